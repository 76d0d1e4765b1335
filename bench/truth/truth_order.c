#include "bench/truth/truth_order.h"

#include <math.h>

static const double SAFETY = 1.25, UNSAFE = 3, LEAST = 0.5;

/* first / second, if errors were c h^p. */
static double ratio(const double h[3], double p)
{
    return (pow(h[0], p) - pow(h[1], p)) / (pow(h[1], p) - pow(h[2], p));
}

/* The ratio grows with p: halving. */
static double solve(const double h[3], double wanted)
{
    double low = 1e-3, high = 20;

    if (!(wanted > ratio(h, low)))
        return NAN;
    for (int n = 0; n < 60; n++) {
        double middle = (low + high) / 2;
        if (ratio(h, middle) < wanted)
            low = middle;
        else
            high = middle;
    }
    return low;
}

struct truth_order truth_order(const double h[3], double first, double second,
                               double promised)
{
    struct truth_order o = {.order = NAN};

    if (!(second > 0))
        return o;
    o.order = solve(h, first / second);
    double p = o.order >= LEAST ? fmin(o.order, promised) : LEAST;
    double left = pow(h[2], p) / (pow(h[1], p) - pow(h[2], p));
    o.bar = (o.order >= LEAST ? SAFETY : UNSAFE) * second * left;
    return o;
}
