#include "models/linalg/front.h"

#include "models/linalg/tile.h"
#include "models/linalg/tile_three.h"

/* Pivot tiles a panel: three tile rows of it (18 kB) and one more stay in the first cache.
 */
enum { PANEL = 12 };

/* Tiles (row .. row + count - 1, column) of L, with updates from panel tiles from ..
 * column. */
TILE_INLINE void finish(const struct front *f, int count, int row, int column, int from)
{
    tile_registers c;
    double *target = f->column[column] + (ptrdiff_t)row * TILE_SIZE;
    const double *diagonal = f->column[column] + (ptrdiff_t)column * TILE_SIZE;
    tile_load(count, target, c);
    tile_update(0, count, c, f->column, row, column, from, column);
    tile_divide(count, c, diagonal, f->inverse + column * TILE);
    tile_store(count, c, target);
}

/* Tiles (row .. row + count - 1, column) minus their product over the panel from .. to. */
TILE_INLINE void update(const struct front *f, int count, int row, int column, int from,
                        int to)
{
    tile_registers c;
    double *target = f->column[column] + (ptrdiff_t)row * TILE_SIZE;
    tile_load(count, target, c);
    tile_update(0, count, c, f->column, row, column, from, to);
    tile_store(count, c, target);
}

static bool factor_panel_diagonal(const struct front *f, int from, int to)
{
    for (int k = from; k < to; k++) {
        update(f, 1, k, k, from, k);
        if (!tile_cholesky(f->column[k] + (ptrdiff_t)k * TILE_SIZE, f->inverse + k * TILE))
            return false;
        for (int row = k + 1; row < to; row++)
            finish(f, 1, row, k, from);
    }
    return true;
}

/* Rows row .. row + count - 1 of the panel, then of everything right of it. */
TILE_INLINE void sweep_rows(const struct front *f, int count, int row, int from, int to)
{
    for (int k = from; k < to; k++)
        finish(f, count, row, k, from);
    for (int column = to; column <= row; column++)
        update(f, count, row, column, from, to);
    for (int column = row + 1; column < row + count; column++)
        for (int r = column; r < row + count; r++)
            update(f, 1, r, column, from, to);
}

bool front_factor(const struct front *f)
{
    for (int from = 0; from < f->pivots; from += PANEL) {
        int to = from + PANEL < f->pivots ? from + PANEL : f->pivots, row = to;
        if (!factor_panel_diagonal(f, from, to))
            return false;
        for (; row + TILE_PASS <= f->tiles; row += TILE_PASS)
            sweep_rows(f, TILE_PASS, row, from, to);
        for (; row < f->tiles; row++)
            sweep_rows(f, 1, row, from, to);
    }
    return true;
}

/* target[place[r]] += source[r] for the rows of one tile; `first` cuts off rows above it.
 */
TILE_INLINE void add_rows(double *target, const double *source, const int *place, int first,
                          int rows)
{
    for (int r = first; r < rows; r++)
        target[place[r]] += source[r];
}

void front_add(const struct front *f, const double *from, int rows, const int *place)
{
    int tiles = (rows + TILE - 1) / TILE, whole = rows / TILE;
    for (int c = 0; c < rows; c++) {
        int tile = c / TILE;
        const double *source = from + c % TILE * TILE;
        double *target = f->column[place[c] / TILE_SIZE] + place[c] % TILE * TILE;
        const int *to = place + tile * TILE;
        add_rows(target, source, to, c % TILE, tile < whole ? TILE : rows % TILE);
        for (int t = tile + 1; t < whole; t++) {
            source += TILE_SIZE;
            to += TILE;
            if (to[TILE - 1] - to[0] == TILE - 1 && to[0] % TILE == 0)
                tile_column(source, -1.0, target + to[0]);
            else
#pragma GCC unroll 8
                for (int r = 0; r < TILE; r++)
                    target[to[r]] += source[r];
        }
        if (tile < whole && whole < tiles)
            add_rows(target, source + TILE_SIZE, to + TILE, 0, rows % TILE);
        if (c % TILE == TILE - 1)
            from += (ptrdiff_t)(tiles - tile) * TILE_SIZE;
    }
}

void front_forward(int pivots, int tiles, const double *l, const double *inverse, double *x)
{
    for (int k = 0; k < pivots; k++) {
        tile_forward(l, inverse + k * TILE, x + k * TILE);
        tile_subtract(tiles - k - 1, l + TILE_SIZE, x + k * TILE, x + (k + 1) * TILE);
        l += (ptrdiff_t)(tiles - k) * TILE_SIZE;
    }
}

void front_backward(int pivots, int tiles, const double *l, const double *inverse,
                    double *x)
{
    ptrdiff_t all = (ptrdiff_t)pivots * tiles - (ptrdiff_t)pivots * (pivots - 1) / 2;
    l += all * TILE_SIZE;
    for (int k = pivots - 1; k >= 0; k--) {
        l -= (ptrdiff_t)(tiles - k) * TILE_SIZE;
        tile_subtract_transposed(tiles - k - 1, l + TILE_SIZE, x + (k + 1) * TILE,
                                 x + k * TILE);
        tile_backward(l, inverse + k * TILE, x + k * TILE);
    }
}

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
