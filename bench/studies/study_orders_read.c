/* study_orders_read.c - the three paths' shapes, their motions from result files, and the
 * table of both. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/store_read.h"
#include "bench/harness/run_result.h"
#include "bench/studies/study_orders.h"
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
static enum status read_side(const char *path, struct study_orders_result *r,
                             struct message *why)
{
    struct store_read *file = NULL;
    double nodes;
    enum status st;

    TRY(store_read_open(path, &file, why));
    TRY(store_read_number(file, "nodes", &nodes, why));
    r->side = (int)lround((sqrt(nodes / 2) + 4) / 3);
out:
    store_read_close(file);
    return st;
}

enum status study_orders_read(const char *folder, struct study_orders_result *r,
                              struct message *why)
{
    struct run_result run[STUDY_ORDERS] = {0};
    char path[PATH];
    enum status st = STATUS_OK;

    memset(r, 0, sizeof *r);
    for (enum study_order_path n = 0; n < STUDY_ORDERS; n++) {
        study_orders_file(folder, n, path, sizeof path);
        TRY(run_result_read(path, true, &run[n], why));
        for (int t = 0; t < STUDY_ORDERS_TIMES; t++)
            r->motion[n][t] = t < run[0].frames && t < run[n].frames
                                  ? metric_rmse(run[0].xyz[t], run[n].xyz[t]) /* L = 1 m */
                                  : NAN;
    }
    TRY(read_side(path, r, why)); /* of the last, STUDY_ORDERS_K */
    TRY(read_shapes(r, why));
out:
    for (int n = 0; n < STUDY_ORDERS; n++)
        run_result_clear(&run[n]);
    return st;
}

enum status study_orders_print(const struct study_orders_result *r,
                               enum table_format format, FILE *file)
{
    static const struct table_column columns[] = {
        {"path", NULL, TABLE_LEFT}, {"points", "a side"}, {"shape", "m"},
        {"motion 0.05 s", "L"},     {"0.1 s", "L"},       {"0.2 s", "L"}};
    static const char *const title[STUDY_ORDERS] = {"refine, then elevate",
                                                    "elevate, then refine, double knots",
                                                    "elevate, then refine, single knots"};
    char caption[128];
    struct table *t;
    enum status st;

    snprintf(
        caption, sizeof caption,
        "From %dx%dx2 of degrees (2,2,1): every span halved and p = q = 3, in either order",
        r->side, r->side);
    t = table_create(sizeof columns / sizeof *columns, columns, caption);
    for (int n = 0; n < STUDY_ORDERS; n++) {
        table_row(t);
        table_text(t, "%s", title[n]);
        table_integer(t, r->points[n]);
        table_number(t, r->shape[n], 2);
        for (int k = 0; k < STUDY_ORDERS_TIMES; k++)
            table_number(t, r->motion[n][k], 2);
    }
    table_note(t,
               "Shape: greatest distance from the shape before. Motion: RMSE / L from the "
               "first path's motion, the paper's scheme, one edge held. Knots of the first "
               "two differ by %.2g, control points by %.2g m.",
               r->knots, r->net);
    st = table_print(t, format, file);
    table_destroy(t);
    return st;
}
