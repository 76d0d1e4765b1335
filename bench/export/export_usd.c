/* Writes scene.usda: the sheet as a surface deformable of the AOUSD proposal "Deformable
 * Body Physics in USD" (OpenUSD-proposals, pull request 111, at 584939b6), in SI units. */
#include "bench/export/export_parts.h"

#include <math.h>
#include <stdlib.h>

enum { A_LINE = 8 }; /* elements of an array                                           */

/* The mesh of the file: the sheet's triangles, then those of its clamps. */
struct usd_mesh {
    int count;
    int (*corner)[3]; /*                                                           owned */
};

/* Prints what stands before element n of an array. */
static void next(struct output *out, int n)
{
    output_print(out, "%s", n % A_LINE ? ", " : n ? ",\n            " : "\n            ");
}

static void put_whole(struct output *out, int n, int value)
{
    next(out, n);
    output_print(out, "%d", value);
}

static void put_triple(struct output *out, int n, const double x[3])
{
    next(out, n);
    output_print(out, "(%.9g, %.9g, %.9g)", x[0] + 0.0, x[1] + 0.0, x[2] + 0.0);
}

/* Returns the place of a held vertex of the sheet. */
static void place_of(const struct export_sheet *s, int vertex, int place[2])
{
    const int columns = export_sheet_columns(s);

    place[0] = export_sheet_place(s, vertex % columns);
    place[1] = vertex / columns;
}

/* Adds the cell between two vertices outside and the held ones beside them, if the two are
 * neighbours off the same edge; a comes first in the row of held vertices. */
static void add_cell(const struct export_sheet *s, const struct export_held_vertex *a,
                     const struct export_held_vertex *b, struct usd_mesh *mesh)
{
    int p[2], q[2];

    place_of(s, a->beside, p);
    place_of(s, b->beside, q);
    const int along[2] = {q[0] - p[0], q[1] - p[1]}, off[2] = {a->i - p[0], a->j - p[1]};
    const int turn = along[0] * off[1] - along[1] * off[0];
    if (b->i - q[0] != off[0] || b->j - q[1] != off[1] || along[0] + along[1] != 1 ||
        along[0] * along[1] != 0 || turn == 0)
        return;
    const int round[4] = {a->beside, turn > 0 ? b->beside : a->vertex, b->vertex,
                          turn > 0 ? a->vertex : b->beside};
    for (int k = 0; k < 2; k++, mesh->count++)
        for (int c = 0; c < 3; c++)
            mesh->corner[mesh->count][c] = round[c ? c + k : 0];
}

static enum status make_mesh(const struct export_job *j, struct usd_mesh *mesh)
{
    const struct export_held *held = &j->held;
    const int inside = held->count - held->outside;

    mesh->corner = malloc((size_t)(export_mesh_triangles(&j->sheet) + 4 * held->outside) *
                          sizeof *mesh->corner);
    if (!mesh->corner)
        return STATUS_MEMORY;
    for (; mesh->count < export_mesh_triangles(&j->sheet); mesh->count++)
        export_mesh_triangle(&j->sheet, mesh->count, mesh->corner[mesh->count]);
    for (int a = inside; a < held->count; a++)
        for (int b = a + 1; b < held->count; b++)
            add_cell(&j->sheet, &held->vertex[a], &held->vertex[b], mesh);
    return STATUS_OK;
}

static void put_head(const struct export_job *j, struct output *out)
{
    const double *g = j->scene.gravity, size = hypot(g[0], hypot(g[1], g[2]));
    const double one = size > 0 ? 1 / size : 0;

    output_print(out,
                 "#usda 1.0\n(\n    defaultPrim = \"World\"\n    metersPerUnit = 1\n"
                 "    kilogramsPerUnit = 1\n    upAxis = \"Z\"\n"
                 "    timeCodesPerSecond = 1\n    startTimeCode = 0\n"
                 "    endTimeCode = %.9g\n)\n\ndef Xform \"World\"\n{\n",
                 j->scene.end);
    output_print(out,
                 "    def PhysicsScene \"Physics\"\n    {\n"
                 "        vector3f physics:gravityDirection = (%.9g, %.9g, %.9g)\n"
                 "        float physics:gravityMagnitude = %.9g\n    }\n\n",
                 one * g[0] + 0.0, one * g[1] + 0.0, one * g[2] + 0.0, size);
}

/* Puts the structural stiffnesses that the proposal derives from E, nu and h, and those
 * too. */
