/* plan_case.h - the cases of a plan, and the levels of its studies, one by one, as what a
 * run needs. */
#ifndef PLAN_CASE_H
#define PLAN_CASE_H

#include "bench/experiment/plan.h"
#include "bench/harness/run.h"

struct plan_case {
    long number;      /* from 0                                                       */
    const char *name; /* of the listed case, or NULL                         borrowed */
    const struct contestant *contestant;
    char *path;               /* scene file                                      owned */
    struct settings settings; /* stand-ins as what they stand for                owned */
    /* [plan->key_count] as the plan gives them; NULL: not in this case; array   owned */
    const struct plan_setting **given;
};

/* Listed cases times the values of every axis. */
long plan_case_count(const struct plan *plan);

/* Case `number`, 0 <= number < count. STATUS_INPUT with a sentence `plan:line: ...`: its
 * scene or a value is impossible. *c is all-zero on failure; free with plan_case_clear. */
enum status plan_case_open(const struct plan *plan, long number, struct plan_case *c,
                           struct message *why);
void plan_case_clear(struct plan_case *c);

/* A level of a study, for a quick run or not; NULL: what all its levels have. The same
 * errors. */
enum status plan_case_level(const struct plan *plan, const struct plan_study *study,
                            const struct plan_level *level, bool quick, struct plan_case *c,
                            struct message *why);

/* What run.h runs of a case; borrows from it. */
struct run_plan plan_case_run(const struct plan_case *c);

/* The case `number` without path, contestant and settings: what the plan says of it.
 * STATUS_MEMORY. */
enum status plan_case_given(const struct plan *plan, long number, struct plan_case *c);

/* The scene of a case. Errors as scene_file_read: plan_case_blame finds the plan's line. */
enum status plan_case_scene(const struct plan_case *c, struct scene *scene,
                            struct message *why);

/* The scene of the first case with other settings on top: of a mark on the map.
 * STATUS_INPUT with a sentence. */
enum status plan_case_mark(const struct plan *plan, const struct plan_settings *settings,
                           struct scene *scene, struct message *why);

/* Turns a sentence on a case's scene into `plan:line: ...` with the line of the setting
 * that it blames, else that of the scene. STATUS_INPUT then, or st. */
enum status plan_case_blame(const struct plan *plan, const struct plan_case *c,
                            enum status st, struct message *why);

/* The sentence `plan:line: ...`; returns STATUS_INPUT. */
enum status plan_case_refuse(const struct plan *plan, int line, struct message *why,
                             const char *format, ...) __attribute__((format(printf, 4, 5)));

/* The failure st of somebody who knows no plan, with what they said, at a line of this one:
 * STATUS_INPUT. STATUS_OK and STATUS_MEMORY as they are. */
enum status plan_case_pass(const struct plan *plan, int line, enum status st,
                           const struct message *said, struct message *why);

/* The file of a scene's name or path, a path seen from the plan's folder; *path is freed by
 * the receiver. STATUS_INPUT: no such name. */
enum status plan_case_find_scene(const struct plan *plan, const char *argument, char **path,
                                 struct message *why);

/* The key that a stand-in (derived_key.h) sets in this plan. */
const char *plan_case_set_by(const struct plan *plan, const char *key);

#endif
