/* tile.h - inside factor.h: arithmetic on 8 x 8 tiles.
 *
 * A tile is 64 numbers, column by column, aligned to 64 bytes, so that one column is one
 * cache line. Factors are stored tile by tile: every kernel streams. A column is one
 * register with AVX-512, two with AVX, four with SSE2; loops over TILE_WORDS are unrolled
 * away. Includers are compiled with -ffp-contract=fast: here fused multiply-adds are half
 * the time.
 */
#ifndef TILE_H
#define TILE_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

enum { TILE = 8, TILE_SIZE = TILE * TILE };

/* What the accumulators of one pass may take: TILE_PASS tiles one under the other, of which
 * TILE_STRIP columns at a time: 24 of 32 registers with AVX-512, 8 of 16 without. */
enum { TILE_PASS_MAX = 3 };
#if defined(__AVX512F__)
enum { TILE_LANES = 8, TILE_PASS = TILE_PASS_MAX, TILE_STRIP = 8 };
#elif defined(__AVX__)
enum { TILE_LANES = 4, TILE_PASS = 1, TILE_STRIP = 4 };
#else
enum { TILE_LANES = 2, TILE_PASS = 1, TILE_STRIP = 2 };
#endif
enum { TILE_WORDS = TILE / TILE_LANES };

typedef double tile_word
    __attribute__((vector_size(TILE_LANES * sizeof(double)), may_alias));

/* Tiles in registers: word w of column j of tile r. */
typedef tile_word tile_registers[TILE_PASS_MAX][TILE][TILE_WORDS];

#define TILE_INLINE static inline __attribute__((always_inline))
#define TILE_UNROLL _Pragma("GCC unroll 8")

/* Tiles (row + r, k) lie at column[k] + (row + r) TILE_SIZE:
 * c[r] -= sum over k = from .. to - 1 of tile (row + r, k) tile (other, k)^T,
 * for `count` tiles r one under the other from `first` on (constants). */
TILE_INLINE void tile_update(int first, int count, tile_registers c, double *const *column,
                             ptrdiff_t row, ptrdiff_t other, int from, int to)
{
    TILE_UNROLL
    for (int strip = 0; strip < TILE; strip += TILE_STRIP)
        for (int k = from; k < to; k++) {
            const double *a = column[k] + row * TILE_SIZE;
            const double *b = column[k] + other * TILE_SIZE;
            TILE_UNROLL
            for (int l = 0; l < TILE; l++)
                TILE_UNROLL
            for (int r = first; r < first + count; r++)
                TILE_UNROLL
            for (int w = 0; w < TILE_WORDS; w++) {
                const tile_word left =
                    ((const tile_word *)(a + r * TILE_SIZE + l * TILE))[w];
                TILE_UNROLL
                for (int j = strip; j < strip + TILE_STRIP; j++)
                    c[r][j][w] -= left * b[l * TILE + j];
            }
        }
}

/* c[r] = c[r] l^-T: l lower triangular, `inverse` the reciprocals of its diagonal. */
TILE_INLINE void tile_divide(int count, tile_registers c, const double *l,
                             const double *inverse)
{
    TILE_UNROLL
    for (int r = 0; r < count; r++)
        TILE_UNROLL
    for (int j = 0; j < TILE; j++)
        TILE_UNROLL
    for (int w = 0; w < TILE_WORDS; w++) {
        c[r][j][w] *= inverse[j];
        TILE_UNROLL
        for (int i = j + 1; i < TILE; i++)
            c[r][i][w] -= c[r][j][w] * l[j * TILE + i];
    }
}

TILE_INLINE void tile_load(int count, const double *from, tile_registers c)
{
    TILE_UNROLL
    for (int r = 0; r < count; r++)
        TILE_UNROLL
    for (int j = 0; j < TILE; j++)
        TILE_UNROLL
    for (int w = 0; w < TILE_WORDS; w++)
        c[r][j][w] = ((const tile_word *)(from + r * TILE_SIZE + j * TILE))[w];
}

TILE_INLINE void tile_store(int count, tile_registers c, double *to)
{
    TILE_UNROLL
    for (int r = 0; r < count; r++)
        TILE_UNROLL
    for (int j = 0; j < TILE; j++)
        TILE_UNROLL
    for (int w = 0; w < TILE_WORDS; w++)
        ((tile_word *)(to + r * TILE_SIZE + j * TILE))[w] = c[r][j][w];
}

