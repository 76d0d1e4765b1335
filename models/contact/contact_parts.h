/* contact_parts.h - the list of a contact's touches and what each of them measures, for the
 * files that fill contact.h.
 */
#ifndef CONTACT_PARTS_H
#define CONTACT_PARTS_H

#include "models/contact/contact.h"

/* Empties the list and the totals. */
void contact_touch_none(struct contact *c);

/* Appends a touch of a sample with a body, at the distance D with the normal n.
 * STATUS_MEMORY. */
enum status contact_touch_body(struct contact *c, int sample, int obstacle, double D,
                               const double n[3]);

/* Appends the touches of the sheet with itself at x[nodes][3]. Each of the two sides has
 * half of the law at samples of its own. STATUS_NAN, STATUS_MEMORY. */
enum status contact_touch_own(struct contact *c, const double *x);

/* Return the law of a touch and its coefficient of friction. */
const struct contact_law *contact_touch_law(const struct contact *c,
                                            const struct contact_touch *t);
double contact_touch_friction(const struct contact *c, const struct contact_touch *t);

/* Computes how far the touch's places have moved against each other since the step began.
 */
void contact_touch_way(const struct contact *c, const struct contact_touch *t,
                       const double *x, double way[3]);

/* Splits a way into its length along n, returned, and the part across, in `slip`. */
double contact_touch_split(const double way[3], const double n[3], double slip[3]);

/* Returns the distance of a touch when the step began. A body's is measured: the way along
 * the normal would take a sheet that slides on a ball for one that leaves it. */
double contact_touch_before(const struct contact *c, const struct contact_touch *t,
                            double along);

/* Adds a touch's pressure and friction to the totals. */
void contact_touch_total(struct contact *c, const struct contact_touch *t);

/* Tells whether a body neither moves nor turns. */
bool contact_touch_still(const struct scene_obstacle *o);

/* Returns the distance of a sample that a step leads to y, D from a body, as seen from the
 * side from which they have met: a step may lead through a thin body, or so deep into it
 * that its nearest face is the far one. There the distance is that from the plane of the
 * face that it came through, and *normal this face's. The distance changes by the way at
 * most, so that most are done with at once. */
double contact_touch_met(const struct contact *c, int sample, int obstacle,
                         const double y[3], double D, double normal[3]);

#endif
