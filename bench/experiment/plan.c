/* plan.c - a plan from YAML: one schema reads, refuses and documents. */
#include "bench/experiment/plan.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/output.h"
#include "bench/harness/derived_key.h"

#define IN(type, member) .offset = offsetof(struct type, member)
#define ANY              .low = -1e30, .high = 1e30

/* Defines the reader of a list into the members `list` and `count` of a `type` at
 * key->offset, whose elements `one` reads. */
#define LIST_READER(name, type, list, count, one)                                          \
    static enum status name(const struct schema_key *key, const struct yaml_tree *node,    \
                            void *target, struct message *why)                             \
    {                                                                                      \
        struct type *to = (void *)((char *)target + key->offset);                          \
        enum status st;                                                                    \
        to->list =                                                                         \
            plan_settings_list(key, node, sizeof *to->list, &to->count, one, &st, why);    \
        return st;                                                                         \
    }

/* --- Axes. */

static const char *const SCALES[] = {"linear", "log", NULL};

/* An axis as it is read. */
struct axis_reading {
    struct plan_axis axis;
    const struct yaml_tree *values; /* NULL: from ... to */
    double from, to;                /* NaN: not given */
    int count;
};

static enum status read_values(const struct schema_key *key, const struct yaml_tree *node,
                               void *target, struct message *why)
{
    struct axis_reading *r = target;

    if (node->kind != YAML_TREE_LIST || node->count < 1 || node->count > PLAN_AXIS_MOST)
        return schema_refuse(key, node, why);
    r->values = node;
    return STATUS_OK;
}

/* clang-format off */
static const struct schema_key AXIS[] = {
    {"key", "what changes", SCHEMA_TEXT, .required = true, IN(axis_reading, axis.key)},
    {"by", "the key that a stand-in sets", SCHEMA_TEXT, IN(axis_reading, axis.by)},
    {"values", "its values", SCHEMA_SPECIAL, .read = read_values,
     .want = "a list of 1 to 10000 values"},
    {"from", "first value", SCHEMA_NUMBER, ANY, IN(axis_reading, from)},
    {"to", "last value", SCHEMA_NUMBER, ANY, IN(axis_reading, to)},
    {"count", "values from first to last", SCHEMA_COUNT, .low = 2, .high = PLAN_AXIS_MOST,
     IN(axis_reading, count)},
    {"scale", "steps between them", SCHEMA_WORD, .words = SCALES,
     IN(axis_reading, axis.scale)},
    {NULL}};
/* clang-format on */

static enum status fill_range(struct axis_reading *r)
{
    enum status st = STATUS_OK;
    const bool log = r->axis.scale == PLAN_AXIS_LOG;

    for (int n = 0; n < r->count; n++) {
        const double share = (double)n / (r->count - 1);
        double value = log ? r->from * pow(r->to / r->from, share)
                           : r->from + (r->to - r->from) * share;
        char text[32];

        value = n == r->count - 1 ? r->to : value;
        snprintf(text, sizeof text, "%.*g", output_digits(value), value);
        TRY(plan_settings_add_text(&r->axis.values, r->axis.key, text, r->axis.line));
    }
out:
    return st;
}

/* The values of an axis that was read, from its list or its range. */
static enum status fill_axis(struct axis_reading *r, const struct yaml_tree *node,
                             struct message *why)
{
    enum status st = STATUS_OK;
    const bool range = !isnan(r->from) && !isnan(r->to) && r->count;
    const bool some = !isnan(r->from) || !isnan(r->to) || r->count;

    TRY(plan_settings_check_key(r->axis.key, node, why));
    if (r->values ? some : !range)
        return yaml_tree_refuse(node, why,
                                "the axis %s needs either values or all of from, to, count",
                                yaml_tree_quote(r->axis.key).text);
    if (r->axis.by && !derived_key_is(r->axis.key))
        return yaml_tree_refuse(node, why,
                                "the axis %s has 'by', but only gamma and "
                                "young_over_density are set by another key",
                                yaml_tree_quote(r->axis.key).text);
    if (!r->values && r->axis.scale == PLAN_AXIS_LOG && !(r->from > 0 && r->to > 0))
        return yaml_tree_refuse(node, why,
                                "the axis %s goes from %g to %g on a log scale, but both "
                                "must be above 0",
                                yaml_tree_quote(r->axis.key).text, r->from, r->to);
    if (!r->values)
        return fill_range(r);
    for (const struct yaml_tree *v = r->values->first; v; v = v->next)
        TRY(plan_settings_add(&r->axis.values, r->axis.key, v, why));
out:
    return st;
}

