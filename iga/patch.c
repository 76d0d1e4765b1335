#include "iga/patch.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int patch_nodes(const struct patch *p)
{
    return p->basis[0].n * bspline_points(&p->basis[1]) * p->basis[2].n;
}

int patch_local(const struct patch *p)
{
    return (p->basis[0].p + 1) * (p->basis[1].p + 1) * (p->basis[2].p + 1);
}

enum status patch_init(struct patch *patch, const struct bspline basis[3])
{
    enum status st = STATUS_OK;
    struct patch new = {0};

    for (int d = 0; d < 3; d++)
        TRY(bspline_copy(&basis[d], &new.basis[d]));
    new.point = calloc((size_t)patch_nodes(&new) * 3, sizeof *new.point);
    if (!new.point)
        TRY(STATUS_MEMORY);
    *patch = new, new = (struct patch){0};
out:
    patch_clear(&new);
    return st;
}

void patch_clear(struct patch *patch)
{
    if (!patch)
        return;
    for (int d = 0; d < 3; d++)
        bspline_clear(&patch->basis[d]);
    free(patch->point);
    free(patch->weight);
    *patch = (struct patch){0};
}

void patch_set_box(struct patch *patch, const double origin[3], const double a[3],
                   const double b[3], const double c[3])
{
    const struct bspline *basis = patch->basis;
    double *x = patch->point;

    for (int i = 0; i < basis[0].n; i++)
        for (int j = 0; j < basis[1].n; j++)
            for (int k = 0; k < basis[2].n; k++, x += 3) {
                double u = bspline_greville(&basis[0], i);
                double v = bspline_greville(&basis[1], j);
                double w = bspline_greville(&basis[2], k);
                for (int d = 0; d < 3; d++)
                    x[d] = origin[d] + a[d] * u + b[d] * v + c[d] * w;
            }
}

void patch_local_nodes(const struct patch *patch, const int span[3], int *node)
{
    const struct bspline *basis = patch->basis;
    int m = bspline_points(&basis[1]), l = basis[2].n;

    for (int i = span[0] - basis[0].p; i <= span[0]; i++)
        for (int j = span[1] - basis[1].p; j <= span[1]; j++)
            for (int k = span[2] - basis[2].p; k <= span[2]; k++)
                *node++ = (i * m + bspline_point(&basis[1], j)) * l + k;
}

/* Univariate values and first derivatives at a point, [value, derivative][function]. */
struct factors {
    double N[3][2][BSPLINE_MAX_ORDER];
};

static void evaluate_factors(const struct patch *patch, const double uvw[3], int order,
                             int span[3], struct factors *f)
{
    for (int d = 0; d < 3; d++) {
        const struct bspline *b = &patch->basis[d];
        double out[2 * BSPLINE_MAX_ORDER];
        span[d] = bspline_span(b, uvw[d]);
        bspline_eval(b, span[d], uvw[d], order, out);
        for (int o = 0; o <= order; o++)
            memcpy(f->N[d][o], out + o * (b->p + 1), ((size_t)b->p + 1) * sizeof *out);
    }
}

/* Fills out[local]: products of values, differentiated once in `direction` (-1: not). */
static void tensor(const struct patch *patch, const struct factors *f, int direction,
                   double *out)
{
    const double *A = f->N[0][direction == 0], *B = f->N[1][direction == 1];
    const double *C = f->N[2][direction == 2];

    for (int a = 0; a <= patch->basis[0].p; a++)
        for (int b = 0; b <= patch->basis[1].p; b++)
            for (int c = 0; c <= patch->basis[2].p; c++)
                *out++ = A[a] * B[b] * C[c];
}

/* Multiplies f_a by w_a; returns their sum. */
static double weigh(const double *weight, const int *node, int local, double *f)
{
    double sum = 0.0;

    for (int a = 0; a < local; a++)
        sum += f[a] *= weight[node[a]];
    return sum;
}

/* Computes R = N w / W, R' = (N' w - R W') / W, W the sum of N w. (eq. 2; NURBS Book
 * 4.8) */
