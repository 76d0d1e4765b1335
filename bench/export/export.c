#include "bench/export/export.h"

#include <math.h>
#include <string.h>

#include "bench/files/arena.h"
#include "bench/files/folder.h"
#include "bench/files/output.h"
#include "bench/truth/truth.h"
#include "bench/ui/command.h"
#include "bench/ui/show.h"
#include "models/bodies/body_mesh.h"
#include "models/damping.h"
#include "models/mechanics/dead_load.h"
#include "models/supports.h"
#include "models/net/hinge_mesh.h"
#include "models/net/hinge_rule.h"
#include "models/pattern.h"
#include "models/net/spring_net.h"
#include "models/reader/scene_file.h"
#include "models/reader/scene_schema.h"
#include "models/vector.h"

/* Vertices outside the sheet make a clamp of an edge: where bending is an angle between
 * elements, a held row alone is a hinge. A support through the whole thickness that holds
 * the direction from an edge into the sheet keeps the edge from turning. A vertex whose
 * neighbour inside is free and that has none on the other side gets one there, where the
 * mid-surface would go on, held as it is. A patch of several rows needs none.
 */

struct export_held_vertex {
    int vertex, i, j; /* its number, from n m on for those outside; its place           */
    unsigned fix;     /* FIX_X...                                                       */
    int support;      /* that it moves with; -1: it does not move                       */
    int beside;       /* outside: the held vertex that it stands beside; else -1        */
};

struct export_held {
    int count, outside;
    struct export_held_vertex *vertex; /* [count], those of the sheet first            */
    struct message doubt; /* where the net holds too little; empty: nowhere            */
};

struct export_job {
    struct scene scene; /* as its truth moves                                            */
    struct settings settings;
    struct export_sheet sheet;
    struct mesh mesh; /* of --mesh, else all zero                                  owned */
    double *hinge;    /* [edges of the mesh] factors of their hinges                      */
    struct export_held held;
    struct truth known;    /* no times: no truth is known                                */
    struct message misfit; /* what matched springs cannot represent; empty: nothing      */
    int body;              /* the obstacle of export_mesh_body                            */
    bool undamped;         /* the scene is damped by a factor a step, its truth is not   */
    struct arena arena;    /*                                                      owned */
};

/* Returns the vertices in a row, K n. */
static int export_sheet_columns(const struct export_sheet *s)
{
    return scene_sheets(s->scene) * s->points[0];
}

static int export_sheet_vertices(const struct export_sheet *s)
{
    return s->mesh ? s->mesh->vertices : export_sheet_columns(s) * s->points[1];
}

/* Returns the place i of column n of the row. Places have room for one more before and
 * behind each sheet: from -1 on, n + 2 a sheet. */
static int export_sheet_place(const struct export_sheet *s, int column)
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

/* Tells whether the place i, j is in a net, and not outside of its edges. */
static bool export_sheet_has(const struct export_sheet *s, int i, int j)
{
    int point;

    sheet_of(s, i, &point);
    return point >= 0 && point < s->points[0] && j >= 0 && j < s->points[1];
}

/* Returns parameters (u,v,1/2) of the place i, j, and its rest position [m]; places of a
 * mesh are its vertices, then those outside. */
static void export_sheet_point(const struct export_sheet *s, int i, int j, double uvw[3],
                               double xyz[3])
{
    int point;
    const double *at = !s->mesh                ? NULL
                       : i < s->mesh->vertices ? s->mesh->flat.at[i]
                                               : s->outside[i - s->mesh->vertices];

    if (at) {
        uvw[0] = at[0] / s->scene->length, uvw[1] = at[1] / s->scene->width, uvw[2] = 0.5;
        if (s->mesh->flat.start && i >= s->mesh->vertices)
            memcpy(xyz, s->mirrored[i - s->mesh->vertices], 3 * sizeof *xyz);
        else if (s->mesh->flat.start)
            memcpy(xyz, s->mesh->rest + 3 * (size_t)i, 3 * sizeof *xyz);
        else
            scene_rest_point(s->scene, uvw, xyz);
        return;
    }
    const int sheet = sheet_of(s, i, &point);
    const struct scene one = scene_sheet(s->scene, sheet);

    uvw[0] = point / (s->points[0] - 1.0);
    uvw[1] = j / (s->points[1] - 1.0);
    uvw[2] = 0.5;
    scene_rest_point(&one, uvw, xyz);
    uvw[0] = scene_sheet_u(s->scene, sheet, uvw[0]);
}

/* Returns the same of a vertex of the net. */
static void export_sheet_vertex(const struct export_sheet *s, int vertex, double uvw[3],
                                double xyz[3])
{
    const int columns = export_sheet_columns(s);

    if (s->mesh)
        export_sheet_point(s, vertex, 0, uvw, xyz);
    else
        export_sheet_point(s, export_sheet_place(s, vertex % columns), vertex / columns,
                           uvw, xyz);
}

/* Returns the part within half a cell of point k of n, within [0, 1]. */
static void own_part(int k, int n, double part[2])
{
    part[0] = fmax(0, (k - 0.5) / (n - 1));
    part[1] = fmin(1, (k + 0.5) / (n - 1));
}

/* Returns the part of the sheet that belongs to a vertex: half a cell to each side [m^2].
 * It is exact on flat sheets and cones; all add up to the sheet. */
static double export_sheet_area(const struct export_sheet *s, int vertex)
{
    const struct scene *scene = s->scene;
    double u[2], v[2], r, z;

    if (s->mesh)
        return s->mesh->area[vertex];
    own_part(vertex % s->points[0], s->points[0], u);
    own_part(vertex / export_sheet_columns(s), s->points[1], v);
    const double along = (u[1] - u[0]) * scene->length;
    if (scene->shape == SCENE_FLAT)
        return along * (v[1] - v[0]) * scene->width;
    scene_cloak_meridian(scene, (u[0] + u[1]) / 2, 0.5, &r, &z); /* linear in u */
    return along * r * (scene_cloak_angle(scene, v[1]) - scene_cloak_angle(scene, v[0]));
}

/* Returns the words x, y, z of FIX_X... bits, in this order, for printing. */
static const char *export_sheet_axes(unsigned fix)
{
    static const char *const words[] = {"", "x", "y", "xy", "z", "xz", "yz", "xyz"};

    return words[fix & FIX_XYZ];
}

/* Allowances for round-off: of a vertex's parameter, and of a direction. */
static const double ROUNDING = 1e-12;

/* Steps to the neighbours inside of an edge, before and after along u and v. */
static const int STEP[4][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};

static bool is_whole(const struct scene_support *s)
{
    return s->lo[2] <= 0 && s->hi[2] >= 1;
}

static bool reaches(const struct export_sheet *s, const struct scene_support *support,
                    int i, int j)
{
    double uvw[3], x[3];

    export_sheet_point(s, i, j, uvw, x);
    for (int d = 0; d < 2; d++)
        if (uvw[d] < support->lo[d] - ROUNDING || uvw[d] > support->hi[d] + ROUNDING)
            return false;
    return true;
}

/* Returns the components that supports through the whole thickness fix at the vertex. */
static unsigned held_whole(const struct export_sheet *s, int i, int j)
{
    unsigned fix = 0;

    for (int n = 0; export_sheet_has(s, i, j) && n < s->scene->support_count; n++)
        if (is_whole(&s->scene->supports[n]) && reaches(s, &s->scene->supports[n], i, j))
            fix |= s->scene->supports[n].fix;
    return fix;
}

/* Returns whether all components of a direction are fixed. */
static bool has_direction(unsigned fix, const double from[3], const double to[3])
{
    const double length = vector_distance(from, to);
    bool all = true;

    for (int c = 0; c < 3; c++)
        all &= (fix >> c & 1) || fabs(to[c] - from[c]) <= ROUNDING * length;
    return all;
}

/* Returns whether the vertex's fixed components keep the sheet from turning towards `step`.
 */
static bool is_stiff(const struct export_sheet *s, int i, int j, const int step[2])
{
    double uvw[3], here[3], there[3];

    export_sheet_point(s, i, j, uvw, here);
    export_sheet_point(s, i + step[0], j + step[1], uvw, there);
    return has_direction(held_whole(s, i, j), here, there);
}

/* Returns whether the vertex is in the sheet and not fixed along its normal. */
static bool may_leave(const struct export_sheet *s, int i, int j)
{
    double uvw[3], low[3], high[3];

    if (!export_sheet_has(s, i, j))
        return false;
    export_sheet_point(s, i, j, uvw, low);
    uvw[2] = 0, scene_rest_point(s->scene, uvw, low);
    uvw[2] = 1, scene_rest_point(s->scene, uvw, high);
    return !has_direction(held_whole(s, i, j), low, high);
}

static enum status check_held(const struct scene *scene, struct message *why)
{
    for (int n = 0; n < scene->support_count; n++) {
        const struct scene_support *s = &scene->supports[n];
        if (scene_grips(s))
            return status_fail(why, STATUS_UNSUPPORTED,
                               "supports[%d] takes hold or lets go: held.csv and paths.csv "
                               "know what is held from start to end",
                               n);
        if (!is_whole(s) && !(s->lo[2] == 0.5 && s->hi[2] == 0.5))
            return status_fail(
                why, STATUS_UNSUPPORTED,
                "supports[%d] holds w from %g to %g: vertices of a mid-surface say the "
                "whole thickness (a clamp) or w = 0.5 (a hinge)",
                n, s->lo[2], s->hi[2]);
    }
    return STATUS_OK;
}

static void add_outside(const struct export_sheet *s, struct export_held *held, int i,
                        int j, const struct export_held_vertex *beside)
{
    struct export_held_vertex *v = &held->vertex[held->count++];

    *v = *beside;
    v->vertex = export_sheet_vertices(s) + held->outside++;
    v->i = i, v->j = j;
    v->beside = beside->vertex;
}

