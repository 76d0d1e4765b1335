#include "bench/studies/study_contact.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/store_read.h"
#include "bench/files/store_scene.h"
#include "bench/harness/run_file.h"
#include "models/contact.h"
#include "models/grid.h"
#include "models/metric/intersection.h"
#include "models/metric/metric.h"
#include "models/reader/scene_file.h"

/* Frames between looks for crossings, which cost more than a frame; and grid points between
 * those that are looked at. */
enum { CROSSINGS_EVERY = 10, CROSSINGS_STEP = 3, QUICK_SIDE = 6, PATH = 4096 };

#define UNDAMPED "damping={kind: none}"

const struct study_contact_case study_contact_case[STUDY_CONTACT_CASES] = {
    {"IGA, printed (the paper's)", "printed", "iga_paper", 15, NULL},
    {"IGA, printed, mu = 0.5", "printed_half", "iga_paper", 15, "damping.value=0.5"},
    {"IGA, incremental, undamped", "incremental", "iga_incremental", 15, UNDAMPED},
    {"IGA, linear", "linear", "iga_linear", 15, UNDAMPED},
    {"shell, nonlinear", "shell", "shell", 10, UNDAMPED},
    {"mass-spring, matched", "mass_spring", "mass_spring", 15, UNDAMPED},
    {"projective dynamics, matched", "projective_dynamics", "projective_dynamics", 15,
     UNDAMPED},
};

static const struct {
    const char *name, *unit;
} words[STUDY_CONTACT_SERIES] = {
    {"net_gap", "m"}, {"surface_gap", "m"}, {"carried", "1"},
    {"contact", "N"}, {"crossings", "1"},   {"net_crossings", "1"},
};

struct watch {
    struct run run;
    struct motion motion;
    struct run_file *file;
    struct intersection crossings;
    double *xyz, *net; /* field; control points, or NULL if the model hands out none   */
    double *series[STUDY_CONTACT_SERIES];
    int snapshot, frames;
};

/* Crossings of the middle of an n x m x l net, or NaN. */
static double net_crossings(struct watch *w)
{
    const int *p = w->run.discretization.points;
    const int n = p[0], m = p[1], l = p[2];
    long count;

    if (!w->net)
        return NAN;
    w->run.model->net(w->run.state, w->net);
    for (int a = 0; a < n * m; a++) /* bottom and top, in place */
        for (int i = 0; i < 3; i++)
            w->net[3 * a + i] =
                (w->net[3 * a * l + i] + w->net[3 * (a * l + l - 1) + i]) / 2;
    return intersection_count(&w->crossings, m, n, w->net, &count) == STATUS_OK
               ? (double)count
               : NAN;
}

/* Takes run_file.h's look, and its own. */
static enum status look(void *context, const struct motion *m, struct message *why)
{
    struct watch *w = context;
    const struct scene *s = m->scene;
    const double *g = s->gravity;
    double row[STUDY_CONTACT_SERIES] = {0};
    bool snapshot = w->snapshot < s->snapshot_count &&
                    m->time > s->snapshots[w->snapshot] - s->step / 2;
    bool cross = snapshot || m->frames % CROSSINGS_EVERY == 0;
    struct model_contact c;

    w->snapshot += snapshot;
    m->model->sample(m->state, w->xyz);
    m->model->contact(m->state, &c);
    row[STUDY_CONTACT_NET_GAP] = c.least_gap;
    row[STUDY_CONTACT_SURFACE_GAP] = contact_least_gap(s, GRID_POINTS, w->xyz);
    row[STUDY_CONTACT_CARRIED] = c.nodes;
    for (int i = 0; i < 3; i++)
        row[STUDY_CONTACT_FORCE] -= c.force[i] * g[i];
    row[STUDY_CONTACT_FORCE] /= sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    row[STUDY_CONTACT_CROSSINGS] =
        cross ? metric_intersections_every(w->xyz, CROSSINGS_STEP) : NAN;
    row[STUDY_CONTACT_NET_CROSSINGS] = cross ? net_crossings(w) : NAN;
    for (int n = 0; n < STUDY_CONTACT_SERIES; n++)
        w->series[n][w->frames] = row[n];
    w->frames++;
    return run_file_watch(w->file, m, why);
}

static enum status make_room(struct watch *w)
{
    struct model_size size;
    bool good = true;

    w->run.model->size(w->run.state, &size);
    w->xyz = malloc(3 * GRID_POINTS * sizeof *w->xyz);
    if (w->run.model->net)
        good = (w->net = malloc(3 * (size_t)size.nodes * sizeof *w->net)) != NULL;
    for (int n = 0; n < STUDY_CONTACT_SERIES; n++)
        good &= (w->series[n] =
                     malloc((size_t)(w->motion.frame_count + 1) * sizeof(double))) != NULL;
    return w->xyz && good ? STATUS_OK : STATUS_MEMORY;
}

