/* plan.c - a plan from YAML: one schema reads, refuses and documents; then what the studies
 * have of the plan and the products of their axes; then checks of all that a run needs. */
#define _GNU_SOURCE /* open_memstream */
#include "bench/experiment/plan.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/output.h"
#include "bench/harness/derived_key.h"
#include "bench/harness/measures.h"

SCOPE_OF(yaml_tree_free, struct yaml_tree)

/* All that a plan has lies in its arena. What a schema fills begins with the pointer to it.
 */
#define ARENA_OF(target) (*(struct arena **)(target))

#define IN(type, member) .offset = offsetof(struct type, member)
#define ANY              .low = -1e30, .high = 1e30

/* --- settings ----------------------------------------------------------------------------
 */

static void write_scalar(const char *scalar, bool quoted, FILE *text)
{
    if (quoted)
        fputc('\'', text);
    for (const char *c = scalar; *c; c++)
        fprintf(text, quoted && *c == '\'' ? "''" : "%c", *c);
    if (quoted)
        fputc('\'', text);
}

/* Writes a node in one line, as it could stand in a plan. */
static void write_flow(const struct yaml_tree *node, FILE *text)
{
    const bool list = node->kind == YAML_TREE_LIST;

    if (node->kind == YAML_TREE_SCALAR) {
        write_scalar(node->text, node->quoted, text);
        return;
    }
    fputc(list ? '[' : '{', text);
    for (const struct yaml_tree *child = node->first; child; child = child->next) {
        if (!list)
            fprintf(text, "%s: ", child->key);
        write_flow(child, text);
        if (child->next)
            fputs(list ? "," : ", ", text);
    }
    fputc(list ? ']' : '}', text);
}

static void add_text(struct arena *a, struct plan_settings *settings, const char *key,
                     const char *value, int line)
{
    settings->list =
        arena_more(a, settings->list, (size_t)settings->count, sizeof *settings->list);
    settings->list[settings->count++] =
        (struct plan_setting){arena_print(a, "%s", key), arena_print(a, "%s", value), line};
}

/* Refuses a key that --set KEY=VALUE would read otherwise. */
static enum status check_key(const char *key, const struct yaml_tree *node,
                             struct message *why)
{
    return *key && !key[strcspn(key, "=\r\n")]
               ? STATUS_OK
               : yaml_tree_refuse(node, why, "%s is no key that --set could take",
                                  yaml_tree_quote(key).text);
}

/* Returns whether the value of a key is looked up as it is; others are YAML, as --set takes
 * it. */
static bool is_name(const char *key)
{
    return !strcmp(key, "scene") || !strcmp(key, "model");
}

/* Adds a key with the value that `node` has. */
static enum status add_value(struct arena *a, struct plan_settings *settings,
                             const char *key, const struct yaml_tree *node,
                             struct message *why)
{
    enum status st = STATUS_OK;
    char *value SCOPED(scope_free) = NULL;
    size_t size;
    FILE *text;

    CALL(check_key(key, node, why));
    text = open_memstream(&value, &size);
    if (!text)
        arena_end();
    if (node->kind == YAML_TREE_SCALAR && is_name(key))
        write_scalar(node->text, false, text);
    else
        write_flow(node, text);
    if (fclose(text) != 0)
        arena_end();
    if (!size || strpbrk(value, "\r\n"))
        st = yaml_tree_refuse(node, why, "%s is %s, but must be a value in one line",
                              yaml_tree_quote(key).text, yaml_tree_describe(node).text);
    else
        add_text(a, settings, key, value, node->line);
    return st;
}

/* Hands over to the arena what the schema has allocated of a key. */
static void keep(const struct schema_key *key, void *target)
{
    void **owned = (void *)((char *)target + key->offset);

    for (const struct schema_key *k = key->keys; key->type == SCHEMA_SECTION && k->key; k++)
        keep(k, target);
    if ((key->type == SCHEMA_TEXT || key->type == SCHEMA_NUMBERS) && *owned)
        arena_keep(ARENA_OF(target), *owned);
}

static enum status read_value(const struct schema_key *key, const struct yaml_tree *node,
                              void *target, struct message *why)
{
    const enum status st = schema_value(key, node, target, why);

    keep(key, target);
    return st;
}

static enum status read_table(const struct schema_key *keys, const struct yaml_tree *node,
                              const char *what, void *target, struct message *why)
{
    const enum status st = schema_read(keys, node, what, target, why);

    for (; keys->key; keys++)
        keep(keys, target);
    return st;
}

/* Returns the key of a table; NULL: it has none of this name. */
static const struct schema_key *find_key(const struct schema_key *keys, const char *name)
{
    while (keys->key && strcmp(keys->key, name))
        keys++;
    return keys->key ? keys : NULL;
}

/* Reads a map some of whose keys are in the table, into *target, and the others settings.
 */
static enum status read_mixed(const struct schema_key *keys, const struct yaml_tree *node,
                              const char *what, void *target,
                              struct plan_settings *settings, struct message *why)
{
    if (node->kind != YAML_TREE_MAP)
        return yaml_tree_refuse(node, why, "%s is %s, but must be a map {KEY: VALUE, ...}",
                                what, yaml_tree_describe(node).text);
    for (const struct yaml_tree *child = node->first; child; child = child->next) {
        const struct schema_key *key = find_key(keys, child->key);
        CALL(key ? read_value(key, child, target, why)
                 : add_value(ARENA_OF(target), settings, child->key, child, why));
    }
    return STATUS_OK;
}

/* Reads {KEY: VALUE, ...} into the struct plan_settings at key->offset. */
static enum status read_map(const struct schema_key *key, const struct yaml_tree *node,
                            void *target, struct message *why)
{
    return read_mixed(&(struct schema_key){NULL}, node, key->key, target,
                      (void *)((char *)target + key->offset), why);
}

/* Adds the key itself with its value, a word. */
static enum status read_name(const struct schema_key *key, const struct yaml_tree *node,
                             void *target, struct message *why)
{
    if (node->kind != YAML_TREE_SCALAR || !*node->text)
        return schema_refuse(key, node, why);
    return add_value(ARENA_OF(target), (void *)((char *)target + key->offset), key->key,
                     node, why);
}

/* Reads a list of key->low to key->most things of so many bytes, all-zero before but for
 * the arena; *count has what was begun. *st says why it is not whole. */
