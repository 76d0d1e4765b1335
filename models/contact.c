#include "models/contact.h"

#include <math.h>
#include <stddef.h>

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double contact_gap(const struct scene_obstacle *obstacle, const double x[3],
                   double normal[3])
{
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

double contact_least_gap(const struct scene *scene, long count, const double *x)
{
    double least = INFINITY;

    for (int o = 0; o < scene->obstacle_count; o++)
        for (long n = 0; n < count; n++) {
            double gap = contact_gap(&scene->obstacles[o], x + 3 * n, NULL);
            if (isnan(gap))
                return NAN;
            least = fmin(least, gap);
        }
    return least;
}
