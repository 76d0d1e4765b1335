#include "bench/experiment/plan.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/output.h"
#include "bench/harness/derived_key.h"

#define IN(type, member) .offset = offsetof(struct type, member)
#define ANY              .low = -1e30, .high = 1e30

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
const struct schema_key plan_axis_keys[] = {
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

enum status plan_axis_read(const struct yaml_tree *node, void *axis, struct message *why)
{
    struct axis_reading r = {.axis.line = node->line, .from = NAN, .to = NAN};
    enum status st = schema_read(plan_axis_keys, node, "an axis", &r, why);

    if (st == STATUS_OK)
        st = fill_axis(&r, node, why);
    *(struct plan_axis *)axis = r.axis;
    return st;
}

void plan_axis_clear(struct plan_axis *axis)
{
    free(axis->key);
    free(axis->by);
    plan_settings_clear(&axis->values);
    *axis = (struct plan_axis){0};
}
