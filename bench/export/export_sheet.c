#include "bench/export/export_sheet.h"

#include <math.h>

enum { PATH = 4096 };

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

enum status export_sheet_open(const struct export_sheet *s, const char *name,
                              struct output **out, struct message *why)
{
    char path[PATH];

    if (snprintf(path, sizeof path, "%s/%s", s->folder, name) >= PATH)
        return status_fail(why, STATUS_FILE, "%.60s...: the path is too long", s->folder);
    return output_create(path, out, why);
}

/* Returns the corners of the two triangles of the cell at i, j, counted from 0:
 * counter-clockwise seen from where u x v points. Diagonals alternate, so that the mesh has
 * no bias. */
static void cell_triangles(const struct export_sheet *s, int i, int j, int corner[2][3])
{
    const int n = s->points[0], a = j * n + i, b = a + 1, c = a + n + 1, d = a + n;
    const int rising[2][3] = {{a, b, c}, {a, c, d}}, falling[2][3] = {{a, b, d}, {b, c, d}};

    for (int k = 0; k < 6; k++)
        corner[k / 3][k % 3] = ((i + j) % 2 ? falling : rising)[k / 3][k % 3];
}

static void print_faces(const struct export_sheet *s,
                        void (*print)(struct output *, const int[3]), struct output *out)
{
    for (int j = 0; j + 1 < s->points[1]; j++)
        for (int i = 0; i + 1 < s->points[0]; i++) {
            int corner[2][3];
            cell_triangles(s, i, j, corner);
            print(out, corner[0]);
            print(out, corner[1]);
        }
}

static void print_vertices(const struct export_sheet *s,
                           void (*print)(struct output *, int, const double *,
                                         const double *),
                           struct output *out)
{
    for (int n = 0; n < export_sheet_vertices(s); n++) {
        double uvw[3], x[3];
        export_sheet_point(s, n % s->points[0], n / s->points[0], uvw, x);
        print(out, n, uvw, x);
    }
}

static void obj_place(struct output *out, int n, const double *uv, const double *x)
{
    (void)n, (void)uv;
    output_print(out, "v %.17g %.17g %.17g\n", x[0], x[1], x[2]);
}

static void obj_texture(struct output *out, int n, const double *uv, const double *x)
{
    (void)n, (void)x;
    output_print(out, "vt %.17g %.17g\n", uv[0], uv[1]);
}

static void obj_face(struct output *out, const int c[3])
{
    output_print(out, "f %d/%d %d/%d %d/%d\n", c[0] + 1, c[0] + 1, c[1] + 1, c[1] + 1,
                 c[2] + 1, c[2] + 1);
}

static void write_obj(const struct export_sheet *s, struct output *out)
{
    output_print(out, "# %s at rest [m]; vt = u v; %d x %d vertices, u fastest\no sheet\n",
                 s->scene->name, s->points[0], s->points[1]);
    print_vertices(s, obj_place, out);
    print_vertices(s, obj_texture, out);
    print_faces(s, obj_face, out);
}

static void ply_vertex(struct output *out, int n, const double *uv, const double *x)
{
    (void)n;
    output_print(out, "%.17g %.17g %.17g %.17g %.17g\n", x[0], x[1], x[2], uv[0], uv[1]);
}

static void ply_face(struct output *out, const int c[3])
{
    output_print(out, "3 %d %d %d\n", c[0], c[1], c[2]);
}

/* Writes rest.ply; s, t are what Blender and others call u, v. */
static void write_ply(const struct export_sheet *s, struct output *out)
{
    output_print(out,
                 "ply\nformat ascii 1.0\ncomment %s at rest [m]; s t = u v; u fastest\n"
                 "element vertex %d\nproperty double x\nproperty double y\n"
                 "property double z\nproperty double s\nproperty double t\n"
                 "element face %d\nproperty list uchar int vertex_indices\nend_header\n",
                 s->scene->name, export_sheet_vertices(s),
                 2 * (s->points[0] - 1) * (s->points[1] - 1));
    print_vertices(s, ply_vertex, out);
    print_faces(s, ply_face, out);
}

static void csv_vertex(struct output *out, int n, const double *uv, const double *x)
{
    output_print(out, "%d,%.17g,%.17g,%.17g,%.17g,%.17g\n", n, uv[0], uv[1], x[0], x[1],
                 x[2]);
}

static void write_csv(const struct export_sheet *s, struct output *out)
{
    output_print(out, "vertex,u,v,x,y,z\n");
    print_vertices(s, csv_vertex, out);
}

enum status export_sheet_write(const struct export_sheet *s, unsigned formats,
                               struct message *why)
{
    static const struct {
        unsigned bit;
        const char *name;
        void (*write)(const struct export_sheet *, struct output *);
    } files[] = {{EXPORT_SHEET_OBJ, "rest.obj", write_obj},
                 {EXPORT_SHEET_PLY, "rest.ply", write_ply},
                 {EXPORT_SHEET_CSV, "rest.csv", write_csv}};
    enum status st = STATUS_OK;

    for (size_t n = 0; n < sizeof files / sizeof *files; n++) {
        struct output *out = NULL;
        if (!(formats & files[n].bit))
            continue;
        TRY(export_sheet_open(s, files[n].name, &out, why));
        files[n].write(s, out);
        TRY(output_close(out, why));
    }
out:
    return st;
}

const char *export_sheet_axes(unsigned fix)
{
    static const char *const words[] = {"", "x", "y", "xy", "z", "xz", "yz", "xyz"};

    return words[fix & FIX_XYZ];
}
