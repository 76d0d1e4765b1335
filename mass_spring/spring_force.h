/* spring_force.h - energy, force and Jacobian of a net at positions x[nodes][3].
 *
 * A spring of stiffness k and rest length r has the energy k (l - r)^2 / 2 and the second
 * derivative k ((1 - r/l) I + (r/l) n n'), whose transverse part is negative when it is
 * compressed. A hinge has P (|e1| + |e2| - |e1 + e2|).
 */
#ifndef SPRING_FORCE_H
#define SPRING_FORCE_H

#include "models/net/spring_net.h"

/* Returns elastic energy [J]; zero at rest up to round-off. */
double spring_force_energy(const struct spring_net *net, const double *x);

/* Adds the force -dE/dx [N] to f[nodes][3]. */
void spring_force_add(const struct spring_net *net, const double *x, double *f);

/* Computes K = d2E/dx2 [N/m], K[pairs of net->graph][9]. */
void spring_force_jacobian(const struct spring_net *net, const double *x, double (*K)[9]);

/* Computes a positive semi-definite matrix near it: per spring the negative transverse part
 * is clamped to zero; per hinge the second derivative of the straight hinge at rest, the
 * same in all directions, which does not depend on x: `hinges`, a number a pair of the
 * graph, from spring_force_hinges [N/m]. */
void spring_force_clamped(const struct spring_net *net, const double *x,
                          const double *hinges, double (*K)[9]);
void spring_force_hinges(const struct spring_net *net, double *hinges);

#endif
