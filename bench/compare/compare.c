#include "bench/compare/compare.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "bench/compare/fig6.h"
#include "bench/files/folder.h"
#include "bench/ui/progress.h"
#include "bench/harness/timing.h"
#include "bench/truth/truth_plan.h"
#include "models/damping.h"
#include "models/metric/metric.h"
#include "models/reader/scene_file.h"

enum { MOST_TIMES = 5, MOST_SETTINGS = 256 };

/* Half a second: an edge drop's first quarter swing, before motions part for good. */
static const double UNTIL = 0.5;

struct job {
    struct compare compare;
    struct scene scene;
    char *path;
    const char *folder;
    int times;
    double time[MOST_TIMES];
    int given; /* settings of the user                                                 */
    const char *const *set;
    const char *damping; /* our own setting, or NULL                                   */
    bool quick, read_only;
};

/* The user's settings, ours and the rung's into all[]; returns their number. */
static int settings_of(const struct job *j, const struct ladder_rung *r, bool printed,
                       const char **all)
{
    int count = 0;

    for (int n = 0; n < j->given; n++)
        all[count++] = j->set[n];
    if (j->damping && !printed)
        all[count++] = j->damping;
    for (int n = 0; r && n < r->count; n++)
        all[count++] = r->settings[n];
    return count;
}

/* Those given by --until; else those of the stored truth up to UNTIL; else up to UNTIL. */
static enum status read_times(struct job *j, const struct command_line *line,
                              struct message *why)
{
    const char *word = command_value(line, "--until");
    const char *all[MOST_SETTINGS];
    char *end = NULL;
    double until = word ? strtod(word, &end) : fmin(UNTIL, j->scene.end);

    if (word && (*end || !(until > 0)))
        return status_fail(why, STATUS_INPUT, "--until %s: a time in seconds, above 0",
                           word);
    if (!word) {
        enum status st = truth_stored_times(j->path, settings_of(j, NULL, false, all), all,
                                            until, MOST_TIMES, j->time, &j->times, why);
        if (st != STATUS_OK || j->times)
            return st;
    }
    j->times = MOST_TIMES;
    for (int n = 0; n < j->times; n++)
        j->time[n] =
            fmax(1, round((n + 1) * until / j->times / j->scene.step)) * j->scene.step;
    for (int n = 1; n < j->times; n++)
        if (j->time[n] <= j->time[n - 1])
            return status_fail(why, STATUS_INPUT,
                               "--until %g: at least %d frames of %g s are needed", until,
                               j->times, j->scene.step);
    return STATUS_OK;
}

/* All but the paper's own scheme move as the truth does (truth_plan.h). */
static void choose_damping(struct job *j)
{
    for (int n = 0; n < j->given; n++)
        if (!strncmp(j->set[n], "damping", 7))
            return;
    j->damping = truth_plan_damping(&j->scene);
    if (!j->damping)
        return;
    snprintf(j->compare.physics, sizeof j->compare.physics,
             "undamped, but for the paper's own scheme with velocity_scale %g",
             j->scene.damping.value);
}

static enum status prepare(struct job *j, const struct command_line *line,
                           struct message *why)
{
    enum status st;
    struct discretization unused = {0};

    j->set = command_values(line, "--set", &j->given);
    j->quick = command_given(line, "--quick");
    if (j->given + LADDER_SETTINGS + 1 > MOST_SETTINGS)
        return status_fail(why, STATUS_INPUT, "--set: at most %d settings",
                           MOST_SETTINGS - LADDER_SETTINGS - 1);
    TRY(scene_file_find(line->words[0], &j->path, why));
    TRY(scene_file_read(j->path, j->given, j->set, &j->scene, &unused, why));
    discretization_clear(&unused);
    snprintf(j->compare.physics, sizeof j->compare.physics, "damping %s",
             damping_name((int)j->scene.damping.kind));
    choose_damping(j);
    TRY(read_times(j, line, why));
    j->compare.scene = j->scene.name;
    j->compare.gamma = scene_gamma(&j->scene);
    j->compare.length = j->scene.length;
    j->compare.frame = j->scene.step;
out:
    return st;
}

static bool is_printed(const struct ladder_rung *r)
{
    for (int n = 0; n < r->count; n++)
        if (strstr(r->settings[n], "kinematics=printed"))
            return true;
    return false;
}

static enum status run_row(const struct job *j, struct compare_row *row,
                           struct message *why)
{
    const char *all[MOST_SETTINGS];
    struct rung_plan plan = {.path = j->path,
                             .setting_count =
                                 settings_of(j, &row->rung, is_printed(&row->rung), all),
                             .settings = all,
                             .model = row->rung.model,
                             .times = j->times,
                             .time = j->time,
                             .folder = j->folder,
                             .name = row->rung.name};
    struct message refusal = {""};
    enum status st = j->read_only ? STATUS_OK : rung_run(&plan, &refusal);

