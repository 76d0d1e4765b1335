#include "bench/sweep/sweep.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/metric/metric.h"
#include "models/metric/metric_rest.h"

void sweep_rows_init(struct sweep_rows *rows, const struct plan *plan)
{
    *rows = (struct sweep_rows){.plan = plan, .count = plan_case_count(plan)};
    rows->row = arena_take(&rows->arena, (size_t)rows->count, sizeof *rows->row);
}

void sweep_rows_set(struct sweep_rows *rows, long number, enum sweep_state state,
                    const struct run_result *result, const char *why)
{
    const struct plan *plan = rows->plan;
    struct sweep_row *row = &rows->row[number];
    const bool ran = state == SWEEP_RAN;
    char label[1024];

    *row = (struct sweep_row){.state = state,
                              .outcome = ran ? result->outcome : STATUS_OK,
                              .verdict = {.kind = VERDICT_NONE},
                              .why = arena_print(&rows->arena, "%s", why)};
    for (int n = 0; n < MEASURES; n++)
        row->value[n] = ran ? result->value[n] : NAN;
    snprintf(label, sizeof label, "%s", state == SWEEP_OPEN ? "run again" : "no result");
    if (ran) {
        row->verdict = rules_of(&plan->verdicts, result);
        rules_text(&plan->verdicts, row->verdict, label, sizeof label);
    }
    row->label = arena_print(&rows->arena, "%s", label);
}

/* --- the reference of a case ------------------------------------------------------------
 */

/* Returns the case of the same study that has the labels of the reference and else those of
 * case `number`; -1: there is none. */
static long reference_of(const struct plan *plan, long number)
{
    const struct plan_study *study = plan->studies;
    long before = 0;

    while (number >= before + study->level_count)
        before += study++->level_count;
    const int found =
        plan_level_with(study, &study->levels[number - before], &plan->reference);
    return found < 0 ? -1 : before + found;
}

enum status sweep_rows_check(const struct plan *plan, struct message *why)
{
    return plan->reference.count && plan->keep != PLAN_KEEP_SNAPSHOTS
               ? plan_case_refuse(plan, plan->reference.list->line, why,
                                  "a plan with a reference must keep snapshots")
               : STATUS_OK;
}

/* The reference that was read last. */
struct reference {
    long number;              /* its case; -1: none                                    */
    struct run_result result; /* with fields; empty unless it lived to the end         */
    bool died;                /* or came to no result                                  */
    double *rest;             /* its sheet at rest (grid.h) [m]                  owned */
};

static enum status read_reference(struct reference *ref, long number,
                                  const struct sweep_folder *folder)
{
    struct message sentence;
    enum sweep_state state;
    enum status st;

    run_result_clear(&ref->result);
    free(ref->rest), ref->rest = NULL;
    ref->number = number;
    TRY(sweep_folder_read(folder, number, NULL, true, &state, &ref->result, &sentence));
    ref->died = state == SWEEP_FAILED || status_is_death(ref->result.outcome);
    if (state != SWEEP_RAN || ref->result.outcome != STATUS_OK) {
        run_result_clear(&ref->result);
        goto out;
    }
    ref->rest = metric_rest_field(&ref->result.scene);
    st = ref->rest ? STATUS_OK : STATUS_MEMORY;
out:
    return st;
}

/* Returns the error at the worst of the kept times; infinite where one of the two died, NaN
 * where nobody knows the reference or the model refused. */
static double compare(const struct run_result *r, const struct reference *ref)
{
    const bool died = status_is_death(r->outcome);
    double worst = died || (r->outcome == STATUS_OK && ref->died) ? INFINITY : NAN;

    for (int n = 0; r->outcome == STATUS_OK && n < ref->result.frames; n++)
        worst = fmax(worst, metric_rmse(r->xyz[n], ref->result.xyz[n]) /
                                metric_rmse(ref->result.xyz[n], ref->rest));
    return worst;
}

/* --- reading ---------------------------------------------------------------------------
 */

static enum status read_row(struct sweep_rows *rows, long number,
                            const struct sweep_folder *folder, struct reference *ref)
{
    const struct plan *plan = rows->plan;
    const bool compared = plan->reference.count > 0;
    const long other = compared ? reference_of(plan, number) : -1;
    struct run_result r = {0};
    struct message sentence = {""};
    enum sweep_state state;
    enum status st;

    TRY(sweep_folder_read(folder, number, NULL, compared, &state, &r, &sentence));
    if (compared && ref->number != other)
        TRY(read_reference(ref, other, folder));
    if (compared && state == SWEEP_RAN)
        r.value[MEASURE_REFERENCE_ERROR_MAX] = compare(&r, ref);
    sweep_rows_set(rows, number, state, &r, sentence.text);
out:
    run_result_clear(&r);
    return st;
}

