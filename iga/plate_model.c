#include "iga/plate_model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "iga/bspline_contact.h"
#include "iga/cloak_net.h"
#include "iga/reduced_rule.h"
#include "iga/support_knots.h"
#include "models/contact/contact_rest.h"
#include "models/grid.h"
#include "models/supports.h"
#include "models/room.h"
#include "models/solid/solid_hinge.h"
#include "models/solid/solid_model.h"

/* Computes shifted Legendre polynomials P_k(2 w - 1), k = 0..degree, and derivatives or
 * NULL. */
static void plate_legendre(int degree, double w, double *value, double *derivative)
{
    double x = 2 * w - 1, p[BSPLINE_MAX_ORDER], d[BSPLINE_MAX_ORDER];

    p[0] = 1, d[0] = 0;
    p[1] = x, d[1] = 1;
    for (int k = 1; k < degree; k++) { /* Bonnet's recurrence */
        p[k + 1] = ((2 * k + 1) * x * p[k] - k * p[k - 1]) / (k + 1);
        d[k + 1] = d[k - 1] + (2 * k + 1) * p[k];
    }
    for (int k = 0; k <= degree; k++) {
        value[k] = p[k];
        if (derivative)
            derivative[k] = 2 * d[k];
    }
}

/* Computes values at w of the functions through the thickness in use, N[order]. */
static void plate_thickness(const struct patch *patch, bool thickness, double w, double *N)
{
    const struct bspline *b = &patch->basis[2];

    if (thickness)
        plate_legendre(b->p, w, N, NULL);
    else
        bspline_eval(b, bspline_span(b, w), w, 0, N);
}

static void legendre(const struct bspline *b, int span, double w, int order, double *out)
{
    (void)span;
    plate_legendre(b->p, w, out, order ? out + b->p + 1 : NULL);
}

/* Returns values, followed by slopes, at point q of span e. */
static const double *values(const struct line_table *t, int e, int q)
{
    return t->value + (size_t)(e * t->most + q) * 2 * (size_t)t->order;
}

/* Computes R_a = w_a N_a / W and its gradient at one Gauss point, in place. In the
 * thickness basis, weights are equal through a column and its first function, 1, represents
 * the sum of all. */
static void make_rational(const struct solid_space *space, int element, double *N,
                          double *G, int row)
{
    const struct plate_tables *t = space->tables;
    const int *node = space->ien + (size_t)element * (size_t)space->local;
    int column = space->thickness_basis ? t->direction[2].order : 1;
    double W[4] = {0};

    for (int a = 0; a < space->local; a++) {
        double w = t->point_weight[node[a]], counts = a % column == 0;
        W[0] += counts * (N[a] *= w);
        for (int i = 0; i < 3; i++)
            W[i + 1] += counts * (G[i * row + a] *= w);
    }
    for (int a = 0; a < space->local; a++) {
        N[a] /= W[0];
        for (int i = 0; i < 3; i++)
            G[i * row + a] = (G[i * row + a] - N[a] * W[i + 1]) / W[0];
    }
}

/* Computes N_v N_w, N_v' N_w and N_v N_w' at a point of v and one of w. */
static void multiply(const struct line_table *v, const double *V,
                     const struct line_table *w, const double *W,
                     double vw[3][BSPLINE_MAX_ORDER * BSPLINE_MAX_ORDER])
{
    const double *dV = V + v->order, *dW = W + w->order;

    for (int b = 0, n = 0; b < v->order; b++)
        for (int c = 0; c < w->order; c++, n++) {
            vw[0][n] = V[b] * W[c];
            vw[1][n] = dV[b] * W[c];
            vw[2][n] = V[b] * dW[c];
        }
}

