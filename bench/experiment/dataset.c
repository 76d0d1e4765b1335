#include "bench/experiment/dataset.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/fit.h"

const char *dataset_label(const struct study *s, int level, const char *axis)
{
    if (!strcmp(axis, "study"))
        return s->plan->name;
    for (int n = 0; n < s->plan->axis_count; n++)
        if (!strcmp(axis, s->plan->axis[n].name))
            return s->row[level].level->word[n];
    return s->plan->axis_count || strcmp(axis, "level") ? NULL : s->row[level].level->label;
}

/* A level of a study at one of the study's times. */
struct place {
    int study, level, time;
};

/* Whether a row has all of these labels; without a time, whether it is the last. */
static bool is_named(const struct study *s, const struct place *p,
                     const struct where *where)
{
    bool timed = false;

    for (; where->axis; where++) {
        const char *label = dataset_label(s, p->level, where->axis);
        const bool other = where->label[0] == '!';
        if (!strcmp(where->axis, "at")) {
            const double want = strtod(where->label, NULL);
            timed = true;
            if (strcmp(where->label, "*") &&
                (!s->time || fabs(s->time[p->time] - want) > 1e-9))
                return false;
        } else if (!label || !strcmp(label, where->label + other) == other) {
            return false;
        }
    }
    return timed || p->time == s->frames - 1;
}

/* Goes on to the next row that the labels name, times being the last to change; false:
 * there is none. Begin with FIRST. */
static bool next_row(const struct study_results *d, const struct where *where,
                     struct place *p)
{
    for (; p->study < d->count; ++p->study, p->level = 0, p->time = -1) {
        const struct study *s = &d->study[p->study];
        for (; p->level < s->plan->level_count; ++p->level, p->time = -1)
            while (++p->time < s->frames)
                if (!s->row[p->level].left_out && is_named(s, p, where))
                    return true;
    }
    return false;
}

static const struct place FIRST = {0, 0, -1};

/* The only row that the labels name. */
static bool find(const struct study_results *d, const struct where *where, struct place *p)
{
    struct place after;

    *p = FIRST;
    if (!next_row(d, where, p))
        return false;
    after = *p;
    return !next_row(d, where, &after);
}

int dataset_labels(const struct study_results *d, const char *axis, int most,
                   const char **label)
{
    struct place p = FIRST;
    int count = 0;

    while (next_row(d, WHERE({NULL, NULL}), &p)) {
        const char *word = dataset_label(&d->study[p.study], p.level, axis);
        int n = 0;
        while (word && n < count && strcmp(label[n], word))
            n++;
        if (word && n == count && count < most)
            label[count++] = word;
    }
    return count;
}

static double value(const struct study_results *d, enum quantity q, const struct place *p)
{
    return quantity_table[q].at(d, &d->study[p->study], p->level, p->time);
}

double dataset_at(const struct study_results *d, enum quantity q, const struct where *where)
{
    struct place p;

    return find(d, where, &p) ? value(d, q, &p) : NAN;
}

enum judge dataset_verdict(const struct study_results *d, const char *label,
                           const struct where *where)
{
    const struct verdict_rules *rules = &d->plan->verdicts;
    struct place p;

    if (!find(d, where, &p))
        return JUDGE_OPEN;
    const struct verdict v = verdict_of(rules, &d->study[p.study].row[p.level].result);
    if (!label)
        return v.kind == VERDICT_FEASIBLE     ? JUDGE_HOLDS
               : v.kind == VERDICT_INFEASIBLE ? JUDGE_FAILS
                                              : JUDGE_OPEN;
    return verdict_has(rules, v, label)     ? JUDGE_HOLDS
           : verdict_lacks(rules, v, label) ? JUDGE_OPEN
                                            : JUDGE_FAILS;
}

double dataset_most(const struct study_results *d, enum quantity q,
                    const struct where *where)
{
    struct place p = FIRST;
    double most = NAN;

    while (next_row(d, where, &p))
        most = fmax(most, value(d, q, &p));
    return most;
}

double dataset_least(const struct study_results *d, enum quantity q,
                     const struct where *where)
{
    struct place p = FIRST;
    double least = NAN;

    while (next_row(d, where, &p))
        least = fmin(least, value(d, q, &p));
    return least;
}

