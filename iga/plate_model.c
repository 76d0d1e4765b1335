#include "iga/plate_model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "iga/bspline_contact.h"
#include "iga/cloak_net.h"
#include "iga/plate_space.h"
#include "iga/support_knots.h"
#include "models/contact/contact_rest.h"
#include "models/grid.h"
#include "models/mechanics/large_leapfrog.h"
#include "models/solid/solid_hinge.h"
#include "models/solid/solid_model.h"

struct plate {
    struct solid_sheet sheet; /* first: solid_model.h                                  */
    struct plate_tables tables;
    struct patch patch;
    struct scene scene; /* the caller's, with supports of its own                owned  */
    double (*uvw)[3];   /* with weights given: parameters of the grid's points    owned  */
};

/* clang-format off */
static const struct schema_key options[] = {
    {"points"}, {"degree"}, {"gauss"}, {"knots_u"}, {"knots_v"}, {"knots_w"}, {"weights"},
    {"kinematics"}, {"unknowns"}, {"solver"}, {"preconditioner"}, {"newton"},
    {"viscosity"}, {"substeps"},
    {"remedy", .only = OPTION(REMEDY_NONE) | OPTION(REMEDY_REDUCED) |
                       OPTION(REMEDY_SELECTIVE) | OPTION(REMEDY_CLAMPED)},
    {"integrator", .only = OPTION(INTEGRATOR_IMPLICIT) | OPTION(INTEGRATOR_LEAPFROG)},
    {"contact"},
    {NULL}};
/* clang-format on */

/* Places the control points of a flat sheet. */
static void make_box(const struct scene *scene, struct patch *patch)
{
    double corner[3][3], at[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, origin[3];

    scene_rest_point(scene, (double[3]){0, 0, 0}, origin);
    for (int i = 0; i < 3; i++) {
        scene_rest_point(scene, at[i], corner[i]);
        for (int j = 0; j < 3; j++)
            corner[i][j] -= origin[j];
    }
    patch_set_box(patch, origin, corner[0], corner[1], corner[2]);
}

static void make_boxes(const struct scene *scene, const struct patch *patch)
{
    struct patch part = *patch;

    part.basis[0] = bspline_part(&patch->basis[0], 0);
    for (int k = 0; k < patch->basis[0].n / part.basis[0].n; k++) {
        const struct scene sheet = scene_sheet(scene, k);
        make_box(&sheet, &part);
        part.point += 3 * (size_t)patch_nodes(&part);
    }
}

static enum status make_cloak(const struct scene *scene, struct patch *patch,
                              struct message *why)
{
    const struct bspline *b = patch->basis;
    double *w = malloc((size_t)b[2].n * sizeof *w);
    enum status st = STATUS_MEMORY;

    patch->weight = malloc((size_t)patch_nodes(patch) * sizeof *patch->weight);
    if (!w || !patch->weight)
        goto out;
    for (int k = 0; k < b[2].n; k++)
        w[k] = bspline_greville(&b[2], k);
    st = cloak_net(scene, &b[0], &b[1], b[2].n, w, patch->point, patch->weight, why);
    if (!cloak_net_exact(&b[1]))
        free(patch->weight), patch->weight = NULL;
out:
    free(w);
    return st;
}

static enum status give_weights(const struct discretization *d, struct patch *patch,
                                struct message *why)
{
    size_t bytes = (size_t)d->weight_count * sizeof *patch->weight;

    if (d->weight_count != patch_nodes(patch))
        return status_fail(why, STATUS_INPUT,
                           "weights: %d given, but the net has %d points", d->weight_count,
                           patch_nodes(patch));
    patch->weight = malloc(bytes);
    if (!patch->weight)
        return STATUS_MEMORY;
    memcpy(patch->weight, d->weights, bytes);
    return STATUS_OK;
}

static enum status make_patch(const struct scene *scene, const struct discretization *d,
                              struct patch *patch, struct message *why)
{
    enum status st = STATUS_OK;
    struct bspline basis[3] = {{0}};

    if (scene->shape != SCENE_FLAT && d->weight_count)
        return status_fail(why, STATUS_INPUT,
                           "weights: a curved rest shape brings its own; give none");
    if (scene->sheets > 1 && d->weight_count)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "unsupported: no weights with several sheets");
    for (int i = 0; i < 2; i++)
        TRY(support_knots_basis(&basis[i], scene, d, i, SUPPORT_KNOTS_SOLID, why));
    TRY(bspline_init_direction(&basis[2], d, 2, why));
    TRY(patch_init(patch, basis));
    if (scene->shape == SCENE_CLOAK)
        TRY(make_cloak(scene, patch, why));
    else
        make_boxes(scene, patch);
    if (d->weight_count)
        TRY(give_weights(d, patch, why));
out:
    for (int i = 0; i < 3; i++)
        bspline_clear(&basis[i]);
    return st;
}