static void functions(const struct solid_space *space, int element,
                      struct solid_functions *out)
{
    const struct plate_tables *t = space->tables;
    const struct line_table *u = &t->direction[0], *v = &t->direction[1],
                            *w = &t->direction[2];
    const int eu = element / (v->spans * w->spans), ev = element / w->spans % v->spans,
              ew = element % w->spans, across = v->most * w->most;
    const int count = v->order * w->order, row = SOLID_PADDED(space->local);
    double vw[3][BSPLINE_MAX_ORDER * BSPLINE_MAX_ORDER];

    for (int s = 0; s < across; s++) {
        const int qv = s / w->most, qw = s % w->most;
        multiply(v, values(v, ev, qv), w, values(w, ew, qw), vw);
        for (int q = 0; q < u->most; q++) {
            const double *Nu = values(u, eu, q), *dNu = Nu + u->order;
            const int point = q * across + s;
            double *N = out->N + point * row, *G = out->G + 3 * point * row;
            for (int a = 0; a < u->order; a++)
                for (int n = 0; n < count; n++) {
                    N[a * count + n] = Nu[a] * vw[0][n];
                    G[a * count + n] = dNu[a] * vw[0][n];
                    G[row + a * count + n] = Nu[a] * vw[1][n];
                    G[2 * row + a * count + n] = Nu[a] * vw[2][n];
                }
            out->weight[point] =
                u->weight[eu * u->most + q] *
                (v->weight[ev * v->most + qv] * w->weight[ew * w->most + qw]);
            if (t->point_weight)
                make_rational(space, element, N, G, row);
        }
    }
}

static struct solid_line line(const struct solid_space *space, int element, int i)
{
    const struct plate_tables *t = space->tables;
    const struct line_table *d = t->direction;
    const int e = i == 0   ? element / (d[1].spans * d[2].spans)
                  : i == 1 ? element / d[2].spans % d[1].spans
                           : element % d[2].spans;

    return (struct solid_line){d[i].most, d[i].order, values(&d[i], e, 0),
                               d[i].weight + e * d[i].most};
}

static void number_elements(struct solid_space *space, const struct plate_tables *t,
                            const struct patch *patch)
{
    const struct line_table *d = t->direction;
    int m = bspline_points(&patch->basis[1]), l = patch->basis[2].n, *node = space->ien;

    for (int eu = 0; eu < d[0].spans; eu++)
        for (int ev = 0; ev < d[1].spans; ev++)
            for (int ew = 0; ew < d[2].spans; ew++)
                for (int a = 0; a < d[0].order; a++)
                    for (int b = 0; b < d[1].order; b++)
                        for (int c = 0; c < d[2].order; c++)
                            *node++ = (d[0].node[eu * d[0].order + a] * m +
                                       d[1].node[ev * d[1].order + b]) *
                                          l +
                                      d[2].node[ew * d[2].order + c];
}

/* Computes Legendre coefficients of a column of control points: c_k = (2k+1) int V P_k
 * dw. V counts from the first point, so that a column along an axis has exact zeros
 * across it: round-off there, divided by a small thickness, would couple membrane and
 * bending motion. */
static void column_coefficients(const struct bspline *b, const double *point, double *out)
{
    double x[GAUSS_MAX], w[GAUSS_MAX], N[BSPLINE_MAX_ORDER], P[BSPLINE_MAX_ORDER];

    memset(out, 0, 3 * (size_t)b->n * sizeof *out);
    gauss_rule(b->n, x, w);
    for (int q = 0; q < b->n; q++) {
        bspline_eval(b, b->p, x[q], 0, N);
        plate_legendre(b->p, x[q], P, NULL);
        for (int i = 0; i < 3; i++) {
            double V = 0;
            for (int c = 0; c < b->n; c++)
                V += N[c] * (point[3 * c + i] - point[i]);
            for (int k = 0; k < b->n; k++)
                out[3 * k + i] += (2 * k + 1) * w[q] * P[k] * V;
        }
    }
    for (int i = 0; i < 3; i++)
        out[i] += point[i];
}

