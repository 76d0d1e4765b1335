/* What the folder of `stress` holds: a file a run, and tables of them. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/seal.h"
#include "bench/stress/stress.h"

enum { PATH = 4096 };

static const char *const outcome_words[] = {[STRESS_RAN] = "ran",
                                            [STRESS_SAID_NO] = "refused",
                                            [STRESS_DEAD] = "died",
                                            [STRESS_STOPPED] = "stopped"};
enum { OUTCOMES = sizeof outcome_words / sizeof *outcome_words };

const char *const stress_end_name[STRESS_ENDS] = {"accurate", "degraded", "refused", "died",
                                                  "not judged: quick"};

enum stress_end stress_result_end(const struct stress_result *r, double bound)
{
    if (r->outcome == STRESS_SAID_NO)
        return STRESS_REFUSED;
    if (r->outcome == STRESS_STOPPED)
        return STRESS_UNJUDGED;
    if (r->outcome == STRESS_DEAD || !isfinite(r->error))
        return STRESS_DIED;
    if (r->quick)
        return STRESS_UNJUDGED;
    return r->error <= bound ? STRESS_ACCURATE : STRESS_DEGRADED;
}

static void find_file(const char *folder, const struct stress_case *c,
                      const struct contestant *contestant, char path[PATH])
{
    snprintf(path, PATH, "%s/%s.%s.txt", folder, c->item.name, contestant->name);
}

enum status stress_result_write(const char *folder, const struct stress_case *c,
                                const struct contestant *contestant,
                                const struct stress_result *r, struct message *why)
{
    char path[PATH], text[sizeof r->sentence.text + 256];

    find_file(folder, c, contestant, path);
    snprintf(text, sizeof text,
             "outcome %s\nerror %.17g\ntime %.17g\nseconds %.17g\nquick %d\nsentence %s\n",
             outcome_words[r->outcome], r->error, r->time, r->seconds, r->quick,
             r->sentence.text);
    return seal_text_write(path, text, why);
}

/* As stress_result_write has it, to the last line's end. */
static bool read_result(const char *text, struct stress_result *r)
{
    char word[16];
    int outcome = 0, quick = 0, used = 0;

    if (sscanf(text, "outcome %15s error %lf time %lf seconds %lf quick %d sentence%n",
               word, &r->error, &r->time, &r->seconds, &quick, &used) != 5 ||
        text[used] != ' ')
        return false;
    while (outcome < OUTCOMES && strcmp(outcome_words[outcome], word))
        outcome++;
    r->outcome = (enum stress_outcome)outcome;
    r->quick = quick;
    snprintf(r->sentence.text, sizeof r->sentence.text, "%.*s",
             (int)strcspn(text + used + 1, "\n"), text + used + 1);
    return outcome < OUTCOMES;
}

enum status stress_result_read(const char *folder, const struct stress_case *c,
                               const struct contestant *contestant, struct stress_result *r,
                               struct message *why)
{
    char path[PATH], *text = NULL;
    enum status st;

    *r = (struct stress_result){.error = NAN, .time = NAN, .seconds = NAN};
    find_file(folder, c, contestant, path);
    TRY(seal_text_read(path, &text, why));
    if (!read_result(text, r))
        st = status_fail(why, STATUS_INPUT, "%s is no result of this `stress`", path);
out:
    free(text);
    return st;
}

/* How all ended, a row a case; what each is held against; a row a run, with everything. */
enum { OVERVIEW, TRUTHS, DETAILS, TABLES };
struct tables {
    struct table *table[TABLES];
    int count[STRESS_ENDS]; /* runs by their end                                       */
    int damaged;            /* files that could not be read                            */
};

/* Nothing, and NULL, where memory is out: table_finish says so. */
static struct table *create_overview(const struct stress_choice *choice)
{
    const struct contestant *at = NULL;
    int count = 1;

    while ((at = stress_choice_next(choice, at)))
        count++;
    struct table_column *columns = calloc((size_t)count, sizeof *columns);
    if (!columns)
        return NULL;
    columns[0] = (struct table_column){"case", NULL, TABLE_LEFT};
    for (int n = 1; (at = stress_choice_next(choice, at)); n++)
        columns[n] = (struct table_column){at->column, NULL, TABLE_LEFT};
    struct table *t = table_create(count, columns, "Hard cases");
    free(columns);
    return t;
}

static struct tables create_tables(const struct stress_choice *choice)
{
    static const struct table_column truths[] = {
        {"case", NULL, TABLE_LEFT},   {"what is hard", NULL, TABLE_LEFT},
        {"bound", NULL, TABLE_RIGHT}, {"its reason", NULL, TABLE_LEFT},
        {"error", NULL, TABLE_LEFT},
    };
    static const struct table_column details[] = {
        {"case", NULL, TABLE_LEFT},
        {"model", NULL, TABLE_LEFT},
        {"bound", "1", TABLE_RIGHT, .readers = TABLE_MACHINES},
        {"end", NULL, TABLE_LEFT},
        {"error", "1", TABLE_RIGHT},
        {"until", "s", TABLE_RIGHT},
        {"took", "s", TABLE_RIGHT},
        {"in words", NULL, TABLE_LEFT},
    };

    return (struct tables){
        {create_overview(choice),
         table_create(sizeof truths / sizeof *truths, truths,
                      "What each case is held against"),
         table_create(sizeof details / sizeof *details, details, "How each run ended")},
        {0}};
}