/* Evaluates the functions alive at u, v or w (i = 2); returns the first. */
static int alive(const struct plate *p, int i, double at, double *value)
{
    const struct bspline *b = &p->patch.basis[i];
    const int sheet = i ? 0 : scene_sheet_at(&p->scene, at, &at);

    if (i < 2)
        return bspline_alive(b, sheet, at, 0, value);
    plate_space_thickness(&p->patch, p->sheet.space.thickness_basis, at, value);
    return bspline_span(b, at) - b->p;
}

/* Evaluates the functions through the thickness, all of one element. */
static void layer_values(const void *context, double w, double *N)
{
    const struct plate *p = context;

    plate_space_thickness(&p->patch, p->sheet.space.thickness_basis, w, N);
}

static enum status add_loads(struct plate *p, struct message *why)
{
    struct dead_load_line line[3];
    struct bspline part[3];

    if (p->sheet.motion.scene->load_count && p->patch.weight)
        return status_fail(why, STATUS_UNSUPPORTED, "unsupported: no loads with weights");
    for (int i = 0; i < 3; i++) {
        const struct bspline *b = &part[i];
        part[i] = bspline_part(&p->patch.basis[i], 0);
        line[i] = (struct dead_load_line){b->n,        b->p,           b->n - b->p + 1,
                                          b->U + b->p, bspline_values, b};
    }
    if (p->sheet.space.thickness_basis)
        line[2].value = layer_values, line[2].context = p;
    return solid_motion_add_loads(&p->sheet.motion, line);
}

/* Replaces material points by their parameters: in a flat sheet with weights given they are
 * not the same. */
static enum status find_parameters(const struct plate *p, int count, double (*uvw)[3])
{
    const struct scene *scene = &p->scene;
    const double tolerance = 1e-12 * (scene->length + scene->width);
    enum status st = STATUS_OK;

    for (int n = 0; n < count && st == STATUS_OK; n++) {
        double x[3];
        scene_rest_point(scene, uvw[n], x);
        st = patch_invert(&p->patch, x, tolerance, uvw[n]);
    }
    return st;
}

static enum status find_grid(struct plate *p)
{
    if (!p->patch.weight || p->scene.shape != SCENE_FLAT)
        return STATUS_OK;
    p->uvw = malloc(GRID_POINTS * sizeof *p->uvw);
    if (!p->uvw)
        return STATUS_MEMORY;
    for (int n = 0; n < GRID_POINTS; n++)
        grid_point(n, p->uvw[n]);
    return find_parameters(p, GRID_POINTS, p->uvw);
}

/* Returns the present control points, or coefficients of the thickness basis. */
static const double *points_of(const struct plate *p)
{
    return solid_hinge_points(&p->sheet.space, p->sheet.motion.x);
}

/* Computes the position at one tensor-product point: sums over u, then v, then w, so that a
 * grid point comes out the same for all callers. Rational if the patch has weights; the sum
 * of the functions through the thickness is then that of all or, in the thickness basis,
 * the first. */
