/* spring_sweep_row.h - one strip of rows of the sweep for one kind of REAL: included once
 * for each, with NAME(x) giving its names. Arithmetic is contracted (a b + c in one
 * rounding): see CMakeLists.txt. */

/* Pulls at a neighbour `offset` behind: (A + B |e|^2) e, or of cells (A + tension) e. */
#define EDGE(offset)                                                                       \
    const REAL e0 = x0[j + (offset)] - x0[j], e1 = x1[j + (offset)] - x1[j],               \
               e2 = x2[j + (offset)] - x2[j]
#define SQUARE          (e0 * e0 + e1 * e1 + e2 * e2)
#define ADD(pull)       f0 += (pull)*e0, f1 += (pull)*e1, f2 += (pull)*e2
#define C(part, n)      c[((part) + (n)) * wide + j]
#define T(side, offset) t[(side)*stride + j + (offset)]
#define NEAR(n, offset, tension)                                                           \
    {                                                                                      \
        EDGE(offset);                                                                      \
        REAL pull = C(SWEEP_A, n);                                                         \
        if (cells)                                                                         \
            pull += push * (tension);                                                      \
        else                                                                               \
            pull += C(SWEEP_B, n) * SQUARE;                                                \
        ADD(pull);                                                                         \
    }
#define FAR(n, offset)                                                                     \
    {                                                                                      \
        EDGE(offset);                                                                      \
        ADD(C(SWEEP_FAR, n));                                                              \
    }

/* Moves points: x, v, y: positions, velocities, new positions of the strip, by component;
 * c: coefficients [SWEEP_COUNT][wide]; count a multiple of the padding; pitch from row to
 * row; t: tensions of cells, [CELL_SIDES][stride] and the row before; NULL without. */
static inline __attribute__((always_inline)) void
NAME(gather)(const bool cells, ptrdiff_t count, ptrdiff_t wide, ptrdiff_t pitch, REAL dt,
             REAL lag, const REAL *restrict t, ptrdiff_t stride, const REAL *restrict c,
             const REAL *restrict x0, const REAL *restrict x1, const REAL *restrict x2,
             REAL *restrict v0, REAL *restrict v1, REAL *restrict v2, REAL *restrict y0,
             REAL *restrict y1, REAL *restrict y2)
{
    count -= count % SWEEP_PAD; /* tells the compiler that no rest is left */
    for (ptrdiff_t j = 0; j < count; j++) {
        const REAL push = cells ? c[SWEEP_PUSH * wide + j] : 0;
        REAL f0 = 0, f1 = 0, f2 = 0;
        NEAR(0, -pitch - 1, T(CELL_RISING, -pitch - 1))
        NEAR(1, -pitch, T(CELL_BOTTOM, -pitch) + T(CELL_TOP, -pitch - 1))
        NEAR(2, -pitch + 1, T(CELL_FALLING, -pitch))
        NEAR(3, -1, T(CELL_LEFT, -1) + T(CELL_RIGHT, -pitch - 1))
        NEAR(4, 1, T(CELL_LEFT, 0) + T(CELL_RIGHT, -pitch))
        NEAR(5, pitch - 1, T(CELL_FALLING, -1))
        NEAR(6, pitch, T(CELL_BOTTOM, 0) + T(CELL_TOP, -1))
        NEAR(7, pitch + 1, T(CELL_RISING, 0))
        FAR(0, -2 * pitch)
        FAR(1, -2)
        FAR(2, 2)
        FAR(3, 2 * pitch)
        REAL keep = c[SWEEP_KEEP * wide + j];
        const REAL *free = c + SWEEP_FREE * wide + j, *kick = c + SWEEP_KICK * wide + j;
        REAL new0 = keep * v0[j] + (free[0] * f0 + kick[0]);
        REAL new1 = keep * v1[j] + (free[wide] * f1 + kick[wide]);
        REAL new2 = keep * v2[j] + (free[2 * wide] * f2 + kick[2 * wide]);
        y0[j] = x0[j] + dt * new0 + lag * (new0 - v0[j]);
        y1[j] = x1[j] + dt * new1 + lag * (new1 - v1[j]);
        y2[j] = x2[j] + dt * new2 + lag * (new2 - v2[j]);
        v0[j] = new0, v1[j] = new1, v2[j] = new2;
    }
}

#undef EDGE
#undef SQUARE
#undef ADD
#undef C
#undef NEAR
#undef T
#undef FAR

