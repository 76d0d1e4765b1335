/* looks.h - the moments ("looks") at which a run is measured, and the numbers measured
 * there: shared by the run and by the reading of its file. */
#ifndef LOOKS_H
#define LOOKS_H

#include <stdbool.h>

#include "bench/files/arena.h"
#include "bench/harness/measures.h"
#include "models/model.h"

/* The series, each of one number a look. */
enum {
    LOOKS_DROP,
    LOOKS_ANGLE,
    LOOKS_STRETCH,
    LOOKS_ROUGHNESS,
    LOOKS_PENETRATION,
    LOOKS_INTERSECTIONS, /* NaN: not counted                                           */
    LOOKS_SPEED, /* rms over the grid since the look before; NaN at the first    [m/s] */
    LOOKS_LOAD,  /* force of obstacles against gravity, over the weight; NaN without them */
    LOOKS_REACTION, /* size of the force of the first support; NaN without         [N] */
    LOOKS_THROUGH, /* steps so far that ended with part of an obstacle through the sheet  */
    LOOKS_SPREAD,  /* of neighbouring stretches                                          */
    LOOKS_TURN,    /* of a cell of the net [rad]; NaN: not measured                      */
    LOOKS_SERIES
};

struct looks_series {
    const char *name, *unit; /* as in result files (store.h)                           */
    double (*value)(const struct scene *scene, const double *xyz); /* NULL: not of this */
    int most, end; /* measures: the largest and the last one; < 0: none                */
};
extern const struct looks_series looks_series[LOOKS_SERIES];

struct looks {
    int count, room;
    struct arena arena;           /* of what follows                            owned  */
    double *time;                 /* [count] [s]                                       */
    double *series[LOOKS_SERIES]; /* [count]                                           */
    double *drift;                /* [count] of the energy, once it is reduced         */
    struct energy *energy;        /* [count]; NaN: the model has none                  */
};

/* Allocates room for that many looks, count 0. *looks is overwritten. */
void looks_init(struct looks *looks, int room);
void looks_clear(struct looks *looks); /* all-zero is allowed */

/* Adds a look, measured on a field (grid.h), with the crossings that were counted (NaN:
 * none were); speed, load and energy are NaN. */
void looks_add(struct looks *looks, const struct scene *scene, double time,
               const double *xyz, double crossings);

/* Counts crossings on every third point of a field: what a look of a grid costs. */
double looks_crossings(const struct scene *scene, const double *xyz);

/* Counts the crossings of the last look, measured on the field xyz, on the whole grid, if
 * they were counted and none was found: so many as users are told at the end of a run. */
void looks_recount(struct looks *looks, const struct scene *scene, const double *xyz);

/* A sweep stores these beside the series, at the looks at which a truth is known: the rms
 * distance to it and its error bar, both over the length; NaN at other looks. */
enum { LOOKS_TRUTH_ERROR, LOOKS_TRUTH_BAR, LOOKS_TRUTH };
extern const char *const looks_truth[LOOKS_TRUTH];

/* Fills the three measures of the truth from these [count] numbers. */
void looks_reduce_truth(int count, const double *error, const double *bar, double *value);

/* Computes the drift, and value[MEASURES] of a run that ended so (STATUS_OK, a death at
 * death_time, or STATUS_UNSUPPORTED) after that work (NULL: unknown); those of the truth
 * are NaN. */
void looks_reduce(struct looks *looks, const struct scene *scene, enum status outcome,
                  double death_time, const struct counters *work, double *value);

#endif