static void evaluate(const struct plate *p, const double *x, const int first[3],
                     const double *const N[3], double *xyz)
{
    const double *weight = p->patch.weight;
    const struct bspline *v = &p->patch.basis[1];
    int m = bspline_points(v), l = p->patch.basis[2].n;
    int orders[3] = {p->patch.basis[0].p + 1, p->patch.basis[1].p + 1,
                     p->patch.basis[2].p + 1};
    double sum[3] = {0}, total = 0;

    for (int c = 0; c < orders[2]; c++) {
        double over_v[3] = {0}, weight_v = 0;
        for (int b = 0; b < orders[1]; b++) {
            double over_u[3] = {0}, weight_u = 0;
            for (int a = 0; a < orders[0]; a++) {
                int node = ((first[0] + a) * m + bspline_point(v, first[1] + b)) * l +
                           first[2] + c;
                double share = weight ? N[0][a] * weight[node] : N[0][a];
                weight_u += share;
                for (int i = 0; i < 3; i++)
                    over_u[i] += share * x[3 * (size_t)node + i];
            }
            weight_v += N[1][b] * weight_u;
            for (int i = 0; i < 3; i++)
                over_v[i] += N[1][b] * over_u[i];
        }
        if (c == 0 || !p->sheet.space.thickness_basis)
            total += N[2][c] * weight_v;
        for (int i = 0; i < 3; i++)
            sum[i] += N[2][c] * over_v[i];
    }
    for (int i = 0; i < 3; i++)
        xyz[i] = weight ? sum[i] / total : sum[i];
}

/* Computes the position at parameters of the patch. */
static void evaluate_at(const struct plate *p, const double *x, const double uvw[3],
                        double *xyz)
{
    double N[3][BSPLINE_MAX_ORDER];
    int first[3];

    for (int i = 0; i < 3; i++)
        first[i] = alive(p, i, uvw[i], N[i]);
    evaluate(p, x, first, (const double *const[3]){N[0], N[1], N[2]}, xyz);
}

static void sample(const void *state, double *xyz)
{
    enum { LINE = GRID_U > GRID_V ? GRID_U : GRID_V };
    static const int counts[3] = {GRID_U, GRID_V, GRID_W};
    const struct plate *p = state;
    const double *x = points_of(p);
    double value[3][LINE][BSPLINE_MAX_ORDER]; /* of the lines along u, v and w */
    int first[3][LINE];

    for (int n = 0; p->uvw && n < GRID_POINTS; n++)
        evaluate_at(p, x, p->uvw[n], xyz + 3 * (size_t)n);
    if (p->uvw)
        return;
    for (int d = 0; d < 3; d++)
        for (int n = 0; n < counts[d]; n++)
            first[d][n] = alive(p, d, n / (counts[d] - 1.0), value[d][n]);
    for (int k = 0; k < GRID_W; k++)
        for (int j = 0; j < GRID_V; j++)
            for (int i = 0; i < GRID_U; i++, xyz += 3)
                evaluate(p, x, (const int[]){first[0][i], first[1][j], first[2][k]},
                         (const double *const[]){value[0][i], value[1][j], value[2][k]},
                         xyz);
}

static void clear(void *state)
{
    struct plate *p = state;

    solid_motion_clear(&p->sheet.motion);
    plate_space_clear(&p->sheet.space, &p->tables);
    patch_clear(&p->patch);
    free(p->scene.supports);
    free(p->uvw);
}

static void probe(const void *state, int n, const double *uvw, double *xyz)
{
    const struct plate *p = state;
    const double *x = points_of(p);

    for (int t = 0; t < n; t++, uvw += 3, xyz += 3) {
        double at[1][3] = {{uvw[0], uvw[1], uvw[2]}};
        if (p->uvw && find_parameters(p, 1, at))
            at[0][0] = NAN; /* cannot be: the rest shape was inverted at create */
        evaluate_at(p, x, at[0], xyz);
    }
}

/* Fabrics are for layers alone. */
enum {
    PLATE_SERVES =
        SOLID_MODEL_SERVES | SCENE_NEED_CLOSED_REST | SCENE_NEED_FABRIC | SCENE_NEED_BIAS
};

static bool has_layer(const struct discretization *d)
{
    return d->remedy == REMEDY_SELECTIVE || d->remedy == REMEDY_CLAMPED;
}

static void clamp_edges(struct plate *p, const struct scene *scene)
{
    const double length[2] = {scene->length, scene->width};
    const struct law law = scene_law(scene);

    for (int i = 0; i < 2; i++)
        for (int end = 0; end < 2; end++)
            if (scene_edge_clamped(scene, 0, i, end))
                plate_space_clamp(&p->tables, &p->patch, i, end, law.thickness / length[i],
                                  law.poisson);
}

