#include "bench/studies/study_contact.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/motion.h"
#include "bench/files/store.h"
#include "bench/files/store_read.h"
#include "bench/files/store_scene.h"
#include "bench/harness/trial.h"
#include "models/contact.h"
#include "models/grid.h"
#include "models/metric/intersection.h"
#include "models/metric/metric.h"
#include "models/reader/scene_file.h"

/* Frames between looks for crossings, which cost more than a frame; and grid points between
 * those that are looked at. */
enum { CROSSINGS_EVERY = 10, CROSSINGS_STEP = 3, PATH = 4096 };

#define UNDAMPED "damping={kind: none}"

const struct study_contact_case study_contact_case[STUDY_CONTACT_CASES] = {
    {"IGA, printed (the paper's)", "printed", "iga", "printed", "[15,15,2]", NULL},
    {"IGA, printed, mu = 0.5", "printed_half", "iga", "printed", "[15,15,2]",
     "damping.value=0.5"},
    {"IGA, incremental, undamped", "incremental", "iga", "incremental", "[15,15,2]",
     UNDAMPED},
    {"IGA, linear", "linear", "iga", "linear", "[15,15,2]", UNDAMPED},
    {"shell, nonlinear", "shell", "shell", "nonlinear", "[10,10]", UNDAMPED},
    {"mass-spring, matched", "mass_spring", "mass_spring", "nonlinear", "[15,15,1]",
     UNDAMPED},
    {"projective dynamics, matched", "projective_dynamics", "projective_dynamics",
     "nonlinear", "[15,15,1]", UNDAMPED},
};

static const struct {
    const char *name, *unit;
} words[STUDY_CONTACT_SERIES] = {
    {"net_gap", "m"}, {"surface_gap", "m"}, {"carried", "1"},
    {"contact", "N"}, {"crossings", "1"},   {"net_crossings", "1"},
};

struct watch {
    struct trial trial;
    struct store *store;
    struct intersection crossings;
    double *xyz, *net; /* field; control points, or NULL if the model hands out none   */
    double *series[STUDY_CONTACT_SERIES];
    int snapshot, frames;
};

/* Crossings of the middle of an n x m x l net, or NaN. */
static double net_crossings(struct watch *w)
{
    const int *p = w->trial.discretization.points;
    const int n = p[0], m = p[1], l = p[2];
    long count;

    if (!w->net)
        return NAN;
    w->trial.model->net(w->trial.state, w->net);
    for (int a = 0; a < n * m; a++) /* bottom and top, in place */
        for (int i = 0; i < 3; i++)
            w->net[3 * a + i] =
                (w->net[3 * a * l + i] + w->net[3 * (a * l + l - 1) + i]) / 2;
    return intersection_count(&w->crossings, m, n, w->net, &count) == STATUS_OK
               ? (double)count
               : NAN;
}

static enum status look(void *context, const struct motion *m, struct message *why)
{
    struct watch *w = context;
    const struct scene *s = m->scene;
    double *row[STUDY_CONTACT_SERIES], size = 0;
    bool snapshot = w->snapshot < s->snapshot_count &&
                    m->time > s->snapshots[w->snapshot] - s->step / 2;
    bool cross = snapshot || m->frames % CROSSINGS_EVERY == 0;
    struct model_contact c;
    struct energy energy = {NAN, NAN, NAN};

    for (int n = 0; n < STUDY_CONTACT_SERIES; n++)
        row[n] = &w->series[n][w->frames];
    w->snapshot += snapshot;
    w->frames++;
    m->model->sample(m->state, w->xyz);
    m->model->contact(m->state, &c);
    if (m->model->energy)
        m->model->energy(m->state, &energy);
    *row[STUDY_CONTACT_NET_GAP] = c.least_gap;
    *row[STUDY_CONTACT_SURFACE_GAP] = contact_least_gap(s, GRID_POINTS, w->xyz);
    *row[STUDY_CONTACT_CARRIED] = c.nodes;
    *row[STUDY_CONTACT_FORCE] = 0;
    for (int i = 0; i < 3; i++) {
        *row[STUDY_CONTACT_FORCE] -= c.force[i] * s->gravity[i];
        size += s->gravity[i] * s->gravity[i];
    }
    *row[STUDY_CONTACT_FORCE] /= sqrt(size);
    *row[STUDY_CONTACT_CROSSINGS] =
        cross ? metric_intersections_every(w->xyz, CROSSINGS_STEP) : NAN;
    *row[STUDY_CONTACT_NET_CROSSINGS] = cross ? net_crossings(w) : NAN;
    return store_frame(w->store, m->time, snapshot ? w->xyz : NULL, &energy, &m->counters,
                       why);
}

static enum status make_room(struct watch *w, int frames)
{
    struct model_size size;
    bool good = true;

    w->trial.model->size(w->trial.state, &size);
    w->xyz = malloc(3 * GRID_POINTS * sizeof *w->xyz);
    if (w->trial.model->net)
        good = (w->net = malloc(3 * (size_t)size.nodes * sizeof *w->net)) != NULL;
    for (int n = 0; n < STUDY_CONTACT_SERIES; n++)
        good &= (w->series[n] = malloc((size_t)(frames + 1) * sizeof(double))) != NULL;
    return w->xyz && good ? STATUS_OK : STATUS_MEMORY;
}

