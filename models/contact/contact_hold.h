/* contact_hold.h - touches that are held in a step, where Newton's method finds others anew
 * and does not converge.
 */
#ifndef CONTACT_HOLD_H
#define CONTACT_HOLD_H

#include "models/contact/contact.h"

/* Takes the size [m] of the next change of Newton's method, and holds the touches
 * that contact_find found there if such changes do not shrink. Until the step ends, or
 * `held` is false, each keeps its places, its normal and what bounds its friction, and new
 * ones are added. What is left then has a solution and, but for the pressure's rate, a
 * convex potential, while feet and normals of a folded net may jump, back and forth,
 * between two states that are none. */
void contact_hold(struct contact *c, double size);

/* Goes on from what held touches led to. The first time, and `again`, they are let go,
 * so that contact_find finds them anew; else they stay held, since feet may jump for ever,
 * and take their push there for what bounds their friction. False: none are held, or what
 * they led to is to be taken, since push and bound are alike. */
bool contact_hold_release(struct contact *c, bool again);

#endif
