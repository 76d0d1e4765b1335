/* study_orders_read.c - the three paths' shapes, and their motions from result files. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/store_read.h"
#include "bench/studies/study_orders.h"
#include "models/grid.h"
#include "models/metric/metric.h"

enum { PATH = 4096, SAMPLES = 23 };

/* Greatest distance [m] between the shapes, at points that are no knots. */
static double shape_change(const struct patch *a, const struct patch *b)
{
    double most = 0;

    for (int n = 0; n < SAMPLES * SAMPLES * 2; n++) {
        const double uvw[3] = {(n % SAMPLES) / (SAMPLES - 1.),
                               (n / SAMPLES % SAMPLES) / (SAMPLES - 1.),
                               n / (SAMPLES * SAMPLES)};
        double x[3], y[3], square = 0;
        patch_point(a, uvw, x, NULL);
        patch_point(b, uvw, y, NULL);
        for (int d = 0; d < 3; d++)
            square += (x[d] - y[d]) * (x[d] - y[d]);
        most = fmax(most, sqrt(square));
    }
    return most;
}

static double largest_difference(int count, const double *a, const double *b)
{
    double most = 0;

    for (int n = 0; n < count; n++)
        most = fmax(most, fabs(a[n] - b[n]));
    return most;
}

static void compare_nets(const struct patch *a, const struct patch *b,
                         struct study_orders_result *r)
{
    r->knots = r->net = NAN;
    if (a->basis[0].n != b->basis[0].n || a->basis[1].n != b->basis[1].n)
        return;
    r->knots = 0;
    for (int d = 0; d < 2; d++)
        r->knots = fmax(r->knots, largest_difference(a->basis[d].n + a->basis[d].p + 1,
                                                     a->basis[d].U, b->basis[d].U));
    r->net = largest_difference(3 * patch_nodes(a), a->point, b->point);
}

static enum status read_shapes(struct study_orders_result *r, struct message *why)
{
    struct patch patch[STUDY_ORDERS] = {{{{0}}}}, base = {{{0}}};
    enum status st = STATUS_OK;

    for (enum study_order_path n = 0; n < STUDY_ORDERS; n++) {
        TRY(study_orders_patch(n, r->side, &patch[n], &base, why));
        r->shape[n] = shape_change(&patch[n], &base);
        r->points[n] = patch[n].basis[0].n;
        patch_clear(&base);
    }
    compare_nets(&patch[STUDY_ORDERS_REFINE_FIRST], &patch[STUDY_ORDERS_ELEVATE_FIRST], r);
out:
    patch_clear(&base);
    for (int n = 0; n < STUDY_ORDERS; n++)
        patch_clear(&patch[n]);
    return st;
}

/* The net that all start from: k-refinement of n points of degree 2 has 4 + 2 (n - 3) of
 * the old knots and n - 2 new ones. */
static enum status read_side(struct store_read *file, struct study_orders_result *r,
                             struct message *why)
{
    double nodes;
    enum status st = store_read_number(file, "nodes", &nodes, why);

    if (st == STATUS_OK)
        r->side = (int)lround((sqrt(nodes / 2) + 4) / 3);
    return st;
}

static enum status read_motions(struct store_read *const file[STUDY_ORDERS],
                                struct study_orders_result *r, struct message *why)
{
    double *first = malloc(3 * GRID_POINTS * sizeof *first);
    double *other = malloc(3 * GRID_POINTS * sizeof *other);
    enum status st = first && other ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    for (int n = 0; n < STUDY_ORDERS; n++)
        for (int t = 0; t < STUDY_ORDERS_TIMES; t++) {
            r->motion[n][t] = NAN;
            if (t >= store_read_frames(file[0]) || t >= store_read_frames(file[n]))
                continue;
            TRY(store_read_frame(file[0], t, first, why));
            TRY(store_read_frame(file[n], t, other, why));
            r->motion[n][t] = metric_rmse(first, other); /* L = 1 m */
        }
out:
    free(first);
    free(other);
    return st;
}

enum status study_orders_read(const char *folder, struct study_orders_result *r,
                              struct message *why)
{
    struct store_read *file[STUDY_ORDERS] = {NULL};
    char path[PATH];
    enum status st = STATUS_OK;

    memset(r, 0, sizeof *r);
    for (enum study_order_path n = 0; n < STUDY_ORDERS; n++) {
        study_orders_file(folder, n, path, sizeof path);
        TRY(store_read_open(path, &file[n], why));
    }
    TRY(read_side(file[STUDY_ORDERS_K], r, why));
    TRY(read_shapes(r, why));
    TRY(read_motions(file, r, why));
out:
    for (int n = 0; n < STUDY_ORDERS; n++)
        store_read_close(file[n]);
    return st;
}
