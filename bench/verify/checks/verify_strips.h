/* verify_strips.h - heavy strips of nu = 0, clamped at one end, as the checks on the
 * elastica judge them: who, and the worst of several loads.
 */
#ifndef VERIFY_STRIPS_H
#define VERIFY_STRIPS_H

#include "bench/verify/verify_check.h"

/* The strips are this wide, of their length. */
#define VERIFY_STRIPS_WIDTH 0.1

/* Linear theory is 1 % wrong at this weight (heavy_elastica.csv, lin_err): it ends there.
 */
#define VERIFY_STRIPS_LINEAR_GAMMA 0.9

extern const struct verify_field verify_strips;

/* A load and where the truth has the tip: out of level, and along, as the check has it. */
struct verify_strips_load {
    double load, out, along;
};

/* On one net: what is shown, and the tip's distance from the truth, of `out`. */
typedef void verify_strips_measure(struct verify_trial *t,
                                   const struct verify_strips_load *load, double *out,
                                   double *error);

/* Loads 0, every, 2 every, ...: the worst of them is judged. NULL: all lived, or the load
 * at which one did not. */
const struct verify_strips_load *
verify_strips_worst(struct verify_trial *t, verify_strips_measure *measure, int count,
                    const struct verify_strips_load *load, int every, double bar);

#endif
