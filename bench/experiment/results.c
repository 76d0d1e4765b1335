#include "bench/experiment/results.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/fit.h"

const char *results_label(const struct study *s, int level, const char *axis)
{
    return plan_label(s->plan, s->row[level].level, axis);
}

static bool is_at(const struct place *p, const char *label)
{
    const double *time = p->s->time;

    return !strcmp(label, "*") ||
           (time && fabs(time[p->time] - strtod(label, NULL)) <= 1e-9);
}

/* Returns whether a row has this label. */
static bool has_label(const struct place *p, const struct where *where)
{
    const char *label = results_label(p->s, p->level, where->axis);
    const bool other = where->label[0] == '!';
    const char *text = where->label + other;
    const size_t size = strlen(text) - (*text && text[strlen(text) - 1] == '*');

    if (!strcmp(where->axis, "at"))
        return is_at(p, where->label);
    return label && !strncmp(label, text, size + !text[size]) != other;
}

static bool names_axis(const struct where *where, const char *axis)
{
    while (where->axis && strcmp(where->axis, axis))
        where++;
    return where->axis != NULL;
}

/* Returns whether a row has all of these labels and those of the reading, on axes that they
 * do not name and that its study has; and, if none of them names a time, is at the last. */
static bool is_named(const struct place *p, const struct where *where)
{
    bool timed = names_axis(where, "at");

    for (const struct where *w = where; w->axis; w++)
        if (!has_label(p, w))
            return false;
    for (const struct where *w = p->d->reading; w && w->axis; w++) {
        const bool time = !strcmp(w->axis, "at");
        if (names_axis(where, w->axis) ||
            (!time && !results_label(p->s, p->level, w->axis)))
            continue;
        timed |= time;
        if (!has_label(p, w))
            return false;
    }
    return timed || p->time == p->s->frames - 1;
}

/* Returns the place before the first row. */
static struct place begin(const struct study_results *d)
{
    return (struct place){d, d->study, 0, -1};
}

/* Goes on to the next row that the labels name, times being the last to change; false:
 * there is none. */
static bool next_row(const struct where *where, struct place *p)
{
    for (; p->s < p->d->study + p->d->count; ++p->s, p->level = 0, p->time = -1)
        for (; p->level < p->s->plan->level_count; ++p->level, p->time = -1)
            while (++p->time < p->s->frames)
                if (!p->s->row[p->level].left_out && is_named(p, where))
                    return true;
    return false;
}

/* Finds the only row that the labels name. */
static bool find(const struct study_results *d, const struct where *where, struct place *p)
{
    *p = begin(d);
    if (!next_row(where, p))
        return false;
    struct place after = *p;
    return !next_row(where, &after);
}

int results_labels(const struct study_results *d, const char *axis, int most,
                   const char **label)
{
    struct place p = begin(d);
    int count = 0;

    while (next_row(WHERE({NULL, NULL}), &p)) {
        const char *word = results_label(p.s, p.level, axis);
        int n = 0;
        while (word && n < count && strcmp(label[n], word))
            n++;
        if (word && n == count && count < most)
            label[count++] = word;
    }
    return count;
}

double results_at(const struct study_results *d, enum quantity q, const struct where *where)
{
    struct place p;

    return find(d, where, &p) ? quantity_at(&p, q) : NAN;
}

enum verdict results_verdict(const struct study_results *d, const char *label,
                             const struct where *where)
{
    const struct rules *rules = &d->plan->verdicts;
    struct place p;

    if (!find(d, where, &p))
        return VERDICT_OPEN;
    const struct ruling v = rules_of(rules, &p.s->row[p.level].result);
    if (!label)
        return v.kind == VERDICT_FEASIBLE     ? VERDICT_HOLDS
               : v.kind == VERDICT_INFEASIBLE ? VERDICT_FAILS
                                              : VERDICT_OPEN;
    return rules_has(rules, v, label)     ? VERDICT_HOLDS
           : rules_lacks(rules, v, label) ? VERDICT_OPEN
                                          : VERDICT_FAILS;
}

