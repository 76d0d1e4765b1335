#include "bench/experiment/dataset.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/fit.h"
#include "bench/ui/chart.h"

const char *dataset_label(const struct study *s, int level, const char *axis)
{
    if (!strcmp(axis, "study"))
        return s->plan->name;
    if (!strcmp(axis, "caption"))
        return s->plan->caption;
    for (int n = 0; n < s->plan->axis_count; n++)
        if (!strcmp(axis, s->plan->axis[n].name))
            return s->row[level].level->word[n];
    return s->plan->axis_count || strcmp(axis, "level") ? NULL : s->row[level].level->label;
}

/* Whether a row has all of these labels; without a time, whether it is the last. */
static bool is_named(const struct place *p, const struct where *where)
{
    const double *time = p->s->time;
    bool timed = false;

    for (; where->axis; where++) {
        const char *label = dataset_label(p->s, p->level, where->axis);
        const bool other = where->label[0] == '!';
        const char *text = where->label + other;
        const size_t size = strlen(text) - (*text && text[strlen(text) - 1] == '*');
        if (!strcmp(where->axis, "at")) {
            timed = true;
            if (strcmp(where->label, "*") &&
                (!time || fabs(time[p->time] - strtod(where->label, NULL)) > 1e-9))
                return false;
        } else if (!label || !strncmp(label, text, size + !text[size]) == other) {
            return false;
        }
    }
    return timed || p->time == p->s->frames - 1;
}

/* Before the first row. */
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

/* The only row that the labels name. */
static bool find(const struct study_results *d, const struct where *where, struct place *p)
{
    *p = begin(d);
    if (!next_row(where, p))
        return false;
    struct place after = *p;
    return !next_row(where, &after);
}

int dataset_labels(const struct study_results *d, const char *axis, int most,
                   const char **label)
{
    struct place p = begin(d);
    int count = 0;

    while (next_row(WHERE({NULL, NULL}), &p)) {
        const char *word = dataset_label(p.s, p.level, axis);
        int n = 0;
        while (word && n < count && strcmp(label[n], word))
            n++;
        if (word && n == count && count < most)
            label[count++] = word;
    }
    return count;
}

double dataset_at(const struct study_results *d, enum quantity q, const struct where *where)
{
    struct place p;

    return find(d, where, &p) ? quantity_table[q].at(&p) : NAN;
}

enum judge dataset_verdict(const struct study_results *d, const char *label,
                           const struct where *where)
{
    const struct verdict_rules *rules = &d->plan->verdicts;
    struct place p;

    if (!find(d, where, &p))
        return JUDGE_OPEN;
    const struct verdict v = verdict_of(rules, &p.s->row[p.level].result);
    if (!label)
        return v.kind == VERDICT_FEASIBLE     ? JUDGE_HOLDS
               : v.kind == VERDICT_INFEASIBLE ? JUDGE_FAILS
                                              : JUDGE_OPEN;
    return verdict_has(rules, v, label)     ? JUDGE_HOLDS
           : verdict_lacks(rules, v, label) ? JUDGE_OPEN
                                            : JUDGE_FAILS;
}

static double fold(const struct study_results *d, enum quantity q,
                   const struct where *where, double of_two(double a, double b))
{
    struct place p = begin(d);
    double all = next_row(where, &p) ? quantity_table[q].at(&p) : NAN;

    while (next_row(where, &p))
        all = of_two(all, quantity_table[q].at(&p));
    return all;
}

double dataset_most(const struct study_results *d, enum quantity q,
                    const struct where *where)
{
    return fold(d, q, where, fmax);
}

double dataset_least(const struct study_results *d, enum quantity q,
                     const struct where *where)
{
    return fold(d, q, where, fmin);
}

double dataset_all_most(const struct study_results *d, enum quantity q,
                        const struct where *where)
{
    return fold(d, q, where, judge_most);
}

