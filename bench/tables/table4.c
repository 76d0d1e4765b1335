#include "bench/tables/table4.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/experiment/measurement.h"
#include "bench/experiment/plan_case.h"
#include "bench/experiment/plan_read.h"
#include "bench/harness/run_file.h"

const char *const table4_scene[TABLE4_SCENES] = {"flag", "edge_drop"};

const struct table4_reading table4_reading[TABLE4_READINGS] = {
    [TABLE4_PRINTED] = {"printed", "printed, v <- mu v (the paper's)", "iga_paper",
                        TABLE4_SCALE, false},
    [TABLE4_INCREMENTAL] = {"incremental", "incremental, v <- mu v", "iga_incremental",
                            TABLE4_SCALE, false},
    [TABLE4_INCREMENTAL_UNDAMPED] = {"incremental_undamped", "incremental, undamped",
                                     "iga_incremental", TABLE4_UNDAMPED, false},
    [TABLE4_LINEAR] = {"linear", "linear, v <- mu v", "iga_linear", TABLE4_SCALE, false},
    [TABLE4_SOLID] = {"nonlinear", "nonlinear solid, remedy none, undamped",
                      "iga_nonlinear", TABLE4_UNDAMPED, true},
    [TABLE4_SHELL_RATE] = {"shell_rate", "nonlinear shell, mu as a rate", "shell_2",
                           TABLE4_RATE, true},
    [TABLE4_SHELL] = {"nonlinear_shell", "nonlinear shell, undamped", "shell_2",
                      TABLE4_UNDAMPED, true},
};

/* The softest, the chaotic and the first feasible one. */
const int table4_scaled[TABLE4_SCALED] = {3, 6, 13};

enum { PATH = 4096 };

int table4_run_of(int reading, int row)
{
    const struct paper_table4_row *want = &paper_table4[row];

    if (table4_reading[reading].damping != TABLE4_UNDAMPED)
        return row;
    for (int n = 0; n < row; n++)
        if (paper_table4[n].young * want->density == want->young * paper_table4[n].density)
            return n;
    return row;
}

void table4_path(const char *folder, int reading, int scene, int row, char *path, int size)
{
    snprintf(path, (size_t)size, "%s/%s_%s_%02d.h5", folder, table4_reading[reading].name,
             table4_scene[scene], table4_run_of(reading, row) + 1);
}

static void scaled_path(const char *folder, int n, char path[PATH])
{
    snprintf(path, PATH, "%s/%s_%s_%02d_fourfold.h5", folder, table4_reading[0].name,
             table4_scene[0], table4_scaled[n] + 1);
}

static enum status read_plan(struct plan *plan, struct message *why)
{
    char *path = NULL;
    enum status st;

    TRY(named_file_find(&plan_kind, "table4", &path, why));
    TRY(plan_read(path, plan, why));
out:
    free(path);
    return st;
}

enum status table4_rules(struct verdict_rules *rules, struct verdict_rules *learnt,
                         struct message *why)
{
    struct plan plan = {0};
    const enum status st = read_plan(&plan, why);

    *rules = plan.verdicts;
    plan.verdicts = (struct verdict_rules){0};
    if (learnt) {
        *learnt = plan.learnt;
        plan.learnt = (struct verdict_rules){0};
    }
    plan_clear(&plan);
    return st;
}

/* --- running ----------------------------------------------------------------------------
 */

/* A case of the plan under a reading, E and rho times `scale`. */
struct job {
    const struct experiment_options *options;
    const struct plan *plan;
    int reading, scene, row;
    double scale;
    const char *out;
};

/* What the reading, the scale and a quick run change of the plan's case. */
static void change(const struct job *j, const struct contestant *c, struct settings *s)
{
    const struct paper_table4_row *row = &paper_table4[j->row];
    const int side = j->options->quick && j->reading != TABLE4_PRINTED ? 6 : 10;
    const double frame = 0.005;

    contestant_points(c, side, side, s);
    settings_number(s, "material.young", j->scale * row->young);
    settings_number(s, "material.density", j->scale * row->density);
    if (table4_reading[j->reading].damping == TABLE4_UNDAMPED)
        settings_set(s, "damping={kind: none}");
    if (table4_reading[j->reading].damping == TABLE4_RATE) {
        settings_word(s, "damping.kind", "mass");
        settings_number(s, "damping.value", -log(row->damping) / frame);
    }
}

