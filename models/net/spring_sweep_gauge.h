/* spring_sweep_gauge.h - the tensions of springs that measure their stretch over a gauge
 * length (spring_gauge.h), for one kind of REAL (spring_sweep_row.h): first the stretch of
 * each, then its weighted mean along the line. Both belong to the point that the spring
 * begins at. */

/* Computes l^2 - r^2 of one line's springs. */
CLONES static void NAME(gauge_stretches)(ptrdiff_t count, ptrdiff_t ahead, REAL square,
                                         const REAL *restrict x0, const REAL *restrict x1,
                                         const REAL *restrict x2, REAL *restrict to)
{
    count -= count % SWEEP_PAD;
#pragma omp simd
    for (ptrdiff_t j = 0; j < count; j++) {
        const REAL e0 = x0[j + ahead] - x0[j], e1 = x1[j + ahead] - x1[j],
                   e2 = x2[j + ahead] - x2[j];
        to[j] = e0 * e0 + e1 * e1 + e2 * e2 - square;
    }
}

static inline __attribute__((always_inline)) void
NAME(gauge_mean)(const int taps, ptrdiff_t count, ptrdiff_t ahead, const REAL *restrict w,
                 const REAL *restrict from, REAL *restrict to)
{
    const ptrdiff_t whole = count - count % SWEEP_PAD;

#pragma omp simd
    for (ptrdiff_t j = 0; j < whole; j++) {
        REAL sum = 0;
#pragma GCC unroll 8
        for (int t = 0; t < taps; t++)
            sum += w[t * count + j] * from[(t - taps / 2) * ahead + j];
        to[j] = sum;
    }
}

/* Computes the tension of one line's springs, with g in a run, from their stretches. */
CLONES static void NAME(gauge_means)(int g, ptrdiff_t count, ptrdiff_t ahead,
                                     const REAL *restrict w, const REAL *restrict from,
                                     REAL *restrict to)
{
    if (g == 1)
        NAME(gauge_mean)(1, count, ahead, w, from, to);
    else if (g == 2)
        NAME(gauge_mean)(3, count, ahead, w, from, to);
    else if (g == 3)
        NAME(gauge_mean)(5, count, ahead, w, from, to);
    else
        NAME(gauge_mean)(7, count, ahead, w, from, to);
}

/* Returns a line's stretches, or tensions, at point 0. */
static REAL *NAME(gauge_room)(const struct spring_sweep *s, bool tensions, int line)
{
    return (REAL *)s->gauge_room + (SPRING_GAUGE_LINES * tensions + line) * s->stride +
           gauge_pad(s);
}

static REAL *NAME(gauge_weight)(const struct spring_sweep *s, int line)
{
    return (REAL *)s->weight + line * SPRING_GAUGE_TAPS * s->count * s->strips;
}

/* Sets the weights, taps of a line by points. */
static void NAME(gauge_set)(struct spring_sweep *s)
{
    for (int line = 0; line < SPRING_GAUGE_LINES; line++) {
        const int g = s->gauge->springs[line];
        REAL *to = NAME(gauge_weight)(s, line);
        for (int a = 0; a < s->n * s->m; a++)
            for (int t = 0; t < 2 * g - 1; t++)
                to[t * s->count * s->strips + place_of(s, a) - s->first] =
                    (REAL)s->gauge->weight[line][a][SPRING_GAUGE_MOST - g + t];
    }
}

/* Computes the tensions of the whole net. */
static void NAME(gauge_tensions)(const struct spring_sweep *s, int now)
{
    const ptrdiff_t count = s->count * s->strips;
    const REAL *x[3];

    for (int k = 0; k < 3; k++)
        x[k] = (const REAL *)s->field[now][k] + s->first;
    for (int n = 0; n < 2 * SPRING_GAUGE_LINES; n++) {
        const int line = n % SPRING_GAUGE_LINES, *step = spring_gauge_step[line];
        const ptrdiff_t ahead = step[0] * s->pitch + step[1];
        REAL *stretch = NAME(gauge_room)(s, false, line);
        REAL *tension = NAME(gauge_room)(s, true, line);
        const REAL *w = NAME(gauge_weight)(s, line), r2 = (REAL)s->gauge->square[line];
        if (!s->gauge->taken[line])
            continue;
        if (n < SPRING_GAUGE_LINES)
            NAME(gauge_stretches)(count, ahead, r2, x[0], x[1], x[2], stretch);
        else
            NAME(gauge_means)(s->gauge->springs[line], count, ahead, w, stretch, tension);
    }
}
