#include "bench/tables/table4.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "models/reader/scene_file.h"

const char *const table4_scene[TABLE4_SCENES] = {"flag", "edge_drop"};

const struct table4_reading table4_reading[TABLE4_READINGS] = {
    [TABLE4_PRINTED] = {"printed", "printed, v <- mu v (the paper's)", "iga", "printed",
                        TABLE4_SCALE},
    [TABLE4_INCREMENTAL] = {"incremental", "incremental, v <- mu v", "iga", "incremental",
                            TABLE4_SCALE},
    [TABLE4_INCREMENTAL_UNDAMPED] = {"incremental_undamped", "incremental, undamped", "iga",
                                     "incremental", TABLE4_UNDAMPED},
    [TABLE4_LINEAR] = {"linear", "linear, v <- mu v", "iga", "linear", TABLE4_SCALE},
    [TABLE4_SOLID] = {"nonlinear", "nonlinear solid, remedy none, undamped", "iga",
                      "nonlinear", TABLE4_UNDAMPED},
    [TABLE4_SHELL_RATE] = {"shell_rate", "nonlinear shell, mu as a rate", "shell",
                           "nonlinear", TABLE4_RATE},
    [TABLE4_SHELL] = {"shell", "nonlinear shell, undamped", "shell", "nonlinear",
                      TABLE4_UNDAMPED},
};

/* The softest, the chaotic and the first feasible one. */
const int table4_scaled[TABLE4_SCALED] = {3, 6, 13};

/* A look every 0.05 s; the paper's net, a shell of as many points. */
enum { EVERY = 10, SETTINGS = 7, SETTING = 96 };

bool table4_is_physics(int reading)
{
    return !strcmp(table4_reading[reading].kinematics, "nonlinear");
}

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

void table4_scaled_path(const char *folder, int n, char *path, int size)
{
    snprintf(path, (size_t)size, "%s/%s_%s_%02d_fourfold.h5", folder,
             table4_reading[0].name, table4_scene[0], table4_scaled[n] + 1);
}

/* One case: a row, E and rho times `scale`, on a scene file under a reading. */
struct job {
    const struct exhibit_options *options;
    const struct provenance *provenance;
    const char *scene; /* its file                                                     */
    int reading, row;
    double scale;
    const char *out;
};

static void set_damping(const struct job *j, char *text, size_t size)
{
    const double frame = 0.005, mu = paper_table4[j->row].damping;

    switch (table4_reading[j->reading].damping) {
    case TABLE4_SCALE:
        snprintf(text, size, "damping={kind: velocity_scale, value: %.17g}", mu);
        break;
    case TABLE4_RATE:
        snprintf(text, size, "damping={kind: mass, value: %.17g}", -log(mu) / frame);
        break;
    case TABLE4_UNDAMPED:
        snprintf(text, size, "damping={kind: none}");
        break;
    }
}

static enum status run(const struct job *j, struct message *why)
{
    const struct paper_table4_row *row = &paper_table4[j->row];
    const struct table4_reading *reading = &table4_reading[j->reading];
    const bool quick = j->options->quick, shell = !strcmp(reading->model, "shell");
    const int side = quick && j->reading != TABLE4_PRINTED ? 6 : 10;
    char text[SETTINGS][SETTING];
    const char *settings[SETTINGS];
    struct case_result unused;

    snprintf(text[0], SETTING, "material.young=%.17g", j->scale * row->young);
    snprintf(text[1], SETTING, "material.density=%.17g", j->scale * row->density);
    set_damping(j, text[2], SETTING);
    snprintf(text[3], SETTING, "time.end=%g", quick ? 0.3 : 3.0);
    snprintf(text[4], SETTING, "snapshots=[]");
    snprintf(text[5], SETTING, "discretization.kinematics=%s", reading->kinematics);
    snprintf(text[6], SETTING, "discretization.points=[%d,%d%s]", side, side,
             shell ? "" : ",2");
    for (int n = 0; n < SETTINGS; n++)
        settings[n] = text[n];
    return case_run(&(struct case_plan){.path = j->scene,
                                        .setting_count = SETTINGS,
                                        .settings = settings,
                                        .model = reading->model,
                                        .every = EVERY,
                                        .intersections = true,
                                        .out = j->out,
                                        .provenance = j->provenance},
                    &unused, why);
}

static enum status run_rows(struct job *j, int scene, struct message *why)
{
    enum status st = STATUS_OK;
    char path[4096];

    for (j->row = 0; j->row < PAPER_TABLE4_ROWS; j->row++) {
        table4_path(j->options->folder, j->reading, scene, j->row, path, sizeof path);
        j->out = path;
        if (table4_run_of(j->reading, j->row) == j->row)
            TRY(run(j, why));
        exhibit_progress(j->options, table4_reading[j->reading].name,
                         scene * PAPER_TABLE4_ROWS + j->row + 1,
                         TABLE4_SCENES * PAPER_TABLE4_ROWS);
    }
out:
    return st;
}

static enum status run_scaled(struct job *j, struct message *why)
{
    enum status st = STATUS_OK;
    char path[4096];

    j->reading = TABLE4_PRINTED;
    j->scale = 4; /* a power of 4: square roots in the factor stay exact */
    j->out = path;
    for (int n = 0; n < TABLE4_SCALED; n++) {
        j->row = table4_scaled[n];
        table4_scaled_path(j->options->folder, n, path, sizeof path);
        TRY(run(j, why));
    }
out:
    return st;
}

static enum status measure(const struct exhibit_options *options, struct message *why)
{
    enum status st = STATUS_OK;
    struct provenance provenance;
    struct job j = {.options = options, .provenance = &provenance, .scale = 1};
    char *scene[TABLE4_SCENES] = {NULL};

    provenance_collect(&provenance);
    for (int s = 0; s < TABLE4_SCENES; s++)
        TRY(scene_file_find(table4_scene[s], &scene[s], why));
    for (j.reading = 0; j.reading < TABLE4_READINGS; j.reading++)
        for (int s = 0; s < TABLE4_SCENES; s++) {
            j.scene = scene[s];
            TRY(run_rows(&j, s, why));
        }
    j.scene = scene[TABLE4_FLAG];
    TRY(run_scaled(&j, why));
out:
    for (int s = 0; s < TABLE4_SCENES; s++)
        free(scene[s]);
    return st;
}

const struct exhibit table4_exhibit = {
    .item = {"4", "E, rho and mu that give cloth, and why the others do not"},
    .measure = measure,
    .print = table4_print,
};
