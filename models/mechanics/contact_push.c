#include "models/mechanics/contact_push.h"

#include <math.h>
#include <string.h>

#include "models/contact/contact_shape.h"

/* The most sweeps over a point between several obstacles, which push it to and fro. */
enum { MOST_SWEEPS = 100 };

/* A gap below this share of the length is closed to round-off. */
static const double CLOSED = 1e-15;

/* A point is not pushed along a normal whose free part is shorter than this. */
static const double LEAST_FREE = 1e-3;

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Takes up to mu push off the way of x across the normal, in free components. */
static void rub(double mu, double push, const double normal[3], const int *place,
                const double *start, double *x)
{
    double way[3];

    for (int i = 0; i < 3; i++)
        way[i] = place[i] < 0 ? 0 : x[i] - start[i];
    double along = dot(way, normal);
    for (int i = 0; i < 3; i++)
        way[i] = place[i] < 0 ? 0 : way[i] - along * normal[i];
    double size = sqrt(dot(way, way)), bound = mu * push;
    for (int i = 0; i < 3; i++)
        x[i] -= size > bound ? way[i] * (bound / size) : way[i];
}

/* Pushes x out of one obstacle; false if x was out of it. */
static bool push(const struct scene *scene, const struct scene_obstacle *obstacle,
                 double offset, const int *place, const double *start, double *x)
{
    double normal[3], free[3];
    double gap = contact_shape_distance(obstacle, NULL, x, normal) - offset;

    for (int i = 0; i < 3; i++)
        free[i] = place[i] < 0 ? 0 : normal[i];
    double room = dot(free, free);
    if (!(gap < -CLOSED * scene->length) || room < LEAST_FREE)
        return false;
    for (int i = 0; i < 3; i++)
        x[i] -= gap / room * free[i];
    if (obstacle->friction > 0)
        rub(obstacle->friction, -gap, normal, place, start, x);
    return true;
}

int contact_push_out(const struct scene *scene, const struct supports *supports,
                     double offset, const double *weight, const double *start, double *x,
                     double force[3])
{
    int pushed = 0;

    for (int a = 0; a < supports->nodes; a++) {
        const int *place = supports->free_index + 3 * a;
        double *at = x + 3 * a, from[3];
        bool moved = true, touched = false;
        memcpy(from, at, sizeof from);
        for (int sweep = 0; moved && sweep < MOST_SWEEPS; sweep++) {
            moved = false;
            for (int o = 0; o < scene->obstacle_count; o++)
                moved |=
                    push(scene, &scene->obstacles[o], offset, place, start + 3 * a, at);
            touched |= moved;
        }
        pushed += touched;
        for (int i = 0; touched && i < 3; i++)
            force[i] += weight[a] * (at[i] - from[i]);
    }
    return pushed;
}

double contact_push_gap(const struct scene *scene, long nodes, const double *x)
{
    return contact_least_gap(scene, 0, nodes, x) - scene->thickness / 2;
}
