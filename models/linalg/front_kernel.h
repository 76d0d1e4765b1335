/* front_kernel.h - factor_supernodal.c's arithmetic on one dense front, for one kind of
 * REAL: included once for each, with NAME(x) as in tile_kernel.h. */

#define COLUMN  ((REAL *const *)f->column)
#define INVERSE ((REAL *)f->inverse)

/* Finishes tiles (row .. row + count - 1, column) of L, updated by panel tiles from ..
 * column. */
TILE_INLINE void NAME(finish)(const struct front *f, int count, int row, int column,
                              int from)
{
    NAME(tile_registers) c;
    REAL *target = COLUMN[column] + (ptrdiff_t)row * TILE_SIZE;
    const REAL *diagonal = COLUMN[column] + (ptrdiff_t)column * TILE_SIZE;
    NAME(tile_load)(count, target, c);
    NAME(tile_update)(0, count, c, COLUMN, row, column, from, column);
    NAME(tile_divide)(count, c, diagonal, INVERSE + column * TILE);
    NAME(tile_store)(count, c, target);
}

/* Subtracts their product over the panel from tiles (row .. row + count - 1, column). */
TILE_INLINE void NAME(update)(const struct front *f, int count, int row, int column,
                              int from, int to)
{
    NAME(tile_registers) c;
    REAL *target = COLUMN[column] + (ptrdiff_t)row * TILE_SIZE;
    NAME(tile_load)(count, target, c);
    NAME(tile_update)(0, count, c, COLUMN, row, column, from, to);
    NAME(tile_store)(count, c, target);
}

static bool NAME(factor_panel_diagonal)(const struct front *f, int from, int to)
{
    for (int k = from; k < to; k++) {
        NAME(update)(f, 1, k, k, from, k);
        if (!NAME(tile_cholesky)(COLUMN[k] + (ptrdiff_t)k * TILE_SIZE, INVERSE + k * TILE))
            return false;
        for (int row = k + 1; row < to; row++)
            NAME(finish)(f, 1, row, k, from);
    }
    return true;
}

/* Sweeps rows row .. row + count - 1 of the panel, then of everything right of it. */
TILE_INLINE void NAME(sweep_rows)(const struct front *f, int count, int row, int from,
                                  int to)
{
    for (int k = from; k < to; k++)
        NAME(finish)(f, count, row, k, from);
    for (int column = to; column <= row; column++)
        NAME(update)(f, count, row, column, from, to);
    for (int column = row + 1; column < row + count; column++)
        for (int r = column; r < row + count; r++)
            NAME(update)(f, 1, r, column, from, to);
}

/* Factors a front; false if it is not positive definite or not finite. */
static bool NAME(front_factor)(const struct front *f)
{
    for (int from = 0; from < f->pivots; from += PANEL) {
        int to = from + PANEL < f->pivots ? from + PANEL : f->pivots, row = to;
        if (!NAME(factor_panel_diagonal)(f, from, to))
            return false;
        for (; row + TILE_PASS <= f->tiles; row += TILE_PASS)
            NAME(sweep_rows)(f, TILE_PASS, row, from, to);
        for (; row < f->tiles; row++)
            NAME(sweep_rows)(f, 1, row, from, to);
    }
    return true;
}

/* Adds source[r] to target[place[r]] for the rows of one tile; `first` cuts off rows above
 * it.
 */
TILE_INLINE void NAME(add_rows)(REAL *target, const REAL *source, const int *place,
                                int first, int rows)
{
    for (int r = first; r < rows; r++)
        target[place[r]] += source[r];
}

/* Adds the update of a child, rows x rows: its row r goes to row i of the front, where
 * place[r] = i / 8 * 64 + i % 8, ascending. from: tile column after tile column, each from
 * its diagonal tile down. */
static void NAME(front_add)(const struct front *f, const REAL *from, int rows,
                            const int *place)
{
    int tiles = (rows + TILE - 1) / TILE, whole = rows / TILE;
    for (int c = 0; c < rows; c++) {
        int tile = c / TILE;
        const REAL *source = from + c % TILE * TILE;
        REAL *target = COLUMN[place[c] / TILE_SIZE] + place[c] % TILE * TILE;
        const int *to = place + tile * TILE;
        NAME(add_rows)(target, source, to, c % TILE, tile < whole ? TILE : rows % TILE);
        for (int t = tile + 1; t < whole; t++) {
            source += TILE_SIZE;
            to += TILE;
            if (to[TILE - 1] - to[0] == TILE - 1 && to[0] % TILE == 0)
                NAME(tile_column)(source, -1, target + to[0]);
            else
#pragma GCC unroll 8
                for (int r = 0; r < TILE; r++)
                    target[to[r]] += source[r];
        }
        if (tile < whole && whole < tiles)
            NAME(add_rows)(target, source + TILE_SIZE, to + TILE, 0, rows % TILE);
        if (c % TILE == TILE - 1)
            from += (ptrdiff_t)(tiles - tile) * TILE_SIZE;
    }
}

#undef COLUMN
#undef INVERSE

/* Sweep with L, stored as tile column after tile column, each from its diagonal. x[tiles *
 * 8], aligned as tiles: pivots first. Forward: pivots x1 = L11^-1 x1, then rest x2 -= L21
 * x1. Backward: x1 = L11^-T (x1 - L21^T x2). */
static void NAME(front_forward)(int pivots, int tiles, const REAL *l, const REAL *inverse,
                                REAL *x)
{
    for (int k = 0; k < pivots; k++) {
        NAME(tile_forward)(l, inverse + k * TILE, x + k * TILE);
        NAME(tile_subtract)(tiles - k - 1, l + TILE_SIZE, x + k * TILE, x + (k + 1) * TILE);
        l += (ptrdiff_t)(tiles - k) * TILE_SIZE;
    }
}

static void NAME(front_backward)(int pivots, int tiles, const REAL *l, const REAL *inverse,
                                 REAL *x)
{
    ptrdiff_t all = (ptrdiff_t)pivots * tiles - (ptrdiff_t)pivots * (pivots - 1) / 2;
    l += all * TILE_SIZE;
    for (int k = pivots - 1; k >= 0; k--) {
        l -= (ptrdiff_t)(tiles - k) * TILE_SIZE;
        NAME(tile_subtract_transposed)
        (tiles - k - 1, l + TILE_SIZE, x + (k + 1) * TILE, x + k * TILE);
        NAME(tile_backward)(l, inverse + k * TILE, x + k * TILE);
    }
}