/* Moves the points of a strip by cells, or by springs where t is NULL. */
CLONES static void NAME(strip)(ptrdiff_t count, ptrdiff_t wide, ptrdiff_t pitch, REAL dt,
                               REAL lag, const REAL *restrict t, ptrdiff_t stride,
                               const REAL *restrict c, const REAL *restrict x0,
                               const REAL *restrict x1, const REAL *restrict x2,
                               REAL *restrict v0, REAL *restrict v1, REAL *restrict v2,
                               REAL *restrict y0, REAL *restrict y1, REAL *restrict y2)
{
    if (t) {
        NAME(gather)
        (true, count, wide, pitch, dt, lag, t, stride, c, x0, x1, x2, v0, v1, v2, y0, y1,
         y2);
    } else {
        NAME(gather)
        (false, count, wide, pitch, dt, lag, t, stride, c, x0, x1, x2, v0, v1, v2, y0, y1,
         y2);
    }
}

/* Takes one step of strips [from, to), from set `now` of the positions into the other. */
static void NAME(strips)(struct spring_sweep *s, double dt, int now, int from, int to)
{
    struct NAME(law) law = {0};

    if (s->celled)
        law = NAME(law_of)(&s->cells);
    for (int i = from; i < to; i++) {
        ptrdiff_t at = s->first + i * s->count;
        const REAL *x[3], *t = s->celled ? NAME(cells_tension)(s, law, now, i) : NULL;
        REAL *v[3], *y[3];
        for (int k = 0; k < 3; k++) {
            x[k] = (const REAL *)s->field[now][k] + at;
            y[k] = (REAL *)s->field[!now][k] + at;
            v[k] = (REAL *)s->field[SWEEP_V][k] + at;
        }
        NAME(strip)
        (points_of(s, i), s->count, s->pitch, (REAL)dt, (REAL)s->lag, t, s->stride,
         s->strip[i], x[0], x[1], x[2], v[0], v[1], v[2], y[0], y[1], y[2]);
    }
}

static void NAME(put)(struct spring_sweep *s, int set, const double from[3],
                      const double *values)
{
    REAL *x = (REAL *)s->field[set][0] + s->first, *y = (REAL *)s->field[set][1] + s->first,
         *z = (REAL *)s->field[set][2] + s->first;
    const bool whole = s->pitch == s->m; /* then all rows are one */
    const ptrdiff_t rows = whole ? 1 : s->n, points = whole ? s->n * s->m : s->m;

    for (ptrdiff_t i = 0; i < rows; i++, values += 3 * points)
        for (ptrdiff_t j = 0; j < points; j++) {
            x[i * s->pitch + j] = (REAL)(values[3 * j] - from[0]);
            y[i * s->pitch + j] = (REAL)(values[3 * j + 1] - from[1]);
            z[i * s->pitch + j] = (REAL)(values[3 * j + 2] - from[2]);
        }
}

static void NAME(get)(const struct spring_sweep *s, int set, const double from[3],
                      double *values)
{
    const double to[3] = {0 - from[0], 0 - from[1], 0 - from[2]}; /* less 0 is as it was */
    const REAL *x = (const REAL *)s->field[set][0] + s->first,
               *y = (const REAL *)s->field[set][1] + s->first,
               *z = (const REAL *)s->field[set][2] + s->first;
    const bool whole = s->pitch == s->m; /* then all rows are one */
    const ptrdiff_t rows = whole ? 1 : s->n, points = whole ? s->n * s->m : s->m;

    for (ptrdiff_t i = 0; i < rows; i++, values += 3 * points)
        for (ptrdiff_t j = 0; j < points; j++) {
            values[3 * j] = x[i * s->pitch + j] - to[0];
            values[3 * j + 1] = y[i * s->pitch + j] - to[1];
            values[3 * j + 2] = z[i * s->pitch + j] - to[2];
        }
}

/* Fills the coefficients of strip i, transposed and padded. */
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
            for (int k = 0; k < 3; k++) { /* what the origin's velocity keeps */
                const double v = from[SWEEP_FREE + k] * s->origin.velocity[k];
                if (v != 0)
                    to[(SWEEP_KICK + k) * s->count + j] =
                        (REAL)(from[SWEEP_KICK + k] + (from[SWEEP_KEEP] - 1) * v);
            }
        }
}
