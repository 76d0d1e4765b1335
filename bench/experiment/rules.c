#include "bench/experiment/rules.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "models/reader/schema.h"

/* A rule as it is read; NaN: the key was not given. */
struct reading {
    char *label, *why;
    int measure;
    double above, below;
};

#define IN(member) .offset = offsetof(struct reading, member)
#define ANY        .low = -1e30, .high = 1e30

static const struct schema_key RULE[] = {
    {"label", "what such a case is called", SCHEMA_TEXT, .required = true, IN(label)},
    {"measure", "number of a case", SCHEMA_WORD, .required = true, .word = measure_name,
     IN(measure)},
    {"above", "the label is given above this", SCHEMA_NUMBER, ANY, IN(above)},
    {"below", "the label is given below this", SCHEMA_NUMBER, ANY, IN(below)},
    {"why", "reason for the value", SCHEMA_TEXT, .required = true, IN(why)},
    {NULL}};

static enum status read_rule(const struct yaml_tree *node, struct arena *arena,
                             struct rule *rule, struct message *why)
{
    struct reading r = {.above = NAN, .below = NAN};
    enum status st = schema_read(RULE, node, "a verdict", &r, why);

    if (r.label)
        arena_keep(arena, r.label);
    if (r.why)
        arena_keep(arena, r.why);
    CALL(st);
    if (isnan(r.above) == isnan(r.below))
        return yaml_tree_refuse(node, why,
                                "the verdict %s must have one of above and below",
                                yaml_tree_quote(r.label).text);
    *rule = (struct rule){.label = r.label,
                          .measure = r.measure,
                          .above = isnan(r.below),
                          .bound = isnan(r.below) ? r.above : r.below,
                          .why = r.why};
    return STATUS_OK;
}

enum status rules_read(const struct yaml_tree *list, struct arena *arena,
                       struct rules *rules, struct message *why)
{
    int count = 0;

    *rules = (struct rules){0};
    if (list->kind != YAML_TREE_LIST || list->count == 0 || list->count > RULES_MOST)
        return yaml_tree_refuse(list, why,
                                "verdicts is %s, but must be a list of 1 to %d rules "
                                "{label: ..., measure: ..., above: ..., why: ...}",
                                yaml_tree_describe(list).text, RULES_MOST);
    for (const struct yaml_tree *node = list->first; node; node = node->next)
        CALL(read_rule(node, arena, &rules->rule[count++], why));
    rules->count = count;
    return STATUS_OK;
}

struct ruling rules_of(const struct rules *rules, const struct run_result *r)
{
    struct ruling v = {.died = status_is_death(r->outcome)};

    if (r->quick)
        return (struct ruling){.kind = VERDICT_UNJUDGED, .quick = true};
    if (r->outcome != STATUS_OK && !v.died)
        return (struct ruling){.kind = VERDICT_NONE};
    for (int n = 0; n < rules->count; n++) {
        const struct rule *rule = &rules->rule[n];
        const double value = r->value[rule->measure];
        if (isnan(value))
            v.unmeasured |= 1u << n;
        else if (rule->above ? value > rule->bound : value < rule->bound)
            v.rules |= 1u << n;
    }
    v.kind = v.rules || v.died               ? VERDICT_INFEASIBLE
             : v.unmeasured || !rules->count ? VERDICT_UNJUDGED
                                             : VERDICT_FEASIBLE;
    return v;
}

/* Returns whether a rule among these bits has the label. */
static bool among(const struct rules *rules, unsigned bits, const char *label)
{
    for (int n = 0; n < rules->count; n++)
        if (bits >> n & 1 && !strcmp(rules->rule[n].label, label))
            return true;
    return false;
}

bool rules_has(const struct rules *rules, struct ruling v, const char *label)
{
    return among(rules, v.rules, label);
}

bool rules_lacks(const struct rules *rules, struct ruling v, const char *label)
{
    return among(rules, v.unmeasured, label) && !among(rules, v.rules, label);
}

/* Adds the labels of these rules, each once, the first behind `before`; none of `but`. */
static void add_labels(const struct rules *rules, unsigned bits, unsigned but,
                       const char *before, char *text, int size)
{
    for (int n = 0; n < rules->count; n++) {
        const char *label = rules->rule[n].label;
        const size_t used = strlen(text);
        if (!(bits >> n & 1) || among(rules, bits & ((1u << n) - 1), label) ||
            among(rules, but, label))
            continue;
        snprintf(text + used, (size_t)size - used, "%s%s", before, label);
        before = ", ";
    }
}

const char *rules_text(const struct rules *rules, struct ruling v, char *text, int size)
{
    snprintf(text, (size_t)size, "%s",
             v.kind == VERDICT_FEASIBLE                    ? verdict_word(v.kind)
             : v.kind == VERDICT_NONE                      ? "unsupported"
             : v.quick                                     ? verdict_word(VERDICT_QUICK)
             : v.kind == VERDICT_UNJUDGED && !rules->count ? "not judged: no rules"
             : v.died && !v.rules                          ? verdict_word(VERDICT_DIED)
                                                           : "");
    add_labels(rules, v.rules, 0, "", text, size);
    add_labels(rules, v.unmeasured, v.rules,
               *text ? "; not judged: " : "not judged: ", text, size);
    return text;
}
