/* large_settle.h - brings a body at large displacements to rest, among obstacles and where
 * it snaps to a shape far off (large_rest.h). */
#ifndef LARGE_SETTLE_H
#define LARGE_SETTLE_H

#include "models/mechanics/large_motion.h"

/* Moves m->x, any shape with held unknowns where they shall be, to equilibrium: backward
 * Euler steps that forget their velocity go downhill, under contact and friction as in
 * motion (contact.h), in steps that grow while they succeed (pseudo-transient continuation;
 * Kelley, Keyes 1998). That is a slow lowering of the sheet: which of many equilibria
 * friction holds is that of this way. At the end no more than 1e-6 of the loads and support
 * reactions is left unbalanced, summed over nodes as lengths, the friction of what slips
 * faster than `creep` added; what friction holds creeps as contact_law.h says. The pressure
 * has no rate here. m->push is the force of bodies. It may
 * be an unstable state where symmetry leads to one: large_rest_modes tells.
 * STATUS_DIVERGED, with what is left in a sentence, if there is no such state within the
 * budget: a sheet that slides off and falls has none. On success *why tells of it, too.
 */
enum status large_settle(struct large_motion *m, struct counters *counters,
                         struct message *why);

#endif
