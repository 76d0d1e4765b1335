/* contact_share.h - the share of a change that Newton's method takes under contact: its one
 * cure of overshoot. The pressure rises far more steeply than its slope says, and a whole
 * change may be thrown back by many times the force that drove it. Along a change d the
 * work r . d of the residual falls to nothing if the tangent is right; the share is good
 * where little is left, of either sign. Springs judge by the whole residual, bodies at
 * large displacements by the contact's part (large_newton.c).
 */
#ifndef CONTACT_SHARE_H
#define CONTACT_SHARE_H

#include <stdbool.h>

/* The most places that callers try for one change. */
enum { CONTACT_SHARE_PLACES = 20 };

/* A share, tried from `most` = share = high downwards, low = 0. */
struct contact_share {
    double share, most;
    double low, high; /* good ones lie between them                                    */
};

/* Tells whether the share is good, of a change whose slope was `fall` > 0 at its start and
 * is -rise there; sets the next one to try if not. Not finite `rise`: there is no shape
 * there. */
bool contact_share_good(struct contact_share *s, double fall, double rise);

#endif
