/* calculix_cases.h - the jobs whose answers are stored in tests/reference/calculix_*.csv.
 */
#ifndef CALCULIX_CASES_H
#define CALCULIX_CASES_H

#include "fem_ref/calculix_deck.h"

/* On dyadic points this is exact in the deck's 13 digits. No angle stays right. */
static inline void cases_distort(double x[3])
{
    x[0] += 0.25 * x[1] * x[2] + 0.125 * x[1];
    x[1] += 0.125 * x[0] - 0.25 * x[2];
    x[2] += 0.25 * x[0] * x[1];
}

/* Matrices: name of the file, job. */
enum { CASES_MATRICES = 2 };
static const struct {
    const char *name;
    bool distorted;
} cases_matrices[CASES_MATRICES] = {{"box", false}, {"distorted", true}};

static inline struct calculix_job cases_matrix_job(int n)
{
    return (struct calculix_job){
        .task = CALCULIX_MATRICES,
        .element = CALCULIX_C3D8,
        .length = 1,
        .width = 0.75,
        .thickness = 0.125,
        .cells = {2, 2, 1},
        .young = 1e5,
        .poisson = 0.3,
        .density = 0.5,
        .place = cases_matrices[n].distorted ? cases_distort : NULL,
    };
}

/* Tips of the square cantilever under its own weight. */
enum { CASES_THICKNESSES = 6, CASES_TIPS = 2 * CASES_THICKNESSES };

static inline struct calculix_job cases_tip_job(int n)
{
    static const double thickness[] = {0.1, 0.05, 0.02, 0.01, 0.005, 0.001};
    bool quadratic = n >= CASES_THICKNESSES;
    int cells = quadratic ? 20 : 32;

    return (struct calculix_job){
        .task = CALCULIX_STATIC,
        .element = quadratic ? CALCULIX_C3D20R : CALCULIX_C3D8I,
        .length = 1,
        .width = 1,
        .thickness = thickness[n % CASES_THICKNESSES],
        .cells = {cells, cells, 1},
        .young = 1e5,
        .poisson = 0.3,
        .density = 0.5,
        .gravity = 9.81,
    };
}

/* The swing of pendulum_C0: nu = 0, uniform across the width, so one element is enough. */
static inline struct calculix_job cases_swing_job(int cells, double step)
{
    return (struct calculix_job){
        .task = CALCULIX_SWING,
        .element = CALCULIX_C3D20R,
        .length = 1,
        .width = 0.05,
        .thickness = 0.005,
        .cells = {cells, 1, 1},
        .young = 1e5,
        .density = 0.3,
        .gravity = 9.81,
        .step = step,
        .end = 0.3,
        .every = (int)(0.01 / step + 0.5),
    };
}

#endif
