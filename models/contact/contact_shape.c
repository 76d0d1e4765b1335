#include "models/contact/contact_shape.h"

#include <math.h>
#include <stddef.h>

/* The round-off of positions, relative to the largest; and the distance at which a plane's
 * point is taken for infinitely far, in widths. */
static const double ROUNDING = 1e-13, FAR = 1e12;

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void contact_pose_at(const struct scene_obstacle *o, double t, struct contact_pose *pose)
{
    (void)o, (void)t;
    *pose = (struct contact_pose){.turn = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
}

void contact_pose_carry(const struct contact_pose *to, const struct contact_pose *from,
                        const double x[3], double y[3])
{
    (void)to, (void)from;
    for (int i = 0; i < 3; i++)
        y[i] = x[i];
}

double contact_shape_distance(const struct scene_obstacle *obstacle,
                              const struct contact_pose *pose, const double x[3],
                              double normal[3])
{
    (void)pose;
    bool ball = obstacle->kind == OBSTACLE_SPHERE;
    double d[3];

    for (int i = 0; i < 3; i++)
        d[i] = x[i] - obstacle->point[i];
    const double *outward = ball ? d : obstacle->normal;
    double size = sqrt(dot(outward, outward));
    for (int i = 0; normal && i < 3; i++)
        normal[i] = size > 0 ? outward[i] / size : i == 2;
    return ball ? size - obstacle->radius : dot(d, outward) / size;
}

/* Returns v of the straight line along u that is nearest to a point d[3] from the origin:
 * on a cloak the one at its azimuth, or at the end of the opening nearer to that. */
static double nearest_line(const struct scene *scene, const double d[3])
{
    const double along = dot(d, scene->axis_v);
    double e_w[3], v = along / scene->width;

    if (scene->shape == SCENE_CLOAK) {
        scene_normal(scene, e_w);
        v = (1 + tan(atan2(along, dot(d, e_w)) / 2) / scene_cloak_quarter_tangent(scene)) /
            2;
    }
    return fmin(fmax(v, 0), 1);
}

double contact_rest_depth(const struct scene *scene, const struct scene_obstacle *obstacle)
{
    const bool ball = obstacle->kind == OBSTACLE_SPHERE;
    const double size = sqrt(dot(obstacle->normal, obstacle->normal));
    double d[3], a[3], b[3], ab[3];

    for (int i = 0; i < 3; i++) /* for a plane: a point far below it */
        d[i] = ball ? obstacle->point[i] - scene->origin[i]
                    : -FAR * scene->width * obstacle->normal[i] / size;
    const double v = nearest_line(scene, d);
    scene_rest_point(scene, (double[3]){0, v, 0.5}, a);
    scene_rest_point(scene, (double[3]){1, v, 0.5}, b);
    for (int i = 0; i < 3; i++) {
        ab[i] = b[i] - a[i];
        d[i] += scene->origin[i] - a[i];
    }
    const double u = fmin(fmax(dot(d, ab) / dot(ab, ab), 0), 1);
    for (int i = 0; i < 3; i++)
        a[i] += u * ab[i];
    const double depth =
        scene->thickness / 2 - contact_shape_distance(obstacle, NULL, a, NULL);
    const double far = sqrt(dot(a, a)) + sqrt(dot(obstacle->point, obstacle->point));
    return depth > ROUNDING * (far + obstacle->radius) ? depth : 0;
}

double contact_least_gap(const struct scene *scene, double t, long count, const double *x)
{
    double least = INFINITY;

    for (int o = 0; o < scene->obstacle_count; o++)
        for (long n = 0; n < count; n++) {
            struct contact_pose pose;
            contact_pose_at(&scene->obstacles[o], t, &pose);
            double gap =
                contact_shape_distance(&scene->obstacles[o], &pose, x + 3 * n, NULL);
            if (isnan(gap))
                return NAN;
            least = fmin(least, gap);
        }
    return least;
}