static void place_nodes(struct solid_space *space, const struct patch *patch)
{
    const struct bspline *b = patch->basis;
    const int rows = bspline_part(&b[0], 0).n;
    int l = b[2].n, node = 0;

    memcpy(space->rest, patch->point, 3 * (size_t)space->nodes * sizeof *space->rest);
    for (int i = 0; i < b[0].n; i++)
        for (int j = 0; j < bspline_points(&b[1]); j++)
            for (int k = 0; k < l; k++, node++) {
                space->uvw[node][0] = bspline_greville(&b[0], i % rows);
                space->uvw[node][1] = bspline_greville(&b[1], j);
                space->uvw[node][2] = !space->thickness_basis ? bspline_greville(&b[2], k)
                                      : k == 0                ? SUPPORTS_MIDDLE
                                                              : SUPPORTS_DIFFERENCE;
            }
    for (int a = 0; space->thickness_basis && a < space->nodes; a += l)
        column_coefficients(&b[2], patch->point + 3 * (size_t)a,
                            space->rest + 3 * (size_t)a);
}

void plate_model_clear(struct solid_space *space, struct plate_tables *tables)
{
    solid_space_clear(space);
    if (!tables)
        return;
    for (int i = 0; i < 3; i++)
        line_rule_table_clear(&tables->direction[i]);
    for (int l = 0; l < PLATE_LINES; l++)
        for (int i = 0; i < 2; i++)
            line_rule_table_clear(&tables->cure[l][i]);
    memset(tables, 0, sizeof *tables);
}

enum status plate_model_space(struct solid_space *space, struct plate_tables *tables,
                              const struct patch *patch, const int gauss[3], bool thickness)
{
    enum status st = STATUS_OK;
    struct plate_tables t = {.point_weight = patch->weight};
    const struct line_table *d = t.direction;
    struct solid_space new = {.nodes = patch_nodes(patch), .local = patch_local(patch)};

    for (int i = 0; i < 3; i++) {
        const struct bspline *b = &patch->basis[i];
        struct line_rule rule;
        st = line_rule_gauss(&rule, b, gauss[i] ? gauss[i] : b->p + 1);
        TRY(line_rule_table(&t.direction[i], b, st, &rule, 2,
                            thickness && i == 2 ? legendre : bspline_eval));
    }
    new.elements = d[0].spans *d[1].spans *d[2].spans;
    new.gauss = d[0].most *d[1].most *d[2].most;
    new.thickness_basis = thickness;
    new.functions = functions;
    new.line = patch->weight ? NULL : line;
    new.tables = tables;
    TRY(solid_space_allocate(&new, d[1].spans * d[2].spans, patch->basis[0].p));
    number_elements(&new, &t, patch);
    place_nodes(&new, patch);
    *space = new, *tables = t;
    return STATUS_OK;
out:
    plate_model_clear(&new, &t);
    return st;
}

/* --- Cures. */

static enum status make_line(struct plate_tables *tables, const struct bspline *b, int l,
                             int i)
{
    struct line_rule rule;
    const bool derived = l == PLATE_DERIVED && b->p > 3;
    enum status st = l == PLATE_BENDING  ? line_rule_bending(&rule, b)
                     : l == PLATE_VALUES ? line_rule_greville(&rule, b, false)
                     : derived           ? reduced_rule_derived(&rule, b)
                                         : reduced_rule_init(&rule, b, l != PLATE_ACROSS);

    return line_rule_table(&tables->cure[l][i], b, st, &rule, 2, bspline_eval);
}

/* Computes values and gradients of the functions of a surface at one point: N, N_u, N_v,
 * [3][order u * order v]. */
