#include "bench/experiment/plan.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define IN(type, member) .offset = offsetof(struct type, member)

/* clang-format off */
const struct schema_key plan_study_level_keys[] = {
    {"label", "in tables and pictures", SCHEMA_TEXT, .required = true, IN(plan_level, label)},
    {"name", "of its file (made of the label)", SCHEMA_TEXT, IN(plan_level, name)},
    {"size", "mesh width, step, ...: for observed orders", SCHEMA_NUMBER, .low = 0,
     .high = 1e30, .open = true, IN(plan_level, size)},
    {"model", "model or contestant", SCHEMA_SPECIAL, .read = plan_settings_read_word,
     IN(plan_level, settings), .want = "the name of a model"},
    {"settings", "what makes the level", SCHEMA_SPECIAL, .read = plan_settings_read_key,
     IN(plan_level, settings), .want = "a map {KEY: VALUE, ...}"},
    {"quick", "on top of them in a quick run", SCHEMA_SPECIAL, .read = plan_settings_read_key,
     IN(plan_level, quick), .want = "a map {KEY: VALUE, ...}"},
    {"phases", "time assembly, factorisation and solve of a frame, too", SCHEMA_WORD,
     .words = plan_settings_truth, IN(plan_level, phases)},
    {"paper_ms", "what somebody else's frame costs [ms]", SCHEMA_NUMBER, .low = 0,
     .high = 1e9, .open = true, IN(plan_level, paper_ms)},
    {"timed", "repeats of its milliseconds a frame (as the study has it)", SCHEMA_COUNT,
     .low = 0, .high = 1000, IN(plan_level, timed)},
    {NULL}};

const struct schema_key plan_study_keys[] = {
    {"name", "of its files", SCHEMA_TEXT, .required = true, IN(plan_study, name)},
    {"caption", "of its tables (the name)", SCHEMA_TEXT, IN(plan_study, caption)},
    {"scene", "instead of the plan's", SCHEMA_SPECIAL, .read = plan_settings_read_word,
     IN(plan_study, settings), .want = "the name or the path of a scene"},
    {"model", "instead of the plan's", SCHEMA_SPECIAL, .read = plan_settings_read_word,
     IN(plan_study, settings), .want = "the name of a model"},
    {"settings", "of its levels; the physics are the truth's, too", SCHEMA_SPECIAL,
     .read = plan_settings_read_key, IN(plan_study, settings),
     .want = "a map {KEY: VALUE, ...}"},
    PLAN_STUDY_KEYS(0),
    {NULL}};
/* clang-format on */

const char *const plan_study_truth[] = {"false", "true", "plate", NULL};

/* "10x10x2, p = 2": "10x10x2_p_2". */
static char *make_name(const char *label)
{
    char *name = strdup(label);
    size_t used = 0;

    for (const char *c = label; name && *c; c++)
        if (isalnum((unsigned char)*c))
            name[used++] = (char)tolower((unsigned char)*c);
        else if (used && name[used - 1] != '_')
            name[used++] = '_';
    if (name)
        name[used] = '\0';
    return name;
}

static enum status read_level(const struct yaml_tree *node, void *target,
                              struct message *why)
{
    struct plan_level *level = target;
    enum status st;

    level->line = node->line;
    level->paper_ms = NAN;
    level->timed = -1;
    TRY(schema_read(plan_study_level_keys, node, "a level", level, why));
    if (!level->name)
        level->name = make_name(level->label);
    if (!level->name)
        TRY(STATUS_MEMORY);
out:
    return st;
}

/* A map of axes. */
static enum status read_axes(const struct schema_key *key, const struct yaml_tree *node,
                             struct plan_study *study, struct message *why)
{
    enum status st = STATUS_OK;

    if (node->count < 1 || node->count > PLAN_STUDY_AXES)
        return schema_refuse(key, node, why);
    for (const struct yaml_tree *n = node->first; n; n = n->next) {
        struct plan_study_axis *axis = &study->axis[study->axis_count++];
        axis->name = strdup(n->key);
        TRY(axis->name ? STATUS_OK : STATUS_MEMORY);
        axis->levels = plan_settings_list(key, n, sizeof *axis->levels, &axis->count,
                                          read_level, &st, why);
        TRY(st);
    }
out:
    return st;
}

enum status plan_study_read_levels(const struct schema_key *key,
                                   const struct yaml_tree *node, void *target,
                                   struct message *why)
{
    struct plan_study *study = (void *)((char *)target + key->offset);
    enum status st;

    if (node->kind == YAML_TREE_MAP)
        return read_axes(key, node, study, why);
    study->levels = plan_settings_list(key, node, sizeof *study->levels,
                                       &study->level_count, read_level, &st, why);
    return st;
}

struct plan_study plan_study_none(void)
{
    return (struct plan_study){.time_count = -1, .truth = -1, .timed = -1};
}

enum status plan_study_read(const struct yaml_tree *node, void *target, struct message *why)
{
    struct plan_study *study = target;
    const struct yaml_tree *times;
    enum status st;

    *study = plan_study_none();
    study->line = node->line;
    TRY(schema_read(plan_study_keys, node, "a study", study, why));
    times = yaml_tree_find(node, "times");
    study->times_line = times ? times->line : 0;
out:
    return st;
}

static void clear_level(struct plan_level *level)
{
    free(level->label);
    free(level->name);
    plan_settings_clear(&level->settings);
    plan_settings_clear(&level->quick);
    *level = (struct plan_level){0};
}

