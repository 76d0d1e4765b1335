/* stress.h - hard cases, for every contestant: thin to h/L = 1e-5, nearly incompressible,
 * steps of 0.1 s, nets of one element, other units, ten thousand steps, bodies that press,
 * stop and have needles, ... A contestant's
 * run of a case ends in exactly one of four ways, never in silence:
 *
 *   accurate   it ran, and its error is within the case's bound
 *   degraded   it ran, and its error is beyond that
 *   refused    it said in a sentence why it will not
 *   died       at a time and for a cause: numerical death, crash, or time limit
 *
 * The error is against a truth that the case names; the bound is one number a case, the
 * same for every contestant. Each run is a process of its own (pool.h). All runs together
 * leave FOLDER/stress.csv, a row each; tables are printed from it alone.
 */
#ifndef STRESS_H
#define STRESS_H

#include "bench/experiment/kept.h"
#include "bench/harness/contestant.h"
#include "bench/truth/truth.h"
#include "bench/ui/command.h"

/* --- Cases. */

/* The truths against which errors are measured, and how. */
#define STRESS_TRUTH_LIST(X)                                                               \
    X(PLATE, "tip at rest against the Kirchhoff plate (Ritz), relative")                   \
    X(ELASTICA, "tip at rest against the heavy elastica, over L")                          \
    X(VIBRATION,                                                                           \
      "tip in time against the Kirchhoff plate's modal solution, over its greatest "       \
      "deflection")                                                                        \
    X(SIMILAR,                                                                             \
      "against the model's own motion in metres, kilograms and seconds, RMSE over L")      \
    X(ENERGY, "drift of the sum of energies, over the energy in play")                     \
    X(BUCKLED, "middle against Euler's elastica, over L")                                  \
    X(STILL, "motion where there should be none, RMSE over L")                             \
    X(STILL_REST, "motion away from the model's own equilibrium, RMSE over L")             \
    X(SHIFTED, "where it comes to rest, RMSE over L")                                      \
    X(SHELL, "against a finer nonlinear shell, RMSE over L")                               \
    X(CONTACT,                                                                             \
      "way into the distance at which contact with a body starts, over twice that; more "  \
      "than half: through it or itself")                                                   \
    X(SLIDE, "mean way along the plane against the rigid block's, over L; and as above")

enum stress_truth {
#define STRESS_TRUTH_CODE(code, text) STRESS_##code,
    STRESS_TRUTH_LIST(STRESS_TRUTH_CODE)
#undef STRESS_TRUTH_CODE
        STRESS_TRUTHS
};
extern const char *const stress_truth_text[STRESS_TRUTHS];

enum { STRESS_SETTINGS = 8 };

struct stress_case {
    struct command_item item; /* name [a-z0-9_]+, and what is hard; first: items of the
                                 command are pointers to these                         */
    enum stress_truth truth;
    double gamma;                          /* sets E; 0: the scene's                      */
    const char *physics[STRESS_SETTINGS];  /* KEY=VALUE on stress_case_scene; NULL ends   */
    const char *numerics[STRESS_SETTINGS]; /* the same, of every contestant               */
    int side;            /* points a side of nets; 0: 10; 1: one element                  */
    double weight_ratio; /* NURBS weights: of every other row to the rest; 0: none        */
    int needles;         /* triangles of a double cone under the sheet; 0: no such body;
                            negative: as many, and one whose corners are on a line             */
    double length, mass, time; /* SIMILAR: the other units in ours [m], [kg], [s]         */
    double bound;              /* largest error of an accurate run                        */
    const char *why;           /* reason for the bound                                    */
    bool quick;                /* part of --quick                                         */
};

extern const char *const stress_case_scene; /* name of the scene that all start from      */
/* The command's words; ends with NULL. */
extern const struct command_item *const stress_case_items[];

/* Returns case n = 0, 1, ...; NULL past the last. */
const struct stress_case *stress_case_at(int n);

/* --- Results. */

enum stress_end {
    STRESS_ACCURATE,
    STRESS_DEGRADED,
    STRESS_REFUSED,
    STRESS_DIED,
    STRESS_ENDS
};
extern const char *const stress_end_name[STRESS_ENDS]; /* "accurate", ... */

struct stress_result {
    enum stress_end end;
    double error;   /* NaN unless it ran                                                  */
    double time;    /* of death, or until when the error was within the bound; NaN [s]    */
    double seconds; /* of processor time                                                  */
    struct message sentence; /* why it refused or died; remarks                           */
};

/* Returns the end of a run that was not refused and has this error: one that is no number
 * is a death. */
enum stress_end stress_result_end(double error, double bound);

/* --- Jobs: a contestant on a case. */

struct stress_job {
    const struct stress_case *c;         /*                            borrowed           */
    const struct contestant *contestant; /*                            borrowed           */
    const char *path;   /* of stress_case_scene's file                 borrowed           */
    const char *folder; /* for truths that are kept                    borrowed           */
    struct stress_result *result; /* where its process leaves it       borrowed           */
};

/* Runs one job in this process: refusals and deaths are results. Anything
 * but STATUS_OK is the harness's own failure. */
enum status stress_judge(const struct stress_job *job, struct stress_result *r,
                         struct message *why);

/* --- The choice of the user. */

struct stress_choice {
    int word_count;
    const char *const *words; /* names of cases; 0 of them: all                           */
    const char *models;       /* contestant_chosen; NULL: all that enter here             */
    bool quick;               /* of all cases, the quick ones                             */
};

bool stress_choice_case(const struct stress_choice *choice, const struct stress_case *c);

/* Returns the chosen contestant after `last`, the first after NULL; NULL: no more. */
const struct contestant *stress_choice_next(const struct stress_choice *choice,
                                            const struct contestant *last);

/* Returns STATUS_INPUT with a sentence if there is no such case or contestant. */
enum status stress_choice_check(const struct stress_choice *choice, struct message *why);

/* --- Output. */

/* Writes FOLDER/stress.csv, the results of the jobs. STATUS_FILE. */
enum status stress_save(const char *folder, long count, const struct stress_job *jobs,
                        struct message *why);

/* Prints the tables of the chosen results in FOLDER/stress.csv. STATUS_FILE: there is none;
 * STATUS_INPUT: it has no row of these. */
enum status stress_print(const char *folder, const struct stress_choice *choice,
                         const struct printer *p, struct message *why);

#endif
