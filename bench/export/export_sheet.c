#include "bench/export/export_sheet.h"

#include <math.h>

int export_sheet_vertices(const struct export_sheet *s)
{
    return s->points[0] * s->points[1];
}

void export_sheet_point(const struct export_sheet *s, int i, int j, double uvw[3],
                        double xyz[3])
{
    uvw[0] = i / (s->points[0] - 1.0);
    uvw[1] = j / (s->points[1] - 1.0);
    uvw[2] = 0.5;
    scene_rest_point(s->scene, uvw, xyz);
}

void export_sheet_vertex(const struct export_sheet *s, int vertex, double uvw[3],
                         double xyz[3])
{
    export_sheet_point(s, vertex % s->points[0], vertex / s->points[0], uvw, xyz);
}

/* Returns the part within half a cell of point k of n, within [0, 1]. */
static void own_part(int k, int n, double part[2])
{
    part[0] = fmax(0, (k - 0.5) / (n - 1));
    part[1] = fmin(1, (k + 0.5) / (n - 1));
}

double export_sheet_area(const struct export_sheet *s, int vertex)
{
    const struct scene *scene = s->scene;
    double u[2], v[2], r, z;

    own_part(vertex % s->points[0], s->points[0], u);
    own_part(vertex / s->points[0], s->points[1], v);
    const double along = (u[1] - u[0]) * scene->length;
    if (scene->shape == SCENE_FLAT)
        return along * (v[1] - v[0]) * scene->width;
    scene_cloak_meridian(scene, (u[0] + u[1]) / 2, 0.5, &r, &z); /* linear in u */
    return along * r * (scene_cloak_angle(scene, v[1]) - scene_cloak_angle(scene, v[0]));
}

const char *export_sheet_axes(unsigned fix)
{
    static const char *const words[] = {"", "x", "y", "xy", "z", "xz", "yz", "xyz"};

    return words[fix & FIX_XYZ];
}
