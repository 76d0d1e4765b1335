#include "models/contact/contact_rest.h"

#include <math.h>
#include <string.h>

#include "models/contact/contact.h"
#include "models/contact/contact_foot.h"
#include "models/contact/contact_law.h"
#include "models/bodies/body_shape.h"
#include "models/pattern.h"
#include "models/vector.h"

/* The round-off of positions, relative to the largest; and the distance at which a plane's
 * point is taken for infinitely far, in widths. */
static const double ROUNDING = 1e-13, FAR = 1e12;

/* Returns v of the straight line along u that is nearest to a point d[3] from the origin:
 * on a cloak the one at its azimuth, or at the end of the opening nearer to that. */
static double nearest_line(const struct scene *scene, const double d[3])
{
    const double along = vector_dot(d, scene->axis_v);
    double e_w[3], v = along / scene->width;

    if (scene->shape == SCENE_CLOAK) {
        scene_normal(scene, e_w);
        v = scene_cloak_across(scene, atan2(along, vector_dot(d, e_w)));
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

/* This is a search for the least distance of the mid-surface at rest. */
struct least {
    const struct scene *scene;
    const struct scene_obstacle *obstacle;
    struct scene_placement pose;
    double distance; /* least so far, or that of contact                        [m]   */
    double place[3];
};

/* Returns the distance of x, at (u,v), or some number from `most` up to it. */
static double try_point(struct least *l, double u, double v, const double x[3], double most)
{
    const struct scene *scene = l->scene;
    const double distance = body_shape_near(l->obstacle, &l->pose, x, most, NULL);

    if (distance < l->distance &&
        (!scene->pattern ||
         pattern_has(scene->pattern, u * scene->length, v * scene->width))) {
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
    const double middle =
        try_point(l, from[0] + half, from[1] + half, x, l->distance + reach);
    if (middle - reach >= l->distance)
        return;
    for (int k = 0; k < 4; k++)
        if (level == FINEST)
            try_point(l, from[0] + 2 * half * (k & 1), from[1] + half * (k & 2), corner[k],
                      l->distance);
        else
            search_part(l, level + 1,
                        (double[2]){from[0] + half * (k & 1), from[1] + half * (k >> 1)});
}

/* Searches the corners of an outline, or of all triangles that start in space. */
static void search_corners(struct least *l)
{
    const struct pattern *p = l->scene->pattern;
    const bool raised = pattern_starts_in_space(p);
    const double(*at)[2] = (const double(*)[2])(!p ? NULL : raised ? p->mesh.at : p->at);

    for (int n = 0; p && n < (raised ? p->mesh.nodes : p->points); n++) {
        const double u = at[n][0] / l->scene->length, v = at[n][1] / l->scene->width;
        double x[3];
        if (raised)
            scene_pose_point(l->scene, p->start[p->node[n]], x);
        else
            scene_rest_point(l->scene, (double[3]){u, v, .5}, x);
        try_point(l, u, v, x, l->distance);
    }
}

static double depth_of_sheet(const struct scene *scene, const struct scene_obstacle *o)
{
    struct least l = {.scene = scene, .obstacle = o};
    const double start = contact_law_body(scene).start;

    scene_motion_at(&o->motion, 0, &l.pose);
    l.distance = start;
    if ((o->kind == OBSTACLE_PLANE || o->kind == OBSTACLE_SPHERE) &&
        !o->motion.turn_count && !scene->pattern) {
        nearest_point(scene, o, l.pose.shift, l.place);
        l.distance = body_shape_distance(o, &l.pose, l.place, NULL);
    } else {
        search_corners(&l);
        if (scene_starts_flat(scene) || !scene->pattern)
            search_part(&l, 0, (double[2]){0, 0});
    }
    const double depth = start - l.distance;
    const double far = vector_length(l.place) + vector_length(o->point);
    return depth > ROUNDING * (far + o->radius) ? depth : 0;
}

double contact_rest_depth(const struct scene *scene, const struct scene_obstacle *o)
{
    double depth = 0;

    for (int k = 0; k < scene_sheets(scene); k++) {
        const struct scene one = scene_sheet(scene, k);
        depth = fmax(depth, depth_of_sheet(&one, o));
    }
    return depth;
}

/* Tells whether the way from p to q goes through a sheet. */
static bool goes_through(const struct scene *sheet, const double p[3], const double q[3])
{
    double e_w[3], way[2][3], at[3];

    scene_normal(sheet, e_w);
    vector_between(sheet->origin, p, way[0]);
    vector_between(sheet->origin, q, way[1]);
    const double a = vector_dot(way[0], e_w), b = vector_dot(way[1], e_w), t = a / (a - b);
    for (int i = 0; i < 3; i++)
        at[i] = way[0][i] + t * (way[1][i] - way[0][i]);
    const double u = vector_dot(at, sheet->axis_u), v = vector_dot(at, sheet->axis_v);
    return t >= 0 && t <= 1 && u >= 0 && u <= sheet->length && v >= 0 && v <= sheet->width;
}

/* Returns the least distance of the corners and edges of a sheet from another, whose
 * corners are q: those around each; 0 where an edge goes through it [m]. */
static double distance_from(const struct scene *other, const double p[4][3],
                            const double q[4][3])
{
    double least = INFINITY, share[3];

    for (int k = 0; k < 4; k++) {
        const double *const half[2][3] = {{q[0], q[1], q[2]}, {q[0], q[2], q[3]}};
        for (int h = 0; h < 2; h++)
            least = fmin(least, sqrt(contact_foot_nearest(p[k], half[h], share)));
        for (int l = 0; l < 4; l++) {
            const double *const edges[] = {p[k], p[(k + 1) % 4], q[l], q[(l + 1) % 4]};
            least = fmin(least, contact_foot_between(edges, share));
        }
        if (goes_through(other, p[k], p[(k + 1) % 4]))
            least = 0;
    }
    return least;
}

double contact_rest_overlap(const struct scene *scene, int sheet, int *before)
{
    const double start = contact_law_self(scene).start;
    double p[4][3], q[4][3], most = 0;

    for (int k = 0; k < sheet && scene->contact.self; k++) {
        const struct scene one = scene_sheet(scene, sheet), other = scene_sheet(scene, k);
        for (int n = 0; n < 4; n++) {
            const double uvw[3] = {n == 1 || n == 2, n > 1, 0.5};
            scene_rest_point(&one, uvw, p[n]);
            scene_rest_point(&other, uvw, q[n]);
        }
        const double least =
            fmin(distance_from(&other, (const double(*)[3])p, (const double(*)[3])q),
                 distance_from(&one, (const double(*)[3])q, (const double(*)[3])p));
        if (start - least > fmax(most, ROUNDING * (vector_length(p[0]) + scene->length)))
            most = start - least, *before = k;
    }
    return most;
}

enum status contact_rest_refuse(const struct scene *scene, const struct discretization *d,
                                struct message *why)
{
    if (!contact_wanted(scene))
        return STATUS_OK;
    if (d->kinematics == KINEMATICS_LINEAR)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "unsupported: no contact with kinematics=linear, which is for "
                           "small displacements about the rest shape; use "
                           "kinematics=nonlinear");
    if (d->contact == CONTACT_NET && (scene_closed(scene) || scene_sheets(scene) > 1))
        return status_fail(why, STATUS_UNSUPPORTED,
                           "contact=control_points is for one sheet that is not closed; "
                           "use contact=surface");
    for (int o = 0; o < scene->obstacle_count; o++) {
        const double depth = contact_rest_depth(scene, &scene->obstacles[o]);
        if (depth > 0)
            return status_fail(why, STATUS_INPUT, CONTACT_REST_DEPTH, depth, o);
    }
    for (int k = 1, before; k < scene->sheets; k++) {
        const double overlap = contact_rest_overlap(scene, k, &before);
        if (overlap > 0)
            return status_fail(why, STATUS_INPUT, CONTACT_REST_OVERLAP, k + 1, overlap,
                               before + 1);
    }
    return STATUS_OK;
}
