#include "models/metric/drape.h"

#include <math.h>
#include <stdlib.h>

#include "models/grid.h"
#include "models/metric/metric_rest.h"
#include "models/vector.h"

static const double PI = 3.14159265358979323846;

enum { RAYS = 1440, LAYER = GRID_U * GRID_V };

/* Heights of folds that count, in lengths u. */
static const double DEPTH = 0.02;

struct outline {
    double across[2][3]; /* axes of its plane, across gravity                          */
    double radius[RAYS]; /* [m]                                                        */
};

static bool is_disc(const struct scene *scene)
{
    return scene_closed(scene) && scene->flare == 90 && vector_length(scene->gravity) > 0;
}

/* Sets the plane, and the holder as the outline. */
static double start(const struct scene *scene, struct outline *o)
{
    double holder, z;

    scene_cloak_meridian(scene, 0, 0.5, &holder, &z);
    vector_cross(scene->gravity, scene->axis_v, o->across[0]);
    vector_cross(scene->gravity, o->across[0], o->across[1]);
    for (int d = 0; d < 2; d++) {
        const double size = vector_length(o->across[d]);
        for (int c = 0; c < 3; c++)
            o->across[d][c] /= size;
    }
    for (int k = 0; k < RAYS; k++)
        o->radius[k] = holder;
    return holder;
}

/* Computes the shadow of a point of the mid-surface, from the axis. */
static void shadow(const struct scene *scene, const struct outline *o, const double *xyz,
                   int n, double p[2])
{
    double way[3];

    for (int c = 0; c < 3; c++)
        way[c] = (xyz[3 * n + c] + xyz[3 * (n + LAYER) + c]) / 2 - scene->origin[c];
    for (int d = 0; d < 2; d++)
        p[d] = vector_dot(way, o->across[d]);
}

/* Takes a segment's points on the rays that it crosses; of one along a ray, an end. */
static void take(struct outline *o, const double p[2], const double q[2])
{
    const double area = p[0] * q[1] - p[1] * q[0], along = p[0] * q[0] + p[1] * q[1];
    const double step = 2 * PI / RAYS, from = atan2(p[1], p[0]) / step;
    const double to = from + atan2(area, along) / step;
    const double far = fmax(hypot(p[0], p[1]), hypot(q[0], q[1]));

    for (double k = ceil(fmin(from, to)); k <= fmax(from, to); k++) {
        const double c = cos(k * step), s = sin(k * step);
        const double across = c * (q[1] - p[1]) - s * (q[0] - p[0]);
        const int ray = (int)k < 0 ? (int)k + RAYS : (int)k % RAYS;
        const double r = across != 0 ? fmin(area / across, far) : far;
        o->radius[ray] = fmax(o->radius[ray], r);
    }
}

/* Draws the lines of the grid; false: a coordinate is not finite. */
static bool draw(const struct scene *scene, const double *xyz, struct outline *o)
{
    for (int n = 0; n < LAYER; n++) {
        double p[2], q[2];
        shadow(scene, o, xyz, n, p);
        if (!isfinite(p[0]) || !isfinite(p[1]))
            return false;
        for (int d = 0; d < 2; d++)
            if (d ? n + GRID_U < LAYER : (n + 1) % GRID_U != 0) {
                shadow(scene, o, xyz, n + (d ? GRID_U : 1), q);
                if (isfinite(q[0]) && isfinite(q[1]))
                    take(o, p, q);
            }
    }
    return true;
}

/* Returns the area beyond the holder [m^2], NaN: there is none. */
static double area_beyond(const struct scene *scene, const double *xyz)
{
    struct outline o;
    double sum = 0;

    if (!xyz)
        return NAN;
    const double holder = start(scene, &o);
    if (!draw(scene, xyz, &o))
        return NAN;
    for (int k = 0; k < RAYS; k++)
        sum += o.radius[k] * o.radius[k] - holder * holder;
    return sum * PI / RAYS;
}

double drape_coefficient(const struct scene *scene, const double *xyz)
{
    if (!is_disc(scene))
        return NAN;
    double *rest = metric_rest_field(scene);
    const double flat = area_beyond(scene, rest);
    free(rest);
    return area_beyond(scene, xyz) / flat;
}

double drape_folds(const struct scene *scene, const double *xyz)
{
    const double depth = DEPTH * scene->length;
    struct outline o;
    int lowest = 0, folds = 0;
    bool rises = true;

    if (!is_disc(scene))
        return NAN;
    start(scene, &o);
    if (!draw(scene, xyz, &o))
        return NAN;
    for (int k = 0; k < RAYS; k++)
        lowest = o.radius[k] < o.radius[lowest] ? k : lowest;
    double last = o.radius[lowest]; /* the extremum so far */
    for (int k = 1; k <= RAYS; k++) {
        const double r = o.radius[(lowest + k) % RAYS];
        if (rises ? r > last : r < last)
            last = r;
        else if (fabs(r - last) > depth) {
            folds += rises;
            rises = !rises, last = r;
        }
    }
    return folds;
}
