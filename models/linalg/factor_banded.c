/* Cholesky on a band of 8 x 8 tiles with a ragged lower edge.
 *
 * Tile column K holds the tiles K .. last(K), one under the other; last never decreases, so
 * that all fill falls inside. Left-looking: every tile of L is written once, from
 * registers, with all updates from its left and the division by the diagonal tile done. The
 * unknowns are padded with ones on the diagonal to whole tiles.
 */
#include <assert.h>
#include <stdlib.h>

#include "models/linalg/factor.h"
#include "models/linalg/factor_part.h"
#include "models/linalg/tile.h"
#include "models/linalg/tile_three.h"
#include "models/room.h"

struct banded {
    void *room;       /* memory of the arrays but pair                                 */
    int half;         /* half-bandwidth in unknowns                                    */
    int tiles;        /* tile columns                                                  */
    int *last;        /* [tiles] last tile row of a tile column                        */
    int *first;       /* [tiles] first tile column of a tile row                       */
    ptrdiff_t *start; /* [tiles + 1] the diagonal tile of a column, in values          */
    double *inverse;  /* [tiles * TILE] reciprocals of the diagonal of L, or floats    */
    double *pair;     /* [tiles * TILE_PAIR] inverse diagonal tiles, NULL until needed */
    void **column;    /* [tiles] tile (i,k) at column[k] + i TILE_SIZE, during refactor */
};

static int half_bandwidth(const struct factor_pattern *a, const int *position)
{
    int half = 0;
    for (int j = 0; j < a->n; j++)
        for (long s = a->start[j]; s < a->start[j + 1]; s++) {
            int width = abs(position[a->row[s]] - position[j]);
            half = width > half ? width : half;
        }
    return half;
}

/* Takes the given order, unless the natural one is as narrow; returns the
 * half-bandwidth. */
static int choose_order(const struct factor_pattern *a, int *position)
{
    for (int k = 0; k < a->n; k++)
        position[k] = k;
    int natural = half_bandwidth(a, position);
    if (!a->order)
        return natural;
    for (int k = 0; k < a->n; k++)
        position[a->order[k]] = k;
    int given = half_bandwidth(a, position);
    if (given < natural)
        return given;
    for (int k = 0; k < a->n; k++)
        position[k] = k;
    return natural;
}

static void find_profile(struct banded *band, const struct factor_pattern *a,
                         const int *position)
{
    for (int t = 0; t < band->tiles; t++)
        band->last[t] = t;
    for (int j = 0; j < a->n; j++)
        for (long s = a->start[j]; s < a->start[j + 1]; s++) {
            int p = position[a->row[s]] / TILE, q = position[j] / TILE;
            int low = p < q ? p : q, high = p < q ? q : p;
            band->last[low] = high > band->last[low] ? high : band->last[low];
        }
    band->start[0] = 0;
    for (int t = 0, row = 0; t < band->tiles; t++) {
        if (t > 0 && band->last[t] < band->last[t - 1])
            band->last[t] = band->last[t - 1];
        for (; row <= band->last[t]; row++)
            band->first[row] = t;
        band->start[t + 1] =
            band->start[t] + (band->last[t] - t + 1) * (ptrdiff_t)TILE_SIZE;
    }
}

static enum status create(const struct factor_pattern *a, int *position,
                          struct factor_part *part)
{
    enum status st;
    struct banded *band = part->state = calloc(1, sizeof *band);
    if (!band)
        return STATUS_MEMORY;
    band->half = choose_order(a, position);
    band->tiles = (a->n + TILE - 1) / TILE;
    TRY(room_cut(&band->room, ROOM(band->last, band->tiles), ROOM(band->first, band->tiles),
                 ROOM(band->start, band->tiles + 1),
                 ROOM(band->inverse, band->tiles * TILE), ROOM(band->column, band->tiles)));
    find_profile(band, a, position);
    part->rows = band->tiles * TILE;
    part->slots = band->start[band->tiles];
out:
    return st;
}

static ptrdiff_t slot(const struct factor_part *part, int i, int j)
{
    const struct banded *band = part->state;
    int row = i / TILE, column = j / TILE;
    assert(row <= band->last[column]);
    return band->start[column] + (row - column) * TILE_SIZE + j % TILE * TILE + i % TILE;
}

#define REAL       double
#define NAME(name) name
#include "models/linalg/factor_banded_kernel.h"
#undef REAL
#undef NAME
#define REAL       float
#define NAME(name) name##_single
#include "models/linalg/factor_banded_kernel.h"
#undef REAL
#undef NAME

static enum status prepare_three(struct factor_part *part, const double *value)
{
    struct banded *band = part->state;
    if (!band->pair)
        band->pair = factor_numbers((ptrdiff_t)band->tiles * TILE_PAIR);
    if (!band->pair)
        return STATUS_MEMORY;
    for (int k = 0; k < band->tiles; k++)
        tile_invert(value + band->start[k], band->inverse + k * TILE,
                    band->pair + k * TILE_PAIR);
    return STATUS_OK;
}

static enum status solve_three(struct factor_part *part, const double *value, double *b)
{
    const struct banded *band = part->state;
    for (int k = 0; k < band->tiles; k++) {
        double *x = b + k * BLOCK;
        tile_three_apply(band->pair + k * TILE_PAIR, x);
        tile_three_subtract(band->last[k] - k, value + band->start[k] + TILE_SIZE, x,
                            x + BLOCK);
    }
    for (int k = band->tiles - 1; k >= 0; k--) {
        double *x = b + k * BLOCK;
        tile_three_subtract_transposed(band->last[k] - k,
                                       value + band->start[k] + TILE_SIZE, x + BLOCK, x);
        tile_three_apply(band->pair + k * TILE_PAIR + TILE_SIZE, x);
    }
    return STATUS_OK;
}

static void describe(const struct factor_part *part, struct factor_info *info)
{
    const struct banded *band = part->state;
    for (int k = 0; k < band->tiles; k++) {
        double below = (band->last[k] - k) * TILE; /* n + (n - 1) + ... squared, by 8 */
        info->flops += TILE * (below + TILE / 2) * (below + TILE / 2);
    }
    info->entries += (long)part->slots;
    info->bytes +=
        (long)(sizeof *band + band->tiles * (2 * sizeof(int) + 10 * sizeof(double)));
    info->half_bandwidth =
        band->half > info->half_bandwidth ? band->half : info->half_bandwidth;
}

static void destroy(struct factor_part *part)
{
    struct banded *band = part->state;
    if (!band)
        return;
    free(band->room);
    free(band->pair);
    free(band);
    part->state = NULL;
}

const struct factor_method factor_banded = {
    "banded",    create,          slot,         refactor, solve,  prepare_three,
    solve_three, refactor_single, solve_single, describe, destroy};