/* Adds the clamps of one held vertex of the sheet: vertices outside of it, or says why
 * there can be none. */
static enum status add_clamps(const struct export_sheet *s, struct export_held *held,
                              const struct export_held_vertex *v, struct message *why)
{
    for (int k = 0; k < 4; k++) {
        const int *step = STEP[k], i = v->i - step[0], j = v->j - step[1];
        if (!may_leave(s, v->i + step[0], v->j + step[1]) || !is_stiff(s, v->i, v->j, step))
            continue;
        if (held_whole(s, v->i, v->j) != FIX_XYZ)
            return status_fail(why, STATUS_UNSUPPORTED,
                               "vertex %d is held in %s through the thickness, which keeps "
                               "the sheet from turning there; vertices can say that of xyz "
                               "alone",
                               v->vertex, export_sheet_axes(v->fix));
        if (may_leave(s, i, j))
            return status_fail(why, STATUS_UNSUPPORTED,
                               "vertex %d is clamped with the sheet free on both sides of "
                               "it: held vertices cannot say that; a patch of two rows or "
                               "more can, on a net so fine",
                               v->vertex);
        if (!export_sheet_has(s, i, j))
            add_outside(s, held, i, j, v);
    }
    return STATUS_OK;
}

/* Tells whether side k of an edge of a mesh, whose ends are clamped, bends against nothing
 * that is held: a vertex outside has to be. */
static bool bends_alone(const struct mesh *mesh, const struct mesh_edge *e, int k)
{
    const int in = e->node[2 + k], out = e->node[3 - k];

    return mesh->clamped[e->node[0]] && mesh->clamped[e->node[1]] && in >= 0 &&
           !mesh->clamped[in] && !(out >= 0 && mesh->clamped[out]);
}

/* Mirrors a vertex at an edge in space, in their plane. */
static void mirror(const double *x, const int end[2], int vertex, double mirrored[3])
{
    double e[3], c[3];

    vector_between(x + 3 * (size_t)end[0], x + 3 * (size_t)end[1], e);
    vector_between(x + 3 * (size_t)end[0], x + 3 * (size_t)vertex, c);
    const double foot = vector_dot(c, e) / vector_dot(e, e);
    for (int i = 0; i < 3; i++)
        mirrored[i] = x[3 * end[0] + i] + 2 * foot * e[i] - c[i];
}

/* Adds the vertices outside of a mesh: those inside mirrored at the edge. */
static void add_mirrored(struct arena *arena, struct export_sheet *s,
                         struct export_held *held)
{
    const struct mesh *mesh = s->mesh;
    const double(*at)[2] = (const double(*)[2])mesh->flat.at;
    const int count = held->count;

    s->outside = arena_take(arena, 2 * (size_t)mesh->edges, sizeof *s->outside);
    s->mirrored = arena_take(arena, 2 * (size_t)mesh->edges, sizeof *s->mirrored);
    for (int k = 0; k < 2 * mesh->edges; k++) {
        const struct mesh_edge *e = &mesh->edge[k / 2];
        const double *a = at[e->node[0]], *b = at[e->node[1]];
        const double x = b[0] - a[0], y = b[1] - a[1];
        if (!bends_alone(mesh, e, k % 2))
            continue;
        const double *c = at[e->node[2 + k % 2]];
        const double far = 2 * ((c[0] - a[0]) * y - (c[1] - a[1]) * x) / (x * x + y * y);
        int n = 0;
        while (n < count && held->vertex[n].vertex != e->node[0])
            n++;
        if (mesh->flat.start)
            mirror(mesh->rest, e->node, e->node[2 + k % 2], s->mirrored[held->outside]);
        s->outside[held->outside][0] = c[0] - far * y;
        s->outside[held->outside][1] = c[1] + far * x;
        add_outside(s, held, mesh->vertices + held->outside, 0, &held->vertex[n]);
    }
}

/* Returns whether vertices of the mesh or net lie along an edge of a support, at u or v. */
static bool meets_edge(const struct export_sheet *s, const struct scene_support *support,
                       int k, double at)
{
    bool has = false;

    if (!s->mesh) {
        const double cells = at * (s->points[k] - 1);
        return fabs(cells - round(cells)) <= 1e-9;
    }
    for (int a = 0; a < s->mesh->vertices; a++)
        has |= fabs(s->mesh->uvw[a][k] - at) <= 1e-9 &&
               supports_covers(support, s->mesh->uvw[a]);
    return has;
}

/* Says which support (the first) has an edge without vertices. */
static void doubt_edges(const struct export_sheet *s, struct export_held *held)
{
    for (int n = s->scene->support_count - 1; n >= 0; n--)
        for (int k = 3; k >= 0 && !s->scene->supports[n].part_count; k--) {
            const struct scene_support *support = &s->scene->supports[n];
            double at = k % 2 ? support->hi[k / 2] : support->lo[k / 2];
            if (!(k / 2))
                scene_sheet_at(s->scene, at, &at);
            if (!meets_edge(s, support, k / 2, at))
                status_fail(&held->doubt, STATUS_OK,
                            s->mesh ? "supports[%d] has no vertices along its edge at %c = "
                                      "%g: the mesh holds up to the last ones within"
                                    : "supports[%d] ends at %c = %g, between vertices: the "
                                      "net holds up to the last one within",
                            n, "uv"[k / 2], at);
        }
}

static void add_held(const struct export_sheet *s, const struct supports *supports, int n,
                     struct export_held *held)
{
    const int columns = s->mesh ? 1 : export_sheet_columns(s);
    struct export_held_vertex v = {
        n, s->mesh ? n : export_sheet_place(s, n % columns), n / columns, 0, -1, -1};

    for (int c = 0; c < 3; c++)
        if (supports->free_index[3 * n + c] < 0)
            v.fix |= 1u << c;
    if (v.fix)
        held->vertex[held->count++] = v;
}

static void add_paths(const struct scene *scene, const struct supports *supports,
                      struct export_held *held)
{
    int at = 0;

    for (int n = 0; n < supports->held_count; n++) {
        while (held->vertex[at].vertex < supports->held[n] / 3)
            at++;
        const int owner = supports->owner[n];
        if (SCENE_MOVES(scene->supports[owner].motion))
            held->vertex[at].support = owner;
    }
}

/* Finds the held vertices. STATUS_UNSUPPORTED with a sentence: vertices cannot express how
 * the scene holds the sheet, STATUS_INPUT: a support holds none of them. */
static enum status export_held_find(struct arena *arena, struct export_sheet *s,
                                    struct export_held *held, struct message *why)
{
    const int vertices = export_sheet_vertices(s);
    struct supports supports SCOPED(supports_clear) = {0};
    double(*uvw)[3] = arena_take(arena, 2 * (size_t)vertices, sizeof *uvw);
    double(*rest)[3] = uvw + vertices;

    CALL(check_held(s->scene, why));
    for (int n = 0; n < vertices; n++)
        export_sheet_vertex(s, n, uvw[n], rest[n]);
    CALL(supports_init(&supports, s->scene, vertices, uvw, *rest, why));
    /* a vertex may have one outside along u and one along v; a mesh two an edge */
    held->vertex = arena_take(arena, 7 * ((size_t)vertices + 1), sizeof *held->vertex);
    for (int n = 0; n < vertices; n++)
        add_held(s, &supports, n, held);
    add_paths(s->scene, &supports, held);
    if (s->mesh)
        add_mirrored(arena, s, held);
    for (int n = 0, count = held->count; n < count && !s->mesh; n++)
        CALL(add_clamps(s, held, &held->vertex[n], why));
    doubt_edges(s, held);
    return STATUS_OK;
}

/* Returns the path in paths.csv of the nth held vertex: its support's number, or, as a turn
 * moves each vertex another way, one of its own after those; -1: it does not move. */
static int export_held_path(const struct export_job *j, int n)
{
    const int support = j->held.vertex[n].support;

    return support < 0 || !j->scene.supports[support].motion.turn_count
               ? support
               : j->scene.support_count + n;
}

static void export_held_csv(struct export_job *j, struct output *out)
{
    output_print(out, "vertex,u,v,x,y,z,fix,path,beside\n");
    for (int n = 0; n < j->held.count; n++) {
        const struct export_held_vertex *v = &j->held.vertex[n];
        double uvw[3], x[3];
        export_sheet_point(&j->sheet, v->i, v->j, uvw, x);
        output_print(out, "%d,%.17g,%.17g,%.17g,%.17g,%.17g,%s,", v->vertex, uvw[0], uvw[1],
                     x[0], x[1], x[2], export_sheet_axes(v->fix));
        const int path = export_held_path(j, n);
        output_print(out, path < 0 ? "," : "%d,", path);
        output_print(out, v->beside < 0 ? "\n" : "%d\n", v->beside);
    }
}

/* --- the mesh at rest --- */

/* Finds the corners of the n-th triangle, counted from 0: counter-clockwise seen from where
 * u x v points. A cell's diagonals alternate, so that the mesh has no bias. */
static void export_mesh_triangle(const struct export_sheet *s, int n, int corner[3])
{
    if (s->mesh) {
        memcpy(corner, s->mesh->flat.triangle[n], 3 * sizeof *corner);
        return;
    }
    const int columns = export_sheet_columns(s), cells = s->points[0] - 1,
              row = columns - columns / s->points[0], /* cells in a row */
        i = n / 2 % row, j = n / 2 / row;
    const int a = j * columns + i + i / cells, b = a + 1, d = a + columns, c = d + 1;
    const int cell[2][2][3] = {{{a, b, c}, {a, c, d}}, {{a, b, d}, {b, c, d}}};

    memcpy(corner, cell[(i % cells + j) % 2][n % 2], 3 * sizeof *corner);
}

