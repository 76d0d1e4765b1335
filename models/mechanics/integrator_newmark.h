/* integrator_newmark.h - steps of M a + C v + K d = f by Newmark's average acceleration
 * (beta = 1/4, gamma = 1/2; Newmark 1959; Ren et al. 2024, eq. 18-19), C = alpha M + beta
 * K, whose K is constant.
 *
 * The paper solves (M + dt^2/4 K) a = f - K (d + dt v + dt^2/4 a_old). With the predictor
 * p = d + dt v + dt^2/4 a_old the same equation reads (M + c K)(a + p/c) = f + M p/c,
 * c = dt^2/4: a product with M (a ninth of the numbers) in place of one with K.
 */
#ifndef INTEGRATOR_NEWMARK_H
#define INTEGRATOR_NEWMARK_H

#include "models/mechanics/march.h"

/* Return the factors of K and M in the step's system: k K + m M. */
double integrator_newmark_k(const struct march *m);
double integrator_newmark_m(const struct march *m);

/* Takes a step; the system holds the factor of k K + m M. `held` NULL: held unknowns stay.
 */
enum status integrator_newmark_step(struct march *m, const struct march_held *held,
                                    struct counters *counters);

/* Adds `share` of the forces of supports at the present d, v and a, by the step's equation.
 */
void integrator_newmark_weigh(struct march *m, double share);

#endif
