#include "bench/compare/compare.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/compare/fig6.h"
#include "bench/experiment/batch.h"
#include "bench/files/folder.h"
#include "bench/harness/timing.h"
#include "bench/truth/truth_plan.h"
#include "bench/ui/progress.h"
#include "models/damping.h"
#include "models/metric/metric.h"
#include "models/reader/scene_file.h"

/* Half a second: an edge drop's first quarter swing, before motions part for good. */
static const double UNTIL = 0.5;

struct job {
    struct compare compare;
    struct scene scene;
    char *path;
    const char *folder;
    int times;
    double time[COMPARE_TIMES];
    struct settings user;  /* the user's                                               */
    struct settings truth; /* these, and how the truth is damped                       */
    struct batch batch;    /* a case a row                                             */
    bool quick;
};

/* Those given by --until; else those of the stored truth up to UNTIL; else up to UNTIL. */
static enum status read_times(struct job *j, const struct command_line *line,
                              struct message *why)
{
    const char *word = command_value(line, "--until");
    char *end = NULL;
    double until = word ? strtod(word, &end) : fmin(UNTIL, j->scene.end);

    if (word && (*end || !(until > 0)))
        return status_fail(why, STATUS_INPUT, "--until %s: a time in seconds, above 0",
                           word);
    if (!word) {
        enum status st = truth_stored_times(j->path, &j->truth, until, COMPARE_TIMES,
                                            j->time, &j->times, why);
        if (st != STATUS_OK || j->times)
            return st;
    }
    j->times = COMPARE_TIMES;
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
    const char *truth = truth_plan_damping(&j->scene);

    snprintf(j->compare.physics, sizeof j->compare.physics, "damping %s",
             damping_name((int)j->scene.damping.kind));
    settings_append(&j->truth, &j->user);
    for (int n = 0; n < j->user.count; n++)
        if (!strncmp(j->user.text[n], "damping", 7))
            return;
    if (!truth)
        return;
    settings_set(&j->truth, truth);
    snprintf(j->compare.physics, sizeof j->compare.physics,
             "undamped, but for the paper's own scheme with velocity_scale %g",
             j->scene.damping.value);
}

static enum status prepare(struct job *j, const struct command_line *line,
                           struct message *why)
{
    enum status st;
    int given;
    const char *const *set = command_values(line, "--set", &given);

    j->quick = command_given(line, "--quick");
    settings_set_all(&j->user, given, set);
    TRY(scene_file_find(line->words[0], &j->path, why));
    TRY(settings_read_scene(&j->user, j->path, &j->scene, why));
    choose_damping(j);
    TRY(read_times(j, line, why));
    j->compare.scene = &j->scene;
out:
    return st;
}

static int length(const int *list, int most)
{
    int n = 0;

    while (n < most && list[n])
        n++;
    return n;
}

/* Nets, time steps and iterations of a contestant; `quick` leaves out the dear half. */
static void add_rows(struct compare *c, const struct contestant *who, bool quick)
{
    const int sides = length(who->points, quick ? 2 : CONTESTANT_STEPS);
    const int divisors = length(who->divisors, quick ? 1 : CONTESTANT_STEPS);
    const int iterations = length(who->iterations, CONTESTANT_STEPS);

    for (int s = 0; s < sides; s++)
        for (int d = 0; d < divisors; d++)
            for (int i = 0; i == 0 || i < iterations; i++)
                c->rows[c->count++].at =
                    (struct refinement){who, who->points[s], who->divisors[d],
                                        iterations ? who->iterations[i] : 0};
}

static void refine(const struct refinement *r, double frame, struct settings *s)
{
    contestant_settings(r->contestant, s); /* again: what the user set may not change it */
    contestant_points(r->contestant, r->side, r->side, s);
    settings_number(s, "time.step", frame / r->divisor);
    if (r->iterations)
        settings_integer(s, "discretization.iterations", r->iterations);
}

static void plan_row(struct job *j, const struct refinement *r)
{
    char name[128];

    snprintf(name, sizeof name, "%s_%d_%d_%d", r->contestant->name, r->side, r->divisor,
             r->iterations);
    struct measurement_case *c = batch_add(&j->batch, j->path, r->contestant, name);
    c->plan.end = j->time[j->times - 1];
    c->keep.times = j->times;
    c->keep.time = j->time;
    c->keep.fields = RUN_FIELDS_TIMES;
    c->timed = MEASUREMENT_WHOLE;
    settings_append(batch_settings(&j->batch),
                    contestant_is_paper_scheme(r->contestant) ? &j->user : &j->truth);
    refine(r, j->scene.step, batch_settings(&j->batch));
}

enum { MOST = CONTESTANT_STEPS * CONTESTANT_STEPS * CONTESTANT_STEPS };

/* All of a choice (contestant_chosen), model by model. */
static enum status plan_rows(struct job *j, const char *models, struct message *why)
{
    struct compare *c = &j->compare;
    const struct model *model;
    size_t contestants = 0;
    enum status st;

