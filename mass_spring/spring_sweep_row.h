/* spring_sweep_row.h - one strip of rows of the sweep for one kind of REAL: included once
 * for each, with NAME(x) giving its names. Arithmetic is contracted (a b + c in one
 * rounding): see CMakeLists.txt. */

/* x, v, y: positions, velocities, new positions of the strip, by component; c: coefficients
 * [SWEEP_COUNT][wide]; count a multiple of the padding; pitch from row to row; more: other
 * forces on the points, [3][stride], in place of springs; NULL without. */
static inline __attribute__((always_inline)) void
NAME(gather)(ptrdiff_t count, ptrdiff_t wide, ptrdiff_t pitch, REAL dt, REAL lag,
             const bool lags, const bool springs, const REAL *restrict more,
             ptrdiff_t stride, const REAL *restrict c, const REAL *restrict x0,
             const REAL *restrict x1, const REAL *restrict x2, REAL *restrict v0,
             REAL *restrict v1, REAL *restrict v2, REAL *restrict y0, REAL *restrict y1,
             REAL *restrict y2)
{
    const REAL *restrict far = c + SWEEP_FAR * wide;

    count -= count % SWEEP_PAD; /* tells the compiler that no rest is left */
    for (ptrdiff_t j = 0; j < count; j++) {
        REAL f0 = 0, f1 = 0, f2 = 0;
#define NEAR(n, offset)                                                                    \
    {                                                                                      \
        REAL e0 = x0[j + (offset)] - x0[j], e1 = x1[j + (offset)] - x1[j],                 \
             e2 = x2[j + (offset)] - x2[j];                                                \
        REAL pull = c[(SWEEP_A + (n)) * wide + j];                                         \
        if (springs)                                                                       \
            pull += c[(SWEEP_B + (n)) * wide + j] * (e0 * e0 + e1 * e1 + e2 * e2);         \
        f0 += pull * e0, f1 += pull * e1, f2 += pull * e2;                                 \
    }
#define FAR(n, offset)                                                                     \
    {                                                                                      \
        REAL pull = far[(n)*wide + j];                                                     \
        f0 += pull * (x0[j + (offset)] - x0[j]);                                           \
        f1 += pull * (x1[j + (offset)] - x1[j]);                                           \
        f2 += pull * (x2[j + (offset)] - x2[j]);                                           \
    }
        NEAR(0, -pitch - 1)
        NEAR(1, -pitch)
        NEAR(2, -pitch + 1)
        NEAR(3, -1)
        NEAR(4, 1)
        NEAR(5, pitch - 1)
        NEAR(6, pitch)
        NEAR(7, pitch + 1)
        FAR(0, -2 * pitch)
        FAR(1, -2)
        FAR(2, 2)
        FAR(3, 2 * pitch)
#undef NEAR
#undef FAR
        if (!springs) {
            REAL push = c[SWEEP_PUSH * wide + j];
            f0 += push * more[j], f1 += push * more[stride + j];
            f2 += push * more[2 * stride + j];
        }
        REAL keep = c[SWEEP_KEEP * wide + j];
        const REAL *free = c + SWEEP_FREE * wide + j, *kick = c + SWEEP_KICK * wide + j;
        REAL new0 = keep * v0[j] + (free[0] * f0 + kick[0]);
        REAL new1 = keep * v1[j] + (free[wide] * f1 + kick[wide]);
        REAL new2 = keep * v2[j] + (free[2 * wide] * f2 + kick[2 * wide]);
        y0[j] = x0[j] + dt * new0 + (lags ? lag * (new0 - v0[j]) : 0);
        y1[j] = x1[j] + dt * new1 + (lags ? lag * (new1 - v1[j]) : 0);
        y2[j] = x2[j] + dt * new2 + (lags ? lag * (new2 - v2[j]) : 0);
        v0[j] = new0, v1[j] = new1, v2[j] = new2;
    }
}

#define STRIP(name, lags, springs)                                                         \
    CLONES static void NAME(name)(                                                         \
        ptrdiff_t count, ptrdiff_t wide, ptrdiff_t pitch, REAL dt, REAL lag,               \
        const REAL *restrict more, ptrdiff_t stride, const REAL *restrict c,               \
        const REAL *restrict x0, const REAL *restrict x1, const REAL *restrict x2,         \
        REAL *restrict v0, REAL *restrict v1, REAL *restrict v2, REAL *restrict y0,        \
        REAL *restrict y1, REAL *restrict y2)                                              \
    {                                                                                      \
        NAME(gather)                                                                       \
        (count, wide, pitch, dt, lag, lags, springs, more, stride, c, x0, x1, x2, v0, v1,  \
         v2, y0, y1, y2);                                                                  \
    }
STRIP(strip, false, true)
STRIP(lagging_strip, true, true)
STRIP(cell_strip, false, false)
STRIP(lagging_cell_strip, true, false)
#undef STRIP

/* One step of strips [from, to), from set `now` of the positions into the other. */
static void NAME(strips)(struct spring_sweep *s, double dt, int now, int from, int to)
{
    const bool cells = s->cell_room, lags = s->lag > 0;
    struct NAME(law) law = {0};

    if (cells)
        law = NAME(law_of)(&s->cells);
    for (int i = from; i < to; i++) {
        ptrdiff_t at = s->first + i * s->count;
        const REAL *x[3], *more = cells ? NAME(cells_force)(s, law, now, i) : NULL;
        REAL *v[3], *y[3];
        for (int k = 0; k < 3; k++) {
            x[k] = (const REAL *)s->field[now][k] + at;
            y[k] = (REAL *)s->field[!now][k] + at;
            v[k] = (REAL *)s->field[SWEEP_V][k] + at;
        }
        (cells  ? lags ? NAME(lagging_cell_strip) : NAME(cell_strip)
          : lags ? NAME(lagging_strip)
                : NAME(strip))(points_of(s, i), s->count, s->pitch, (REAL)dt, (REAL)s->lag,
                               more, s->stride, s->strip[i], x[0], x[1], x[2], v[0], v[1],
                               v[2], y[0], y[1], y[2]);
    }
}

static void NAME(put)(struct spring_sweep *s, int set, const double *values)
{
    for (int k = 0; k < 3; k++) {
        REAL *to = (REAL *)s->field[set][k] + s->first;
        for (int i = 0; i < s->n; i++)
            for (int j = 0; j < s->m; j++)
                to[i * s->pitch + j] = (REAL)values[3 * (i * s->m + j) + k];
    }
}

static void NAME(get)(const struct spring_sweep *s, int set, double *values)
{
    for (int k = 0; k < 3; k++) {
        const REAL *from = (const REAL *)s->field[set][k] + s->first;
        for (int i = 0; i < s->n; i++)
            for (int j = 0; j < s->m; j++)
                values[3 * (i * s->m + j) + k] = from[i * s->pitch + j];
    }
}

/* The coefficients of strip i, transposed and padded. */
static void NAME(coefficients)(const struct spring_sweep *s, int strip,
                               const double (*c)[SWEEP_COUNT], void *coefficients)
{
    REAL *to = coefficients;

    memset(to, 0, s->strip_bytes);
    for (int i = 0; i < s->rows && strip * s->rows + i < s->n; i++, to += s->pitch)
        for (int j = 0; j < s->m; j++) {
            const double *from = c[(strip * s->rows + i) * s->m + j];
            for (int n = 0; n < SWEEP_COUNT; n++)
                to[n * s->count + j] = (REAL)from[n];
        }
}