static void surface_point(const struct solid_space *space, int element,
                          const struct line_table *u, const double *Nu,
                          const struct line_table *v, const double *Nv, double *N)
{
    const struct plate_tables *t = space->tables;
    const double *dNu = Nu + u->order, *dNv = Nv + v->order;
    const int *node = space->ien + (size_t)element * (size_t)space->local;
    int count = u->order * v->order, n = 0;
    double W[3] = {0};

    for (int a = 0; a < u->order; a++)
        for (int b = 0; b < v->order; b++, n++) {
            double w = t->point_weight ? t->point_weight[node[2 * n]] : 1;
            W[0] += N[n] = w * Nu[a] * Nv[b];
            W[1] += N[count + n] = w * dNu[a] * Nv[b];
            W[2] += N[2 * count + n] = w * Nu[a] * dNv[b];
        }
    for (n = 0; t->point_weight && n < count; n++) {
        N[n] /= W[0];
        N[count + n] = (N[count + n] - N[n] * W[1]) / W[0];
        N[2 * count + n] = (N[2 * count + n] - N[n] * W[2]) / W[0];
    }
}

/* The lines of points along u and v of each kind of strain. */
static const int lines[SOLID_KINDS][2] = {
    [SOLID_ALONG_U] = {PLATE_DERIVED, PLATE_VALUES},
    [SOLID_ALONG_V] = {PLATE_VALUES, PLATE_DERIVED},
    [SOLID_PLANE] = {PLATE_DERIVED, PLATE_DERIVED},
    [SOLID_ACROSS] = {PLATE_ACROSS, PLATE_ACROSS},
    [SOLID_BENDING] = {PLATE_BENDING, PLATE_BENDING},
};

static int layer_functions(const struct solid_space *space, int element,
                           enum solid_strains kind, double *G, double *weight)
{
    const struct plate_tables *t = space->tables;
    const struct line_table *u = &t->cure[lines[kind][0]][0],
                            *v = &t->cure[lines[kind][1]][1];
    double N[3 * BSPLINE_MAX_ORDER * BSPLINE_MAX_ORDER];
    int eu = element / v->spans, ev = element % v->spans, points = 0;
    int surface = u->order * v->order, row = SOLID_PADDED(space->local);

    for (int q = 0; q < u->points[eu]; q++)
        for (int s = 0; s < v->points[ev]; s++, G += 6 * row) {
            surface_point(space, element, u, values(u, eu, q), v, values(v, ev, s), N);
            weight[points++] = u->weight[eu * u->most + q] * v->weight[ev * v->most + s];
            for (int n = 0; n < surface; n++)
                for (int c = 0; c < 2; c++) {
                    int a = 2 * n + c;
                    G[a] = N[surface + n] * t->layer[0][c];
                    G[row + a] = N[2 * surface + n] * t->layer[0][c];
                    G[2 * row + a] = N[n] * t->layer[1][c];
                    G[3 * row + a] = N[surface + n] * t->layer[1][c];
                    G[4 * row + a] = N[2 * surface + n] * t->layer[1][c];
                }
        }
    return points;
}

enum status plate_model_select(struct solid_space *space, struct plate_tables *tables,
                               const struct patch *patch)
{
    double face[2][2];
    enum status st = STATUS_OK;

    for (int l = 0; l < PLATE_LINES && st == STATUS_OK; l++)
        for (int i = 0; i < 2 && st == STATUS_OK; i++)
            st = make_line(tables, &patch->basis[i], l, i);
    for (int k = 0; k < 2; k++)
        plate_thickness(patch, space->thickness_basis, k, face[k]);
    for (int c = 0; c < 2; c++) {
        tables->layer[0][c] = (face[0][c] + face[1][c]) / 2;
        tables->layer[1][c] = face[1][c] - face[0][c];
    }
    space->layer = layer_functions;
    for (int k = 0; k < SOLID_KINDS; k++)
        space->layer_points[k] =
            tables->cure[lines[k][0]][0].most * tables->cure[lines[k][1]][1].most;
    return st;
}

struct plate {
    struct solid_sheet sheet; /* first: solid_model.h                                  */
    struct plate_tables tables;
    struct patch patch;
    struct scene scene; /* the caller's, with supports of its own                owned  */
    double (*uvw)[3];   /* with weights given: parameters of the grid's points    owned  */
};

