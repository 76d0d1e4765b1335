/* The numbers that a simulator needs besides the mesh: materials.csv, times.csv, and where
 * the scene has them obstacles.csv, paths.csv, loads.csv, velocities.csv. */
#include "bench/export/export_numbers.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/export/export_parts.h"
#include "models/net/spring_net.h"
#include "models/mechanics/dead_load.h"
#include "models/reader/scene_schema.h"
#include "models/vector.h"

/* A stiffness over E h below this is round-off: long cells do not need that spring. */
static const double NOTHING = 1e-12;

/* Numbers that differ by less than this share are the same but for rounding: the mass of a
 * vertex, a spring's length. */
static const double SAME = 1e-9;

struct number {
    const char *quantity;
    int a, b; /* vertices; -1: none                                                    */
    double value;
    const char *unit;
    double length, compliance; /* at rest [m], 1/value; NaN: none                      */
};
/* The receiver of the numbers. */
struct taker {
    void (*take)(void *context, const struct number *number);
    void *context;
};

static void put(const struct taker *t, const char *quantity, double value, const char *unit)
{
    t->take(t->context, &(struct number){quantity, -1, -1, value, unit, NAN, NAN});
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

/* Passes on the hinges' stiffness D |e|^2 / (A1 + A2) of an edge with triangles on both
 * sides, half a cell each (Grinspun et al. 2003, their stiffness matched to a plate's). A
 * triangle that is held does not bend and counts as no area: at a clamp one is left. A
 * fabric's edges along u and v bend with B22 and B11. In a cylinder along u or v diagonals
 * do not fold; in a twist they alone do, and hold B66. */
static void put_hinges(const struct export_sheet *s, const struct taker *t)
{
    static const char *const name[] = {"hinge u", "hinge v", "hinge diagonal",
                                       "hinge u held", "hinge v held"};
    const double a = s->scene->length / (s->points[0] - 1),
                 b = s->scene->width / (s->points[1] - 1);
    const double square[] = {a * a, b * b, a * a + b * b};
    const struct law law = scene_law(s->scene);
    const double *B = law.matrix[LAW_BENDING], D = B[LAW_11];
    const double bending[] = {law.isotropic ? D : B[LAW_22], D,
                              law.isotropic ? D
                                            : 4 * B[LAW_33] * square[0] * square[1] /
                                                  (square[2] * square[2])};

    for (int n = 0; n < 5; n++) {
        const double area = n < 3 ? a * b : a * b / 2;
        const double k = bending[n % 3] * square[n % 3] / area;
        t->take(t->context, &(struct number){name[n], -1, -1, k, "N m", NAN, 1 / k});
    }
}

/* Returns our number of a node of the springs' net, which counts along v first. */
static int vertex_of(const struct export_sheet *s, int node)
{
    return node % s->points[1] * export_sheet_columns(s) + node / s->points[1];
}

static enum status put_springs(const struct export_sheet *s, const struct taker *t,
                               struct message *misfit)
{
    static const char *const name[] = {"spring u", "spring v", "spring diagonal"};
    struct spring_net net = {0};
    enum status st;

    TRY(spring_net_init(&net, s->scene, s->points, PARAMETERS_MATCHED, false));
    for (int n = 0; n < net.spring_count; n++) {
        const struct spring *k = &net.springs[n];
        if (!(k->stiffness > NOTHING * s->scene->young * s->scene->thickness))
            continue;
        const int di = k->b / net.points[1] != k->a / net.points[1];
        const int dj = k->b % net.points[1] != k->a % net.points[1];
        t->take(t->context,
                &(struct number){name[di && dj ? SPRING_DIAGONAL
                                      : di     ? SPRING_U
                                               : SPRING_V],
                                 vertex_of(s, k->a), vertex_of(s, k->b), k->stiffness,
                                 "N/m", k->length, 1 / k->stiffness});
    }
    spring_law_tell(&net.law, net.cell, s->scene, misfit);
out:
    spring_net_clear(&net);
    return st;
}

/* Passes on, one by one, all numbers of a net of points: the material; the mass of each
 * vertex a; on a flat sheet the stiffness of a hinge between two triangles over an inner
 * edge along u, along v and along a diagonal, D |e|^2 / (A1 + A2) (theta^2 / 2 times it is
 * the energy; Grinspun et al. 2003), and twice that where one of the two is held; and each
 * matched spring from a to b (models/net/spring_net.h). *misfit says what those springs
 * cannot represent; empty: nothing. */
static enum status each(const struct export_sheet *s, const struct taker *t,
                        struct message *misfit)
{
    const double areal = s->scene->density * s->scene->thickness;

    put_material(s->scene, t);
    for (int n = 0; n < export_sheet_vertices(s); n++)
        t->take(t->context, &(struct number){"mass", n, -1, areal * export_sheet_area(s, n),
                                             "kg", NAN, NAN});
    if (s->scene->shape != SCENE_FLAT)
        return STATUS_OK;
    const struct law law = scene_law(s->scene);
    put_hinges(s, t);
    return law_is_aligned(&law) ? put_springs(s, t, misfit) : STATUS_OK;
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

enum status export_numbers_table(const struct export_sheet *s, struct table **table)
{
    static const struct table_column columns[] = {{"quantity", NULL, TABLE_LEFT},
                                                  {"value"},
                                                  {"unit", NULL, TABLE_LEFT},
                                                  {"rest length", "m"},
                                                  {"compliance", "1/unit", .key_unit = "1"},
                                                  {"how many"}};
    struct kinds kinds = {0};
    struct message misfit = {""};
    enum status st;

    *table =
        TABLE_OF(columns, "Parameters of this net of points, for an engine of your own");
    TRY(each(s, &(struct taker){take_kind, &kinds}, &misfit));
    for (int n = 0; n < kinds.count; n++) {
        const struct number *k = &kinds.kind[n];
        table_line(*table, "%s|%.6g|%s|%.6g|%.6g|%.0f", k->quantity, k->value, k->unit,
                   k->length, k->compliance, k->a < 0 ? NAN : (double)kinds.uses[n]);
    }
    table_note(
        *table,
        "mass: of a vertex - corner, rim, inside; springs: half as stiff on the rim; "
        "hinge: bending by the angle theta between two triangles, k theta^2 / 2, over "
        "an inner edge along u, v or a diagonal, or over one of whose triangles one is "
        "held, at a clamp; compliance: of XPBD, with C = length - rest length or C = "
        "theta.");
    if (*misfit.text)
        table_note(*table, "Springs are no plane stress: %s.", misfit.text);
out:
    if (st != STATUS_OK) {
        table_destroy(*table);
        *table = NULL;
    }
    return st;
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

enum status export_numbers_materials(struct export_job *j, struct output *out)
{
    output_print(out, "quantity,a,b,value,unit,rest_length,compliance\n");
    return each(&j->sheet, &(struct taker){take_line, out}, &j->misfit);
}

enum status export_numbers_times(struct export_job *j, struct output *out)
{
    output_print(out, "what,time,bar\nstep,%.17g,\nend,%.17g,\n", j->scene.step,
                 j->scene.end);
    for (int n = 0; n < j->known.claimed; n++)
        output_print(out, "truth,%.17g,%.17g\n", j->known.time[n], j->known.error[n]);
    return STATUS_OK;
}

enum status export_numbers_obstacles(struct export_job *j, struct output *out)
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
    return STATUS_OK;
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

enum status export_numbers_paths(struct export_job *j, struct output *out)
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
    return STATUS_OK;
}

/* Writes loads, distributed by the vertices' hat functions as springs and triangles do. */
enum status export_numbers_loads(struct export_job *j, struct output *out)
{
    const struct export_sheet *s = &j->sheet;
    const struct dead_load_line line[3] = {
        {.n = s->points[0], .degree = 1}, {.n = s->points[1], .degree = 1}, {.n = 1}};
    double *force = calloc(3 * (size_t)export_sheet_vertices(s), sizeof *force);
    enum status st = STATUS_MEMORY;

    if (!force)
        return st;
    TRY(dead_load_add(s->scene, line, force));
    output_print(out, "vertex,x,y,z\n");
    for (int n = 0; n < export_sheet_vertices(s); n++) {
        const int columns = export_sheet_columns(s), along = n % columns,
                  across = n / columns;
        const double *f = force + 3 * (along * s->points[1] + across);
        if (f[0] != 0 || f[1] != 0 || f[2] != 0)
            output_print(out, "%d,%.17g,%.17g,%.17g\n", n, f[0], f[1], f[2]);
    }
out:
    free(force);
    return st;
}

void export_numbers_velocity(const struct export_job *j, int n, int *held, double v[3])
{
    const bool is_held = *held < j->held.count && j->held.vertex[*held].vertex == n;
    const unsigned fix = is_held ? j->held.vertex[(*held)++].fix : 0;
    double uvw[3], x[3] = {0};

    if (n < export_sheet_vertices(&j->sheet)) /* others are held */
        export_sheet_vertex(&j->sheet, n, uvw, x);
    scene_initial_velocity(&j->scene, x, v);
    for (int c = 0; c < 3; c++)
        v[c] = fix >> c & 1 ? 0 : v[c];
}

enum status export_numbers_velocities(struct export_job *j, struct output *out)
{
    double v[3];

    output_print(out, "vertex,x,y,z\n");
    for (int n = 0, held = 0; n < export_sheet_vertices(&j->sheet); n++) {
        export_numbers_velocity(j, n, &held, v);
        output_print(out, "%d,%.17g,%.17g,%.17g\n", n, v[0], v[1], v[2]);
    }
    return STATUS_OK;
}
