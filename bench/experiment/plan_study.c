#include "bench/experiment/plan.h"

#include <ctype.h>
#include <math.h>
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
     .word = plan_settings_truth, IN(plan_level, phases)},
    {"paper_ms", "what somebody else's frame costs [ms]", SCHEMA_NUMBER, .low = 0,
     .high = 1e9, .open = true, IN(plan_level, paper_ms)},
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
    {"paper_ms", "what somebody else's frame costs [ms]", SCHEMA_NUMBER, .low = 0,
     .high = 1e9, .open = true, IN(plan_study, paper_ms)},
    {"paper_net", "somebody else's words for degree and net", SCHEMA_TEXT,
     IN(plan_study, paper_net)},
    {NULL}};
/* clang-format on */

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
    TRY(schema_read(plan_study_level_keys, node, "a level", level, why));
    if (!level->name)
        level->name = make_name(level->label);
    if (!level->name)
        TRY(STATUS_MEMORY);
out:
    return st;
}

enum status plan_study_read_levels(const struct schema_key *key,
                                   const struct yaml_tree *node, void *target,
                                   struct message *why)
{
    struct plan_study *study = (void *)((char *)target + key->offset);
    enum status st;

    study->levels = plan_settings_list(key, node, sizeof *study->levels,
                                       &study->level_count, read_level, &st, why);
    return st;
}

struct plan_study plan_study_none(void)
{
    return (struct plan_study){.time_count = -1, .truth = -1, .timed = -1, .paper_ms = NAN};
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

enum status plan_study_inherit(struct plan_study *study, const struct plan_study *base)
{
    if (!study->level_count) {
        study->level_count = base->level_count;
        study->levels = base->levels;
    }
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
        study->truth = base->truth > 0;
    if (study->timed < 0)
        study->timed = base->timed < 0 ? 0 : base->timed;
    if (!study->caption)
        study->caption = strdup(study->name);
    return study->caption ? STATUS_OK : STATUS_MEMORY;
}

static void clear_level(struct plan_level *level)
{
    free(level->label);
    free(level->name);
    plan_settings_clear(&level->settings);
    plan_settings_clear(&level->quick);
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
    plan_settings_clear(&study->settings);
    free(study->name);
    free(study->caption);
    free(study->paper_net);
    *study = (struct plan_study){0};
}
