#include "bench/table1.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/registry.h"
#include "bench/store.h"
#include "bench/timing.h"
#include "models/grid.h"
#include "models/scene_file.h"

const double table1_time[TABLE1_TIMES] = {0.1, 0.2, 0.3, 0.4};
const int table1_density[TABLE1_DENSITIES] = {10, 16, 24, 32, 40};
const char *const table1_part_name[TABLE1_PARTS] = {"printed", "incremental", "linear",
                                                    "static"};

/* At least nine repeats (fair timing). A solid's frame costs the same all along the motion,
 * so twenty frames a repeat do; the shell's Newton iterations are more in some frames than
 * in others, so it is timed over the whole motion. */
enum { REPEATS = 9, FRAMES = 20, QUICK_REPEATS = 3, QUICK_FRAMES = 5, WARMUP = 2 };

struct table1_variant table1_variant(int n)
{
    if (n == 0)
        return (struct table1_variant){"iga", 10, false};
    if (n == TABLE1_SHELL)
        return (struct table1_variant){"shell", 10, false};
    return (struct table1_variant){"hex", table1_density[(n - 1) % TABLE1_DENSITIES],
                                   n > TABLE1_DENSITIES};
}

void table1_path(const char *folder, enum table1_part part, int variant, char *path,
                 int size)
{
    struct table1_variant v = table1_variant(variant);

    snprintf(path, (size_t)size, "%s/%s_%s_%d%s.h5", folder, table1_part_name[part],
             v.model, v.side, v.incompatible ? "_incompatible" : "");
}

/* edge_drop as the part needs it. The velocity scaling of the paper belongs to its own
 * kinematics; the others move undamped. */
static enum status read_scene(enum table1_part part, struct scene *scene,
                              struct message *why)
{
    static const char *const settings[] = {"time.end=0.4", "snapshots=[0.1, 0.2, 0.3, 0.4]",
                                           "damping={kind: none}"};
    struct discretization unused = {0};
    char *path = NULL;
    enum status st;

    TRY(scene_file_find("edge_drop", &path, why));
    TRY(scene_file_read(path, part == TABLE1_PRINTED ? 2 : 3, settings, scene, &unused,
                        why));
    discretization_clear(&unused);
out:
    free(path);
    return st;
}

static enum status set_up(enum table1_part part, int variant, const struct model **model,
                          struct discretization *d, struct message *why)
{
    static const enum kinematics kinematics[TABLE1_PARTS] = {
        KINEMATICS_PRINTED, KINEMATICS_INCREMENTAL, KINEMATICS_LINEAR, KINEMATICS_LINEAR};
    struct table1_variant v = table1_variant(variant);
    enum status st = registry_find(v.model, model, why);

    if (st != STATUS_OK)
        return st;
    (*model)->defaults(d);
    d->points[0] = d->points[1] = v.side;
    d->kinematics = variant == TABLE1_SHELL && kinematics[part] != KINEMATICS_LINEAR
                        ? KINEMATICS_NONLINEAR
                        : kinematics[part];
    if (v.incompatible)
        d->remedy = REMEDY_INCOMPATIBLE;
    return STATUS_OK;
}

struct run {
    const struct model *model;
    const struct scene *scene; /* borrowed */
    struct discretization d;
    struct store *store;
    struct timing_case timing;
};

/* One state on its way: what is stored of it. */
static enum status keep(struct run *r, void *state, double t,
                        const struct counters *counters, double *xyz, struct message *why)
{
    struct energy energy;

    r->model->sample(state, xyz);
    r->model->energy(state, &energy);
    return store_frame(r->store, t, xyz, &energy, counters, why);
}

static enum status follow(struct run *r, enum table1_part part, double *xyz,
                          struct message *why)
{
    const struct scene *scene = r->scene;
    void *state = NULL;
    struct counters counters = {0};
    struct model_size size;
    enum status st;
    int frame = 0;

    TRY(r->model->create(scene, &r->d, &state, why));
    r->model->size(state, &size);
    TRY(store_size(r->store, &size, why));
    if (part == TABLE1_STATIC) {
        TRY(r->model->equilibrium(state, &counters, why));
        TRY(keep(r, state, 0, &counters, xyz, why));
    }
    for (int n = 0; part != TABLE1_STATIC && n < TABLE1_TIMES; n++) {
        for (; st == STATUS_OK && frame < lround(table1_time[n] / scene->step); frame++)
            st = r->model->advance(state, &counters);
        if (status_is_death(st)) {
            store_death(r->store, st, frame * scene->step);
            st = STATUS_OK;
            break;
        }
        TRY(st);
        TRY(keep(r, state, table1_time[n], &counters, xyz, why));
    }
out:
    r->model->destroy(state);
    return st;
}

