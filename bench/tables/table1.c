#include "bench/tables/table1.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/registry.h"
#include "bench/experiment/timed.h"
#include "models/reader/scene_file.h"

const double table1_time[TABLE1_TIMES] = {0.1, 0.2, 0.3, 0.4};
const int table1_density[TABLE1_DENSITIES] = {10, 16, 24, 32, 40};
const char *const table1_part_name[TABLE1_PARTS] = {"printed", "incremental", "linear",
                                                    "static"};

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

/* A solid's frame costs the same all along the motion; the shell's Newton iterations are
 * more in some frames than in others, so it is timed over the whole motion. */
static int frames_timed(int variant, const struct scene *scene)
{
    return variant == TABLE1_SHELL
               ? (int)lround(table1_time[TABLE1_TIMES - 1] / scene->step)
               : 0;
}

static enum status measure_part(const struct exhibit_options *options,
                                enum table1_part part, const struct provenance *provenance,
                                struct message *why)
{
    struct timed_case cases[TABLE1_VARIANTS] = {{0}};
    struct scene scene = {0}, undamped = {0};
    enum status st;

    TRY(read_scene(part, &scene, why));
    TRY(read_scene(TABLE1_LINEAR, &undamped, why));
    for (int n = 0; n < TABLE1_VARIANTS; n++) {
        struct timed_case *c = &cases[n];
        TRY(set_up(part, n, &c->model, &c->d, why));
        c->scene = n == TABLE1_SHELL ? &undamped : &scene;
        c->times = part == TABLE1_STATIC ? 0 : TABLE1_TIMES;
        c->time = table1_time;
        c->frames = frames_timed(n, &scene);
        table1_path(options->folder, part, n, c->path, sizeof c->path);
    }
    TRY(timed_measure(options, table1_part_name[part], provenance, TABLE1_VARIANTS, cases,
                      why));
out:
    scene_clear(&scene);
    scene_clear(&undamped);
    return st;
}

enum status table1_measure(const struct exhibit_options *options, struct message *why)
{
    enum status st = STATUS_OK;
    struct provenance provenance;

    provenance_collect(&provenance);
    for (int part = 0; part < TABLE1_PARTS; part++)
        TRY(measure_part(options, part, &provenance, why));
out:
    return st;
}

const struct exhibit table1_exhibit = {
    .item = {"1",
             "Ren et al. 2024, Table 1: IGA plate against trilinear hexahedra, at equal "
             "looks and against truth"},
    .measure = table1_measure,
    .print = table1_print,
};
