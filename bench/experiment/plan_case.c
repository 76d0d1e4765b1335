#include "bench/experiment/plan.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/derived_key.h"
#include "models/reader/scene_file.h"

#define YOUNG "material.young" /* which derived keys set */

enum status plan_case_refuse(const struct plan *plan, int line, struct message *why,
                             const char *format, ...)
{
    const struct yaml_tree node = {.origin = plan->path, .line = line};
    struct message text;
    va_list words;

    va_start(words, format);
    vsnprintf(text.text, sizeof text.text, format, words);
    va_end(words);
    return yaml_tree_refuse(&node, why, "%s", text.text);
}

enum status plan_case_pass(const struct plan *plan, int line, enum status st,
                           const struct message *said, struct message *why)
{
    return st == STATUS_OK || st == STATUS_MEMORY
               ? st
               : plan_case_refuse(plan, line, why, "%s", said->text);
}

enum status plan_case_scene(const struct plan_case *c, struct scene *scene,
                            struct message *why)
{
    struct run run SCOPED(run_close) = {0};
    enum status st = run_read(&run, &c->run, why);

    *scene = run.scene;
    run.scene = (struct scene){0};
    return st;
}

static int key_index(const struct plan *plan, const char *key)
{
    for (int k = 0; k < plan->key_count; k++)
        if (!strcmp(plan->keys[k], key))
            return k;
    return -1;
}

/* Returns what the plan gives a case for a key; NULL: nothing. */
static const struct plan_setting *given(const struct plan *plan, const struct plan_case *c,
                                        const char *key)
{
    const int k = key_index(plan, key);

    return k < 0 ? NULL : c->given[k];
}

/* Sets the key behind a stand-in so that its number takes the value in this case. */
static enum status resolve(const struct plan *plan, const struct plan_setting *s,
                           struct plan_case *c, struct message *why)
{
    struct scene scene SCOPED(scene_clear) = {0};
    char *end;
    double want = strtod(s->value, &end), value;
    const struct plan_setting *also = given(plan, c, YOUNG);

    if (also)
        return plan_case_refuse(
            plan, also->line, why,
            YOUNG " is given here and also set by %s in line %d; leave one out", s->key,
            s->line);

    if (end == s->value || *end || !(want > 0 && isfinite(want)))
        return plan_case_refuse(plan, s->line, why,
                                "%.40s is '%.40s', but must be a number above 0", s->key,
                                s->value);
    CALL(plan_case_scene(c, &scene, why));
    value = derived_key_young(s->key, want, &scene);
    if (isnan(value))
        return plan_case_refuse(plan, s->line, why, "%.40s cannot be set in this scene%s",
                                s->key,
                                scene.is_fabric ? ": its material is a fabric" : "");
    settings_number(&c->run.settings, YOUNG, value);
    return STATUS_OK;
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

/* Finds the setting whose KEY=VALUE stands at the beginning of a text. */
static const struct plan_setting *find_blamed(const struct plan *plan,
                                              const struct plan_case *c, const char *text)
{
    for (int k = 0; k < plan->key_count; k++) {
        const struct plan_setting *s = c->given[k];
        if (!s)
            continue;
        const char *key = derived_key_is(s->key) ? YOUNG : s->key;
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
    const struct plan_setting *s = NULL;

    if ((st != STATUS_INPUT && st != STATUS_FILE) || !why ||
        !strncmp(why->text, plan->path, strlen(plan->path)))
        return st;
    const struct message old = *why;
    const char *text = old.text;
    if (!strncmp(text, mark, strlen(mark))) {
        text += strlen(mark);
        s = find_blamed(plan, c, text);
    }
    if (!s)
        s = given(plan, c, "scene"); /* the scene's file itself is wrong */
    return plan_case_refuse(plan, s ? s->line : 1, why, "%s", text);
}

/* Fills contestant, scene file and settings of a case whose `given` is there. */
static enum status build(const struct plan *plan, struct plan_case *c, struct message *why)
{
    const struct plan_setting *scene = given(plan, c, "scene"),
                              *model = given(plan, c, "model");
    struct message text;
    char *path = NULL;

    for (int k = 0; k < plan->key_count; k++) {
        const struct plan_setting *s = c->given[k];

        if (s && s != scene && s != model && !derived_key_is(s->key))
            settings_word(&c->run.settings, s->key, s->value);
    }
    if (!scene)
        return plan_case_refuse(plan, 1, why,
                                "the plan lacks the key 'scene', a name or a path");
    CALL(plan_case_pass(plan, model->line,
                        contestant_find(model->value, &c->run.contestant, &text), &text,
                        why));
    CALL(plan_case_pass(plan, scene->line,
                        plan_case_find_scene(plan, scene->value, &path, &text), &text,
                        why));
    c->run.path = arena_keep(&c->run.settings.arena, path);
    for (int k = 0; k < plan->key_count; k++)
        if (c->given[k] && derived_key_is(c->given[k]->key))
            CALL(resolve(plan, c->given[k], c, why));
    return STATUS_OK;
}

static void give(const struct plan *plan, const struct plan_settings *settings,
                 struct plan_case *c)
{
    for (int n = 0; n < settings->count; n++)
        c->given[key_index(plan, settings->list[n].key)] = &settings->list[n];
}

long plan_case_count(const struct plan *plan)
{
    long count = 0;

    for (int n = 0; n < plan->study_count; n++)
        count += plan->studies[n].level_count;
    return count;
}

/* Starts a case with what the plan gives it. */
static void begin(const struct plan *plan, const struct plan_study *study,
                  const struct plan_level *level, bool quick, struct plan_case *c)
{
    *c = (struct plan_case){.study = study, .level = level};
    c->given =
        arena_take(&c->run.settings.arena, (size_t)plan->key_count, sizeof *c->given);
    give(plan, &plan->settings, c);
    give(plan, &study->settings, c);
    for (int k = 0; level && k < (quick ? 2 : 1); k++)
        for (int n = 0; n < PLAN_STUDY_AXES && level->part[n]; n++)
            give(plan, k ? &level->part[n]->quick : &level->part[n]->settings, c);
}

const char *plan_case_words(const struct plan *plan, const struct plan_study *study,
                            const struct plan_level *level, const char *key)
{
    struct plan_case c SCOPED(plan_case_clear) = {0};

    begin(plan, study, level, false, &c);
    const struct plan_setting *s = given(plan, &c, key);
    return s ? s->value : NULL;
}

enum status plan_case_level(const struct plan *plan, const struct plan_study *study,
                            const struct plan_level *level, bool quick, struct plan_case *c,
                            struct message *why)
{
    begin(plan, study, level, quick, c);
    const enum status st = plan_case_blame(plan, c, build(plan, c, why), why);
    if (st != STATUS_OK)
        plan_case_clear(c);
    return st;
}

void plan_case_clear(struct plan_case *c)
{
    case_clear(&c->run);
    *c = (struct plan_case){0};
}