struct reporter {
    const struct exhibit_options *options;
    enum table1_part part;
};

static void report(void *context, int done, int total)
{
    const struct reporter *r = context;

    exhibit_progress(r->options, table1_part_name[r->part], done, total);
}

static enum status time_part(const struct exhibit_options *options, enum table1_part part,
                             struct run *runs, struct message *why)
{
    struct timing_case cases[TABLE1_VARIANTS];
    struct reporter reporter = {options, part};
    struct timing_plan plan = {.repeats = options->quick ? QUICK_REPEATS : REPEATS,
                               .warmup = WARMUP,
                               .frames = options->quick ? QUICK_FRAMES : FRAMES,
                               .progress = report,
                               .context = &reporter};
    enum status st;

    for (int n = 0; n < TABLE1_VARIANTS; n++)
        cases[n] = (struct timing_case){
            .model = runs[n].model,
            .scene = runs[n].scene,
            .discretization = &runs[n].d,
            .frames = n == TABLE1_SHELL
                          ? (int)lround(table1_time[TABLE1_TIMES - 1] / runs[n].scene->step)
                          : 0};
    st = timing_run(&plan, TABLE1_VARIANTS, cases, why);
    for (int n = 0; n < TABLE1_VARIANTS && st == STATUS_OK; n++) {
        st = store_seconds(runs[n].store, "create", cases[n].create, plan.repeats, 0, why);
        if (st == STATUS_OK)
            st = store_seconds(runs[n].store, "advance", cases[n].advance, plan.repeats,
                               cases[n].frames, why);
    }
    for (int n = 0; n < TABLE1_VARIANTS; n++)
        timing_clear(&cases[n]);
    return st;
}

static enum status measure_part(const struct exhibit_options *options,
                                enum table1_part part, const struct provenance *provenance,
                                double *xyz, struct message *why)
{
    struct run runs[TABLE1_VARIANTS] = {{0}};
    struct scene scene = {0}, undamped = {0};
    enum status st;
    char path[4096];

    TRY(read_scene(part, &scene, why));
    TRY(read_scene(TABLE1_LINEAR, &undamped, why));
    for (int n = 0; n < TABLE1_VARIANTS; n++) {
        struct run *r = &runs[n];
        TRY(set_up(part, n, &r->model, &r->d, why));
        r->scene = n == TABLE1_SHELL ? &undamped : &scene;
        struct store_run what = {.scene = r->scene,
                                 .model = r->model,
                                 .discretization = &r->d,
                                 .provenance = provenance,
                                 .single = true};
        table1_path(options->folder, part, n, path, sizeof path);
        TRY(store_create(path, &what, &r->store, why));
        TRY(follow(r, part, xyz, why));
    }
    if (part != TABLE1_STATIC)
        TRY(time_part(options, part, runs, why));
    for (int n = 0; n < TABLE1_VARIANTS; n++) {
        struct store *store = runs[n].store;
        runs[n].store = NULL;
        TRY(store_close(store, why));
    }
out:
    for (int n = 0; n < TABLE1_VARIANTS; n++)
        store_discard(runs[n].store);
    scene_clear(&scene);
    scene_clear(&undamped);
    return st;
}

enum status table1_measure(const struct exhibit_options *options, struct message *why)
{
    enum status st = STATUS_OK;
    struct provenance provenance;
    double *xyz = malloc(3 * GRID_POINTS * sizeof *xyz);

    if (!xyz)
        return STATUS_MEMORY;
    provenance_collect(&provenance);
    for (int part = 0; part < TABLE1_PARTS; part++)
        TRY(measure_part(options, part, &provenance, xyz, why));
out:
    free(xyz);
    return st;
}

const struct exhibit table1_exhibit = {
    .item = {"1",
             "Ren et al. 2024, Table 1: IGA plate against trilinear hexahedra, at equal "
             "looks and against truth"},
    .measure = table1_measure,
    .print = table1_print,
};
