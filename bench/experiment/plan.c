/* plan.c - a plan from YAML: one schema reads, refuses and documents. */
#include "bench/experiment/plan.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define IN(type, member) .offset = offsetof(struct type, member)

static const char *const KEEPS[] = {"none", "snapshots", NULL};

static enum status read_axes(const struct schema_key *key, const struct yaml_tree *node,
                             void *target, struct message *why)
{
    enum status st;
    struct plan *plan = target;

    plan->axes = plan_settings_list(key, node, sizeof *plan->axes, &plan->axis_count,
                                    plan_axis_read, &st, why);
    return st;
}

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

static enum status read_cases(const struct schema_key *key, const struct yaml_tree *node,
                              void *target, struct message *why)
{
    enum status st;
    struct plan *plan = target;

    plan->listed = plan_settings_list(key, node, sizeof *plan->listed, &plan->listed_count,
                                      read_listed, &st, why);
    return st;
}

static enum status read_studies(const struct schema_key *key, const struct yaml_tree *node,
                                void *target, struct message *why)
{
    enum status st;
    struct plan *plan = target;

    plan->studies = plan_settings_list(key, node, sizeof *plan->studies, &plan->study_count,
                                       plan_study_read, &st, why);
    return st;
}

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

static enum status read_products(const struct schema_key *key, const struct yaml_tree *node,
                                 void *target, struct message *why)
{
    struct plan_products *products = (void *)((char *)target + key->offset);
    enum status st;

    products->list = plan_settings_list(key, node, sizeof *products->list, &products->count,
                                        read_product, &st, why);
    return st;
}

static enum status read_shown(const struct schema_key *key, const struct yaml_tree *node,
                              void *target, struct message *why)
{
    (void)key;
    return read_labels(node, &((struct plan *)target)->table.shown, NULL, why);
}

static enum status read_reference(const struct schema_key *key,
                                  const struct yaml_tree *node, void *target,
                                  struct message *why)
{
    (void)key;
    return read_labels(node, &((struct plan *)target)->reference, NULL, why);
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

static enum status read_marks(const struct schema_key *key, const struct yaml_tree *node,
                              void *target, struct message *why)
{
    enum status st;
    struct plan_map *map = &((struct plan *)target)->map;

    map->marks = plan_settings_list(key, node, sizeof *map->marks, &map->mark_count,
                                    read_mark, &st, why);
    return st;
}

static const struct schema_key MAP[] = {
    {"x", "key or measure", SCHEMA_TEXT, .required = true, IN(plan, map.x)},
    {"y", "key or measure", SCHEMA_TEXT, .required = true, IN(plan, map.y)},
    {"panel", "key of a panel each, or name (of cases)", SCHEMA_TEXT, IN(plan, map.panel)},
    {"marks", "points that are no cases", SCHEMA_SPECIAL, .most = PLAN_MAX_LISTED,
     .read = read_marks, .want = "a list of {text: ..., label: ..., at: {KEY: VALUE}}"},
    {NULL}};

static const struct schema_key TABLE[] = {
    {"columns", "quantities, a column each", SCHEMA_SPECIAL, .required = true,
     .read = read_words, .most = PLAN_TABLE_COLUMNS, IN(plan, table.columns),
     .want = "a list of 1 to 16 quantities"},
    {"last", "people see the last time of each study alone", SCHEMA_WORD,
     .words = plan_settings_truth, IN(plan, table.last)},
    {"shown", "people see the levels with these labels alone", SCHEMA_SPECIAL,
     .read = read_shown, .want = "a map {AXIS: LABEL}"},
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
     .read = read_axes, .keys = plan_axis_keys,
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
     .read = read_studies, .low = 1, .most = PLAN_STUDY_MOST, .keys = plan_study_keys,
     .want = "a list of 1 to 100 studies {name: ..., scene: ..., settings: {KEY: VALUE}}"},
    {"skip", "products of a study's axes that are not run; quick: true, by a quick run",
     SCHEMA_SPECIAL, .read = read_products, .low = 1, .most = PLAN_STUDY_MOST,
     IN(plan, skip), .want = "a list of maps {AXIS: LABEL, AXIS: [LABEL, LABEL]}"},
    {"paper", "milliseconds of somebody else's frame, of such products", SCHEMA_SPECIAL,
     .read = read_products, .low = 1, .most = PLAN_STUDY_MOST, IN(plan, paper),
     .want = "a list of maps {AXIS: LABEL, paper_ms: NUMBER}"},
    {"reference", "axis and label of what levels are compared with", SCHEMA_SPECIAL,
     .read = read_reference, .want = "a map {AXIS: LABEL}"},
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