enum status sweep_rows_read(struct sweep_rows *rows, const struct plan *plan,
                            const struct sweep_folder *folder)
{
    struct reference ref = {.number = -1};
    enum status st = STATUS_OK;

    sweep_rows_init(rows, plan);
    for (long n = 0; n < rows->count; n++)
        TRY(read_row(rows, n, folder, &ref));
out:
    run_result_clear(&ref.result);
    free(ref.rest);
    return st;
}

/* --- files for machines ----------------------------------------------------------------
 */

static bool is_axis(const struct plan *plan, const char *name)
{
    const struct plan_study *first = plan->studies;

    return plan_label(first, first->levels, name);
}

/* Creates table.csv: labels, every key that is no axis, and every measure; a key that has
 * a measure's name gets one of its own. */
static struct dataset *create_table(const struct plan *plan)
{
    const struct plan_study *first = plan->studies;
    const int count = first->axis_count + plan->key_count + MEASURES + 5;
    struct arena own = {0};
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
    arena_clear(&own);
    return t;
}

/* Adds the label of a case on an axis; empty where its study has no such axis. */
static void add_label(struct dataset *t, const struct plan_case *c, const char *axis)
{
    const char *label = plan_label(c->study, c->level, axis);

    dataset_text(t, "%s", label ? label : "");
}

static void add_case(struct dataset *t, const struct plan *plan, const struct plan_case *c,
                     const struct sweep_row *row)
{
    dataset_line(t, "%ld", c->number + 1);
    if (plan->study_count > 1)
        add_label(t, c, "study");
    for (int n = 0; n < plan->studies->axis_count; n++)
        add_label(t, c, plan->studies->axis[n].name);
    for (int k = 0; k < plan->key_count; k++)
        if (!is_axis(plan, plan->keys[k]))
            dataset_add(t, "%s", c->given[k] ? c->given[k]->value : "");
    for (int n = 0; n < MEASURES; n++)
        dataset_add(t, "%.6g", row->value[n]);
    dataset_add(t, "%s|%s|%s", verdict_word(row->verdict.kind), row->label, row->why);
}

enum status sweep_rows_save(const struct sweep_rows *rows, const struct printer *p,
                            struct message *why)
{
    struct dataset *t = create_table(rows->plan);
    struct plan_case c;
    enum status st;

    for (long n = 0; n < rows->count; n++) {
        TRY(plan_case_given(rows->plan, n, &c));
        add_case(t, rows->plan, &c, &rows->row[n]);
        plan_case_clear(&c);
    }
    st = printer_save(p, t, "table", why);
out:
    dataset_destroy(t);
    return st;
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
static void print_label(const struct sweep_rows *rows, int n, FILE *file)
{
    const struct rules *rules = &rows->plan->verdicts;
    const char *label = rules->rule[n].label;
    long judged = 0, have = 0, lack = 0;

    for (const struct sweep_row *row = rows->row; row < rows->row + rows->count; row++) {
        judged += row->verdict.kind != VERDICT_NONE;
        have += row->state == SWEEP_RAN && rules_has(rules, row->verdict, label);
        lack += row->state == SWEEP_RAN && rules_lacks(rules, row->verdict, label);
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

void sweep_rows_print(const struct sweep_rows *rows, FILE *file)
{
    const struct plan *plan = rows->plan;
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

    for (const struct sweep_row *row = rows->row; row < rows->row + rows->count; row++) {
        feasible += row->verdict.kind == VERDICT_FEASIBLE;
        ends[0].count += row->verdict.kind == VERDICT_UNJUDGED;
        ends[1].count += row->value[MEASURE_NOT_ARRIVED] > 0;
        ends[2].count += row->verdict.died;
        ends[3].count += row->outcome == STATUS_UNSUPPORTED;
        ends[4].count += row->state == SWEEP_FAILED;
        ends[5].count += row->state == SWEEP_OPEN;
    }
    print_plan(plan, file);
    if (plan->verdicts.count)
        fprintf(file, "  %-24s%6ld\n", "feasible", feasible);
    for (int n = 0; n < plan->verdicts.count; n++)
        if (is_new_label(&plan->verdicts, n))
            print_label(rows, n, file);
    for (size_t n = 0; n < sizeof ends / sizeof *ends; n++) /* labels alone may be none */
        if (ends[n].count)
            fprintf(file, "  %-24s%6ld   %s\n", ends[n].end, ends[n].count, ends[n].why);
    fprintf(file, "\n");
}
