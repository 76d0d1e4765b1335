/* pb_sweep_row.h - the kernels of the sweep for one kind of REAL: included once for each,
 * with NAME(x) giving its names. Arithmetic is contracted (a b + c in one rounding): see
 * CMakeLists.txt. What is always inlined becomes part of `iterate`, of which there is one
 * for each level of CPU (clones.h). */

#define INLINE static inline __attribute__((always_inline))

/* Returns a field from the first point of a row on. */
INLINE REAL *NAME(at)(const struct pb_sweep *s, int field, int row)
{
    return (REAL *)s->field[field] + row * s->pitch;
}

/* The three components of a field from a row on. */
struct NAME(vector) {
    REAL *c[3];
};

INLINE struct NAME(vector) NAME(vector_at)(const struct pb_sweep *s, int field, int row)
{
    return (struct NAME(vector)){{NAME(at)(s, field, row), NAME(at)(s, field + 1, row),
                                  NAME(at)(s, field + 2, row)}};
}

/* Loops over `count` points, a multiple of the padding, so that the compiler leaves out a
 * remainder; they do not affect each other. */
#define LANES(j, count) APART for (ptrdiff_t j = 0; j < (count) - (count) % PAD; j++)
#define COMPONENTS(c)   _Pragma("GCC unroll 3") for (int c = 0; c < 3; c++)

/* Projects springs from `count` points to those `o` behind them; mask NULL: all of them.
 * Pulls go to s->pull, or at once to the points, if no two springs share one. */
INLINE void NAME(stretch)(struct pb_sweep *s, enum pb_kind kind, int row, ptrdiff_t count,
                          ptrdiff_t o, const REAL *mask, const bool apart,
                          const bool recalls)
{
    const REAL rest = (REAL)s->plan.rest[kind], gain = (REAL)s->plan.gain, gamma = gain - 1;
    const struct NAME(vector) x = NAME(vector_at)(s, PB_X, row),
                              d = NAME(vector_at)(s, PB_D, row),
                              w = NAME(vector_at)(s, PB_W, row);
    REAL *strength = NAME(at)(s, PB_STRENGTH + (int)kind, row),
         *lambda = NAME(at)(s, PB_LAMBDA + (int)kind, row), *f0 = s->pull[0],
         *f1 = s->pull[1], *f2 = s->pull[2];

    LANES(j, count)
    {
        REAL e[3], q = NO_LENGTH, turned = 0, sum = 0;
        COMPONENTS(c)
        {
            REAL step = d.c[c][j + o] - d.c[c][j];
            e[c] = x.c[c][j + o] - x.c[c][j] + step;
            q += e[c] * e[c];
            turned += e[c] * step;
            sum += e[c] * e[c] * (w.c[c][j] + w.c[c][j + o]);
        }
        REAL l = ROOT(q), k = strength[j];
        if (mask)
            k *= mask[j];
        REAL t = k * (q - rest * l + gamma * turned);
        if (recalls)
            t += (mask ? mask[j] * lambda[j] : lambda[j]) * l;
        t /= k * gain * sum + q;
        if (recalls)
            lambda[j] -= t * l;
        if (apart) {
            COMPONENTS(c)
            {
                d.c[c][j] += w.c[c][j] * (t * e[c]);
                d.c[c][j + o] -= w.c[c][j + o] * (t * e[c]);
            }
        } else {
            f0[j] = t * e[0], f1[j] = t * e[1], f2[j] = t * e[2];
        }
    }
}

/* Applies s->pull with these weights to the points of a row (of count / pitch rows). Behind
 * its end it is zero: the last colour of kinds that are done at once has nothing in the
 * first column, and nothing else writes there. */
INLINE void NAME(push)(struct pb_sweep *s, int row, ptrdiff_t count, const struct across to)
{
    const struct NAME(vector) d = NAME(vector_at)(s, PB_D, row),
                              w = NAME(vector_at)(s, PB_W, row);
    const REAL before = (REAL)to.before, at = (REAL)to.at, behind = (REAL)to.behind;

    if (!to.has)
        return;
    LANES(j, count)
    {
        COMPONENTS(c)
        {
            const REAL *f = s->pull[c];
            REAL sum = 0;
            if (to.has & AT)
                sum += at * f[j];
            if (to.has & BEFORE)
                sum += before * f[j - 1];
            if (to.has & BEHIND)
                sum += behind * f[j + 1];
            d.c[c][j] -= w.c[c][j] * sum;
        }
    }
}