static void put_material(const struct export_job *j, struct output *out)
{
    const struct scene *c = &j->scene;
    const double membrane = c->young * c->thickness;

    output_print(out,
                 "    def Material \"Cloth\" (\n        prepend apiSchemas = "
                 "[\"PhysicsSurfaceDeformableMaterialAPI\"]\n    )\n    {\n"
                 "        float physics:density = %.9g\n"
                 "        float physics:youngsModulus = %.9g\n"
                 "        float physics:poissonsRatio = %.9g\n"
                 "        float physics:surfaceStretchStiffness = %.9g\n"
                 "        float physics:surfaceShearStiffness = %.9g\n"
                 "        float physics:surfaceBendStiffness = %.9g\n    }\n\n",
                 c->density, c->young, c->poisson, membrane / (1 - c->poisson * c->poisson),
                 membrane / 2 / (1 + c->poisson), scene_bending_stiffness(c));
}

static int vertices(const struct export_job *j)
{
    return export_sheet_vertices(&j->sheet) + j->held.outside;
}

/* Finds u, v and the place of a vertex, those outside the sheet after the others. */
static void vertex_at(const struct export_job *j, int n, double uvw[3], double x[3])
{
    const int outside = n - export_sheet_vertices(&j->sheet);
    const struct export_held_vertex *v =
        &j->held.vertex[j->held.count - j->held.outside + outside];

    if (outside < 0)
        export_sheet_vertex(&j->sheet, n, uvw, x);
    else
        export_sheet_point(&j->sheet, v->i, v->j, uvw, x);
}

static void put_points(const struct export_job *j, struct output *out)
{
    const bool moves = scene_needs(&j->scene) & SCENE_NEED_INITIAL_MOTION;
    double uvw[3], x[3], v[3];
    int held = 0;

    output_print(out, "        point3f[] points = [");
    for (int n = 0; n < vertices(j); n++) {
        vertex_at(j, n, uvw, x);
        put_triple(out, n, x);
    }
    output_print(out, "]\n        texCoord2f[] primvars:st = [");
    for (int n = 0; n < vertices(j); n++) {
        vertex_at(j, n, uvw, x);
        next(out, n);
        output_print(out, "(%.9g, %.9g)", uvw[0], uvw[1]);
    }
    output_print(out, "] (interpolation = \"vertex\")\n");
    for (int n = 0; moves && n < vertices(j); n++) {
        export_numbers_velocity(j, n, &held, v);
        output_print(out, n ? "" : "        vector3f[] velocities = [");
        put_triple(out, n, v);
    }
    output_print(out, moves ? "]\n" : "");
}

/* Puts vertices that are held, in which components: what a simulator without attachments
 * pins. */
static void put_held(const struct export_job *j, struct output *out)
{
    output_print(out,
                 "        custom int clothbench:sheetVertices = %d\n"
                 "        custom int[] clothbench:held = [",
                 export_sheet_vertices(&j->sheet));
    for (int n = 0; n < j->held.count; n++)
        put_whole(out, n, j->held.vertex[n].vertex);
    output_print(out, "]\n        custom token[] clothbench:held:fix = [");
    for (int n = 0; n < j->held.count; n++) {
        next(out, n);
        output_print(out, "\"%s\"", export_sheet_axes(j->held.vertex[n].fix));
    }
    output_print(out, "]\n");
}

static void put_mesh(const struct export_job *j, const struct usd_mesh *mesh,
                     struct output *out)
{
    const unsigned needs = scene_needs(&j->scene);

    output_print(out,
                 "    def Mesh \"Sheet\" (\n        prepend apiSchemas = "
                 "[\"PhysicsDeformableBodyAPI\", \"PhysicsSurfaceDeformableSimAPI\",\n"
                 "            %s\"MaterialBindingAPI\"]\n    )\n    {\n"
                 "        rel material:binding:physics = </World/Cloth>\n"
                 "        uniform token subdivisionScheme = \"none\"\n"
                 "        float[] physics:thicknesses = [%.9g]\n"
                 "        uniform token physics:thicknesses:elementType = \"constant\"\n"
                 "        uniform token physics:restBendAnglesDefault = \"%s\"\n"
                 "        int[] faceVertexCounts = [",
                 needs & (SCENE_NEED_CONTACT | SCENE_NEED_SELF_CONTACT)
                     ? "\"PhysicsCollisionAPI\", "
                     : "",
                 j->scene.thickness, j->scene.shape == SCENE_FLAT ? "flat" : "restShape");
    for (int n = 0; n < mesh->count; n++)
        output_print(out, n ? ", 3" : "3");
    output_print(out, "]\n        int[] faceVertexIndices = [");
    for (int n = 0; n < mesh->count; n++) {
        const int *c = mesh->corner[n];
        next(out, n);
        output_print(out, "%d, %d, %d", c[0], c[1], c[2]);
    }
    output_print(out, "]\n");
    put_points(j, out);
    put_held(j, out);
    output_print(out, "    }\n");
}