static void *read_list(const struct schema_key *key, const struct yaml_tree *node,
                       struct arena *arena, size_t size, int *count,
                       enum status read(const struct yaml_tree *node, void *element,
                                        struct message *why),
                       enum status *st, struct message *why)
{
    char *list = arena_take(arena, (size_t)node->count + 1, size);

    *st = node->kind != YAML_TREE_LIST || node->count < key->low || node->count > key->most
              ? schema_refuse(key, node, why)
              : STATUS_OK;
    for (const struct yaml_tree *n = node->first; n && *st == STATUS_OK; n = n->next) {
        void *element = list + size * (size_t)(*count)++;
        ARENA_OF(element) = arena;
        *st = read(n, element, why);
    }
    return list;
}

const struct plan_setting *plan_settings_find(const struct plan_settings *settings,
                                              const char *key)
{
    for (int n = 0; n < settings->count; n++)
        if (!strcmp(settings->list[n].key, key))
            return &settings->list[n];
    return NULL;
}

/* Defines the reader of a list into the members `list` and `count` of a `type` at
 * key->offset, whose elements `one` reads. */
#define LIST_READER(name, type, list, count, one)                                          \
    static enum status name(const struct schema_key *key, const struct yaml_tree *node,    \
                            void *target, struct message *why)                             \
    {                                                                                      \
        struct type *to = (void *)((char *)target + key->offset);                          \
        enum status st;                                                                    \
        to->list = read_list(key, node, ARENA_OF(target), sizeof *to->list, &to->count,    \
                             one, &st, why);                                               \
        return st;                                                                         \
    }
#define WITH_MAP   SCHEMA_SPECIAL, .read = read_map, .want = "a map {KEY: VALUE, ...}"
#define WITH_MODEL SCHEMA_SPECIAL, .read = read_name, .want = "the name of a model"
#define WITH_SCENE                                                                         \
    SCHEMA_SPECIAL, .read = read_name, .want = "the name or the path of a scene"

static const char *const NO_OR_YES[] = {"false", "true", NULL};

/* --- axes --------------------------------------------------------------------------------
 */

static const char *const TRUTHS[] = {"false", "true", "plate", NULL};
static const char *const SCALES[] = {"linear", "log", NULL};

/* clang-format off */
static const struct schema_key LEVEL[] = {
    {"name", "name of its file (made from the label)", SCHEMA_TEXT, IN(plan_level, name)},
    {"size", "mesh width, step, ..., for observed orders", SCHEMA_NUMBER, .low = 0,
     .high = 1e30, .open = true, IN(plan_level, size)},
    {"quick", "further settings in a quick run", WITH_MAP, IN(plan_level, quick)},
    {"phases", "also time assembly, factorisation and solve of a frame", SCHEMA_WORD,
     .words = NO_OR_YES, IN(plan_level, phases)},
    {"paper_ms", "time of a frame in the paper [ms]", SCHEMA_NUMBER, .low = 0,
     .high = 1e9, .open = true, IN(plan_level, paper_ms)},
    {"timed", "repeats of the timing of a frame (the study's)", SCHEMA_COUNT,
     .low = 0, .high = 1000, IN(plan_level, timed)},
    {NULL}};

/* Values from ... to. */
struct range {
    double from, to;
    int count, scale;
};
static const struct schema_key RANGE[] = {
    {"from", "first value", SCHEMA_NUMBER, ANY, .required = true, IN(range, from)},
    {"to", "last value", SCHEMA_NUMBER, ANY, .required = true, IN(range, to)},
    {"count", "number of values", SCHEMA_COUNT, .low = 2, .high = PLAN_AXIS_MOST,
     .required = true, IN(range, count)},
    {"scale", "spacing of the values", SCHEMA_WORD, .words = SCALES, IN(range, scale)},
    {NULL}};

/* `help plan` lists these keys of an axis. */
static const struct schema_key AXIS_KEYS[] = {
    {"LABEL", "a value of the axis: what it sets, {KEY: VALUE}, and", SCHEMA_SECTION,
     .keys = LEVEL},
    {"KEY", "of an axis that is a key: its values [VALUE, ...], or", SCHEMA_SECTION,
     .keys = RANGE},
    {NULL}};
/* clang-format on */

/* Makes a name of a label: "10x10x2, p = 2" becomes "10x10x2_p_2". */
static char *make_name(struct arena *a, const char *label)
{
    char *name = arena_print(a, "%s", label);
    size_t used = 0;

    for (const char *c = label; *c; c++)
        if (isalnum((unsigned char)*c))
            name[used++] = (char)tolower((unsigned char)*c);
        else if (used && name[used - 1] != '_')
            name[used++] = '_';
    name[used] = '\0';
    return name;
}

/* Adds a level to an axis. */
static struct plan_level *add_level(struct arena *a, struct plan_axis *axis,
                                    const char *label, int line)
{
    axis->levels = arena_more(a, axis->levels, (size_t)axis->count, sizeof *axis->levels);
    struct plan_level *level = &axis->levels[axis->count++];

    *level = (struct plan_level){a, .label = arena_print(a, "%s", label), .paper_ms = NAN,
                                 .timed = -1, .line = line};
    return level;
}

/* Adds the values of a map {from: ..., to: ..., count: ...}. */
static enum status fill_range(struct arena *a, struct plan_axis *axis,
                              const struct yaml_tree *node, struct message *why)
{
    struct range r = {.scale = 0};

    CALL(schema_read(RANGE, node, "an axis", &r, why));
    if (r.scale && !(r.from > 0 && r.to > 0))
        return yaml_tree_refuse(node, why,
                                "the axis %s goes from %g to %g on a log scale, but both "
                                "must be above 0",
                                yaml_tree_quote(axis->name).text, r.from, r.to);
    for (int n = 0; n < r.count; n++) {
        const double share = (double)n / (r.count - 1);
        double value =
            r.scale ? r.from * pow(r.to / r.from, share) : r.from + (r.to - r.from) * share;
        char text[32];

        value = n == r.count - 1 ? r.to : value;
        snprintf(text, sizeof text, "%.*g", output_digits(value), value);
        add_text(a, &add_level(a, axis, text, axis->line)->settings, axis->name, text,
                 axis->line);
    }
    return STATUS_OK;
}

