/* spline_fixture.h - random knots and patches for tests, the same on every run. */
#ifndef SPLINE_FIXTURE_H
#define SPLINE_FIXTURE_H

#include "iga/patch.h"
#include "tests/check.h"

#include <stdint.h>

/* Uniform in [0,1) (splitmix64, Steele et al. 2014, public domain constants). */
static inline double random_unit(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

static inline int random_int(uint64_t *state, int low, int high) /* both included */
{
    return low + (int)(random_unit(state) * (high - low + 1));
}

/* Up to four inner knots, at least 0.04 apart, each of multiplicity 1..p. */
static inline void random_bspline(uint64_t *state, int p, struct bspline *b)
{
    double U[2 * BSPLINE_MAX_ORDER + 4 * BSPLINE_MAX_DEGREE];
    int count = 0, inner = random_int(state, 0, 4);

    for (int i = 0; i <= p; i++)
        U[count++] = 0.0;
    for (int i = 0; i < inner; i++) {
        double u = (i + 0.1 + 0.8 * random_unit(state)) / inner;
        for (int m = random_int(state, 1, p); m > 0; m--)
            U[count++] = u;
    }
    for (int i = 0; i <= p; i++)
        U[count++] = 1.0;
    REQUIRE(bspline_init(b, p, count, U, NULL) == STATUS_OK);
}

/* A unit box whose control points are shaken by up to `shake` of the distance between
 * neighbours; weights, if wanted, in [0.5, 2). Degrees p[3]. */
static inline void random_patch(uint64_t *state, const int p[3], double shake,
                                bool rational, struct patch *patch)
{
    static const double origin[3], edge[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    struct bspline basis[3];
    int nodes;

    for (int d = 0; d < 3; d++)
        random_bspline(state, p[d], &basis[d]);
    REQUIRE(patch_init(patch, basis) == STATUS_OK);
    patch_set_box(patch, origin, edge[0], edge[1], edge[2]);
    nodes = patch_nodes(patch);
    for (int i = 0; i < 3 * nodes; i++)
        patch->point[i] += shake * (random_unit(state) - 0.5) / basis[i % 3].n;
    if (rational) {
        patch->weight = malloc((size_t)nodes * sizeof *patch->weight);
        REQUIRE(patch->weight);
        for (int i = 0; i < nodes; i++)
            patch->weight[i] = 0.5 * pow(4.0, random_unit(state));
    }
    for (int d = 0; d < 3; d++)
        bspline_clear(&basis[d]);
}

/* Quarter of a hollow cylinder: u the angle (exact circle), v the radius, w the height. */
static inline void quarter_annulus(double inner, double outer, double height,
                                   struct patch *patch)
{
    static const double corner[3][2] = {{1, 0}, {1, 1}, {0, 1}};
    struct bspline basis[3];
    double *x;

    for (int d = 0; d < 3; d++)
        REQUIRE(bspline_init_uniform(&basis[d], d ? 1 : 2, d ? 2 : 3, NULL) == STATUS_OK);
    REQUIRE(patch_init(patch, basis) == STATUS_OK);
    x = patch->point;
    patch->weight = malloc((size_t)patch_nodes(patch) * sizeof *patch->weight);
    REQUIRE(patch->weight);
    for (int i = 0; i < 12; i++, x += 3) {
        double radius = i / 2 % 2 ? outer : inner;
        x[0] = corner[i / 4][0] * radius;
        x[1] = corner[i / 4][1] * radius;
        x[2] = i % 2 ? height : 0.0;
        patch->weight[i] = i / 4 == 1 ? sqrt(0.5) : 1.0;
    }
    for (int d = 0; d < 3; d++)
        bspline_clear(&basis[d]);
}

#endif
