/* contact_coupled.h - the system of a body that touches itself: places far apart on the
 * sheet are coupled, so that its pattern is wider than the body's and changes as it moves.
 */
#ifndef CONTACT_COUPLED_H
#define CONTACT_COUPLED_H

#include "models/contact/contact.h"
#include "models/mechanics/system.h"

/* All zero before the first use, and after contact_coupled_clear. */
struct contact_coupled {
    struct blocks graph; /* the body's, and that of the touches it was made for         */
    struct system system;
    void *room;     /* of the arrays                                       owned   */
    long *place;    /* [pairs of the body] where they are in graph                */
    double (*K)[9]; /* [pairs of graph]                                            */
    double *M;      /* [pairs of graph]                                            */
};

/* Tells whether the touches of the last contact_find couple places of the sheet. */
bool contact_coupled_wanted(const struct contact *c);

/* Factorises k K + m M with the stiffness of the touches times `force`; K, M [pairs] of the
 * body's graph; M may be NULL if m == 0. The pattern is made anew where the touches' places
 * are not in it. */
enum status contact_coupled_update(struct contact_coupled *w, const struct contact *c,
                                   const struct blocks *graph, const struct supports *held,
                                   double k, const double (*K)[9], double force, double m,
                                   const double *M);

/* Solves as system_solve does. */
enum status contact_coupled_solve(struct contact_coupled *w, double *x);

void contact_coupled_clear(struct contact_coupled *w);

#endif