/* Adds listed values of the key that the axis is called by. */
static enum status fill_values(struct arena *a, struct plan_axis *axis,
                               const struct yaml_tree *values, struct message *why)
{
    for (const struct yaml_tree *v = values->first; v; v = v->next) {
        struct plan_level *level = add_level(a, axis, "", v->line);
        CALL(add_value(a, &level->settings, axis->name, v, why));
        level->label =
            arena_print(a, "%s", v->text ? v->text : level->settings.list->value);
    }
    return STATUS_OK;
}

static enum status fill_labels(struct arena *a, struct plan_axis *axis,
                               const struct yaml_tree *node, struct message *why)
{
    static const struct schema_key label = {"a label", .type = SCHEMA_TEXT};

    for (const struct yaml_tree *v = node->first; v; v = v->next) {
        struct plan_level *level = add_level(a, axis, v->key, v->line);
        const struct yaml_tree text = {
            .kind = YAML_TREE_SCALAR, .text = v->key, .origin = v->origin, .line = v->line};
        char *good = NULL;
        CALL(schema_text(&label, &text, &good, why));
        free(good);
        CALL(read_mixed(LEVEL, v, v->key, level, &level->settings, why));
    }
    return STATUS_OK;
}

/* Reads an axis: [VALUE, ...] or a range of the key that it is called by, or
 * {LABEL: {KEY: VALUE}}. */
static enum status read_axis(struct arena *a, const struct yaml_tree *node,
                             struct plan_axis *axis, struct message *why)
{
    const bool list = node->kind == YAML_TREE_LIST;
    enum status st = STATUS_OK;

    axis->line = node->line;
    axis->name = arena_print(a, "%s", node->key);
    CALL(check_key(axis->name, node, why));
    if (node->kind == YAML_TREE_SCALAR || !node->count || node->count > PLAN_AXIS_MOST)
        return yaml_tree_refuse(node, why,
                                "the axis %s is %s, but must be a list of values, a map "
                                "{from: ..., to: ..., count: ...} or {LABEL: {KEY: VALUE}}",
                                yaml_tree_quote(axis->name).text,
                                yaml_tree_describe(node).text);
    st = list                           ? fill_values(a, axis, node, why)
         : yaml_tree_find(node, "from") ? fill_range(a, axis, node, why)
                                        : fill_labels(a, axis, node, why);
    for (int n = 0; n < axis->count; n++)
        if (!axis->levels[n].name)
            axis->levels[n].name = make_name(a, axis->levels[n].label);
    return st;
}

static enum status read_axes(const struct schema_key *key, const struct yaml_tree *node,
                             void *target, struct message *why)
{
    struct plan_study *study = (void *)((char *)target + key->offset);

    if (node->kind != YAML_TREE_MAP || node->count < 1 || node->count > PLAN_STUDY_AXES)
        return schema_refuse(key, node, why);
    for (const struct yaml_tree *n = node->first; n; n = n->next)
        if (n->count) /* else it takes the plan's away */
            CALL(read_axis(ARENA_OF(target), n, &study->axis[study->axis_count++], why));
    return STATUS_OK;
}

/* --- studies -----------------------------------------------------------------------------
 */

/* The keys that both plan and study may have, read into the struct plan_study that begins
 * `at` bytes into the target. */
/* clang-format off */
#define TIMES_AT(at, values, count)                                                        \
    SCHEMA_NUMBERS, .low = 0, .high = 1e9, .open = true, .order = SCHEMA_INCREASING,       \
    .most = PLAN_STUDY_TIMES, .offset = (at) + offsetof(struct plan_study, values),        \
    .count_offset = (at) + offsetof(struct plan_study, count)
#define SHARED_KEYS(at)                                                                    \
    {"axes", "every combination is a case", SCHEMA_SPECIAL, .keys = AXIS_KEYS,             \
     .read = read_axes, .offset = (at),                                                    \
     .want = "a map of 1 to 8 axes {AXIS: [VALUE, ...]} or {AXIS: {LABEL: {KEY: VALUE}}}"}, \
    {"times", "times at which sheets are compared [s]; []: at rest; none: a sweep",        \
     TIMES_AT(at, times, time_count)},                                                     \
    {"quick_times", "times in a quick run [s]",                                  \
     TIMES_AT(at, quick_times, quick_count)},                                              \
    {"truth", "errors against the scene's truth; plate: against linear Kirchhoff plate theory",    \
     SCHEMA_WORD, .words = TRUTHS, .offset = (at) + offsetof(struct plan_study, truth)},   \
    {"timed", "repeats of the timing of a frame", SCHEMA_COUNT, .low = 0, .high = 1000, \
     .offset = (at) + offsetof(struct plan_study, timed)}
static const struct schema_key SHARED[] = {SHARED_KEYS(0), {NULL}};
static const struct schema_key STUDY[] = {
    {"caption", "caption of its tables (the name)", SCHEMA_TEXT, IN(plan_study, caption)},
    SHARED_KEYS(0),
    {NULL}};
/* clang-format on */

/* --- the plan ----------------------------------------------------------------------------
 */

/* A plan as it is read, and what its studies have unless they say otherwise. */
struct reading {
    struct plan plan; /* first: readers take the one for the other */
    struct plan_study base;
    struct plan_statement open; /* readings of statements without their own */
};

static const char *const KEEPS[] = {"none", "snapshots", NULL};

/* Reads {NAME: {KEY: VALUE, ...}, ...}. */
static enum status read_studies(const struct schema_key *key, const struct yaml_tree *node,
                                void *target, struct message *why)
{
    struct plan *plan = target;

    if (node->kind != YAML_TREE_MAP || node->count < 1)
        return schema_refuse(key, node, why);
    plan->studies = arena_take(plan->arena, (size_t)node->count, sizeof *plan->studies);
    for (const struct yaml_tree *n = node->first; n; n = n->next) {
        struct plan_study *study = &plan->studies[plan->study_count++];
        *study =
            (struct plan_study){plan->arena, .name = arena_print(plan->arena, "%s", n->key),
                                .line = n->line, .time_count = -1};
        CALL(read_mixed(STUDY, n, n->key, study, &study->settings, why));
    }
    return STATUS_OK;
}

/* Reads a label, or a list of them, on each axis of a map; and into *target what is in the
 * table and no axis. */