/* Whether a level of a study is among these products. */
static bool is_among(const struct plan_product *product, const struct plan_study *study,
                     const struct plan_level *level)
{
    for (int axis = -1; axis < study->axis_count; axis++) {
        const char *name = axis < 0 ? "study" : study->axis[axis].name;
        const char *word = axis < 0 ? study->name : level->word[axis];
        bool named = false, met = false;
        for (int n = 0; n < product->labels.count; n++)
            if (!strcmp(product->labels.list[n].key, name)) {
                named = true;
                met |= !strcmp(product->labels.list[n].value, word);
            }
        if (named && !met)
            return false;
    }
    return true;
}

/* More of a text behind a comma, a blank, ...; false without memory. */
static bool append(char **text, const char *between, const char *more)
{
    const size_t used = *text ? strlen(*text) : 0;
    char *grown = realloc(*text, used + strlen(between) + strlen(more) + 1);

    if (!grown)
        return false;
    *text = grown;
    sprintf(grown + used, "%s%s", used ? between : "", more);
    return true;
}

static enum status add_settings(struct plan_settings *to, const struct plan_settings *from)
{
    enum status st = STATUS_OK;

    for (int n = 0; n < from->count && st == STATUS_OK; n++)
        st = plan_settings_add_text(to, from->list[n].key, from->list[n].value,
                                    from->list[n].line);
    return st;
}

/* The product of one level of each axis. */
static enum status multiply(const struct plan_study *study, int number,
                            struct plan_level *product)
{
    int stride = 1;
    enum status st = STATUS_OK;

    *product = (struct plan_level){.paper_ms = NAN, .timed = -1};
    for (int n = 0; n < study->axis_count; n++)
        stride *= study->axis[n].count;
    for (int n = 0; n < study->axis_count; n++) {
        const struct plan_study_axis *axis = &study->axis[n];
        stride /= axis->count;
        const struct plan_level *level = &axis->levels[number / stride % axis->count];
        TRY(append(&product->label, ", ", level->label) &&
                    append(&product->name, "_", level->name)
                ? STATUS_OK
                : STATUS_MEMORY);
        TRY(add_settings(&product->settings, &level->settings));
        TRY(add_settings(&product->quick, &level->quick));
        product->word[n] = level->label;
        product->line = level->line;
        product->size = level->size > 0 ? level->size : product->size;
        product->timed = level->timed >= 0 ? level->timed : product->timed;
        product->paper_ms = isnan(level->paper_ms) ? product->paper_ms : level->paper_ms;
        product->phases |= level->phases;
    }
out:
    return st;
}

/* Makes the levels of a study with axes. */
static enum status multiply_all(struct plan_study *study, const struct plan *plan,
                                struct message *why)
{
    const struct yaml_tree place = {.origin = plan->path, .line = study->line};
    double all = 1;
    enum status st = STATUS_OK;

    for (int n = 0; n < study->axis_count; n++)
        all *= study->axis[n].count;
    if (all > PLAN_STUDY_LEVELS)
        return yaml_tree_refuse(&place, why,
                                "the axes of the study %s have %.0f products, but a study "
                                "has at most %d levels",
                                study->name, all, PLAN_STUDY_LEVELS);
    study->levels = calloc((size_t)all, sizeof *study->levels);
    TRY(study->levels ? STATUS_OK : STATUS_MEMORY);
    for (int n = 0; n < (int)all; n++) {
        struct plan_level *level = &study->levels[study->level_count++];
        bool gone = false;
        TRY(multiply(study, n, level));
        for (int k = 0; k < plan->skip.count; k++)
            if (is_among(&plan->skip.list[k], study, level)) {
                level->slow |= plan->skip.list[k].quick;
                gone |= !plan->skip.list[k].quick;
            }
        for (int k = 0; k < plan->paper.count; k++)
            if (is_among(&plan->paper.list[k], study, level))
                level->paper_ms = plan->paper.list[k].paper_ms;
        if (gone)
            clear_level(&study->levels[--study->level_count]);
    }
out:
    return st;
}

enum status plan_study_inherit(struct plan_study *study, const struct plan *plan,
                               struct message *why)
{
    const struct plan_study *base = &plan->base;
    enum status st = STATUS_OK;

    if (!study->level_count && !study->axis_count) {
        study->level_count = base->level_count;
        study->levels = base->levels;
        study->axis_count = base->axis_count;
        memcpy(study->axis, base->axis, sizeof study->axis);
    }
    if (study->axis_count)
        TRY(multiply_all(study, plan, why));
    if (study->time_count < 0) {
        study->time_count = base->time_count < 0 ? 0 : base->time_count;
        study->times = base->times;
        study->times_line = base->times_line;
        if (!study->quick_count) {
            study->quick_count = base->quick_count;
            study->quick_times = base->quick_times;
        }
    }
    if (study->truth < 0)
        study->truth = base->truth < 0 ? PLAN_TRUTH_NONE : base->truth;
    if (study->timed < 0)
        study->timed = base->timed < 0 ? 0 : base->timed;
    if (!study->caption)
        study->caption = strdup(study->name);
    st = study->caption ? STATUS_OK : STATUS_MEMORY;
out:
    return st;
}

void plan_study_clear(struct plan_study *study, const struct plan_study *base)
{
    const bool own = study == base;

    for (int n = 0; (own || study->levels != base->levels) && n < study->level_count; n++)
        clear_level(&study->levels[n]);
    if (own || study->levels != base->levels)
        free(study->levels);
    if (own || study->times != base->times)
        free(study->times);
    if (own || study->quick_times != base->quick_times)
        free(study->quick_times);
    for (int n = 0; (own || study->axis->name != base->axis->name) && n < study->axis_count;
         n++) {
        for (int k = 0; k < study->axis[n].count; k++)
            clear_level(&study->axis[n].levels[k]);
        free(study->axis[n].levels);
        free(study->axis[n].name);
    }
    plan_settings_clear(&study->settings);
    free(study->name);
    free(study->caption);
    *study = (struct plan_study){0};
}
