/* front.h - inside factor.h: partial Cholesky of one dense front, in tiles (tile.h).
 *
 * A front is a lower triangle of tiles x tiles tiles: the first `pivots` columns of tiles
 * are factored, the rest (the update, for the parent) gets minus their product. Tile (i,j),
 * i >= j, lies at column[j] + i * TILE_SIZE. Tiles on the diagonal hold anything above it.
 */
#ifndef FRONT_H
#define FRONT_H

#include <stdbool.h>
#include <stddef.h>

struct front {
    int pivots, tiles;
    void **column; /* [tiles] to doubles, or floats                                    */
    void *inverse; /* [pivots * 8] reciprocals of the diagonal of L, written           */
};

/* Factors a front; false if it is not positive definite or not finite. */
bool front_factor(const struct front *front);

/* Adds the update of a child, rows x rows: its row r goes to row i of the front, where
 * place[r] = i / 8 * 64 + i % 8, ascending. update: tile column after tile column, each
 * from its diagonal tile down. */
void front_add(const struct front *front, const double *update, int rows, const int *place);

/* Sweep with L, stored as tile column after tile column, each from its diagonal. x[tiles *
 * 8], 64-byte aligned: pivots first. Forward: pivots x1 = L11^-1 x1, then rest x2 -= L21
 * x1. Backward: x1 = L11^-T (x1 - L21^T x2). */
void front_forward(int pivots, int tiles, const double *l, const double *inverse,
                   double *x);
void front_backward(int pivots, int tiles, const double *l, const double *inverse,
                    double *x);

/* Do the same in single precision; x is 32-byte aligned. */
bool front_factor_single(const struct front *front);
void front_add_single(const struct front *front, const float *update, int rows,
                      const int *place);
void front_forward_single(int pivots, int tiles, const float *l, const float *inverse,
                          float *x);
void front_backward_single(int pivots, int tiles, const float *l, const float *inverse,
                           float *x);

/* Sweep for three sides: x in blocks (tile_three.h), pair: inverse diagonal tiles of the
 * pivots, TILE_PAIR each. */
void front_forward_three(int pivots, int tiles, const double *l, const double *pair,
                         double *x);
void front_backward_three(int pivots, int tiles, const double *l, const double *pair,
                          double *x);

#endif
