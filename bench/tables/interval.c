#include "bench/tables/interval.h"

#include <math.h>

static int agreement(int count, const double *value, const bool *yes, double low,
                     double high)
{
    int agree = 0;

    for (int n = 0; n < count; n++)
        agree += (value[n] >= low && value[n] <= high) == yes[n];
    return agree;
}

struct interval interval_best(int count, const double *value, const bool *yes,
                              enum interval_shape shape)
{
    struct interval best = {INFINITY, -INFINITY, 0};

    best.agree = agreement(count, value, yes, best.low, best.high);
    for (int i = 0; i < count; i++)
        for (int j = 0; j < count; j++) {
            double low = shape == INTERVAL_BELOW ? -INFINITY : value[i];
            double high = shape == INTERVAL_ABOVE ? INFINITY : value[j];
            int agree = agreement(count, value, yes, low, high);
            if (agree > best.agree)
                best = (struct interval){low, high, agree};
        }
    return best;
}
