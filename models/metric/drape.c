#include "models/metric/drape.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/grid.h"
#include "models/metric/metric_rest.h"
#include "models/pattern.h"
#include "models/vector.h"

static const double PI = 3.14159265358979323846;

enum { RAYS = 1440, LAYER = GRID_U * GRID_V };

/* Heights of folds that count, in widths of what hangs. */
static const double DEPTH = 0.02;

struct outline {
    double axis[3];      /* a point on it                                        [m]   */
    double holder, rim;  /* radii                                                [m]   */
    double across[2][3]; /* axes of its plane, across gravity                          */
    double radius[RAYS]; /* [m]                                                        */
};

/* How far a border may be from round, in shares of its radius. */
static const double ROUND = 0.02;

/* Finds the least and largest distance of places [m] from a pattern's middle. */
static void radii(const struct pattern *p, int count, const double (*at)[2],
                  const double scale[2], double radius[2])
{
    radius[0] = INFINITY, radius[1] = 0;
    for (int n = 0; n < count; n++) {
        const double r = hypot(at[n][0] * scale[0] - p->size[0] / 2,
                               at[n][1] * scale[1] - p->size[1] / 2);
        radius[0] = fmin(radius[0], r), radius[1] = fmax(radius[1], r);
    }
}

/* Finds holder and rim; false: the sheet is no disc that a smaller one holds. */
static bool find_disc(const struct scene *scene, struct outline *o)
{
    const struct pattern *p = scene->pattern;
    double rim[2], held[2], z;

    if (!(vector_length(scene->gravity) > 0))
        return false;
    if (scene_closed(scene) && scene->flare == 90) {
        memcpy(o->axis, scene->origin, sizeof o->axis);
        scene_cloak_meridian(scene, 0, 0.5, &o->holder, &z);
        scene_cloak_meridian(scene, 1, 0.5, &o->rim, &z);
        return true;
    }
    if (!p || p->lines != 1 || p->start || scene->support_count != 1 ||
        !scene->supports[0].part_count || scene->supports[0].fix != FIX_XYZ)
        return false;
    const struct scene_support *s = &scene->supports[0];
    radii(p, p->points, (const double(*)[2])p->at, (double[]){1, 1}, rim);
    radii(p, 3 * s->part_count, (const double(*)[2])s->part[0], p->size, held);
    scene_rest_point(scene, (const double[3]){0.5, 0.5, 0.5}, o->axis);
    o->holder = held[1], o->rim = rim[1];
    return rim[1] - rim[0] < ROUND * rim[1];
}

/* Sets the plane, and the holder as the outline; false as find_disc. */
static bool start(const struct scene *scene, struct outline *o)
{
    if (!find_disc(scene, o))
        return false;
    vector_cross(scene->gravity, scene->axis_v, o->across[0]);
    vector_cross(scene->gravity, o->across[0], o->across[1]);
    for (int d = 0; d < 2; d++) {
        const double size = vector_length(o->across[d]);
        for (int c = 0; c < 3; c++)
            o->across[d][c] /= size;
    }
    for (int k = 0; k < RAYS; k++)
        o->radius[k] = o->holder;
    return true;
}

/* Computes the shadow of a point of the mid-surface, from the axis. */
static void shadow(const struct outline *o, const double *xyz, int n, double p[2])
{
    double way[3];

    for (int c = 0; c < 3; c++)
        way[c] = (xyz[3 * n + c] + xyz[3 * (n + LAYER) + c]) / 2 - o->axis[c];
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

/* Computes the shadow of a place x, y of a pattern: bilinear in the grid's cell there, or
 * continued from the next one towards the middle that is whole. */
static void shadow_at(const struct scene *scene, const struct outline *o, const double *xyz,
                      const double at[2], double p[2])
{
    const double *size = scene->pattern->size;
    const double place[2] = {at[0] / size[0] * (GRID_U - 1),
                             at[1] / size[1] * (GRID_V - 1)};
    double from[2] = {place[0], place[1]};
    bool whole = false;
    int i = 0, j = 0;

    for (int step = 0; !whole && step < GRID_U; step++) {
        i = (int)fmin(fmax(floor(from[0]), 0), GRID_U - 2);
        j = (int)fmin(fmax(floor(from[1]), 0), GRID_V - 2);
        whole = true;
        for (int k = 0; k < 4; k++)
            whole &= !scene_void(scene, i + k % 2, j + k / 2);
        from[0] += ((GRID_U - 1) / 2. - from[0]) * 0.01;
        from[1] += ((GRID_V - 1) / 2. - from[1]) * 0.01;
    }
    p[0] = p[1] = 0;
    for (int k = 0; k < 4; k++) {
        const double a = place[0] - i, b = place[1] - j;
        const double share = (k % 2 ? a : 1 - a) * (k / 2 ? b : 1 - b);
        double corner[2];
        shadow(o, xyz, (j + k / 2) * GRID_U + i + k % 2, corner);
        p[0] += share * corner[0], p[1] += share * corner[1];
    }
}

/* Draws a pattern's border, each side in several parts. */
static void draw_border(const struct scene *scene, const double *xyz, struct outline *o)
{
    enum { PARTS = 4 };
    const struct pattern *border = scene->pattern;

    for (int n = 0; n < PARTS * border->points; n++) {
        const double *a = border->at[n / PARTS], *b = border->at[border->next[n / PARTS]];
        double p[2], q[2], at[2][2];
        for (int k = 0; k < 2; k++)
            for (int c = 0; c < 2; c++)
                at[k][c] = a[c] + (b[c] - a[c]) * (n % PARTS + k) / PARTS;
        shadow_at(scene, o, xyz, at[0], p);
        shadow_at(scene, o, xyz, at[1], q);
        take(o, p, q);
    }
}

/* Draws the lines of the grid; false: a coordinate is not finite. */
static bool draw(const struct scene *scene, const double *xyz, struct outline *o)
{
    for (int n = 0; n < LAYER; n++) {
        double p[2], q[2];
        shadow(o, xyz, n, p);
        if (scene_void(scene, n % GRID_U, n / GRID_U))
            continue;
        if (!isfinite(p[0]) || !isfinite(p[1]))
            return false;
        for (int d = 0; d < 2; d++)
            if (d ? n + GRID_U < LAYER : (n + 1) % GRID_U != 0) {
                shadow(o, xyz, n + (d ? GRID_U : 1), q);
                if (isfinite(q[0]) && isfinite(q[1]))
                    take(o, p, q);
            }
    }
    if (scene->pattern)
        draw_border(scene, xyz, o);
    return true;
}

/* Returns the area beyond the holder [m^2], NaN: there is none. */
static double area_beyond(const struct scene *scene, const double *xyz)
{
    struct outline o;
    double sum = 0;

    if (!xyz || !start(scene, &o) || !draw(scene, xyz, &o))
        return NAN;
    for (int k = 0; k < RAYS; k++)
        sum += o.radius[k] * o.radius[k] - o.holder * o.holder;
    return sum * PI / RAYS;
}

double drape_coefficient(const struct scene *scene, const double *xyz)
{
    struct outline o;

    if (!find_disc(scene, &o))
        return NAN;
    double *rest = metric_rest_field(scene);
    const double flat = area_beyond(scene, rest);
    free(rest);
    return area_beyond(scene, xyz) / flat;
}

double drape_folds(const struct scene *scene, const double *xyz)
{
    struct outline o;
    int lowest = 0, folds = 0;
    bool rises = true;

    if (!start(scene, &o) || !draw(scene, xyz, &o))
        return NAN;
    const double depth = DEPTH * (o.rim - o.holder);
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
