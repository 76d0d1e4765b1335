/* tile_three.h - inside factor.h: tiles against three right-hand sides at once (x, y and z
 * of a scalar system), so that L is read once for all three.
 *
 * A block is 24 numbers: eight rows of the first side, of the second, of the third; aligned
 * to 64 bytes. Division by a diagonal tile is a product with its inverse, which tile_invert
 * makes once: eight steps that wait for each other become none. Both the inverse and its
 * transpose are kept: TILE_PAIR numbers a diagonal tile.
 */
#ifndef TILE_THREE_H
#define TILE_THREE_H

#include <string.h>

#include "models/linalg/tile.h"

/* Eight rows; the compiler makes as many registers of it as the CPU needs. */
typedef double tile_line __attribute__((vector_size(TILE * sizeof(double)), may_alias));

enum { SIDES = 3, BLOCK = SIDES * TILE, TILE_PAIR = 2 * TILE_SIZE };

/* Returns the place of row i of the first side in blocks; the others follow TILE apart. */
static inline ptrdiff_t block_place(ptrdiff_t i)
{
    return (i & ~(ptrdiff_t)(TILE - 1)) * SIDES + (i & (TILE - 1)); /* i >= 0 */
}

/* Fills pair[TILE_PAIR]: l^-1, l^-T, column by column; inverse: reciprocals of l's
 * diagonal. */
static inline void tile_invert(const double *l, const double *inverse, double *pair)
{
    double *down = pair, *up = pair + TILE_SIZE;

    memset(pair, 0, TILE_PAIR * sizeof *pair);
    for (int j = 0; j < TILE; j++)
        for (int i = j; i < TILE; i++) {
            double sum = i == j;
            for (int k = j; k < i; k++)
                sum -= l[k * TILE + i] * down[j * TILE + k];
            down[j * TILE + i] = up[i * TILE + j] = sum * inverse[i];
        }
}

/* Adds a x[c] to y[c] on one tile and one block. */
TILE_INLINE void tile_three_product(const double *a, const double *x, tile_line y[SIDES])
{
#pragma GCC unroll 8
    for (int j = 0; j < TILE; j++) {
        const tile_line column = *(const tile_line *)(a + j * TILE);
#pragma GCC unroll 3
        for (int c = 0; c < SIDES; c++)
            y[c] += column * x[c * TILE + j];
    }
}

/* Computes x <- a x on one block. */
TILE_INLINE void tile_three_apply(const double *a, double *x)
{
    tile_line y[SIDES] = {{0}};
    tile_three_product(a, x, y);
#pragma GCC unroll 3
    for (int c = 0; c < SIDES; c++)
        *(tile_line *)(x + c * TILE) = y[c];
}

/* Subtracts a[t] x from y[t] for `pass` tiles (a constant): x is broadcast once for all of
 * them. */
TILE_INLINE void tile_three_subtract_pass(int pass, const double *a, const double *x,
                                          double *y)
{
    tile_line sum[2][SIDES] = {{{0}}};
#pragma GCC unroll 8
    for (int j = 0; j < TILE; j++)
#pragma GCC unroll 3
        for (int c = 0; c < SIDES; c++) {
            const double value = x[c * TILE + j];
#pragma GCC unroll 2
            for (int t = 0; t < pass; t++)
                sum[t][c] += *(const tile_line *)(a + t * TILE_SIZE + j * TILE) * value;
        }
#pragma GCC unroll 2
    for (int t = 0; t < pass; t++)
#pragma GCC unroll 3
        for (int c = 0; c < SIDES; c++)
            *(tile_line *)(y + t * BLOCK + c * TILE) -= sum[t][c];
}

/* Subtracts a x from y for `count` tiles one under the other; y[count * BLOCK], x[BLOCK].
 */
TILE_INLINE void tile_three_subtract(ptrdiff_t count, const double *a, const double *x,
                                     double *y)
{
    for (; count >= 2; count -= 2, a += 2 * TILE_SIZE, y += 2 * BLOCK)
        tile_three_subtract_pass(2, a, x, y);
    if (count)
        tile_three_subtract_pass(1, a, x, y);
}

/* Subtracts the sums of eight lines' lanes from x. */
TILE_INLINE void tile_subtract_lanes(const tile_line s[TILE], tile_line *x)
{
    tile_line two[4], four[2];
#pragma GCC unroll 4
    for (int k = 0; k < 4; k++)
        two[k] =
            __builtin_shufflevector(s[2 * k], s[2 * k + 1], 0, 8, 2, 10, 4, 12, 6, 14) +
            __builtin_shufflevector(s[2 * k], s[2 * k + 1], 1, 9, 3, 11, 5, 13, 7, 15);
#pragma GCC unroll 2
    for (int k = 0; k < 2; k++)
        four[k] =
            __builtin_shufflevector(two[2 * k], two[2 * k + 1], 0, 1, 8, 9, 4, 5, 12, 13) +
            __builtin_shufflevector(two[2 * k], two[2 * k + 1], 2, 3, 10, 11, 6, 7, 14, 15);
    *x -= __builtin_shufflevector(four[0], four[1], 0, 1, 2, 3, 8, 9, 10, 11) +
          __builtin_shufflevector(four[0], four[1], 4, 5, 6, 7, 12, 13, 14, 15);
}

/* Subtracts a^T y from x for `count` tiles one under the other. */
TILE_INLINE void tile_three_subtract_transposed(ptrdiff_t count, const double *a,
                                                const double *y, double *x)
{
    tile_line sum[SIDES][TILE];
#pragma GCC unroll 3
    for (int c = 0; c < SIDES; c++)
#pragma GCC unroll 8
        for (int j = 0; j < TILE; j++)
            sum[c][j] = (tile_line){0};
    for (ptrdiff_t t = 0; t < count; t++, a += TILE_SIZE, y += BLOCK) {
        const tile_line y0 = *(const tile_line *)y, y1 = *(const tile_line *)(y + TILE),
                        y2 = *(const tile_line *)(y + 2 * TILE);
#pragma GCC unroll 8
        for (int j = 0; j < TILE; j++) {
            const tile_line column = *(const tile_line *)(a + j * TILE);
            sum[0][j] += column * y0;
            sum[1][j] += column * y1;
            sum[2][j] += column * y2;
        }
    }
#pragma GCC unroll 3
    for (int c = 0; c < SIDES; c++)
        tile_subtract_lanes(sum[c], (tile_line *)(x + c * TILE));
}

#endif