int dataset_values(const struct study_results *d, enum quantity q,
                   const struct where *where, int most, double *values)
{
    struct place p = begin(d);
    int count = 0;

    while (count < most && next_row(where, &p))
        values[count++] = quantity_table[q].at(&p);
    return count;
}

void dataset_write(const struct study_results *d, enum quantity q,
                   const struct where *where, FILE *file)
{
    struct place p = begin(d);

    for (const char *comma = ""; next_row(where, &p); comma = ", ") {
        const struct study_row *row = &p.s->row[p.level];
        const double v = quantity_table[q].at(&p);
        if (isnan(v) && !row->frame[p.time].xyz)
            fprintf(file, "%s%s", comma,
                    run_result_refused(&row->result) ? "refused" : "died");
        else
            fprintf(file, "%s%.3g", comma, v);
    }
}

double dataset_ratio(const struct study_results *d, enum quantity q, const struct where *a,
                     const struct where *b)
{
    return dataset_at(d, q, a) / dataset_at(d, q, b);
}

double dataset_apart(const struct study_results *d, const struct where *a,
                     const struct where *b)
{
    struct place p, other;

    return find(d, a, &p) && find(d, b, &other) ? study_distance(&p, &other) : NAN;
}

double dataset_exponent(const struct study_results *d, enum quantity x, enum quantity y,
                        const struct where *where)
{
    double xs[PLAN_STUDY_LEVELS], ys[PLAN_STUDY_LEVELS];
    struct place p = begin(d);
    int count = 0;

    while (count < PLAN_STUDY_LEVELS && next_row(where, &p)) {
        xs[count] = quantity_table[x].at(&p);
        ys[count] = quantity_table[y].at(&p);
        count += isfinite(log(xs[count])) && isfinite(log(ys[count]));
    }
    return count < 2 ? NAN : fit_exponent(count, xs, ys);
}

/* --- the plan's table and chart ----------------------------------------------------------
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

enum status dataset_check(const struct plan *plan, struct message *why)
{
    enum status st = STATUS_OK;

    for (int n = 0; n < plan->table.columns.count; n++)
        TRY(check_quantity(plan, plan->table.columns.list[n].key,
                           plan->table.columns.list[n].line, "a column of the table", why));
    for (int n = 0; n < plan->chart.y.count; n++)
        TRY(check_quantity(plan, plan->chart.y.list[n].key, plan->chart.y.list[n].line,
                           "y of the chart", why));
    for (int n = 0; n < plan->table.pictures.count; n++) {
        const struct plan_setting *name = &plan->table.pictures.list[n];
        int study = 0;
        while (study < plan->study_count && strcmp(plan->studies[study].name, name->key))
            study++;
        if (study == plan->study_count)
            return plan_case_refuse(plan, name->line, why,
                                    "pictures of the table has %s, which is no study",
                                    yaml_tree_quote(name->key).text);
    }
out:
    return st;
}

/* One of a list of quantities. */
static const struct quantity_row *quantity_of(const struct plan_settings *list, int n)
{
    return &quantity_table[quantity_find(list->list[n].key)];
}

enum { AXES = 12 }; /* most label columns */

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

/* The axes that some study has, each once; people see captions, machines the names. */
static int find_axes(const struct study_results *d, const char *axis[AXES])
{
    int count = 0;

    if (d->count > 1)
        axis[count++] = "caption", axis[count++] = "study";
    for (int k = 0; k < d->count; k++) {
        const struct plan_study *plan = d->study[k].plan;
        for (int n = 0; n < plan->axis_count || n == 0; n++) {
            const char *name = plan->axis_count ? plan->axis[n].name : "level";
            int at = 0;
            while (at < count && strcmp(axis[at], name))
                at++;
            if (at == count && count < AXES)
                axis[count++] = name;
        }
    }
    return count;
}

