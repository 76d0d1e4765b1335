/* solid_outer.h - sums of outer products of rows over functions, the kernel of every
 * element stiffness. For files compiled with -ffp-contract=fast. */
#ifndef SOLID_OUTER_H
#define SOLID_OUTER_H

#include <stddef.h>

#include "models/solid/solid_space.h"

typedef double solid_lanes __attribute__((vector_size(SOLID_LANES * sizeof(double))));

/* Rows a and a + 1, four columns from `first` on: two rows share the loads of g. */
static inline void solid_outer_rows(int padded, int points, const double *w,
                                    const double *g, double *H, int a, int first)
{
    size_t stride = 3 * (size_t)padded;
    solid_lanes s[9] = {{0}}, r[9] = {{0}};

    w += a, g += first, H += (size_t)a * 9 * (size_t)padded + (size_t)first;
    for (int q = 0; q < points; q++, w += stride, g += stride) {
        solid_lanes g0 = *(const solid_lanes *)g, g1 = *(const solid_lanes *)(g + padded),
                    g2 = *(const solid_lanes *)(g + 2 * padded);
        const double *w1 = w + padded, *w2 = w + 2 * padded;
        s[0] += w[0] * g0, s[1] += w[0] * g1, s[2] += w[0] * g2;
        s[3] += w1[0] * g0, s[4] += w1[0] * g1, s[5] += w1[0] * g2;
        s[6] += w2[0] * g0, s[7] += w2[0] * g1, s[8] += w2[0] * g2;
        r[0] += w[1] * g0, r[1] += w[1] * g1, r[2] += w[1] * g2;
        r[3] += w1[1] * g0, r[4] += w1[1] * g1, r[5] += w1[1] * g2;
        r[6] += w2[1] * g0, r[7] += w2[1] * g1, r[8] += w2[1] * g2;
    }
    for (int n = 0; n < 9; n++) {
        *(solid_lanes *)(H + n * padded) = s[n];
        *(solid_lanes *)(H + (9 + n) * padded) = r[n];
    }
}

/* Computes H[a][3 i + j][b] = sum over points of w[.][i][a] g[.][j][b], for a < columns and
 * b >= a; H has room for an even number of columns. */
static inline void solid_outer(int columns, int padded, int points, const double *w,
                               const double *g, double *H)
{
    for (int a = 0; a < columns; a += 2)
        for (int b = a / SOLID_LANES * SOLID_LANES; b < padded; b += SOLID_LANES)
            solid_outer_rows(padded, points, w, g, H, a, b);
}

#endif
