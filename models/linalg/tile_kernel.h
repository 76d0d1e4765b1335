/* tile_kernel.h - tile.h's arithmetic for one kind of REAL: included once for each, with
 * NAME(x) giving its names and LANES numbers in a register. */

enum { NAME(TILE_WORDS) = TILE / LANES };

typedef REAL NAME(tile_word) __attribute__((vector_size(LANES * sizeof(REAL)), may_alias));

/* Tiles in registers: word w of column j of tile r. */
typedef NAME(tile_word) NAME(tile_registers)[TILE_PASS_MAX][TILE][NAME(TILE_WORDS)];

/* Tiles (row + r, k) lie at column[k] + (row + r) TILE_SIZE:
 * c[r] -= sum over k = from .. to - 1 of tile (row + r, k) tile (other, k)^T,
 * for `count` tiles r one under the other from `first` on (constants). */
TILE_INLINE void NAME(tile_update)(int first, int count, NAME(tile_registers) c,
                                   REAL *const *column, ptrdiff_t row, ptrdiff_t other,
                                   int from, int to)
{
    TILE_UNROLL
    for (int strip = 0; strip < TILE; strip += LANES)
        for (int k = from; k < to; k++) {
            const REAL *a = column[k] + row * TILE_SIZE;
            const REAL *b = column[k] + other * TILE_SIZE;
            TILE_UNROLL
            for (int l = 0; l < TILE; l++)
                TILE_UNROLL
            for (int r = first; r < first + count; r++)
                TILE_UNROLL
            for (int w = 0; w < NAME(TILE_WORDS); w++) {
                const NAME(tile_word) left =
                    ((const NAME(tile_word) *)(a + r * TILE_SIZE + l * TILE))[w];
                TILE_UNROLL
                for (int j = strip; j < strip + LANES; j++)
                    c[r][j][w] -= left * b[l * TILE + j];
            }
        }
}

/* Computes c[r] <- c[r] l^-T: l lower triangular, `inverse` the reciprocals of its
 * diagonal. */
TILE_INLINE void NAME(tile_divide)(int count, NAME(tile_registers) c, const REAL *l,
                                   const REAL *inverse)
{
    TILE_UNROLL
    for (int r = 0; r < count; r++)
        TILE_UNROLL
    for (int j = 0; j < TILE; j++)
        TILE_UNROLL
    for (int w = 0; w < NAME(TILE_WORDS); w++) {
        c[r][j][w] *= inverse[j];
        TILE_UNROLL
        for (int i = j + 1; i < TILE; i++)
            c[r][i][w] -= c[r][j][w] * l[j * TILE + i];
    }
}

TILE_INLINE void NAME(tile_load)(int count, const REAL *from, NAME(tile_registers) c)
{
    TILE_UNROLL
    for (int r = 0; r < count; r++)
        TILE_UNROLL
    for (int j = 0; j < TILE; j++)
        TILE_UNROLL
    for (int w = 0; w < NAME(TILE_WORDS); w++)
        c[r][j][w] = ((const NAME(tile_word) *)(from + r * TILE_SIZE + j * TILE))[w];
}

TILE_INLINE void NAME(tile_store)(int count, NAME(tile_registers) c, REAL *to)
{
    TILE_UNROLL
    for (int r = 0; r < count; r++)
        TILE_UNROLL
    for (int j = 0; j < TILE; j++)
        TILE_UNROLL
    for (int w = 0; w < NAME(TILE_WORDS); w++)
        ((NAME(tile_word) *)(to + r * TILE_SIZE + j * TILE))[w] = c[r][j][w];
}

/* Subtracts a x from y on one column. */
TILE_INLINE void NAME(tile_column)(const REAL *a, REAL x, REAL *y)
{
    TILE_UNROLL
    for (int w = 0; w < NAME(TILE_WORDS); w++)
        ((NAME(tile_word) *)y)[w] -= ((const NAME(tile_word) *)a)[w] * x;
}

/* Factors one tile in place: lower triangle read, L written over it, zeros above.
 * inverse[TILE]: reciprocals of the diagonal. False if not positive definite or not
 * finite. */
