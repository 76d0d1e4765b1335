#include <math.h>

#include "iga/plate_space.h"
#include "iga/plate_space_part.h"
#include "iga/reduced_rule.h"

/* Computes N, G and weight of one point from rows of the three directions' tables. */
static double one_point(const struct plate_direction *const d[3], const size_t at[3],
                        double *N, double *G, int row)
{
    const double *value[3], *slope[3];
    int n = 0;

    for (int i = 0; i < 3; i++) {
        value[i] = d[i]->N + at[i] * (size_t)d[i]->order;
        slope[i] = d[i]->dN + at[i] * (size_t)d[i]->order;
    }
    for (int a = 0; a < d[0]->order; a++)
        for (int b = 0; b < d[1]->order; b++)
            for (int c = 0; c < d[2]->order; c++, n++) {
                N[n] = value[0][a] * value[1][b] * value[2][c];
                G[n] = slope[0][a] * value[1][b] * value[2][c];
                G[row + n] = value[0][a] * slope[1][b] * value[2][c];
                G[2 * row + n] = value[0][a] * value[1][b] * slope[2][c];
            }
    return d[0]->weight[at[0]] * d[1]->weight[at[1]] * d[2]->weight[at[2]];
}

static int reduced_functions(const struct solid_space *space, int element,
                             struct solid_functions *out)
{
    const struct plate_tables *t = space->tables;
    const struct plate_direction *const d[3] = {
        &t->cure[PLATE_REDUCED][0], &t->cure[PLATE_REDUCED][1], &t->direction[2]};
    int e[3] = {element / (d[1]->spans * d[2]->spans), element / d[2]->spans % d[1]->spans,
                element % d[2]->spans};
    int row = SOLID_PADDED(space->local), count = 0;
    size_t at[3];

    for (int q = 0; q < d[0]->points[e[0]]; q++)
        for (int s = 0; s < d[1]->points[e[1]]; s++)
            for (int r = 0; r < d[2]->gauss; r++, count++) {
                double *N = out->N + count * row, *G = out->G + 3 * count * row;
                at[0] = (size_t)(e[0] * d[0]->gauss + q);
                at[1] = (size_t)(e[1] * d[1]->gauss + s);
                at[2] = (size_t)(e[2] * d[2]->gauss + r);
                out->weight[count] = one_point(d, at, N, G, row);
                if (t->point_weight)
                    plate_space_rational(space, element, N, G, row);
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

    return plate_space_direction(&tables->cure[l][i], b, st, &rule, false);
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
static double surface_point(const struct solid_space *space, int element,
                            const struct plate_direction *u, size_t at_u,
                            const struct plate_direction *v, size_t at_v, double *N)
{
    const struct plate_tables *t = space->tables;
    const double *Nu = u->N + at_u * (size_t)u->order,
                 *dNu = u->dN + at_u * (size_t)u->order;
    const double *Nv = v->N + at_v * (size_t)v->order,
                 *dNv = v->dN + at_v * (size_t)v->order;
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
    return u->weight[at_u] * v->weight[at_v];
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
    const struct plate_direction *u = &t->cure[lines[kind][0]][0],
                                 *v = &t->cure[lines[kind][1]][1];
    double N[3 * BSPLINE_MAX_ORDER * BSPLINE_MAX_ORDER];
    int eu = element / v->spans, ev = element % v->spans, points = 0;
    int surface = u->order * v->order, row = SOLID_PADDED(space->local);

    for (int q = 0; q < u->points[eu]; q++)
        for (int s = 0; s < v->points[ev]; s++, G += 6 * row) {
            weight[points++] = surface_point(space, element, u, (size_t)(eu * u->gauss + q),
                                             v, (size_t)(ev * v->gauss + s), N);
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
            tables->cure[lines[k][0]][0].gauss * tables->cure[lines[k][1]][1].gauss;
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
    struct plate_direction *d = &tables->cure[PLATE_BENDING][i];
    const double width = thickness * sqrt((1 - poisson) / 120);
    const double share = poisson * poisson / ((1 - poisson) * (1 - poisson));
    double x[GAUSS_MAX], w[GAUSS_MAX], y[GAUSS_MAX], less[GAUSS_MAX];

    for (int e = 0; e < d->spans && width > 0; e++) {
        const int points = d->points[e];
        double lo = b->U[d->first[e] + b->p], hi = b->U[d->first[e] + b->p + 1];
        double near = (end ? 1 - hi : lo) / width, far = (end ? 1 - lo : hi) / width;
        gauss_rule(points, x, w);
        for (int q = 0; q < points; q++) /* the rule is symmetric */
            y[q] = (far - near) * x[q];
        decaying(points, y, near, far, less);
        for (int q = 0; q < points; q++) {
            double *weight = d->weight + e * d->gauss + (end ? points - 1 - q : q);
            *weight /= 1 - share * less[q] / ((far - near) * w[q]);
        }
    }
}
