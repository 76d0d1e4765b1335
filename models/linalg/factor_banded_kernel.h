/* factor_banded_kernel.h - factor_banded.c's arithmetic for one kind of REAL: included once
 * for each, with NAME(x) as in tile_kernel.h. */

/* Finishes tiles (row .. row + count - 1, column) of L; `count` is a constant where this is
 * inlined. Tiles left of a row's first one do not exist; later rows begin later. */
TILE_INLINE void NAME(finish_tiles)(const struct banded *band, REAL *const *tile, int count,
                                    int row, int column)
{
    NAME(tile_registers) c;
    REAL *target = tile[column] + (ptrdiff_t)row * TILE_SIZE;
    int all = band->first[row + count - 1]; /* from here every row has a tile */
    NAME(tile_load)(count, target, c);
    TILE_UNROLL
    for (int r = 0; r < count - 1; r++)
        NAME(tile_update)(r, 1, c, tile, row, column, band->first[row + r], all);
    NAME(tile_update)(0, count, c, tile, row, column, all, column);
    NAME(tile_divide)
    (count, c, tile[column] + (ptrdiff_t)column * TILE_SIZE,
     (REAL *)band->inverse + column * TILE);
    NAME(tile_store)(count, c, target);
}

static bool NAME(finish_diagonal)(const struct banded *band, REAL *const *tile, int column)
{
    NAME(tile_registers) c;
    REAL *target = tile[column] + (ptrdiff_t)column * TILE_SIZE;
    NAME(tile_load)(1, target, c);
    NAME(tile_update)(0, 1, c, tile, column, column, band->first[column], column);
    NAME(tile_store)(1, c, target);
    return NAME(tile_cholesky)(target, (REAL *)band->inverse + column * TILE);
}

static enum status NAME(refactor)(struct factor_part *part, REAL *value)
{
    const struct banded *band = part->state;
    REAL **column = (REAL **)band->column;
    for (int i = part->n; i < part->rows; i++)
        value[slot(part, i, i)] = 1;
    for (int k = 0; k < band->tiles; k++)
        column[k] = value + band->start[k] - (ptrdiff_t)k * TILE_SIZE;
    for (int k = 0; k < band->tiles; k++) {
        if (!NAME(finish_diagonal)(band, column, k))
            return STATUS_INDEFINITE;
        int row = k + 1;
        for (; row + TILE_PASS - 1 <= band->last[k]; row += TILE_PASS)
            NAME(finish_tiles)(band, column, TILE_PASS, row, k);
        for (; row <= band->last[k]; row++)
            NAME(finish_tiles)(band, column, 1, row, k);
    }
    return STATUS_OK;
}

static enum status NAME(solve)(struct factor_part *part, const REAL *value, REAL *b)
{
    const struct banded *band = part->state;
    const REAL *inverse = (const REAL *)band->inverse;
    for (int k = 0; k < band->tiles; k++) {
        const REAL *tile = value + band->start[k];
        REAL *x = b + k * TILE;
        NAME(tile_forward)(tile, inverse + k * TILE, x);
        NAME(tile_subtract)(band->last[k] - k, tile + TILE_SIZE, x, x + TILE);
    }
    for (int k = band->tiles - 1; k >= 0; k--) {
        const REAL *tile = value + band->start[k];
        REAL *x = b + k * TILE;
        NAME(tile_subtract_transposed)(band->last[k] - k, tile + TILE_SIZE, x + TILE, x);
        NAME(tile_backward)(tile, inverse + k * TILE, x);
    }
    return STATUS_OK;
}