static void add_truth(struct table *t, const struct stress_case *c, bool quick)
{
    table_row(t);
    table_text(t, "%s", c->item.name);
    table_text(t, "%s", quick && c->quick_text ? c->quick_text : c->item.text);
    table_number(t, c->bound, 1);
    table_text(t, "%s", c->why);
    table_text(t, "%s", stress_truth_text[c->truth]);
}

/* How a run ended, in a word, and with everything. */
static void add_row(struct tables *t, const struct stress_case *c,
                    const struct contestant *contestant, const char *end,
                    const struct stress_result *r)
{
    struct table *details = t->table[DETAILS];

    table_row(details);
    table_text(details, "%s", c->item.name);
    table_text(details, "%s", contestant->name);
    table_number(details, c->bound, 1);
    table_text(details, "%s", end);
    table_number(details, isfinite(r->error) ? r->error : NAN, 3);
    table_number(details, r->time, 3);
    table_fixed(details, r->seconds, 2);
    table_text(details, "%s", r->sentence.text);
}

static void add_result(struct tables *t, const struct stress_case *c,
                       const struct contestant *contestant, const struct stress_result *r)
{
    struct table *overview = t->table[OVERVIEW];
    const enum stress_end end = stress_result_end(r, c->bound);

    t->count[end]++;
    if (end == STRESS_ACCURATE || end == STRESS_DEGRADED)
        table_text(overview, "%s %.0e", end == STRESS_ACCURATE ? "ok" : "off", r->error);
    else if (end == STRESS_DIED && isfinite(r->time))
        table_text(overview, "died %.2g s", r->time);
    else if (end == STRESS_UNJUDGED && isfinite(r->error))
        table_text(overview, "quick %.0e", r->error);
    else
        table_text(overview, "%s", end == STRESS_UNJUDGED ? "quick" : stress_end_name[end]);
    add_row(t, c, contestant, stress_end_name[end], r);
}

static void add_damaged(struct tables *t, const struct stress_case *c,
                        const struct contestant *contestant, const struct message *why)
{
    t->damaged++;
    table_text(t->table[OVERVIEW], "damaged");
    add_row(t, c, contestant, "damaged",
            &(struct stress_result){
                .error = NAN, .time = NAN, .seconds = NAN, .sentence = *why});
}

/* How many files a case has, of the contestants that were asked for, and how many of them
 * are of a quick run. */
static int count_files(const char *folder, const struct stress_choice *choice,
                       const struct stress_case *c, int *quick)
{
    const struct contestant *at = NULL;
    struct stress_result r;
    int count = 0;

    *quick = 0;
    while ((at = stress_choice_next(choice, at))) {
        count += stress_result_read(folder, c, at, &r, NULL) != STATUS_FILE;
        *quick += r.quick;
    }
    return count;
}

/* A case that was asked for and that some contestant left a file of. */
static void add_case(struct tables *t, const char *folder,
                     const struct stress_choice *choice, const struct stress_case *c)
{
    const struct contestant *at = NULL;
    struct stress_result r;
    struct message why;
    int quick;

    if (!count_files(folder, choice, c, &quick))
        return;
    add_truth(t->table[TRUTHS], c, quick > 0);
    table_row(t->table[OVERVIEW]);
    table_text(t->table[OVERVIEW], "%s", c->item.name);
    while ((at = stress_choice_next(choice, at))) {
        const enum status st = stress_result_read(folder, c, at, &r, &why);
        if (st == STATUS_OK)
            add_result(t, c, at, &r);
        else if (st == STATUS_FILE)
            table_dash(t->table[OVERVIEW]);
        else
            add_damaged(t, c, at, &why);
    }
    table_rule(t->table[DETAILS]);
}

static void note_counts(const struct tables *t, int runs)
{
    struct table *overview = t->table[OVERVIEW];
    const int *count = t->count;

    table_note(overview,
               "ok: accurate, the error is within the case's bound; off: degraded, beyond "
               "it. %d runs: %d accurate, %d degraded, %d refused, %d died.",
               runs, count[0], count[1], count[2], count[3]);
    if (count[STRESS_UNJUDGED])
        table_note(overview,
                   "quick: %d not judged: quick. The error is that of the part of the case "
                   "that --quick runs.",
                   count[STRESS_UNJUDGED]);
    if (t->damaged)
        table_note(overview,
                   "Damaged files, no longer as they were written: %d. Run "
                   "their cases again.",
                   t->damaged);
}

enum status stress_print(const char *folder, const struct stress_choice *choice,
                         enum table_format format, FILE *file, struct message *why)
{
    const bool data = table_format_is_data(format);
    struct tables t = create_tables(choice);
    bool map = false;
    int runs = 0;
    enum status st = STATUS_OK;

    for (int n = 0; stress_case_at(n); n++)
        if (stress_choice_case(choice, stress_case_at(n)))
            add_case(&t, folder, choice, stress_case_at(n));
    for (int n = 0; n < STRESS_ENDS; n++)
        runs += t.count[n];
    note_counts(&t, runs);
    runs += t.damaged;
    table_note(t.table[DETAILS],
               "Until: the time in the scene at which the run died, or at which its error "
               "first went beyond the bound.");
    for (int n = 0; n < TABLES; n++) /* a machine gets one: that with everything */
        if (st == STATUS_OK && runs && (!data || n == DETAILS))
            st = table_finish(t.table[n], format, file);
        else
            table_destroy(t.table[n]);
    if (st == STATUS_OK && stress_choice_map(choice))
        st = stress_map_print(folder, format, runs && data ? NULL : file, &map, why);
    if (st == STATUS_OK && !runs && !map)
        st = status_fail(why, STATUS_INPUT, "%s holds no such results of `stress`", folder);
    return st;
}
