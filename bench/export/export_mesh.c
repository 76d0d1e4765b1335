/* Writes the mesh at rest. */
#include "bench/export/export_parts.h"

#include <string.h>

#include "models/contact/contact_mesh.h"

void export_mesh_triangle(const struct export_sheet *s, int n, int corner[3])
{
    const int columns = export_sheet_columns(s), cells = s->points[0] - 1,
              row = columns - columns / s->points[0], /* cells in a row */
        i = n / 2 % row, j = n / 2 / row;
    const int a = j * columns + i + i / cells, b = a + 1, d = a + columns, c = d + 1;
    const int cell[2][2][3] = {{{a, b, c}, {a, c, d}}, {{a, b, d}, {b, c, d}}};

    memcpy(corner, cell[(i % cells + j) % 2][n % 2], 3 * sizeof *corner);
}

int export_mesh_triangles(const struct export_sheet *s)
{
    return 2 * scene_sheets(s->scene) * (s->points[0] - 1) * (s->points[1] - 1);
}

enum status export_mesh_obj(struct export_job *j, struct output *out)
{
    const struct export_sheet *s = &j->sheet;
    double uvw[3], x[3];
    int c[3];

    output_print(out, "# %s at rest [m]; vt = u v; %d x %d vertices, u fastest\no sheet\n",
                 s->scene->name, export_sheet_columns(s), s->points[1]);
    for (int n = 0; n < export_sheet_vertices(s); n++) {
        export_sheet_vertex(s, n, uvw, x);
        output_print(out, "v %.17g %.17g %.17g\n", x[0], x[1], x[2]);
    }
    for (int n = 0; n < export_sheet_vertices(s); n++) {
        export_sheet_vertex(s, n, uvw, x);
        output_print(out, "vt %.17g %.17g\n", uvw[0], uvw[1]);
    }
    for (int n = 0; n < export_mesh_triangles(s); n++) {
        export_mesh_triangle(s, n, c);
        output_print(out, "f %d/%d %d/%d %d/%d\n", c[0] + 1, c[0] + 1, c[1] + 1, c[1] + 1,
                     c[2] + 1, c[2] + 1);
    }
    return STATUS_OK;
}

/* Writes a body as it lies in the scene, in metres. */
enum status export_mesh_body(struct export_job *j, struct output *out)
{
    const struct contact_mesh_view m = contact_mesh_view(j->scene.obstacles[j->body].mesh);

    output_print(out, "# obstacle %d of %s [m]\no obstacle\n", j->body, j->scene.name);
    for (int n = 0; n < m.vertices; n++)
        output_print(out, "v %.17g %.17g %.17g\n", m.vertex[n][0], m.vertex[n][1],
                     m.vertex[n][2]);
    for (int n = 0; n < m.triangles; n++)
        output_print(out, "f %d %d %d\n", m.triangle[n][0] + 1, m.triangle[n][1] + 1,
                     m.triangle[n][2] + 1);
    return STATUS_OK;
}

/* Writes rest.ply; s, t are what Blender and others call u, v. */
enum status export_mesh_ply(struct export_job *j, struct output *out)
{
    const struct export_sheet *s = &j->sheet;
    double uvw[3], x[3];
    int c[3];

    output_print(out,
                 "ply\nformat ascii 1.0\ncomment %s at rest [m]; s t = u v; u fastest\n"
                 "element vertex %d\nproperty double x\nproperty double y\n"
                 "property double z\nproperty double s\nproperty double t\n"
                 "element face %d\nproperty list uchar int vertex_indices\nend_header\n",
                 s->scene->name, export_sheet_vertices(s), export_mesh_triangles(s));
    for (int n = 0; n < export_sheet_vertices(s); n++) {
        export_sheet_vertex(s, n, uvw, x);
        output_print(out, "%.17g %.17g %.17g %.17g %.17g\n", x[0], x[1], x[2], uvw[0],
                     uvw[1]);
    }
    for (int n = 0; n < export_mesh_triangles(s); n++) {
        export_mesh_triangle(s, n, c);
        output_print(out, "3 %d %d %d\n", c[0], c[1], c[2]);
    }
    return STATUS_OK;
}

enum status export_mesh_csv(struct export_job *j, struct output *out)
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
