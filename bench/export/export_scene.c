#include "bench/export/export_scene.h"

#include <stdlib.h>

#include "models/damping.h"

/* With as many digits as it takes to read it again; never -0. */
static void put_number(struct output *out, double value)
{
    char text[32];

    for (int digits = 15; digits <= 17; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, value + 0.0);
        if (strtod(text, NULL) == value)
            break;
    }
    output_print(out, "%s", text);
}

static void put_key(struct output *out, const char *key, double value)
{
    output_print(out, "%s: ", key);
    put_number(out, value);
}

static void put_list(struct output *out, const char *before, int count, const double *value,
                     const char *after)
{
    output_print(out, "%s[", before);
    for (int n = 0; n < count; n++) {
        output_print(out, "%s", n ? ", " : "");
        put_number(out, value[n]);
    }
    output_print(out, "]%s", after);
}

static void put_text(struct output *out, const char *key, const char *text)
{
    output_print(out, "%s: \"", key);
    for (; *text; text++)
        output_print(out, *text == '"' || *text == '\\' ? "\\%c" : "%c", *text);
    output_print(out, "\"\n");
}

static void put_sheet(const struct scene *s, struct output *out)
{
    put_key(out, "sheet: {length", s->length);
    put_key(out, ", width", s->width);
    put_key(out, ", thickness", s->thickness);
    output_print(out, "}\n");
    output_print(out, "pose:\n  kind: %s\n", scene_shape_name((int)s->shape));
    put_list(out, "  origin: ", 3, s->origin, "\n");
    put_list(out, "  u: ", 3, s->axis_u, "\n");
    put_list(out, "  v: ", 3, s->axis_v, "\n");
    if (s->shape == SCENE_CLOAK) {
        put_key(out, "  opening", s->opening);
        put_key(out, "\n  flare", s->flare);
        output_print(out, "\n");
    }
    put_key(out, "material: {young", s->young);
    put_key(out, ", poisson", s->poisson);
    put_key(out, ", density", s->density);
    output_print(out, "}\n");
}

static void put_forces(const struct scene *s, struct output *out)
{
    const struct scene_damping *d = &s->damping;

    put_list(out, "gravity: ", 3, s->gravity, "\n");
    if (s->drag > 0) {
        put_key(out, "drag: {coefficient", s->drag);
        put_list(out, ", wind: ", 3, s->wind, "}\n");
    }
    output_print(out, "damping: {kind: %s", damping_name((int)d->kind));
    if (d->kind == DAMPING_RAYLEIGH) {
        put_key(out, ", alpha", d->alpha);
        put_key(out, ", beta", d->beta);
    } else if (d->kind != DAMPING_NONE)
        put_key(out, ", value", d->value);
    output_print(out, "}\n");
    if (scene_needs(s) & SCENE_NEED_INITIAL_MOTION) {
        put_list(out, "motion: {velocity: ", 3, s->velocity, ", ");
        put_list(out, "spin: ", 3, s->spin, "}\n");
    }
}

static void put_region(struct output *out, const double lo[3], const double hi[3])
{
    output_print(out, "  - at: {");
    for (int c = 0; c < 3; c++) {
        output_print(out, "%s%c: ", c ? ", " : "", "uvw"[c]);
        if (lo[c] == hi[c])
            put_number(out, lo[c]);
        else
            put_list(out, "", 2, (double[]){lo[c], hi[c]}, "");
    }
    output_print(out, "}\n");
}

static void put_supports(const struct scene *s, struct output *out)
{
    for (int n = 0; n < s->support_count; n++) {
        const struct scene_support *p = &s->supports[n];
        output_print(out, "%s", n ? "" : "supports:\n");
        put_region(out, p->lo, p->hi);
        output_print(out, "    fix: %s\n%s", export_sheet_axes(p->fix),
                     p->path_count ? "    path:\n" : "");
        for (int k = 0; k < p->path_count; k++)
            put_list(out, "      - ", 4, p->path[k], "\n");
    }
    for (int n = 0; n < s->load_count; n++) {
        output_print(out, "%s", n ? "" : "loads:\n");
        put_region(out, s->loads[n].lo, s->loads[n].hi);
        put_list(out, "    force: ", 3, s->loads[n].force, "\n");
    }
}

static void put_obstacles(const struct scene *s, struct output *out)
{
    for (int n = 0; n < s->obstacle_count; n++) {
        const struct scene_obstacle *o = &s->obstacles[n];
        const bool plane = o->kind == OBSTACLE_PLANE;
        output_print(out, "%s  - %s:\n", n ? "" : "obstacles:\n",
                     plane ? "plane" : "sphere");
        put_list(out, plane ? "      point: " : "      center: ", 3, o->point, "\n");
        if (plane)
            put_list(out, "      normal: ", 3, o->normal, "\n");
        else
            put_key(out, "      radius", o->radius);
        put_key(out, plane ? "      friction" : "\n      friction", o->friction);
        output_print(out, "\n");
    }
}

enum status export_scene_write(const struct export_sheet *s, struct message *why)
{
    const struct scene *scene = s->scene;
    struct output *out = NULL;
    enum status st;

    TRY(export_sheet_open(s, "scene.yaml", &out, why));
    output_print(out, "name: %s\n", scene->name);
    put_text(out, "source", scene->source);
    put_sheet(scene, out);
    put_forces(scene, out);
    put_supports(scene, out);
    put_obstacles(scene, out);
    put_key(out, "time: {step", scene->step);
    put_key(out, ", end", scene->end);
    output_print(out, "}\n");
    if (scene->snapshot_count)
        put_list(out, "snapshots: ", scene->snapshot_count, scene->snapshots, "\n");
    TRY(output_close(out, why));
out:
    return st;
}
