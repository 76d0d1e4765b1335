/* derivative_fixture.h - what every body at large displacements owes: forces that are the
 * derivative of its energy, tangents that are that of its forces, rigid motions for
 * nothing.
 */
#ifndef DERIVATIVE_FIXTURE_H
#define DERIVATIVE_FIXTURE_H

#include "models/linalg/blocks.h"
#include "models/mechanics/large_body.h"
#include "tests/check.h"

static inline double derivative_dot(size_t count, const double *a, const double *b)
{
    double sum = 0;

    for (size_t t = 0; t < count; t++)
        sum += a[t] * b[t];
    return sum;
}

static inline double derivative_norm(size_t count, const double *a)
{
    return sqrt(derivative_dot(count, a, a));
}

static inline double derivative_energy(const struct large_body *b, const double *x)
{
    double energy = NAN;

    CHECK(b->energy(b->self, x, &energy) == STATUS_OK);
    return energy;
}

/* Along d at x, [nodes][3] each, the best of a sweep of central differences: truncation
 * falls as step^2, rounding grows as eps / step. For smooth functions of size 1 the best is
 * some 1e-10; a wrong term is 1e-3 and more. */
static inline void derivative_check(const struct large_body *b, const struct blocks *graph,
                                    const double *x, const double *d, double tolerance)
{
    const size_t count = 3 * (size_t)graph->nodes;
    double *want = malloc(4 * count * sizeof *want), *moved = want + count;
    double *f[2] = {moved + count, moved + 2 * count}, off[2] = {1, 1};
    double(*K)[9] = malloc((size_t)graph->start[graph->nodes] * sizeof *K);

    REQUIRE(want && K);
    CHECK(large_body_force(b, &large_path_statics, x, want) == STATUS_OK);
    const double along = derivative_dot(count, want, d),
                 size = derivative_norm(count, want) * derivative_norm(count, d);
    CHECK(large_body_tangent(b, &large_path_statics, x, (struct large_foresight){0}, K) ==
          STATUS_OK);
    blocks_multiply(graph, (const double(*)[9])K, d, want);
    for (double step = 1e-3; step > 1e-8; step /= 4) {
        double energy[2];
        for (int side = 0; side < 2; side++) {
            for (size_t t = 0; t < count; t++)
                moved[t] = x[t] + (side ? step : -step) * d[t];
            energy[side] = derivative_energy(b, moved);
            CHECK(large_body_force(b, &large_path_statics, moved, f[side]) == STATUS_OK);
        }
        for (size_t t = 0; t < count; t++)
            moved[t] = (f[1][t] - f[0][t]) / (2 * step) - want[t];
        off[0] = fmin(off[0], fabs((energy[1] - energy[0]) / (2 * step) - along) / size);
        off[1] = fmin(off[1], derivative_norm(count, moved) / derivative_norm(count, want));
    }
    CHECK_NEAR(off[0], 0, tolerance);
    CHECK_NEAR(off[1], 0, tolerance);
    free(want);
    free(K);
}

/* Turned by 2.1 rad about (1,2,2)/3 and shifted: energy and forces, of those of the body
 * deformed. */
static inline void derivative_rigid(const struct large_body *b, const double *rest,
                                    double shift, double deformed, double tol_energy,
                                    double tol_force)
{
    const double axis[3] = {1 / 3., 2 / 3., 2 / 3.}, c = cos(2.1), n = sin(2.1);
    const size_t count = 3 * (size_t)b->nodes;
    double *x = malloc(2 * count * sizeof *x), *f = x + count;

    REQUIRE(x);
    for (int a = 0; a < b->nodes; a++) {
        const double *r = rest + 3 * a, along = derivative_dot(3, axis, r);
        for (int i = 0; i < 3; i++) {
            int j = (i + 1) % 3, k = (i + 2) % 3;
            x[3 * a + i] = c * r[i] + (1 - c) * along * axis[i] +
                           n * (axis[j] * r[k] - axis[k] * r[j]) + shift;
        }
    }
    CHECK_NEAR(derivative_energy(b, x) / deformed, 0, tol_energy);
    CHECK(large_body_force(b, &large_path_statics, x, f) == STATUS_OK);
    CHECK_NEAR(derivative_norm(count, f) / deformed, 0, tol_force);
    free(x);
}

#endif