static enum status read_labels(const struct schema_key *keys, const struct yaml_tree *node,
                               void *target, struct plan_settings *labels,
                               struct message *why)
{
    if (node->kind != YAML_TREE_MAP)
        return yaml_tree_refuse(node, why, "%s, but a map {AXIS: LABEL} is wanted",
                                yaml_tree_describe(node).text);
    for (const struct yaml_tree *axis = node->first; axis; axis = axis->next) {
        const bool list = axis->kind == YAML_TREE_LIST;
        const struct schema_key *key = find_key(keys, axis->key);
        if (key)
            CALL(read_value(key, axis, target, why));
        for (const struct yaml_tree *n = list ? axis->first : axis; n && !key;
             n = list ? n->next : NULL) {
            if (!n->text)
                return yaml_tree_refuse(n, why, "%s is %s, but must be a label of the axis",
                                        axis->key, yaml_tree_describe(n).text);
            add_text(ARENA_OF(target), labels, axis->key, n->text, n->line);
        }
    }
    return STATUS_OK;
}

static const struct schema_key NONE[] = {{NULL}};
static const struct schema_key PRODUCT[] = {
    {"quick", .type = SCHEMA_WORD, .words = NO_OR_YES, IN(plan_product, quick)},
    {"paper_ms", .type = SCHEMA_NUMBER, .high = 1e9, .open = true,
     IN(plan_product, paper_ms)},
    {NULL}};

static enum status read_product(const struct yaml_tree *node, void *target,
                                struct message *why)
{
    struct plan_product *product = target;

    return read_labels(PRODUCT, node, product, &product->labels, why);
}

LIST_READER(read_products, plan_products, list, count, read_product)

static enum status read_chosen(const struct schema_key *key, const struct yaml_tree *node,
                               void *target, struct message *why)
{
    return read_labels(NONE, node, target, (void *)((char *)target + key->offset), why);
}

static enum status read_words(const struct schema_key *key, const struct yaml_tree *node,
                              void *target, struct message *why)
{
    struct plan_settings *words = (void *)((char *)target + key->offset);

    if (node->kind != YAML_TREE_LIST || node->count < 1 || node->count > key->most)
        return schema_refuse(key, node, why);
    for (const struct yaml_tree *n = node->first; n; n = n->next) {
        if (!n->text)
            return schema_refuse(key, node, why);
        add_text(ARENA_OF(target), words, n->text, "", n->line);
    }
    return STATUS_OK;
}

/* --- statements */

static const struct schema_key READING[] = {
    {"why", .type = SCHEMA_TEXT, IN(plan_reading, why)},
    {"ours", .type = SCHEMA_WORD, .words = NO_OR_YES, IN(plan_reading, ours)},
    {NULL}};

static enum status read_readings(const struct schema_key *key, const struct yaml_tree *node,
                                 void *target, struct message *why)
{
    struct plan_statement *s = (void *)((char *)target + key->offset);

    if (node->kind != YAML_TREE_MAP || node->count < 1 || node->count > PLAN_READINGS)
        return schema_refuse(key, node, why);
    s->readings = arena_take(ARENA_OF(target), (size_t)node->count, sizeof *s->readings);
    for (const struct yaml_tree *n = node->first; n; n = n->next) {
        struct plan_reading *r = &s->readings[s->reading_count++];
        r->arena = ARENA_OF(target);
        r->name = arena_print(r->arena, "%s", n->key);
        CALL(read_labels(READING, n, r, &r->rows, why));
    }
    return STATUS_OK;
}

/* Reads [QUANTITY, ROW, ROW] of a ratio, or [QUANTITY, QUANTITY, ROWS] of an exponent. */
static enum status read_compared(const struct schema_key *key, const struct yaml_tree *node,
                                 void *target, struct message *why)
{
    struct plan_statement *s = target;
    enum status st = STATUS_OK;
    int rows = 0;

    s->exponent = !strcmp(key->key, "exponent");
    if (node->kind != YAML_TREE_LIST || node->count != 3)
        return schema_refuse(key, node, why);
    for (const struct yaml_tree *n = node->first; n && st == STATUS_OK; n = n->next)
        if (n->kind == YAML_TREE_MAP && rows < 2 - s->exponent)
            st = read_labels(NONE, n, s, &s->row[rows++], why);
        else if (n->text && !rows)
            add_text(s->arena, &s->quantity, n->text, "", n->line);
        else
            st = schema_refuse(key, n, why);
    return st == STATUS_OK && rows != 2 - s->exponent ? schema_refuse(key, node, why) : st;
}

/* clang-format off */
#define READINGS(at)                                                                       \
    {"readings", "what the paper leaves open: labels that rows have besides, and why; the" \
     " first is primary", SCHEMA_SPECIAL, .read = read_readings, .offset = (at),            \
     .want = "a map of 1 to 8 {NAME: {AXIS: LABEL, why: ...}}, with ours: true what we would do"}
static const struct schema_key STATEMENT[] = {
    {"quote", "what the paper states, in our words", SCHEMA_TEXT, .required = true,
     IN(plan_statement, quote)},
    {"section", "where it states that", SCHEMA_TEXT, .required = true, IN(plan_statement, section)},
    {"ratio", "a quantity of one row over that of another", SCHEMA_SPECIAL, .read = read_compared,
     .want = "[QUANTITY, {AXIS: LABEL}, {AXIS: LABEL}]"},
    {"exponent", "the power of x as which y grows over some rows", SCHEMA_SPECIAL,
     .read = read_compared, .want = "[QUANTITY, QUANTITY, {AXIS: LABEL}]"},
    {"paper", "what it is in the paper", SCHEMA_NUMBER, .required = true, .low = 0, .high = 1e9,
     .open = true, IN(plan_statement, paper)},
    READINGS(0),
    {NULL}};
/* clang-format on */

static enum status read_statement(const struct yaml_tree *node, void *target,
                                  struct message *why)
{
    struct plan_statement *s = target;
    enum status st = STATUS_OK;

    s->line = node->line;
    CALL(read_table(STATEMENT, node, "a statement", s, why));
    if (s->quantity.count != 1 + s->exponent)
        st = yaml_tree_refuse(node, why, "a statement is either a ratio or an exponent");
    return st;
}

LIST_READER(read_statements, plan, statements, statement_count, read_statement)

/* Reads a plan file as text and tree, both freed by the receiver. */
static enum status load(const char *path, char **text, struct yaml_tree **root,
                        struct message *why)
{
    size_t size = 0;

