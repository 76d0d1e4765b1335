/* spring_frequency.h - the largest natural frequency of a net about its rest shape, which
 * limits the explicit method. */
#ifndef SPRING_FREQUENCY_H
#define SPRING_FREQUENCY_H

#include "mass_spring/spring_net.h"
#include "models/mechanics/supports.h"

/* By Lanczos' method, without reorthogonalisation (the extreme value does not need it),
 * from below, in 200 steps at most. mass[nodes]; K[pairs][9] is work. 0 if nothing can
 * move. */
enum status spring_frequency_largest(const struct spring_net *net,
                                     const struct supports *supports, const double *mass,
                                     double (*K)[9], double *omega);

#endif
