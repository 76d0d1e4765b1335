/* contact_share.h - the share of a change that Newton's method takes: its one cure of
 * overshoot, in every model. A change is shortened where the shape that it leads to has no
 * forces, and under contact where it is thrown back: the pressure rises far more steeply
 * than its slope says, and a whole change may meet many times the force that drove it.
 * Along a change d the work r . d of the residual falls to nothing if the tangent is right;
 * the share is good where little is left, of either sign. The work judged is
 * the contact's part (large_newton.c). What may be taken at most, before walls, is
 * contact_limit's to say, and comes first.
 */
#ifndef CONTACT_SHARE_H
#define CONTACT_SHARE_H

#include <stdbool.h>
#include <stddef.h>

#include "models/status.h"

/* A change d[count] of x[count], both [m]. */
struct contact_change {
    size_t count;
    double *x;
    const double *d;
    double fall; /* r . d at x, of any sign                                        [J] */
    bool lower;  /* what is left may drive on                                          */
    void *self;  /* of the next, borrowed                                              */
    /* Computes the forces at x, and *rise, minus what of r . d is left there. */
    enum status (*look)(void *self, const struct contact_change *c, double *rise);
};

/* Moves x by the share of d, returned in *share, that is taken, with `look` there last;
 * returns its status: a death if even short changes lead to no shape. */
enum status contact_change_take(const struct contact_change *c, double *share);

#endif