static double fold(const struct study_results *d, enum quantity q,
                   const struct where *where, double of_two(double a, double b))
{
    struct place p = begin(d);
    double all = next_row(where, &p) ? quantity_at(&p, q) : NAN;

    while (next_row(where, &p))
        all = of_two(all, quantity_at(&p, q));
    return all;
}

double results_most(const struct study_results *d, enum quantity q,
                    const struct where *where)
{
    return fold(d, q, where, fmax);
}

double results_least(const struct study_results *d, enum quantity q,
                     const struct where *where)
{
    return fold(d, q, where, fmin);
}

double results_all_most(const struct study_results *d, enum quantity q,
                        const struct where *where)
{
    return fold(d, q, where, judge_most);
}

int results_values(const struct study_results *d, enum quantity q,
                   const struct where *where, int most, double *values)
{
    struct place p = begin(d);
    int count = 0;

    while (count < most && next_row(where, &p))
        values[count++] = quantity_at(&p, q);
    return count;
}

void results_write(const struct study_results *d, enum quantity q,
                   const struct where *where, FILE *file)
{
    struct place p = begin(d);

    for (const char *comma = ""; next_row(where, &p); comma = ", ") {
        const struct study_row *row = &p.s->row[p.level];
        const double v = quantity_at(&p, q);
        if (isnan(v) && !row->xyz[p.time])
            fprintf(file, "%s%s", comma,
                    run_result_refused(&row->result) ? "refused" : "died");
        else
            fprintf(file, "%s%.3g", comma, v);
    }
}

double results_ratio(const struct study_results *d, enum quantity q, const struct where *a,
                     const struct where *b)
{
    return results_at(d, q, a) / results_at(d, q, b);
}

double results_apart(const struct study_results *d, const struct where *a,
                     const struct where *b)
{
    struct place p, other;

    return find(d, a, &p) && find(d, b, &other) ? study_distance(&p, &other) : NAN;
}

double results_exponent(const struct study_results *d, enum quantity x, enum quantity y,
                        const struct where *where)
{
    double xs[PLAN_STUDY_LEVELS], ys[PLAN_STUDY_LEVELS];
    struct place p = begin(d);
    int count = 0;

    while (count < PLAN_STUDY_LEVELS && next_row(where, &p)) {
        xs[count] = quantity_at(&p, x);
        ys[count] = quantity_at(&p, y);
        count += isfinite(log(xs[count])) && isfinite(log(ys[count]));
    }
    return count < 2 ? NAN : fit_exponent(count, xs, ys);
}

/* --- what is printed ---------------------------------------------------------------------
 */

static enum status check_quantity(const struct plan *plan, const char *name, int line,
                                  const char *where, struct message *why)
{
    return quantity_find(name) >= 0
               ? STATUS_OK
               : plan_case_refuse(plan, line, why,
                                  "%s is %s, which is no quantity; clothbench list "
                                  "quantities has them",
                                  where, yaml_tree_quote(name).text);
}

enum status results_check(const struct plan *plan, struct message *why)
{
    for (int n = 0; n < plan->table.columns.count; n++)
        CALL(check_quantity(plan, plan->table.columns.list[n].key,
                            plan->table.columns.list[n].line, "a column of the table",
                            why));
    for (int n = 0; n < plan->chart.y.count; n++)
        CALL(check_quantity(plan, plan->chart.y.list[n].key, plan->chart.y.list[n].line,
                            "y of the chart", why));
    for (int k = 0; k < plan->statement_count; k++)
        for (int n = 0; n < plan->statements[k].quantity.count; n++)
            CALL(check_quantity(plan, plan->statements[k].quantity.list[n].key,
                                plan->statements[k].line, "the quantity of a statement",
                                why));
    return STATUS_OK;
}

/* Returns one of a list of quantities. */
static enum quantity quantity_of(const struct plan_settings *list, int n)
{
    return (enum quantity)quantity_find(list->list[n].key);
}

