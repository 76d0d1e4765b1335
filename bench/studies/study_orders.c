#include "bench/studies/study_orders.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/experiment/judge.h"
#include "bench/files/store_read.h"
#include "bench/harness/run_file.h"
#include "bench/harness/run_result.h"
#include "iga/plate_space.h"
#include "iga/refine.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "models/solid/solid_model.h"

enum { SIDE = 10, QUICK_SIDE = 6, PATH = 4096, SAMPLES = 23 };
static const double picture[STUDY_ORDERS_TIMES] = {0.05, 0.1, 0.2}; /* [s] */

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

/* --- Motion. */

/* A solid on a patch as it is, not on one made anew from its knots: that its control points
 * came by another way is what is tried. The state of a model of its own. */
struct sheet {
    struct solid_motion motion; /* first: solid_model.h                                */
    struct solid_space space;
    struct plate_tables tables;
    struct patch now; /* its points are the motion's; the rest is borrowed              */
};

static void probe(const void *state, int n, const double *uvw, double *xyz)
{
    const struct sheet *s = state;

    for (int t = 0; t < n; t++)
        patch_point(&s->now, uvw + 3 * t, xyz + 3 * t, NULL);
}

static void sample(const void *state, double *xyz)
{
    for (int n = 0; n < GRID_POINTS; n++) {
        double uvw[3];
        grid_point(n, uvw);
        probe(state, 1, uvw, xyz + 3 * (size_t)n);
    }
}

static void destroy(void *state)
{
    struct sheet *s = state;

    if (!s)
        return;
    solid_motion_clear(&s->motion);
    plate_space_clear(&s->space, &s->tables);
    free(s);
}

static enum status build(struct run *run, const struct patch *patch, struct message *why)
{
    struct sheet *s = calloc(1, sizeof *s);
    enum status st = s ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    TRY(plate_space_init(&s->space, &s->tables, patch, run->discretization.gauss, false));
    TRY(solid_motion_init(&s->motion, &run->scene, &s->space, &run->discretization, NULL,
                          why));
    s->now = *patch;
    s->now.point = s->motion.x;
    run->state = s, s = NULL;
out:
    destroy(s);
    return st;
}

/* The sheet of Fig. 12-14, of the size of the patches. */
static void add_settings(const struct patch *patch, struct settings *s)
{
    static const char *const fixed[] = {"sheet={length: 1, width: 1, thickness: 0.001}",
                                        "material.young=5e4", "material.density=0.7",
                                        "time.end=0.2", "snapshots=[]"},
                             *const key[] = {"discretization.knots_u",
                                             "discretization.knots_v",
                                             "discretization.knots_w"};
    const struct bspline *b = patch->basis;

    settings_list(s, sizeof fixed / sizeof *fixed, fixed);
    settings_integers(s, "discretization.degree", 3, (int[]){b[0].p, b[1].p, b[2].p});
    settings_integers(s, "discretization.points", 3, (int[]){b[0].n, b[1].n, b[2].n});
    for (int i = 0; i < 3; i++)
        settings_numbers(s, key[i], b[i].n + b[i].p + 1, b[i].U);
}

static enum status move(const struct run_plan *plan, const struct patch *patch,
                        const char *path, struct message *why)
{
    const struct run_keep keep = {
        .file = path, .times = STUDY_ORDERS_TIMES, .time = picture, .doubles = true};
    struct run run = {0};
    struct motion m = {0};
    struct run_file *file = NULL, *done;
    struct model moved;
    enum status st;

    TRY(run_read(&run, plan, why));
    moved = (struct model){.name = run.model->name,
                           .title = run.model->title,
                           .source = run.model->source,
                           .advance = solid_model_advance,
                           .sample = sample,
                           .probe = probe,
                           .size = solid_model_size,
                           .destroy = destroy};
    run.model = &moved;
    TRY(build(&run, patch, why));
    TRY(motion_init(&m, run.model, &run.scene, run.state));
    TRY(run_file_open(&run, &keep, &file, why));
    TRY(motion_run(&m, run_file_watch, file, true, why));
    done = file, file = NULL;
    TRY(run_file_close(done, &m, NULL, why));
out:
    run_file_discard(file);
    motion_clear(&m);
    run_close(&run);
    return st;
}

static void file_of(const char *folder, enum study_order_path n, char path[PATH])
{
    snprintf(path, PATH, "%s/orders_%s.h5", folder, file_name[n]);
}

enum status study_orders_measure(const struct experiment_options *options,
                                 struct message *why)
{
    struct settings settings = {0};
    struct run_plan plan = {.path = "edge_drop", .settings = &settings};
    struct patch patch = {0};
    char path[PATH];
    enum status st;

    TRY(contestant_find("iga_paper", &plan.contestant, why));
    for (enum study_order_path n = 0; n < STUDY_ORDERS; n++) {
        TRY(study_orders_patch(n, options->quick ? QUICK_SIDE : SIDE, &patch, NULL, why));
        file_of(options->folder, n, path);
        add_settings(&patch, &settings);
        TRY(move(&plan, &patch, path, why));
        patch_clear(&patch);
        settings_clear(&settings);
        experiment_progress(options, "orders", (int)n + 1, STUDY_ORDERS);
    }
out:
    patch_clear(&patch);
    settings_clear(&settings);
    return st;
}

/* --- What came of it. */

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
        file_of(folder, n, path);
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

/* Equal knots give equal spaces and then motions equal to round-off, which the steps of a
 * thin solid magnify: at most a millionth of what another space makes, at every time. */
static void tell(const struct study_orders_result *r, FILE *file)
{
    const double *same = r->motion[STUDY_ORDERS_ELEVATE_FIRST],
                 *k = r->motion[STUDY_ORDERS_K];
    enum judge turn = r->knots == 0 ? JUDGE_HOLDS : JUDGE_FAILS;

    for (int t = 0; t < STUDY_ORDERS_TIMES; t++)
        turn = judge_both(turn, judge_below(same[t], 1e-6 * k[t]));
    judge_print(
        file,
        "the mixed operations in either order give the same knots, so the same motion",
        r->side == SIDE ? turn : JUDGE_QUICK,
        "When the second order is made to give the first one's knots: they differ by %.2g, "
        "control points by %.2g m, motions by %.2g, %.2g, %.2g L. Not of itself: degree "
        "elevation doubles the knots that are there, and a new knot inserted after it is "
        "single: %d points a side instead of %d, and motions that differ by %.2g, %.2g, "
        "%.2g L. The paper makes its nets anew at each density and degree, with uniform "
        "knots, and so has no order of operations.",
        r->knots, r->net, same[0], same[1], same[2], r->points[STUDY_ORDERS_K],
        r->points[STUDY_ORDERS_REFINE_FIRST], k[0], k[1], k[2]);
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
    st = table_finish(t, format, file);
    if (st == STATUS_OK && table_format_is_prose(format))
        tell(r, file);
    return st;
}