static int export_mesh_triangles(const struct export_sheet *s)
{
    return s->mesh ? s->mesh->flat.triangles
                   : 2 * scene_sheets(s->scene) * (s->points[0] - 1) * (s->points[1] - 1);
}

/* Tells whether the sheet is sewn together or starts in space. */
static bool is_sewn(const struct export_sheet *s)
{
    return s->mesh && s->mesh->flat.corner;
}

/* Puts the pattern of a mesh, a place for each corner [m], and its faces. */
static void put_pattern(const struct mesh_flat *flat, const double origin[2],
                        struct output *out)
{
    for (int n = 0; n < 3 * flat->triangles; n++) {
        const double *at = mesh_flat_place(flat, n / 3, n % 3);
        output_print(out, "vt %.17g %.17g\n", at[0] + origin[0], at[1] + origin[1]);
    }
    for (int n = 0; n < flat->triangles; n++) {
        const int *v = flat->triangle[n];
        output_print(out, "f %d/%d %d/%d %d/%d\n", v[0] + 1, 3 * n + 1, v[1] + 1, 3 * n + 2,
                     v[2] + 1, 3 * n + 3);
    }
}

/* Writes rest.obj. */
static void export_mesh_obj(struct export_job *j, struct output *out)
{
    const struct export_sheet *s = &j->sheet;
    double uvw[3], x[3];
    int c[3];

    if (s->mesh)
        output_print(out, "# %s at %s; %d vertices\no sheet\n", s->scene->name,
                     is_sewn(s) ? "the start [m]; vt = the flat pattern [m]"
                                : "rest [m]; vt = u v",
                     export_sheet_vertices(s));
    else
        output_print(out,
                     "# %s at rest [m]; vt = u v; %d x %d vertices, u fastest\no sheet\n",
                     s->scene->name, export_sheet_columns(s), s->points[1]);
    for (int n = 0; n < export_sheet_vertices(s); n++) {
        export_sheet_vertex(s, n, uvw, x);
        output_print(out, "v %.17g %.17g %.17g\n", x[0], x[1], x[2]);
    }
    if (is_sewn(s)) {
        put_pattern(&s->mesh->flat, (const double[2]){0}, out);
        return;
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
}

/* Writes the scene's own mesh for scene.yaml: the start in the pose's axes, the pattern. */
static void export_mesh_sheet(struct export_job *j, struct output *out)
{
    const struct pattern *p = j->scene.pattern;
    struct mesh_flat flat SCOPED(mesh_flat_clear) = {0};

    if (pattern_sewn(p, &flat) != STATUS_OK)
        arena_end();
    output_print(out, "# the sheet of %s; vt = the flat pattern [m]\no sheet\n",
                 j->scene.name);
    for (int n = 0; n < flat.nodes; n++) {
        const double *at = flat.start ? flat.start[n] : flat.at[n];
        output_print(out, "v %.17g %.17g %.17g\n", at[0] + p->corner[0],
                     at[1] + p->corner[1], flat.start ? at[2] : 0);
    }
    put_pattern(&flat, p->corner, out);
}

/* Writes a body as it lies in the scene, in metres. */
static void export_mesh_body(struct export_job *j, struct output *out)
{
    const struct body_mesh_view m = body_mesh_view(j->scene.obstacles[j->body].mesh);

    output_print(out, "# obstacle %d of %s [m]\no obstacle\n", j->body, j->scene.name);
    for (int n = 0; n < m.vertices; n++)
        output_print(out, "v %.17g %.17g %.17g\n", m.vertex[n][0], m.vertex[n][1],
                     m.vertex[n][2]);
    for (int n = 0; n < m.triangles; n++)
        output_print(out, "f %d %d %d\n", m.triangle[n][0] + 1, m.triangle[n][1] + 1,
                     m.triangle[n][2] + 1);
}

/* Writes rest.ply; s, t are what Blender and others call u, v. */
static void export_mesh_ply(struct export_job *j, struct output *out)
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
}

static void export_mesh_csv(struct export_job *j, struct output *out)
{
    const struct export_sheet *s = &j->sheet;
    double uvw[3], x[3];

    output_print(out, "vertex,u,v,x,y,z\n");
    for (int n = 0; n < export_sheet_vertices(s); n++) {
        export_sheet_vertex(s, n, uvw, x);
        output_print(out, "%d,%.17g,%.17g,%.17g,%.17g,%.17g\n", n, uvw[0], uvw[1], x[0],
                     x[1], x[2]);
    }
}

/* --- the numbers that a simulator needs besides the mesh --- */

/* A stiffness over E h below this is round-off: long cells do not need that spring. */
static const double NOTHING = 1e-12;

/* Numbers that differ by less than this share are the same but for rounding: the mass of a
 * vertex, a spring's length. */
static const double SAME = 1e-9;

struct number {
    const char *quantity;
    double value;
    const char *unit;
    int a, b;                  /* vertices; -1: none                                   */
    double length, compliance; /* at rest [m], 1/value; NaN: none                      */
};
/* The receiver of the numbers. */
struct taker {
    void (*take)(void *context, const struct number *number);
    void *context;
};

/* Passes on a number: its quantity, value, unit, and of a spring or vertex the rest. */
#define PUT(t, ...) (t)->take((t)->context, &(struct number){__VA_ARGS__})

static void put(const struct taker *t, const char *quantity, double value, const char *unit)
{
    PUT(t, quantity, value, unit, -1, -1, NAN, NAN);
}

/* Passes on a fabric's moduli along warp and weft, and those of an orthotropic solid as
 * thick as its h. */
static void put_fabric(const struct scene *scene, const struct taker *t)
{
    static const char *const name[LAW_PARTS][LAW_MODULI] = {{"Y11", "Y22", "Y12", "G"},
                                                            {"B1", "B2", "B12", "B66"}};
    const struct law_fabric *f = &scene->fabric;
    const double *Y = f->membrane, h = scene->thickness;

    for (int n = 0; n < LAW_MODULI; n++)
        put(t, name[LAW_MEMBRANE][n], Y[n], "N/m");
    for (int n = 0; n < LAW_MODULI; n++)
        put(t, name[LAW_BENDING][n], f->bending[n], "N m");
    for (int n = 0; n < 2; n++)
        if (f->softening[n] < 0)
            put(t, n ? "C2" : "C1", f->softening[n], "N m^2");
    put(t, "warp", f->warp, "deg");
    put(t, "E1", (Y[LAW_WARP] - Y[LAW_CROSS] * Y[LAW_CROSS] / Y[LAW_WEFT]) / h, "Pa");
    put(t, "E2", (Y[LAW_WEFT] - Y[LAW_CROSS] * Y[LAW_CROSS] / Y[LAW_WARP]) / h, "Pa");
    put(t, "nu12", Y[LAW_CROSS] / Y[LAW_WEFT], "1");
    put(t, "G12", Y[LAW_SHEAR] / h, "Pa");
    put(t, "areal mass", f->areal_density, "kg/m^2");
}

static void put_material(const struct scene *scene, const struct taker *t)
{
    const struct spring_law_stiffness plane = spring_law_plane_stress(scene);

    put(t, "E", scene->young, "Pa");
    put(t, "nu", scene->poisson, "1");
    put(t, "rho", scene->density, "kg/m^3");
    put(t, "h", scene->thickness, "m");
    if (scene->is_fabric) {
        put_fabric(scene, t);
        return;
    }
    put(t, "E h", scene->young * scene->thickness, "N/m");
    put(t, "E h/(1-nu^2)", plane.c11, "N/m");
    put(t, "G h", plane.c33, "N/m");
    put(t, "D", scene_bending_stiffness(scene), "N m");
    put(t, "areal mass", scene->density * scene->thickness, "kg/m^2");
}

static struct hinge_rule hinges_of(const struct export_sheet *s)
{
    const struct law law = scene_law(s->scene);

    return hinge_rule_of(law.matrix[LAW_BENDING], s->scene->length / (s->points[0] - 1),
                         s->scene->width / (s->points[1] - 1));
}

static void put_hinges(const struct export_sheet *s, const struct taker *t)
{
    const struct hinge_rule k = hinges_of(s);
    const struct {
        const char *name;
        double k;
    } hinge[] = {{"hinge u", k.u},
                 {"hinge v", k.v},
                 {"hinge diagonal", k.diagonal},
                 {"hinge u held", k.held_u},
                 {"hinge v held", k.held_v}};

    for (size_t n = 0; n < sizeof hinge / sizeof *hinge; n++)
        PUT(t, hinge[n].name, hinge[n].k, "N m", -1, -1, NAN, 1 / hinge[n].k);
}

/* Returns our number of a node of the springs' net, which counts along v first. */
static int vertex_of(const struct export_sheet *s, int node)
{
    return node % s->points[1] * export_sheet_columns(s) + node / s->points[1];
}

static void put_springs(const struct export_sheet *s, const struct taker *t,
                        struct message *misfit)
{
    static const char *const name[] = {"spring u", "spring v", "spring diagonal"};
    struct mesh mesh SCOPED(mesh_clear) = {0};
    struct spring_net net SCOPED(spring_net_clear) = {0};

    if ((!s->mesh && mesh_init(&mesh, s->scene, s->points) != STATUS_OK) ||
        spring_net_init(&net, s->scene, s->mesh ? s->mesh : &mesh, PARAMETERS_MATCHED,
                        false) != STATUS_OK)
        arena_end();
    for (const struct spring *k = net.springs; k < net.springs + net.spring_count; k++) {
        const int m = s->points[1]; /* none of a mesh */
        if (s->mesh)
            PUT(t, "spring", k->stiffness, "N/m", k->a, k->b, k->length, 1 / k->stiffness);
        else if (k->stiffness > NOTHING * s->scene->young * s->scene->thickness)
            PUT(t,
                name[k->b / m == k->a / m   ? SPRING_V
                     : k->b % m == k->a % m ? SPRING_U
                                            : SPRING_DIAGONAL],
                k->stiffness, "N/m", vertex_of(s, k->a), vertex_of(s, k->b), k->length,
                1 / k->stiffness);
    }
    spring_net_tell(&net, s->scene, misfit);
}