    CALL(named_file_read(&plan_kind, path, text, &size, why));
    return yaml_tree_parse(path, false, *text, size, root, why);
}

/* Reads the rules that another plan has under the key. */
static enum status read_others(const char *name, const char *key, struct arena *arena,
                               struct rules *rules, struct message *why)
{
    char *path SCOPED(scope_free) = NULL;
    char *text SCOPED(scope_free) = NULL;
    struct yaml_tree *list = NULL;
    struct yaml_tree *root SCOPED(yaml_tree_free_scope) = NULL;

    CALL(named_file_find(&plan_kind, name, &path, why));
    CALL(load(path, &text, &root, why));
    if (root->kind == YAML_TREE_MAP)
        list = yaml_tree_find(root, key);
    if (!list)
        return yaml_tree_refuse(root, why, "this plan has no %s", key);
    return rules_read(list, arena, rules, why);
}

/* Reads a list of rules, or the plan that has it. */
static enum status read_verdicts(const struct schema_key *key, const struct yaml_tree *node,
                                 void *target, struct message *why)
{
    struct rules *rules = (void *)((char *)target + key->offset);
    struct message reason = {""};

    if (node->kind != YAML_TREE_SCALAR)
        return rules_read(node, ARENA_OF(target), rules, why);
    const enum status st =
        read_others(node->text, key->key, ARENA_OF(target), rules, &reason);
    if (st == STATUS_OK || st == STATUS_MEMORY)
        return st;
    return yaml_tree_refuse(node, why, "%s: %s", key->key, reason.text);
}

/* clang-format off */
static const struct schema_key TABLE[] = {
    {"columns", "quantities, a column each", SCHEMA_SPECIAL, .required = true,
     .read = read_words, .most = PLAN_TABLE_COLUMNS, IN(plan, table.columns),
     .want = "a list of 1 to 16 quantities"},
    {"last", "show only the last time of each study", SCHEMA_WORD,
     .words = NO_OR_YES, IN(plan, table.last)},
    {"shown", "show only the levels with these labels", SCHEMA_SPECIAL,
     .read = read_chosen, IN(plan, table.shown), .want = "a map {AXIS: LABEL}"},
    {"note", "note below the table", SCHEMA_TEXT, IN(plan, table.note)},
    {NULL}};

#define AXES SCHEMA_SPECIAL, .read = read_words, .most = PLAN_STUDY_AXES, \
    .want = "a list of 1 to 8 axes"
static const struct schema_key CHART[] = {
    {"x", "quantity along x, or a name for the size of the levels", SCHEMA_TEXT, .required = true,
     IN(plan, chart.x)},
    {"y", "quantities along y, a line each", SCHEMA_SPECIAL, .required = true, IN(plan, chart.y),
     .read = read_words, .most = PLAN_TABLE_COLUMNS, .want = "a list of 1 to 16 quantities"},
    {"from", "value from which the quantity's distance is drawn (none)", SCHEMA_NUMBER,
     .low = -1e30,
     .high = 1e30, IN(plan, chart.from)},
    {"panel", "axes whose labels have a panel each", AXES, IN(plan, chart.panel)},
    {"line", "axes whose labels have a line each", AXES, .required = true,
     IN(plan, chart.line)},
    {NULL}};

static const struct schema_key PLAN[] = {
    {"name", "name in lists, and of the results' folder", SCHEMA_TEXT, .required = true,
     IN(plan, name)},
    {"source", "subject of the plan", SCHEMA_TEXT, .required = true, IN(plan, source)},
    {"what", "description for lists (the source)", SCHEMA_TEXT, IN(plan, what)},
    {"scene", "scene of all cases", WITH_SCENE, IN(plan, settings)},
    {"model", "of all cases: a model or a contestant", WITH_MODEL, IN(plan, settings)},
    {"settings", "settings of all cases", SCHEMA_SPECIAL, .read = read_map, IN(plan, settings),
     .want = "a map {KEY: VALUE, ...} of keys that --set takes"},
    {"look", "frames between two readings of the metrics", SCHEMA_COUNT, .low = 1,
     .high = 1e6, IN(plan, look)},
    {"intersections", "count self-intersections", SCHEMA_WORD, .words = NO_OR_YES,
     IN(plan, intersections)},
    {"keep", "fields that result files keep", SCHEMA_WORD, .words = KEEPS, IN(plan, keep)},
    {"time_limit", "processor time that a case may take [s]", SCHEMA_NUMBER,
     .low = 0.001, .high = 1e9,
     IN(plan, time_limit)},
    {"verdicts", "rules that label a case", SCHEMA_SPECIAL, .read = read_verdicts,
     .want = "rules {label: ..., measure: ..., above or below: ..., why: ...}, or the plan "
             "that has them",
     IN(plan, verdicts)},
    SHARED_KEYS(offsetof(struct reading, base)),
    {"studies", "each has these axes, times, ... but for its own", SCHEMA_SPECIAL,
     .read = read_studies, .keys = STUDY,
     .want = "a map of 1 to 64 studies {NAME: {scene: ..., KEY: VALUE}}"},
    {"skip", "products of the axes that are not run; with quick: true, not in a quick run",
     SCHEMA_SPECIAL, .read = read_products, .low = 1, .most = PLAN_STUDY_MOST,
     IN(plan, skip), .want = "a list of maps {AXIS: LABEL, AXIS: [LABEL, LABEL]}"},
    {"paper", "milliseconds of a frame in the paper, for products of the axes", SCHEMA_SPECIAL,
     .read = read_products, .low = 1, .most = PLAN_STUDY_MOST, IN(plan, paper),
     .want = "a list of maps {AXIS: LABEL, paper_ms: NUMBER}"},
    READINGS(offsetof(struct reading, open)),
    {"statements", "statements of the paper that are ratios or exponents", SCHEMA_SPECIAL,
     .read = read_statements, .low = 1, .most = PLAN_STUDY_MOST, .keys = STATEMENT,
     .want = "a list of maps {quote: ..., section: ..., ratio: [...], paper: NUMBER}"},
    {"reference", "axis and label of the cases that others are compared with", SCHEMA_SPECIAL,
     .read = read_chosen, IN(plan, reference), .want = "a map {AXIS: LABEL}"},
    {"table", "one table of all studies", SCHEMA_SECTION, .keys = TABLE},
    {"chart", "a point for each level", SCHEMA_SECTION, .keys = CHART},
    {NULL}};