static void make_rational(const struct patch *patch, const int span[3], double *R,
                          double *dR)
{
    int node[PATCH_MAX_LOCAL], local = patch_local(patch);
    double W;

    patch_local_nodes(patch, span, node);
    W = weigh(patch->weight, node, local, R);
    for (int a = 0; a < local; a++)
        R[a] /= W;
    for (int d = 0; dR && d < 3; d++) {
        double *g = dR + d * local;
        double dW = weigh(patch->weight, node, local, g);
        for (int a = 0; a < local; a++)
            g[a] = (g[a] - R[a] * dW) / W;
    }
}

void patch_basis(const struct patch *patch, const double uvw[3], int span[3], double *R,
                 double *dR)
{
    double scratch[PATCH_MAX_LOCAL];
    struct factors f;

    evaluate_factors(patch, uvw, dR ? 1 : 0, span, &f);
    if (!R && patch->weight) /* the quotient rule needs the values */
        R = scratch;
    if (R)
        tensor(patch, &f, -1, R);
    for (int d = 0; dR && d < 3; d++)
        tensor(patch, &f, d, dR + d * patch_local(patch));
    if (patch->weight && R)
        make_rational(patch, span, R, dR);
}

void patch_point(const struct patch *patch, const double uvw[3], double x[3],
                 double J[3][3])
{
    double R[PATCH_MAX_LOCAL], dR[3 * PATCH_MAX_LOCAL];
    int node[PATCH_MAX_LOCAL], span[3], local = patch_local(patch);

    patch_basis(patch, uvw, span, R, J ? dR : NULL);
    patch_local_nodes(patch, span, node);
    memset(x, 0, 3 * sizeof *x);
    if (J)
        memset(J, 0, 9 * sizeof(double));
    for (int a = 0; a < local; a++) {
        const double *P = patch->point + 3 * (size_t)node[a];
        for (int i = 0; i < 3; i++) {
            x[i] += R[a] * P[i];
            for (int j = 0; J && j < 3; j++)
                J[i][j] += dR[j * local + a] * P[i];
        }
    }
}

/* Computes r = x - V(uvw), returns its length. */
static double residual(const struct patch *patch, const double x[3], const double uvw[3],
                       double r[3], double J[3][3])
{
    double y[3];

    patch_point(patch, uvw, y, J);
    for (int i = 0; i < 3; i++)
        r[i] = x[i] - y[i];
    return hypot(hypot(r[0], r[1]), r[2]);
}

/* Solves J s = r by cofactors; s is not finite where J is singular. */
static void solve(double J[3][3], const double r[3], double s[3])
{
    double determinant = 0;

    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        double C[3]; /* cofactors of column i */
        for (int a = 0; a < 3; a++) {
            const int b = (a + 1) % 3, c = (a + 2) % 3;
            C[a] = J[b][j] * J[c][k] - J[c][j] * J[b][k];
        }
        s[i] = C[0] * r[0] + C[1] * r[1] + C[2] * r[2];
        determinant = C[0] * J[0][i] + C[1] * J[1][i] + C[2] * J[2][i];
    }
    for (int i = 0; i < 3; i++)
        s[i] /= determinant;
}

enum status patch_invert(const struct patch *patch, const double x[3], double tolerance,
                         double uvw[3])
{
    enum { STEPS = 50 };
    double J[3][3], r[3], s[3], share = 1, distance;

    for (int i = 0; i < 3; i++)
        uvw[i] = fmin(fmax(uvw[i], 0.0), 1.0);
    distance = residual(patch, x, uvw, r, J);
    for (int n = 0; n < STEPS && distance > tolerance; n++) {
        double try[3], try_r[3], try_J[3][3];
        solve(J, r, s);
        for (int i = 0; i < 3; i++)
            try[i] = fmin(fmax(uvw[i] + share * s[i], 0.0), 1.0);
        const double try_distance = residual(patch, x, try, try_r, try_J);
        if (!(try_distance < distance)) {
            share /= 2;
            continue;
        }
        share = 1, distance = try_distance;
        memcpy(uvw, try, sizeof try);
        memcpy(r, try_r, sizeof r);
        memcpy(J, try_J, sizeof J);
    }
    return distance <= tolerance ? STATUS_OK : STATUS_DIVERGED;
}