/* Passes on, one by one, all numbers of a net of points: the material; the mass of each
 * vertex a; on a flat sheet the stiffnesses of hinges (models/net/hinge_rule.h); and each
 * matched spring from a to b (models/net/spring_net.h). *misfit says what those springs
 * cannot represent; empty: nothing. */
static void each(const struct export_sheet *s, const struct taker *t,
                 struct message *misfit)
{
    const double areal = s->scene->density * s->scene->thickness;

    put_material(s->scene, t);
    for (int n = 0; n < export_sheet_vertices(s); n++)
        PUT(t, "mass", areal * export_sheet_area(s, n), "kg", n, -1, NAN, NAN);
    if (s->scene->shape != SCENE_FLAT)
        return;
    const struct law law = scene_law(s->scene);
    if (!s->mesh)
        put_hinges(s, t);
    if (s->mesh ? !s->scene->is_fabric : law_is_aligned(&law))
        put_springs(s, t, misfit);
}

/* --- as a table: what is the same is a row --- */

enum { KINDS = 40 };
struct kinds {
    int count;
    long uses[KINDS];
    struct number kind[KINDS];
};

static bool is_near(double a, double b)
{
    return (isnan(a) && isnan(b)) || fabs(a - b) <= SAME * fabs(b);
}

static void take_kind(void *context, const struct number *number)
{
    struct kinds *k = context;
    int n = 0;

    while (n < k->count && !(!strcmp(k->kind[n].quantity, number->quantity) &&
                             is_near(k->kind[n].value, number->value) &&
                             is_near(k->kind[n].length, number->length)))
        n++;
    if (n == KINDS) /* a flat net has fewer */
        return;
    k->kind[n] = *number;
    k->uses[n]++;
    k->count += n == k->count;
}

struct dataset *export_numbers_table(const struct export_sheet *s)
{
    static const struct dataset_column columns[] = {
        {"quantity"},
        {"value"},
        {"unit"},
        {"rest length", "m"},
        {"compliance", "1/unit", .key_unit = "1"},
        {"how many"}};
    struct kinds kinds = {0};
    struct message misfit = {""};
    struct dataset *table =
        DATASET_OF(columns, "Parameters of this net of points, for an engine of your own");
    each(s, &(struct taker){take_kind, &kinds}, &misfit);
    for (int n = 0; n < kinds.count; n++) {
        const struct number *k = &kinds.kind[n];
        dataset_line(table, "%s|%.6g|%s|%.6g|%.6g|%.0f", k->quantity, k->value, k->unit,
                     k->length, k->compliance, k->a < 0 ? NAN : (double)kinds.uses[n]);
    }
    dataset_note(
        table,
        "mass: of a vertex - corner, rim, inside; springs: half as stiff on the rim; "
        "hinge: bending by the angle theta between two triangles, k theta^2 / 2, over an "
        "inner edge along u, v or a diagonal, or over one of whose triangles one is held, "
        "at a clamp; compliance: of XPBD, with C = length - rest length or C = theta.");
    if (*misfit.text)
        dataset_note(table, "Springs are no plane stress: %s.", misfit.text);
    return table;
}

/* --- as files --- */

/* Prints a comma and a number, which may be missing. */
static void print_cell(struct output *out, double value)
{
    output_print(out, ",");
    if (!isnan(value))
        output_print(out, "%.17g", value);
}

static void take_line(void *context, const struct number *n)
{
    struct output *out = context;

    output_print(out, "%s", n->quantity);
    print_cell(out, n->a < 0 ? NAN : n->a);
    print_cell(out, n->b < 0 ? NAN : n->b);
    output_print(out, ",%.17g,%s", n->value, n->unit);
    print_cell(out, n->length);
    print_cell(out, n->compliance);
    output_print(out, "\n");
}

static void export_numbers_materials(struct export_job *j, struct output *out)
{
    output_print(out, "quantity,a,b,value,unit,rest_length,compliance\n");
    each(&j->sheet, &(struct taker){take_line, out}, &j->misfit);
}

/* Writes each edge's hinge: D |e|^2 over the area of its triangles, times factors
 * (models/net/hinge_mesh.h); at a clamp the angle stands for half a cell, and that is the
 * area of the one that is free. */
static void export_numbers_hinges(struct export_job *j, struct output *out)
{
    const struct mesh *mesh = j->sheet.mesh;
    const double D = scene_bending_stiffness(&j->scene);
    int outside = mesh->vertices;

    output_print(out, "a,b,c,d,stiffness\n");
    for (const struct mesh_edge *e = mesh->edge; e < mesh->edge + mesh->edges; e++) {
        const int *v = e->node;
        const double length = mesh_edge_length(mesh, (int)(e - mesh->edge));
        const double square = length * length;
        const bool clamp = mesh->clamped[v[0]] && mesh->clamped[v[1]];
        double area[2] = {0};
        for (int k = 0; k < 2; k++)
            if (v[2 + k] >= 0)
                area[k] = mesh_plane_of(mesh, e->triangle[k]).area;
        for (int k = 0; clamp && k < 2; k++)
            if (v[2 + k] >= 0 && !mesh->clamped[v[2 + k]])
                output_print(out, "%d,%d,%d,%d,%.17g\n", v[0], v[1], v[2 + k],
                             bends_alone(mesh, e, k) ? outside++ : v[3 - k],
                             D * square / area[k]);
        if (!clamp && v[3] >= 0)
            output_print(out, "%d,%d,%d,%d,%.17g\n", v[0], v[1], v[2], v[3],
                         j->hinge[e - mesh->edge] * D * square / (area[0] + area[1]));
    }
}

static void export_numbers_times(struct export_job *j, struct output *out)
{
    output_print(out, "what,time,bar\nstep,%.17g,\nend,%.17g,\n", j->scene.step,
                 j->scene.end);
    for (int n = 0; n < j->known.claimed; n++)
        output_print(out, "truth,%.17g,%.17g\n", j->known.time[n], j->known.error[n]);
}

static void export_numbers_obstacles(struct export_job *j, struct output *out)
{
    output_print(out, "kind,x,y,z,normal_x,normal_y,normal_z,radius,friction\n");
    for (int n = 0; n < j->scene.obstacle_count; n++) {
        const struct scene_obstacle *o = &j->scene.obstacles[n];
        const double *p = o->point, *m = o->normal;
        const double size = hypot(m[0], hypot(m[1], m[2]));
        output_print(out, "%s%s,%.17g,%.17g,%.17g", SCENE_MOVES(o->motion) ? "moving_" : "",
                     scene_schema_obstacles[o->kind].key, p[0], p[1], p[2]);
        if (o->kind == OBSTACLE_PLANE)
            output_print(out, ",%.17g,%.17g,%.17g", m[0] / size, m[1] / size, m[2] / size);
        else
            output_print(out, ",,,");
        print_cell(out, o->radius > 0 ? o->radius : NAN);
        print_cell(out, o->friction);
        output_print(out, "\n");
    }
}

static void print_path(int number, double t, const double shift[3], struct output *out)
{
    output_print(out, "%d,%.17g,%.17g,%.17g,%.17g\n", number, t, shift[0], shift[1],
                 shift[2]);
}

/* Prints, frame by frame, the path of a held vertex whose support turns. */
static void print_turning(const struct export_job *j, int n, struct output *out)
{
    const struct export_held_vertex *v = &j->held.vertex[n];
    const int frames = (int)lround(j->scene.end / j->scene.step);

    for (int k = 0; k <= frames; k++) {
        struct scene_placement place;
        double uvw[3], X[3], x[3], shift[3];
        export_sheet_point(&j->sheet, v->i, v->j, uvw, X);
        scene_motion_at(&j->scene.supports[v->support].motion, k * j->scene.step, &place);
        scene_placement_point(&place, X, x);
        vector_between(X, x, shift);
        print_path(export_held_path(j, n), k * j->scene.step, shift, out);
    }
}

static void export_numbers_paths(struct export_job *j, struct output *out)
{
    output_print(out, "path,t,x,y,z\n");
    for (int n = 0; n < j->scene.support_count; n++) {
        const struct scene_motion *m = &j->scene.supports[n].motion;
        for (int k = 0; k < m->path_count && !m->turn_count; k++)
            print_path(n, m->path[k][0], m->path[k] + 1, out);
    }
    for (int n = 0; n < j->held.count; n++)
        if (export_held_path(j, n) >= j->scene.support_count)
            print_turning(j, n, out);
}

/* Writes loads, distributed by the vertices' hat functions as springs and triangles do. */
static void export_numbers_loads(struct export_job *j, struct output *out)
{
    const struct export_sheet *s = &j->sheet;
    const struct dead_load_line line[3] = {
        {.n = s->points[0], .degree = 1}, {.n = s->points[1], .degree = 1}, {.n = 1}};
    double *force =
        arena_take(&j->arena, 3 * (size_t)export_sheet_vertices(s), sizeof *force);

    if ((s->mesh ? mesh_add_loads(s->mesh, s->scene, force)
                 : dead_load_add(s->scene, line, force)) != STATUS_OK)
        arena_end();
    output_print(out, "vertex,x,y,z\n");
    for (int n = 0; n < export_sheet_vertices(s); n++) {
        const int columns = s->mesh ? 1 : export_sheet_columns(s), along = n % columns,
                  across = n / columns;
        const double *f = force + 3 * (s->mesh ? n : along * s->points[1] + across);
        if (f[0] != 0 || f[1] != 0 || f[2] != 0)
            output_print(out, "%d,%.17g,%.17g,%.17g\n", n, f[0], f[1], f[2]);
    }
}