/* clang-format on */

/* --- what the studies have of the plan ---------------------------------------------------
 */

/* Returns the line of a key of a map; `otherwise`: it is not there. */
static int line_of(const struct yaml_tree *map, const char *key, int otherwise)
{
    const struct yaml_tree *node = yaml_tree_find(map, key);

    return node ? node->line : otherwise;
}

bool plan_is_study(const struct plan *plan)
{
    return plan->study_count && plan->studies->time_count >= 0;
}

const char *plan_label(const struct plan_study *study, const struct plan_level *level,
                       const char *axis)
{
    if (!strcmp(axis, "study"))
        return study->name;
    if (!strcmp(axis, "caption"))
        return study->caption;
    for (int n = 0; n < study->axis_count; n++)
        if (!strcmp(axis, study->axis[n].name))
            return level->part[n]->label;
    return NULL;
}

int plan_level_with(const struct plan_study *study, const struct plan_level *level,
                    const struct plan_settings *labels)
{
    for (int n = 0; n < study->level_count; n++) {
        bool same = true;
        for (int a = 0; same && a < study->axis_count; a++) {
            const struct plan_setting *want =
                plan_settings_find(labels, study->axis[a].name);
            const struct plan_level *part = study->levels[n].part[a];
            same = want ? !strcmp(part->label, want->value) : part == level->part[a];
        }
        if (same)
            return n;
    }
    return -1;
}

