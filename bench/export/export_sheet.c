#include "bench/export/export_sheet.h"

#include <math.h>

int export_sheet_columns(const struct export_sheet *s)
{
    return scene_sheets(s->scene) * s->points[0];
}

int export_sheet_vertices(const struct export_sheet *s)
{
    return export_sheet_columns(s) * s->points[1];
}

int export_sheet_place(const struct export_sheet *s, int column)
{
    return column + column / s->points[0] * 2;
}

/* Returns the sheet of place i, and finds which of its points that is. */
static int sheet_of(const struct export_sheet *s, int i, int *point)
{
    const int sheet = (i + 1) / (s->points[0] + 2);

    *point = i - sheet * (s->points[0] + 2);
    return sheet;
}

bool export_sheet_has(const struct export_sheet *s, int i, int j)
{
    int point;

    sheet_of(s, i, &point);
    return point >= 0 && point < s->points[0] && j >= 0 && j < s->points[1];
}

void export_sheet_point(const struct export_sheet *s, int i, int j, double uvw[3],
                        double xyz[3])
{
    int point;
    const int sheet = sheet_of(s, i, &point);
    const struct scene one = scene_sheet(s->scene, sheet);

    uvw[0] = point / (s->points[0] - 1.0);
    uvw[1] = j / (s->points[1] - 1.0);
    uvw[2] = 0.5;
    scene_rest_point(&one, uvw, xyz);
    uvw[0] = scene_sheet_u(s->scene, sheet, uvw[0]);
}

void export_sheet_vertex(const struct export_sheet *s, int vertex, double uvw[3],
                         double xyz[3])
{
    const int columns = export_sheet_columns(s);

    export_sheet_point(s, export_sheet_place(s, vertex % columns), vertex / columns, uvw,
                       xyz);
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
    own_part(vertex / export_sheet_columns(s), s->points[1], v);
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