static enum status check_remedy(const struct discretization *d, struct message *why)
{
    const char *name = option_remedy[d->remedy];

    if (d->remedy == REMEDY_NONE)
        return STATUS_OK;
    if (d->degree[0] < 2 || d->degree[1] < 2)
        return status_fail(why, STATUS_INPUT,
                           "remedy=%s needs degree 2 or more along u and v", name);
    if (d->gauss[0] || d->gauss[1] || d->gauss[2])
        return status_fail(why, STATUS_INPUT, "remedy=%s has its own rule; leave gauss out",
                           name);
    if (has_layer(d) && (d->points[2] != 2 || d->weight_count))
        return status_fail(why, d->weight_count ? STATUS_INPUT : STATUS_UNSUPPORTED,
                           "remedy=%s is for one layer of degree 1 through the thickness "
                           "without weights; use reduced",
                           name);
    return STATUS_OK;
}

static void adapt(const struct scene *scene, struct discretization *d,
                  struct message *reason)
{
    const bool paper = kinematics_rebuilds(d->kinematics);

    (void)scene;
    for (int i = 0; i < 3; i++)
        if (!d->degree[i])
            d->degree[i] = bspline_open_degree(d, i, i < 2 ? 3 - paper : 2 - paper);
    if (paper)
        status_fail(reason, STATUS_OK, "cured sheets die of kinematics=%s",
                    option_kinematics[d->kinematics]);
    if (d->remedy != REMEDY_AUTO)
        return;
    d->remedy = REMEDY_SELECTIVE;
    if (paper || check_remedy(d, reason) != STATUS_OK)
        d->remedy = REMEDY_NONE;
}

/* Adds points for knots that repeat at supports, which make no spans. */
static int extra_points(const struct scene *scene, const struct discretization *d, int i)
{
    return i > 1 || kinematics_rebuilds(d->kinematics)
               ? 0
               : support_knots_repeats(scene, i, d->degree[i], SUPPORT_KNOTS_SOLID);
}

/* Turns tensor-product functions at w = 1/2 into weights of the coefficients; returns how
 * many are not zero. */
static int middle_row(const struct plate *p, const int first[3],
                      double N[3][BSPLINE_MAX_ORDER], int *node, double *shape)
{
    const struct bspline *b = p->patch.basis;
    const double *weight = p->patch.weight;
    double sum = 0;
    int used = 0;

    for (int i = 0; i <= b[0].p; i++)
        for (int j = 0; j <= b[1].p; j++)
            for (int k = 0; k <= b[2].p; k++, used++) {
                node[used] = ((first[0] + i) * bspline_points(&b[1]) +
                              bspline_point(&b[1], first[1] + j)) *
                                 b[2].n +
                             first[2] + k;
                shape[used] = N[0][i] * N[1][j] * N[2][k];
                if (weight)
                    shape[used] *= weight[node[used]];
                if (!k || !p->sheet.space.thickness_basis)
                    sum += shape[used];
            }
    for (int n = 0; n < used; n++)
        shape[n] /= sum;
    return solid_hinge_row(&p->sheet.space, used, node, shape);
}

/* Finds the mid-surface's point in the coefficients: contact_row. */
static int row(const void *self, double u, double v, int *node, double *shape)
{
    const struct plate *p = self;
    const double uvw[3] = {u, v, 0.5};
    double N[3][BSPLINE_MAX_ORDER];
    int first[3];

    for (int i = 0; i < 3; i++)
        first[i] = alive(p, i, uvw[i], N[i]);
    return middle_row(p, first, N, node, shape);
}

/* Does so for the control net of the mid-surface. */
static int row_of_net(const void *self, double u, double v, int *node, double *shape)
{
    const struct plate *p = self;
    double N[3][BSPLINE_MAX_ORDER];
    const int first[3] = {bspline_contact_hats(&p->patch.basis[0], u, N[0]),
                          bspline_contact_hats(&p->patch.basis[1], v, N[1]),
                          alive(p, 2, 0.5, N[2])};

    return middle_row(p, first, N, node, shape);
}

