/* tile.h - inside factor.h: arithmetic on 8 x 8 tiles.
 *
 * A tile is 64 numbers, column by column, aligned to 64 bytes: one column is one cache line
 * and one AVX-512 register (the compiler makes two AVX or four SSE registers of it where
 * there is no AVX-512). Factors are stored tile by tile, so that every kernel streams.
 * Includers are compiled with -ffp-contract=fast: here fused multiply-adds are half the time.
 */
#ifndef TILE_H
#define TILE_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

enum { TILE = 8, TILE_SIZE = TILE * TILE };

/* Tiles that one pass holds in registers: 24 accumulators of 32 with AVX-512. */
enum { TILE_PASS_MAX = 3 };
#ifdef __AVX512F__
enum { TILE_PASS = TILE_PASS_MAX };
#else
enum { TILE_PASS = 1 };
#endif

typedef double tile_column __attribute__((vector_size(TILE * sizeof(double)), may_alias));

#define TILE_INLINE static inline __attribute__((always_inline))

/* c[r] -= a[r] b^T for `count` tiles r one under the other (count 1..TILE_PASS_MAX, a constant). */
TILE_INLINE void tile_update(int count, tile_column c[][TILE], const double *a,
                             const double *b)
{
#pragma GCC unroll 8
    for (int k = 0; k < TILE; k++)
#pragma GCC unroll 3
        for (int r = 0; r < count; r++) {
            const tile_column left = *(const tile_column *)(a + r * TILE_SIZE + k * TILE);
#pragma GCC unroll 8
            for (int j = 0; j < TILE; j++)
                c[r][j] -= left * b[k * TILE + j];
        }
}

/* c[r] = c[r] l^-T: l lower triangular, `inverse` the reciprocals of its diagonal. */
TILE_INLINE void tile_divide(int count, tile_column c[][TILE], const double *l,
                             const double *inverse)
{
#pragma GCC unroll 3
    for (int r = 0; r < count; r++)
#pragma GCC unroll 8
        for (int j = 0; j < TILE; j++) {
            c[r][j] *= inverse[j];
#pragma GCC unroll 8
            for (int i = j + 1; i < TILE; i++)
                c[r][i] -= c[r][j] * l[j * TILE + i];
        }
}

TILE_INLINE void tile_load(int count, const double *from, tile_column c[][TILE])
{
#pragma GCC unroll 3
    for (int r = 0; r < count; r++)
#pragma GCC unroll 8
        for (int j = 0; j < TILE; j++)
            c[r][j] = *(const tile_column *)(from + r * TILE_SIZE + j * TILE);
}

TILE_INLINE void tile_store(int count, tile_column c[][TILE], double *to)
{
#pragma GCC unroll 3
    for (int r = 0; r < count; r++)
#pragma GCC unroll 8
        for (int j = 0; j < TILE; j++)
            *(tile_column *)(to + r * TILE_SIZE + j * TILE) = c[r][j];
}

/* Cholesky of one tile in place: lower triangle read, L written over it, zeros above.
 * inverse[TILE]: reciprocals of the diagonal. False if not positive definite or not finite. */
TILE_INLINE bool tile_cholesky(double *a, double *inverse)
{
    for (int j = 0; j < TILE; j++) {
        double pivot = a[j * TILE + j];
        if (!(pivot > 0.0 && pivot < INFINITY))
            return false;
        double root = sqrt(pivot);
        inverse[j] = 1.0 / root;
        tile_column *column = (tile_column *)(a + j * TILE);
        *column *= inverse[j];
        for (int i = 0; i < j; i++)
            a[j * TILE + i] = 0.0;
        a[j * TILE + j] = root;
        for (int k = j + 1; k < TILE; k++)
            *(tile_column *)(a + k * TILE) -= *column * a[j * TILE + k];
    }
    return true;
}

/* x = l^-1 x on one tile. */
TILE_INLINE void tile_forward(const double *l, const double *inverse, double *x)
{
    tile_column rest = *(tile_column *)x;
#pragma GCC unroll 8
    for (int j = 0; j < TILE; j++) {
        double value = rest[j] * inverse[j];
        rest -= *(const tile_column *)(l + j * TILE) * value; /* zeros above the diagonal */
        x[j] = value;
    }
}

/* x = l^-T x on one tile. */
TILE_INLINE void tile_backward(const double *l, const double *inverse, double *x)
{
#pragma GCC unroll 8
    for (int j = TILE - 1; j >= 0; j--) {
        double value = x[j] * inverse[j];
        x[j] = value;
#pragma GCC unroll 8
        for (int i = 0; i < j; i++)
            x[i] -= l[i * TILE + j] * value;
    }
}

/* y -= a x for `count` tiles one under the other; y[count * TILE]. */
TILE_INLINE void tile_subtract(ptrdiff_t count, const double *a, const double *x, double *y)
{
    for (ptrdiff_t t = 0; t < count; t++) {
        tile_column even = *(const tile_column *)(y + t * TILE), odd = {0};
#pragma GCC unroll 4
        for (int j = 0; j < TILE; j += 2) {
            even -= *(const tile_column *)(a + t * TILE_SIZE + j * TILE) * x[j];
            odd -= *(const tile_column *)(a + t * TILE_SIZE + (j + 1) * TILE) * x[j + 1];
        }
        *(tile_column *)(y + t * TILE) = even + odd;
    }
}

/* x -= a^T y for `count` tiles one under the other. */
TILE_INLINE void tile_subtract_transposed(ptrdiff_t count, const double *a, const double *y,
                                          double *x)
{
    tile_column sum[TILE] = {{0}};
    for (ptrdiff_t t = 0; t < count; t++) {
        const tile_column right = *(const tile_column *)(y + t * TILE);
#pragma GCC unroll 8
        for (int j = 0; j < TILE; j++)
            sum[j] += *(const tile_column *)(a + t * TILE_SIZE + j * TILE) * right;
    }
    for (int j = 0; j < TILE; j++) {
        const tile_column s = sum[j];
        x[j] -= ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
    }
}

#endif