    TRY(contestant_check(models, why));
    while (contestant_table[contestants].name)
        contestants++;
    c->rows = calloc(contestants * MOST, sizeof *c->rows);
    TRY(c->rows ? STATUS_OK : STATUS_MEMORY);
    for (int m = 0; (model = contestant_model(m)); m++)
        for (const struct contestant *who = contestant_table; who->name; who++)
            if (who->model == model && contestant_chosen(who, models, CONTESTANT_COMPARE))
                add_rows(c, who, j->quick);
    TRY(batch_init(&j->batch, j->folder, c->count));
    for (int n = 0; n < c->count; n++)
        plan_row(j, &c->rows[n].at);
out:
    return st;
}

static enum status read_row(const struct job *j, int n, struct message *why)
{
    struct compare_row *row = &j->compare.rows[n];
    struct run_result r = {0};
    enum status st;

    TRY(batch_read(&j->batch, n, true, &r, why));
    row->worst = 0;
    for (int t = 0; t < j->times; t++) {
        row->error[t] =
            t < r.frames ? metric_rmse(r.xyz[t], j->compare.truth->xyz[t]) / j->scene.length
                         : NAN;
        row->worst = isnan(row->error[t]) ? NAN : fmax(row->worst, row->error[t]);
    }
    if (r.frames < j->times)
        row->worst = NAN;
    row->seconds = r.create.median + r.step.median * (double)r.steps;
    row->result = r;
    row->result.xyz = NULL, row->result.time = NULL;
out:
    run_result_clear(&r);
    return st;
}

static void show(void *context, const char *what, int done, int total)
{
    struct progress *bar = context;

    (void)what;
    bar->total = total;
    progress_update(bar, done);
}

static enum status run_all(struct job *j, struct message *why)
{
    struct progress bar = progress_start("compare", 1, false);
    const struct measurement_options options = {
        .what = "compare", .quick = j->quick, .progress = show, .context = &bar};
    const enum status st = batch_run(&j->batch, &options, why);

    progress_end(&bar);
    return st;
}

static enum status run(const struct command_line *line, struct message *why)
{
    enum status st;
    struct job j = {0};
    struct truth *truth = NULL;
    const char *word = command_value(line, "--format");
    const char *out = command_value(line, "--out"), *from = command_value(line, "--from");
    enum table_format format = TABLE_TEXT;
    char folder[4096];

    if (word)
        TRY(table_format_parse(word, &format, why));
    if (out && from)
        return status_fail(
            why, STATUS_INPUT,
            "--from reads result files and --out writes them; give one of the two");
    TRY(prepare(&j, line, why));
    snprintf(folder, sizeof folder, "results/compare_%s", j.scene.name);
    j.folder = from ? from : out ? out : folder;
    TRY(plan_rows(&j, command_value(line, "--models"), why));
    TRY(folder_make(j.folder, why));
    timing_alone();
    if (!strcmp(j.scene.name, "corners_drop"))
        TRY(fig6_compare(j.path, &j.user, j.folder, from != NULL, format, stdout, why));
    TRY(truth_find(j.path, &j.truth, j.times, j.time, j.folder,
                   j.quick ? TRUTH_QUICK : TRUTH_FULL, &truth, why));
    j.compare.truth = truth;
    if (!from)
        TRY(run_all(&j, why));
    for (int n = 0; n < j.compare.count; n++)
        TRY(read_row(&j, n, why));
    TRY(compare_print(&j.compare, j.folder, format, stdout, why));
out:
    free(j.compare.rows);
    batch_clear(&j.batch);
    settings_clear(&j.user);
    settings_clear(&j.truth);
    truth_destroy(truth);
    scene_clear(&j.scene);
    free(j.path);
    return st;
}

static const struct command_option options[] = {
    {"--models", "NAME,NAME,...", false,
     "which models or contestants (all that enter here;\nclothbench list contestants)"},
    {"--set", "KEY=VALUE", true, "override a key of the scene"},
    {"--until", "SECONDS", false,
     "compare five times up to this one (0.5, or those of\nthe stored truth before it)"},
    {"--format", TABLE_FORMATS, false, "how to print (text)"},
    {"--out", "DIR", false, "where result files, CSV and plot go (results/compare_SCENE)"},
    {"--from", "DIR", false, "tables and plot from result files of an earlier run"},
    {"--quick", NULL, false, "the cheap half of each refinement, three repeats"},
    {NULL, NULL, false, NULL},
};

const struct command compare_command = {
    .name = "compare",
    .summary = "speed against error, all models, one scene",
    .arguments = "SCENE [OPTION]...",
    .text =
        "Runs each contestant over nets, time steps and iterations from cheap to dear,\n"
        "holds every run against the scene's truth on the material grid, times all in\n"
        "turn and prints the error beside the seconds, the time each needs for 10, 3, 1\n"
        "and 0.1 %, and the error that refinement does not remove. Seconds are medians\n"
        "of the repeats that stand beside them.\n",
    .examples = "compare edge_drop\ncompare corners_drop --models iga,shell_3\n"
                "compare edge_drop --from results/compare_edge_drop --format csv\n",
    .least = 1,
    .most = 1,
    .options = options,
    .run = run,
};