static enum status meet(struct plate *p, const struct discretization *d)
{
    static contact_row *const rows[CONTACT_SAMPLES] = {row, row_of_net};
    struct contact_surface surface;
    enum status st =
        bspline_contact_surface(&p->scene, p->patch.basis, d, p, rows,
                                patch_local(&p->patch), patch_nodes(&p->patch), &surface);

    return st == STATUS_OK ? solid_motion_meet(&p->sheet.motion, &surface) : st;
}

static enum status init(void *state, const struct scene *scene,
                        const struct discretization *d, struct message *why)
{
    enum status st;
    bool thickness, one_element;
    double middle[BSPLINE_MAX_ORDER];
    struct plate *p = state;

    TRY(model_refuse(scene, PLATE_SERVES, why));
    TRY(contact_rest_refuse(scene, why));
    TRY(bspline_contact_refuse(scene, d, why));
    TRY(large_leapfrog_refuse(d, why));
    TRY(check_remedy(d, why));
    if (d->remedy == REMEDY_REDUCED && scene_closed(scene))
        TRY(status_fail(
            why, STATUS_UNSUPPORTED,
            "remedy=reduced has a rule that begins at an edge, and the sheet is "
            "closed; use selective"));
    if (!has_layer(d))
        TRY(solid_model_refuse_fabric(scene, why));
    if (d->remedy == REMEDY_CLAMPED && (scene->shape != SCENE_FLAT || scene->sheets > 1))
        TRY(status_fail(why, STATUS_UNSUPPORTED,
                        "remedy=clamped is for one flat sheet; use selective"));
    TRY(make_patch(scene, d, &p->patch, why));
    p->scene = *scene;
    TRY(support_knots_hold(scene, p->patch.basis, &p->scene.supports));
    one_element = p->patch.basis[2].n == p->patch.basis[2].p + 1 && !d->weight_count;
    TRY(solid_model_basis(scene, d, one_element, &thickness, why));
    TRY(plate_space_init(&p->sheet.space, &p->tables, &p->patch, d->gauss, thickness));
    solid_space_spread(&p->sheet.space, scene);
    if (d->remedy == REMEDY_REDUCED)
        TRY(plate_space_reduce(&p->sheet.space, &p->tables, &p->patch));
    if (has_layer(d))
        TRY(plate_space_select(&p->sheet.space, &p->tables, &p->patch));
    if (d->remedy == REMEDY_CLAMPED)
        clamp_edges(p, scene);
    TRY(find_grid(p));
    const struct bspline *b = p->patch.basis;
    plate_space_thickness(&p->patch, false, 0.5, middle);
    TRY(solid_model_init(&p->sheet, &p->scene, d,
                         (const int[]){b[0].n, bspline_points(&b[1]), b[2].n},
                         one_element ? middle : NULL, why));
    TRY(add_loads(p, why));
    if (contact_wanted(scene))
        TRY(meet(p, d));
    TRY(solid_model_misfit(&p->sheet, probe));
out:
    return st;
}

const struct model plate_model = {
    .name = "iga",
    .title = "IGA thick plate",
    .source = "Ren, Dai, Lin 2024, Journal of Image and Graphics 29(1), eq. 1-22",
    .serves = PLATE_SERVES,
    .options = options,
    /* Degree 3: at any cost below 3 % of error it is the cheaper one, and of degree 2 a
     * sheet with Gamma above 1e4 folds between its points (README, Speed against error). */
    .defaults = {.points = {10, 10, 2},
                 .degree = {3, 3, 1},
                 .kinematics = KINEMATICS_NONLINEAR,
                 .remedy = REMEDY_SELECTIVE},
    .adapt = adapt,
    .extra_points = extra_points,
    .bytes = sizeof(struct plate),
    .init = init,
    .advance = solid_motion_step,
    .sample = sample,
    .probe = probe,
    .size = solid_model_size,
    .describe = solid_model_describe,
    .energy = solid_motion_energy,
    .contact = solid_model_contact,
    .net = solid_model_net,
    .equilibrium = solid_model_equilibrium,
    .modes = solid_model_modes,
    .matrices = solid_model_matrices,
    .clear = clear,
};
