/* contact_coupled.h - the system of a body that touches itself: places far apart on the
 * sheet are coupled, so that its pattern is wider than the body's and changes as it moves.
 */
#ifndef CONTACT_COUPLED_H
#define CONTACT_COUPLED_H

#include "models/contact/contact.h"
#include "models/mechanics/pencil.h"
#include "models/mechanics/system.h"

/* All zero before the first use, and after contact_coupled_clear. */
struct contact_coupled {
    bool used;            /* by the last contact_coupled_add                             */
    struct blocks graph;  /* the body's, and that of the touches it was made for         */
    struct system system; /* solves while `used`                                        */
    void *room;           /* of the arrays                                       owned   */
    long *place;          /* [pairs of the body] where they are in graph                */
    double (*K)[9];       /* [pairs of graph]                                            */
    double *M;            /* [pairs of graph]                                            */
};

/* Adds the stiffness of the touches of the last contact_find to K[pairs], a tangent of the
 * body's system. Where they couple places of the sheet K stays, and the sum is w's own, in
 * a pattern that is made anew where the touches' places are not in it. */
enum status contact_coupled_add(struct contact_coupled *w, const struct contact *c,
                                const struct system *system, double (*K)[9]);

/* Does so with the turning of the normals at x[nodes][3]; where touches couple places, `p`
 * gets that sum and the mass M [pairs] in w's pattern. */
enum status contact_coupled_pencil(struct contact_coupled *w, const struct contact *c,
                                   const struct system *system, const double *x,
                                   double (*K)[9], const double *M, struct pencil *p);

/* Factorises k K + m M after contact_coupled_add, as system_update does, and counts it in
 * `system`; M [pairs] of the body, NULL if m == 0. */
enum status contact_coupled_update(struct contact_coupled *w, struct system *system,
                                   double k, const double (*K)[9], double m,
                                   const double *M);

void contact_coupled_clear(struct contact_coupled *w);

#endif
