/* plan.h - the plan of a sweep: which cases to run, what to read off them, how to judge and
 * draw them; or of studies, which have levels instead of cases (plan_study.h). Read from
 * YAML; every error is one sentence `file:line: ...`.
 *
 *     name: stiffness
 *     source: who wants to know
 *     scene: flag                      # a name or a path, seen from the plan's folder
 *     model: iga
 *     settings: {time.end: 3, discretization.points: [10,10,2]}     # of all cases
 *     axes:                            # every combination, the first changes slowest
 *       - {key: gamma, from: 10, to: 1e4, count: 25, scale: log, by: material.young}
 *       - {key: damping.value, values: [0.1, 0.3, 0.5]}
 *     cases:                           # each with every combination of the axes
 *       - {name: thin, sheet.thickness: 1e-3}
 *     look: 10                         # frames from one reading of the metrics to the next
 *     intersections: true              # looks for self-intersections, too
 *     keep: none                       # or snapshots: fields at the scene's snapshots
 *     time_limit: 60                   # [s] of a case; 600 unless told otherwise
 *     verdicts: [...]                  # verdict.h; or the name of the plan whose they are
 *     map: {x: gamma, y: damping.value, panel: material.poisson}
 *
 * A key is any that --set takes, or `scene`, or `model`, or one of two that stand for
 * another key: `gamma` and `young_over_density` set the key `by` (material.young unless
 * told otherwise) so that the number takes the value with all else of the case as given.
 */
#ifndef PLAN_H
#define PLAN_H

#include <stdbool.h>

#include "bench/experiment/plan_axis.h"
#include "bench/experiment/plan_study.h"
#include "bench/experiment/verdict.h"
#include "models/reader/named_file.h"

enum {
    PLAN_MAX_CASES = 100000,
    PLAN_MAX_LISTED = 10000, /* cases                                                  */
    PLAN_MAX_AXES = 16,
};

struct plan_listed {
    char *name; /* or NULL                                                      owned  */
    int line;
    struct plan_settings settings;
};

/* A point on the map that is no case: where another's result lies. */
struct plan_mark {
    char *text, *label; /* on the point; in the legend                          owned  */
    int line;
    struct plan_settings settings;
};

struct plan_map {
    char *x, *y, *panel; /* keys or measures; x NULL: no map; panel may be NULL, or
                            "name": of the listed case                          owned */
    int line;
    int mark_count;
    struct plan_mark *marks; /*                                                  owned */
};

enum plan_keep { PLAN_KEEP_NONE, PLAN_KEEP_SNAPSHOTS };

struct plan {
    char *path; /* of the file                                                   owned */
    char *text; /* the file as read                                              owned */
    char *name, *source;
    char *what; /* a line for lists, or NULL                                     owned */
    struct plan_settings settings; /* of all cases; scene and model are among them     */
    int axis_count;
    struct plan_axis *axes; /* owned                                                   */
    int listed_count;
    struct plan_listed *listed; /* owned                                               */
    int look;
    int intersections; /* 0 or 1                                                       */
    enum plan_keep keep;
    double time_limit; /* of a case [s]                                                */
    struct verdict_rules verdicts;
    struct plan_map map;
    struct plan_study base; /* what its studies have unless they say otherwise         */
    int study_count;        /* 0: it is for sweeps                                     */
    struct plan_study *studies; /* owned                                               */
    int key_count;
    const char **keys; /* every key that some case has, in the plan's order; array owned */
};

/* Where plans with names are: $CLOTHBENCH_PLANS first. The second describes those that are
 * no studies as "". */
extern const struct named_file_kind plan_kind, plan_study_kind;

/* Reads a plan as its schema has it (plan_read.h tries its values, too). STATUS_INPUT with
 * a sentence; *plan is overwritten, and all-zero on failure. Free with plan_clear, which
 * accepts all-zero. */
enum status plan_parse(const char *path, struct plan *plan, struct message *why);
void plan_clear(struct plan *plan);

/* Calls line() for every key that a plan may have, with what it may be. */
void plan_keys(void (*line)(void *context, const char *key, const char *text),
               void *context);

#endif
