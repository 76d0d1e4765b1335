#include "bench/export/export_numbers.h"

#include <math.h>
#include <stdlib.h>

#include "mass_spring/spring_net.h"
#include "models/mechanics/dead_load.h"

/* What round-off leaves of a stiffness that long cells have no use for, over E h. */
static const double NOTHING = 1e-12;

static void put(struct output *out, const char *quantity, double value, const char *unit)
{
    output_print(out, "%s,,,%.17g,%s,,\n", quantity, value, unit);
}

static void put_material(const struct scene *scene, struct output *out)
{
    const struct spring_law_stiffness plane = spring_law_plane_stress(scene);

    put(out, "E", scene->young, "Pa");
    put(out, "nu", scene->poisson, "1");
    put(out, "rho", scene->density, "kg/m^3");
    put(out, "h", scene->thickness, "m");
    put(out, "E h", scene->young * scene->thickness, "N/m");
    put(out, "E h/(1-nu^2)", plane.c11, "N/m");
    put(out, "G h", plane.c33, "N/m");
    put(out, "D", scene_bending_stiffness(scene), "N m");
    put(out, "areal mass", scene->density * scene->thickness, "kg/m^2");
}

/* Our number of a node of the springs' net, which counts along v first. */
static int vertex_of(const struct spring_net *net, int node)
{
    return node % net->points[1] * net->points[0] + node / net->points[1];
}

static enum status put_springs(const struct export_sheet *s, struct output *out,
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
        output_print(out, "%s,%d,%d,%.17g,N/m,%.17g,%.17g\n",
                     name[di && dj ? SPRING_DIAGONAL
                          : di     ? SPRING_U
                                   : SPRING_V],
                     vertex_of(&net, k->a), vertex_of(&net, k->b), k->stiffness, k->length,
                     1 / k->stiffness);
    }
    spring_law_tell(&net.law, net.cell, s->scene, misfit);
out:
    spring_net_clear(&net);
    return st;
}

enum status export_numbers_materials(const struct export_sheet *s, struct message *misfit,
                                     struct message *why)
{
    const double areal = s->scene->density * s->scene->thickness;
    struct output *out = NULL, *done;
    enum status st;

    TRY(export_sheet_open(s, "materials.csv", &out, why));
    output_print(out, "quantity,a,b,value,unit,rest_length,compliance\n");
    put_material(s->scene, out);
    for (int n = 0; n < export_sheet_vertices(s); n++)
        output_print(out, "mass,%d,,%.17g,kg,,\n", n, areal * export_sheet_area(s, n));
    if (s->scene->shape == SCENE_FLAT)
        TRY(put_springs(s, out, misfit));
    done = out, out = NULL;
    TRY(output_close(done, why));
out:
    output_discard(out);
    return st;
}

enum status export_numbers_times(const struct export_sheet *s,
                                 const struct truth_made *known, struct message *why)
{
    struct output *out = NULL;
    enum status st;

    TRY(export_sheet_open(s, "times.csv", &out, why));
    output_print(out, "what,time,bar\nstep,%.17g,\nend,%.17g,\n", s->scene->step,
                 s->scene->end);
    for (int n = 0; n < known->claimed; n++)
        output_print(out, "truth,%.17g,%.17g\n", known->time[n],
                     known->value[n][TRUTH_ERROR]);
    TRY(output_close(out, why));
out:
    return st;
}

static enum status write_obstacles(const struct export_sheet *s, struct message *why)
{
    struct output *out = NULL;
    enum status st;

    TRY(export_sheet_open(s, "obstacles.csv", &out, why));
    output_print(out, "kind,x,y,z,normal_x,normal_y,normal_z,radius,friction\n");
    for (int n = 0; n < s->scene->obstacle_count; n++) {
        const struct scene_obstacle *o = &s->scene->obstacles[n];
        const double *p = o->point, *m = o->normal;
        const double size = hypot(m[0], hypot(m[1], m[2]));
        if (o->kind == OBSTACLE_PLANE)
            output_print(out, "plane,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,,%.17g\n", p[0],
                         p[1], p[2], m[0] / size, m[1] / size, m[2] / size, o->friction);
        else
            output_print(out, "sphere,%.17g,%.17g,%.17g,,,,%.17g,%.17g\n", p[0], p[1], p[2],
                         o->radius, o->friction);
    }
    TRY(output_close(out, why));
out:
    return st;
}

static enum status write_paths(const struct export_sheet *s, struct message *why)
{
    struct output *out = NULL;
    enum status st;

    TRY(export_sheet_open(s, "paths.csv", &out, why));
    output_print(out, "path,t,x,y,z\n");
    for (int n = 0; n < s->scene->support_count; n++)
        for (int k = 0; k < s->scene->supports[n].path_count; k++) {
            const double *row = s->scene->supports[n].path[k];
            output_print(out, "%d,%.17g,%.17g,%.17g,%.17g\n", n, row[0], row[1], row[2],
                         row[3]);
        }
    TRY(output_close(out, why));
out:
    return st;
}

/* As the nets of springs and triangles spread them: by the hats of the vertices. */
static enum status write_loads(const struct export_sheet *s, struct message *why)
{
    const struct dead_load_line line[3] = {
        {.n = s->points[0], .degree = 1}, {.n = s->points[1], .degree = 1}, {.n = 1}};
    double *force = calloc(3 * (size_t)export_sheet_vertices(s), sizeof *force);
    struct output *out = NULL, *done;
    enum status st = STATUS_MEMORY;

    if (!force)
        return st;
    TRY(dead_load_add(s->scene, line, force));
    TRY(export_sheet_open(s, "loads.csv", &out, why));
    output_print(out, "vertex,x,y,z\n");
    for (int n = 0; n < export_sheet_vertices(s); n++) {
        const int i = n % s->points[0], j = n / s->points[0];
        const double *f = force + 3 * (i * s->points[1] + j);
        if (f[0] != 0 || f[1] != 0 || f[2] != 0)
            output_print(out, "%d,%.17g,%.17g,%.17g\n", n, f[0], f[1], f[2]);
    }
    done = out, out = NULL;
    TRY(output_close(done, why));
out:
    output_discard(out);
    free(force);
    return st;
}

static enum status write_velocities(const struct export_sheet *s,
                                    const struct export_held *held, struct message *why)
{
    struct output *out = NULL;
    enum status st;
    int next = 0; /* held vertices of the sheet come in their order */

    TRY(export_sheet_open(s, "velocities.csv", &out, why));
    output_print(out, "vertex,x,y,z\n");
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
    TRY(output_close(out, why));
out:
    return st;
}

enum status export_numbers_world(const struct export_sheet *s,
                                 const struct export_held *held, struct message *why)
{
    const unsigned needs = scene_needs(s->scene);
    enum status st = STATUS_OK;

    if (needs & SCENE_NEED_CONTACT)
        TRY(write_obstacles(s, why));
    if (needs & SCENE_NEED_MOVING_SUPPORTS)
        TRY(write_paths(s, why));
    if (needs & SCENE_NEED_LOADS)
        TRY(write_loads(s, why));
    if (needs & SCENE_NEED_INITIAL_MOTION)
        TRY(write_velocities(s, held, why));
out:
    return st;
}