/* Writes velocities at t = 0, none in components that are held [m/s]. */
static void export_numbers_velocities(struct export_job *j, struct output *out)
{
    const struct export_held *h = &j->held;
    double uvw[3], x[3], v[3];

    output_print(out, "vertex,x,y,z\n");
    for (int n = 0, held = 0; n < export_sheet_vertices(&j->sheet); n++) {
        const bool is_held = held < h->count && h->vertex[held].vertex == n;
        const unsigned fix = is_held ? h->vertex[held++].fix : 0;
        export_sheet_vertex(&j->sheet, n, uvw, x);
        scene_initial_velocity(&j->scene, x, v);
        for (int c = 0; c < 3; c++)
            v[c] = fix >> c & 1 ? 0 : v[c];
        output_print(out, "%d,%.17g,%.17g,%.17g\n", n, v[0], v[1], v[2]);
    }
}

#define MESH_FILE  "obstacle_%d.obj"
#define SHEET_FILE "sheet.obj"

/* --- scene.yaml: what was set is in it, and what its truth changes; comments are not ---
 */

/* Prints a text in which each # stands for the next number, with as many digits as it takes
 * to read it again; never -0. */
static void put_words(struct output *out, const char *text, const double *value)
{
    for (; *text; text++)
        if (*text != '#')
            output_print(out, "%c", *text);
        else
            output_print(out, "%.*g", output_digits(*value), *value + 0.0), value++;
}

static void put_text(struct output *out, const char *key, const char *text)
{
    output_print(out, "%s: \"", key);
    for (; *text; text++)
        output_print(out, *text == '"' || *text == '\\' ? "\\%c" : "%c", *text);
    output_print(out, "\"\n");
}

static void tell_fabric(const struct law_fabric *f, struct output *out)
{
    put_words(out, "material:\n  membrane: [#, #, #, #]\n", f->membrane);
    put_words(out, "  bending: [#, #, #, #]\n", f->bending);
    put_words(out, "  areal_density: #\n", &f->areal_density);
    put_words(out, "  warp: #\n", &f->warp);
    if (f->softening[0] != 0 || f->softening[1] != 0)
        put_words(out, "  softening: [#, #]\n", f->softening);
}

/* Puts the lines of an outline, or the name of the mesh. */
static void put_pattern_lines(const struct scene *s, struct output *out)
{
    const struct pattern *p = s->pattern;

    if (p->mesh.nodes)
        output_print(out, "sheet:\n  mesh: " SHEET_FILE "\n");
    for (int k = 0; !p->mesh.nodes && k < p->lines; k++) {
        output_print(out, "%s",
                     k == 0   ? "sheet:\n  outline:\n"
                     : k == 1 ? "  holes:\n"
                              : "");
        for (int n = p->line[k]; n < p->line[k + 1]; n++) {
            output_print(out, "%s",
                         k == 0            ? "    - "
                         : n == p->line[k] ? "    - - "
                                           : "      - ");
            put_words(out, "[#, #]\n",
                      (double[]){p->at[n][0] + p->corner[0], p->at[n][1] + p->corner[1]});
        }
    }
    if (!s->is_fabric)
        put_words(out, "  thickness: #\n", &s->thickness);
}

static void put_sheet(const struct scene *s, struct output *out)
{
    const double *zero = s->pattern ? s->pattern->corner : (const double[2]){0};
    double origin[3]; /* where the pattern has its 0 */

    if (s->pattern)
        put_pattern_lines(s, out);
    else
        put_words(out,
                  s->is_fabric ? "sheet: {length: #, width: #}\n"
                               : "sheet: {length: #, width: #, thickness: #}\n",
                  (double[]){s->length, s->width, s->thickness});
    if (s->sheets < 2)
        output_print(out, "pose:\n  kind: %s\n", scene_shape_words[s->shape]);
    for (int k = 0; k < scene_sheets(s); k++) {
        const char *head = s->sheets < 2 ? "  " : k ? "  - " : "sheets:\n  - ";
        output_print(out, "%s", head);
        for (int c = 0; c < 3; c++)
            origin[c] = s->pose[k].origin[c] -
                        (zero[0] * s->pose[k].axis_u[c] + zero[1] * s->pose[k].axis_v[c]);
        put_words(out, "origin: [#, #, #]\n", origin);
        put_words(out, s->sheets < 2 ? "  u: [#, #, #]\n" : "    u: [#, #, #]\n",
                  s->pose[k].axis_u);
        put_words(out, s->sheets < 2 ? "  v: [#, #, #]\n" : "    v: [#, #, #]\n",
                  s->pose[k].axis_v);
    }
    if (s->shape == SCENE_CLOAK)
        put_words(out, "  opening: #\n  flare: #\n", (double[]){s->opening, s->flare});
    if (s->is_fabric)
        tell_fabric(&s->fabric, out);
    else
        put_words(out, "material: {young: #, poisson: #, density: #}\n",
                  (double[]){s->young, s->poisson, s->density});
}

static void put_forces(const struct scene *s, struct output *out)
{
    const struct scene_damping *d = &s->damping;

    put_words(out, "gravity: [#, #, #]\n", s->gravity);
    if (s->pressure != 0)
        put_words(out, "pressure: #\n", &s->pressure);
    if (s->drag > 0) {
        put_words(out, "drag: {coefficient: #", &s->drag);
        put_words(out, ", wind: [#, #, #]}\n", s->wind);
    }
    if (s->air.density > 0) {
        put_words(out, "air:\n  density: #\n", &s->air.density);
        put_words(out, "  drag: [#, #]\n", s->air.drag);
        output_print(out, "%s", s->air.wind_count ? "  wind:\n" : "");
        for (int n = 0; n < s->air.wind_count; n++)
            put_words(out, "    - [#, #, #, #]\n", s->air.wind[n]);
    }
    output_print(out, "damping: {kind: %s", damping_words[d->kind]);
    if (d->kind == DAMPING_RAYLEIGH)
        put_words(out, ", alpha: #, beta: #", (double[]){d->alpha, d->beta});
    else if (d->kind != DAMPING_NONE)
        put_words(out, ", value: #", &d->value);
    output_print(out, "}\n");
    if (scene_needs(s) & SCENE_NEED_INITIAL_MOTION) {
        put_words(out, "motion: {velocity: [#, #, #]", s->velocity);
        put_words(out, ", spin: [#, #, #]", s->spin);
        if (scene_ripples(s)) {
            put_words(out, ", ripple: [#, #, #]", s->ripple);
            put_words(out, ", wave: #", &s->wave);
            output_print(out, ", seed: %d", s->seed);
        }
        output_print(out, "}\n");
    }
}

/* Begins an element of a list; of several sheets u is that along the one that it names, or
 * all of it. */
static void put_region(const struct scene *s, int sheet, struct output *out,
                       const double lo[3], const double hi[3])
{
    output_print(out, "  - at: {");
    if (s->sheets > 1 && sheet)
        output_print(out, "sheet: %d, ", sheet);
    for (int c = s->sheets > 1 && !sheet; c < 3; c++) {
        double at[2] = {lo[c], hi[c]};
        for (int k = 0; c == 0 && k < 2 && s->sheets > 1; k++) {
            scene_sheet_at(s, at[k], &at[k]);
            at[k] = nearbyint(at[k] * 1e12) / 1e12; /* as it was typed */
        }
        output_print(out, "%c: ", "uvw"[c]);
        put_words(out, at[0] == at[1] ? "#" : "[#, #]", at);
        output_print(out, c < 2 ? ", " : "}\n");
    }
}

static void put_motion(const struct scene_motion *m, struct output *out)
{
    output_print(out, "%s", m->path_count ? "    path:\n" : "");
    for (int k = 0; k < m->path_count; k++)
        put_words(out, "      - [#, #, #, #]\n", m->path[k]);
    if (!m->turn_count)
        return;
    put_words(out, "    turn:\n      axis: [#, #, #]\n", m->axis);
    put_words(out, "      about: [#, #, #]\n      angles:\n", m->about);
    for (int k = 0; k < m->turn_count; k++)
        put_words(out, "        - [#, #]\n", m->turn[k]);
}

/* Puts the vertices that a support names, or that its group has. */
static void put_vertices(const struct scene *s, const struct scene_support *support,
                         struct output *out)
{
    const struct pattern *p = s->pattern;
    int last = -1;

    output_print(out, "  - at: {vertices: [");
    for (int a = 0; a < p->mesh.nodes; a++) {
        const int node = p->node ? p->node[a] : a;
        const double *at = p->mesh.at[a];
        if (node <= last ||
            !scene_support_has(support, at[0] / s->length, at[1] / s->width))
            continue;
        output_print(out, last < 0 ? "%d" : ", %d", node + 1);
        last = node;
    }
    const bool whole = support->lo[2] <= 0 && support->hi[2] >= 1;
    put_words(out,
              whole                              ? "]}\n"
              : support->lo[2] == support->hi[2] ? "], w: #}\n"
                                                 : "], w: [#, #]}\n",
              (double[]){support->lo[2], support->hi[2]});
}

static void put_supports(const struct scene *s, struct output *out)
{
    for (int n = 0; n < s->support_count; n++) {
        const struct scene_support *p = &s->supports[n];
        output_print(out, "%s", n ? "" : "supports:\n");
        if (p->part_count)
            put_vertices(s, p, out);
        else
            put_region(s, p->sheet, out, p->lo, p->hi);
        output_print(out, "    fix: %s\n", export_sheet_axes(p->fix));
        put_motion(&p->motion, out);
    }
    for (int n = 0; n < s->load_count; n++) {
        output_print(out, "%s", n ? "" : "loads:\n");
        put_region(s, s->loads[n].sheet, out, s->loads[n].lo, s->loads[n].hi);
        put_words(out, "    force: [#, #, #]\n", s->loads[n].force);
    }
}