/* clang-format off */
static const struct schema_key options[] = {
    OPTIONS_CONTINUUM, {"knots_u"}, {"knots_v"}, {"knots_w"}, {"weights"}, {"kinematics"},
    {"unknowns"}, {"contact"},
    {"remedy", .only = OPTION(REMEDY_NONE) | OPTION(REMEDY_SELECTIVE)},
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
    plate_thickness(&p->patch, p->sheet.space.thickness_basis, at, value);
    return bspline_span(b, at) - b->p;
}

/* Evaluates the functions through the thickness, all of one element. */
static void layer_values(const void *context, double w, double *N)
{
    const struct plate *p = context;

    plate_thickness(&p->patch, p->sheet.space.thickness_basis, w, N);
}

static enum status add_loads(struct plate *p, struct message *why)
{
    struct dead_load_line line[3];
    struct bspline part[3];

    if (p->sheet.march.scene->load_count && p->patch.weight)
        return status_fail(why, STATUS_UNSUPPORTED, "unsupported: no loads with weights");
    for (int i = 0; i < 3; i++) {
        const struct bspline *b = &part[i];
        part[i] = bspline_part(&p->patch.basis[i], 0);
        line[i] = (struct dead_load_line){b->n,        b->p,           b->n - b->p + 1,
                                          b->U + b->p, bspline_values, b};
    }
    if (p->sheet.space.thickness_basis)
        line[2].value = layer_values, line[2].context = p;
    return solid_model_load(&p->sheet, line);
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

/* Sums over the functions along u, of each function along w and v that lives at a point:
 * the three coordinates, weighted, and the weight. */
typedef double plate_rows[BSPLINE_MAX_ORDER][BSPLINE_MAX_ORDER][4];

static void sum_over_u(const struct plate *p, const int first[3], const double *N,
                       plate_rows rows)
{
    const double *weight = p->patch.weight, *x = p->sheet.march.x;
    const struct bspline *v = &p->patch.basis[1];
    const int m = bspline_points(v), l = p->patch.basis[2].n;

    for (int c = 0; c <= p->patch.basis[2].p; c++)
        for (int b = 0; b <= v->p; b++) {
            double *sum = memset(rows[c][b], 0, sizeof rows[c][b]);
            for (int a = 0; a <= p->patch.basis[0].p; a++) {
                int node = ((first[0] + a) * m + bspline_point(v, first[1] + b)) * l +
                           first[2] + c;
                double share = weight ? N[a] * weight[node] : N[a];
                for (int i = 0; i < 3; i++)
                    sum[i] += share * solid_hinge_point(&p->sheet.space, x, node, i);
                sum[3] += share;
            }
        }
}

/* Computes the position at one tensor-product point: sums over u, then v, then w, so that a
 * grid point comes out the same for all callers. Rational if the patch has weights; the sum
 * of the functions through the thickness is then that of all or, in the thickness basis,
 * the first. */
static void sum_over_rows(const struct plate *p, const plate_rows rows, const double *Nv,
                          const double *Nw, double *xyz)
{
    double sum[3] = {0}, total = 0;

    for (int c = 0; c <= p->patch.basis[2].p; c++) {
        double over_v[4] = {0};
        for (int b = 0; b <= p->patch.basis[1].p; b++)
            for (int i = 0; i < 4; i++)
                over_v[i] += Nv[b] * rows[c][b][i];
        if (c == 0 || !p->sheet.space.thickness_basis)
            total += Nw[c] * over_v[3];
        for (int i = 0; i < 3; i++)
            sum[i] += Nw[c] * over_v[i];
    }
    for (int i = 0; i < 3; i++)
        xyz[i] = p->patch.weight ? sum[i] / total : sum[i];
}

/* Computes the position at parameters of the patch. */
static void evaluate_at(const struct plate *p, const double uvw[3], double *xyz)
{
    double N[3][BSPLINE_MAX_ORDER];
    plate_rows rows;
    int first[3];

    for (int i = 0; i < 3; i++)
        first[i] = alive(p, i, uvw[i], N[i]);
    sum_over_u(p, first, N[0], rows);
    sum_over_rows(p, rows, N[1], N[2], xyz);
}

/* Points of a line along v in the same span share their sums over u. */
static void sample(const void *state, double *xyz)
{
    enum { LINE = GRID_U > GRID_V ? GRID_U : GRID_V };
    static const int counts[3] = {GRID_U, GRID_V, GRID_W};
    const struct plate *p = state;
    double value[3][LINE][BSPLINE_MAX_ORDER]; /* of the lines along u, v and w */
    int first[3][LINE];
    plate_rows rows;

    for (int n = 0; p->uvw && n < GRID_POINTS; n++)
        evaluate_at(p, p->uvw[n], xyz + 3 * (size_t)n);
    if (p->uvw)
        return;
    for (int d = 0; d < 3; d++)
        for (int n = 0; n < counts[d]; n++)
            first[d][n] = alive(p, d, n / (counts[d] - 1.0), value[d][n]);
    for (int k = 0; k < GRID_W; k++)
        for (int i = 0; i < GRID_U; i++)
            for (int j = 0; j < GRID_V; j++) {
                if (j == 0 || first[1][j] != first[1][j - 1])
                    sum_over_u(p, (const int[]){first[0][i], first[1][j], first[2][k]},
                               value[0][i], rows);
                sum_over_rows(
                    p, rows, value[1][j], value[2][k],
                    xyz + 3 * (((size_t)k * GRID_V + (size_t)j) * GRID_U + (size_t)i));
            }
}

static void clear(void *state)
{
    struct plate *p = state;

    solid_model_clear(&p->sheet);
    plate_model_clear(&p->sheet.space, &p->tables);
    patch_clear(&p->patch);
    free(p->scene.supports);
    free(p->uvw);
}

static void probe(const void *state, int n, const double *uvw, double *xyz)
{
    const struct plate *p = state;

    for (int t = 0; t < n; t++, uvw += 3, xyz += 3) {
        double at[1][3] = {{uvw[0], uvw[1], uvw[2]}};
        if (p->uvw && find_parameters(p, 1, at))
            at[0][0] = NAN; /* cannot be: the rest shape was inverted at create */
        evaluate_at(p, at[0], xyz);
    }
}

/* Fabrics are for layers alone. */
enum {
    PLATE_SERVES =
        SOLID_MODEL_SERVES | SCENE_NEED_CLOSED_REST | SCENE_NEED_FABRIC | SCENE_NEED_BIAS
};

static enum status check_remedy(const struct discretization *d, struct message *why)
{
    if (d->remedy == REMEDY_NONE)
        return STATUS_OK;
    if (d->degree[0] < 2 || d->degree[1] < 2)
        return status_fail(why, STATUS_INPUT,
                           "remedy=selective needs degree 2 or more along u and v");
    if (d->gauss[0] || d->gauss[1] || d->gauss[2])
        return status_fail(why, STATUS_INPUT,
                           "remedy=selective has its own rule; leave gauss out");
    if (d->points[2] != 2 || d->weight_count)
        return status_fail(why, d->weight_count ? STATUS_INPUT : STATUS_UNSUPPORTED,
                           "remedy=selective is for one layer of degree 1 through the "
                           "thickness without weights; use none");
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
static int face_row(const struct plate *p, const int first[3],
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
    const struct solid_face *face = self;
    const struct plate *p = face->body;
    const double uvw[3] = {u, v, face->w};
    double N[3][BSPLINE_MAX_ORDER];
    int first[3];

    for (int i = 0; i < 3; i++)
        first[i] = alive(p, i, uvw[i], N[i]);
    return face_row(p, first, N, node, shape);
}

/* Does so for its control net. */
static int row_of_net(const void *self, double u, double v, int *node, double *shape)
{
    const struct solid_face *face = self;
    const struct plate *p = face->body;
    double N[3][BSPLINE_MAX_ORDER];
    const int first[3] = {bspline_contact_hats(&p->patch.basis[0], u, N[0]),
                          bspline_contact_hats(&p->patch.basis[1], v, N[1]),
                          alive(p, 2, face->w, N[2])};

    return face_row(p, first, N, node, shape);
}

static enum status meet(struct plate *p, const struct discretization *d)
{
    static contact_row *const rows[CONTACT_SAMPLES] = {row, row_of_net};
    const struct solid_face *face;
    struct contact_surface surface;
    enum status st = STATUS_OK;

