/* plan_study.h - the studies of a plan: scenes at several levels of one parameter, from
 * coarse to fine.
 *
 *     what: a line on it, for lists
 *     levels:
 *       - {label: 5x5x2, size: 0.33, settings: {discretization.points: [5,5,2]}}
 *       - {label: 9x9x2, size: 0.14, settings: {discretization.points: [9,9,2]}}
 *     times: [0.5, 1]      # [s] at which sheets are compared; none: at rest
 *     truth: true          # hold them against the scene's truth (truth.h), with its bar
 *     timed: 9             # milliseconds a frame, from so many interleaved repeats
 *     studies:             # each with the plan's levels, times, ... unless it has its own
 *       - {name: edge, caption: ..., scene: edge_drop, settings: {...}}
 *       - {name: corners, scene: corners_drop, times: [0.25]}
 *
 * Without `studies` the plan is one, of its own name. Settings of a level go before those
 * of a study, these before the plan's.
 */
#ifndef PLAN_STUDY_H
#define PLAN_STUDY_H

#include "bench/experiment/plan_settings.h"
#include "models/reader/schema.h"

enum { PLAN_STUDY_MOST = 100, PLAN_STUDY_LEVELS = 16, PLAN_STUDY_TIMES = 8 };

struct plan_level {
    char *label;     /* short, for tables and pictures                          owned  */
    char *name;      /* of its file, [a-z0-9_]+; made of the label if not given  owned  */
    double size;     /* mesh width, step, ...: observed orders are over it; 0: none     */
    double paper_ms; /* what somebody else's frame costs; NaN: unknown                  */
    int phases;      /* 1: a solid that is rebuilt every frame: time its phases, too    */
    struct plan_settings settings;
    struct plan_settings quick; /* on top of them in a quick run                       */
    int line;
};

struct plan_study {
    char *name;    /* of its files, [a-z0-9_]+                                  owned  */
    char *caption; /* of its tables                                             owned  */
    struct plan_settings settings;
    int level_count;
    struct plan_level *levels; /* [level_count]; as times owned, unless the plan's */
    int time_count;            /* 0: static equilibrium, as the only frame; -1: not given */
    double *times;             /* [time_count] [s]                                       */
    int quick_count;           /* 0: a quick run has the same times                     */
    double *quick_times;
    int truth;            /* 0 or 1; -1: not given                                 */
    int timed;            /* repeats; 0: not timed; -1: not given                  */
    double paper_ms;      /* of its levels that have none of their own; NaN        */
    char *paper_net;      /* how somebody else writes degree and net       owned  */
    int line, times_line; /* in the plan                                           */
};

/* What a plan may have of these, too, read into the struct plan_study that begins `at`
 * bytes into the target: rows of a schema. */
/* clang-format off */
#define PLAN_STUDY_TIMES_AT(at, values, count)                                             \
    SCHEMA_NUMBERS, .low = 0, .high = 1e9, .open = true, .order = SCHEMA_INCREASING,       \
    .most = PLAN_STUDY_TIMES, .offset = (at) + offsetof(struct plan_study, values),        \
    .count_offset = (at) + offsetof(struct plan_study, count)
#define PLAN_STUDY_KEYS(at)                                                                \
    {"levels", "from coarse to fine", SCHEMA_SPECIAL, .keys = plan_study_level_keys,       \
     .read = plan_study_read_levels, .low = 1, .most = PLAN_STUDY_LEVELS, .offset = (at),  \
     .want = "a list of 1 to 16 levels {label: ..., settings: {KEY: VALUE, ...}}"},        \
    {"times", "at which sheets are compared [s]",                                          \
     PLAN_STUDY_TIMES_AT(at, times, time_count)},                                          \
    {"quick_times", "instead of them in a quick run [s]",                                  \
     PLAN_STUDY_TIMES_AT(at, quick_times, quick_count)},                                   \
    {"truth", "errors against the scene's truth", SCHEMA_WORD,                             \
     .word = plan_settings_truth, .offset = (at) + offsetof(struct plan_study, truth)},    \
    {"timed", "repeats of the milliseconds a frame", SCHEMA_COUNT, .low = 0, .high = 1000, \
     .offset = (at) + offsetof(struct plan_study, timed)}
/* clang-format on */

extern const struct schema_key plan_study_keys[], plan_study_level_keys[];

/* A reader of schema.h, into the struct plan_study at key->offset. */
enum status plan_study_read_levels(const struct schema_key *key,
                                   const struct yaml_tree *node, void *target,
                                   struct message *why);

/* Nothing given yet. */
struct plan_study plan_study_none(void);

/* Reads one of the list `studies` into the struct plan_study, which is overwritten; free it
 * with plan_study_clear after a failure, too. STATUS_INPUT with one sentence. */
enum status plan_study_read(const struct yaml_tree *node, void *target,
                            struct message *why);

/* Fills in from `base` what a study does not have; what is given nowhere is none. */
enum status plan_study_inherit(struct plan_study *study, const struct plan_study *base);

/* `base`: of its plan. All-zero is allowed. */
void plan_study_clear(struct plan_study *study, const struct plan_study *base);

#endif