/* Returns the part of a row's forms from the row `o` behind it, in one component. */
INLINE REAL NAME(part)(const REAL *x, const REAL *d, ptrdiff_t o, REAL gain,
                       const struct across of)
{
    REAL sum = 0;

    if (of.has & BEFORE)
        sum += (REAL)of.before * (x[o - 1] + gain * d[o - 1]);
    if (of.has & AT)
        sum += (REAL)of.at * (x[o] + gain * d[o]);
    if (of.has & BEHIND)
        sum += (REAL)of.behind * (x[o + 1] + gain * d[o + 1]);
    return sum;
}

/* Projects bending forms at `count` points; weights in the rows before, here and behind. */
INLINE void NAME(bend)(struct pb_sweep *s, enum pb_kind kind, int row, ptrdiff_t count,
                       const REAL *mask, const bool recalls, const struct across before,
                       const struct across here, const struct across behind)
{
    const int form = (int)kind - PB_SPRINGS;
    const ptrdiff_t pitch = s->pitch;
    const REAL gain = (REAL)s->plan.gain;
    const struct NAME(vector) x = NAME(vector_at)(s, PB_X, row),
                              d = NAME(vector_at)(s, PB_D, row),
                              lambda = NAME(vector_at)(s, PB_LAMBDAS + 3 * form, row);
    const REAL *strength = NAME(at)(s, PB_STRENGTH + (int)kind, row),
               *recall = NAME(at)(s, PB_RECALL + form, row);

    LANES(j, count)
    {
        COMPONENTS(c)
        {
            REAL *f = s->pull[c];
            REAL t = NAME(part)(x.c[c] + j, d.c[c] + j, -pitch, gain, before) +
                     NAME(part)(x.c[c] + j, d.c[c] + j, 0, gain, here) +
                     NAME(part)(x.c[c] + j, d.c[c] + j, pitch, gain, behind);
            t *= strength[j];
            if (recalls)
                t += recall[j] * lambda.c[c][j];
            if (mask)
                t *= mask[j];
            if (recalls)
                lambda.c[c][j] -= t;
            f[j] = t;
        }
    }
    NAME(push)(s, row - 1, count, turned(before));
    NAME(push)(s, row, count, turned(here));
    NAME(push)(s, row + 1, count, turned(behind));
}

/* Projects the constraints of one kind and colour at `count` points from a row on. */
INLINE void NAME(row)(struct pb_sweep *s, const enum pb_kind kind, int row, ptrdiff_t count,
                      const REAL *mask, const bool recalls)
{
    const struct across none = {0}, point = {AT, 0, 1, 0}, middle = {AT, 0, -2, 0},
                        curve = {ALL, 1, -2, 1}, down = {AT | BEHIND, 0, -1, 1},
                        up = {AT | BEHIND, 0, 1, -1};
    const double u = s->plan.mean[0], v = s->plan.mean[1];
    const struct across beside = {AT, 0, u, 0}, mean = {ALL, v, -2 * (u + v), v};
    const ptrdiff_t pitch = s->pitch;

    switch (kind) {
    case PB_U:
        NAME(stretch)(s, kind, row, count, pitch, mask, true, recalls);
        break;
    case PB_DOWN:
        NAME(stretch)(s, kind, row, count, pitch + 1, mask, true, recalls);
        break;
    case PB_UP: /* a row's last point lies next to the first of the row below */
        NAME(stretch)(s, kind, row, count, pitch - 1, mask, false, recalls);
        NAME(push)(s, row, count, (struct across){AT, 0, -1, 0});
        NAME(push)(s, row + 1, count, (struct across){BEHIND, 0, 0, 1});
        break;
    case PB_V:
        NAME(stretch)(s, kind, row, count, 1, mask, false, recalls);
        NAME(push)(s, row, count, turned(down));
        break;
    case PB_LINE_U:
        NAME(bend)(s, kind, row, count, mask, recalls, point, middle, point);
        break;
    case PB_LINE_V:
        NAME(bend)(s, kind, row, count, mask, recalls, none, curve, none);
        break;
    case PB_TWIST:
        NAME(bend)(s, kind, row, count, mask, recalls, none, up, down);
        break;
    default:
        NAME(bend)(s, PB_MEAN, row, count, mask, recalls, beside, mean, beside);
    }
}

