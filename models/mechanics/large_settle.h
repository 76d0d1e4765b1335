/* large_settle.h - a body at large displacements comes to rest, among obstacles and where
 * it snaps to a shape far off (large_rest.h). */
#ifndef LARGE_SETTLE_H
#define LARGE_SETTLE_H

#include "models/mechanics/large_motion.h"

/* Of the loads and what supports bear: forces that stress, supports and obstacles leave
 * unbalanced, summed over nodes as lengths, in what is called rest. */
extern const double LARGE_SETTLE_RESIDUAL;

/* Moves m->x, any shape with held unknowns where they shall be, to equilibrium: backward
 * Euler steps that forget their velocity go downhill, under contact and friction as in
 * motion (contact_solve.h), in steps that grow while they succeed (pseudo-transient
 * continuation; Kelley, Keyes 1998). That is a slow lowering of the sheet: which of many
 * equilibria friction holds is that of this way. The end is judged by the state alone: no
 * more than LARGE_SETTLE_RESIDUAL of the loads is unbalanced by forces that obstacles may
 * have (contact_set_balance). m->push are their reactions. STATUS_DIVERGED, with what is
 * left in a sentence, if there is no such state within the budget: a sheet that slides off
 * and falls has none. On success *why tells of it, too. */
enum status large_settle(struct large_motion *m, struct counters *counters,
                         struct message *why);

#endif
