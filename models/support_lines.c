#include "models/support_lines.h"

#include <math.h>

/* The round-off of a line's place, in sides. */
static const double ROUNDING = 1e-9;

bool support_lines_clamped(const struct scene_support *s, int i)
{
    return s->hi[i] - s->lo[i] <= SUPPORT_LINES_APART &&
           s->hi[1 - i] - s->lo[1 - i] > SUPPORT_LINES_APART &&
           s->lo[i] > SUPPORT_LINES_APART && s->hi[i] < 1 - SUPPORT_LINES_APART &&
           s->fix == FIX_XYZ && s->lo[2] < s->hi[2];
}

bool support_lines_loaded(const struct scene *scene, int load, int i, double *at)
{
    const struct scene_load *l = &scene->loads[load];

    *at = l->lo[i];
    if (i == 0)
        scene_sheet_at(scene, *at, at);
    return l->hi[i] - l->lo[i] <= SUPPORT_LINES_APART &&
           l->hi[1 - i] - l->lo[1 - i] > SUPPORT_LINES_APART && *at > SUPPORT_LINES_APART &&
           *at < 1 - SUPPORT_LINES_APART;
}

static bool on_line(double place, int spans)
{
    return fabs(place - round(place * spans) / spans) <= ROUNDING;
}

static bool fits(const struct scene *scene, int along, int spans, int degree)
{
    for (int n = 0; n < scene->support_count; n++) {
        const struct scene_support s = scene_support_along(scene, n);
        const double lo = s.lo[along], hi = s.hi[along];
        const bool own_knots = degree > 1 && (lo < hi || support_lines_clamped(&s, along));
        if (!own_knots && (!on_line(lo, spans) || !on_line(hi, spans)))
            return false;
    }
    for (int n = 0; degree == 1 && n < scene->load_count; n++) {
        double at;
        if (support_lines_loaded(scene, n, along, &at) && !on_line(at, spans))
            return false;
    }
    return true;
}

int support_lines_points(const struct scene *scene, int along, int points, int degree)
{
    /* Around a closed sheet there are as many spans as points, and no knots are made. */
    const bool around = along == 1 && scene_closed(scene);
    const int more = around ? 0 : degree, spans = points - more;

    for (int n = spans; n <= 2 * spans; n++)
        if (fits(scene, along, n, around ? 1 : degree))
            return n + more;
    return 0;
}
