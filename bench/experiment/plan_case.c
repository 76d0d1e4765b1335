#include "bench/experiment/plan_case.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/registry.h"
#include "bench/harness/derived_key.h"
#include "models/reader/scene_file.h"

static enum status refuse(const struct plan *plan, int line, struct message *why,
                          const char *text)
{
    const struct yaml_tree node = {.origin = plan->path, .line = line};

    return yaml_tree_refuse(&node, why, "%s", text);
}

const char *plan_case_set_by(const struct plan *plan, const char *key)
{
    for (int n = 0; n < plan->axis_count; n++)
        if (!strcmp(plan->axes[n].key, key) && plan->axes[n].by)
            return plan->axes[n].by;
    return "material.young";
}

/* Puts KEY=VALUE behind the settings of a case, which has room. */
static enum status put(struct plan_case *c, const char *key, const char *value)
{
    const size_t room = strlen(key) + strlen(value) + 2;
    char *text = malloc(room);

    if (!text)
        return STATUS_MEMORY;
    snprintf(text, room, "%s=%s", key, value);
    c->settings[c->setting_count++] = text;
    return STATUS_OK;
}

enum status plan_case_scene(const struct plan_case *c, struct scene *scene,
                            struct message *why)
{
    struct discretization d = {.weights = NULL};
    const struct model *model;
    enum status st;

    TRY(registry_find(c->model, &model, why));
    model->defaults(&d);
    st = scene_file_read(c->path, c->setting_count, (const char *const *)c->settings, scene,
                         &d, why);
    discretization_clear(&d);
out:
    return st;
}

enum status plan_case_mark(const struct plan *plan, const struct plan_settings *settings,
                           struct scene *scene, struct message *why)
{
    struct plan_case c;
    char **grown;
    enum status st;

    *scene = (struct scene){0};
    TRY(plan_case_open(plan, 0, &c, why));
    grown = realloc(c.settings,
                    (size_t)(c.setting_count + settings->count + 1) * sizeof *grown);
    TRY(grown ? STATUS_OK : STATUS_MEMORY);
    c.settings = grown;
    for (int n = 0; n < settings->count; n++)
        TRY(put(&c, settings->list[n].key, settings->list[n].value));
    TRY(plan_case_scene(&c, scene, why));
out:
    plan_case_clear(&c);
    return st;
}

/* Sets the key behind a stand-in so that its number takes the value in this case. */
static enum status resolve(const struct plan *plan, const struct plan_setting *s,
                           struct plan_case *c, struct message *why)
{
    const char *by = plan_case_set_by(plan, s->key);
    struct scene scene = {0};
    char text[160], *end;
    double want = strtod(s->value, &end), value;
    enum status st;

    snprintf(text, sizeof text, "%.40s is '%.40s', but must be a number above 0", s->key,
             s->value);
    if (end == s->value || *end || !(want > 0 && isfinite(want)))
        return refuse(plan, s->line, why, text);
    TRY(plan_case_scene(c, &scene, why));
    value = derived_key_solve(s->key, by, want, &scene);
    snprintf(text, sizeof text, "%.40s cannot be set by %.40s in this scene", s->key, by);
    if (isnan(value))
        TRY(refuse(plan, s->line, why, text));
    snprintf(text, sizeof text, "%.17g", value);
    TRY(put(c, by, text));
out:
    scene_clear(&scene);
    return st;
}

enum status plan_case_find_scene(const struct plan *plan, const char *argument, char **path,
                                 struct message *why)
{
    const char *slash = strrchr(plan->path, '/');
    enum status st = scene_file_find(argument, path, why);

    if (st != STATUS_OK || strcmp(*path, argument) || *argument == '/' || !slash)
        return st;
    const size_t room = strlen(plan->path) + strlen(argument) + 2;
    char *seen = malloc(room);
    if (seen)
        snprintf(seen, room, "%.*s/%s", (int)(slash - plan->path), plan->path, argument);
    free(*path);
    *path = seen;
    return seen ? STATUS_OK : STATUS_MEMORY;
}

/* The setting whose KEY=VALUE stands at the beginning of a text. */
static const struct plan_setting *find_blamed(const struct plan *plan,
                                              const struct plan_case *c, const char *text)
{
    for (int k = 0; k < plan->key_count; k++) {
        const struct plan_setting *s = c->given[k];
        if (!s)
            continue;
        const char *key = derived_key_is(s->key) ? plan_case_set_by(plan, s->key) : s->key;
        const size_t size = strlen(key);
        if (!strncmp(text, key, size) && text[size] == '=')
            return s;
    }
    return NULL;
}

