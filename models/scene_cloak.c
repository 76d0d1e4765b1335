#include "models/scene.h"

#include <math.h>

static const double PI = 3.14159265358979323846, DEGREE = 3.14159265358979323846 / 180;

bool scene_closed(const struct scene *scene)
{
    return scene->shape == SCENE_CLOAK && scene->opening == 360;
}

double scene_cloak_quarter_tangent(const struct scene *scene)
{
    return tan(scene->opening * DEGREE / 4);
}

double scene_cloak_angle(const struct scene *scene, double v)
{
    return scene_closed(scene) ? (2 * v - 1) * PI
                               : 2 * atan((2 * v - 1) * scene_cloak_quarter_tangent(scene));
}

double scene_cloak_across(const struct scene *scene, double phi)
{
    return (1 + (scene_closed(scene) ? phi / PI
                                     : tan(phi / 2) / scene_cloak_quarter_tangent(scene))) /
           2;
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
    if (scene_closed(scene)) {
        const double phi = scene_cloak_angle(scene, uvw[1]);
        scene_cloak_place(scene, z, r * sin(phi), r * cos(phi), xyz);
        return;
    }
    scene_cloak_place(scene, z, r * 2 * s / (1 + s * s), r * (1 - s * s) / (1 + s * s),
                      xyz);
}
