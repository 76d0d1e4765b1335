/* shell_fixture.h - shells for tests at library level: flat and curved surfaces with any
 * degrees and weights, moved control points, numbers that look random. */
#ifndef SHELL_FIXTURE_H
#define SHELL_FIXTURE_H

#include "shell_ref/shell_assembly.h"
#include "tests/check.h"

/* Uniform in [-1, 1], the same every run. */
static inline double shell_random(unsigned long long *state)
{
    *state = *state * 6364136223846793005ULL + 1442695040888963407ULL;
    return (double)(*state >> 11) / 4503599627370496.0 - 1.0;
}

static inline void shell_bases(struct bspline basis[2], int p, int n, int q, int m)
{
    REQUIRE(bspline_init_uniform(&basis[0], p, n, NULL) == STATUS_OK);
    REQUIRE(bspline_init_uniform(&basis[1], q, m, NULL) == STATUS_OK);
}

/* A sheet 1.3 m x 0.9 m, bent, twisted and skewed, with weights if wanted. */
static inline void shell_curved(struct shell_space *space, int p, int n, int q, int m,
                                bool weights, bool selective)
{
    struct bspline basis[2];
    struct message why = {{0}};
    const int gauss[2] = {0, 0};
    unsigned long long seed = 7;

    shell_bases(basis, p, n, q, m);
    double *point = malloc(3 * (size_t)(n * m) * sizeof *point);
    double *weight = malloc((size_t)(n * m) * sizeof *weight);
    REQUIRE(point && weight);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < m; j++) {
            double u = bspline_greville(&basis[0], i), v = bspline_greville(&basis[1], j);
            double *x = point + 3 * (i * m + j);
            x[0] = 1.3 * u + 0.2 * v;
            x[1] = 0.9 * v - 0.1 * u * u;
            x[2] = 0.3 * u * u - 0.2 * u * v + 0.1 * v * v;
            weight[i * m + j] = 1 + 0.3 * shell_random(&seed);
        }
    CHECK_SAY(shell_space_init(space, basis, point, weights ? weight : NULL, gauss,
                               selective, &why) == STATUS_OK,
              "%s", why.text);
    bspline_clear(&basis[0]);
    bspline_clear(&basis[1]);
    free(point);
    free(weight);
}

/* x = control points at rest, each moved by up to `size` [m]. */
static inline double *shell_moved(const struct shell_space *space, double size,
                                  unsigned long long seed)
{
    size_t count = 3 * (size_t)space->nodes;
    double *x = malloc(count * sizeof *x);
    REQUIRE(x);
    for (size_t t = 0; t < count; t++)
        x[t] = space->rest[t] + size * shell_random(&seed);
    return x;
}

#endif
