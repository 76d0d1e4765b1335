#include "bench/studies/study_contact.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/experiment/judge.h"
#include "bench/files/store_read.h"
#include "bench/files/store_scene.h"
#include "bench/harness/run_file.h"
#include "bench/studies/studies.h"
#include "models/contact.h"
#include "models/grid.h"
#include "models/metric/intersection.h"
#include "models/metric/metric.h"

/* Frames between looks for crossings, which cost more than a frame; and grid points between
 * those that are looked at. */
enum { CROSSINGS_EVERY = 10, CROSSINGS_STEP = 3, QUICK_SIDE = 6, PATH = 4096 };

#define UNDAMPED "damping={kind: none}"

const struct study_contact_case study_contact_case[STUDY_CONTACT_CASES] = {
    {"IGA, printed (the paper's)", "printed", "iga_paper", 15, NULL},
    {"IGA, printed, mu = 0.5", "printed_half", "iga_paper", 15, "damping.value=0.5"},
    {"IGA, incremental, undamped", "incremental", "iga_incremental", 15, UNDAMPED},
    {"IGA, linear", "linear", "iga_linear", 15, UNDAMPED},
    {"shell, nonlinear", STUDIES_SHELL, STUDIES_SHELL, 10, UNDAMPED},
    {"mass-spring, matched", STUDIES_SPRINGS, STUDIES_SPRINGS, 15, UNDAMPED},
    {"projective dynamics, matched", STUDIES_PROJECTIVE, STUDIES_PROJECTIVE, 15, UNDAMPED},
};

/* The paper's. */
static const double picture[STUDY_CONTACT_TIMES] = {0.1, 0.2, 0.3, 0.5, 1.0}; /* [s] */

static const struct run_own words[STUDY_CONTACT_SERIES] = {
    {"net_gap", "m"}, {"surface_gap", "m"}, {"carried", "1"},
    {"contact", "N"}, {"crossings", "1"},   {"net_crossings", "1"},
};

struct watch {
    int side, layers; /* of the net                                                    */
    int pictures;     /* so far                                                        */
    struct intersection crossings;
    double *net; /* control points; NULL at first, and if the model hands out none     */
};

/* Crossings of the middle of the net, or NaN. */
static enum status net_crossings(struct watch *w, const struct motion *m, double *crossings)
{
    const int count = w->side * w->side, l = w->layers;
    long pairs;

    *crossings = NAN;
    if (!m->model->net)
        return STATUS_OK;
    if (!w->net && !(w->net = malloc(3 * (size_t)(count * l) * sizeof *w->net)))
        return STATUS_MEMORY;
    m->model->net(m->state, w->net);
    for (int a = 0; a < count; a++) /* bottom and top, in place */
        for (int i = 0; i < 3; i++)
            w->net[3 * a + i] =
                (w->net[3 * a * l + i] + w->net[3 * (a * l + l - 1) + i]) / 2;
    if (intersection_count(&w->crossings, w->side, w->side, w->net, &pairs) == STATUS_OK)
        *crossings = (double)pairs;
    return STATUS_OK;
}

static enum status look(void *context, const struct motion *m, const double *xyz,
                        double *value)
{
    struct watch *w = context;
    const struct scene *s = m->scene;
    const double *g = s->gravity;
    const bool shown =
        w->pictures < STUDY_CONTACT_TIMES && m->time > picture[w->pictures] - s->step / 2;
    struct model_contact c;

    w->pictures += shown;
    m->model->contact(m->state, &c);
    value[STUDY_CONTACT_NET_GAP] = c.least_gap;
    value[STUDY_CONTACT_SURFACE_GAP] = contact_least_gap(s, GRID_POINTS, xyz);
    value[STUDY_CONTACT_CARRIED] = c.nodes;
    value[STUDY_CONTACT_FORCE] = 0;
    for (int i = 0; i < 3; i++)
        value[STUDY_CONTACT_FORCE] -= c.force[i] * g[i];
    value[STUDY_CONTACT_FORCE] /= sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    value[STUDY_CONTACT_CROSSINGS] = value[STUDY_CONTACT_NET_CROSSINGS] = NAN;
    if (!shown && m->frames % CROSSINGS_EVERY != 0)
        return STATUS_OK;
    value[STUDY_CONTACT_CROSSINGS] = metric_intersections_every(xyz, CROSSINGS_STEP);
    return net_crossings(w, m, &value[STUDY_CONTACT_NET_CROSSINGS]);
}

static void file_of(const char *folder, int n, char path[PATH])
{
    snprintf(path, PATH, "%s/contact_%s.h5", folder, study_contact_case[n].name);
}

static enum status measure_case(int n, const struct experiment_options *options,
                                struct message *why)
{
    const struct study_contact_case *c = &study_contact_case[n];
    struct watch w = {.side = options->quick ? QUICK_SIDE : c->side};
    struct settings settings = {0};
    struct run_plan plan = {.path = "ground", .settings = &settings};
    char path[PATH];
    enum status st;

    file_of(options->folder, n, path);
    TRY(contestant_find(c->contestant, &plan.contestant, why));
    contestant_points(plan.contestant, w.side, w.side, &settings);
    w.layers = plan.contestant->layers ? plan.contestant->layers : 1;
    if (c->damping)
        settings_set(&settings, c->damping);
    TRY(run_file_write(&plan,
                       &(struct run_keep){.file = path,
                                          .every = 1,
                                          .times = STUDY_CONTACT_TIMES,
                                          .time = picture,
                                          .own_count = STUDY_CONTACT_SERIES,
                                          .own = words,
                                          .own_look = look,
                                          .context = &w},
                       NULL, why));
out:
    intersection_clear(&w.crossings);
    free(w.net);
    settings_clear(&settings);
    return st;
}

static enum status measure(const struct experiment_options *options, struct message *why)
{
    enum status st = STATUS_OK;

    for (int n = 0; n < STUDY_CONTACT_CASES; n++) {
        TRY(measure_case(n, options, why));
        experiment_progress(options, "ground", n + 1, STUDY_CONTACT_CASES);
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
    for (int n = 0; n < STUDY_CONTACT_SERIES && !run_result_refused(&run->result); n++) {
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

static enum status print(const char *folder, enum table_format format, FILE *file,
                         struct message *why)
{
    struct study_contact_run run[STUDY_CONTACT_CASES] = {0};
    enum status st = STATUS_OK;

    for (int n = 0; n < STUDY_CONTACT_CASES; n++)
        TRY(study_contact_read(folder, n, &run[n], why));
    TRY(study_contact_tell(run, judge_marked(folder), folder, format, file, why));
out:
    for (int n = 0; n < STUDY_CONTACT_CASES; n++)
        study_contact_clear(&run[n]);
    return st;
}

const struct experiment study_contact_experiment = {
    .item = {"contact",
             "Ren et al. 2024, Fig. 9: a sheet falls onto the ground; gaps, weight, "
             "self-intersections"},
    .measure = measure,
    .print = print,
};
