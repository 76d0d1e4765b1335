#include <math.h>

#include "iga/plate_space.h"
#include "iga/plate_space_part.h"
#include "iga/reduced_rule.h"

/* N, G and weight of one point: rows of the three directions' tables. */
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
    const struct plate_direction *const d[3] = {&t->reduced[0], &t->reduced[1],
                                                &t->direction[2]};
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

static enum status reduce_directions(struct plate_tables *tables, const struct patch *patch)
{
    for (int i = 0; i < 2; i++) {
        const struct bspline *b = &patch->basis[i];
        struct reduced_rule rule;
        enum status st = reduced_rule_init(&rule, b);
        if (st == STATUS_OK)
            st = plate_space_direction(&tables->reduced[i], b, rule.most, &rule, false);
        reduced_rule_clear(&rule);
        if (st != STATUS_OK)
            return st;
    }
    return STATUS_OK;
}

enum status plate_space_reduce(struct solid_space *space, struct plate_tables *tables,
                               const struct patch *patch)
{
    enum status st = reduce_directions(tables, patch);

    if (st != STATUS_OK)
        return st;
    space->reduced = reduced_functions;
    space->plane_stress = patch->basis[2].n == 2;
    return STATUS_OK;
}

/* Values and gradients of the functions of a surface at one point: N, N_u, N_v, [3][order u
 * * order v]. */
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

static int layer_functions(const struct solid_space *space, int element, bool bend,
                           double *G, double *weight)
{
    const struct plate_tables *t = space->tables;
    const struct plate_direction *u = bend ? &t->bend[0] : &t->reduced[0], *v = u + 1;
    double N[3 * BSPLINE_MAX_ORDER * BSPLINE_MAX_ORDER];
    int eu = element / v->spans, ev = element % v->spans, points = 0;
    int surface = u->order * v->order, row = SOLID_PADDED(space->local);
    int nu = u->points ? u->points[eu] : u->gauss,
        nv = v->points ? v->points[ev] : v->gauss;

    for (int q = 0; q < nu; q++)
        for (int s = 0; s < nv; s++, G += 6 * row) {
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
    enum status st = reduce_directions(tables, patch);

    for (int i = 0; i < 2 && st == STATUS_OK; i++) {
        const struct bspline *b = &patch->basis[i];
        st = plate_space_direction(&tables->bend[i], b, b->p > 2 ? b->p - 1 : 2, NULL,
                                   false);
    }
    for (int k = 0; k < 2; k++)
        plate_space_thickness(patch, space->thickness_basis, k, face[k]);
    for (int c = 0; c < 2; c++) {
        tables->layer[0][c] = (face[0][c] + face[1][c]) / 2;
        tables->layer[1][c] = face[1][c] - face[0][c];
    }
    space->layer = layer_functions;
    space->layer_points[0] = tables->reduced[0].gauss * tables->reduced[1].gauss;
    space->layer_points[1] = tables->bend[0].gauss * tables->bend[1].gauss;
    return st;
}

/* int_a^b exp(-y) of the `count` polynomials that are 1 at one of y[count] and 0 at the
 * others; y counts from a. */
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
    struct plate_direction *d = &tables->bend[i];
    const double width = thickness * sqrt((1 - poisson) / 120);
    const double share = poisson * poisson / ((1 - poisson) * (1 - poisson));
    double x[GAUSS_MAX], w[GAUSS_MAX], y[GAUSS_MAX], less[GAUSS_MAX];

    gauss_rule(d->gauss, x, w);
    for (int e = 0; e < d->spans && width > 0; e++) {
        double lo = b->U[d->first[e] + b->p], hi = b->U[d->first[e] + b->p + 1];
        double near = (end ? 1 - hi : lo) / width, far = (end ? 1 - lo : hi) / width;
        for (int q = 0; q < d->gauss; q++) /* the rule is symmetric */
            y[q] = (far - near) * x[q];
        decaying(d->gauss, y, near, far, less);
        for (int q = 0; q < d->gauss; q++) {
            double *weight = d->weight + e * d->gauss + (end ? d->gauss - 1 - q : q);
            *weight /= 1 - share * less[q] / ((far - near) * w[q]);
        }
    }
}
