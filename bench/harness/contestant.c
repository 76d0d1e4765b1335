#include "bench/harness/contestant.h"

#include <stdio.h>
#include <string.h>

#include "models/reader/near.h"
#include "models/reader/scene_file.h"

const struct model *contestant_model(int n)
{
    for (const struct contestant *c = contestant_table; c->name; c++)
        if (!strcmp(c->name, c->model->name) && n-- == 0)
            return c->model;
    return NULL;
}

/* Writes the models' names into text[size], as "a, b". */
static void list_models(char *text, size_t size)
{
    const struct model *model;

    *text = '\0';
    for (int n = 0; (model = contestant_model(n)); n++)
        status_join(text, size, ", ", "%s", model->name);
}

static bool is(const char *word, size_t length, const char *name)
{
    return strlen(name) == length && !strncmp(word, name, length);
}

/* The letters of an unknown name that its error sentence repeats. */
enum { LONGEST = 80 };

/* Finds a contestant by a name of `length` letters. */
static enum status find(const char *name, size_t length, const struct contestant **found,
                        struct message *why)
{
    char models[256], word[LONGEST + 1], meant[80];

    snprintf(word, sizeof word, "%.*s", length < LONGEST ? (int)length : LONGEST, name);
    struct near near = near_start(word);
    for (const struct contestant *c = contestant_table; c->name; c++) {
        if (is(name, length, c->name)) {
            *found = c;
            return STATUS_OK;
        }
        near_try(&near, c->name);
    }
    if (near.best)
        return status_fail(why, STATUS_INPUT, "there is no model or contestant '%s'%s",
                           word, near_text(&near, meant));
    list_models(models, sizeof models);
    return status_fail(why, STATUS_INPUT,
                       "there is no model or contestant '%s'; models: %s; contestants: "
                       "clothbench list contestants",
                       word, models);
}

enum status contestant_find(const char *name, const struct contestant **found,
                            struct message *why)
{
    return find(name, strlen(name), found, why);
}

static bool is_all(const char *choice)
{
    return !choice || !strcmp(choice, "all");
}

static bool has_entered(const struct model *model, unsigned where)
{
    for (const struct contestant *c = contestant_table; c->name; c++)
        if (c->model == model && c->enters & where)
            return true;
    return false;
}

bool contestant_chosen(const struct contestant *c, const char *choice, unsigned where)
{
    const bool enters = !where || c->enters & where;
    size_t length;

    if (is_all(choice))
        return enters;
    for (const char *at = choice; *at; at += length + (at[length] == ',')) {
        length = strcspn(at, ",");
        const bool model = is(at, length, c->model->name);
        if (model ? enters : is(at, length, c->name))
            return true;
        if (model && is(at, length, c->name) && !has_entered(c->model, where))
            return true;
    }
    return false;
}

enum status contestant_check(const char *choice, struct message *why)
{
    const struct contestant *unused;
    enum status st = STATUS_OK;
    size_t length;

    if (is_all(choice))
        return STATUS_OK;
    if (!*choice)
        return status_fail(why, STATUS_INPUT, "no model is named");
    for (const char *at = choice; *at && !st; at += length + (at[length] == ',')) {
        length = strcspn(at, ",");
        st = find(at, length, &unused, why);
    }
    return st;
}

void contestant_settings(const struct contestant *c, struct settings *s)
{
    settings_list(s, CONTESTANT_SETTINGS, c->settings);
}

void contestant_tell_model(const struct model *model, char text[CONTESTANT_TEXT])
{
    char not_served[SCENE_NEEDS_TEXT];

    scene_needs_text(SCENE_NEED_ALL & ~model->serves, not_served, sizeof not_served);
    snprintf(text, CONTESTANT_TEXT, "%s; serves %s%s (%s)", model->title,
             *not_served ? "all but " : "every scene", not_served, model->source);
}

void contestant_tell(const struct contestant *c, char text[CONTESTANT_TEXT])
{
    static const struct {
        unsigned where;
        const char *name;
    } places[] = {{CONTESTANT_COMPARE, "compare"},
                  {CONTESTANT_STRESS, "stress"},
                  {CONTESTANT_SMALL, "verify at small strains"},
                  {CONTESTANT_LARGE, "verify bending far"},
                  {CONTESTANT_SPEED, "bench"}};
    int used = snprintf(text, CONTESTANT_TEXT, "%s", c->title);

    for (size_t n = 0; n < sizeof places / sizeof *places; n++)
        if (c->enters & places[n].where)
            used += snprintf(text + used, CONTESTANT_TEXT - (size_t)used, "; %s",
                             places[n].name);
    if (c->note)
        snprintf(text + used, CONTESTANT_TEXT - (size_t)used, ". %s", c->note);
}

const char *contestant_setting(const struct contestant *c, const char *key)
{
    int count = 0;

    while (count < CONTESTANT_SETTINGS && c->settings[count])
        count++;
    return settings_value(&(struct settings){count, (char **)c->settings}, key);
}

bool contestant_is_paper_scheme(const struct contestant *c)
{
    const char *kinematics = contestant_setting(c, "discretization.kinematics");

    return kinematics && !strcmp(kinematics, option_kinematics[KINEMATICS_PRINTED]);
}

void contestant_points(const struct contestant *c, int u, int v, struct settings *s)
{
    const int points[] = {u, v, c->layers};

    settings_integers(s, "discretization.points", c->layers ? 3 : 2, points);
}

int contestant_least(const struct contestant *c)
{
    return c->degree + 1;
}

enum status contestant_read_settings(const struct settings *s, const char *path,
                                     struct scene *scene, struct discretization *d,
                                     struct message *why)
{
    d->others = contestant_model;
    const enum status st =
        scene_file_read(path, s->count, (const char *const *)s->text, scene, d, why);
    return st == STATUS_FILE ? STATUS_INPUT : st; /* a scene that cannot be read is input */
}

enum status contestant_read_scene(const struct settings *s, const char *path,
                                  struct scene *scene, struct message *why)
{
    struct discretization unused SCOPED(discretization_clear) = {0};
    const enum status st = contestant_read_settings(s, path, scene, &unused, why);

    return st;
}