/* Puts the numbers of each kind; a mesh lies in a file of its own, where it is. */
static void put_obstacles(const struct scene *s, struct output *out)
{
    for (int n = 0; n < s->obstacle_count; n++) {
        const struct scene_obstacle *o = &s->obstacles[n];
        const struct schema_key *kind = &scene_schema_obstacles[o->kind];
        output_print(out, "%s  - %s:\n", n ? "" : "obstacles:\n", kind->key);
        if (o->kind == OBSTACLE_MESH) {
            output_print(out, "      file: " MESH_FILE "\n", n);
            put_words(out, "      friction: #\n", &o->friction);
        }
        for (const struct schema_key *k = kind->keys; o->kind != OBSTACLE_MESH && k->key;
             k++) {
            const bool vector = k->type == SCHEMA_VECTOR;
            if (!vector && k->type != SCHEMA_NUMBER)
                continue;
            output_print(out, "      %s: ", k->key);
            put_words(out, vector ? "[#, #, #]\n" : "#\n",
                      (const void *)((const char *)o + k->offset));
        }
        put_motion(&o->motion, out);
    }
}

static void put_contact(const struct scene *s, struct output *out)
{
    const struct scene_contact *c = &s->contact;

    if (!c->self && c->thickness == 0 && c->range == 0 && c->stiffness == 0 &&
        c->friction == 0)
        return;
    output_print(out, "contact: {self: %s", c->self ? "true" : "false");
    put_words(out, ", thickness: #, range: #, stiffness: #, friction: #}\n",
              (double[]){c->thickness, c->range, c->stiffness, c->friction});
}

static void write_scene(struct export_job *j, struct output *out)
{
    const struct scene *scene = &j->scene;

    output_print(out, "name: %s\n", scene->name);
    put_text(out, "source", scene->source);
    put_sheet(scene, out);
    put_forces(scene, out);
    put_supports(scene, out);
    put_obstacles(scene, out);
    put_contact(scene, out);
    put_words(out, "time: {step: #, end: #}\n", (double[]){scene->step, scene->end});
    for (int n = 0; n < scene->snapshot_count; n++)
        put_words(out, n ? ", #" : "snapshots: [#", &scene->snapshots[n]);
    output_print(out, "%s", scene->snapshot_count ? "]\n" : "");
}

/* --- README.md: the rules on one page --- */

/* Puts three corners of a sheet at rest. */
static void put_corners(const struct scene *c, int sheet, struct output *out)
{
    for (int n = 0; n < 3; n++) {
        const double corner[3] = {scene_sheet_u(c, sheet, n == 1), n == 2, 0.5};
        double x[3];
        scene_rest_point(c, corner, x);
        output_print(out, "%s u = %.6g, v = %g is at (%.4g, %.4g, %.4g)",
                     n       ? ","
                     : sheet ? "\nOf the next sheet"
                             : " At rest",
                     corner[0], corner[1], x[0] + 0.0, x[1] + 0.0, x[2] + 0.0);
    }
    output_print(out, ".");
}

static void put_title(const struct export_job *j, struct output *out)
{
    const struct scene *c = &j->scene;
    const int *points = j->sheet.points;
    const double *g = c->gravity;
    char number[16] = "A";

    if (c->sheets > 1)
        snprintf(number, sizeof number, "%d", c->sheets);

    output_print(out, "# %s for your simulator\n\n%s %s sheet%s %g m (u) by %g m (v), ",
                 c->name, number,
                 is_sewn(&j->sheet) ? "garment's" : scene_shape_words[c->shape],
                 c->sheets > 1 ? "s, each"
                 : c->pattern  ? ", whose pattern lies in a box of"
                               : ",",
                 c->length, c->width);
    if (c->is_fabric)
        output_print(out, "a fabric of %g kg/m^2, h_eff = %g m", c->fabric.areal_density,
                     c->thickness);
    else
        output_print(out, "%g m thick: E = %g Pa, nu = %g, rho = %g kg/m^3", c->thickness,
                     c->young, c->poisson, c->density);
    output_print(out,
                 "; gravity\n%g %g %g m/s^2; Gamma = rho g h L^3 / D = %.4g.\nSource: "
                 "%s.\n\n",
                 g[0] + 0.0, g[1] + 0.0, g[2] + 0.0, scene_gamma(c), c->source);
    output_print(out, "SI units; x, y, z right-handed.");
    if (is_sewn(&j->sheet))
        output_print(out, " The sheet is sewn of panels, or starts in space: `vt` of "
                          "rest.obj is the flat pattern [m],\nwhich is without stress, "
                          "`v` where it starts. Lengths, areas and shapes at rest are the "
                          "pattern's.");
    for (int k = 0; k < scene_sheets(c) && !is_sewn(&j->sheet); k++)
        put_corners(c, k, out);
    if (c->sheets > 1)
        output_print(
            out,
            "\nVertex j %d + (k - 1) %d + i is point (i/%d, j/%d) of sheet k, 1 to "
            "%d: a row goes through all\nsheets, and nothing connects them. u counts "
            "on from sheet to sheet, as the files have it.",
            export_sheet_columns(&j->sheet), points[0], points[0] - 1, points[1] - 1,
            c->sheets);
    else if (j->sheet.mesh)
        output_print(
            out, c->pattern ? "\nVertices are numbered as in rest.obj."
                            : "\nVertices are those that your faces name, in your order.");
    else
        output_print(out, "\nVertex j %d + i is at u = i/%d, v = j/%d.", points[0],
                     points[0] - 1, points[1] - 1);
    output_print(out,
                 " Files count vertices from 0, OBJ from 1.\nTriangles are "
                 "counter-clockwise seen from u x v%s.\n\n",
                 j->sheet.mesh ? "" : "; the diagonals alternate");
}

static void put_damping(const struct scene *c, bool undamped, bool at_rest,
                        struct output *out)
{
    const struct scene_damping *d = &c->damping;

    if (at_rest)
        output_print(out, "- Damping: any, as long as the sheet is at rest at the end. The "
                          "truth is the shape at rest.\n");
    else if (undamped)
        output_print(out, "- No damping: the scene scales velocities by a factor a step, "
                          "which is no rate; its truth is undamped.\n");
    else if (d->kind == DAMPING_NONE)
        output_print(out, "- No damping, no drag of the air but what is said here.\n");
    else if (d->kind == DAMPING_RAYLEIGH)
        output_print(out,
                     "- Damping %g M + %g s K: forces against velocity by mass and "
                     "stiffness.\n",
                     d->alpha, d->beta);
    else
        output_print(out,
                     "- Damping: a force of %g 1/s times mass against the velocity of "
                     "each point.\n",
                     d->value);
}

/* Tells whether obstacles.csv says all there is to the obstacles. */
static bool in_table(const struct scene *c)
{
    bool all = !(scene_needs(c) & SCENE_NEED_MOVING_OBSTACLES);

    for (int n = 0; n < c->obstacle_count; n++)
        all = all && (c->obstacles[n].kind == OBSTACLE_PLANE ||
                      c->obstacles[n].kind == OBSTACLE_SPHERE);
    return all;
}

static void put_physics(const struct export_job *j, struct output *out)
{
    const struct scene *c = &j->scene;
    const unsigned needs = scene_needs(c);

    output_print(out, "## Physics of the truth\n\n");
    put_damping(c, j->undamped, j->known.closed && c->support_count, out);
    output_print(out, "- From t = 0 at rest%s%s; large displacements; %s.\n",
                 is_sewn(&j->sheet) ? ", with the stress of where it starts"
                                    : " in the rest shape, without stress",
                 needs & SCENE_NEED_INITIAL_MOTION ? " but for velocities.csv [m/s]" : "",
                 !(needs & SCENE_NEED_SELF_CONTACT) ? "no self-contact"
                 : needs & SCENE_NEED_SHEETS
                     ? "the sheets meet each other and themselves (scene.yaml)"
                     : "the sheet meets itself (scene.yaml)");
    if (needs & SCENE_NEED_DRAG)
        output_print(out,
                     "- Body drag: %g kg/m^3/s times (wind - velocity) per volume, wind "
                     "%g %g %g m/s: times area and h per vertex.\n",
                     c->drag, c->wind[0], c->wind[1], c->wind[2]);
    if (needs & SCENE_NEED_AIR)
        output_print(out,
                     "- Air of %g kg/m^3 in the wind of scene.yaml: w the wind less the "
                     "velocity, n the normal, w_n = (w n) n, a force of %g/2 (%g |w_n| w_n "
                     "+ %g |w - w_n| (w - w_n)) times a vertex's present area.\n",
                     c->air.density, c->air.density, c->air.drag[0], c->air.drag[1]);
    if (needs & SCENE_NEED_PRESSURE)
        output_print(out,
                     "- Pressure of %g Pa against the outward normal, as it turns: times a "
                     "vertex's area.\n",
                     c->pressure);
    if (needs & SCENE_NEED_CONTACT)
        output_print(out,
                     "- Obstacles%s: obstacles.csv; normals point outward; Coulomb "
                     "friction. The sheet's faces, %g m off its middle, touch.\n",
                     needs & SCENE_NEED_MOVING_OBSTACLES ? "" : " stand still",
                     (c->contact.thickness > 0 ? c->contact.thickness : c->thickness) / 2);
    if (needs & SCENE_NEED_CONTACT && !in_table(c))
        output_print(
            out, "  obstacles.csv has all there is to a `plane` or `sphere`; the rest of "
                 "a `capsule`, `box` or `mesh`\n  (obstacle_N.obj) and of one that moves "
                 "(`moving_...`, its place without the motion) is in scene.yaml.\n");
    if (needs & SCENE_NEED_LOADS)
        output_print(out,
                     "- Forces that keep their direction from t = 0: loads.csv [N].\n");
    if (needs & SCENE_NEED_MOVING_SUPPORTS)
        output_print(out, "- Held vertices with a `path` move: rest + paths.csv [s, m], "
                          "linear between rows, constant outside.\n");
    output_print(out, "\n");
}