static void add_row(struct table *t, enum part part, const struct place *p)
{
    const struct study_results *d = p->d;
    const struct plan_table *plan = &d->plan->table;
    const struct verdict_rules *rules = &d->plan->verdicts;
    const char *axis[AXES];
    char words[256];
    const int axes = find_axes(d, axis);

    table_row(t);
    for (int n = 0; n < axes; n++) {
        const char *label = dataset_label(p->s, p->level, axis[n]);
        if (label)
            table_text(t, "%s", label);
        else
            table_dash(t);
    }
    if (part != PART_RUN && has_times(d))
        table_number(t, p->s->time ? p->s->time[p->time] : NAN, 4);
    for (int n = 0; n < plan->columns.count; n++) {
        const struct quantity_row *q = quantity_of(&plan->columns, n);
        if (is_in(part, q) && q->digits)
            table_number(t, q->at(p), q->digits);
        else if (is_in(part, q))
            table_fixed(t, q->at(p), 0);
    }
    if (rules->count && part != PART_TIMES)
        table_text(t, "%s",
                   verdict_text(rules, verdict_of(rules, &p->s->row[p->level].result),
                                words, sizeof words));
}

/* Whether people see a level. */
static bool is_shown(const struct study_results *d, const struct study *s, int level)
{
    const struct plan_settings *shown = &d->plan->table.shown;

    for (int n = 0; n < shown->count; n++) {
        const char *label = dataset_label(s, level, shown->list[n].key);
        if (!label || strcmp(label, shown->list[n].value))
            return false;
    }
    return true;
}

/* For people, what the plan has them see. */
static struct table *fill(const struct study_results *d, enum part part, bool people,
                          const char *caption)
{
    const struct plan_table *plan = &d->plan->table;
    const bool last = part == PART_RUN || (people && plan->last);
    struct table_column columns[AXES + 2 + PLAN_TABLE_COLUMNS];
    const char *axis[AXES];
    int count = find_axes(d, axis);

    for (int n = 0; n < count; n++)
        columns[n] = (struct table_column){axis[n], NULL, TABLE_LEFT};
    if (d->count > 1) {
        columns[0] =
            (struct table_column){"study", NULL, TABLE_LEFT, "caption", TABLE_PEOPLE};
        columns[1].readers = TABLE_MACHINES;
    }
    if (part != PART_RUN && has_times(d))
        columns[count++] = (struct table_column){"time", "s"};
    for (int n = 0; n < plan->columns.count; n++) {
        const struct quantity_row *q = quantity_of(&plan->columns, n);
        if (is_in(part, q))
            columns[count++] =
                (struct table_column){q->head, q->unit, .key = q->name,
                                      .readers = *q->head ? TABLE_ALL : TABLE_MACHINES};
    }
    if (d->plan->verdicts.count && part != PART_TIMES)
        columns[count++] = (struct table_column){"by the rules", NULL, TABLE_LEFT};
    struct table *t = table_create(count, columns, caption);
    for (int k = 0; k < d->count; k++) {
        const struct study *s = &d->study[k];
        const int rows = table_rows(t);
        for (int n = 0; n < s->plan->level_count; n++)
            for (int time = last ? s->frames - 1 : 0; time < s->frames; time++)
                if (!s->row[n].left_out && (!people || is_shown(d, s, n)))
                    add_row(t, part, &(struct place){d, s, n, time});
        if (k + 1 < d->count && table_rows(t) > rows)
            table_rule(t);
    }
    return t;
}