static enum status run(const struct job *j, struct message *why)
{
    struct plan_case c = {0};
    struct settings s = {0};
    const struct contestant *contestant;
    enum status st;

    TRY(contestant_find(table4_reading[j->reading].contestant, &contestant, why));
    TRY(plan_case_open(j->plan, j->row * TABLE4_SCENES + j->scene, &c, why));
    settings_append(&s, &c.settings);
    change(j, contestant, &s);
    TRY(run_file_write(
        &(struct run_plan){c.path, contestant, &s, j->options->quick ? 0.3 : 0},
        &(struct run_keep){.file = j->out,
                           .every = j->plan->look,
                           .intersections = j->plan->intersections,
                           .quick = j->options->quick},
        NULL, why));
out:
    settings_clear(&s);
    plan_case_clear(&c);
    return st;
}

static enum status run_rows(struct job *j, struct message *why)
{
    enum status st = STATUS_OK;
    char path[PATH];

    j->out = path;
    for (j->row = 0; j->row < PAPER_TABLE4_ROWS; j->row++) {
        table4_path(j->options->folder, j->reading, j->scene, j->row, path, PATH);
        if (table4_run_of(j->reading, j->row) == j->row)
            TRY(run(j, why));
        experiment_progress(j->options, table4_reading[j->reading].name,
                            j->scene * PAPER_TABLE4_ROWS + j->row + 1,
                            TABLE4_SCENES * PAPER_TABLE4_ROWS);
    }
out:
    return st;
}

static enum status measure(const struct experiment_options *options, struct message *why)
{
    struct plan plan = {0};
    struct job j = {.options = options, .plan = &plan, .scale = 1};
    char path[PATH];
    enum status st;

    TRY(read_plan(&plan, why));
    for (j.reading = 0; j.reading < TABLE4_READINGS; j.reading++)
        for (j.scene = 0; j.scene < TABLE4_SCENES; j.scene++)
            TRY(run_rows(&j, why));
    j.reading = TABLE4_PRINTED, j.scene = TABLE4_FLAG, j.out = path;
    j.scale = 4; /* a power of 4: square roots in the factor stay exact */
    for (int n = 0; n < TABLE4_SCALED; n++) {
        j.row = table4_scaled[n];
        scaled_path(options->folder, n, path);
        TRY(run(&j, why));
    }
out:
    plan_clear(&plan);
    return st;
}

/* --- reading ----------------------------------------------------------------------------
 */

void table4_clear(struct table4_data *d)
{
    if (!d)
        return;
    for (int r = 0; r < TABLE4_READINGS; r++)
        for (int s = 0; s < TABLE4_SCENES; s++)
            for (int row = 0; row < PAPER_TABLE4_ROWS; row++)
                run_result_clear(&d->run[r][s][row].result);
    for (int n = 0; n < TABLE4_SCALED; n++)
        run_result_clear(&d->scaled[n]);
    verdict_clear(&d->rules);
    verdict_clear(&d->learnt);
    free(d);
}

/* The rules' labels are the paper's words. */
static void judge(const struct verdict_rules *rules, struct table4_run *run)
{
    const struct verdict v = verdict_of(rules, &run->result);

    run->feasible = v.kind == VERDICT_FEASIBLE;
    run->judged = run->feasible || v.kind == VERDICT_INFEASIBLE;
    run->labels = 0;
    for (int n = 0; n < PAPER_LABELS; n++)
        if (verdict_has(rules, v, paper_label[n]))
            run->labels |= 1u << n;
}

void table4_judge(struct table4_data *d)
{
    d->quick = false;
    for (int r = 0; r < TABLE4_READINGS; r++)
        for (int s = 0; s < TABLE4_SCENES; s++)
            for (int row = 0; row < PAPER_TABLE4_ROWS; row++) {
                judge(&d->rules, &d->run[r][s][row]);
                d->quick = d->quick || d->run[r][s][row].result.quick;
            }
}