/* Projects all constraints of a kind: `rows` colours of a sheet's rows, from `low` to the
 * last but `high` (0: rows are independent, and are done at once), and `colours` along
 * them. */
INLINE void NAME(kind)(struct pb_sweep *s, const enum pb_kind kind, const int rows,
                       const int low, const int high, void *const *masks, const int colours,
                       const bool recalls)
{
    if (!s->used[kind])
        return;
    for (int first = 0; rows && first < s->plan.n; first += s->plan.sheet)
        for (int r = 0; r < rows; r++)
            for (int i = low + r; i < s->plan.sheet - high; i += rows)
                for (int k = 0; k < colours; k++)
                    NAME(row)
    (s, kind, first + i, s->pitch, masks ? masks[k] : NULL, recalls);
    for (int k = 0; rows == 0 && k < colours; k++)
        NAME(row)(s, kind, 0, s->plan.n * s->pitch, masks[k], recalls);
}

/* Projects listed springs, one by one, as `stretch` does. */
INLINE void NAME(links)(struct pb_sweep *s, bool back, const bool recalls)
{
    const REAL gain = (REAL)s->plan.gain, gamma = gain - 1;
    REAL *const *x = (REAL *const *)s->field + PB_X, *const *d = x + PB_D,
                *const *w = x + PB_W;
    const int count = s->plan.link_count;

    for (int n = 0; n < count; n++) {
        struct pb_link *link = &s->plan.link[back ? count - 1 - n : n];
        const int a = link->node[0], b = link->node[1];
        const REAL k = (REAL)link->strength;
        REAL e[3], q = NO_LENGTH, turned = 0, sum = 0;
        COMPONENTS(c)
        {
            REAL step = d[c][b] - d[c][a];
            e[c] = x[c][b] - x[c][a] + step;
            q += e[c] * e[c];
            turned += e[c] * step;
            sum += e[c] * e[c] * (w[c][a] + w[c][b]);
        }
        REAL l = ROOT(q), t = k * (q - (REAL)link->rest * l + gamma * turned);
        if (recalls)
            t += (REAL)link->lambda * l;
        t /= k * gain * sum + q;
        if (recalls)
            link->lambda -= t * l;
        COMPONENTS(c)
        {
            d[c][a] += w[c][a] * (t * e[c]);
            d[c][b] -= w[c][b] * (t * e[c]);
        }
    }
}

/* Projects listed constraints, one by one. */
INLINE void NAME(odd)(struct pb_sweep *s, bool back, const bool recalls)
{
    const double gain = s->plan.gain;

    for (int n = 0; n < s->plan.odd_count; n++)
        for (int c = 0; c < 3; c++) {
            struct pb_odd *o = &s->plan.odd[back ? s->plan.odd_count - 1 - n : n];
            const REAL *x = s->field[PB_X + c], *w = s->field[PB_W + c];
            REAL *d = s->field[PB_D + c];
            double value = o->shift[c];
            for (int k = 0; k < o->count; k++)
                value += o->weight[k] * (x[o->place[k]] + gain * d[o->place[k]]);
            double t = o->strength * value + (recalls ? o->recall * o->lambda[c] : 0);
            if (recalls)
                o->lambda[c] -= t;
            for (int k = 0; k < o->count; k++)
                d[o->place[k]] -= (REAL)(w[o->place[k]] * o->weight[k] * t);
        }
}