    for (int n = 0; (face = solid_model_face(&p->sheet, p, n)); n++) {
        TRY(bspline_contact_surface(&p->scene, p->patch.basis, d, face, rows,
                                    patch_local(&p->patch), patch_nodes(&p->patch),
                                    &surface));
        TRY(solid_model_meet(&p->sheet, face, &surface));
    }
out:
    return st;
}

static enum status meet_air(struct plate *p)
{
    enum status st;
    int *span, breaks[2];
    double *line[2];
    void *room = NULL;

    TRY(room_cut(&room, ROOM(line[0], p->patch.basis[0].n + 1),
                 ROOM(line[1], p->patch.basis[1].n + 1),
                 ROOM(span, p->patch.basis[0].n + p->patch.basis[1].n)));
    for (int d = 0; d < 2; d++) {
        const struct bspline b = bspline_part(&p->patch.basis[d], 0);
        const int spans = bspline_spans(&b, span);
        for (int k = 0; k < spans; k++)
            line[d][k] = b.U[span[k]];
        line[d][spans] = 1;
        breaks[d] = spans + 1;
    }
    TRY(solid_model_air(&p->sheet, p, row, patch_local(&p->patch), breaks,
                        (const double *const *)line,
                        (const int[]){p->patch.basis[0].p, p->patch.basis[1].p}));
out:
    free(room);
    return st;
}

static enum status init(void *state, const struct scene *scene,
                        const struct discretization *d, struct message *why)
{
    enum status st;
    bool thickness, one_element;
    double middle[BSPLINE_MAX_ORDER];
    struct plate *p = state;

    TRY(model_refuse(scene, PLATE_SERVES, why));
    TRY(contact_rest_refuse(scene, d, why));
    TRY(model_refuse_options(d, why));
    TRY(check_remedy(d, why));
    if (d->remedy != REMEDY_SELECTIVE)
        TRY(solid_model_refuse_fabric(scene, why));
    TRY(make_patch(scene, d, &p->patch, why));
    p->scene = *scene;
    TRY(support_knots_hold(scene, p->patch.basis, &p->scene.supports));
    one_element = p->patch.basis[2].n == p->patch.basis[2].p + 1 && !d->weight_count;
    TRY(solid_model_basis(scene, d, one_element, &thickness, why));
    TRY(plate_model_space(&p->sheet.space, &p->tables, &p->patch, d->gauss, thickness));
    solid_space_spread(&p->sheet.space, scene);
    if (d->remedy == REMEDY_SELECTIVE)
        TRY(plate_model_select(&p->sheet.space, &p->tables, &p->patch));
    TRY(find_grid(p));
    const struct bspline *b = p->patch.basis;
    plate_thickness(&p->patch, false, 0.5, middle);
    TRY(solid_model_init(&p->sheet, &p->scene, d,
                         (const int[]){b[0].n, bspline_points(&b[1]), b[2].n},
                         one_element ? middle : NULL, why));
    TRY(add_loads(p, why));
    TRY(meet(p, d));
    TRY(meet_air(p));
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
    .advance = march_step,
    .sample = sample,
    .probe = probe,
    .size = march_size,
    .describe = solid_model_describe,
    .energy = march_energy,
    .contact = march_contact,
    .forces = march_forces,
    .net = solid_model_net,
    .equilibrium = march_equilibrium,
    .modes = march_modes,
    .matrices = solid_model_matrices,
    .clear = clear,
};