enum { AXES = 12 }; /* most label columns */

/* The columns and rows of a table: what a run has once, what it has at each time, or, for
 * machines, all. */
enum part { PART_RUN, PART_TIMES, PART_ALL };

static bool is_in(enum part part, enum quantity q)
{
    return part == PART_ALL || quantity_table[q].moves == (part == PART_TIMES);
}

/* The rows and columns that are printed together: all studies in the plan's table, or one
 * of them alone where the plan has none. */
struct view {
    const struct study_results *d; /* borrowed                                          */
    bool alone, timed;             /* timed: with a column of the time                  */
    const char *name, *caption;    /* of files and table; borrowed                      */
    int axes, columns;
    const char *axis[AXES];
    enum quantity column[PLAN_TABLE_COLUMNS];
};

/* Adds the axes that some study has, each once; people see captions, machines the names. */
static void find_axes(struct view *v)
{
    if (v->d->count > 1)
        v->axis[v->axes++] = "caption", v->axis[v->axes++] = "study";
    for (int k = 0; k < v->d->count; k++) {
        const struct plan_study *plan = v->d->study[k].plan;
        for (int n = 0; n < plan->axis_count; n++) {
            const char *name = plan->axis[n].name;
            int at = 0;
            while (at < v->axes && strcmp(v->axis[at], name))
                at++;
            if (at == v->axes && v->axes < AXES)
                v->axis[v->axes++] = name;
        }
    }
}

static struct view view_of(const struct study_results *d)
{
    static const enum quantity usual[] = {
        QUANTITY_SIZE,    QUANTITY_UNKNOWNS, QUANTITY_FACTOR_ENTRIES, QUANTITY_FRAME,
        QUANTITY_PAPER,   QUANTITY_SECONDS,  QUANTITY_NEXT,           QUANTITY_FINEST,
        QUANTITY_ERROR,   QUANTITY_BAR,      QUANTITY_ROUGHNESS,      QUANTITY_INNER,
        QUANTITY_STRETCH, QUANTITY_DROP,     QUANTITY_UNEVENNESS};
    enum { USUAL = sizeof usual / sizeof *usual };
    const struct plan *plan = d->plan;
    const struct plan_settings *asked = &plan->table.columns;
    struct view v = {.d = d,
                     .alone = !asked->count,
                     .name = plan->name,
                     .caption = plan->what ? plan->what : plan->source};

    if (v.alone)
        v.name = d->study->plan->name, v.caption = d->study->plan->caption;
    for (int n = 0; n < d->count; n++)
        v.timed |= d->study[n].frames > 1 || v.alone;
    find_axes(&v);
    v.columns = v.alone ? USUAL : asked->count;
    for (int n = 0; n < v.columns; n++)
        v.column[n] = v.alone ? usual[n] : quantity_of(asked, n);
    return v;
}

static bool has_part(const struct view *v, enum part part)
{
    bool any = part == PART_RUN && v->d->plan->verdicts.count;

    for (int n = 0; n < v->columns; n++)
        any |= is_in(part, v->column[n]);
    return any;
}

/* Returns whether people see a quantity: a study alone without a truth has no errors. */
static bool is_seen(const struct view *v, enum quantity q)
{
    const bool error = q == QUANTITY_ERROR || q == QUANTITY_BAR;

    return *quantity_table[q].head && !(v->alone && error && !v->d->study->truth);
}

