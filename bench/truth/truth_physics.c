#include "bench/truth/truth_physics.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "models/damping.h"

static void print(FILE *out, const char *key, int count, const double *value)
{
    fprintf(out, "%s", key);
    for (int n = 0; n < count; n++)
        fprintf(out, " %.17g", value[n] + 0.0); /* no -0 */
    fputc('\n', out);
}

static void print_supports(const struct scene *s, FILE *out)
{
    for (int n = 0; n < s->support_count; n++) {
        const struct scene_support *support = &s->supports[n];
        fprintf(out, "support fix %u\n", support->fix);
        print(out, "support from", 3, support->lo);
        print(out, "support to", 3, support->hi);
        for (int k = 0; k < support->path_count; k++)
            print(out, "support path", 4, support->path[k]);
    }
}

static void print_loads(const struct scene *s, FILE *out)
{
    for (int n = 0; n < s->load_count; n++) {
        print(out, "load from", 3, s->loads[n].lo);
        print(out, "load to", 3, s->loads[n].hi);
        print(out, "load force", 3, s->loads[n].force);
    }
}

static void print_obstacles(const struct scene *s, FILE *out)
{
    for (int n = 0; n < s->obstacle_count; n++) {
        const struct scene_obstacle *o = &s->obstacles[n];
        bool plane = o->kind == OBSTACLE_PLANE;
        print(out, plane ? "plane" : "sphere", 3, o->point);
        print(out, plane ? "normal" : "radius", plane ? 3 : 1,
              plane ? o->normal : &o->radius);
        print(out, "friction", 1, &o->friction);
    }
}

/* Only the numbers that the kind of damping has. A factor a step is a physics that depends
 * on the step. */
static void print_damping(const struct scene *s, FILE *out)
{
    const struct scene_damping *d = &s->damping;

    fprintf(out, "damping %s\n", damping_words[d->kind]);
    if (d->kind == DAMPING_RAYLEIGH)
        print(out, "rayleigh", 2, (double[]){d->alpha, d->beta});
    else if (d->kind != DAMPING_NONE)
        print(out, "value", 1, &d->value);
    if (d->kind == DAMPING_VELOCITY_SCALE)
        print(out, "step", 1, &s->step);
}

static bool is_zero(const double v[3])
{
    return v[0] == 0 && v[1] == 0 && v[2] == 0;
}

enum status truth_physics(const struct scene *s, char **text)
{
    char *result = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&result, &size);

    if (!out)
        return STATUS_MEMORY;
    print(out, "sheet", 3, (double[]){s->length, s->width, s->thickness});
    fprintf(out, "shape %s\n", scene_shape_words[s->shape]);
    if (s->shape == SCENE_CLOAK)
        print(out, "cloak", 2, (double[]){s->opening, s->flare});
    print(out, "origin", 3, s->origin);
    print(out, "u", 3, s->axis_u);
    print(out, "v", 3, s->axis_v);
    print(out, "material", 3, (double[]){s->young, s->poisson, s->density});
    print(out, "gravity", 3, s->gravity);
    print(out, "drag", 1, &s->drag);
    if (s->drag != 0)
        print(out, "wind", 3, s->wind);
    if (!is_zero(s->velocity) || !is_zero(s->spin)) {
        print(out, "velocity", 3, s->velocity);
        print(out, "spin", 3, s->spin);
    }
    print_damping(s, out);
    print_supports(s, out);
    print_loads(s, out);
    print_obstacles(s, out);
    if (fclose(out) != 0) {
        free(result);
        return STATUS_MEMORY;
    }
    *text = result;
    return STATUS_OK;
}

/* Past the lines that both begin with. */
static void skip_common(const char **a, const char **b)
{
    size_t line = 0;

    for (size_t n = 0; (*a)[n] && (*a)[n] == (*b)[n]; n++)
        if ((*a)[n] == '\n')
            line = n + 1;
    *a += line;
    *b += line;
}

enum { LINE = 256 };

/* The first line of a text, a blank before each word, with the digits that people write. */
static void tell_line(const char *text, char line[LINE])
{
    size_t used = 0;

    line[0] = '\0';
    for (size_t word; *text && *text != '\n' && used < LINE / 2; text += word) {
        char *after;
        const double value = strtod(text, &after);
        text += *text == ' ';
        word = strcspn(text, " \n");
        used +=
            (size_t)(after == text + word
                         ? snprintf(line + used, LINE - used, " %.15g", value)
                         : snprintf(line + used, LINE - used, " %.*s", (int)word, text));
    }
}

enum status truth_physics_check(const char *text, const struct scene *scene,
                                struct message *why)
{
    char *wanted = NULL;
    enum status st = truth_physics(scene, &wanted);

    if (st == STATUS_OK && strcmp(text, wanted) != 0) {
        const char *other = wanted;
        char line[2][LINE];
        skip_common(&text, &other);
        tell_line(*text ? text : "nothing", line[0]);
        tell_line(*other ? other : "nothing", line[1]);
        st = status_fail(why, STATUS_UNSUPPORTED, "of other physics:%s, not%s", line[0],
                         line[1]);
    }
    free(wanted);
    return st;
}
