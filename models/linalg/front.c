#include "models/linalg/front.h"

#include "models/linalg/tile.h"
#include "models/linalg/tile_three.h"

/* Pivot tiles a panel: three of its tile rows (18 kB) and one more fit the first cache. */
enum { PANEL = 12 };

#define REAL       double
#define NAME(name) name
#include "models/linalg/front_kernel.h"
#undef REAL
#undef NAME
#define REAL       float
#define NAME(name) name##_single
#include "models/linalg/front_kernel.h"
#undef REAL
#undef NAME

void front_forward_three(int pivots, int tiles, const double *l, const double *pair,
                         double *x)
{
    for (int k = 0; k < pivots; k++) {
        tile_three_apply(pair + k * TILE_PAIR, x + k * BLOCK);
        tile_three_subtract(tiles - k - 1, l + TILE_SIZE, x + k * BLOCK,
                            x + (k + 1) * BLOCK);
        l += (ptrdiff_t)(tiles - k) * TILE_SIZE;
    }
}

void front_backward_three(int pivots, int tiles, const double *l, const double *pair,
                          double *x)
{
    ptrdiff_t all = (ptrdiff_t)pivots * tiles - (ptrdiff_t)pivots * (pivots - 1) / 2;
    l += all * TILE_SIZE;
    for (int k = pivots - 1; k >= 0; k--) {
        l -= (ptrdiff_t)(tiles - k) * TILE_SIZE;
        tile_three_subtract_transposed(tiles - k - 1, l + TILE_SIZE, x + (k + 1) * BLOCK,
                                       x + k * BLOCK);
        tile_three_apply(pair + k * TILE_PAIR + TILE_SIZE, x + k * BLOCK);
    }
}
