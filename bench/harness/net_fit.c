#include "bench/harness/net_fit.h"

#include <math.h>
#include <stdbool.h>

#include "iga/support_knots.h"

/* The round-off of a line's place, in sides. */
static const double ROUNDING = 1e-9;

static bool on_line(double place, int spans)
{
    return fabs(place - round(place * spans) / spans) <= ROUNDING;
}

static bool fits(const struct scene *scene, int along, int spans, int degree)
{
    for (int n = 0; n < scene->support_count; n++) {
        const struct scene_support s = scene_support_along(scene, n);
        const double lo = s.lo[along], hi = s.hi[along];
        const bool own_knots =
            degree > 1 && (lo < hi || support_knots_clamps_line(&s, along));
        if (!own_knots && (!on_line(lo, spans) || !on_line(hi, spans)))
            return false;
    }
    for (int n = 0; degree == 1 && n < scene->load_count; n++) {
        double at;
        if (support_knots_loads_line(scene, n, along, &at) && !on_line(at, spans))
            return false;
    }
    return true;
}

int net_fit_points(const struct scene *scene, int along, int points, int degree)
{
    const int spans = points - degree;

    for (int n = spans; n <= 2 * spans; n++)
        if (fits(scene, along, n, degree))
            return n + degree;
    return 0;
}