INLINE void NAME(pass)(struct pb_sweep *s, bool bends, bool back, const bool recalls)
{
    const int last = bends ? PB_KINDS : PB_SPRINGS - 1;

    if (s->plan.link_count && !back)
        NAME(links)(s, back, recalls);
    for (int k = 0; k <= last; k++)
        switch (back ? last - k : k) {
        case PB_U:
            NAME(kind)(s, PB_U, 2, 0, 1, NULL, 1, recalls);
            break;
        case PB_V:
            NAME(kind)(s, PB_V, 0, 0, 0, s->half, HALVES, recalls);
            break;
        case PB_DOWN:
            NAME(kind)(s, PB_DOWN, 2, 0, 1, NULL, 1, recalls);
            break;
        case PB_UP:
            NAME(kind)(s, PB_UP, 2, 0, 1, NULL, 1, recalls);
            break;
        case PB_LINE_U:
            NAME(kind)(s, PB_LINE_U, 3, 1, 1, NULL, 1, recalls);
            break;
        case PB_LINE_V:
            NAME(kind)(s, PB_LINE_V, 0, 0, 0, s->third, THIRDS, recalls);
            break;
        case PB_TWIST:
            NAME(kind)(s, PB_TWIST, 2, 0, 1, s->half, HALVES, recalls);
            break;
        case PB_MEAN:
            NAME(kind)(s, PB_MEAN, 3, 1, 1, s->third, THIRDS, recalls);
            break;
        default:
            NAME(odd)(s, back && s->plan.link_count, recalls);
        }
    if (s->plan.link_count && back)
        NAME(links)(s, back, recalls);
}

CLONES static void NAME(iterate)(struct pb_sweep *s, bool bends, bool recalls, bool back)
{
    if (recalls)
        NAME(pass)(s, bends, back, true);
    else
        NAME(pass)(s, bends, back, false);
}

CLONES static void NAME(predict)(struct pb_sweep *s)
{
    const ptrdiff_t count = s->pitch * s->plan.n;
    const REAL *keep = s->field[PB_KEEP];

    for (int c = 0; c < 3; c++) {
        const REAL *restrict kick = s->field[PB_KICK + c];
        REAL *restrict d = s->field[PB_D + c];
        LANES(n, count)
        d[n] = keep[n] * d[n] + kick[n];
    }
}

CLONES static void NAME(finish)(struct pb_sweep *s)
{
    const ptrdiff_t count = s->pitch * s->plan.n;

    for (int c = 0; c < 3; c++) {
        const REAL *restrict d = s->field[PB_D + c];
        REAL *restrict x = s->field[PB_X + c];
        LANES(n, count)
        x[n] += d[n];
    }
}

static void NAME(hold)(struct pb_sweep *s, ptrdiff_t at, int component, double x)
{
    ((REAL *)s->field[PB_D + component])[at] =
        (REAL)(x - ((REAL *)s->field[PB_X + component])[at]);
}

static void NAME(put)(struct pb_sweep *s, int first, int count, const double *values)
{
    for (int f = 0; f < count; f++) {
        const double from = first + f < PB_W ? s->origin[first + f] : 0;
        for (int i = 0; i < s->plan.n; i++)
            for (int j = 0; j < s->plan.m; j++)
                NAME(at)
        (s, first + f, i)[j] = (REAL)(values[count * (i * s->plan.m + j) + f] - from);
    }
}

static void NAME(get)(const struct pb_sweep *s, int first, int count, double *values)
{
    for (int f = 0; f < count; f++) {
        const double to = first + f < PB_W ? 0 - s->origin[first + f] : 0;
        for (int i = 0; i < s->plan.n; i++)
            for (int j = 0; j < s->plan.m; j++)
                values[count * (i * s->plan.m + j) + f] = NAME(at)(s, first + f, i)[j] - to;
    }
}

static void NAME(mask)(const struct pb_sweep *s, void *mask, int period, int place)
{
    for (ptrdiff_t n = 0; n < s->pitch * s->plan.n; n++)
        ((REAL *)mask)[n] = n % s->pitch % period == place;
}

#undef INLINE
#undef LANES
#undef COMPONENTS
