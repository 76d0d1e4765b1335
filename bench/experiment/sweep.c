#include "bench/experiment/sweep.h"

#include <math.h>
#include <string.h>

/* Begins a loop over the cases of all studies of d. */
#define EACH_CASE(d, s, row)                                                               \
    for (const struct study *s = (d)->study; s < (d)->study + (d)->count; s++)             \
        for (const struct study_row *row = s->row; row < s->row + s->plan->level_count;    \
             row++)

static struct ruling ruling_of(const struct study_results *d, const struct study_row *row)
{
    return row->lost ? (struct ruling){.kind = VERDICT_NONE}
                     : rules_of(&d->plan->verdicts, &row->result);
}

/* --- files for machines ------------------------------------------------------------------
 */

static bool is_axis(const struct plan *plan, const char *name)
{
    return plan_label(plan->studies, plan->studies->levels, name);
}

/* Creates the table: labels, every key that is no axis, and every measure; a key that has
 * a measure's name gets one of its own. */
static struct dataset *create_table(const struct plan *plan)
{
    const struct plan_study *first = plan->studies;
    const int count = first->axis_count + plan->key_count + MEASURES + 5;
    struct arena own SCOPED(arena_clear) = {0};
    struct dataset_column *columns = arena_take(&own, (size_t)count, sizeof *columns),
                          *c = columns;

    *c++ = (struct dataset_column){"number"};
    if (plan->study_count > 1)
        *c++ = (struct dataset_column){"study"};
    for (int n = 0; n < first->axis_count; n++, c++)
        c->header = c->key = first->axis[n].name;
    for (int k = 0; k < plan->key_count; k++)
        if (!is_axis(plan, plan->keys[k]))
            c->header = c->key = plan->keys[k], c++;
    for (int n = 0; n < MEASURES; n++, c++) {
        c->header = measure_name(n);
        c->unit = measure_unit(n);
        c->key = n == MEASURE_GAMMA                ? "gamma_measured"
                 : n == MEASURE_YOUNG_OVER_DENSITY ? "young_over_density_measured"
                                                   : measure_name(n);
    }
    *c++ = (struct dataset_column){"verdict"};
    *c++ = (struct dataset_column){"labels"};
    *c++ = (struct dataset_column){"outcome"};
    struct dataset *t = dataset_create((int)(c - columns), columns, NULL);
    return t;
}

static void add_text(struct dataset *t, const char *text)
{
    dataset_text(t, "%s", text ? text : "");
}

static void add_case(struct dataset *t, const struct study_results *d,
                     const struct study *s, const struct study_row *row)
{
    const struct plan *plan = d->plan;
    const struct ruling verdict = ruling_of(d, row);
    char label[1024];

    dataset_line(t, "%d", dataset_count(t)); /* this one among them */
    if (plan->study_count > 1)
        add_text(t, s->plan->name);
    for (int n = 0; n < plan->studies->axis_count; n++)
        add_text(t, plan_label(s->plan, row->level, plan->studies->axis[n].name));
    for (int k = 0; k < plan->key_count; k++)
        if (!is_axis(plan, plan->keys[k]))
            add_text(t, plan_case_words(plan, s->plan, row->level, plan->keys[k]));
    for (int n = 0; n < MEASURES; n++)
        dataset_add(t, "%.6g", row->lost ? NAN : row->result.value[n]);
    add_text(t, verdict_word(verdict.kind));
    add_text(t, row->again  ? "run again"
                : row->lost ? "no result"
                            : rules_text(&plan->verdicts, verdict, label, sizeof label));
    add_text(t, row->lost ? row->lost : row->result.sentence.text);
}

enum status sweep_save(const struct study_results *d, const struct printer *p,
                       struct message *why)
{
    struct dataset *t SCOPED(dataset_destroy_scope) = create_table(d->plan);

    EACH_CASE(d, s, row)
    add_case(t, d, s, row);
    return printer_save(p, t, "table", why);
}

/* --- words for people ------------------------------------------------------------------
 */

static void print_plan(const struct plan *plan, FILE *file)
{
    const struct plan_setting *scene = plan_settings_find(&plan->settings, "scene");

    fprintf(file, "%s: %ld cases", plan->name, plan_case_count(plan));
    if (scene)
        fprintf(file, " of %s", scene->value);
    for (int n = 0; n < plan->studies->axis_count; n++)
        fprintf(file, "%s%d of %s", n ? " x " : "; ", plan->studies->axis[n].count,
                plan->studies->axis[n].name);
    fprintf(file, "\n\n");
}

/* Prints how many cases have the label of rule n; a case that was not measured does not
 * count as passed. */
static void print_label(const struct study_results *d, int n, FILE *file)
{
    const struct rules *rules = &d->plan->verdicts;
    const char *label = rules->rule[n].label;
    long judged = 0, have = 0, lack = 0;

    EACH_CASE(d, s, row)
    {
        const struct ruling verdict = ruling_of(d, row);
        judged += verdict.kind != VERDICT_NONE;
        have += !row->lost && rules_has(rules, verdict, label);
        lack += !row->lost && rules_lacks(rules, verdict, label);
    }
    if (lack && lack == judged)
        fprintf(file, "  %-24s not judged: it was not measured\n", label);
    else if (lack)
        fprintf(file, "  %-24s%6ld   not judged in %ld more, where it was not measured\n",
                label, have, lack);
    else
        fprintf(file, "  %-24s%6ld\n", label, have);
}

static bool is_new_label(const struct rules *rules, int n)
{
    for (int m = 0; m < n; m++)
        if (!strcmp(rules->rule[m].label, rules->rule[n].label))
            return false;
    return true;
}

void sweep_print(const struct study_results *d, FILE *file)
{
    const struct rules *rules = &d->plan->verdicts;
    long feasible = 0;
    struct {
        const char *end, *why;
        long count;
    } ends[] = {
        {"not judged", "no label, but not all could be asked for", 0},
        {"not arrived", "iterations of some steps ended at their limit", 0},
        {"died", "the numerics ended the run", 0},
        {"unsupported", "the model leaves something out", 0},
        {"no result", "timed out, crashed or refused: see table.csv", 0},
        {"run again", "cut short, or damaged since: the next sweep does it", 0},
    };

    EACH_CASE(d, s, row)
    {
        const struct ruling verdict = ruling_of(d, row);
        const struct run_result *r = &row->result;
        feasible += verdict.kind == VERDICT_FEASIBLE;
        ends[0].count += verdict.kind == VERDICT_UNJUDGED;
        ends[1].count += !row->lost && r->value[MEASURE_NOT_ARRIVED] > 0;
        ends[2].count += verdict.died;
        ends[3].count += !row->lost && r->outcome == STATUS_UNSUPPORTED;
        ends[4].count += row->lost && !row->again;
        ends[5].count += row->again;
    }
    print_plan(d->plan, file);
    if (rules->count)
        fprintf(file, "  %-24s%6ld\n", "feasible", feasible);
    for (int n = 0; n < rules->count; n++)
        if (is_new_label(rules, n))
            print_label(d, n, file);
    for (size_t n = 0; n < sizeof ends / sizeof *ends; n++) /* labels alone may be none */
        if (ends[n].count)
            fprintf(file, "  %-24s%6ld   %s\n", ends[n].end, ends[n].count, ends[n].why);
    fprintf(file, "\n");
}
