#include "bench/experiment/learn.h"

#include <math.h>

struct bounds {
    double low, high;
};

static bool has(struct bounds b, double value)
{
    return value >= b.low && value <= b.high;
}

static int right(int count, const double *value, const bool *yes, struct bounds b)
{
    int agree = 0;

    for (int n = 0; n < count; n++)
        agree += has(b, value[n]) == yes[n];
    return agree;
}

/* Returns the point half way to the nearest value beyond an end; infinite if there is none.
 */
static double widen(int count, const double *value, double end, int sign)
{
    double next = sign * INFINITY;
    bool any = false;

    for (int n = 0; n < count; n++)
        if (sign > 0 ? value[n] > end : value[n] < end) {
            next = sign > 0 ? fmin(next, value[n]) : fmax(next, value[n]);
            any = true;
        }
    if (!isfinite(end) || !any)
        return sign * INFINITY;
    return isfinite(next) ? (end + next) / 2 : end;
}

static struct bounds best(int count, const double *value, const bool *yes,
                          enum learn_shape shape)
{
    struct bounds best = {INFINITY, -INFINITY};
    int most = right(count, value, yes, best);

    for (int i = 0; i < count; i++)
        for (int j = 0; j < count; j++) {
            const struct bounds b = {shape == LEARN_BELOW ? -INFINITY : value[i],
                                     shape == LEARN_ABOVE ? INFINITY : value[j]};
            const int agree = right(count, value, yes, b);
            if (agree > most)
                best = b, most = agree;
        }
    if (best.low > best.high)
        return best;
    return (struct bounds){widen(count, value, best.low, -1),
                           widen(count, value, best.high, 1)};
}

struct learnt learn(int count, const double *value, const bool *yes, enum learn_shape shape)
{
    const struct bounds all = best(count, value, yes, shape);
    struct learnt l = {all.low, all.high, {0}, {0}};

    for (int out = 0; out < count; out++) {
        double others[LEARN_MOST];
        bool theirs[LEARN_MOST];
        int n = 0;
        for (int k = 0; k < count; k++)
            if (k != out)
                others[n] = value[k], theirs[n++] = yes[k];
        l.fitted[out] = has(all, value[out]);
        l.left_out[out] = has(best(n, others, theirs, shape), value[out]);
    }
    return l;
}