int dataset_values(const struct study_results *d, enum quantity q,
                   const struct where *where, int most, double *values)
{
    struct place p = FIRST;
    int count = 0;

    while (count < most && next_row(d, where, &p))
        values[count++] = value(d, q, &p);
    return count;
}

void dataset_write(const struct study_results *d, enum quantity q,
                   const struct where *where, FILE *file)
{
    struct place p = FIRST;

    for (const char *comma = ""; next_row(d, where, &p); comma = ", ") {
        const struct study_row *row = &d->study[p.study].row[p.level];
        const double v = value(d, q, &p);
        if (isnan(v) && !row->frame[p.time].xyz)
            fprintf(file, "%s%s", comma,
                    run_result_refused(&row->result) ? "refused" : "died");
        else
            fprintf(file, "%s%.3g", comma, v);
    }
}

double dataset_apart(const struct study_results *d, const struct where *a,
                     const struct where *b)
{
    struct place p, other;

    if (!find(d, a, &p) || !find(d, b, &other))
        return NAN;
    return study_distance(&d->study[p.study], p.level, &d->study[other.study], other.level,
                          p.time);
}

double dataset_exponent(const struct study_results *d, enum quantity x, enum quantity y,
                        const struct where *where)
{
    double xs[PLAN_STUDY_LEVELS], ys[PLAN_STUDY_LEVELS];
    struct place p = FIRST;
    int count = 0;

    while (count < PLAN_STUDY_LEVELS && next_row(d, where, &p)) {
        xs[count] = value(d, x, &p);
        ys[count] = value(d, y, &p);
        count += isfinite(log(xs[count])) && isfinite(log(ys[count]));
    }
    return count < 2 ? NAN : fit_exponent(count, xs, ys);
}

/* --- the plan's table --------------------------------------------------------------------
 */

enum status dataset_check(const struct plan *plan, struct message *why)
{
    for (int n = 0; n < plan->table.columns.count; n++) {
        const struct plan_setting *column = &plan->table.columns.list[n];
        if (quantity_find(column->key) < 0)
            return plan_case_refuse(plan, column->line, why,
                                    "a column of the table is %s, which is no quantity; "
                                    "clothbench list quantities has them",
                                    yaml_tree_quote(column->key).text);
    }
    return STATUS_OK;
}

/* Column n of a plan's table. */
static const struct quantity_row *column_of(const struct plan_table *plan, int n)
{
    return &quantity_table[quantity_find(plan->columns.list[n].key)];
}

enum { AXES = 2 + PLAN_STUDY_AXES }; /* with the study's and the time's columns */

/* Whether some study has several times. */
static bool has_times(const struct study_results *d)
{
    for (int n = 0; n < d->count; n++)
        if (d->study[n].frames > 1)
            return true;
    return false;
}

/* Which columns and rows: those of a run, those of its times, or, for machines, all. */
enum part { PART_RUN, PART_TIMES, PART_ALL };

static bool is_in(enum part part, const struct quantity_row *q)
{
    return part == PART_ALL || q->moves == (part == PART_TIMES);
}

/* Heads of the label columns: the study where there are several, the axes of the first, the
 * time where there are several. */
static int label_columns(const struct study_results *d, enum part part,
                         struct table_column *columns)
{
    const struct plan_study *first = d->study[0].plan;
    int count = 0;

    if (d->count > 1)
        columns[count++] = (struct table_column){"study", NULL, TABLE_LEFT};
    for (int n = 0; n < first->axis_count; n++)
        columns[count++] = (struct table_column){first->axis[n].name, NULL, TABLE_LEFT};
    if (!first->axis_count)
        columns[count++] = (struct table_column){"level", NULL, TABLE_LEFT};
    if (part != PART_RUN && has_times(d))
        columns[count++] = (struct table_column){"time", "s"};
    return count;
}

static void add_row(struct table *t, const struct study_results *d, enum part part,
                    const struct study *s, int level, int time)
{
    const struct plan_table *plan = &d->plan->table;
    const struct verdict_rules *rules = &d->plan->verdicts;
    char words[256];

    table_row(t);
    if (d->count > 1)
        table_text(t, "%s", s->plan->name);
    for (int n = 0; n < s->plan->axis_count; n++)
        table_text(t, "%s", s->row[level].level->word[n]);
    if (!s->plan->axis_count)
        table_text(t, "%s", s->row[level].level->label);
    if (part != PART_RUN && has_times(d))
        table_number(t, s->time ? s->time[time] : NAN, 4);
    for (int n = 0; n < plan->columns.count; n++) {
        const struct quantity_row *q = column_of(plan, n);
        if (is_in(part, q) && q->digits)
            table_number(t, q->at(d, s, level, time), q->digits);
        else if (is_in(part, q))
            table_fixed(t, q->at(d, s, level, time), 0);
    }
    if (rules->count && part != PART_TIMES)
        table_text(t, "%s",
                   verdict_text(rules, verdict_of(rules, &s->row[level].result), words,
                                sizeof words));
}

