/* The free fall and the creep of study_timestep.h. */
#include <math.h>
#include <stdlib.h>

#include "bench/harness/registry.h"
#include "bench/studies/study_timestep.h"
#include "bench/truth/truth_plate.h"
#include "models/grid.h"
#include "models/reader/scene_file.h"

/* Late enough for v <- mu v to have forgotten its start: 0.7^50 = 2e-8. */
static const double fall_time[] = {0.5, 0.75, 1.0}; /* [s] */
static const struct {
    double mu, step;
} falls[STUDY_TIMESTEP_FALLS] = {{0.2, 0.01},   {1 / 3., 0.01}, {0.5, 0.01},
                                 {0.7, 0.01},   {0.2, 0.0025},  {1 / 3., 0.0025},
                                 {0.5, 0.0025}, {0.7, 0.0025}};

/* A stiff cantilever under a weight so small that a creep of some seconds does not bend it
 * far; its slowest mode dies out before these times. */
static const double creep_time[] = {0.5, 0.75}; /* [s] */
static const struct {
    double young, step;
} creeps[STUDY_TIMESTEP_CREEPS] = {{4e7, 0.01},    {4e7, 0.005}, {4e7, 0.0025},
                                   {4e7, 0.00125}, {2e7, 0.005}, {8e7, 0.005}};

/* Small: a second's fall is to stay within ten lengths. */
const double study_timestep_viscous_gravity = 1;

enum {
    CASES = 2 * STUDY_TIMESTEP_FALLS + 2 * STUDY_TIMESTEP_CREEPS,
    SETTINGS = 7,
    TEXT = 80
};

/* Cases in the order of the files: falls printed, falls incremental, creeps, statics. */
enum part { FALL_PRINTED, FALL_INCREMENTAL, CREEP, STATIC };

static enum part part_of(int n, int *index)
{
    if (n < 2 * STUDY_TIMESTEP_FALLS) {
        *index = n % STUDY_TIMESTEP_FALLS;
        return n < STUDY_TIMESTEP_FALLS ? FALL_PRINTED : FALL_INCREMENTAL;
    }
    n -= 2 * STUDY_TIMESTEP_FALLS;
    *index = n % STUDY_TIMESTEP_CREEPS;
    return n < STUDY_TIMESTEP_CREEPS ? CREEP : STATIC;
}

static void file_of(const char *folder, int n, char path[TIMED_PATH])
{
    static const char *const name[] = {"fall_printed", "fall_incremental", "creep",
                                       "creep_static"};
    int index;
    enum part part = part_of(n, &index);

    if (part <= FALL_INCREMENTAL)
        snprintf(path, TIMED_PATH, "%s/%s_mu%.0f_dt%.0fus.h5", folder, name[part],
                 100 * falls[index].mu, 1e6 * falls[index].step);
    else
        snprintf(path, TIMED_PATH, "%s/%s_e%.0f_dt%.0fus.h5", folder, name[part],
                 creeps[index].young, 1e6 * creeps[index].step);
}

static enum status read_scene(int n, struct scene *scene, struct discretization *d,
                              struct message *why)
{
    static const char *const kinematics[] = {"printed", "incremental", "printed", "linear"};
    char text[SETTINGS][TEXT], *path = NULL;
    const char *settings[SETTINGS];
    int index, count = 0;
    enum part part = part_of(n, &index);
    bool fall = part <= FALL_INCREMENTAL;
    enum status st;

