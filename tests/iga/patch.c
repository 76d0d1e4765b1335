/* The solid: local numbering, rational functions, gradients against differences, and points
 * found back. (Affine boxes: nonuniform.c.) */
#include "iga/patch.h"
#include "tests/check.h"
#include "tests/spline_fixture.h"

#include <float.h>

/* Three univariate factors at 8 eps each (see tests/iga/bspline.c), sums over up to 216
 * positive terms that add to 1: about 2 sqrt(216) / 2 eps more. */
#define TOL_SUM (40 * DBL_EPSILON)
/* The same, with derivative factors: terms up to 2 p / (knot distance) = 250 times the sum,
 * and never more than 250 * 40 eps; stated relative to that scale. */
#define TOL_GRADIENT_SUM (250 * TOL_SUM)
/* Central difference with relative truncation c t^2 and round-off 40 eps / t; c is 1120 for
 * one polynomial of degree 5 (tests/iga/bspline.c) and, for a quotient by weights in [0.5,
 * 2), up to (1 + W'/W)^3 with W' / W <= 4 more: about 1e5. Best at t = 4e-7: 1.6e-8
 * + 2.2e-8.
 */
#define TOL_DIFFERENCE 4e-8
/* Newton's last residual is below this part of the size; parameters follow within it times
 * the inverse Jacobian, <= 8 for the shapes here. */
#define TOL_RESIDUAL  1e-13
#define TOL_PARAMETER (8 * TOL_RESIDUAL)

enum { SAMPLES = 50 };

static void random_uvw(uint64_t *state, double uvw[3])
{
    for (int d = 0; d < 3; d++)
        uvw[d] = random_unit(state);
}

/* A node is alive at a point iff all three univariate functions are on the span; summing
 * them over the whole net in global order must give the same numbers and the same order. */
static void check_local_nodes(const struct patch *patch, uint64_t *state)
{
    const struct bspline *b = patch->basis;
    int span[3], node[PATCH_MAX_LOCAL], local = patch_local(patch), next = 0;
    double uvw[3], R[PATCH_MAX_LOCAL], N[3][BSPLINE_MAX_ORDER], sum = 0.0;

    random_uvw(state, uvw);
    patch_basis(patch, uvw, span, R, NULL);
    patch_local_nodes(patch, span, node);
    for (int d = 0; d < 3; d++) {
        CHECK(span[d] == bspline_span(&b[d], uvw[d]));
        bspline_eval(&b[d], span[d], uvw[d], 0, N[d]);
    }
    for (int pass = 0; pass < 2; pass++) /* first the denominator, then the comparison */
        for (int global = 0; global < patch_nodes(patch); global++) {
            int index[3] = {global / (b[1].n * b[2].n), global / b[2].n % b[1].n,
                            global % b[2].n};
            double product = patch->weight ? patch->weight[global] : 1.0;
            bool alive = true;
            for (int d = 0; d < 3; d++) {
                int a = index[d] - span[d] + b[d].p;
                alive = alive && a >= 0 && a <= b[d].p;
                product *= alive ? N[d][a] : 0.0;
            }
            if (!alive)
                continue;
            if (pass == 0) {
                sum += product;
            } else if (CHECK(next < local && node[next] == global)) {
                CHECK_NEAR(R[next], product / sum, TOL_SUM);
                next++;
            }
        }
    CHECK(next == local);
}

static void check_sums(const struct patch *patch, uint64_t *state)
{
    int span[3], local = patch_local(patch);
    double uvw[3], R[PATCH_MAX_LOCAL], dR[3 * PATCH_MAX_LOCAL], alone[3 * PATCH_MAX_LOCAL];
    double sum = 0.0;

    random_uvw(state, uvw);
    patch_basis(patch, uvw, span, R, dR);
    patch_basis(patch, uvw, span, NULL, alone);
    CHECK(!memcmp(dR, alone, (size_t)(3 * local) * sizeof *dR));
    for (int a = 0; a < local; a++) {
        CHECK(R[a] >= 0.0);
        sum += R[a];
    }
    CHECK_NEAR(sum, 1.0, TOL_SUM);
    for (int d = 0; d < 3; d++) {
        double slope = 0.0;
        for (int a = 0; a < local; a++)
            slope += dR[d * local + a];
        CHECK_NEAR(slope, 0.0, TOL_GRADIENT_SUM);
    }
}

