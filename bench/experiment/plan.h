/* plan.h - reads a plan: which cases to run, what to read off them, how to judge and draw
 * them. It is YAML; every error is one sentence `file:line: ...`.
 * doc/studies.md shows plans, the schema in plan.c (clothbench help plan) has all keys.
 *
 * The cases of a study are all combinations of its axes, the first changing slowest. An
 * axis has labelled values, each of which sets some keys: any that --set takes, or `scene`,
 * or `model`, or one of two that stand for another key: `gamma` and `young_over_density`
 * set material.young so that the number takes the value with all else of the case as given.
 * Keys of an axis go before those of a study,
 * these before the plan's, and later axes before earlier ones.
 *
 * A plan without `studies` is one, of its own name. A study with times is one for `study`:
 * its cases are compared at these times, or at rest; the cases of others go to their
 * scene's end, in a sweep.
 */
#ifndef PLAN_H
#define PLAN_H

#include <stdbool.h>

#include "bench/experiment/rules.h"
#include "bench/files/arena.h"
#include "bench/harness/run.h"
#include "models/reader/named_file.h"
#include "models/reader/schema.h"

enum {
    PLAN_MAX_CASES = 100000,
    PLAN_TABLE_COLUMNS = 16,
};

/* --- Settings: keys and values as a plan gives them, with their lines. */

struct plan_setting {
    char *key, *value; /* as --set takes them: KEY=VALUE                         owned */
    int line;          /* in the plan                                                  */
};

struct plan_settings {
    int count;
    struct plan_setting *list; /* owned                                                */
};

/* Returns the setting of a key; NULL if there is none. */
const struct plan_setting *plan_settings_find(const struct plan_settings *settings,
                                              const char *key);

/* --- Axes and studies. */

enum {
    PLAN_AXIS_MOST = 10000, /* values                                                   */
    PLAN_STUDY_MOST = 100,
    PLAN_READINGS = 8,       /* of a statement                                          */
    PLAN_STUDY_LEVELS = 128, /* of which an exponent or an order is one                 */
    PLAN_STUDY_TIMES = 8,
    PLAN_STUDY_AXES = 8,
};

/* A value of an axis, or a product of such. */
struct plan_level {
    struct arena *arena; /* in which all of the plan lies                   borrowed */
    char *label;     /* short, for tables and pages                             owned  */
    char *name;      /* of its file, [a-z0-9_]+; made of the label if not given  owned  */
    double size;     /* mesh width, step, ...: observed orders are over it; 0: none     */
    double paper_ms; /* what somebody else's frame costs; NaN: unknown                  */
    int phases;      /* 1: a solid that is rebuilt every frame: time its phases, too    */
    struct plan_settings settings;
    struct plan_settings quick; /* on top of them in a quick run                       */
    int timed; /* repeats; 0: not timed; -1: as the study has it                       */
    bool slow; /* a quick run leaves it out                                            */
    /* The levels that it is the product of, one on each axis of its study; borrowed.
       Their settings are its settings. */
    const struct plan_level *part[PLAN_STUDY_AXES];
    int line;
};

struct plan_axis {
    char *name; /* of listed values and of ranges the key that they are of      owned  */
    int count;
    struct plan_level *levels; /* [count]                                         owned */
    int line;
};

/* Some products: the levels that have, on each axis that is named here, one of the labels
 * given for it. The axis "study" has the names of studies as labels. */
struct plan_product {
    struct arena *arena; /* in which all of the plan lies                   borrowed */
    struct plan_settings labels; /* axis and label; several of an axis are alternatives  */
    int quick;       /* of skip: only a quick run leaves them out                      */
    double paper_ms; /* of paper: what somebody else's frame costs                     */
};
struct plan_products {
    int count;
    struct plan_product *list; /* owned                                                */
};

/* The truth that a study is held against: none, the scene's (truth.h), or the Kirchhoff
 * plate, which is that of linear kinematics, at rest, too. */
enum plan_truth { PLAN_TRUTH_NONE, PLAN_TRUTH_SCENE, PLAN_TRUTH_PLATE };

struct plan_study {
    struct arena *arena; /* in which all of the plan lies                   borrowed */
    char *name;    /* of its files, [a-z0-9_]+                                  owned  */
    char *caption; /* of its tables                                             owned  */
    struct plan_settings settings;
    int level_count;
    struct plan_level *levels; /* [level_count], products of the axes           owned  */
    int axis_count;
    struct plan_axis axis[PLAN_STUDY_AXES];
    int time_count;  /* 0: static equilibrium, as the only frame; -1: a sweep's    */
    double *times;   /* [time_count] [s]                                        owned  */
    int quick_count; /* 0: a quick run has the same times                          */
    double *quick_times;  /* [quick_count] [s]                                  owned  */
    int truth;            /* enum plan_truth                                       */
    int timed;            /* repeats; 0: not timed                                 */
    int line, times_line; /* in the plan                                           */
};

/* --- The plan. */

/* One table of all studies, a row for each level and time. */
struct plan_table {
    struct plan_settings columns; /* names of quantities (results.h), as keys; none: a
                                     plan's studies are printed one by one (study.h)   */
    int last;                     /* 1: people see the last time of each study alone   */
    struct plan_settings shown;   /* axis and label: people see levels with these alone */
    char *note;                   /* below it, or NULL                         owned */
};

/* A chart of all studies, both axes logarithmic: quantities at the last time over another,
 * or over the size of levels; those that have none are not in it. */
struct plan_chart {
    char *x; /* the quantity, or in words what the size is; NULL: no chart       owned */
    double from; /* it shows how far the quantities are from this; NaN: themselves     */
    struct plan_settings y, panel, line; /* quantities; axes whose labels have one
                                            each, as keys                              */
};