/* y -= a x on one column. */
TILE_INLINE void tile_column(const double *a, double x, double *y)
{
    TILE_UNROLL
    for (int w = 0; w < TILE_WORDS; w++)
        ((tile_word *)y)[w] -= ((const tile_word *)a)[w] * x;
}

/* Cholesky of one tile in place: lower triangle read, L written over it, zeros above.
 * inverse[TILE]: reciprocals of the diagonal. False if not positive definite or not finite.
 */
TILE_INLINE bool tile_cholesky(double *a, double *inverse)
{
    for (int j = 0; j < TILE; j++) {
        double pivot = a[j * TILE + j];
        if (!(pivot > 0.0 && pivot < INFINITY))
            return false;
        double root = sqrt(pivot);
        inverse[j] = 1.0 / root;
        for (int i = 0; i < TILE; i++)
            a[j * TILE + i] = i < j ? 0.0 : a[j * TILE + i] * inverse[j];
        a[j * TILE + j] = root;
        for (int k = j + 1; k < TILE; k++)
            tile_column(a + j * TILE, a[j * TILE + k], a + k * TILE);
    }
    return true;
}

/* x = l^-1 x on one tile: number by number, where the chain of operations is shortest. */
TILE_INLINE void tile_forward(const double *l, const double *inverse, double *x)
{
    double value[TILE];
    TILE_UNROLL
    for (int j = 0; j < TILE; j++)
        value[j] = x[j];
    TILE_UNROLL
    for (int j = 0; j < TILE; j++) {
        value[j] *= inverse[j];
        TILE_UNROLL
        for (int i = j + 1; i < TILE; i++)
            value[i] -= l[j * TILE + i] * value[j];
    }
    TILE_UNROLL
    for (int j = 0; j < TILE; j++)
        x[j] = value[j];
}

/* x = l^-T x on one tile. */
TILE_INLINE void tile_backward(const double *l, const double *inverse, double *x)
{
    double value[TILE];
    TILE_UNROLL
    for (int j = 0; j < TILE; j++)
        value[j] = x[j];
    TILE_UNROLL
    for (int j = TILE - 1; j >= 0; j--) {
        value[j] *= inverse[j];
        TILE_UNROLL
        for (int i = 0; i < j; i++)
            value[i] -= l[i * TILE + j] * value[j];
    }
    TILE_UNROLL
    for (int j = 0; j < TILE; j++)
        x[j] = value[j];
}

/* y -= a x for `count` tiles one under the other; y[count * TILE]. */
TILE_INLINE void tile_subtract(ptrdiff_t count, const double *a, const double *x, double *y)
{
    for (ptrdiff_t t = 0; t < count; t++)
        TILE_UNROLL
    for (int w = 0; w < TILE_WORDS; w++) {
        const tile_word *left = (const tile_word *)(a + t * TILE_SIZE) + w;
        tile_word *sum = (tile_word *)(y + t * TILE) + w;
        tile_word even = *sum, odd = {0};
        TILE_UNROLL
        for (int j = 0; j < TILE; j += 2) {
            even -= left[j * TILE_WORDS] * x[j];
            odd -= left[(j + 1) * TILE_WORDS] * x[j + 1];
        }
        *sum = even + odd;
    }
}

/* x -= a^T y for `count` tiles one under the other. */
TILE_INLINE void tile_subtract_transposed(ptrdiff_t count, const double *a, const double *y,
                                          double *x)
{
    tile_word sum[TILE] = {{0}};
    for (ptrdiff_t t = 0; t < count; t++)
        TILE_UNROLL
    for (int w = 0; w < TILE_WORDS; w++) {
        const tile_word right = ((const tile_word *)(y + t * TILE))[w];
        TILE_UNROLL
        for (int j = 0; j < TILE; j++)
            sum[j] += ((const tile_word *)(a + t * TILE_SIZE + j * TILE))[w] * right;
    }
    for (int j = 0; j < TILE; j++) { /* lanes pairwise */
        union {
            tile_word word;
            double lane[TILE_LANES];
        } total = {.word = sum[j]};
        for (int half = TILE_LANES / 2; half > 0; half /= 2)
            for (int i = 0; i < half; i++)
                total.lane[i] += total.lane[i + half];
        x[j] -= total.lane[0];
    }
}

#endif