/* Puts, one after the other, the vertices that a body holds in all three components, or
 * where they are at rest. `path` is the body's, -1 the world's. */
static void put_attached(const struct export_job *j, int path, bool at_rest,
                         struct output *out)
{
    int count = 0;

    for (int n = 0; n < j->held.count; n++) {
        const struct export_held_vertex *v = &j->held.vertex[n];
        double uvw[3], x[3];
        if (v->fix != FIX_XYZ || v->support != path)
            continue;
        export_sheet_point(&j->sheet, v->i, v->j, uvw, x);
        if (at_rest)
            put_triple(out, count, x);
        else
            put_whole(out, count, v->vertex);
        count++;
    }
}

/* Puts the matrix of a body that turns, frame by frame, for points as rows. */
static void put_turning(const struct export_job *j, const struct scene_motion *m,
                        struct output *out)
{
    const int frames = (int)lround(j->scene.end / j->scene.step);

    for (int k = 0; k <= frames; k++) {
        struct scene_placement p;
        scene_motion_at(m, k * j->scene.step, &p);
        output_print(out, "            %.9g: (", k * j->scene.step);
        for (int i = 0; i < 3; i++)
            output_print(out, "(%.17g, %.17g, %.17g, 0), ", p.turn[0][i], p.turn[1][i],
                         p.turn[2][i]);
        output_print(out, "(%.17g, %.17g, %.17g, 1)),\n", p.shift[0], p.shift[1],
                     p.shift[2]);
    }
}

/* Puts the body that a support moves, in seconds and metres. */
static void put_body(const struct export_job *j, int path, struct output *out)
{
    const struct scene_motion *m = &j->scene.supports[path].motion;
    const char *kind = m->turn_count ? "transform" : "translate";

    output_print(out,
                 "\n    def Xform \"Path%d\"\n    {\n"
                 "        %s xformOp:%s.timeSamples = {\n",
                 path, m->turn_count ? "matrix4d" : "double3", kind);
    if (m->turn_count)
        put_turning(j, m, out);
    for (int k = 0; k < m->path_count && !m->turn_count; k++)
        output_print(out, "            %.9g: (%.9g, %.9g, %.9g),\n", m->path[k][0],
                     m->path[k][1], m->path[k][2], m->path[k][3]);
    output_print(out,
                 "        }\n        uniform token[] xformOpOrder = "
                 "[\"xformOp:%s\"]\n    }\n",
                 kind);
}

/* Puts hard attachments to the world, path -1, or to the body that a path moves. */
static void put_attachment(const struct export_job *j, int path, struct output *out)
{
    char body[32] = "";

    if (path >= 0) {
        put_body(j, path, out);
        snprintf(body, sizeof body, "/Path%d", path);
    }
    output_print(out,
                 "\n    def PhysicsAttachment \"Held%s\"\n    {\n"
                 "        rel physics:src0 = </World/Sheet>\n"
                 "        rel physics:src1 = </World%s>\n"
                 "        uniform token physics:type0 = \"point\"\n"
                 "        uniform token physics:type1 = \"xform\"\n"
                 "        int[] physics:indices0 = [",
                 body + (path >= 0), body);
    put_attached(j, path, false, out);
    output_print(out, "]\n        vector3f[] physics:coords1 = [");
    put_attached(j, path, true, out);
    output_print(out, "]\n    }\n");
}

/* Tells whether the world, path -1, or a body holds any vertex in all components. The
 * proposal has no attachment in some of them. */
static bool holds(const struct export_job *j, int path)
{
    bool any = false;

    for (int n = 0; n < j->held.count; n++)
        any |= j->held.vertex[n].fix == FIX_XYZ && j->held.vertex[n].support == path;
    return any;
}

enum status export_usd(struct export_job *j, struct output *out)
{
    struct usd_mesh mesh = {0};
    enum status st;

    TRY(make_mesh(j, &mesh));
    put_head(j, out);
    put_material(j, out);
    put_mesh(j, &mesh, out);
    for (int path = -1; path < j->scene.support_count; path++)
        if (holds(j, path))
            put_attachment(j, path, out);
    output_print(out, "}\n");
out:
    free(mesh.corner);
    return st;
}
