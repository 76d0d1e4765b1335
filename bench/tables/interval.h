/* interval.h - what a threshold can do at its best: how many of some yes-or-no answers a
 * number alone reproduces, with the bounds chosen in hindsight. */
#ifndef INTERVAL_H
#define INTERVAL_H

#include <stdbool.h>

struct interval {
    double low, high; /* yes inside, bounds included; -INFINITY, INFINITY: open         */
    int agree;        /* answers reproduced                                             */
};

enum interval_shape { INTERVAL_ANY, INTERVAL_ABOVE, INTERVAL_BELOW };

/* The first interval of a shape that reproduces most of yes[count]. The
 * empty one ("always no", low > high) is among them. NaN lies in none. Bounds are values.
 */
struct interval interval_best(int count, const double *value, const bool *yes,
                              enum interval_shape shape);

#endif
