#include "bench/studies/study_orders.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/provenance.h"
#include "bench/harness/registry.h"
#include "bench/files/store.h"
#include "iga/plate_space.h"
#include "iga/refine.h"
#include "models/grid.h"
#include "models/reader/scene_file.h"
#include "models/solid/solid_model.h"

enum { SIDE = 10, QUICK_SIDE = 6, PATH = 4096 };
const double study_orders_time[STUDY_ORDERS_TIMES] = {0.05, 0.1, 0.2};

static const char *const file_name[STUDY_ORDERS] = {"refine_first", "elevate_first", "k"};
static const double LENGTH = 1, THICKNESS = 0.001;

static enum status make_base(int side, struct patch *patch, struct message *why)
{
    struct bspline basis[3] = {{0}};
    enum status st;

    TRY(bspline_init_uniform(&basis[0], 2, side, why));
    TRY(bspline_init_uniform(&basis[1], 2, side, why));
    TRY(bspline_init_uniform(&basis[2], 1, 2, why));
    TRY(patch_init(patch, basis));
    patch_set_box(patch, (double[]){0, 0, -THICKNESS / 2}, (double[]){LENGTH, 0, 0},
                  (double[]){0, LENGTH, 0}, (double[]){0, 0, THICKNESS});
out:
    for (int d = 0; d < 3; d++)
        bspline_clear(&basis[d]);
    return st;
}

/* Halves each span by a knot of this multiplicity. */
static enum status halve(struct patch *patch, int direction, int multiplicity,
                         struct message *why)
{
    const struct bspline *b = &patch->basis[direction];
    int count = 0, *span = malloc((size_t)(b->n - b->p) * sizeof *span);
    double *u = malloc((size_t)(multiplicity * (b->n - b->p)) * sizeof *u);
    enum status st = span && u ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    int spans = bspline_spans(b, span);
    for (int s = 0; s < spans; s++)
        for (int m = 0; m < multiplicity; m++)
            u[count++] = (b->U[span[s]] + b->U[span[s] + 1]) / 2;
    TRY(refine_insert(patch, direction, count, u, why));
out:
    free(span);
    free(u);
    return st;
}

enum status study_orders_patch(enum study_order_path path, int side, struct patch *patch,
                               struct patch *base, struct message *why)
{
    struct patch new = {0};
    enum status st;

    TRY(make_base(side, &new, why));
    if (base)
        TRY(patch_copy(&new, base));
    for (int d = 0; d < 2; d++) {
        if (path == STUDY_ORDERS_REFINE_FIRST)
            TRY(halve(&new, d, 1, why));
        TRY(refine_elevate(&new, d, 1, why));
        if (path != STUDY_ORDERS_REFINE_FIRST)
            TRY(halve(&new, d, path == STUDY_ORDERS_K ? 1 : 2, why));
    }
    *patch = new;
    memset(&new, 0, sizeof new);
out:
    patch_clear(&new);
    return st;
}

/* --- motion ------------------------------------------------------------------------------
 */

/* The sheet of Fig. 12-14, of the size of the patches. */
static enum status read_scene(struct scene *scene, struct message *why)
{
    static const char *const settings[] = {"sheet={length: 1, width: 1, thickness: 0.001}",
                                           "material.young=5e4", "material.density=0.7",
                                           "time.end=0.2", "snapshots=[]"};
    struct discretization unused = {0};
    char *path = NULL;
    enum status st;

    TRY(scene_file_find("edge_drop", &path, why));
    TRY(scene_file_read(path, sizeof settings / sizeof *settings, settings, scene, &unused,
                        why));
out:
    free(path);
    return st;
}

static void sample(const struct patch *rest, double *coefficients, double *xyz)
{
    struct patch now = *rest;

    now.point = coefficients;
    for (int n = 0; n < GRID_POINTS; n++) {
        double uvw[3];
        grid_point(n, uvw);
        patch_point(&now, uvw, xyz + 3 * (size_t)n, NULL);
    }
}

static enum status follow(struct solid_motion *m, const struct patch *patch,
                          struct store *store, struct message *why)
{
    struct counters counters = {0};
    double *xyz = malloc(3 * GRID_POINTS * sizeof *xyz);
    enum status st = xyz ? STATUS_OK : STATUS_MEMORY;
    int frame = 0;

    for (int t = 0; t < STUDY_ORDERS_TIMES && st == STATUS_OK; t++) {
        for (; frame < lround(study_orders_time[t] / m->scene->step) && st == STATUS_OK;
             frame++)
            st = solid_motion_step(m, &counters);
        if (status_is_death(st)) {
            store_death(store, st, frame * m->scene->step);
            st = STATUS_OK;
            break;
        }
        if (st == STATUS_OK) {
            sample(patch, m->x, xyz);
            st = store_frame(store, study_orders_time[t], xyz, NULL, &counters, why);
        }
    }
    free(xyz);
    return st;
}

/* The present patch moves, not one made anew from its knots: that its control points came
 * by another way is what is tried. */
static enum status move(const struct scene *scene, const struct model *model,
                        const struct patch *patch, const char *path, struct message *why)
{
    struct discretization d = {.kinematics = KINEMATICS_PRINTED};
    struct solid_space space = {0};
    struct plate_tables tables = {0};
    struct solid_motion m = {0};
    struct store *store = NULL;
    struct provenance provenance;
    struct model_size size;
    enum status st;

    for (int i = 0; i < 3; i++) {
        const struct bspline *b = &patch->basis[i];
        d.points[i] = b->n;
        d.degree[i] = b->p;
        d.knot_count[i] = b->n + b->p + 1;
        d.knots[i] = b->U; /* borrowed */
    }
    provenance_collect(&provenance);
    TRY(plate_space_init(&space, &tables, patch, d.gauss, false));
    TRY(solid_motion_init(&m, scene, &space, &d, NULL, why));
    TRY(store_create(path,
                     &(struct store_run){.scene = scene,
                                         .model = model,
                                         .discretization = &d,
                                         .provenance = &provenance},
                     &store, why));
    solid_motion_size(&m, &size);
    TRY(store_size(store, &size, why));
    TRY(follow(&m, patch, store, why));
    struct store *done = store;
    store = NULL;
    TRY(store_close(done, why));
out:
    store_discard(store);
    solid_motion_clear(&m);
    plate_space_clear(&space, &tables);
    return st;
}

void study_orders_file(const char *folder, enum study_order_path path, char *text, int size)
{
    snprintf(text, (size_t)size, "%s/orders_%s.h5", folder, file_name[path]);
}

enum status study_orders_measure(const struct exhibit_options *options, struct message *why)
{
    const struct model *model = NULL;
    struct scene scene = {0};
    struct patch patch = {0};
    char path[PATH];
    enum status st;

    TRY(registry_find("iga", &model, why));
    TRY(read_scene(&scene, why));
    for (enum study_order_path n = 0; n < STUDY_ORDERS; n++) {
        TRY(study_orders_patch(n, options->quick ? QUICK_SIDE : SIDE, &patch, NULL, why));
        study_orders_file(options->folder, n, path, sizeof path);
        TRY(move(&scene, model, &patch, path, why));
        patch_clear(&patch);
        exhibit_progress(options, "orders", (int)n + 1, STUDY_ORDERS);
    }
out:
    patch_clear(&patch);
    scene_clear(&scene);
    return st;
}
