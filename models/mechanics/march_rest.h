/* march_rest.h - static equilibrium of a body at large displacements (march.h). */
#ifndef MARCH_REST_H
#define MARCH_REST_H

#include "models/mechanics/march.h"

/* Moves m->x to equilibrium under the loads; v and a become zero. The load grows from
 * nothing, supports going to their shift of time 0, the next shape guessed along the last
 * two; where that leads nowhere (a sheet that hangs from a hinge has no stiffness at
 * first), by pseudo-transient continuation. Then supports that move go along their paths up
 * to the scene's end, in increments that are shortened until a stable shape stays stable: a
 * shape that is pressed past a limit snaps to a stable one where Newton's method finds it,
 * or by steps downhill. (An arc length would trace the unstable way
 * between, which nothing takes.) A strip that is pressed straight has no such increment:
 * what shall buckle needs a load, however small, that says to which side. Among obstacles
 * all is left to those steps, and *why tells of it on success, too. STATUS_INPUT without
 * supports; deaths with a sentence.
 *
 * The steps downhill are backward Euler's that forget their velocity, under contact and
 * friction as in motion (contact.h), and grow while they succeed (pseudo-transient
 * continuation; Kelley, Keyes 1998). That is a slow lowering of the sheet: which of many
 * equilibria friction holds is that of this way. At the end no more than 1e-6 of the loads
 * and support reactions is left unbalanced, summed over nodes as lengths, the friction of
 * what slips faster than `creep` added; what friction holds creeps as contact_law.h says.
 * The pressure has no rate here. m->push is the force of bodies. It may be an unstable
 * state where symmetry leads to one: march_rest_modes tells. STATUS_DIVERGED, with what is
 * left in a sentence, if there is no such state within the budget: a sheet that slides off
 * and falls has none. */
enum status march_rest_equilibrium(struct march *m, struct counters *counters,
                                   struct message *why);

/* Moves m->x to the equilibrium of a linear body: solves K d = load and refines d once,
 * which measures the digits left: STATUS_INDEFINITE, with a sentence, if fewer than two. */
enum status march_rest_linear(struct march *m, struct counters *counters,
                              struct message *why);

/* Finds model.h's modes about m->x: of its tangent, stress included. Nodes that an obstacle
 * carries may move along it, with the ball's curvature against them, unless friction has
 * strength left: then they stay, by stiff springs, whose own modes appear where nothing
 * else moves. */
enum status march_rest_modes(struct march *m, int count, double *omega,
                             struct message *why);

#endif
