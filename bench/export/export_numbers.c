#include "bench/export/export_numbers.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/net/spring_net.h"
#include "models/mechanics/dead_load.h"

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

static void put_material(const struct scene *scene, const struct taker *t)
{
    const struct spring_law_stiffness plane = spring_law_plane_stress(scene);

    put(t, "E", scene->young, "Pa");
    put(t, "nu", scene->poisson, "1");
    put(t, "rho", scene->density, "kg/m^3");
    put(t, "h", scene->thickness, "m");
    put(t, "E h", scene->young * scene->thickness, "N/m");
    put(t, "E h/(1-nu^2)", plane.c11, "N/m");
    put(t, "G h", plane.c33, "N/m");
    put(t, "D", scene_bending_stiffness(scene), "N m");
    put(t, "areal mass", scene->density * scene->thickness, "kg/m^2");
}

/* Passes on the hinges' stiffness D |e|^2 / (A1 + A2) of an edge with triangles on both
 * sides, half a cell each (Grinspun et al. 2003, their stiffness matched to a plate's). A
 * triangle that is held does not bend and counts as no area: at a clamp one is left. */
static void put_hinges(const struct export_sheet *s, const struct taker *t)
{
    static const char *const name[] = {"hinge u", "hinge v", "hinge diagonal",
                                       "hinge u held", "hinge v held"};
    const double a = s->scene->length / (s->points[0] - 1),
                 b = s->scene->width / (s->points[1] - 1);
    const double square[] = {a * a, b * b, a * a + b * b};

    for (int n = 0; n < 5; n++) {
        const double area = n < 3 ? a * b : a * b / 2;
        const double k = scene_bending_stiffness(s->scene) * square[n % 3] / area;
        t->take(t->context, &(struct number){name[n], -1, -1, k, "N m", NAN, 1 / k});
    }
}

/* Returns our number of a node of the springs' net, which counts along v first. */
static int vertex_of(const struct spring_net *net, int node)
{
    return node % net->points[1] * net->points[0] + node / net->points[1];
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
                                 vertex_of(&net, k->a), vertex_of(&net, k->b), k->stiffness,
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
    put_hinges(s, t);
    return put_springs(s, t, misfit);
}

/* --- as a table: what is the same is a row ----------------------------------------------
 */