static void clear(struct watch *w)
{
    run_file_discard(w->file);
    motion_clear(&w->motion);
    run_close(&w->run);
    intersection_clear(&w->crossings);
    free(w->xyz);
    free(w->net);
    for (int n = 0; n < STUDY_CONTACT_SERIES; n++)
        free(w->series[n]);
}

static enum status follow(const struct run_plan *plan, const char *path,
                          struct message *why)
{
    struct watch w = {0};
    struct run_keep keep = {.file = path, .every = 1};
    struct run_file *file;
    enum status st;

    TRY(run_open(&w.run, plan, why));
    keep.times = w.run.scene.snapshot_count;
    keep.time = w.run.scene.snapshots;
    TRY(motion_init(&w.motion, w.run.model, &w.run.scene, w.run.state));
    TRY(make_room(&w));
    TRY(run_file_open(&w.run, &keep, &w.file, why));
    TRY(motion_run(&w.motion, look, &w, true, why));
    for (int n = 0; n < STUDY_CONTACT_SERIES; n++)
        TRY(run_file_series(w.file, words[n].name, words[n].unit, w.series[n], w.frames,
                            why));
    file = w.file, w.file = NULL;
    TRY(run_file_close(file, &w.motion, NULL, why));
out:
    clear(&w);
    return st;
}

static void file_of(const char *folder, int n, char path[PATH])
{
    snprintf(path, PATH, "%s/contact_%s.h5", folder, study_contact_case[n].name);
}

static enum status measure_case(int n, const struct experiment_options *options,
                                const char *scene, struct message *why)
{
    const struct study_contact_case *c = &study_contact_case[n];
    const int side = options->quick ? QUICK_SIDE : c->side;
    struct settings settings = {0};
    struct run_plan plan = {.path = scene, .settings = &settings};
    char path[PATH];
    enum status st;

    file_of(options->folder, n, path);
    TRY(contestant_find(c->contestant, &plan.contestant, why));
    contestant_points(plan.contestant, side, side, &settings);
    if (c->damping)
        settings_set(&settings, c->damping);
    TRY(follow(&plan, path, why));
out:
    settings_clear(&settings);
    return st;
}

static enum status measure(const struct experiment_options *options, struct message *why)
{
    char *scene = NULL;
    enum status st;

    TRY(scene_file_find("ground", &scene, why));
    for (int n = 0; n < STUDY_CONTACT_CASES; n++) {
        TRY(measure_case(n, options, scene, why));
        experiment_progress(options, "ground", n + 1, STUDY_CONTACT_CASES);
    }
out:
    free(scene);
    return st;
}

static enum status read_series(const struct store_read *file, struct study_contact_run *run,
                               struct message *why)
{
    enum status st;
    int columns, rows;
    char name[64];

    TRY(store_read_array(file, "time", &run->time, &run->frames, &columns, why));
    for (int n = 0; n < STUDY_CONTACT_SERIES; n++) {
        snprintf(name, sizeof name, "metrics/%s", words[n].name);
        TRY(store_read_array(file, name, &run->series[n], &rows, &columns, why));
        if (rows != run->frames)
            return status_fail(why, STATUS_INPUT, "%s: %d numbers for %d frames", name,
                               rows, run->frames);
    }
out:
    return st;
}

enum status study_contact_read(const char *folder, int n, struct study_contact_run *run,
                               struct message *why)
{
    struct store_read *file = NULL;
    struct scene scene = {0};
    char path[PATH];
    enum status st;

    memset(run, 0, sizeof *run);
    file_of(folder, n, path);
    TRY(run_result_read(path, true, &run->result, why));
    TRY(store_read_open(path, &file, why));
    TRY(store_scene(file, path, &scene, why));
    const double *g = scene.gravity;
    run->thickness = scene.thickness;
    run->weight = sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]) * scene.density *
                  scene.length * scene.width * scene.thickness;
    TRY(read_series(file, run, why));
out:
    scene_clear(&scene);
    store_read_close(file);
    return st;
}

void study_contact_clear(struct study_contact_run *run)
{
    run_result_clear(&run->result);
    free(run->time);
    for (int n = 0; n < STUDY_CONTACT_SERIES; n++)
        free(run->series[n]);
    memset(run, 0, sizeof *run);
}

const struct experiment study_contact_experiment = {
    .item = {"contact",
             "Ren et al. 2024, Fig. 9: a sheet falls onto the ground; gaps, weight, "
             "self-intersections"},
    .measure = measure,
    .print = study_contact_print,
};