    if (st == STATUS_UNSUPPORTED) {
        snprintf(row->refused, sizeof row->refused, "%.255s", refusal.text);
        return STATUS_OK;
    }
    if (st == STATUS_OK)
        st = rung_read(&plan, &row->result, &refusal);
    if (st != STATUS_OK)
        return status_fail(why, st, "%s: %s", row->rung.name, refusal.text);
    row->worst = row->result.frames < j->times ? NAN : 0;
    for (int n = 0; n < row->result.frames; n++)
        row->worst =
            fmax(row->worst, metric_rmse(row->result.xyz[n], j->compare.truth->xyz[n]) /
                                 j->compare.length);
    if (row->result.frames < j->times)
        row->worst = NAN;
    return STATUS_OK;
}

static enum status plan_rows(struct job *j, const char *models, struct message *why)
{
    struct compare *c = &j->compare;
    struct ladder_rung *rungs = NULL;
    enum status st;

    TRY(ladder_make(models, j->scene.step, j->quick, &rungs, &c->count, why));
    c->rows = calloc((size_t)c->count + 1, sizeof *c->rows);
    if (!c->rows)
        TRY(STATUS_MEMORY);
    for (int n = 0; n < c->count; n++) {
        c->rows[n].rung = rungs[n];
        c->rows[n].worst = NAN;
    }
out:
    free(rungs);
    return st;
}

static enum status run_all(struct job *j, struct message *why)
{
    struct compare *c = &j->compare;
    struct progress bar = progress_start("compare", c->count, false);
    enum status st = STATUS_OK;

    for (int n = 0; n < c->count; n++) {
        TRY(run_row(j, &c->rows[n], why));
        progress_update(&bar, n + 1);
    }
    progress_end(&bar);
out:
    return st;
}

static enum status run(const struct command_line *line, struct message *why)
{
    enum status st;
    struct job j = {0};
    struct truth *truth = NULL;
    const char *all[MOST_SETTINGS], *word = command_value(line, "--format");
    const char *out = command_value(line, "--out"), *from = command_value(line, "--from");
    enum table_format format = TABLE_TEXT;
    char folder[4096];

    if (word)
        TRY(table_format_parse(word, &format, why));
    if (out && from)
        return status_fail(why, STATUS_INPUT,
                           "--from reads result files and --out writes "
                           "them; give one of the two");
    TRY(prepare(&j, line, why));
    TRY(plan_rows(&j, command_value(line, "--models"), why));
    snprintf(folder, sizeof folder, "results/compare_%s", j.scene.name);
    j.folder = from ? from : out ? out : folder;
    j.read_only = from != NULL;
    TRY(folder_make(j.folder, why));
    omp_set_num_threads(1);
    timing_pin();
    if (!strcmp(j.scene.name, "corners_drop"))
        TRY(fig6_compare(j.path, j.given, j.set, j.folder, j.read_only, format, stdout,
                         why));
    TRY(truth_find(j.path, settings_of(&j, NULL, false, all), all, j.times, j.time,
                   j.folder, j.quick ? TRUTH_QUICK : TRUTH_FULL, &truth, why));
    j.compare.truth = truth;
    TRY(run_all(&j, why));
    TRY(compare_print(&j.compare, format, stdout));
    TRY(compare_print_files(&j.compare, j.folder, why));
out:
    for (int n = 0; j.compare.rows && n < j.compare.count; n++)
        rung_clear(&j.compare.rows[n].result);
    free(j.compare.rows);
    truth_destroy(truth);
    scene_clear(&j.scene);
    free(j.path);
    return st;
}

static const struct command_option options[] = {
    {"--models", "NAME,NAME,...", false, "which models (all that are built)"},
    {"--set", "KEY=VALUE", true, "override a key of the scene"},
    {"--until", "SECONDS", false,
     "compare five times up to this one (0.5, or those of\nthe stored truth before it)"},
    {"--format", TABLE_FORMATS, false, "how to print (text)"},
    {"--out", "DIR", false, "where result files, CSV and plot go (results/compare_SCENE)"},
    {"--from", "DIR", false, "tables and plot from result files of an earlier run"},
    {"--quick", NULL, false, "the cheap half of each ladder"},
    {NULL, NULL, false, NULL},
};

const struct command compare_command = {
    .name = "compare",
    .summary = "speed against error, all models, one scene",
    .arguments = "SCENE [OPTION]...",
    .text =
        "Runs each model over a ladder of nets, time steps and iterations with matched\n"
        "parameters, holds every run against the scene's truth on the material grid and\n"
        "prints the error against the seconds, the time each model needs for 10, 3, 1\n"
        "and 0.1 %, and the error that refinement does not remove.\n",
    .examples = "compare edge_drop\ncompare corners_drop --models iga,shell\n"
                "compare edge_drop --from results/compare_edge_drop --format csv\n",
    .least = 1,
    .most = 1,
    .options = options,
    .run = run,
};
