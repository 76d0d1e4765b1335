#include "bench/truth/truth_command.h"

#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/folder.h"
#include "bench/ui/progress.h"
#include "bench/harness/timing.h"
#include "bench/truth/truth_file.h"
#include "models/reader/scene_file.h"

enum { PATH = 4096 };

struct job {
    char *path;
    struct scene scene;
    bool quick;
    int count;
    const char *set[TRUTH_MOST_SETTINGS];
    enum table_format format;
};

static enum status prepare(struct job *j, const struct command_line *line,
                           struct message *why)
{
    struct discretization unused = {0};
    const char *word = command_value(line, "--format"), *damping;
    const char *const *given = command_values(line, "--set", &j->count);
    enum status st;

    j->quick = command_given(line, "--quick");
    if (word)
        TRY(table_format_parse(word, &j->format, why));
    if (j->count + TRUTH_LEVEL_SETTINGS >= TRUTH_MOST_SETTINGS)
        TRY(status_fail(why, STATUS_INPUT, "--set: at most %d settings",
                        TRUTH_MOST_SETTINGS - TRUTH_LEVEL_SETTINGS - 1));
    for (int n = 0; n < j->count; n++)
        j->set[n] = given[n];
    TRY(scene_file_find(line->words[0], &j->path, why));
    TRY(scene_file_read(j->path, j->count, j->set, &j->scene, &unused, why));
    damping = truth_plan_damping(&j->scene);
    if (damping)
        j->set[j->count++] = damping;
out:
    discretization_clear(&unused);
    return st;
}

static void show(void *context, int done, int total)
{
    struct progress *bar = context;

    if (!done)
        *bar = progress_start("truth", total, false);
    progress_update(bar, done);
    if (done == total)
        progress_end(bar);
}

static enum status make_one(struct job *j, const char *out, struct message *why)
{
    struct truth_plan plan = truth_plan_of(j->scene.name, j->quick);
    struct truth_made made = {0};
    struct progress bar;
    double *time = NULL;
    char folder[PATH], file[2 * PATH];
    enum status st;

    snprintf(folder, sizeof folder, "results/truth_%s%s", j->scene.name,
             j->quick ? "_quick" : "");
    snprintf(file, sizeof file, "results/truths%s/%s.h5", j->quick ? "_quick" : "",
             j->scene.name);
    TRY(folder_make(folder, why));
    if (!out) {
        TRY(folder_make(j->quick ? "results/truths_quick" : "results/truths", why));
        out = file;
    }
    struct truth_runs runs = {.path = j->path,
                              .setting_count = j->count,
                              .settings = j->set,
                              .times = truth_plan_times(&plan, &j->scene, &time),
                              .folder = folder};
    runs.time = time;
    if (runs.times < 0)
        TRY(STATUS_MEMORY);
    omp_set_num_threads(1);
    timing_pin();
    TRY(truth_make(&plan, &runs, &j->scene, show, &bar, &made, why));
    TRY(truth_file_write(out, &runs, &made, why));
    TRY(truth_print(&made, j->scene.name, j->scene.length, j->format, stdout));
    fprintf(stderr, "truth in %s, its runs in %s\n", out, folder);
out:
    truth_made_clear(&made);
    free(time);
    return st;
}

static enum status print_stored(const struct job *j, struct message *why)
{
    struct truth_made made = {0};
    char *path = NULL, *physics = NULL;
    enum status st;

    TRY(named_file_find(&truth_file_kind, j->scene.name, &path, why));
    TRY(truth_file_read(path, &made, &physics, why));
    TRY(truth_print(&made, j->scene.name, j->scene.length, j->format, stdout));
out:
    truth_made_clear(&made);
    free(physics);
    free(path);
    return st;
}

static enum status run(const struct command_line *line, struct message *why)
{
    struct job j = {0};
    enum status st;

    TRY(prepare(&j, line, why));
    if (command_given(line, "--stored"))
        TRY(print_stored(&j, why));
    else
        TRY(make_one(&j, command_value(line, "--out"), why));
out:
    scene_clear(&j.scene);
    free(j.path);
    return st;
}

static const struct command_option options[] = {
    {"--set", "KEY=VALUE", true, "override a key of the scene"},
    {"--out", "FILE", false, "where the truth goes (results/truths/SCENE.h5)"},
    {"--stored", NULL, false, "only print the table of the truth that is stored"},
    {"--format", TABLE_FORMATS, false, "how to print (text)"},
    {"--quick", NULL, false, "coarse nets, 0.2 s: for trying out"},
    {NULL, NULL, false, NULL},
};

const struct command truth_command = {
    .name = "truth",
    .summary = "what a scene's motion is, with an error bar, and until when",
    .arguments = "SCENE [OPTION]...",
    .text =
        "Runs the nonlinear solid, cured of locking, and the nonlinear shell, each on\n"
        "three nets and with three time steps, prints the orders observed, what they\n"
        "leave as error bars, the difference of the two models, and until which time the\n"
        "motion is predictable: one run is made again with gravity changed by 1e-6. The\n"
        "better model's motion is stored, with the larger of its bar and the difference.\n"
        "Truths of some scenes come with the program; `compare` and others use these and\n"
        "those in $CLOTHBENCH_TRUTHS. A scene damped by velocity_scale, which is no rate,\n"
        "has an undamped truth. Runs that are there are not made again.\n",
    .examples = "truth edge_drop --stored\ntruth sphere --quick\n"
                "truth flag --set material.young=1e5 --out flag.h5\n",
    .least = 1,
    .most = 1,
    .options = options,
    .run = run,
};