static enum status keep(struct watch *w, const struct motion *m, struct message *why)
{
    enum status st;
    struct model_size size;

    w->trial.model->size(w->trial.state, &size);
    TRY(store_size(w->store, &size, why));
    for (int n = 0; n < STUDY_CONTACT_SERIES; n++)
        TRY(store_metric(w->store, words[n].name, words[n].unit, w->series[n], w->frames,
                         why));
    TRY(store_seconds(w->store, "advance", m->seconds, 1, m->steps, why));
    if (m->death)
        store_death(w->store, m->death, m->death_time);
out:
    return st;
}

static enum status run(struct watch *w, const char *path, struct message *why)
{
    struct provenance provenance;
    struct motion m = {0};
    enum status st;

    provenance_collect(&provenance);
    TRY(motion_init(&m, w->trial.model, &w->trial.scene, w->trial.state));
    TRY(make_room(w, m.frame_count));
    TRY(store_create(path,
                     &(struct store_run){.scene = &w->trial.scene,
                                         .model = w->trial.model,
                                         .discretization = &w->trial.discretization,
                                         .provenance = &provenance,
                                         .single = true},
                     &w->store, why));
    TRY(motion_run(&m, look, w, true, why));
    TRY(keep(w, &m, why));
    st = store_close(w->store, why);
    w->store = NULL;
out:
    store_discard(w->store);
    motion_clear(&m);
    return st;
}

static void clear(struct watch *w)
{
    trial_close(&w->trial);
    intersection_clear(&w->crossings);
    free(w->xyz);
    free(w->net);
    for (int n = 0; n < STUDY_CONTACT_SERIES; n++)
        free(w->series[n]);
}

static enum status measure_case(const struct study_contact_case *c,
                                const struct exhibit_options *options, struct message *why)
{
    struct watch w = {0};
    char path[PATH], points[64], kinematics[64], *scene = NULL;
    const char *settings[5] = {points, kinematics};
    int count = 2;
    enum status st;

    snprintf(path, sizeof path, "%s/contact_%s.h5", options->folder, c->name);
    snprintf(points, sizeof points, "discretization.points=%s",
             options->quick ? (!strcmp(c->model, "iga") ? "[6,6,2]" : "[6,6,1]")
                            : c->points);
    snprintf(kinematics, sizeof kinematics, "discretization.kinematics=%s", c->kinematics);
    if (c->damping)
        settings[count++] = c->damping;
    TRY(scene_file_find("ground", &scene, why));
    TRY(trial_open(&w.trial, scene, count, settings, c->model, why));
    TRY(run(&w, path, why));
out:
    free(scene);
    clear(&w);
    return st;
}

static enum status measure(const struct exhibit_options *options, struct message *why)
{
    enum status st = STATUS_OK;

    for (int n = 0; n < STUDY_CONTACT_CASES; n++) {
        TRY(measure_case(&study_contact_case[n], options, why));
        exhibit_progress(options, "ground", n + 1, STUDY_CONTACT_CASES);
    }
out:
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

static enum status read_fields(const struct store_read *file, struct study_contact_run *run,
                               struct message *why)
{
    enum status st;
    int rows, columns;
    double *at = NULL;

    TRY(store_read_array(file, "xyz_time", &at, &rows, &columns, why));
    for (int n = 0; n < rows && n < STUDY_CONTACT_TIMES; n++) {
        run->at[n] = at[n];
        run->xyz[n] = malloc(3 * GRID_POINTS * sizeof(double));
        TRY(run->xyz[n] ? STATUS_OK : STATUS_MEMORY);
        TRY(store_read_frame(file, n, run->xyz[n], why));
    }
out:
    free(at);
    return st;
}

enum status study_contact_read(const char *folder, int n, struct study_contact_run *run,
                               struct message *why)
{
    struct store_read *file = NULL;
    struct scene scene = {0};
    char path[PATH], *outcome = NULL;
    enum status st;

    memset(run, 0, sizeof *run);
    snprintf(path, sizeof path, "%s/contact_%s.h5", folder, study_contact_case[n].name);
    TRY(store_read_open(path, &file, why));
    TRY(store_read_text(file, "/", "outcome", &outcome, why));
    snprintf(run->outcome, sizeof run->outcome, "%s", outcome);
    TRY(store_scene(file, path, &scene, why));
    const double *g = scene.gravity;
    run->thickness = scene.thickness;
    run->weight = sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]) * scene.density *
                  scene.length * scene.width * scene.thickness;
    TRY(read_series(file, run, why));
    TRY(read_fields(file, run, why));
out:
    free(outcome);
    scene_clear(&scene);
    store_read_close(file);
    return st;
}

void study_contact_clear(struct study_contact_run *run)
{
    free(run->time);
    for (int n = 0; n < STUDY_CONTACT_SERIES; n++)
        free(run->series[n]);
    for (int n = 0; n < STUDY_CONTACT_TIMES; n++)
        free(run->xyz[n]);
    memset(run, 0, sizeof *run);
}

const struct exhibit study_contact_exhibit = {
    .item = {"contact",
             "Ren et al. 2024, Fig. 9: a sheet falls onto the ground; gaps, weight, "
             "self-intersections"},
    .measure = measure,
    .print = study_contact_print,
};