static enum status read_axis(const struct yaml_tree *node, void *axis, struct message *why)
{
    struct axis_reading r = {.axis.line = node->line, .from = NAN, .to = NAN};
    enum status st = schema_read(AXIS, node, "an axis", &r, why);

    if (st == STATUS_OK)
        st = fill_axis(&r, node, why);
    *(struct plan_axis *)axis = r.axis;
    return st;
}

static void clear_axis(struct plan_axis *axis)
{
    free(axis->key);
    free(axis->by);
    plan_settings_clear(&axis->values);
    *axis = (struct plan_axis){0};
}

/* --- Studies. */

static const char *const TRUTHS[] = {"false", "true", "plate", NULL};

/* clang-format off */
static const struct schema_key LEVEL[] = {
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
    level->timed = -1;
    TRY(schema_read(LEVEL, node, "a level", level, why));
    if (!level->name)
        level->name = make_name(level->label);
    if (!level->name)
        TRY(STATUS_MEMORY);
out:
    return st;
}

/* A map of axes. */
static enum status read_level_axes(const struct schema_key *key,
                                   const struct yaml_tree *node, struct plan_study *study,
                                   struct message *why)
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

LIST_READER(read_level_list, plan_study, levels, level_count, read_level)

static enum status read_levels(const struct schema_key *key, const struct yaml_tree *node,
                               void *target, struct message *why)
{
    return node->kind == YAML_TREE_MAP
               ? read_level_axes(key, node, (void *)((char *)target + key->offset), why)
               : read_level_list(key, node, target, why);
}

/* What plan and study may have, read into the struct plan_study that begins `at` bytes into
 * the target. */
/* clang-format off */
#define PLAN_STUDY_TIMES_AT(at, values, count)                                             \
    SCHEMA_NUMBERS, .low = 0, .high = 1e9, .open = true, .order = SCHEMA_INCREASING,       \
    .most = PLAN_STUDY_TIMES, .offset = (at) + offsetof(struct plan_study, values),        \
    .count_offset = (at) + offsetof(struct plan_study, count)
#define PLAN_STUDY_KEYS(at)                                                                \
    {"levels", "from coarse to fine; {AXIS: [...], AXIS: [...]}: all products",            \
     SCHEMA_SPECIAL, .keys = LEVEL, .read = read_levels,        \
     .low = 1, .most = PLAN_STUDY_LEVELS, .offset = (at),                                  \
     .want = "a list of 1 to 128 levels {label: ..., settings: {KEY: VALUE, ...}}, or a "  \
             "map of up to 4 axes with such a list each"},                                 \
    {"times", "at which sheets are compared [s]",                                          \
     PLAN_STUDY_TIMES_AT(at, times, time_count)},                                          \
    {"quick_times", "instead of them in a quick run [s]",                                  \
     PLAN_STUDY_TIMES_AT(at, quick_times, quick_count)},                                   \
    {"truth", "errors against the scene's truth; plate: Kirchhoff's, of linear theory",    \
     SCHEMA_WORD, .words = TRUTHS,                                                \
     .offset = (at) + offsetof(struct plan_study, truth)},                                 \
    {"timed", "repeats of the milliseconds a frame", SCHEMA_COUNT, .low = 0, .high = 1000, \
     .offset = (at) + offsetof(struct plan_study, timed)}