enum status plan_case_blame(const struct plan *plan, const struct plan_case *c,
                            enum status st, struct message *why)
{
    static const char mark[] = "--set ";
    const struct message old = *why;
    const struct plan_setting *s = NULL;
    const char *text = old.text;

    if ((st != STATUS_INPUT && st != STATUS_FILE) ||
        !strncmp(text, plan->path, strlen(plan->path)))
        return st;
    if (!strncmp(text, mark, strlen(mark))) {
        text += strlen(mark);
        s = find_blamed(plan, c, text);
    }
    for (int k = 0; !s && k < plan->key_count; k++)
        if (!strcmp(plan->keys[k], "scene"))
            s = c->given[k]; /* the scene's file itself is wrong */
    return refuse(plan, s ? s->line : 1, why, text);
}

/* Fills model, scene file and settings of a case whose `given` is there. */
static enum status build(const struct plan *plan, struct plan_case *c, struct message *why)
{
    enum status st = STATUS_OK;
    const struct plan_setting *scene = NULL, *model = NULL;
    struct message text;
    const struct model *known;

    c->settings = calloc((size_t)plan->key_count + 1, sizeof *c->settings);
    if (!c->settings)
        return STATUS_MEMORY;
    for (int k = 0; k < plan->key_count; k++) {
        const struct plan_setting *s = c->given[k];

        if (!s || derived_key_is(s->key))
            continue;
        if (!strcmp(s->key, "model"))
            model = s;
        else if (!strcmp(s->key, "scene"))
            scene = s;
        else
            TRY(put(c, s->key, s->value));
    }
    if (!scene)
        return refuse(plan, 1, why, "the plan lacks the key 'scene', a name or a path");
    if (registry_find(model->value, &known, &text) != STATUS_OK)
        return refuse(plan, model->line, why, text.text);
    c->model = model->value;
    if (plan_case_find_scene(plan, scene->value, &c->path, &text) != STATUS_OK)
        return refuse(plan, scene->line, why, text.text);
    for (int k = 0; k < plan->key_count; k++)
        if (c->given[k] && derived_key_is(c->given[k]->key))
            TRY(resolve(plan, c->given[k], c, why));
out:
    return st;
}

static int key_index(const struct plan *plan, const char *key)
{
    for (int k = 0; k < plan->key_count; k++)
        if (!strcmp(plan->keys[k], key))
            return k;
    return -1;
}

static void give(const struct plan *plan, const struct plan_settings *settings,
                 struct plan_case *c)
{
    for (int n = 0; n < settings->count; n++)
        c->given[key_index(plan, settings->list[n].key)] = &settings->list[n];
}

long plan_case_count(const struct plan *plan)
{
    double count = plan->listed_count ? plan->listed_count : 1;

    for (int n = 0; n < plan->axis_count; n++)
        count *= plan->axes[n].values.count;
    return count > PLAN_MAX_CASES ? PLAN_MAX_CASES + 1 : (long)count;
}

enum status plan_case_given(const struct plan *plan, long number, struct plan_case *c)
{
    long rest = number;

    *c = (struct plan_case){.number = number};
    c->given = calloc((size_t)plan->key_count + 1, sizeof *c->given);
    if (!c->given)
        return STATUS_MEMORY;
    give(plan, &plan->settings, c);
    for (int n = plan->axis_count - 1; n >= 0; n--) { /* the last changes fastest */
        const struct plan_settings *values = &plan->axes[n].values;

        c->given[key_index(plan, plan->axes[n].key)] = &values->list[rest % values->count];
        rest /= values->count;
    }
    if (plan->listed_count) {
        c->name = plan->listed[rest].name;
        give(plan, &plan->listed[rest].settings, c);
    }
    return STATUS_OK;
}

enum status plan_case_open(const struct plan *plan, long number, struct plan_case *c,
                           struct message *why)
{
    enum status st;

    TRY(plan_case_given(plan, number, c));
    TRY(plan_case_blame(plan, c, build(plan, c, why), why));
out:
    if (st != STATUS_OK)
        plan_case_clear(c);
    return st;
}

void plan_case_clear(struct plan_case *c)
{
    for (int n = 0; n < c->setting_count; n++)
        free(c->settings[n]);
    free(c->settings);
    free(c->given);
    free(c->path);
    *c = (struct plan_case){0};
}
