#include "models/contact/contact_shape.h"

#include <math.h>
#include <string.h>

#include "models/contact/contact_law.h"
#include "models/contact/contact_mesh.h"
#include "models/vector.h"

/* The round-off of positions, relative to the largest; and the distance at which a plane's
 * point is taken for infinitely far, in widths. */
static const double ROUNDING = 1e-13, FAR = 1e12;

static const double PI = 3.14159265358979323846;

/* Sets turn to the rotation by an angle about a unit axis (Rodrigues). */
static void rotation(const double axis[3], double angle, double turn[3][3])
{
    const double c = cos(angle), s = sin(angle);

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const int sign = (j - i + 3) % 3 == 1 ? -1 : (j - i + 3) % 3 == 2 ? 1 : 0;
            turn[i][j] = (1 - c) * axis[i] * axis[j] + (i == j) * c +
                         (sign ? sign * s * axis[3 - i - j] : 0);
        }
}

void contact_pose_at(const struct scene_obstacle *o, double t, struct contact_pose *pose)
{
    double shift[3], angle;

    *pose = (struct contact_pose){.turn = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    scene_table_at(o->path_count, 4, (const double *)o->path, t, shift);
    scene_table_at(o->turn_count, 2, (const double *)o->turn, t, &angle);
    if (angle != 0)
        rotation(o->turn_axis, angle * PI / 180, pose->turn);
    for (int i = 0; i < 3; i++)
        pose->shift[i] =
            shift[i] +
            (angle != 0 ? o->turn_point[i] - vector_dot(pose->turn[i], o->turn_point) : 0);
}

/* Computes y = turn x, or its inverse. */
static void turned(const struct contact_pose *pose, bool back, const double x[3],
                   double y[3])
{
    for (int i = 0; i < 3; i++) {
        y[i] = 0;
        for (int j = 0; j < 3; j++)
            y[i] += (back ? pose->turn[j][i] : pose->turn[i][j]) * x[j];
    }
}

/* Computes the point X where the scene places the body's point at x. */
static void to_body(const struct contact_pose *pose, const double x[3], double X[3])
{
    double d[3];

    vector_between(pose->shift, x, d);
    turned(pose, true, d, X);
}

void contact_pose_carry(const struct contact_pose *to, const struct contact_pose *from,
                        const double x[3], double y[3])
{
    double X[3];

    to_body(to, x, X);
    turned(from, false, X, y);
    for (int i = 0; i < 3; i++)
        y[i] += from->shift[i];
}

/* Sets the normal along d, of the given length; if that is 0 along any direction across
 * `axis` (NULL: z). */
static void set_normal(const double d[3], double size, const double *axis, double normal[3])
{
    static const double up[3] = {0, 0, 1};
    double any[3] = {0, 0, 0};
    int least = 0;

    if (size > 0 || !axis) {
        for (int i = 0; i < 3; i++)
            normal[i] = size > 0 ? d[i] / size : up[i];
        return;
    }
    for (int i = 1; i < 3; i++)
        least = fabs(axis[i]) < fabs(axis[least]) ? i : least;
    any[least] = 1;
    vector_cross(axis, any, normal);
    size = vector_length(normal);
    for (int i = 0; i < 3; i++)
        normal[i] = size > 0 ? normal[i] / size : up[i];
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
        return contact_mesh_distance(o->mesh, x, most, normal);
    return isnan(vector_dot(x, x)) ? NAN : INFINITY;
}

double contact_shape_near(const struct scene_obstacle *o, const struct contact_pose *pose,
                          const double x[3], double most, double normal[3])
{
    double X[3] = {x[0], x[1], x[2]}, n[3] = {0, 0, 1}, distance = NAN;

    if (pose)
        to_body(pose, x, X);
    switch (o->kind) {
    case OBSTACLE_PLANE:
        distance = from_plane(o, X, n);
        break;
    case OBSTACLE_SPHERE:
        distance = from_sphere(o, X, n);
        break;
    case OBSTACLE_CAPSULE:
        distance = from_capsule(o, X, n);
        break;
    case OBSTACLE_BOX:
        distance = from_box(o, X, n);
        break;
    case OBSTACLE_MESH:
        distance = from_mesh(o, X, most, n);
        break;
    case OBSTACLE_KINDS:
        break;
    }
    if (normal && pose)
        turned(pose, false, n, normal);
    else if (normal)
        memcpy(normal, n, sizeof n);
    return distance;
}

double contact_shape_distance(const struct scene_obstacle *o,
                              const struct contact_pose *pose, const double x[3],
                              double normal[3])
{
    return contact_shape_near(o, pose, x, INFINITY, normal);
}

/* Returns v of the straight line along u that is nearest to a point d[3] from the origin:
 * on a cloak the one at its azimuth, or at the end of the opening nearer to that. */
static double nearest_line(const struct scene *scene, const double d[3])
{
    const double along = vector_dot(d, scene->axis_v);
    double e_w[3], v = along / scene->width;

    if (scene->shape == SCENE_CLOAK) {
        scene_normal(scene, e_w);
        v = (1 + tan(atan2(along, vector_dot(d, e_w)) / 2) /
                     scene_cloak_quarter_tangent(scene)) /
            2;
    }
    return fmin(fmax(v, 0), 1);
}

/* Computes the point of the sheet nearest to a ball's centre, or the lowest over a plane.
 */
static void nearest_point(const struct scene *scene, const struct scene_obstacle *o,
                          const double shift[3], double x[3])
{
    const bool ball = o->kind == OBSTACLE_SPHERE;
    const double size = vector_length(o->normal);
    double d[3], b[3], ab[3];

    for (int i = 0; i < 3; i++) /* for a plane: a point far below it */
        d[i] = ball ? o->point[i] + shift[i] - scene->origin[i]
                    : -FAR * scene->width * o->normal[i] / size;
    const double v = nearest_line(scene, d);
    scene_rest_point(scene, (double[3]){0, v, 0.5}, x);
    scene_rest_point(scene, (double[3]){1, v, 0.5}, b);
    for (int i = 0; i < 3; i++) {
        ab[i] = b[i] - x[i];
        d[i] += scene->origin[i] - x[i];
    }
    const double u = fmin(fmax(vector_dot(d, ab) / vector_dot(ab, ab), 0), 1);
    for (int i = 0; i < 3; i++)
        x[i] += u * ab[i];
}

/* A search for the least distance of the mid-surface at rest. */
struct least {
    const struct scene *scene;
    const struct scene_obstacle *obstacle;
    struct contact_pose pose;
    double distance; /* least so far, or that of contact                        [m]   */
    double place[3];
};

/* Returns the distance of x, or some number from `most` up to it. */
static double try_point(struct least *l, const double x[3], double most)
{
    const double distance = contact_shape_near(l->obstacle, &l->pose, x, most, NULL);

    if (distance < l->distance) {
        l->distance = distance;
        memcpy(l->place, x, sizeof l->place);
    }
    return distance;
}

/* Searches the part of size 2^-level that begins at from[2]. The distance of a point
 * differs from that of the middle by no more than they are apart. */
static void search_part(struct least *l, int level, const double from[2])
{
    enum { FINEST = 7 };
    const double half = ldexp(0.5, -level);
    double x[3], corner[4][3], reach = 0;

    scene_rest_point(l->scene, (double[3]){from[0] + half, from[1] + half, .5}, x);
    for (int k = 0; k < 4; k++) {
        double way[3];
        scene_rest_point(
            l->scene,
            (double[3]){from[0] + 2 * half * (k & 1), from[1] + half * (k & 2), .5},
            corner[k]);
        vector_between(x, corner[k], way);
        reach = fmax(reach, vector_length(way));
    }
    const double middle = try_point(l, x, l->distance + reach);
    if (middle - reach >= l->distance)
        return;
    for (int k = 0; k < 4; k++)
        if (level == FINEST)
            try_point(l, corner[k], l->distance);
        else
            search_part(l, level + 1,
                        (double[2]){from[0] + half * (k & 1), from[1] + half * (k >> 1)});
}

double contact_rest_depth(const struct scene *scene, const struct scene_obstacle *o)
{
    struct least l = {.scene = scene, .obstacle = o};
    const double start = contact_law_body(scene).start;

    contact_pose_at(o, 0, &l.pose);
    l.distance = start;
    if ((o->kind == OBSTACLE_PLANE || o->kind == OBSTACLE_SPHERE) && !o->turn_count) {
        nearest_point(scene, o, l.pose.shift, l.place);
        l.distance = contact_shape_distance(o, &l.pose, l.place, NULL);
    } else
        search_part(&l, 0, (double[2]){0, 0});
    const double depth = start - l.distance;
    const double far = vector_length(l.place) + vector_length(o->point);
    return depth > ROUNDING * (far + o->radius) ? depth : 0;
}

double contact_least_gap(const struct scene *scene, double t, long count, const double *x)
{
    double least = INFINITY;

    for (int o = 0; o < scene->obstacle_count; o++) {
        struct contact_pose pose;
        contact_pose_at(&scene->obstacles[o], t, &pose);
        for (long n = 0; n < count; n++) {
            double gap =
                contact_shape_near(&scene->obstacles[o], &pose, x + 3 * n, least, NULL);
            if (isnan(gap))
                return NAN;
            least = fmin(least, gap);
        }
    }
    return least;
}