static void put_held(const struct export_job *j, struct output *out)
{
    const struct export_held *h = &j->held;

    output_print(out, "## What is held\n\n");
    if (!h->count) {
        output_print(out, "Nothing.\n\n");
        return;
    }
    output_print(out, "held.csv: %d vertices of the sheet, in the components `fix`.",
                 h->count - h->outside);
    if (h->outside && j->sheet.mesh)
        output_print(
            out,
            "\nIts last %d rows, with `beside`, are vertices outside the sheet, each "
            "across an edge of held ones;\n`beside` is one end, hinges.csv has both. They "
            "are held likewise and have no mass; leave them out\nof your frames. A "
            "simulator with rotations holds those of the held vertices instead.",
            h->outside);
    else if (h->outside)
        output_print(
            out,
            "\nIts last %d rows, with `beside`, are vertices outside the sheet, one cell "
            "off the vertex beside.\nWhere bending is an angle between elements, a held "
            "row alone is a hinge: add these, held\nlikewise, and elements between them "
            "and the held row, without mass; leave them out of your\nframes. The angle "
            "over the held row stands for half a cell of the sheet: its stiffness is "
            "another\n(Parameters). A simulator with rotations holds those of the held "
            "vertices instead and needs none.",
            h->outside);
    else
        output_print(out, " No row outside the sheet is needed.");
    output_print(out, "%s%s\n\n", *h->doubt.text ? "\nNote: " : "", h->doubt.text);
}

/* Says what a simulator without softening loses of it. */
static void put_softening(const struct export_job *j, struct output *out)
{
    const struct law law = scene_law(&j->scene);
    const double *B = j->scene.fabric.bending;
    static const char *const name[] = {"warp", "weft"};

    for (int n = 0; n < 2; n++)
        if (law.soft[n].second < 0)
            output_print(out,
                         "- bending along the %s softens: M = B%d k + C%d k |k| up to k = "
                         "%.3g 1/m. Without C%d [N m^2],\n  which only a curve of moment "
                         "over curvature holds, a sheet is %.3g times as stiff there;\n",
                         name[n], n + 1, n + 1, law.soft[n].most, n + 1,
                         B[n] / (B[n] + law.soft[n].second * law.soft[n].most));
}

/* Says where no rule for hinges is right in every direction. */
static void tell_long_cells(const struct export_job *j, struct output *out)
{
    if (j->scene.shape == SCENE_FLAT && !j->sheet.mesh && !hinges_of(&j->sheet).everywhere)
        output_print(out,
                     "\nNo stiffnesses of hinges are right for bending askew to u and v "
                     "on this mesh: its cells are too long,\nor the fabric is too "
                     "unlike along warp and weft. Along u and v they are.\n");
}

/* Says what each kind of simulator takes of a fabric, and what is lost on the way. */
static void put_fabric_parameters(const struct export_job *j, struct output *out)
{
    const struct law_fabric *f = &j->scene.fabric;
    const double *Y = f->membrane, *B = f->bending;
    struct law law = scene_law(&j->scene);

    output_print(
        out,
        "materials.csv. They follow from the fabric's moduli by rule; none is fitted.\n"
        "The warp runs at %g degrees from u towards v.\n\n"
        "- shells with matrices: Y11, Y22, Y12, G [N/m], energy of shear 2 G E12^2; B1, "
        "B2, B12, B66\n  [N m]. Nothing is lost%s;\n"
        "- orthotropic solids and shells of one thickness (CalculiX: ENGINEERING "
        "CONSTANTS): E1, E2,\n  nu12, G12, rho, h, h the effective thickness. Lost: they "
        "bend with %.3g times B1, %.3g times B2\n  and %.3g times B66;\n",
        f->warp, law.softens ? " but the softening of bending" : "",
        Y[LAW_WARP] * law.thickness * law.thickness / 12 / B[LAW_WARP],
        Y[LAW_WEFT] * law.thickness * law.thickness / 12 / B[LAW_WEFT],
        Y[LAW_SHEAR] * law.thickness * law.thickness / 12 / B[LAW_SHEAR]);
    put_softening(j, out);
    if (j->sheet.mesh)
        output_print(out, "- springs and XPBD: none are told. Edges of a mesh run in all "
                          "directions, a fabric's moduli do not;\n");
    else if (j->scene.shape == SCENE_FLAT && law_is_aligned(&law))
        output_print(out,
                     "- springs and XPBD: `value` [N/m], `compliance` [m/N] along u, v "
                     "and diagonals. Lost: Y12, which is G\n  in a net of springs;\n");
    else
        output_print(out,
                     "- springs and XPBD: none are told. Nets along u and v cannot hold "
                     "this warp;\n");
    output_print(
        out,
        "- angles between two triangles, k theta^2 / 2: %s. Lost: "
        "what tells B12\n  from B66 in double curvature%s;\n"
        "- simulators with isotropic values only: E, nu, rho, h of the mean over all "
        "directions. Lost: the\n  weft's membrane is %.3g times, its bending %.3g times as "
        "stiff as the warp's, and shear is %.3g\n  times as stiff as this mean's. "
        "`clothbench study fabrics` measures what that costs.\n",
        j->sheet.mesh ? "k of each edge in hinges.csv" : "k along u, v and diagonals",
        law_is_aligned(&law) ? "" : ", B13 and B23, which couple bending to twist",
        Y[LAW_WEFT] / Y[LAW_WARP], B[LAW_WEFT] / B[LAW_WARP],
        Y[LAW_SHEAR] * 2 * (1 + law.poisson) / (law.young * law.thickness));
}

static void put_isotropic_parameters(const struct export_job *j, struct output *out)
{
    const bool flat = j->scene.shape == SCENE_FLAT;

    output_print(
        out, "materials.csv. They follow from E, nu, rho and h by rule; none is fitted.\n\n"
             "- finite elements and shells: E, nu, rho, h as they are;\n"
             "- mass of a vertex: areal mass times its share of the area;\n");
    if (j->sheet.mesh)
        output_print(
            out,
            "- springs along edges: `value` [N/m], sqrt(3)/4 E h beside each triangle "
            "(Lloyd, Szekely and\n  Harders 2007); XPBD: `compliance` of C = length - "
            "rest_length;\n- bending by the angle between two triangles, k theta^2 / "
            "2: hinges.csv has for each edge a b, between\n  triangles with c and d, k "
            "= D |e|^2 / (A1 + A2) [N m], with one area at a clamp, times a\n  factor with "
            "which the mesh bends as the sheet does in every direction, on the mean. Of a "
            "mesh\n  that is cut one way it is 1, and askew that is up to three times too "
            "stiff.\n");
    else if (flat)
        output_print(
            out, "- springs along u, v and both diagonals of each cell: `value` [N/m]; on "
                 "square cells\n  C - G h straight, G h diagonal, half on the rim, where "
                 "C - (G h)^2/C = E h: tension with free sides,\n  and shear, are the "
                 "sheet's;\n- XPBD: `compliance` = 1/stiffness [m/N], of C = length - "
                 "rest_length;\n");
    else
        output_print(out,
                     "- springs: none are told; the matched ones are for flat sheets;\n");
    if (!j->sheet.mesh)
        output_print(
            out, "- bending by the angle between two triangles, k theta^2 / 2%s.\n",
            flat ? ": k [N m] of edges along u, along\n  v and along diagonals (`hinge "
                   "u`, `hinge v`, `hinge diagonal`). They are right for these\n  "
                   "triangles, whose diagonals alternate, and not the usual D |e|^2 / (A1 "
                   "+ A2), with which this\n  net is up to a third too stiff or too soft. "
                   "At a clamp, where the three vertices of a triangle are\n  held, k is "
                   "that of `hinge u held`, `hinge v held`"
                 : ": none are told, those known are for flat sheets");
}

static void put_parameters(const struct export_job *j, struct output *out)
{
    output_print(out, "## Parameters\n\n");
    if (j->scene.is_fabric)
        put_fabric_parameters(j, out);
    else
        put_isotropic_parameters(j, out);
    tell_long_cells(j, out);
    if (*j->misfit.text)
        output_print(out, "\nSprings are no plane stress: %s.\n", j->misfit.text);
    output_print(out, "\n");
}

static void put_score(const struct export_job *j, struct output *out)
{
    const struct truth *known = &j->known;
    struct message why = {""};

    output_print(out,
                 "## Frames, and how they are scored\n\n"
                 "Positions of all vertices of the sheet at each time: a CSV with lines "
                 "t,u,v,x,y,z in any\norder, OBJ or PLY a frame, or NPZ or HDF5 with "
                 "xyz [frames][n][3], uv [n][2], t [frames]\n(in Python: "
                 "clothbench.frames.write(path, t, uv, xyz)).\n\n");
    if (known->claimed == 1)
        output_print(out, "The truth is known at %g s", known->time[0]);
    else if (known->claimed)
        output_print(out, "The truth is known at %d times from %g to %g s", known->claimed,
                     known->time[0], known->time[known->claimed - 1]);
    else if (truth_plan_check(&j->scene, &why) == STATUS_OK)
        output_print(out, "No truth is stored: `clothbench truth scene.yaml` makes one in "
                          "results/truths, where score\nfinds it");
    else
        output_print(out, "No truth is stored: %s", why.text);
    output_print(out, "%s.\n",
                 known->claimed ? " (times.csv, with its error bar [m])" : "");
    if (known->claimed)
        output_print(out, "What it is: %s.\n", known->source);
    const bool outlined = j->scene.pattern;
    output_print(out,
                 "Every point of a 100 x 100 grid over (u,v)%s is compared, yours %s:\n\n"
                 "    clothbench score scene.yaml FRAMES%s\n\nprints the rms distance over "
                 "the %s at each of these times, the truth's error bar, and what\nyour net "
                 "alone would cost.\n",
                 outlined ? " that is on the sheet" : "",
                 outlined ? "linear in the triangles" : "bilinear between vertices",
                 outlined ? " --rest rest.obj" : "",
                 outlined ? "square root of the area" : "length");
}