/* A statement of the paper that is a ratio of two times or an exponent of one, and the ways
 * to read what it leaves open: labels of the rows that decide it (results.h). */
struct plan_reading {
    struct arena *arena; /* in which all of the plan lies                   borrowed */
    char *name;          /* in a few words                                owned   */
    char *why;           /* it is the primary one; or NULL                owned   */
    struct plan_settings rows; /* axis and label                                        */
    int ours;                  /* no reading: what we would do instead, shown beside    */
};
struct plan_statement {
    struct arena *arena;   /* in which all of the plan lies                   borrowed */
    char *quote, *section; /* in our words; of the paper                        owned   */
    struct plan_settings quantity; /* as keys: of a ratio one, of an exponent x and y   */
    struct plan_settings row[2];   /* of a ratio; an exponent's rows are row[0]         */
    bool exponent;
    double paper;
    int reading_count; /* 0: nothing is open                                            */
    struct plan_reading *readings; /* owned                                             */
    int line;
};

enum plan_keep { PLAN_KEEP_NONE, PLAN_KEEP_SNAPSHOTS };

struct plan {
    struct arena *arena; /* of all that it has                                   owned */
    char *path; /* of the file                                                   owned */
    char *text; /* the file as read                                              owned */
    char *name, *source;
    char *what; /* a line for lists, or NULL                                     owned */
    struct plan_settings settings; /* of all cases; scene and model are among them     */
    int look; /* frames from one reading of the metrics to the next                     */
    int intersections; /* 0 or 1                                                       */
    enum plan_keep keep;
    double time_limit; /* of a case [s]                                                */
    struct rules verdicts;
    int study_count;
    struct plan_study *studies; /* owned                                               */
    struct plan_products skip, paper;
    int statement_count;
    struct plan_statement *statements; /* owned                                         */
    struct plan_settings reference;    /* axis and label: cases are compared with the one of
                                          their study that has these and else their own   */
    struct plan_table table;
    struct plan_chart chart;
    int key_count;
    const char **keys; /* every key that some case has, in the plan's order; array owned */
};

/* The places of plans with names: $CLOTHBENCH_PLANS first. The second kind describes plans
 * that are no studies as "". */
extern const struct named_file_kind plan_kind, plan_study_kind;

/* Reads a plan as its schema has it. STATUS_INPUT with a sentence; *plan is overwritten,
 * and all-zero on failure. Free with plan_clear, which accepts all-zero. */
enum status plan_parse(const char *path, struct plan *plan, struct message *why);
void plan_clear(struct plan *plan);

/* Calls line() for every key that a plan may have, with what it may be. */
void plan_keys(void (*line)(void *context, const char *key, const char *text),
               void *context);

/* Reads a plan that can be run: plan->keys, no more cases than PLAN_MAX_CASES, and every
 * value good in some case. Errors as plan_parse. */
enum status plan_read(const char *path, struct plan *plan, struct message *why);

/* Returns whether the plan is for `study`, with times, not for `sweep`. */
bool plan_is_study(const struct plan *plan);

/* Returns the label of a level on an axis, also on "study" and "caption"; NULL: its study
 * has no such axis. */
const char *plan_label(const struct plan_study *study, const struct plan_level *level,
                       const char *axis);

/* Returns the level that has these labels and else those of `level`; -1: there is none. */
int plan_level_with(const struct plan_study *study, const struct plan_level *level,
                    const struct plan_settings *labels);

/* --- Cases one by one, as what a run needs (plan_case.c). */

struct plan_case {
    const struct plan_study *study; /*                                        borrowed */
    const struct plan_level *level; /* NULL: what all levels of the study have          */
    struct case_plan run; /* stand-ins among its settings as what they stand for owned */
    /* [plan->key_count] as the plan gives them; NULL: not in this case; in run's arena  */
    const struct plan_setting **given;
};

/* Returns the number of cases of all studies. */
long plan_case_count(const struct plan *plan);

/* Opens a level of a study, for a quick run or not; NULL: with what all its levels have.
 * STATUS_INPUT with a sentence `plan:line: ...`: its scene or a value is impossible. *c is
 * all-zero on failure; free with plan_case_clear. */
enum status plan_case_level(const struct plan *plan, const struct plan_study *study,
                            const struct plan_level *level, bool quick, struct plan_case *c,
                            struct message *why);

void plan_case_clear(struct plan_case *c);

/* Returns the plan's words for a key of a level; NULL: it has none. */
const char *plan_case_words(const struct plan *plan, const struct plan_study *study,
                            const struct plan_level *level, const char *key);

/* Reads the scene of a case. Errors as scene_file_read: plan_case_blame finds the plan's
 * line. */
enum status plan_case_scene(const struct plan_case *c, struct scene *scene,
                            struct message *why);

/* Turns a sentence on a case's scene into `plan:line: ...` with the line of the setting
 * that it blames, else that of the scene. STATUS_INPUT then, or st. */
enum status plan_case_blame(const struct plan *plan, const struct plan_case *c,
                            enum status st, struct message *why);

/* Writes the sentence `plan:line: ...`; returns STATUS_INPUT. */
enum status plan_case_refuse(const struct plan *plan, int line, struct message *why,
                             const char *format, ...) __attribute__((format(printf, 4, 5)));

/* Passes on a failure st with its sentence as one at a line of this plan: STATUS_INPUT.
 * STATUS_OK and STATUS_MEMORY stay as they are. */
enum status plan_case_pass(const struct plan *plan, int line, enum status st,
                           const struct message *said, struct message *why);

/* Finds the file of a scene's name or path, a path seen from the plan's folder; *path is
 * freed by the receiver. STATUS_INPUT: no such name. */
enum status plan_case_find_scene(const struct plan *plan, const char *argument, char **path,
                                 struct message *why);

#endif