/* What the columns mean, how runs ended that did not come to their end, and the truths. */
static void add_notes(struct table *t, const struct study_results *d)
{
    const struct plan_table *plan = &d->plan->table;
    const struct verdict_rules *rules = &d->plan->verdicts;
    char text[2048] = "";

    for (int n = 0; n < plan->columns.count; n++) {
        const struct quantity_row *q = quantity_of(&plan->columns, n);
        const size_t used = strlen(text);
        if (*q->head)
            snprintf(text + used, sizeof text - used, "%s%s: %s", n ? "; " : "", q->head,
                     q->help);
    }
    table_note(t, "%s.", text);
    if (plan->note)
        table_note(t, "%s", plan->note);
    for (int n = 0; n < rules->count; n++) {
        const struct verdict_rule *r = &rules->rule[n];
        const char *unit = measure_unit(r->measure);
        const bool pure = !strcmp(unit, "1");
        table_note(t, "%s: %s %s %g%s%s; %s.", r->label, measure_name(r->measure),
                   r->above ? "above" : "below", r->bound, pure ? "" : " ",
                   pure ? "" : unit, r->why);
    }
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

/* --- the plan's chart --------------------------------------------------------------------
 */

struct dot {
    struct place at; /* the last time of a level */
    const struct quantity_row *of;
    double x, y;
};

/* What x of the chart is; NULL: the size of levels. */
static const struct quantity_row *x_of(const struct plan_chart *plan)
{
    const int n = quantity_find(plan->x);

    return n < 0 ? NULL : &quantity_table[n];
}

/* Every level that has a place in the chart; freed by the receiver. */
static struct dot *find_dots(const struct study_results *d, int *count)
{
    const struct plan_chart *plan = &d->plan->chart;
    struct dot *dots = NULL;
    size_t most = 1;

    for (int k = 0; k < d->count; k++)
        most += (size_t)d->study[k].plan->level_count;
    dots = calloc(most * (size_t)plan->y.count, sizeof *dots);
    for (int i = 0; dots && i < plan->y.count; i++)
        for (int k = 0; k < d->count; k++)
            for (int n = 0; n < d->study[k].plan->level_count; n++) {
                const struct study *s = &d->study[k];
                const struct place at = {d, s, n, s->frames - 1};
                const struct quantity_row *x = x_of(plan), *of = quantity_of(&plan->y, i);
                const double y = of->at(&at);
                const struct dot dot = {at, of, x ? x->at(&at) : s->row[n].level->size,
                                        isnan(plan->from) ? y : fabs(y - plan->from)};
                if (dot.x > 0 && dot.y > 0 && isfinite(dot.y))
                    dots[(*count)++] = dot;
            }
    return dots;
}

/* Whether both have the same labels on the axes of panels and, if `line`, of lines, and are
 * of one quantity then. */
static bool alike(const struct plan_chart *plan, bool line, const struct dot *a,
                  const struct dot *b)
{
    for (int n = 0; n < plan->panel.count + (line ? plan->line.count : 0); n++) {
        const struct plan_setting *axis = n < plan->panel.count
                                              ? &plan->panel.list[n]
                                              : &plan->line.list[n - plan->panel.count];
        const char *one = dataset_label(a->at.s, a->at.level, axis->key);
        const char *other = dataset_label(b->at.s, b->at.level, axis->key);
        if (strcmp(one ? one : "", other ? other : ""))
            return false;
    }
    return !line || a->of == b->of;
}

/* Whether no dot before it is alike. */
static bool is_first(const struct plan_chart *plan, bool line, const struct dot *dots,
                     const struct dot *dot)
{
    while (!alike(plan, line, dots, dot))
        dots++;
    return dots == dot;
}

/* "poisson 0.3, thickness 1 mm"; of a single axis its label alone. */
static const char *name_of(const struct dot *dot, const struct plan_settings *axes,
                           const char *first, char text[128])
{
    snprintf(text, 128, "%s", first);
    for (int n = 0; n < axes->count; n++) {
        const char *axis = axes->list[n].key;
        const char *label = dataset_label(dot->at.s, dot->at.level, axis);
        const bool bare = axes->count == 1 || !strcmp(axis, "study");
        const size_t used = strlen(text);
        if (label)
            snprintf(text + used, 128 - used, "%s%s%s%s", used ? ", " : "",
                     bare ? "" : axis, bare ? "" : " ", label);
    }
    return text;
}

static struct chart *chart_of(const struct study_results *d)
{
    const struct plan_chart *plan = &d->plan->chart;
    const struct quantity_row *q = quantity_of(&plan->y, 0), *x = x_of(plan);
    struct chart *c = chart_create(d->plan->what ? d->plan->what : d->plan->source);
    char text[128], y[128];
    int count = 0;
    struct dot *dots = find_dots(d, &count);

    snprintf(y, sizeof y, isnan(plan->from) ? "%s" : "|%s - %g|", q->head, plan->from);
    chart_axes(c,
               &(struct chart_axis){x ? x->head : plan->x, x ? x->unit : NULL, .log = true},
               &(struct chart_axis){y, isnan(plan->from) ? q->unit : NULL, .log = true});
    for (const struct dot *p = dots; p < dots + count; p++) {
        if (!is_first(plan, false, dots, p))
            continue;
        if (plan->panel.count)
            chart_panel(c, name_of(p, &plan->panel, "", text));
        for (const struct dot *l = p; l < dots + count; l++) {
            if (!alike(plan, false, p, l) || !is_first(plan, true, dots, l))
                continue;
            name_of(l, &plan->line, plan->y.count > 1 ? l->of->head : "", text);
            chart_series(
                c, &(struct chart_series){text, x ? CHART_POINTS : CHART_LINESPOINTS});
            for (const struct dot *at = l; at < dots + count; at++)
                if (alike(plan, true, l, at))
                    chart_point(c, at->x, at->y);
        }
    }
    free(dots);
    return c;
}

/* Whether the plan's table has columns of a kind. */
static bool has_part(const struct study_results *d, enum part part)
{
    bool any = part == PART_RUN && d->plan->verdicts.count;

    for (int n = 0; n < d->plan->table.columns.count; n++)
        any |= is_in(part, quantity_of(&d->plan->table.columns, n));
    return any;
}

/* Sheets of the studies that the plan names; it names none: of those without axes. */
static enum status draw_sheets(const struct study_results *d, const char *folder,
                               struct message *why)
{
    const struct plan_settings *named = &d->plan->table.pictures;
    enum status st = STATUS_OK;

    for (int n = 0; n < d->count && st == STATUS_OK; n++) {
        const struct study *s = &d->study[n];
        if (named->count ? plan_settings_find(named, s->plan->name) != NULL
                         : !s->plan->axis_count && s->time)
            st = study_print_sheets(s, folder, why);
    }
    return st;
}

enum status dataset_print(const struct study_results *d, const char *folder,
                          enum table_format format, FILE *file, struct message *why)
{
    const struct plan_table *plan = &d->plan->table;
    const char *caption = d->plan->what ? d->plan->what : d->plan->source;
    const bool people = !table_format_is_data(format);
    const bool apart =
        people && has_times(d) && has_part(d, PART_RUN) && has_part(d, PART_TIMES);
    const bool last = people && d->plan->table.last;
    const char *name = plan->file ? plan->file : d->plan->name;
    struct table *all = NULL, *t;
    enum status st = STATUS_OK;

    if (d->plan->chart.x)
        TRY(chart_save(chart_of(d), folder, name, why));
    if (!plan->columns.count)
        return study_print_all(d, folder, format, file, why);
    all = fill(d, PART_ALL, false, caption);
    TRY(table_save(all, folder, name, why));
    if (apart)
        TRY(table_finish(fill(d, PART_RUN, people, caption), format, file));
    t = apart ? fill(d, PART_TIMES, people,
                     last ? "The same at the last time" : "The same at the times")
              : fill(d, PART_ALL, people, caption);
    add_notes(t, d);
    TRY(table_finish(t, format, file));
    TRY(draw_sheets(d, folder, why));
out:
    table_destroy(all);
    return st;
}
