#include "models/bodies/body_shape.h"

#include <math.h>
#include <string.h>

#include "models/bodies/body_mesh.h"
#include "models/vector.h"

void body_shape_carry(const struct scene_placement *to, const struct scene_placement *from,
                      const double x[3], double y[3])
{
    double X[3];

    scene_placement_back(to, x, X);
    scene_placement_point(from, X, y);
}

/* Sets the normal along d, of the given length; if that is 0 along any direction across
 * `axis` (NULL: z). */
static void set_normal(const double d[3], double size, const double *axis, double normal[3])
{
    double any[3] = {0, 0, 0}, across[3];
    int least = 0;

    if (!(size > 0) && axis) {
        for (int i = 1; i < 3; i++)
            least = fabs(axis[i]) < fabs(axis[least]) ? i : least;
        any[least] = 1;
        vector_cross(axis, any, across);
        d = across, size = vector_length(d);
    }
    for (int i = 0; i < 3; i++)
        normal[i] = size > 0 ? d[i] / size : i == 2;
}

static double from_plane(const struct scene_obstacle *o, const double x[3],
                         double normal[3])
{
    const double size = vector_length(o->normal);
    double d[3];

    vector_between(o->point, x, d);
    set_normal(o->normal, size, NULL, normal);
    return vector_dot(d, o->normal) / size;
}

static double from_sphere(const struct scene_obstacle *o, const double x[3],
                          double normal[3])
{
    double d[3];

    vector_between(o->point, x, d);
    const double size = vector_length(d);
    set_normal(d, size, NULL, normal);
    return size - o->radius;
}

static double from_capsule(const struct scene_obstacle *o, const double x[3],
                           double normal[3])
{
    double d[3], axis[3];

    vector_between(o->point, x, d);
    vector_between(o->point, o->end, axis);
    const double square = vector_dot(axis, axis);
    const double s = square > 0 ? fmin(fmax(vector_dot(d, axis) / square, 0), 1) : 0;
    for (int i = 0; i < 3; i++)
        d[i] -= s * axis[i];
    const double size = vector_length(d);
    set_normal(d, size, axis, normal);
    return size - o->radius;
}

static double from_box(const struct scene_obstacle *o, const double x[3], double normal[3])
{
    double axis[3][3], d[3], off[3], depth = -INFINITY, square = 0;
    int face = 0;

    memcpy(axis, o->axis, sizeof o->axis);
    vector_cross(axis[0], axis[1], axis[2]);
    vector_between(o->point, x, d);
    for (int k = 0; k < 3; k++) {
        const double along = vector_dot(d, axis[k]), beyond = fabs(along) - o->size[k] / 2;
        if (beyond > depth || isnan(beyond))
            depth = beyond, face = k;
        off[k] = copysign(fmax(beyond, 0), along);
        square += off[k] * off[k];
    }
    if (!(depth > 0)) { /* inside, or NaN */
        for (int i = 0; i < 3; i++)
            normal[i] = vector_dot(d, axis[face]) < 0 ? -axis[face][i] : axis[face][i];
        return depth;
    }
    const double size = sqrt(square);
    for (int i = 0; i < 3; i++)
        normal[i] =
            (off[0] * axis[0][i] + off[1] * axis[1][i] + off[2] * axis[2][i]) / size;
    return size;
}

static double from_mesh(const struct scene_obstacle *o, const double x[3], double most,
                        double normal[3])
{
    if (o->mesh)
        return body_mesh_distance(o->mesh, x, most, normal);
    return isnan(vector_dot(x, x)) ? NAN : INFINITY;
}

double body_shape_near(const struct scene_obstacle *o, const struct scene_placement *pose,
                       const double x[3], double most, double normal[3])
{
    static double (*const from[])(const struct scene_obstacle *, const double[3],
                                  double[3]) = {[OBSTACLE_PLANE] = from_plane,
                                                [OBSTACLE_SPHERE] = from_sphere,
                                                [OBSTACLE_CAPSULE] = from_capsule,
                                                [OBSTACLE_BOX] = from_box};
    double X[3] = {x[0], x[1], x[2]}, n[3] = {0, 0, 1};

    if (pose)
        scene_placement_back(pose, x, X);
    const double distance =
        o->kind == OBSTACLE_MESH ? from_mesh(o, X, most, n) : from[o->kind](o, X, n);
    if (normal && pose)
        scene_placement_turn(pose, n, normal);
    else if (normal)
        memcpy(normal, n, sizeof n);
    return distance;
}

double body_shape_distance(const struct scene_obstacle *o,
                           const struct scene_placement *pose, const double x[3],
                           double normal[3])
{
    return body_shape_near(o, pose, x, INFINITY, normal);
}

double body_shape_least_gap(const struct scene *scene, double t, long count,
                            const double *x)
{
    double least = INFINITY;

    for (int o = 0; o < scene->obstacle_count; o++) {
        struct scene_placement pose;
        scene_motion_at(&scene->obstacles[o].motion, t, &pose);
        for (long n = 0; n < count; n++) {
            double gap =
                body_shape_near(&scene->obstacles[o], &pose, x + 3 * n, least, NULL);
            if (isnan(gap) && scene->pattern)
                continue;
            if (isnan(gap))
                return NAN;
            least = fmin(least, gap);
        }
    }
    return least;
}