/* Adds a level at a time; behind the levels of a study stands its truth. */
static void add_row(struct dataset *t, const struct view *v, enum part part,
                    const struct place *p)
{
    const struct rules *rules = &v->d->plan->verdicts;
    const struct study_row *row = &p->s->row[p->level];
    const bool truth = p->level == p->s->plan->level_count;
    char words[256];

    dataset_row(t);
    for (int n = 0; n < v->axes; n++) {
        const char *label = !truth ? results_label(p->s, p->level, v->axis[n])
                            : n    ? NULL
                                   : "truth";
        if (label)
            dataset_add(t, "%s", label);
        else
            dataset_add(t, "-");
    }
    if (part != PART_RUN && v->timed)
        dataset_add(t, "%.4g", p->s->time ? p->s->time[p->time] : NAN);
    for (int n = 0; n < v->columns; n++) {
        const enum quantity q = v->column[n];
        if (is_in(part, q) && quantity_table[q].digits)
            dataset_add(t, "%.*g", quantity_table[q].digits, quantity_at(p, q));
        else if (is_in(part, q))
            dataset_add(t, "%.0f", quantity_at(p, q));
    }
    if (rules->count && part != PART_TIMES && truth)
        dataset_add(t, "-");
    else if (rules->count && part != PART_TIMES)
        dataset_add(t, "%s",
                    rules_text(rules, rules_of(rules, &row->result), words, sizeof words));
}

/* Returns whether people see a level. */
static bool is_shown(const struct study_results *d, const struct study *s, int level)
{
    const struct plan_settings *shown = &d->plan->table.shown;

    for (int n = 0; n < shown->count; n++) {
        const char *label = results_label(s, level, shown->list[n].key);
        if (!label || strcmp(label, shown->list[n].value))
            return false;
    }
    return true;
}

/* Adds the rows of a study: its levels one by one or, alone, time by time, with its truth.
 */
static void add_study(struct dataset *t, const struct view *v, enum part part, bool people,
                      const struct study *s)
{
    const bool last = part == PART_RUN || (people && v->d->plan->table.last);
    const int first = last ? s->frames - 1 : 0, times = s->frames - first;
    const int levels = s->plan->level_count + (v->alone && s->truth && part != PART_RUN);

    for (int k = 0; k < levels * times; k++) {
        const int level = v->alone ? k % levels : k / times;
        const int time = first + (v->alone ? k / levels : k % times);
        if (v->alone && k && !level)
            dataset_rule(t);
        if (level == s->plan->level_count ||
            (!s->row[level].left_out && (!people || is_shown(v->d, s, level))))
            add_row(t, v, part, &(struct place){v->d, s, level, time});
    }
}

static struct dataset *fill(const struct view *v, enum part part, bool people,
                            const char *caption)
{
    const struct study_results *d = v->d;
    struct dataset_column columns[AXES + 2 + PLAN_TABLE_COLUMNS];
    int count = 0;

    for (; count < v->axes; count++)
        columns[count] = (struct dataset_column){v->axis[count]};
    if (d->count > 1) {
        columns[0] =
            (struct dataset_column){"study", .key = "caption", .readers = DATASET_PEOPLE};
        columns[1].readers = DATASET_MACHINES;
    }
    if (part != PART_RUN && v->timed)
        columns[count++] = (struct dataset_column){
            "time", "s",
            .readers = v->alone && !d->study->time ? DATASET_MACHINES : DATASET_ALL};
    for (int n = 0; n < v->columns; n++) {
        const struct quantity_row *q = &quantity_table[v->column[n]];
        const bool length = v->alone && q->unit && !strcmp(q->unit, "L");
        if (is_in(part, v->column[n]))
            columns[count++] = (struct dataset_column){
                q->head, q->unit, .key = length ? NULL : q->name, /* error_over_length */
                .readers = is_seen(v, v->column[n]) ? DATASET_ALL : DATASET_MACHINES};
    }
    if (d->plan->verdicts.count && part != PART_TIMES)
        columns[count++] = (struct dataset_column){"by the rules"};
    struct dataset *t = dataset_create(count, columns, caption);
    for (int k = 0; k < d->count; k++) {
        const int rows = dataset_count(t);
        add_study(t, v, part, people, &d->study[k]);
        if (k + 1 < d->count && dataset_count(t) > rows)
            dataset_rule(t);
    }
    return t;
}

/* Returns the observed order, in the levels' size, of the error against truth at a time or,
 * without a truth, of the difference from the finest; NaN with fewer than three levels. */
