#include "bench/export/export_parts.h"

#include <math.h>
#include <string.h>

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

/* Returns the place of v around the axis, over the sheet's width at the upper edge's radius
 * 1 [rad]. */
static double around(const struct scene *scene, double v)
{
    return 2 * atan((2 * v - 1) * scene_cloak_quarter_tangent(scene));
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
    return along * r * (around(scene, v[1]) - around(scene, v[0]));
}

/* Finds the corners of the n-th triangle, counted from 0: counter-clockwise seen from where
 * u x v points. A cell's diagonals alternate, so that the mesh has no bias. */
static void triangle(const struct export_sheet *s, int n, int corner[3])
{
    const int cells = s->points[0] - 1, i = n / 2 % cells, j = n / 2 / cells;
    const int a = j * s->points[0] + i, b = a + 1, d = a + s->points[0], c = d + 1;
    const int cell[2][2][3] = {{{a, b, c}, {a, c, d}}, {{a, b, d}, {b, c, d}}};

    memcpy(corner, cell[(i + j) % 2][n % 2], 3 * sizeof *corner);
}

static int triangles(const struct export_sheet *s)
{
    return 2 * (s->points[0] - 1) * (s->points[1] - 1);
}

enum status export_sheet_obj(struct export_job *j, struct output *out)
{
    const struct export_sheet *s = &j->sheet;
    double uvw[3], x[3];
    int c[3];

    output_print(out, "# %s at rest [m]; vt = u v; %d x %d vertices, u fastest\no sheet\n",
                 s->scene->name, s->points[0], s->points[1]);
    for (int n = 0; n < export_sheet_vertices(s); n++) {
        export_sheet_vertex(s, n, uvw, x);
        output_print(out, "v %.17g %.17g %.17g\n", x[0], x[1], x[2]);
    }
    for (int n = 0; n < export_sheet_vertices(s); n++) {
        export_sheet_vertex(s, n, uvw, x);
        output_print(out, "vt %.17g %.17g\n", uvw[0], uvw[1]);
    }
    for (int n = 0; n < triangles(s); n++) {
        triangle(s, n, c);
        output_print(out, "f %d/%d %d/%d %d/%d\n", c[0] + 1, c[0] + 1, c[1] + 1, c[1] + 1,
                     c[2] + 1, c[2] + 1);
    }
    return STATUS_OK;
}

/* Writes rest.ply; s, t are what Blender and others call u, v. */
enum status export_sheet_ply(struct export_job *j, struct output *out)
{
    const struct export_sheet *s = &j->sheet;
    double uvw[3], x[3];
    int c[3];

    output_print(out,
                 "ply\nformat ascii 1.0\ncomment %s at rest [m]; s t = u v; u fastest\n"
                 "element vertex %d\nproperty double x\nproperty double y\n"
                 "property double z\nproperty double s\nproperty double t\n"
                 "element face %d\nproperty list uchar int vertex_indices\nend_header\n",
                 s->scene->name, export_sheet_vertices(s), triangles(s));
    for (int n = 0; n < export_sheet_vertices(s); n++) {
        export_sheet_vertex(s, n, uvw, x);
        output_print(out, "%.17g %.17g %.17g %.17g %.17g\n", x[0], x[1], x[2], uvw[0],
                     uvw[1]);
    }
    for (int n = 0; n < triangles(s); n++) {
        triangle(s, n, c);
        output_print(out, "3 %d %d %d\n", c[0], c[1], c[2]);
    }
    return STATUS_OK;
}

enum status export_sheet_csv(struct export_job *j, struct output *out)
{
    const struct export_sheet *s = &j->sheet;
    double uvw[3], x[3];

    output_print(out, "vertex,u,v,x,y,z\n");
    for (int n = 0; n < export_sheet_vertices(s); n++) {
        export_sheet_vertex(s, n, uvw, x);
        output_print(out, "%d,%.17g,%.17g,%.17g,%.17g,%.17g\n", n, uvw[0], uvw[1], x[0],
                     x[1], x[2]);
    }
    return STATUS_OK;
}

const char *export_sheet_axes(unsigned fix)
{
    static const char *const words[] = {"", "x", "y", "xy", "z", "xz", "yz", "xyz"};

    return words[fix & FIX_XYZ];
}
