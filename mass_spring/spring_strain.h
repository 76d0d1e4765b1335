/* spring_strain.h - Provot's inverse procedure (Provot 1995, section 4.2): after a step,
 * the ends of every spring that has become longer than (1 + limit) times its rest length
 * are moved together along it, each half way, or one alone if the other is held.
 *
 * Provot sweeps once and does not say what becomes of the velocities. Here sweeps go on, in
 * the order of the springs and back, until all springs keep the limit to a part in 1000 of
 * it, 1000 sweeps at most; the velocity is that of the corrected points, so that a net at
 * its limit does not gather speed.
 */
#ifndef SPRING_STRAIN_H
#define SPRING_STRAIN_H

#include "models/net/spring_net.h"
#include "models/mechanics/supports.h"

/* Moves free points of x[nodes][3]; limit > 0. */
void spring_strain_limit(const struct spring_net *net, const struct supports *supports,
                         double limit, double *x);

#endif
