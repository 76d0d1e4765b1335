/* verify_strips.h - heavy strips of nu = 0, clamped at one end: whom the checks on the
 * elastica judge, and the worst of several loads. */
#ifndef VERIFY_STRIPS_H
#define VERIFY_STRIPS_H

#include "bench/verify/verify_check.h"

#define VERIFY_STRIPS_WIDTH 0.1 /* over the length */

/* Weight at which linear theory is 1 % wrong (heavy_elastica.csv, lin_err). */
#define VERIFY_STRIPS_LINEAR_GAMMA 0.9

extern const struct verify_field verify_strips;

/* Computes on one net, in the case s->at, where the tip is, out of level and along. */
typedef void verify_strips_measure(struct verify_trial *t, double at[2]);

/* Judges the worst of the cases s->at, s->at + every .. last, by the distance from the
 * truth, which stands in two columns, over the first of them. False: case s->at died. */
bool verify_strips_worst(struct verify_trial *t, struct verify_subject *s,
                         verify_strips_measure *measure, int last, int every,
                         const char *const truth[2], double bar);

#endif