/* Returns whether a level of a study is among these products. */
static bool is_among(const struct plan_product *product, const struct plan_study *study,
                     const struct plan_level *level)
{
    for (int axis = -1; axis < study->axis_count; axis++) {
        const char *name = axis < 0 ? "study" : study->axis[axis].name;
        const char *word = plan_label(study, level, name);
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

/* Makes the product of one level of each axis, the last axis changing fastest: its label
 * and name are theirs, joined. */
static void multiply(const struct plan_study *study, int number, struct plan_level *product)
{
    char label[4096] = "", name[4096] = "";

    *product = (struct plan_level){study->arena, .paper_ms = NAN, .timed = -1};
    for (int n = study->axis_count - 1; n >= 0; n--) {
        product->part[n] = &study->axis[n].levels[number % study->axis[n].count];
        number /= study->axis[n].count;
    }
    for (int n = 0; n < study->axis_count; n++) {
        const struct plan_level *level = product->part[n];
        product->line = level->line;
        product->size = level->size > 0 ? level->size : product->size;
        product->timed = level->timed >= 0 ? level->timed : product->timed;
        product->paper_ms = isnan(level->paper_ms) ? product->paper_ms : level->paper_ms;
        product->phases |= level->phases;
        TEXT_JOIN(label, ", ", "%s", level->label);
        TEXT_JOIN(name, "_", "%s", level->name);
    }
    product->label = arena_print(study->arena, "%s", label);
    product->name = arena_print(study->arena, "%s", name);
}

/* Makes the levels of a study. */
static enum status multiply_all(struct plan_study *study, const struct plan *plan,
                                struct message *why)
{
    double all = 1;

    for (int n = 0; n < study->axis_count; n++)
        all *= study->axis[n].count;
    if (all > PLAN_MAX_CASES)
        return plan_case_refuse(plan, study->line, why,
                                "the plan has more than %d cases, the most there may be",
                                PLAN_MAX_CASES);
    study->levels = arena_take(study->arena, (size_t)all, sizeof *study->levels);
    for (int n = 0; n < (int)all; n++) {
        struct plan_level *level = &study->levels[study->level_count++];
        bool gone = false;
        multiply(study, n, level);
        for (int k = 0; k < plan->skip.count; k++)
            if (is_among(&plan->skip.list[k], study, level)) {
                level->slow |= plan->skip.list[k].quick;
                gone |= !plan->skip.list[k].quick;
            }
        for (int k = 0; k < plan->paper.count; k++)
            if (is_among(&plan->paper.list[k], study, level))
                level->paper_ms = plan->paper.list[k].paper_ms;
        study->level_count -= gone;
    }
    return STATUS_OK;
}

/* Reads the axes of a study: its own, and the plan's in whose place it has no other. */
static enum status join_axes(struct plan_study *study, const struct yaml_tree *plans,
                             const struct yaml_tree *own, struct message *why)
{
    const struct yaml_tree *first = own ? own->first : NULL;

    study->axis_count = 0;
    memset(study->axis, 0, sizeof study->axis);
    for (int k = 0; k < 2; k++) /* own ones that the plan has not, then the plan's */
        for (const struct yaml_tree *n = k ? plans->first : first; n; n = n->next) {
            const struct yaml_tree *other = yaml_tree_find(k ? own : plans, n->key);
            if (other && (!k || !other->count)) /* an empty one takes the plan's away */
                continue;
            if (study->axis_count == PLAN_STUDY_AXES)
                return yaml_tree_refuse(n, why, "%s has more than %d axes", study->name,
                                        PLAN_STUDY_AXES);
            CALL(read_axis(study->arena, other ? other : n,
                           &study->axis[study->axis_count++], why));
        }
    return STATUS_OK;
}

/* Completes a study: what its own map, `node`, does not say is read from the plan's. A
 * study with times of its own has no others in a quick run unless it says so. */
static enum status complete(struct plan_study *study, const struct yaml_tree *root,
                            const struct yaml_tree *node, const struct plan *plan,
                            struct message *why)
{
    const bool own_times = node && yaml_tree_find(node, "times");
    const bool timeless = !own_times && !yaml_tree_find(root, "times");

    for (const struct schema_key *key = SHARED; key->key; key++) {
        const struct yaml_tree *plans = yaml_tree_find(root, key->key);
        const struct yaml_tree *own = node ? yaml_tree_find(node, key->key) : NULL;
        if (plans && key->read == read_axes)
            CALL(join_axes(study, plans, own, why));
        else if (plans && !own && !(own_times && !strcmp(key->key, "quick_times")))
            CALL(read_value(key, plans, study, why));
    }
    study->times_line = line_of(own_times ? node : root, "times", 0);
    study->time_count = timeless ? -1 : study->time_count;
    if (!study->axis_count)
        return plan_case_refuse(plan, study->line, why,
                                "%s has no axes, and the plan has none for it",
                                yaml_tree_quote(study->name).text);
    if (!study->caption)
        study->caption = study->name;
    return multiply_all(study, plan, why);
}

/* Completes all studies; a plan without is one, of its own name. */
static enum status complete_studies(struct plan *plan, const struct yaml_tree *root,
                                    struct message *why)
{
    const struct yaml_tree *node = yaml_tree_find(root, "studies");

    if (!node) {
        plan->studies = arena_take(plan->arena, 1, sizeof *plan->studies);
        *plan->studies = (struct plan_study){plan->arena, .name = plan->name,
                                             .caption = plan->source, .line = root->line};
        plan->study_count = 1;
    }
    node = node ? node->first : NULL;
    for (int n = 0; n < plan->study_count; n++, node = node ? node->next : NULL)
        CALL(complete(&plan->studies[n], root, node, plan, why));
    return STATUS_OK;
}

/* --- the whole ---------------------------------------------------------------------------
 */

static enum status read_tree(const struct yaml_tree *root, struct plan *plan,
                             struct message *why)
{
    struct reading r = {.plan = *plan};
    enum status st = read_table(PLAN, root, "the plan", &r, why);

    *plan = r.plan; /* each study reads its own of the rest, and each statement */
    CALL(st);
    if (strlen(plan->name) > 64 ||
        plan->name[strspn(plan->name, "abcdefghijklmnopqrstuvwxyz0123456789_-")])
        return yaml_tree_refuse(yaml_tree_find(root, "name"), why,
                                "name is %s, but must be 1 to 64 of the characters a-z, "
                                "0-9, _ and -",
                                yaml_tree_describe(yaml_tree_find(root, "name")).text);
    for (int n = 0; n < plan->statement_count; n++)
        if (!plan->statements[n].readings && yaml_tree_find(root, "readings"))
            CALL(read_readings(&(struct schema_key){.offset = 0},
                               yaml_tree_find(root, "readings"), &plan->statements[n],
                               why));
    return complete_studies(plan, root, why);
}

enum status plan_parse(const char *path, struct plan *plan, struct message *why)
{
    enum status st = STATUS_OK;
    struct yaml_tree *root = NULL;

    *plan = (struct plan){.look = 10, .time_limit = 600, .chart.from = NAN};
    if (why)
        why->text[0] = '\0';
    struct arena first = {0};
    plan->arena = arena_take(&first, 1, sizeof first);
    *plan->arena = first;
    plan->path = arena_print(plan->arena, "%s", path);
    st = load(path, &plan->text, &root, why);
    if (plan->text)
        arena_keep(plan->arena, plan->text);
    TRY(st);
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

/* Returns what a plan is about; with `studies`, nothing if it is none. */
static char *describe_of(const char *path, bool studies)
{
    struct plan plan SCOPED(plan_clear) = {0};
    struct message why;
    char *text;

    if (plan_parse(path, &plan, &why) != STATUS_OK)
        return strdup(why.text);
    text = strdup(studies && !plan_is_study(&plan) ? ""
                  : plan.what                      ? plan.what
                                                   : plan.source);
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

void plan_clear(struct plan *plan)
{
    struct arena all = plan->arena ? *plan->arena : (struct arena){0};

    arena_clear(&all);
    *plan = (struct plan){0};
}

/* --- checks ------------------------------------------------------------------------------
 */

static void add_key(struct plan *plan, const char *key)
{
    for (int k = 0; k < plan->key_count; k++)
        if (!strcmp(plan->keys[k], key))
            return;
    plan->keys =
        arena_more(plan->arena, plan->keys, (size_t)plan->key_count, sizeof *plan->keys);
    plan->keys[plan->key_count++] = key;
}

static void add_keys_of(struct plan *plan, const struct plan_settings *settings)
{
    for (int n = 0; n < settings->count; n++)
        add_key(plan, settings->list[n].key);
}

static void add_keys(struct plan *plan)
{
    add_keys_of(plan, &plan->settings);
    for (int n = 0; n < plan->study_count; n++) {
        const struct plan_study *study = &plan->studies[n];
        add_keys_of(plan, &study->settings);
        for (int k = 0; k < study->axis_count; k++)
            for (int i = 0; i < study->axis[k].count; i++) {
                add_keys_of(plan, &study->axis[k].levels[i].settings);
                add_keys_of(plan, &study->axis[k].levels[i].quick);
            }
    }
}

/* Checks that there is a frame at every time. */
static enum status check_times(const struct plan *plan, const struct plan_study *study,
                               const struct plan_level *level, const struct scene *scene,
                               struct message *why)
{
    const int times = study->time_count > 0 ? study->time_count : 0;

    for (int n = 0; n < times + study->quick_count; n++) {
        const double t = n < times ? study->times[n] : study->quick_times[n - times];
        const double frames = t / scene->step;
        if (fabs(frames - round(frames)) > 1e-6 * frames || frames < 0.5)
            return plan_case_refuse(
                plan, study->times_line, why,
                "the time %g s is no multiple of the step, %g s, of the level "
                "%s",
                t, scene->step, yaml_tree_quote(level->label).text);
    }
    return STATUS_OK;
}

/* Checks that a case's scene can be read, and has a frame at a study's times; clears the
 * case. */
static enum status try_scene(const struct plan *plan, const struct plan_study *study,
                             const struct plan_level *level, struct plan_case *c,
                             struct message *why)
{
    struct scene scene SCOPED(scene_clear) = {0};
    enum status st = plan_case_blame(plan, c, plan_case_scene(c, &scene, why), why);

    if (st == STATUS_OK)
        st = check_times(plan, study, level, &scene, why);
    plan_case_clear(c);
    return st;
}

/* Checks a name, which becomes that of a file and which no other may have. */
static enum status check_name(const struct plan *plan, const char *what, const char *name,
                              const char *before, int line, struct message *why)
{
    const size_t good = strspn(name, "abcdefghijklmnopqrstuvwxyz0123456789_");

    if (!*name || name[good] || strlen(name) > 64)
        return plan_case_refuse(
            plan, line, why,
            "%s has the name %s, but must have 1 to 64 of the characters a-z, "
            "0-9 and _",
            what, yaml_tree_quote(name).text);
    if (before && !strcmp(before, name))
        return plan_case_refuse(plan, line, why,
                                "%s has the name %s as another has; its files "
                                "need a name of their own",
                                what, yaml_tree_quote(name).text);
    return STATUS_OK;
}

static enum status try_level(const struct plan *plan, const struct plan_study *study,
                             const struct plan_level *level, bool quick,
                             struct message *why)
{
    struct plan_case c;
    const enum status st = plan_case_level(plan, study, level, quick, &c, why);

    return st ? st : try_scene(plan, study, level, &c, why);
}

/* Returns whether a level is one of few, or has all axes but one at their first. */
static bool is_tried(const struct plan_study *study, const struct plan_level *level)
{
    enum { FEW = 500 };
    int others = 0;

    for (int n = 0; n < study->axis_count; n++)
        others += level->part[n] != study->axis[n].levels;
    return study->level_count <= FEW || others <= 1;
}

static enum status check_study(const struct plan *plan, int n, struct message *why)
{
    const struct plan_study *study = &plan->studies[n];

    CALL(check_name(plan, "a study", plan->study_count > 1 ? study->name : "study", NULL,
                    study->line, why));
    if (!study->level_count || (study->time_count < 0) == plan_is_study(plan))
        return plan_case_refuse(plan, study->line, why, "the study %s has no %s",
                                yaml_tree_quote(study->name).text,
                                study->level_count ? "times, though others have" : "cases");
    if (study->truth == PLAN_TRUTH_SCENE && study->time_count <= 0)
        return plan_case_refuse(
            plan, study->line, why,
            "the study %s has truth, but no times; a truth is of a motion",
            yaml_tree_quote(study->name).text);
    for (int k = 0; k < study->level_count; k++) {
        const struct plan_level *level = &study->levels[k];
        if (!is_tried(study, level))
            continue;
        for (int i = 0; study->time_count >= 0 && (i < k || i == 0); i++)
            CALL(check_name(plan, "a level", level->name,
                            i < k ? study->levels[i].name : NULL, level->line, why));
        CALL(try_level(plan, study, level, false, why));
        for (int i = 0; i < PLAN_STUDY_AXES && level->part[i]; i++)
            if (level->part[i]->quick.count)
                CALL(try_level(plan, study, level, true, why));
    }
    return STATUS_OK;
}

/* Returns whether some study has an axis of this name, and this label on it. */
static bool has_label(const struct plan *plan, const char *axis, const char *label,
                      bool *known)
{
    bool found = false;

    *known = false;
    for (int n = 0; n < plan->study_count; n++) {
        const struct plan_study *study = &plan->studies[n];
        *known |= !strcmp(axis, "study");
        found |= !strcmp(axis, "study") && !strcmp(label, study->name);
        for (int a = 0; a < study->axis_count; a++) {
            if (strcmp(study->axis[a].name, axis))
                continue;
            *known = true;
            for (int k = 0; k < study->axis[a].count; k++)
                found |= !strcmp(study->axis[a].levels[k].label, label);
        }
    }
    return found;
}

static enum status check_labels(const struct plan *plan, const struct plan_settings *labels,
                                struct message *why)
{
    bool known;

    for (int n = 0; n < labels->count; n++) {
        const struct plan_setting *s = &labels->list[n];
        if (has_label(plan, s->key, s->value, &known))
            continue;
        return plan_case_refuse(
            plan, s->line, why, "%s %s%s%.60s'",
            known ? "the axis" : "no study has an axis", yaml_tree_quote(s->key).text,
            known ? ", which has no label '" : ", nor a label '", s->value);
    }
    return STATUS_OK;
}

/* Checks likewise labels of rows (results.h), of which some stand for several. */
static enum status check_rows(const struct plan *plan, const struct plan_settings *rows,
                              struct message *why)
{
    for (int n = 0; n < rows->count; n++) {
        struct plan_setting *s = &rows->list[n];
        const struct plan_settings one = {1, s};
        if (strcmp(s->key, "at") && s->value[0] != '!' && !strchr(s->value, '*'))
            CALL(check_labels(plan, &one, why));
    }
    return STATUS_OK;
}

static enum status check_statement(const struct plan *plan, const struct plan_statement *s,
                                   struct message *why)
{
    CALL(check_rows(plan, &s->row[0], why));
    CALL(check_rows(plan, &s->row[1], why));
    for (int n = 0; n < s->reading_count; n++)
        CALL(check_rows(plan, &s->readings[n].rows, why));
    if (s->reading_count && s->readings->ours)
        return plan_case_refuse(
            plan, s->line, why,
            "the first reading is what we would do; the primary one has a "
            "name and stands first");
    return STATUS_OK;
}

static enum status check_studies(const struct plan *plan, struct message *why)
{
    for (int n = 0; n < plan->statement_count; n++)
        CALL(check_statement(plan, &plan->statements[n], why));

    for (int n = 0; n < plan->skip.count; n++)
        CALL(check_labels(plan, &plan->skip.list[n].labels, why));
    for (int n = 0; n < plan->paper.count; n++) {
        const struct plan_product *paper = &plan->paper.list[n];
        CALL(check_labels(plan, &paper->labels, why));
        if (!(paper->paper_ms > 0))
            return plan_case_refuse(plan,
                                    paper->labels.count ? paper->labels.list->line : 1, why,
                                    "an entry of paper lacks the key paper_ms");
    }
    CALL(check_labels(plan, &plan->reference, why));
    CALL(check_labels(plan, &plan->table.shown, why));

    for (int n = 0; n < plan->study_count; n++)
        CALL(check_study(plan, n, why));
    return STATUS_OK;
}

static enum status check(struct plan *plan, struct message *why)
{
    if (!plan_settings_find(&plan->settings, "model")) /* the program's first */
        add_text(plan->arena, &plan->settings, "model", contestant_model(0)->name, 1);
    add_keys(plan);
    if (plan->reference.count && !plan_is_study(plan) && plan->keep != PLAN_KEEP_SNAPSHOTS)
        return plan_case_refuse(plan, plan->reference.list->line, why,
                                "a sweep with a reference must keep snapshots");
    if (plan_case_count(plan) > PLAN_MAX_CASES)
        return plan_case_refuse(plan, 1, why,
                                "the plan has more than %d cases, the most there may be",
                                PLAN_MAX_CASES);
    return check_studies(plan, why);
}

enum status plan_read(const char *path, struct plan *plan, struct message *why)
{
    enum status st = plan_parse(path, plan, why);

    if (st == STATUS_OK)
        st = check(plan, why);
    if (st != STATUS_OK)
        plan_clear(plan);
    return st;
}
