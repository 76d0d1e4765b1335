/* verify_strips.h - heavy strips of nu = 0, clamped level: every model with and without its
 * cures, as the checks on the elastica judge them.
 */
#ifndef VERIFY_STRIPS_H
#define VERIFY_STRIPS_H

#include "bench/verify/verify_net.h"

/* The strips are this wide, of their length. */
#define VERIFY_STRIPS_WIDTH 0.1

struct verify_strip {
    struct verify_series nets;
    bool linear;  /* small strains                                                     */
    bool settles; /* without statics: comes to rest by damped motion, if at all        */
};

enum { VERIFY_STRIPS = 12 };
extern const struct verify_strip verify_strips[VERIFY_STRIPS];

/* Linear theory is 1 % wrong at this weight (heavy_elastica.csv, lin_err): it ends there.
 */
#define VERIFY_STRIPS_LINEAR_GAMMA 0.9

#endif