    for (int k = 0; k < SETTINGS; k++)
        settings[k] = text[k];
    snprintf(text[count++], TEXT, "discretization.kinematics=%s", kinematics[part]);
    snprintf(text[count++], TEXT, "time.step=%.17g",
             fall ? falls[index].step : creeps[index].step);
    snprintf(text[count++], TEXT, "damping={kind: velocity_scale, value: %.17g}",
             fall ? falls[index].mu : 0.5);
    if (fall) {
        snprintf(text[count++], TEXT, "supports=[]");
        snprintf(text[count++], TEXT, "snapshots=[]");
        snprintf(text[count++], TEXT, "gravity=[0, 0, %.17g]",
                 -study_timestep_viscous_gravity);
        snprintf(text[count++], TEXT, "discretization.points=[4,4,2]");
    } else {
        snprintf(text[count++], TEXT, "material.young=%.17g", creeps[index].young);
        snprintf(text[count++], TEXT, "material.density=1");
        snprintf(text[count++], TEXT, "sheet.thickness=0.02");
        snprintf(text[count++], TEXT, "gravity=[0, 0, -0.1]");
    }
    TRY(scene_file_find(fall ? "edge_drop" : "cantilever", &path, why));
    TRY(scene_file_read(path, count, settings, scene, d, why));
out:
    free(path);
    return st;
}

enum status study_timestep_viscous_measure(const struct experiment_options *options,
                                           struct message *why)
{
    struct timed_case *cases = calloc(CASES, sizeof *cases);
    struct scene scenes[CASES] = {{0}};
    struct provenance provenance;
    enum status st = cases ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    provenance_collect(&provenance);
    for (int n = 0; n < CASES; n++) {
        struct timed_case *c = &cases[n];
        int index;
        enum part part = part_of(n, &index);
        TRY(registry_find("iga", &c->model, why));
        c->model->defaults(&c->d);
        TRY(read_scene(n, &scenes[n], &c->d, why));
        c->scene = &scenes[n];
        c->times = part == STATIC ? 0 : part == CREEP ? 2 : 3;
        c->time = part == CREEP ? creep_time : fall_time;
        file_of(options->folder, n, c->path);
    }
    TRY(timed_measure(options, "fall and creep", &provenance, CASES, cases, why));
out:
    for (int n = 0; n < CASES; n++)
        scene_clear(&scenes[n]);
    free(cases);
    return st;
}

/* Depth of the middle of the free edge at every time kept, [count]; NaN after a death. */
static enum status read_depth(const char *folder, int n, int count, double *depth,
                              struct message *why)
{
    struct store_read *file = NULL;
    double *xyz = malloc(3 * GRID_POINTS * sizeof *xyz);
    char path[TIMED_PATH];
    enum status st = xyz ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    file_of(folder, n, path);
    TRY(store_read_open(path, &file, why));
    for (int t = 0; t < count; t++) {
        depth[t] = NAN;
        if (t >= store_read_frames(file))
            continue;
        TRY(store_read_frame(file, t, xyz, why));
        depth[t] = -truth_plate_edge(xyz, NULL);
    }
out:
    store_read_close(file);
    free(xyz);
    return st;
}

enum status study_timestep_viscous_read(const char *folder, struct study_timestep *s,
                                        struct message *why)
{
    const double tau = fall_time[1] - fall_time[0], pause = creep_time[1] - creep_time[0];
    enum status st = STATUS_OK;

    for (int n = 0; n < CASES; n++) {
        int index;
        enum part part = part_of(n, &index);
        struct study_timestep_fall *fall = &s->fall[index % STUDY_TIMESTEP_FALLS];
        struct study_timestep_creep *creep = &s->creep[index % STUDY_TIMESTEP_CREEPS];
        double z[3];
        TRY(read_depth(folder, n, part == STATIC ? 1 : part == CREEP ? 2 : 3, z, why));
        if (part == FALL_PRINTED) {
            fall->mu = falls[index].mu;
            fall->step = falls[index].step;
            fall->acceleration = (z[2] - 2 * z[1] + z[0]) / (tau * tau);
        } else if (part == FALL_INCREMENTAL) {
            fall->speed = (z[2] - z[1]) / tau;
        } else if (part == CREEP) {
            creep->young = creeps[index].young;
            creep->step = creeps[index].step;
            creep->speed = (z[1] - z[0]) / pause;
        } else {
            creep->sag = z[0];
        }
    }
out:
    return st;
}