static void write_readme(struct export_job *j, struct output *out)
{
    put_title(j, out);
    put_physics(j, out);
    put_held(j, out);
    put_parameters(j, out);
    put_score(j, out);
}

/* --- the command --- */

typedef void write_one(struct export_job *j, struct output *out);

/* The files in their order: README.md prints what materials.csv found. */
static const struct {
    const char *name;
    const char *format; /* of --format that picks it; NULL: it is always written         */
    unsigned need;      /* of the scene, without which it is left out; 0: none           */
    write_one *write;
} files[] = {
    {"rest.obj", "obj", 0, export_mesh_obj},
    {"rest.ply", "ply", 0, export_mesh_ply},
    {"rest.csv", "csv", 0, export_mesh_csv},
    {"held.csv", NULL, 0, export_held_csv},
    {"materials.csv", NULL, 0, export_numbers_materials},
    {"hinges.csv", NULL, 0, export_numbers_hinges},
    {"times.csv", NULL, 0, export_numbers_times},
    {"obstacles.csv", NULL, SCENE_NEED_CONTACT, export_numbers_obstacles},
    {"paths.csv", NULL, SCENE_NEED_MOVING_SUPPORTS, export_numbers_paths},
    {"loads.csv", NULL, SCENE_NEED_LOADS, export_numbers_loads},
    {"velocities.csv", NULL, SCENE_NEED_INITIAL_MOTION, export_numbers_velocities},
    {"scene.yaml", NULL, 0, write_scene},
    {"README.md", NULL, 0, write_readme},
};
enum { FILES = sizeof files / sizeof *files };

static enum status write_file(struct export_job *j, const char *name, write_one *write,
                              const char *folder, struct message *why)
{
    struct output *out = NULL;

    CALL(output_create(arena_print(&j->arena, "%s/%s", folder, name), &out, why));
    write(j, out);
    return output_close(&out, why);
}

/* Writes all files that the scene needs. */
static enum status write_all(struct export_job *j, const char *folder, struct message *why)
{
    const unsigned needs = scene_needs(&j->scene);

    for (int n = 0; n < FILES; n++)
        if ((!files[n].need || needs & files[n].need) &&
            (j->sheet.mesh || files[n].write != export_numbers_hinges))
            CALL(write_file(j, files[n].name, files[n].write, folder, why));
    if (j->scene.pattern && j->scene.pattern->mesh.nodes)
        CALL(write_file(j, SHEET_FILE, export_mesh_sheet, folder, why));
    for (j->body = 0; j->body < j->scene.obstacle_count; j->body++) {
        char name[32];
        snprintf(name, sizeof name, MESH_FILE, j->body);
        if (j->scene.obstacles[j->body].kind == OBSTACLE_MESH)
            CALL(write_file(j, name, export_mesh_body, folder, why));
    }
    return STATUS_OK;
}

/* Has Python make scene.usda of the other files; without it these are all that there is. */
static enum status write_usd(struct export_job *j, const char *folder, struct message *why)
{
    struct message said = {""};
    const char *path = arena_print(&j->arena, "%s/scene.usda", folder);
    const enum status st =
        show_run((const char *const[]){"usd", folder, path, NULL}, &said);

    if (st != STATUS_LIBRARY)
        return st == STATUS_OK ? st : status_fail(why, st, "%s", said.text);
    fprintf(stderr, "export: no scene.usda: %s\n", said.text);
    return STATUS_OK;
}

/* Leaves one format of the rest mesh, NULL all. */
static void leave_format(struct export_job *j, const char *format, const char *folder)
{
    for (int n = 0; format && n < FILES; n++)
        if (files[n].format && strcmp(format, files[n].format))
            remove(arena_print(&j->arena, "%s/%s", folder, files[n].name));
}

static enum status read_scene(struct export_job *j, const struct command_line *line,
                              struct message *why)
{
    int count;
    const char *const *given = command_values(line, "--set", &count);
    char *path;

    settings_set_all(&j->settings, count, given);
    CALL(scene_file_find(line->words[0], &path, why));
    count = j->settings.count;
    CALL(truth_plan_scene(arena_keep(&j->arena, path), &j->settings, &j->scene, why));
    j->undamped = j->settings.count > count;
    return STATUS_OK;
}

/* Reads how fine the sheet is to be: --points, a mesh of one's own, or the scene's. */
static enum status read_fineness(struct export_job *j, const struct command_line *line,
                                 struct discretization *d, struct message *why)
{
    const bool points = command_given(line, "--points"),
               mesh = command_given(line, "--mesh");
    const struct pattern *p = j->scene.pattern;

    if (p && (mesh || (points && p->mesh.nodes)))
        return status_fail(why, STATUS_INPUT,
                           "%s: %s has a mesh of its own%s; leave it out",
                           mesh ? "--mesh" : "--points", j->scene.name,
                           p->mesh.nodes ? "" : ", which --points N,M makes finer");
    if (points == mesh && !(p && p->mesh.nodes))
        return status_fail(why, STATUS_INPUT,
                           "export needs --points N,M, as in --points 21,21%s",
                           p ? "" : ", or --mesh FILE.obj");
    if (points)
        CALL(command_pair(line, "--points", 2, EXPORT_SHEET_MOST, j->sheet.points, why));
    memcpy(d->points, j->sheet.points, sizeof j->sheet.points);
    d->mesh = (char *)command_value(line, "--mesh");
    return STATUS_OK;
}

/* Checks the whole request before anything is written. */
static enum status prepare(struct export_job *j, const struct command_line *line,
                           struct message *why)
{
    const char *format = command_value(line, "--format");
    struct discretization d = {.points = {2, 2, 1}};

    if (!command_given(line, "--out"))
        return status_fail(why, STATUS_INPUT, "export needs --out FOLDER, a new one");
    if (format && strcmp(format, "obj") && strcmp(format, "ply") && strcmp(format, "csv"))
        return status_fail(why, STATUS_INPUT, "--format %s: obj, ply or csv would be right",
                           format);
    CALL(read_scene(j, line, why));
    CALL(read_fineness(j, line, &d, why));
    if (scene_needs(&j->scene) & SCENE_NEED_OWN_MATERIALS)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "%s has sheets with materials of their own, but export writes "
                           "one material",
                           j->scene.name);
    j->sheet.scene = &j->scene;
    if (d.mesh && (scene_sheets(&j->scene) > 1 || j->scene.shape != SCENE_FLAT))
        return status_fail(why, STATUS_UNSUPPORTED, "--mesh: of one flat sheet only");
    if (d.mesh || j->scene.pattern) {
        CALL(mesh_make(&j->mesh, &j->scene, &d, MESH_NO_NODES, why));
        j->sheet.mesh = &j->mesh;
        const struct law law = scene_law(&j->scene);
        j->hinge = arena_take(&j->arena, (size_t)j->mesh.edges, sizeof *j->hinge);
        CALL(hinge_mesh_factors(&j->mesh, law.matrix[LAW_BENDING], j->hinge));
    }
    CALL(export_held_find(&j->arena, &j->sheet, &j->held, why));
    return truth_judged(&j->scene, &j->known, why);
}

static enum status run(struct command_line *line, struct message *why)
{
    const char *out = command_value(line, "--out");
    struct folder_aside aside = {0};
    struct export_job j = {0};
    enum status st;

    TRY(prepare(&j, line, why));
    TRY(folder_aside_open(out, &aside, why));
    TRY(write_all(&j, aside.temporary, why));
    TRY(write_usd(&j, aside.temporary, why));
    leave_format(&j, command_value(line, "--format"), aside.temporary);
    TRY(folder_aside_commit(&aside, why));
    if (*j.held.doubt.text)
        fprintf(stderr, "export: %s\n", j.held.doubt.text);
    fprintf(stderr, "%s, %d vertices, in %s; begin with README.md there\n", j.scene.name,
            export_sheet_vertices(&j.sheet), out);
out:
    folder_aside_discard(&aside);
    truth_clear(&j.known);
    mesh_clear(&j.mesh);
    arena_clear(&j.arena);
    settings_clear(&j.settings);
    scene_clear(&j.scene);
    return st;
}

static const struct command_option options[] = {
    {"--points", "N,M", false, "vertices along u and v of a sheet (or --mesh)"},
    {"--mesh", "FILE.obj", false,
     "your own triangles; vt, or x and y, are the sheet's plane"},
    {"--out", "FOLDER", false, "a new folder for the files (required)"},
    {"--format", "obj|ply|csv", false, "format of the rest mesh (all three)"},
    {"--set", "KEY=VALUE", true, "change a key of the scene"},
    {NULL, NULL, false, NULL},
};

const struct command export_command = {
    .name = "export",
    .summary = "write a scene for your own simulator",
    .arguments = "SCENE [OPTION]...",
    .text =
        "Writes what another simulator needs to run a scene: the rest mesh with u and v,\n"
        "the vertices that are held and those outside the sheet that make an edge a\n"
        "clamp, the material as elements, springs and XPBD need it, the times at which\n"
        "the truth is known, obstacles, loads and moving supports, the scene itself,\n"
        "also in OpenUSD, and README.md with the rules on one page. The physics are those\n"
        "of the scene's truth. Either all files appear or none does; a folder that is not\n"
        "empty is left alone.\n",
    .examples = "export edge_drop --points 21,21 --out edge_drop_21\n"
                "export sphere --points 51,51 --format obj --out ball\n"
                "export edge_drop --mesh mine.obj --out mine\n",
    .least = 1,
    .most = 1,
    .options = options,
    .run = run,
};
