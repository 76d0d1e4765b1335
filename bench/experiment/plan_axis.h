/* plan_axis.h - one axis of a plan: a key and its values, listed or from ... to. */
#ifndef PLAN_AXIS_H
#define PLAN_AXIS_H

#include "bench/experiment/plan_settings.h"
#include "models/reader/schema.h"

enum { PLAN_AXIS_MOST = 10000 }; /* values */

enum plan_axis_scale { PLAN_AXIS_LINEAR, PLAN_AXIS_LOG };

struct plan_axis {
    char *key; /* owned                                                                */
    char *by;  /* the key that a stand-in sets; NULL: material.young             owned */
    int line;  /* in the plan                                                          */
    enum plan_axis_scale scale;  /* of from ... to, and of the map                     */
    struct plan_settings values; /* each with the axis's key                           */
};

/* Of an axis, for the list of a plan's keys. */
extern const struct schema_key plan_axis_keys[];

/* Reads `{key: ..., values: [...]}` or `{key: ..., from: ..., to: ..., count: ...}` into
 * the struct plan_axis, which is overwritten; free it with plan_axis_clear after a failure,
 * too. STATUS_INPUT with one sentence `origin:line: ...`. */
enum status plan_axis_read(const struct yaml_tree *node, void *axis, struct message *why);
void plan_axis_clear(struct plan_axis *axis); /* all-zero is allowed */

#endif
