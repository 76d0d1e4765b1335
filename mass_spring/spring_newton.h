/* spring_newton.h - minimises
 *     sum_a weight_a |x_a - target_a|^2 / 2 + E(x) - load x + viscosity |x - start|^2_V / 2
 * over the free unknowns of a net: one step of implicit Euler.
 *
 * Newton with the clamped Jacobian (spring_force.h), so that every step goes down, and a
 * line search on the slope: a step is shortened while it ends where the function rises at
 * more than half the rate at which it fell. Slopes cost no energies and have no
 * cancellation. Cut to one iteration it is the linearised step of Baraff and Witkin 1998,
 * without line search; where it touches something it goes on as without that number.
 *
 * The linear systems are solved by conjugate gradients that an earlier factor, turned with
 * the net, preconditions (iterative.h), unless the discretization has another solver; that
 * of a large net in single precision. To 1e-2 of the step, or a tenth of the tolerance, if
 * others follow; 1e-4 if it is the only one.
 *
 * Contact adds its forces and their stiffness, and a step leaves a tenth of each distance
 * to a wall (contact_limit).
 */
#ifndef SPRING_NEWTON_H
#define SPRING_NEWTON_H

#include "mass_spring/spring_force.h"
#include "models/contact/contact.h"
#include "models/mechanics/contact_coupled.h"
#include "models/mechanics/supports.h"
#include "models/mechanics/system.h"
#include "models/model.h"

struct spring_newton {
    const struct spring_net *net;    /* borrowed                                       */
    const struct supports *supports; /* borrowed                                       */
    struct discretization linear;    /* its solver and preconditioner */
    struct system system; /* empty before spring_newton_system                         */
    struct contact_coupled coupled; /* in its place where the sheet touches itself     */
    void *room;       /* memory of the arrays                               owned   */
    double (*K)[9];   /* [pairs]                                                    */
    double *hinges;   /* [pairs] spring_force_hinges                       owned   */
    double *work;     /* [3][nodes][3]                                              */
    const double *at; /* [nodes][3] where K is of                         borrowed  */
};

struct spring_problem {
    const double *weight;        /* [nodes]                                   [N/m]    */
    const double *target, *load; /* [nodes][3]                                [m, N]   */
    double viscosity;            /* 0: V is not read                          [1]      */
    const double (*V)[9];        /* [pairs] positive semi-definite            [N/m]    */
    const double *start;         /* [nodes][3] where the step began           [m]      */
    struct contact *contact;     /* begun, or NULL                                     */
};

struct spring_limits {
    int iterations;   /* stop there without complaint; 0: go on until it has converged */
    double tolerance; /* converged when no coordinate moves farther             [m]    */
};

/* Initialises; all but d, which tells the solver, must stay where it is. */
enum status spring_newton_init(struct spring_newton *s, const struct spring_net *net,
                               const struct supports *supports,
                               const struct discretization *d);

/* Makes the system and hinges, once, to solve with. */
enum status spring_newton_system(struct spring_newton *s);

void spring_newton_clear(struct spring_newton *s);

/* Moves x[nodes][3], whose held unknowns are where they should be, to the minimum.
 * STATUS_DIVERGED after 2000 iterations (limits->iterations == 0), STATUS_INDEFINITE,
 * STATUS_NAN, STATUS_MEMORY. The contact is that of x then. */
enum status spring_newton_solve(struct spring_newton *s, const struct spring_problem *p,
                                const struct spring_limits *limits, double *x,
                                struct counters *counters);

#endif
