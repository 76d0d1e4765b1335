#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench/stress/stress.h"

/* A contestant's result of a case, as the folder has it. */
struct row {
    const struct contestant *contestant;
    enum { ABSENT, DAMAGED, READ } file;
    struct stress_result r; /* DAMAGED: its sentence alone */
};

/* The tables: how all ended, a row a case; what each case is held against; everything, a
 * row a run. */
enum { OVERVIEW, TRUTHS, DETAILS, TABLES };
struct tables {
    struct table *table[TABLES];
    int count[STRESS_ENDS]; /* runs by their end                                       */
    int damaged;            /* files that could not be read                            */
};

/* Makes the tables; those for which there is no memory are NULL, as table_finish expects.
 */
static struct tables create_tables(int contestants, const struct row *rows)
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
    struct table_column *columns = calloc((size_t)contestants + 1, sizeof *columns);
    struct table *overview = NULL;

    if (columns) {
        columns[0] = (struct table_column){"case", NULL, TABLE_LEFT};
        for (int n = 0; n < contestants; n++)
            columns[n + 1] =
                (struct table_column){rows[n].contestant->column, NULL, TABLE_LEFT};
        overview = table_create(contestants + 1, columns, "Hard cases");
    }
    free(columns);
    return (struct tables){{overview, TABLE_OF(truths, "What each case is held against"),
                            TABLE_OF(details, "How each run ended")},
                           {0}};
}

/* Fills the next cell of the overview. */
static void add_word(struct table *t, const struct row *row)
{
    const struct stress_result *r = &row->r;

    if (row->file == ABSENT)
        table_add(t, "-");
    else if (row->file == DAMAGED)
        table_add(t, "damaged");
    else if (r->end == STRESS_ACCURATE || r->end == STRESS_DEGRADED)
        table_add(t, "%s %.0e", r->end == STRESS_ACCURATE ? "ok" : "off", r->error);
    else if (r->end == STRESS_DIED && isfinite(r->time))
        table_add(t, "died %.2g s", r->time);
    else
        table_add(t, "%s", stress_end_name[r->end]);
}

static void add_details(struct table *t, const struct stress_case *c, const struct row *row)
{
    table_line(t, "%s|%s|%.1g|%s|%.3g|%.3g|%.2f|%s", c->item.name, row->contestant->name,
               c->bound, row->file == READ ? stress_end_name[row->r.end] : "damaged",
               isfinite(row->r.error) ? row->r.error : NAN, row->r.time, row->r.seconds,
               row->r.sentence.text);
}

static void add_truth(struct table *t, const struct stress_case *c)
{
    table_line(t, "%s|%s|%.1g|%s|%s", c->item.name, c->item.text, c->bound, c->why,
               stress_truth_text[c->truth]);
}

/* Reads what contestants left of a case; returns how many have left something. */
static int read_case(const char *folder, const struct stress_case *c, int contestants,
                     struct row *rows)
{
    struct message why;
    int count = 0;

    for (struct row *row = rows; row < rows + contestants; row++) {
        const enum status st =
            stress_result_read(folder, c, row->contestant, &row->r, &why);
        row->file = st == STATUS_OK ? READ : st == STATUS_FILE ? ABSENT : DAMAGED;
        if (row->file == DAMAGED)
            row->r = (struct stress_result){
                .error = NAN, .time = NAN, .seconds = NAN, .sentence = why};
        count += row->file != ABSENT;
    }
    return count;
}

static void add_case(struct tables *t, const struct stress_case *c, int contestants,
                     const struct row *rows)
{
    table_line(t->table[OVERVIEW], "%s", c->item.name);
    for (const struct row *row = rows; row < rows + contestants; row++) {
        add_word(t->table[OVERVIEW], row);
        if (row->file == ABSENT)
            continue;
        add_details(t->table[DETAILS], c, row);
        t->damaged += row->file == DAMAGED;
        t->count[row->r.end] += row->file == READ;
    }
    add_truth(t->table[TRUTHS], c);
    table_rule(t->table[DETAILS]);
}

/* Adds the notes; returns the number of runs. */
static int add_notes(const struct tables *t)
{
    struct table *overview = t->table[OVERVIEW];
    const int *count = t->count;
    int runs = 0;

    for (int n = 0; n < STRESS_ENDS; n++)
        runs += count[n];
    table_note(overview,
               "`ok` means accurate: the error is within the case's bound. `off` means "
               "degraded: the error is beyond it. %d runs: %d accurate, %d degraded, %d "
               "refused, %d died.",
               runs, count[0], count[1], count[2], count[3]);
    if (t->damaged)
        table_note(overview,
                   "Damaged files, no longer as they were written: %d. Run "
                   "their cases again.",
                   t->damaged);
    table_note(t->table[DETAILS],
               "The column `until` is the time in the scene at which the run died, or "
               "at which its error first exceeded the bound.");
    return runs + t->damaged;
}

enum status stress_print(const char *folder, const struct stress_choice *choice,
                         enum table_format format, FILE *file, struct message *why)
{
    const bool data = table_format_is_data(format);
    const struct contestant *at = NULL;
    int contestants = 0;
    enum status st = STATUS_OK;

    while ((at = stress_choice_next(choice, at)))
        contestants++;
    struct row *rows = calloc((size_t)contestants + 1, sizeof *rows);
    if (!rows)
        return STATUS_MEMORY;
    for (int n = 0; (at = stress_choice_next(choice, at)); n++)
        rows[n].contestant = at;
    struct tables t = create_tables(contestants, rows);
    for (int n = 0; stress_case_at(n); n++)
        if (stress_choice_case(choice, stress_case_at(n)) &&
            read_case(folder, stress_case_at(n), contestants, rows))
            add_case(&t, stress_case_at(n), contestants, rows);
    const int runs = add_notes(&t);
    for (int n = 0; n < TABLES; n++) /* a machine gets one: that with everything */
        if (st == STATUS_OK && runs && (!data || n == DETAILS))
            st = table_finish(t.table[n], format, file);
        else
            table_destroy(t.table[n]);
    free(rows);
    if (st == STATUS_OK && !runs)
        st = status_fail(why, STATUS_INPUT, "%s holds no such results of `stress`", folder);
    return st;
}