enum status table4_load(const char *folder, struct table4_data **d, struct message *why)
{
    struct table4_data *new = calloc(1, sizeof *new);
    enum status st = new ? STATUS_OK : STATUS_MEMORY;
    char path[PATH];

    TRY(st);
    TRY(table4_rules(&new->rules, &new->learnt, why));
    for (int r = 0; r < TABLE4_READINGS; r++)
        for (int s = 0; s < TABLE4_SCENES; s++)
            for (int row = 0; row < PAPER_TABLE4_ROWS; row++) {
                table4_path(folder, r, s, row, path, PATH);
                TRY(run_result_read(path, false, &new->run[r][s][row].result, why));
            }
    for (int n = 0; n < TABLE4_SCALED; n++) {
        scaled_path(folder, n, path);
        TRY(run_result_read(path, false, &new->scaled[n], why));
    }
    table4_judge(new);
    *d = new, new = NULL;
out:
    table4_clear(new);
    return st;
}

int table4_paper(int label, bool yes[PAPER_TABLE4_ROWS])
{
    int count = 0;

    for (int row = 0; row < PAPER_TABLE4_ROWS; row++) {
        const unsigned labels = paper_table4[row].labels;
        yes[row] = label < 0 ? labels == 0 : labels >> label & 1;
        count += yes[row];
    }
    return count;
}

struct table4_agreement table4_agree(const struct table4_data *d, int reading, int scene,
                                     int label)
{
    struct table4_agreement a = {0, 0, 0, 0};
    bool paper[PAPER_TABLE4_ROWS];

    table4_paper(label, paper);
    for (int row = 0; row < PAPER_TABLE4_ROWS; row++) {
        const struct table4_run *run = &d->run[reading][scene][row];
        const bool ours = label < 0 ? run->feasible : run->labels >> label & 1;
        if (!run->judged)
            continue;
        a.hit += ours && paper[row];
        a.missed += !ours && paper[row];
        a.extra += ours && !paper[row];
        a.agree += ours == paper[row];
    }
    return a;
}

void table4_column(const struct table4_data *d, int reading, int scene, int measure,
                   double value[PAPER_TABLE4_ROWS])
{
    for (int row = 0; row < PAPER_TABLE4_ROWS; row++)
        value[row] = d->run[reading][scene][row].result.value[measure];
}

static int agreement(int count, const double *value, const bool *yes, double low,
                     double high)
{
    int agree = 0;

    for (int n = 0; n < count; n++)
        agree += (value[n] >= low && value[n] <= high) == yes[n];
    return agree;
}

struct table4_interval table4_best(int count, const double *value, const bool *yes,
                                   enum table4_bounds shape)
{
    struct table4_interval best = {INFINITY, -INFINITY, 0};

    best.agree = agreement(count, value, yes, best.low, best.high);
    for (int i = 0; i < count; i++)
        for (int j = 0; j < count; j++) {
            double low = shape == TABLE4_BELOW ? -INFINITY : value[i];
            double high = shape == TABLE4_ABOVE ? INFINITY : value[j];
            int agree = agreement(count, value, yes, low, high);
            if (agree > best.agree)
                best = (struct table4_interval){low, high, agree};
        }
    return best;
}

const char *table4_words(unsigned labels, char *text, int size)
{
    size_t used = 0;

    snprintf(text, (size_t)size, "%s", labels ? "" : "-");
    for (int n = 0; n < PAPER_LABELS && used < (size_t)size; n++)
        if (labels >> n & 1)
            used += (size_t)snprintf(text + used, (size_t)size - used, "%s%s",
                                     used ? ", " : "", paper_label[n]);
    return text;
}

static enum status print(const char *folder, enum table_format format, FILE *file,
                         struct message *why)
{
    struct table4_data *d = NULL;
    char path[PATH];
    enum status st;

    TRY(table4_load(folder, &d, why));
    TRY(table4_print(d, folder, format, file, why));
    if (table_format_is_prose(format)) {
        table4_path(folder, TABLE4_PRINTED, TABLE4_FLAG, 0, path, sizeof path);
        measurement_machine(path, file);
    }
out:
    table4_clear(d);
    return st;
}

const struct experiment table4_exhibit = {
    .item = {"4", "E, rho and mu that give cloth, and why the others do not"},
    .measure = measure,
    .print = print,
};
