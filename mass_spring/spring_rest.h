/* spring_rest.h - static equilibrium of a net: the least energy, the loads' included. */
#ifndef SPRING_REST_H
#define SPRING_REST_H

#include "mass_spring/spring_motion.h"

/* Implements model.h's equilibrium for a struct spring_motion: moves the net from its
 * present positions, supports at their shift of time 0, to rest; velocity and time become
 * zero. Steps of implicit Euler from rest, one Newton iteration each, with time steps that
 * grow while the energy falls: a flat sheet across its load has almost no stiffness, and
 * plain Newton leaps. With the true Jacobian where it is positive definite, the clamped one
 * elsewhere. STATUS_INPUT without supports, STATUS_DIVERGED (with sentence) if the residual
 * force stays above a 1e-8 part of the load and points still move after 5000 iterations. */
enum status spring_rest_equilibrium(void *motion, struct counters *counters,
                                    struct message *why);

#endif
