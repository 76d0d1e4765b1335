#include "models/linalg/krylov.h"

#include <math.h>
#include <string.h>

#include "models/linalg/blocks.h"

double krylov_product(int n, const double *a, const double *b)
{
    double sum = 0;

    for (int t = 0; t < n; t++)
        sum += a[t] * b[t];
    return sum;
}

/* Adds part x to y. */
static void add(int n, double part, const double *x, double *y)
{
    for (int t = 0; t < n; t++)
        y[t] += part * x[t];
}

/* Computes r = b - A x; r does not overlap the others. known: r is A x on entry. */
static void residual(const struct krylov *k, bool known, const double *b, const double *x,
                     double *r)
{
    if (!known)
        k->multiply(k->self, x, r);
    for (int t = 0; t < k->n; t++)
        r[t] = b[t] - r[t];
}

/* --- conjugate gradients -----------------------------------------------------------------
 */

size_t krylov_cg_work(int n)
{
    return 4 * (size_t)n;
}

/* Steps x += part q, r -= part A q, for the part that minimizes r: q is replaced. */
static enum status descend(const struct krylov *k, double size, const double *q, double *Aq,
                           double *x, double *r)
{
    k->multiply(k->self, q, Aq);
    double curvature = krylov_product(k->n, q, Aq);

    if (!isfinite(curvature))
        return STATUS_NAN;
    if (curvature <= 0)
        return STATUS_INDEFINITE;
    add(k->n, size / curvature, q, x);
    add(k->n, -size / curvature, Aq, r);
    return STATUS_OK;
}

enum status krylov_cg(struct krylov *k, const double *b, double *x, bool *done)
{
    enum status st = STATUS_OK;
    int n = k->n;
    double *r = k->work, *z = r + n, *q = z + n, *Aq = q + n, size = 0, first = 0;

    residual(k, k->multiplied, b, x, r);
    k->multiplied = false;
    for (k->iterations = 0; k->iterations <= k->most;) {
        TRY(k->precondition(k->self, r, z));
        double before = size;
        size = krylov_product(n, r, z);
        if (!isfinite(size))
            return STATUS_NAN;
        if (size < 0)
            return STATUS_INDEFINITE;
        if (k->iterations++ == 0)
            first = fmax(size, krylov_product(n, x, b));
        *done = size <= k->tolerance * k->tolerance * first ||
                (k->near > 0 && blocks_longest(n / 3, z) <= k->near);
        if (*done || k->iterations > k->most)
            break;
        for (int t = 0; t < n; t++)
            q[t] = z[t] + (before > 0 ? size / before * q[t] : 0);
        TRY(descend(k, size, q, Aq, x, r));
    }
out:
    return st;
}

/* --- GMRES -------------------------------------------------------------------------------
 */

enum { COLUMNS = KRYLOV_RESTART, ROWS = COLUMNS + 1 };

/* The least squares problem of one cycle: H by columns, made triangular by rotations. */
struct cycle {
    double *v;       /* [ROWS][n] orthonormal                                          */
    double *product; /* [n]                                                            */
    double h[COLUMNS][ROWS], cosine[COLUMNS], sine[COLUMNS], rest[ROWS];
};

size_t krylov_gmres_work(int n)
{
    return (size_t)(ROWS + 1) * (size_t)n;
}

/* Orthogonalizes P A v_c against the vectors so far: column c of H, and v_{c+1}. */
static enum status extend(const struct krylov *k, struct cycle *y, int c)
{
    enum status st;
    int n = k->n;
    double *next = y->v + (size_t)(c + 1) * (size_t)n;

    k->multiply(k->self, y->v + (size_t)c * (size_t)n, y->product);
    TRY(k->precondition(k->self, y->product, next));
    for (int i = 0; i <= c; i++) {
        const double *v = y->v + (size_t)i * (size_t)n;
        y->h[c][i] = krylov_product(n, v, next);
        add(n, -y->h[c][i], v, next);
    }
    double size = sqrt(krylov_product(n, next, next));
    y->h[c][c + 1] = size;
    for (int t = 0; size > 0 && t < n; t++)
        next[t] /= size;
    st = isfinite(size) ? STATUS_OK : STATUS_NAN;
out:
    return st;
}

/* Rotates column c to triangular form, and the rest of the right-hand side with it. */
static void rotate(struct cycle *y, int c)
{
    double *h = y->h[c];

    for (int i = 0; i < c; i++) {
        double upper = h[i];
        h[i] = y->cosine[i] * upper + y->sine[i] * h[i + 1];
        h[i + 1] = y->cosine[i] * h[i + 1] - y->sine[i] * upper;
    }
    double length = hypot(h[c], h[c + 1]);
    y->cosine[c] = length > 0 ? h[c] / length : 1;
    y->sine[c] = length > 0 ? h[c + 1] / length : 0;
    h[c] = length;
    y->rest[c + 1] = -y->sine[c] * y->rest[c];
    y->rest[c] *= y->cosine[c];
}

/* Adds to x the combination of `count` vectors with the least residual. */
static void combine(const struct krylov *k, struct cycle *y, int count, double *x)
{
    for (int i = count - 1; i >= 0; i--) {
        for (int j = i + 1; j < count; j++)
            y->rest[i] -= y->h[j][i] * y->rest[j];
        y->rest[i] = y->h[i][i] != 0 ? y->rest[i] / y->h[i][i] : 0;
        add(k->n, y->rest[i], y->v + (size_t)i * (size_t)k->n, x);
    }
}

enum status krylov_gmres(struct krylov *k, const double *b, double *x, bool *done)
{
    enum status st;
    int n = k->n;
    struct cycle y = {.v = k->work, .product = k->work + (size_t)ROWS * (size_t)n};

    TRY(k->precondition(k->self, b, y.v));
    double wanted = k->tolerance * sqrt(krylov_product(n, y.v, y.v));
    *done = false;
    for (k->iterations = 1; !*done && k->iterations < k->most;) {
        int count = 0;
        residual(k, false, b, x, y.product);
        TRY(k->precondition(k->self, y.product, y.v));
        double size = sqrt(krylov_product(n, y.v, y.v));
        if (!isfinite(size))
            return STATUS_NAN;
        *done = size <= wanted;
        k->iterations++;
        for (int t = 0; !*done && t < n; t++)
            y.v[t] /= size;
        y.rest[0] = size;
        while (count < COLUMNS && fabs(y.rest[count]) > wanted && k->iterations < k->most) {
            TRY(extend(k, &y, count));
            k->iterations++;
            rotate(&y, count++);
        }
        combine(k, &y, count, x);
        *done = *done || fabs(y.rest[count]) <= wanted;
    }
out:
    return st;
}
