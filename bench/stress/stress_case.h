/* stress_case.h - the hard cases, as data: a scene, what is hard, the truth, the bound. */
#ifndef STRESS_CASE_H
#define STRESS_CASE_H

#include "bench/harness/contestant.h"
#include "bench/ui/command.h"

/* What the error of a case is measured against, and how: code, judge, a sentence. */
#define STRESS_TRUTH_LIST(X)                                                               \
    X(PLATE, plate, "tip at rest against the Kirchhoff plate (Ritz), relative")            \
    X(ELASTICA, elastica, "tip at rest against the heavy elastica, over L")                \
    X(VIBRATION, vibration,                                                                \
      "tip in time against the Kirchhoff plate's modal solution, over its greatest "       \
      "deflection")                                                                        \
    X(SIMILAR, similar,                                                                    \
      "against the model's own motion in metres, kilograms and seconds, RMSE over L")      \
    X(ENERGY, energy, "drift of the sum of energies, over the energy in play")             \
    X(BUCKLED, buckled, "middle against Euler's elastica, over L")                         \
    X(STILL, still, "motion where there should be none, RMSE over L")                      \
    X(STILL_REST, still_rest, "motion away from the model's own equilibrium, RMSE over L") \
    X(SHIFTED, shifted, "where it comes to rest, RMSE over L")                             \
    X(SHELL, shell, "against a finer nonlinear shell, RMSE over L")

enum stress_truth {
#define STRESS_TRUTH_CODE(code, name, text) STRESS_##code,
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
    double gamma;                          /* sets E; 0: left as it is                  */
    const char *physics[STRESS_SETTINGS];  /* KEY=VALUE on stress_case_scene; NULL ends  */
    const char *numerics[STRESS_SETTINGS]; /* the same, of every contestant            */
    int side;            /* points a side of nets; 0: 10; 1: one element             */
    double weight_ratio; /* NURBS weights: of every other row to the rest; 0: none     */
    double length, mass, time; /* SIMILAR: the other units in ours [m], [kg], [s]      */
    double bound;              /* of the error, to be accurate                         */
    const char *why;           /* that bound                                           */
    bool quick;                /* part of --quick                                      */
    const char *quick_end;     /* setting of time.end then; NULL: as ever              */
};

extern const char *const stress_case_scene; /* what all cases start from, by name */
/* The command's words: the map, then the cases; ends with NULL. */
extern const struct command_item *const stress_case_items[];

/* Case n = 0, 1, ...; NULL past the last. */
const struct stress_case *stress_case_at(int n);

/* A contestant on a case. */
struct stress_job {
    const struct stress_case *c;         /*                            borrowed */
    const struct contestant *contestant; /*                            borrowed */
    const char *path;   /* of stress_case_scene's file                          borrowed */
    const char *folder; /* for truths that are kept                             borrowed */
    bool quick;
};

#endif