static double observed_order(const struct study_results *d, const struct study *s, int time)
{
    double size[PLAN_STUDY_LEVELS], value[PLAN_STUDY_LEVELS];
    int count = 0;

    for (int n = 0; n < s->plan->level_count && count < PLAN_STUDY_LEVELS; n++) {
        const struct place p = {d, s, n, time};
        size[count] = s->row[n].level->size;
        value[count] = quantity_at(&p, s->truth ? QUANTITY_ERROR : QUANTITY_FINEST);
        count += !isnan(value[count]) && size[count] > 0;
    }
    return count < (s->truth ? 3 : 2) ? NAN : fit_exponent(count, size, value);
}

/* Adds notes on how runs ended that did not come to their end, on orders and on the truth.
 */
static void note_study(struct dataset *t, const struct view *v, const struct study *s)
{
    for (int n = 0; n < s->plan->level_count; n++)
        if (!s->row[n].left_out &&
            (s->row[n].result.outcome || run_result_missed(&s->row[n].result)))
            dataset_note(t, "%s, %s: %s.", s->plan->name, s->row[n].level->label,
                         s->row[n].result.sentence.text);
    for (int time = 0; v->alone && time < s->frames; time++) {
        const char *what = s->truth ? "error" : "difference from the finest";
        const double order = observed_order(v->d, s, time);
        if (!isnan(order) && s->time)
            dataset_note(t, "Observed order at %g s: %.2g, of the %s.", s->time[time],
                         order, what);
        else if (!isnan(order))
            dataset_note(t, "Observed order: %.2g, of the %s.", order, what);
    }
    if (v->alone)
        dataset_note(t, "Gamma = %.4g.", s->gamma);
    if (s->truth)
        dataset_note(t, "Truth of %s: %s.", s->plan->name, s->truth->source);
    else if (s->plan->truth)
        dataset_note(t, "Truth of %s: none; %s.", s->plan->name, s->no_truth.text);
}

/* Adds notes on columns, on verdicts and on each study. */
static void add_notes(struct dataset *t, const struct view *v)
{
    const struct rules *rules = &v->d->plan->verdicts;
    char text[2048] = "";

    for (int n = 0; n < v->columns; n++) {
        const struct quantity_row *q = &quantity_table[v->column[n]];
        if (is_seen(v, v->column[n]))
            TEXT_JOIN(text, "; ", "%s: %s", q->head, q->help);
    }
    dataset_note(t, "%s.", text);
    if (v->d->plan->table.note)
        dataset_note(t, "%s", v->d->plan->table.note);
    for (int n = 0; n < rules->count; n++) {
        const struct rule *r = &rules->rule[n];
        const char *unit = measure_unit(r->measure);
        const bool pure = !strcmp(unit, "1");
        dataset_note(t, "%s: %s %s %g%s%s; %s.", r->label, measure_name(r->measure),
                     r->above ? "above" : "below", r->bound, pure ? "" : " ",
                     pure ? "" : unit, r->why);
    }
    for (int k = 0; k < v->d->count; k++)
        note_study(t, v, &v->d->study[k]);
}

/* Writes "poisson 0.3, thickness 1 mm" behind `first`; of a single axis its label alone. */
static void write_labels(const struct study *s, int level, const struct plan_settings *axes,
                         const char *first, char text[128])
{
    snprintf(text, 128, "%s", first);
    for (int n = 0; n < axes->count; n++) {
        const char *axis = axes->list[n].key, *label = results_label(s, level, axis);
        const bool bare = axes->count == 1 || !strcmp(axis, "study");
        if (label)
            status_join(text, 128, ", ", "%s%s%s", bare ? "" : axis, bare ? "" : " ",
                        label);
    }
}

