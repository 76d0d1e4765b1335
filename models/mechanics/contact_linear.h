/* contact_linear.h - steps of linear systems under contact: what is nonlinear in them is
 * the contact, which is met at the step's end by Newton's method.
 */
#ifndef CONTACT_LINEAR_H
#define CONTACT_LINEAR_H

#include "models/mechanics/contact_coupled.h"
#include "models/mechanics/newmark.h"

/* The parts that the steps of a body work with; borrowed but `coupled`. */
struct contact_linear {
    struct contact *contact;
    struct newmark *newmark; /* d and v; a is not used by contact_linear_step          */
    struct system *system;
    const double (*K)[9]; /* [pairs]                                                   */
    const double *M;      /* [pairs]                                                   */
    const double *load;   /* [nodes][3] [N]                                            */
    double (*tangent)[9]; /* [pairs] room                                              */
    struct contact_coupled coupled; /* where the sheet touches itself, owned         */
    double *room; /* [6][nodes][3]                                             */
    bool plain;   /* the system's factor is newmark_k K + newmark_m M          */
};

void contact_linear_clear(struct contact_linear *l);

/* Takes a step from time t and positions x[nodes][3] of the trapezoidal rule with a contact
 * force r that is constant over it and has its value at the end,
 *     M (v1 - v0) / dt = f - K (d0 + d1) / 2 - C (v0 + v1) / 2 + r,
 *     d1 - d0 = dt (v0 + v1) / 2.
 * r does no less work on the contact than this stores: with E = v'Mv/2 + d'Kd/2 - f'd and
 * the contact's energy, E1 <= E0 up to round-off for every dt (Kane, Repetto, Ortiz,
 * Marsden 1999, Comput. Methods Appl. Mech. Engrg. 180, for the force at the end). `held`
 * as for newmark_step. STATUS_DIVERGED if Newton's method fails. */
enum status contact_linear_step(struct contact_linear *l, double t,
                                const struct newmark_held *held, const double *x,
                                struct counters *counters);

/* Takes a step of newmark_step's kind on matrices that are rebuilt in every step. */
enum status contact_linear_rebuilt(struct contact_linear *l, double t,
                                   const struct newmark_held *held, const double *x,
                                   struct counters *counters);

#endif
