/* The table of the best runs with more threads (compare.h). */
#include <math.h>
#include <stdio.h>

#include "bench/compare/compare.h"

enum { FIXED = 9, MOST_COLUMNS = FIXED + 2 * CONTEST_TEAMS + 1 };

/* What a table borrows: of each number of threads seconds and their ratio to one. */
struct words {
    char header[CONTEST_TEAMS][16], key[CONTEST_TEAMS][24], ratio[CONTEST_TEAMS][24];
};

static struct table *create(const struct contest *c, struct words *w)
{
    struct table_column columns[MOST_COLUMNS] = {
        {"model", NULL, TABLE_LEFT, .key = "title"},
        {"contestant", NULL, TABLE_LEFT, .readers = TABLE_MACHINES},
        {"side", .readers = TABLE_MACHINES},
        {"across", .readers = TABLE_MACHINES},
        {"net", .readers = TABLE_PEOPLE},
        {"step", "ms", .key = "step_s", .key_unit = "s", .scale = 1e3},
        {"iterations"},
        {"error", "%", .key = "worst_rmse_over_length", .key_unit = "1", .scale = 100},
        {"1 thread", "s", .key = "seconds_1_thread"}};
    int count = FIXED;

    for (int t = 0; t < c->teams; t++) {
        snprintf(w->header[t], sizeof w->header[t], "%d threads", c->team[t]);
        snprintf(w->key[t], sizeof w->key[t], "seconds_%d_threads", c->team[t]);
        snprintf(w->ratio[t], sizeof w->ratio[t], "times_%d_threads", c->team[t]);
        columns[count++] = (struct table_column){w->header[t], "s", .key = w->key[t]};
        columns[count++] = (struct table_column){"times", .key = w->ratio[t]};
    }
    columns[count++] = (struct table_column){"same bits", NULL, TABLE_LEFT};
    return table_create(count, columns,
                        "The best runs again with more threads, set-up and stepping");
}

static void add_run(struct table *t, const struct contest *c, const struct contest_row *r)
{
    const int *size = r->at.size;

    table_row(t);
    table_text(t, "%s", r->at.contestant->title);
    table_text(t, "%s", r->at.contestant->name);
    table_integer(t, size[CONTEST_NET]);
    table_integer(t, size[CONTEST_ACROSS]);
    table_text(t, "%dx%d", size[CONTEST_NET], size[CONTEST_ACROSS]);
    table_number(t, c->scene->step / size[CONTEST_STEP], 3);
    table_fixed(t, size[CONTEST_ITERATIONS] ? size[CONTEST_ITERATIONS] : NAN, 0);
    table_number(t, r->worst, 2);
    table_number(t, r->seconds, 3);
    for (int n = 0; n < c->teams; n++) {
        table_number(t, r->team_seconds[n], 3);
        table_number(t, r->team_seconds[n] / r->seconds, 2);
    }
    table_text(t, "%s", r->parted ? "no" : "yes");
}

enum status compare_threads(const struct contest *c, const char *folder,
                            enum table_format format, FILE *file, struct message *why)
{
    const struct contestant *who;
    struct words words;
    enum status st;

    if (!c->teams)
        return STATUS_OK;
    struct table *t = create(c, &words);
    for (int k = 0; (who = contest_entrant(c, k)); k++)
        for (int n = 0; n < c->count; n++)
            if (c->rows[n].at.contestant == who && contest_is_best(c, &c->rows[n]))
                add_run(t, c, &c->rows[n]);
    if (isfinite(c->team_longest))
        table_note(t, "Those that take up to %.2g s, as far as the budget goes.",
                   c->team_longest);
    table_note(t, "Times: of the seconds on one thread. Same bits: all errors are the same "
                  "numbers with every number of threads.");
    TRY(table_save(t, folder, "compare_threads", why));
    return table_finish(t, format, file);
out:
    table_destroy(t);
    return st;
}