enum { KINDS = 32 };
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

    *table = table_create(sizeof columns / sizeof *columns, columns,
                          "Parameters of this net of points, for an engine of your own");
    TRY(each(s, &(struct taker){take_kind, &kinds}, &misfit));
    for (int n = 0; n < kinds.count; n++) {
        const struct number *k = &kinds.kind[n];
        table_row(*table);
        table_text(*table, "%s", k->quantity);
        table_number(*table, k->value, 6);
        table_text(*table, "%s", k->unit);
        table_number(*table, k->length, 6);
        table_number(*table, k->compliance, 6);
        table_fixed(*table, k->a < 0 ? NAN : (double)kinds.uses[n], 0);
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

/* --- as files ---------------------------------------------------------------------------
 */

struct numbers {
    const struct export_sheet *sheet;
    const struct export_held *held;
    const struct truth *known;
    struct message *misfit;
};
struct file {
    unsigned need; /* of the scene; 0: the file is always made                          */
    const char *name, *header;
    enum status (*rows)(const struct numbers *of, struct output *out);
};

static enum status write_file(const struct numbers *of, const struct file *file,
                              struct message *why)
{
    struct output *out = NULL, *done;
    enum status st;

    TRY(export_sheet_open(of->sheet, file->name, &out, why));
    output_print(out, "%s\n", file->header);
    TRY(file->rows(of, out));
    done = out, out = NULL;
    TRY(output_close(done, why));
out:
    output_discard(out);
    return st;
}

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

static enum status material_rows(const struct numbers *of, struct output *out)
{
    return each(of->sheet, &(struct taker){take_line, out}, of->misfit);
}

static enum status time_rows(const struct numbers *of, struct output *out)
{
    const struct truth *known = of->known;

    output_print(out, "step,%.17g,\nend,%.17g,\n", of->sheet->scene->step,
                 of->sheet->scene->end);
    for (int n = 0; n < known->claimed; n++)
        output_print(out, "truth,%.17g,%.17g\n", known->time[n], known->error[n]);
    return STATUS_OK;
}

static enum status obstacle_rows(const struct numbers *of, struct output *out)
{
    for (int n = 0; n < of->sheet->scene->obstacle_count; n++) {
        const struct scene_obstacle *o = &of->sheet->scene->obstacles[n];
        const double *p = o->point, *m = o->normal;
        const double size = hypot(m[0], hypot(m[1], m[2]));
        if (o->kind == OBSTACLE_PLANE)
            output_print(out, "plane,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,,%.17g\n", p[0],
                         p[1], p[2], m[0] / size, m[1] / size, m[2] / size, o->friction);
        else
            output_print(out, "sphere,%.17g,%.17g,%.17g,,,,%.17g,%.17g\n", p[0], p[1], p[2],
                         o->radius, o->friction);
    }
    return STATUS_OK;
}

static enum status path_rows(const struct numbers *of, struct output *out)
{
    for (int n = 0; n < of->sheet->scene->support_count; n++)
        for (int k = 0; k < of->sheet->scene->supports[n].path_count; k++) {
            const double *row = of->sheet->scene->supports[n].path[k];
            output_print(out, "%d,%.17g,%.17g,%.17g,%.17g\n", n, row[0], row[1], row[2],
                         row[3]);
        }
    return STATUS_OK;
}

/* Writes loads, distributed by the vertices' hat functions as springs and triangles do. */
static enum status load_rows(const struct numbers *of, struct output *out)
{
    const struct export_sheet *s = of->sheet;
    const struct dead_load_line line[3] = {
        {.n = s->points[0], .degree = 1}, {.n = s->points[1], .degree = 1}, {.n = 1}};
    double *force = calloc(3 * (size_t)export_sheet_vertices(s), sizeof *force);
    enum status st = STATUS_MEMORY;

    if (!force)
        return st;
    TRY(dead_load_add(s->scene, line, force));
    for (int n = 0; n < export_sheet_vertices(s); n++) {
        const int i = n % s->points[0], j = n / s->points[0];
        const double *f = force + 3 * (i * s->points[1] + j);
        if (f[0] != 0 || f[1] != 0 || f[2] != 0)
            output_print(out, "%d,%.17g,%.17g,%.17g\n", n, f[0], f[1], f[2]);
    }
out:
    free(force);
    return st;
}

static enum status velocity_rows(const struct numbers *of, struct output *out)
{
    const struct export_sheet *s = of->sheet;
    const struct export_held *held = of->held;
    int next = 0; /* held vertices of the sheet come in their order */

    for (int n = 0; n < export_sheet_vertices(s); n++) {
        const bool is_held = next < held->count && held->vertex[next].vertex == n;
        const unsigned fix = is_held ? held->vertex[next++].fix : 0;
        double uvw[3], x[3], v[3];
        export_sheet_point(s, n % s->points[0], n / s->points[0], uvw, x);
        scene_initial_velocity(s->scene, x, v);
        for (int c = 0; c < 3; c++)
            v[c] = fix >> c & 1 ? 0 : v[c];
        output_print(out, "%d,%.17g,%.17g,%.17g\n", n, v[0], v[1], v[2]);
    }
    return STATUS_OK;
}

enum status export_numbers_write(const struct export_sheet *s,
                                 const struct export_held *held, const struct truth *known,
                                 struct message *misfit, struct message *why)
{
    static const struct file files[] = {
        {0, "materials.csv", "quantity,a,b,value,unit,rest_length,compliance",
         material_rows},
        {0, "times.csv", "what,time,bar", time_rows},
        {SCENE_NEED_CONTACT, "obstacles.csv",
         "kind,x,y,z,normal_x,normal_y,normal_z,radius,friction", obstacle_rows},
        {SCENE_NEED_MOVING_SUPPORTS, "paths.csv", "path,t,x,y,z", path_rows},
        {SCENE_NEED_LOADS, "loads.csv", "vertex,x,y,z", load_rows},
        {SCENE_NEED_INITIAL_MOTION, "velocities.csv", "vertex,x,y,z", velocity_rows}};
    const struct numbers of = {s, held, known, misfit};
    enum status st = STATUS_OK;

    for (size_t n = 0; n < sizeof files / sizeof *files; n++)
        if (!files[n].need || scene_needs(s->scene) & files[n].need)
            TRY(write_file(&of, &files[n], why));
out:
    return st;
}