/* Adds the levels at their last times to the table of a chart. */
static void add_points(struct dataset *t, const struct study_results *d,
                       const struct plan_chart *plan)
{
    const int x = quantity_find(plan->x); /* -1: the size of levels */

    for (int i = 0; i < plan->y.count; i++)
        for (int k = 0; k < d->count; k++)
            for (int n = 0; n < d->study[k].plan->level_count; n++) {
                const struct study *s = &d->study[k];
                const struct place at = {d, s, n, s->frames - 1};
                const enum quantity of = quantity_of(&plan->y, i);
                char panel[128], line[128];
                const double y = quantity_at(&at, of);
                write_labels(s, n, &plan->panel, "", panel);
                write_labels(s, n, &plan->line,
                             plan->y.count > 1 ? quantity_table[of].head : "", line);
                dataset_row(t);
                dataset_text(t, "%s", panel);
                dataset_text(t, "%s", line);
                dataset_add(t, "%.6g|%.6g",
                            x < 0 ? s->row[n].level->size
                                  : quantity_at(&at, (enum quantity)x),
                            isnan(plan->from) ? y : fabs(y - plan->from));
            }
}

/* Writes the name of an axis: that of a quantity with its unit. */
static void write_axis(const struct quantity_row *q, char title[128])
{
    const bool pure = !q->unit || !strcmp(q->unit, "1");

    snprintf(title, 128, "%s%s%s%s", q->head, pure ? "" : " [", pure ? "" : q->unit,
             pure ? "" : "]");
}

/* Writes the points of the plan's chart as FOLDER/NAME_chart.csv, under the names of its
 * axes. */
static enum status save_chart(const struct study_results *d, const struct printer *p,
                              struct message *why)
{
    const struct plan_chart *plan = &d->plan->chart;
    const int column = quantity_find(plan->x);
    const struct quantity_row *q = &quantity_table[quantity_of(&plan->y, 0)];
    char x[128], y[128], file[128];

    snprintf(x, sizeof x, "%s", plan->x);
    if (column >= 0)
        write_axis(&quantity_table[column], x);
    if (isnan(plan->from))
        write_axis(q, y);
    else
        snprintf(y, sizeof y, "|%s - %g|", q->head, plan->from);
    const struct dataset_column columns[] = {
        {"panel"}, {"line"}, {"x", .key = x}, {"y", .key = y}};
    struct dataset *t SCOPED(dataset_destroy_scope) = DATASET_OF(columns, NULL);
    add_points(t, d, plan);
    snprintf(file, sizeof file, "%.100s_chart", d->plan->name);
    return printer_save(p, t, file, why);
}

static enum status print_view(const struct view *v, struct printer *p, struct message *why)
{
    const bool people = !printer_is_data(p);
    const bool apart =
        people && v->timed && has_part(v, PART_RUN) && has_part(v, PART_TIMES);
    struct dataset *t;
    struct dataset *all SCOPED(dataset_destroy_scope) =
        fill(v, PART_ALL, false, v->caption);
    char cost[256];

    snprintf(cost, sizeof cost, "%s%s", v->caption, v->alone ? ": cost" : "");
    CALL(printer_save(p, all, v->name, why));
    if (apart)
        CALL(printer_table(p, fill(v, PART_RUN, people, cost), NULL, why));
    t = !apart || v->alone ? fill(v, apart ? PART_TIMES : PART_ALL, people, v->caption)
                           : fill(v, PART_TIMES, people,
                                  v->d->plan->table.last ? "The same at the last time"
                                                         : "The same at the times");
    add_notes(t, v);
    return printer_table(p, t, NULL, why);
}

enum status results_print(const struct study_results *d, struct printer *p,
                          struct message *why)
{
    const struct plan *plan = d->plan;
    struct view v = view_of(d);

    if (plan->chart.x)
        CALL(save_chart(d, p, why));
    if (!v.alone)
        return print_view(&v, p, why);
    for (int n = 0; n < d->count; n++) {
        struct study_results one = *d;
        one.study += n;
        one.count = 1;
        v = view_of(&one);
        CALL(print_view(&v, p, why));
    }
    return STATUS_OK;
}