static struct table *fill(const struct study_results *d, enum part part,
                          const char *caption)
{
    const struct plan_table *plan = &d->plan->table;
    struct table_column columns[AXES + PLAN_TABLE_COLUMNS + 1];
    int count = label_columns(d, part, columns);

    for (int n = 0; n < plan->columns.count; n++) {
        const struct quantity_row *q = column_of(plan, n);
        if (is_in(part, q))
            columns[count++] = (struct table_column){q->head, q->unit, .key = q->name};
    }
    if (d->plan->verdicts.count && part != PART_TIMES)
        columns[count++] = (struct table_column){"by the rules", NULL, TABLE_LEFT};
    struct table *t = table_create(count, columns, caption);
    for (int k = 0; k < d->count; k++) {
        const struct study *s = &d->study[k];
        for (int n = 0; n < s->plan->level_count; n++)
            for (int time = part == PART_RUN ? s->frames - 1 : 0; time < s->frames; time++)
                if (!s->row[n].left_out)
                    add_row(t, d, part, s, n, time);
        if (k + 1 < d->count)
            table_rule(t);
    }
    return t;
}

/* Whether the plan's table has columns of a kind. */
static bool has_part(const struct study_results *d, enum part part)
{
    bool any = part == PART_RUN && d->plan->verdicts.count;

    for (int n = 0; n < d->plan->table.columns.count; n++)
        any |= is_in(part, column_of(&d->plan->table, n));
    return any;
}

/* What the columns mean, how runs ended that did not come to their end, and the truths. */
static void add_notes(struct table *t, const struct study_results *d)
{
    const struct plan_table *plan = &d->plan->table;
    char text[2048] = "";

    for (int n = 0; n < plan->columns.count; n++) {
        const struct quantity_row *q = column_of(plan, n);
        const size_t used = strlen(text);
        snprintf(text + used, sizeof text - used, "%s%s: %s", n ? "; " : "", q->head,
                 q->help);
    }
    table_note(t, "%s.", text);
    if (plan->note)
        table_note(t, "%s", plan->note);
    for (int k = 0; k < d->count; k++) {
        const struct study *s = &d->study[k];
        for (int n = 0; n < s->plan->level_count; n++)
            if (!s->row[n].left_out && s->row[n].result.outcome)
                table_note(t, "%s, %s: %s.", s->plan->name, s->row[n].level->label,
                           s->row[n].result.sentence.text);
        if (s->truth)
            table_note(t, "Truth of %s: %s.", s->plan->name, s->truth->source);
        else if (s->plan->truth)
            table_note(t, "Truth of %s: none; %s.", s->plan->name, s->no_truth.text);
    }
}

enum status dataset_print(const struct study_results *d, const char *folder,
                          enum table_format format, FILE *file, struct message *why)
{
    const char *caption = d->plan->what ? d->plan->what : d->plan->source;
    const bool apart = !table_format_is_data(format) && has_times(d) &&
                       has_part(d, PART_RUN) && has_part(d, PART_TIMES);
    struct table *all = NULL, *t;
    enum status st;

    if (!d->plan->table.columns.count)
        return study_print_all(d, folder, format, file, why);
    all = fill(d, PART_ALL, caption);
    TRY(table_save(all, folder, d->plan->name, why));
    if (apart)
        TRY(table_finish(fill(d, PART_RUN, caption), format, file));
    t = apart ? fill(d, PART_TIMES, "The same at the times") : fill(d, PART_ALL, caption);
    add_notes(t, d);
    TRY(table_finish(t, format, file));
    for (int n = 0; n < d->count; n++)
        if (!d->study[n].plan->axis_count && d->study[n].time)
            TRY(study_print_sheets(&d->study[n], folder, why));
out:
    table_destroy(all);
    return st;
}