/* Functions and map in one direction; the best of a sweep of steps inside the element. */
static void check_gradient(const struct patch *patch, int d, uint64_t *state)
{
    int span[3], local = patch_local(patch);
    double uvw[3], R[2][PATCH_MAX_LOCAL], dR[3 * PATCH_MAX_LOCAL], x[2][3], y[3], J[3][3];
    double width, best = INFINITY, best_map = INFINITY;

    random_uvw(state, uvw);
    span[d] = bspline_span(&patch->basis[d], uvw[d]);
    width = patch->basis[d].U[span[d] + 1] - patch->basis[d].U[span[d]];
    uvw[d] = patch->basis[d].U[span[d]] + 0.4 * width;
    patch_basis(patch, uvw, span, NULL, dR);
    patch_point(patch, uvw, y, J);
    for (int k = 2; k <= 30; k++) {
        double moved[3] = {uvw[0], uvw[1], uvw[2]}, end[2], error = 0.0, error_map = 0.0;
        for (int side = 0; side < 2; side++) {
            moved[d] = end[side] = uvw[d] + (side ? 1 : -1) * ldexp(width, -k);
            patch_basis(patch, moved, span, R[side], NULL);
            patch_point(patch, moved, x[side], NULL);
        }
        for (int a = 0; a < local; a++) {
            double slope = (R[1][a] - R[0][a]) / (end[1] - end[0]);
            error = fmax(error, fabs(slope - dR[d * local + a]));
        }
        for (int i = 0; i < 3; i++)
            error_map =
                fmax(error_map, fabs((x[1][i] - x[0][i]) / (end[1] - end[0]) - J[i][d]));
        best = fmin(best, error * width);
        best_map = fmin(best_map, error_map * width);
    }
    CHECK_NEAR(best, 0.0, TOL_DIFFERENCE);
    CHECK_NEAR(best_map, 0.0, TOL_DIFFERENCE); /* the net's size is 1 */
}

/* `steepest` bounds the inverse of the Jacobian. */
static void check_inverse(const struct patch *patch, double steepest)
{
    uint64_t state = 4;

    for (int s = 0; s < SAMPLES; s++) {
        double want[3], x[3], y[3], uvw[3] = {0.5, 0.5, 0.5};
        random_uvw(&state, want);
        if (s < 8) /* the corners */
            for (int d = 0; d < 3; d++)
                want[d] = s >> d & 1;
        patch_point(patch, want, x, NULL);
        CHECK(patch_invert(patch, x, TOL_RESIDUAL, uvw) == STATUS_OK);
        patch_point(patch, uvw, y, NULL);
        for (int d = 0; d < 3; d++) {
            CHECK(uvw[d] >= 0.0 && uvw[d] <= 1.0);
            CHECK_NEAR(y[d], x[d], TOL_RESIDUAL);
            CHECK_NEAR(uvw[d], want[d], steepest * TOL_RESIDUAL);
        }
    }
}

static void check_inverses(void)
{
    static const double origin[3] = {0};
    static const double skewed[3][3] = {{1, 0.2, 0}, {0.5, 1, 0.1}, {0.1, 0.3, 0.8}};
    static const double thin[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1e-3}};
    static const int degree[3] = {3, 2, 1};
    uint64_t state = 5;
    struct patch patch = {0};
    double uvw[3] = {7, -7, 0.5}, x[3];

    random_patch(&state, degree, 0.0, false, &patch);
    patch_set_box(&patch, origin, thin[0], thin[1], thin[2]);
    check_inverse(&patch, 1.1e3);
    patch_set_box(&patch, origin, skewed[0], skewed[1], skewed[2]);
    check_inverse(&patch, 4.0);
    /* A start outside is brought inside; a point outside, or none, has no parameters. */
    patch_point(&patch, (double[]){0.2, 0.4, 0.6}, x, NULL);
    CHECK(patch_invert(&patch, x, TOL_RESIDUAL, uvw) == STATUS_OK);
    x[2] += 5.0;
    CHECK(patch_invert(&patch, x, TOL_RESIDUAL, uvw) == STATUS_DIVERGED);
    CHECK(uvw[2] == 1.0); /* stopped at the face */
    x[2] = NAN;
    CHECK(patch_invert(&patch, x, TOL_RESIDUAL, uvw) == STATUS_DIVERGED);
    patch_clear(&patch);
    quarter_annulus(0.5, 1.0, 0.5, &patch);
    check_inverse(&patch, 4.0);
    patch_clear(&patch);
    for (int i = 0; i < 5; i++) {
        random_patch(&state, degree, 0.4, true, &patch);
        check_inverse(&patch, 8.0);
        patch_clear(&patch);
    }
}

int main(void)
{
    uint64_t state = 1;

    for (int i = 0; i < 40; i++) {
        int degree[3];
        struct patch patch = {0};
        for (int d = 0; d < 3; d++)
            degree[d] =
                i < 2 ? BSPLINE_MAX_DEGREE : random_int(&state, 1, BSPLINE_MAX_DEGREE);
        random_patch(&state, degree, 0.5, i % 2, &patch);
        check_local_nodes(&patch, &state);
        for (int s = 0; s < 10; s++)
            check_sums(&patch, &state);
        for (int d = 0; d < 3; d++)
            check_gradient(&patch, d, &state);
        patch_clear(&patch);
    }
    check_inverses();
    return check_result();
}