TILE_INLINE bool NAME(tile_cholesky)(REAL *a, REAL *inverse)
{
    for (int j = 0; j < TILE; j++) {
        REAL pivot = a[j * TILE + j];
        if (!(pivot > 0 && pivot < (REAL)INFINITY))
            return false;
        REAL root = (REAL)sqrt(pivot);
        inverse[j] = 1 / root;
        for (int i = 0; i < TILE; i++)
            a[j * TILE + i] = i < j ? 0 : a[j * TILE + i] * inverse[j];
        a[j * TILE + j] = root;
        for (int k = j + 1; k < TILE; k++)
            NAME(tile_column)(a + j * TILE, a[j * TILE + k], a + k * TILE);
    }
    return true;
}

/* Computes x <- l^-1 x on one tile: number by number, where the chain of operations is
 * shortest. */
TILE_INLINE void NAME(tile_forward)(const REAL *l, const REAL *inverse, REAL *x)
{
    REAL value[TILE];
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

/* Computes x <- l^-T x on one tile. */
TILE_INLINE void NAME(tile_backward)(const REAL *l, const REAL *inverse, REAL *x)
{
    REAL value[TILE];
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

/* Subtracts a x from y for `count` tiles one under the other; y[count * TILE]. */
TILE_INLINE void NAME(tile_subtract)(ptrdiff_t count, const REAL *a, const REAL *x, REAL *y)
{
    NAME(tile_word) by[TILE]; /* x, which y might overlap as far as a compiler knows */
    TILE_UNROLL
    for (int j = 0; j < TILE; j++)
        by[j] = x[j] - (NAME(tile_word)){0};
    for (ptrdiff_t t = 0; t < count; t++)
        TILE_UNROLL
    for (int w = 0; w < NAME(TILE_WORDS); w++) {
        NAME(tile_word) *sum = (NAME(tile_word) *)(y + t * TILE) + w;
        NAME(tile_word) even = *sum, odd = {0};
        TILE_UNROLL
        for (int j = 0; j < TILE; j += 2) {
            const REAL *column = a + t * TILE_SIZE + j * TILE;
            even -= ((const NAME(tile_word) *)column)[w] * by[j];
            odd -= ((const NAME(tile_word) *)(column + TILE))[w] * by[j + 1];
        }
        *sum = even + odd;
    }
}

/* Subtracts from x[j] the sum of the lanes of sum[j], pairwise: those half a register
 * apart, then a quarter, then neighbours; where a register holds a tile's column, of eight
 * at once. */
TILE_INLINE void NAME(tile_take_lanes)(const NAME(tile_word) sum[TILE], REAL *x)
{
#if LANES == 8
    NAME(tile_word) half[4], quarter[2];
    TILE_UNROLL
    for (int j = 0; j < 4; j++)
        half[j] = __builtin_shufflevector(sum[j], sum[j + 4], 0, 1, 2, 3, 8, 9, 10, 11) +
                  __builtin_shufflevector(sum[j], sum[j + 4], 4, 5, 6, 7, 12, 13, 14, 15);
    TILE_UNROLL
    for (int j = 0; j < 2; j++)
        quarter[j] =
            __builtin_shufflevector(half[j], half[j + 2], 0, 1, 8, 9, 4, 5, 12, 13) +
            __builtin_shufflevector(half[j], half[j + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    *(NAME(tile_word) *)x -=
        __builtin_shufflevector(quarter[0], quarter[1], 0, 8, 2, 10, 4, 12, 6, 14) +
        __builtin_shufflevector(quarter[0], quarter[1], 1, 9, 3, 11, 5, 13, 7, 15);
#else
    for (int j = 0; j < TILE; j++) { /* lanes pairwise */
        union {
            NAME(tile_word) word;
            REAL lane[LANES];
        } total = {.word = sum[j]};
        for (int half = LANES / 2; half > 0; half /= 2)
            for (int i = 0; i < half; i++)
                total.lane[i] += total.lane[i + half];
        x[j] -= total.lane[0];
    }
#endif
}

/* Subtracts a^T y from x for `count` tiles one under the other. */
TILE_INLINE void NAME(tile_subtract_transposed)(ptrdiff_t count, const REAL *a,
                                                const REAL *y, REAL *x)
{
    NAME(tile_word) sum[TILE] = {{0}};
    for (ptrdiff_t t = 0; t < count; t++)
        TILE_UNROLL
    for (int w = 0; w < NAME(TILE_WORDS); w++) {
        const NAME(tile_word) right = ((const NAME(tile_word) *)(y + t * TILE))[w];
        TILE_UNROLL
        for (int j = 0; j < TILE; j++)
            sum[j] += ((const NAME(tile_word) *)(a + t * TILE_SIZE + j * TILE))[w] * right;
    }
    NAME(tile_take_lanes)(sum, x);
}
