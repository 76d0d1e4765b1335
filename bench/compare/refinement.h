/* refinement.h - the steps on which `compare` sets each contestant: nets, time steps,
 * iterations, from cheap to dear, as its row of the table has them.
 */
#ifndef REFINEMENT_H
#define REFINEMENT_H

#include "bench/harness/contestant.h"

struct refinement {
    const struct contestant *contestant;
    int side;       /* points along u and v                                            */
    int divisor;    /* the scene's frame is divided into so many steps                 */
    int iterations; /* local-global iterations, 0: the model has none                  */
};

/* All of a choice (contestant_chosen), model by model. *all is freed by the receiver.
 * STATUS_INPUT with a sentence for an unknown name. `quick` leaves out the dear half. */
enum status refinement_make(const char *choice, bool quick, struct refinement **all,
                            int *count, struct message *why);

/* What it is made of, for a scene with frames of `frame` seconds. */
void refinement_settings(const struct refinement *r, double frame, struct settings *s);

#endif
