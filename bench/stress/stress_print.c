/* What the folder of `stress` holds: a file a run, and tables of them. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/output.h"
#include "bench/stress/stress.h"

enum { PATH = 4096 };

static const char *const outcome_words[] = {
    [STRESS_RAN] = "ran", [STRESS_SAID_NO] = "refused", [STRESS_DEAD] = "died"};
enum { OUTCOMES = sizeof outcome_words / sizeof *outcome_words };

const char *const stress_end_name[4] = {"accurate", "degraded", "refused", "died"};

enum stress_end stress_result_end(const struct stress_result *r, double bound)
{
    if (r->outcome == STRESS_SAID_NO)
        return STRESS_REFUSED;
    if (r->outcome == STRESS_DEAD || !isfinite(r->error))
        return STRESS_DIED;
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
    struct output *out = NULL;
    char path[PATH];
    enum status st;

    find_file(folder, c, contestant, path);
    TRY(output_create(path, &out, why));
    output_print(out, "outcome %s\nerror %.17g\ntime %.17g\nseconds %.17g\nsentence %s\n",
                 outcome_words[r->outcome], r->error, r->time, r->seconds,
                 r->sentence.text);
    st = output_close(out, why);
out:
    return st;
}

/* As stress_write has it, to the last line's end. */
static bool read_result(FILE *file, struct stress_result *r)
{
    char word[16];
    int outcome = 0;

    if (fscanf(file, "outcome %15s error %lf time %lf seconds %lf sentence%*1[ ]", word,
               &r->error, &r->time, &r->seconds) != 4 ||
        !fgets(r->sentence.text, sizeof r->sentence.text, file))
        return false;
    while (outcome < OUTCOMES && strcmp(outcome_words[outcome], word))
        outcome++;
    r->outcome = (enum stress_outcome)outcome;
    char *end = strchr(r->sentence.text, '\n');
    if (end)
        *end = '\0';
    return end && outcome < OUTCOMES;
}

enum status stress_result_read(const char *folder, const struct stress_case *c,
                               const struct contestant *contestant, struct stress_result *r,
                               struct message *why)
{
    char path[PATH];
    enum status st = STATUS_OK;

    *r = (struct stress_result){.error = NAN, .time = NAN, .seconds = NAN};
    find_file(folder, c, contestant, path);
    FILE *file = fopen(path, "r");
    if (!file)
        return status_fail(why, STATUS_FILE, "%s cannot be read", path);
    if (!read_result(file, r))
        st = status_fail(why, STATUS_INPUT, "%s is no result of `stress`", path);
    fclose(file);
    return st;
}

/* How all ended, a row a case; what each is held against; a row a run, with everything. */
enum { OVERVIEW, TRUTHS, DETAILS, TABLES };
struct tables {
    struct table *table[TABLES];
    int count[4]; /* runs by their end                                                 */
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

static void add_truth(struct table *t, const struct stress_case *c)
{
    table_row(t);
    table_text(t, "%s", c->item.name);
    table_text(t, "%s", c->item.text);
    table_number(t, c->bound, 1);
    table_text(t, "%s", c->why);
    table_text(t, "%s", stress_truth_text[c->truth]);
}

static void add_result(struct tables *t, const struct stress_case *c,
                       const struct contestant *contestant, const struct stress_result *r)
{
    struct table *overview = t->table[OVERVIEW], *details = t->table[DETAILS];
    const enum stress_end end = stress_result_end(r, c->bound);

    t->count[end]++;
    if (end == STRESS_ACCURATE || end == STRESS_DEGRADED)
        table_text(overview, "%s %.0e", end == STRESS_ACCURATE ? "ok" : "off", r->error);
    else if (end == STRESS_DIED && isfinite(r->time))
        table_text(overview, "died %.2g s", r->time);
    else
        table_text(overview, "%s", stress_end_name[end]);

    table_row(details);
    table_text(details, "%s", c->item.name);
    table_text(details, "%s", contestant->name);
    table_number(details, c->bound, 1);
    table_text(details, "%s", stress_end_name[end]);
    table_number(details, isfinite(r->error) ? r->error : NAN, 3);
    table_number(details, r->time, 3);
    table_fixed(details, r->seconds, 2);
    table_text(details, "%s", r->sentence.text);
}

/* A case that was asked for and that some contestant left a result of. */
static void add_case(struct tables *t, const char *folder,
                     const struct stress_choice *choice, const struct stress_case *c)
{
    struct table *overview = t->table[OVERVIEW];
    const struct contestant *at = NULL;
    struct stress_result r;
    int before = 0;

    while ((at = stress_choice_next(choice, at)) &&
           stress_result_read(folder, c, at, &r, NULL) != STATUS_OK)
        before++;
    if (!at)
        return;
    add_truth(t->table[TRUTHS], c);
    table_row(overview);
    table_text(overview, "%s", c->item.name);
    while (before--)
        table_dash(overview);
    for (; at; at = stress_choice_next(choice, at))
        if (stress_result_read(folder, c, at, &r, NULL) == STATUS_OK)
            add_result(t, c, at, &r);
        else
            table_dash(overview);
    table_rule(t->table[DETAILS]);
}

enum status stress_print(const char *folder, const struct stress_choice *choice,
                         enum table_format format, FILE *file, struct message *why)
{
    const bool prose = table_format_is_prose(format);
    struct tables t = create_tables(choice);
    bool map = false;
    enum status st = STATUS_OK;

    for (int n = 0; stress_case_at(n); n++)
        if (stress_choice_case(choice, stress_case_at(n)))
            add_case(&t, folder, choice, stress_case_at(n));
    const int *count = t.count, runs = count[0] + count[1] + count[2] + count[3];
    table_note(t.table[OVERVIEW],
               "ok: accurate, the error is within the case's bound; off: degraded, beyond "
               "it. %d runs: %d accurate, %d degraded, %d refused, %d died.",
               runs, count[0], count[1], count[2], count[3]);
    table_note(t.table[DETAILS],
               "Until: the time in the scene at which the run died, or at which its error "
               "first went beyond the bound.");
    for (int n = 0; n < TABLES; n++) /* a machine gets one: that with everything */
        if (st == STATUS_OK && runs && (prose || n == DETAILS))
            st = table_finish(t.table[n], format, file);
        else
            table_destroy(t.table[n]);
    if (st == STATUS_OK && stress_choice_map(choice))
        st = stress_map_print(folder, format, runs && !prose ? NULL : file, &map, why);
    if (st == STATUS_OK && !runs && !map)
        st = status_fail(why, STATUS_INPUT, "%s holds no such results of `stress`", folder);
    return st;
}