static const struct schema_key STUDY[] = {
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

/* The line of a key of a map; `otherwise`: it is not there. */
static int line_of(const struct yaml_tree *map, const char *key, int otherwise)
{
    const struct yaml_tree *node = yaml_tree_find(map, key);

    return node ? node->line : otherwise;
}

/* Nothing given yet. */
static struct plan_study no_study(void)
{
    return (struct plan_study){.time_count = -1, .truth = -1, .timed = -1};
}

static enum status read_study(const struct yaml_tree *node, void *target,
                              struct message *why)
{
    struct plan_study *study = target;
    enum status st;

    *study = no_study();
    study->line = node->line;
    TRY(schema_read(STUDY, node, "a study", study, why));
    study->times_line = line_of(node, "times", 0);
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

static enum status inherit(struct plan_study *study, const struct plan *plan,
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

static void clear_study(struct plan_study *study, const struct plan_study *base)
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

/* --- The plan. */

static const char *const KEEPS[] = {"none", "snapshots", NULL};

LIST_READER(read_axes, plan, axes, axis_count, read_axis)

static const struct schema_key CASE_NAME = {"name", .type = SCHEMA_TEXT};

/* A map of settings, one of whose keys may be the name. */
static enum status read_listed(const struct yaml_tree *node, void *target,
                               struct message *why)
{
    struct plan_listed *listed = target;
    enum status st = STATUS_OK;

    listed->line = node->line;
    if (node->kind != YAML_TREE_MAP)
        return yaml_tree_refuse(node, why, "a case is %s, but must be a map {KEY: VALUE}",
                                yaml_tree_describe(node).text);
    for (const struct yaml_tree *child = node->first; child; child = child->next)
        TRY(strcmp(child->key, CASE_NAME.key)
                ? plan_settings_add(&listed->settings, child->key, child, why)
                : schema_text(&CASE_NAME, child, &listed->name, why));
out:
    return st;
}

LIST_READER(read_cases, plan, listed, listed_count, read_listed)
LIST_READER(read_studies, plan, studies, study_count, read_study)

/* A label, or a list of them, on each axis of a map; of a product what is no axis, too. */
static enum status read_labels(const struct yaml_tree *node, struct plan_settings *labels,
                               struct plan_product *product, struct message *why)
{
    static const struct schema_key ms = {"paper_ms", .high = 1e9, .open = true};
    enum status st = STATUS_OK;

    if (node->kind != YAML_TREE_MAP)
        return yaml_tree_refuse(node, why, "%s, but a map {AXIS: LABEL} is wanted",
                                yaml_tree_describe(node).text);
    for (const struct yaml_tree *axis = node->first; axis; axis = axis->next) {
        const bool list = axis->kind == YAML_TREE_LIST;
        if (product && !strcmp(axis->key, "quick") && axis->text) {
            product->quick = !strcmp(axis->text, "true");
            if (!product->quick && strcmp(axis->text, "false"))
                return yaml_tree_refuse(axis, why, "quick is %s, but must be true or false",
                                        yaml_tree_describe(axis).text);
            continue;
        }
        if (product && !strcmp(axis->key, ms.key)) {
            TRY(schema_number(&ms, axis, &product->paper_ms, why));
            continue;
        }
        for (const struct yaml_tree *n = list ? axis->first : axis; n;
             n = list ? n->next : NULL) {
            if (!n->text)
                return yaml_tree_refuse(n, why, "%s is %s, but must be a label of the axis",
                                        axis->key, yaml_tree_describe(n).text);
            TRY(plan_settings_add_text(labels, axis->key, n->text, n->line));
        }
    }
out:
    return st;
}

static enum status read_product(const struct yaml_tree *node, void *target,
                                struct message *why)
{
    struct plan_product *product = target;

    return read_labels(node, &product->labels, product, why);
}

LIST_READER(read_products, plan_products, list, count, read_product)

static enum status read_chosen(const struct schema_key *key, const struct yaml_tree *node,
                               void *target, struct message *why)
{
    return read_labels(node, (void *)((char *)target + key->offset), NULL, why);
}

static enum status read_words(const struct schema_key *key, const struct yaml_tree *node,
                              void *target, struct message *why)
{
    struct plan_settings *words = (void *)((char *)target + key->offset);
    enum status st = STATUS_OK;

    if (node->kind != YAML_TREE_LIST || node->count < 1 || node->count > key->most)
        return schema_refuse(key, node, why);
    for (const struct yaml_tree *n = node->first; n && st == STATUS_OK; n = n->next)
        st = n->text ? plan_settings_add_text(words, n->text, "", n->line)
                     : schema_refuse(key, node, why);
    return st;
}

/* The text of a plan file as a tree; both are freed by the receiver. */
static enum status load(const char *path, char **text, struct yaml_tree **root,
                        struct message *why)
{
    enum status st;
    size_t size = 0;

    TRY(named_file_read(&plan_kind, path, text, &size, why));
    TRY(yaml_tree_parse(path, false, *text, size, root, why));
    (*text)[size] = '\0'; /* there is room: it was not too long to parse */
out:
    return st;
}

/* The rules that another plan has under the key. */
static enum status read_others(const char *name, const char *key,
                               struct verdict_rules *rules, struct message *why)
{
    enum status st;
    char *path = NULL, *text = NULL;
    struct yaml_tree *root = NULL, *list = NULL;

    TRY(named_file_find(&plan_kind, name, &path, why));
    TRY(load(path, &text, &root, why));
    if (root->kind == YAML_TREE_MAP)
        list = yaml_tree_find(root, key);
    if (!list)
        TRY(yaml_tree_refuse(root, why, "this plan has no %s", key));
    TRY(verdict_read(list, rules, why));
out:
    yaml_tree_free(root);
    free(text);
    free(path);
    return st;
}

/* A list of rules, or the plan that has it. */
static enum status read_verdicts(const struct schema_key *key, const struct yaml_tree *node,
                                 void *target, struct message *why)
{
    struct verdict_rules *rules = (void *)((char *)target + key->offset);
    struct message reason = {""};

    if (node->kind != YAML_TREE_SCALAR)
        return verdict_read(node, rules, why);
    const enum status st = read_others(node->text, key->key, rules, &reason);
    if (st == STATUS_OK || st == STATUS_MEMORY)
        return st;
    return yaml_tree_refuse(node, why, "%s: %s", key->key, reason.text);
}

static enum status read_measure(const struct schema_key *key, const struct yaml_tree *node,
                                void *target, struct message *why)
{
    int *measure = (void *)((char *)target + key->offset);

    for (int n = 0; n < MEASURES && node->kind == YAML_TREE_SCALAR; n++)
        if (!strcmp(node->text, measure_name(n))) {
            *measure = n;
            return STATUS_OK;
        }
    return schema_refuse(key, node, why);
}

/* clang-format off */
#define ONE_MEASURE SCHEMA_SPECIAL, .read = read_measure, .want = "the name of a measure"
static const struct schema_key FALLS[] = {
    {"measure", "what is to fall", ONE_MEASURE, .required = true, IN(plan, falls.measure)},
    {"along", "key of an axis, its values from coarse to fine", SCHEMA_TEXT,
     .required = true, IN(plan, falls.along)},
    {"by", "by which it may grow (not at all)", ONE_MEASURE, IN(plan, falls.by)},
    {NULL}};

static const struct schema_key MARK[] = {
    {"text", "on the point", SCHEMA_TEXT, .required = true, IN(plan_mark, text)},
    {"label", "in the legend", SCHEMA_TEXT, .required = true, IN(plan_mark, label)},
    {"at", "settings of its case", SCHEMA_SPECIAL, .required = true,
     .read = plan_settings_read_key, IN(plan_mark, settings), .want = "a map {KEY: VALUE, ...}"},
    {NULL}};

static enum status read_mark(const struct yaml_tree *node, void *target,
                             struct message *why)
{
    struct plan_mark *mark = target;

    mark->line = node->line;
    return schema_read(MARK, node, "a mark", mark, why);
}

LIST_READER(read_marks, plan_map, marks, mark_count, read_mark)

static const struct schema_key MAP[] = {
    {"x", "key or measure", SCHEMA_TEXT, .required = true, IN(plan, map.x)},
    {"y", "key or measure", SCHEMA_TEXT, .required = true, IN(plan, map.y)},
    {"panel", "key of a panel each, or name (of cases)", SCHEMA_TEXT, IN(plan, map.panel)},
    {"marks", "points that are no cases", SCHEMA_SPECIAL, .most = PLAN_MAX_LISTED,
     .read = read_marks, IN(plan, map),
     .want = "a list of {text: ..., label: ..., at: {KEY: VALUE}}"},
    {NULL}};

static const struct schema_key TABLE[] = {
    {"columns", "quantities, a column each", SCHEMA_SPECIAL, .required = true,
     .read = read_words, .most = PLAN_TABLE_COLUMNS, IN(plan, table.columns),
     .want = "a list of 1 to 16 quantities"},
    {"last", "people see the last time of each study alone", SCHEMA_WORD,
     .words = plan_settings_truth, IN(plan, table.last)},
    {"shown", "people see the levels with these labels alone", SCHEMA_SPECIAL,
     .read = read_chosen, IN(plan, table.shown), .want = "a map {AXIS: LABEL}"},
    {"pictures", "studies whose sheets are drawn", SCHEMA_SPECIAL, .read = read_words,
     .most = PLAN_TABLE_COLUMNS, IN(plan, table.pictures),
     .want = "a list of 1 to 16 names of studies"},
    {"note", "below the table", SCHEMA_TEXT, IN(plan, table.note)},
    {"file", "of its CSV and the chart (the plan's name)", SCHEMA_TEXT, IN(plan, table.file)},
    {NULL}};

#define AXES SCHEMA_SPECIAL, .read = read_words, .most = PLAN_STUDY_AXES, \
    .want = "a list of 1 to 4 axes"
static const struct schema_key CHART[] = {
    {"x", "a quantity, or what the size of the levels is", SCHEMA_TEXT, .required = true,
     IN(plan, chart.x)},
    {"y", "quantities, a line each", SCHEMA_SPECIAL, .required = true, IN(plan, chart.y),
     .read = read_words, .most = PLAN_TABLE_COLUMNS, .want = "a list of 1 to 16 quantities"},
    {"from", "how far the quantity is from this (itself)", SCHEMA_NUMBER, .low = -1e30,
     .high = 1e30, IN(plan, chart.from)},
    {"panel", "axes whose labels have a panel each", AXES, IN(plan, chart.panel)},
    {"line", "axes whose labels have a line each", AXES, .required = true,
     IN(plan, chart.line)},
    {NULL}};

static const struct schema_key PLAN[] = {
    {"name", "key in lists and of the results' folder", SCHEMA_TEXT, .required = true,
     IN(plan, name)},
    {"source", "what it is about", SCHEMA_TEXT, .required = true, IN(plan, source)},
    {"what", "a line for lists (the source)", SCHEMA_TEXT, IN(plan, what)},
    {"scene", "of all cases", SCHEMA_SPECIAL, .read = plan_settings_read_word,
     IN(plan, settings), .want = "the name or the path of a scene"},
    {"model", "of all cases: a model or a contestant", SCHEMA_SPECIAL,
     .read = plan_settings_read_word, IN(plan, settings), .want = "the name of a model"},
    {"settings", "of all cases", SCHEMA_SPECIAL, .read = plan_settings_read_key,
     IN(plan, settings), .want = "a map {KEY: VALUE, ...} of keys that --set takes"},
    {"axes", "every combination", SCHEMA_SPECIAL, .low = 1, .most = PLAN_MAX_AXES,
     .read = read_axes, .keys = AXIS,
     .want = "a list of 1 to 16 axes {key: ..., values: [...]}"},
    {"cases", "each with all combinations of the axes", SCHEMA_SPECIAL, .low = 1,
     .most = PLAN_MAX_LISTED, .read = read_cases,
     .want = "a list of 1 to 10000 maps {name: ..., KEY: VALUE, ...}"},
    {"look", "frames from one reading of the metrics to the next", SCHEMA_COUNT, .low = 1,
     .high = 1e6, IN(plan, look)},
    {"intersections", "count self-intersections", SCHEMA_WORD, .words = plan_settings_truth,
     IN(plan, intersections)},
    {"keep", "fields in the result files", SCHEMA_WORD, .words = KEEPS, IN(plan, keep)},
    {"time_limit", "of a case on the clock [s]", SCHEMA_NUMBER, .low = 0.001, .high = 1e9,
     IN(plan, time_limit)},
    {"verdicts", "when a case gets a label", SCHEMA_SPECIAL, .read = read_verdicts,
     IN(plan, verdicts),
     .want = "rules {label: ..., measure: ..., above or below: ..., why: ...}, or the plan "
             "that has them"},
    {"learnt", "a second opinion: bounds learnt from the paper's words",
     SCHEMA_SPECIAL, .read = read_verdicts, IN(plan, learnt),
     .want = "rules {label: ..., measure: ..., above or below: ..., why: ...}, or the plan "
             "that has them"},
    {"falls", "what is to fall along an axis; exit 1 where it grows", SCHEMA_SECTION,
     .keys = FALLS},
    {"map", "what the plot shows", SCHEMA_SECTION, .keys = MAP},
    PLAN_STUDY_KEYS(offsetof(struct plan, base)),
    {"studies", "each of these levels, times, ... unless it has its own", SCHEMA_SPECIAL,
     .read = read_studies, .low = 1, .most = PLAN_STUDY_MOST, .keys = STUDY,
     .want = "a list of 1 to 100 studies {name: ..., scene: ..., settings: {KEY: VALUE}}"},
    {"skip", "products of a study's axes that are not run; quick: true, by a quick run",
     SCHEMA_SPECIAL, .read = read_products, .low = 1, .most = PLAN_STUDY_MOST,
     IN(plan, skip), .want = "a list of maps {AXIS: LABEL, AXIS: [LABEL, LABEL]}"},
    {"paper", "milliseconds of somebody else's frame, of such products", SCHEMA_SPECIAL,
     .read = read_products, .low = 1, .most = PLAN_STUDY_MOST, IN(plan, paper),
     .want = "a list of maps {AXIS: LABEL, paper_ms: NUMBER}"},
    {"reference", "axis and label, or key and value, of what levels or cases are compared with",
     SCHEMA_SPECIAL, .read = read_chosen, IN(plan, reference), .want = "a map {AXIS: LABEL}"},
    {"table", "one table of all studies", SCHEMA_SECTION, .keys = TABLE},
    {"chart", "a point for each level", SCHEMA_SECTION, .keys = CHART},
    {NULL}};
/* clang-format on */

/* What the studies do not say themselves; a plan with levels alone is one study. */
static enum status settle_studies(struct plan *plan, const struct yaml_tree *root,
                                  struct message *why)
{
    enum status st = STATUS_OK;
    const struct yaml_tree *given = NULL;
    const bool alone =
        (plan->base.level_count || plan->base.axis_count) && !plan->study_count;

    for (const char *const *key = (const char *const[]){"times", "truth", "timed", "skip",
                                                        "paper", "table", "chart", NULL};
         *key && !given; key++)
        given = yaml_tree_find(root, *key);
    if (given && !alone && !plan->study_count)
        return yaml_tree_refuse(given, why, "%s is for studies, but the plan has no levels",
                                given->key);
    if (alone) {
        plan->studies = calloc(1, sizeof *plan->studies);
        TRY(plan->studies ? STATUS_OK : STATUS_MEMORY);
        plan->studies[plan->study_count++] = no_study();
        plan->studies->line = root->line;
        plan->studies->name = strdup(plan->name);
        plan->studies->caption = strdup(plan->source);
        TRY(plan->studies->name && plan->studies->caption ? STATUS_OK : STATUS_MEMORY);
    }
    for (int n = 0; n < plan->study_count; n++)
        TRY(inherit(&plan->studies[n], plan, why));
out:
    return st;
}

static enum status read_tree(const struct yaml_tree *root, struct plan *plan,
                             struct message *why)
{
    enum status st = STATUS_OK;

    TRY(schema_read(PLAN, root, "the plan", plan, why));
    if (strlen(plan->name) > 64 ||
        plan->name[strspn(plan->name, "abcdefghijklmnopqrstuvwxyz0123456789_-")])
        return yaml_tree_refuse(yaml_tree_find(root, "name"), why,
                                "name is %s, but must be 1 to 64 of the characters a-z, "
                                "0-9, _ and -",
                                yaml_tree_describe(yaml_tree_find(root, "name")).text);
    plan->map.line = line_of(root, "map", root->line);
    plan->falls.line = line_of(root, "falls", root->line);
    plan->base.times_line = line_of(root, "times", 0);
    TRY(settle_studies(plan, root, why));
out:
    return st;
}

enum status plan_parse(const char *path, struct plan *plan, struct message *why)
{
    enum status st = STATUS_OK;
    struct yaml_tree *root = NULL;

    *plan = (struct plan){.look = 10,
                          .time_limit = 600,
                          .falls = {.by = -1},
                          .chart.from = NAN,
                          .base = no_study()};
    if (why)
        why->text[0] = '\0';
    plan->path = strdup(path);
    TRY(plan->path ? STATUS_OK : STATUS_MEMORY);
    TRY(load(path, &plan->text, &root, why));
    TRY(read_tree(root, plan, why));
out:
    yaml_tree_free(root);
    if (st != STATUS_OK)
        plan_clear(plan);
    return st == STATUS_FILE ? STATUS_INPUT : st; /* what cannot be read is bad input */
}

void plan_keys(void (*line)(void *context, const char *key, const char *text),
               void *context)
{
    schema_list(PLAN, "", line, context);
}

/* What it is about; of `studies`, nothing if it is no study. */
static char *describe_of(const char *path, bool studies)
{
    struct plan plan;
    struct message why;
    char *text;

    if (plan_parse(path, &plan, &why) != STATUS_OK)
        return strdup(why.text);
    text = strdup(studies && !plan.study_count ? "" : plan.what ? plan.what : plan.source);
    plan_clear(&plan);
    return text;
}

static char *describe(const char *path)
{
    return describe_of(path, false);
}

static char *describe_study(const char *path)
{
    return describe_of(path, true);
}

#define PLAN_FOLDERS                                                                       \
    .ending = ".yaml", .environment = "CLOTHBENCH_PLANS",                                  \
    .from_program = PLANS_FROM_PROGRAM, .in_source = PLANS_IN_SOURCE

const struct named_file_kind plan_kind = {
    .what = "plan", .describe = describe, PLAN_FOLDERS};
const struct named_file_kind plan_study_kind = {
    .what = "study", .describe = describe_study, PLAN_FOLDERS};

static void clear_products(struct plan_products *products)
{
    for (int n = 0; n < products->count; n++)
        plan_settings_clear(&products->list[n].labels);
    free(products->list);
}

void plan_clear(struct plan *plan)
{
    for (int n = 0; n < plan->axis_count; n++)
        clear_axis(&plan->axes[n]);
    for (int n = 0; n < plan->listed_count; n++) {
        free(plan->listed[n].name);
        plan_settings_clear(&plan->listed[n].settings);
    }
    for (int n = 0; n < plan->map.mark_count; n++) {
        free(plan->map.marks[n].text);
        free(plan->map.marks[n].label);
        plan_settings_clear(&plan->map.marks[n].settings);
    }
    for (int n = 0; n < plan->study_count; n++)
        clear_study(&plan->studies[n], &plan->base);
    clear_study(&plan->base, &plan->base);
    clear_products(&plan->skip);
    clear_products(&plan->paper);
    struct plan_settings *const settings[] = {
        &plan->settings,       &plan->reference,   &plan->table.columns, &plan->table.shown,
        &plan->table.pictures, &plan->chart.panel, &plan->chart.line,    &plan->chart.y};
    for (size_t n = 0; n < sizeof settings / sizeof *settings; n++)
        plan_settings_clear(settings[n]);
    void *const owned[] = {
        plan->table.note, plan->table.file, plan->chart.x,     plan->studies, plan->axes,
        plan->listed,     plan->map.marks,  plan->falls.along, plan->map.x,   plan->map.y,
        plan->map.panel,  plan->keys,       plan->path,        plan->text,    plan->name,
        plan->source,     plan->what};
    for (size_t n = 0; n < sizeof owned / sizeof *owned; n++)
        free(owned[n]);
    verdict_clear(&plan->verdicts);
    verdict_clear(&plan->learnt);
    *plan = (struct plan){0};
}
