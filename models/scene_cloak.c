#include "models/scene.h"

#include <math.h>

static const double DEGREE = 3.14159265358979323846 / 180;

double scene_cloak_quarter_tangent(const struct scene *scene)
{
    return tan(scene->opening * DEGREE / 4);
}

void scene_cloak_meridian(const struct scene *scene, double u, double w, double *r,
                          double *z)
{
    double sine = sin(scene->flare * DEGREE), cosine = cos(scene->flare * DEGREE);
    double along = u * scene->length, across = (w - 0.5) * scene->thickness;

    *r = scene->width / (scene->opening * DEGREE) + along * sine + across * cosine;
    *z = along * cosine - across * sine;
}

void scene_cloak_place(const struct scene *scene, double z, double along_v, double along_w,
                       double xyz[3])
{
    double e_w[3];

    scene_normal(scene, e_w);
    for (int i = 0; i < 3; i++)
        xyz[i] = scene->origin[i] + z * scene->axis_u[i] + along_v * scene->axis_v[i] +
                 along_w * e_w[i];
}

void scene_cloak_point(const struct scene *scene, const double uvw[3], double xyz[3])
{
    double s = (2 * uvw[1] - 1) * scene_cloak_quarter_tangent(scene), r, z;

    scene_cloak_meridian(scene, uvw[0], uvw[2], &r, &z);
    scene_cloak_place(scene, z, r * 2 * s / (1 + s * s), r * (1 - s * s) / (1 + s * s),
                      xyz);
}