    for (const char *const *key =
             (const char *const[]){"times", "truth", "timed", "skip", "reference", "paper",
                                   "table", "chart", NULL};
         *key && !given; key++)
        given = yaml_tree_find(root, *key);
    if (given && !alone && !plan->study_count)
        return yaml_tree_refuse(given, why, "%s is for studies, but the plan has no levels",
                                given->key);
    if (alone) {
        plan->studies = calloc(1, sizeof *plan->studies);
        TRY(plan->studies ? STATUS_OK : STATUS_MEMORY);
        plan->studies[plan->study_count++] = plan_study_none();
        plan->studies->line = root->line;
        plan->studies->name = strdup(plan->name);
        plan->studies->caption = strdup(plan->source);
        TRY(plan->studies->name && plan->studies->caption ? STATUS_OK : STATUS_MEMORY);
    }
    for (int n = 0; n < plan->study_count; n++)
        TRY(plan_study_inherit(&plan->studies[n], plan, why));
out:
    return st;
}

static enum status read_tree(const struct yaml_tree *root, struct plan *plan,
                             struct message *why)
{
    enum status st = STATUS_OK;
    const struct yaml_tree *name, *map, *times, *falls, *table;

    TRY(schema_read(PLAN, root, "the plan", plan, why));
    name = yaml_tree_find(root, "name");
    if (strlen(plan->name) > 64 ||
        plan->name[strspn(plan->name, "abcdefghijklmnopqrstuvwxyz0123456789_-")])
        return yaml_tree_refuse(name, why,
                                "name is %s, but must be 1 to 64 of the characters a-z, "
                                "0-9, _ and -",
                                yaml_tree_describe(name).text);
    map = yaml_tree_find(root, "map");
    plan->map.line = map ? map->line : root->line;
    falls = yaml_tree_find(root, "falls");
    plan->falls.line = falls ? falls->line : root->line;
    table = yaml_tree_find(root, "table");
    plan->table.line = table ? table->line : root->line;
    times = yaml_tree_find(root, "times");
    plan->base.times_line = times ? times->line : 0;
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
                          .base = plan_study_none()};
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
        plan_axis_clear(&plan->axes[n]);
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
        plan_study_clear(&plan->studies[n], &plan->base);
    plan_study_clear(&plan->base, &plan->base);
    clear_products(&plan->skip);
    clear_products(&plan->paper);
    plan_settings_clear(&plan->reference);
    plan_settings_clear(&plan->table.columns);
    plan_settings_clear(&plan->table.shown);
    plan_settings_clear(&plan->table.pictures);
    free(plan->table.note);
    plan_settings_clear(&plan->chart.panel);
    plan_settings_clear(&plan->chart.line);
    free(plan->chart.x);
    plan_settings_clear(&plan->chart.y);
    free(plan->table.file);
    plan_settings_clear(&plan->settings);
    verdict_clear(&plan->verdicts);
    verdict_clear(&plan->learnt);
    free(plan->studies);
    free(plan->axes);
    free(plan->listed);
    free(plan->map.marks);
    free(plan->falls.along);
    free(plan->map.x);
    free(plan->map.y);
    free(plan->map.panel);
    free(plan->keys);
    free(plan->path);
    free(plan->text);
    free(plan->name);
    free(plan->source);
    free(plan->what);
    *plan = (struct plan){0};
}
