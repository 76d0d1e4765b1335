#include "bench/harness/net_fit.h"

#include <math.h>
#include <stdbool.h>

/* Round-off of a line's place, in sides. */
static const double ROUNDING = 1e-9;

static bool on_line(double place, int spans)
{
    return fabs(place - round(place * spans) / spans) <= ROUNDING;
}

static bool fits(const struct scene *scene, int along, int spans)
{
    for (int n = 0; n < scene->support_count; n++)
        if (!on_line(scene->supports[n].lo[along], spans) ||
            !on_line(scene->supports[n].hi[along], spans))
            return false;
    return true;
}

int net_fit_spans(const struct scene *scene, int along, int spans)
{
    for (int n = spans; n <= 2 * spans; n++)
        if (fits(scene, along, n))
            return n;
    return 0;
}
