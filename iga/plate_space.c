#include "iga/plate_space.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "iga/reduced_rule.h"
#include "models/mechanics/supports.h"

void plate_space_legendre(int degree, double w, double *value, double *derivative)
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

void plate_space_thickness(const struct patch *patch, bool thickness, double w, double *N)
{
    const struct bspline *b = &patch->basis[2];

    if (thickness)
        plate_space_legendre(b->p, w, N, NULL);
    else
        bspline_eval(b, bspline_span(b, w), w, 0, N);
}

static void legendre(const struct bspline *b, int span, double w, int order, double *out)
{
    (void)span;
    plate_space_legendre(b->p, w, out, order ? out + b->p + 1 : NULL);
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
        plate_space_legendre(b->p, x[q], P, NULL);
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

void plate_space_clear(struct solid_space *space, struct plate_tables *tables)
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

enum status plate_space_init(struct solid_space *space, struct plate_tables *tables,
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
    plate_space_clear(&new, &t);
    return st;
}

/* --- Cures. */

/* Computes N, G and weight of one point from rows of the three directions' tables. */
static double one_point(const struct line_table *const d[3], const int e[3], const int q[3],
                        double *N, double *G, int row)
{
    const double *value[3], *slope[3];
    double weight[3];
    int n = 0;

    for (int i = 0; i < 3; i++) {
        value[i] = values(d[i], e[i], q[i]), slope[i] = value[i] + d[i]->order;
        weight[i] = d[i]->weight[e[i] * d[i]->most + q[i]];
    }
    for (int a = 0; a < d[0]->order; a++)
        for (int b = 0; b < d[1]->order; b++)
            for (int c = 0; c < d[2]->order; c++, n++) {
                N[n] = value[0][a] * value[1][b] * value[2][c];
                G[n] = slope[0][a] * value[1][b] * value[2][c];
                G[row + n] = value[0][a] * slope[1][b] * value[2][c];
                G[2 * row + n] = value[0][a] * value[1][b] * slope[2][c];
            }
    return weight[0] * weight[1] * weight[2];
}

static int reduced_functions(const struct solid_space *space, int element,
                             struct solid_functions *out)
{
    const struct plate_tables *t = space->tables;
    const struct line_table *const d[3] = {&t->cure[PLATE_REDUCED][0],
                                           &t->cure[PLATE_REDUCED][1], &t->direction[2]};
    const int e[3] = {element / (d[1]->spans * d[2]->spans),
                      element / d[2]->spans % d[1]->spans, element % d[2]->spans};
    int row = SOLID_PADDED(space->local), count = 0;

    for (int q = 0; q < d[0]->points[e[0]]; q++)
        for (int s = 0; s < d[1]->points[e[1]]; s++)
            for (int r = 0; r < d[2]->most; r++, count++) {
                double *N = out->N + count * row, *G = out->G + 3 * count * row;
                out->weight[count] = one_point(d, e, (const int[]){q, s, r}, N, G, row);
                if (t->point_weight)
                    make_rational(space, element, N, G, row);
            }
    return count;
}

static enum status make_line(struct plate_tables *tables, const struct bspline *b, int l,
                             int i)
{
    struct line_rule rule;
    enum status st = l == PLATE_BENDING    ? line_rule_bending(&rule, b)
                     : l == PLATE_GREVILLE ? line_rule_greville(&rule, b, false)
                                           : reduced_rule_init(&rule, b);

    return line_rule_table(&tables->cure[l][i], b, st, &rule, 2, bspline_eval);
}

enum status plate_space_reduce(struct solid_space *space, struct plate_tables *tables,
                               const struct patch *patch)
{
    enum status st = STATUS_OK;

    for (int i = 0; i < 2 && st == STATUS_OK; i++)
        st = make_line(tables, &patch->basis[i], PLATE_REDUCED, i);
    space->reduced = reduced_functions;
    space->plane_stress = patch->basis[2].n == 2;
    return st;
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
    [SOLID_ALONG_U] = {PLATE_REDUCED, PLATE_GREVILLE},
    [SOLID_ALONG_V] = {PLATE_GREVILLE, PLATE_REDUCED},
    [SOLID_OTHER] = {PLATE_REDUCED, PLATE_REDUCED},
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

enum status plate_space_select(struct solid_space *space, struct plate_tables *tables,
                               const struct patch *patch)
{
    double face[2][2];
    enum status st = STATUS_OK;

    for (int l = 0; l < PLATE_LINES && st == STATUS_OK; l++)
        for (int i = 0; i < 2 && st == STATUS_OK; i++)
            st = make_line(tables, &patch->basis[i], l, i);
    for (int k = 0; k < 2; k++)
        plate_space_thickness(patch, space->thickness_basis, k, face[k]);
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

/* Computes int_a^b exp(-y) of the `count` polynomials that are 1 at one of y[count] and 0
 * at the others; y counts from a. */
static void decaying(int count, const double *y, double a, double b, double *out)
{
    double moment[GAUSS_MAX], end = exp(a - b), power = 1;

    for (int k = 0; k < count; k++, power *= b - a)
        moment[k] = (k ? k * moment[k - 1] : 1) - power * end;
    for (int q = 0; q < count; q++) {
        double c[GAUSS_MAX] = {1}; /* coefficients of the polynomial, from the constant */
        for (int r = 0, degree = 0; r < count; r++) {
            if (r == q)
                continue;
            degree++;
            for (int k = degree; k >= 0; k--)
                c[k] = ((k ? c[k - 1] : 0) - y[r] * c[k]) / (y[q] - y[r]);
        }
        out[q] = 0;
        for (int k = 0; k < count; k++)
            out[q] += exp(-a) * c[k] * moment[k];
    }
}

void plate_space_clamp(struct plate_tables *tables, const struct patch *patch, int i,
                       bool end, double thickness, double poisson)
{
    const struct bspline *b = &patch->basis[i];
    struct line_table *d = &tables->cure[PLATE_BENDING][i];
    const double width = thickness * sqrt((1 - poisson) / 120);
    const double share = poisson * poisson / ((1 - poisson) * (1 - poisson));
    double x[GAUSS_MAX], w[GAUSS_MAX], y[GAUSS_MAX], less[GAUSS_MAX];

    for (int e = 0; e < d->spans && width > 0; e++) {
        const int points = d->points[e];
        double lo = b->U[d->node[e * d->order] + b->p];
        double hi = b->U[d->node[e * d->order] + b->p + 1];
        double near = (end ? 1 - hi : lo) / width, far = (end ? 1 - lo : hi) / width;
        gauss_rule(points, x, w);
        for (int q = 0; q < points; q++) /* the rule is symmetric */
            y[q] = (far - near) * x[q];
        decaying(points, y, near, far, less);
        for (int q = 0; q < points; q++) {
            double *weight = d->weight + e * d->most + (end ? points - 1 - q : q);
            *weight /= 1 - share * less[q] / ((far - near) * w[q]);
        }
    }
}
