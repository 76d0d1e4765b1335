/* net_fit.h - nets with lines where supports begin and end.
 *
 * A net holds its points, and so what lies between the last line of points that a support
 * reaches and the next one hangs from where the support does not end: up to a cell, an
 * error of first order that goes up and down as the net is refined.
 */
#ifndef NET_FIT_H
#define NET_FIT_H

#include "models/scene.h"

/* The least number of equal spans along u (0) or v (1), `spans` > 0 or more, up to twice as
 * many, with a line at each end of each support; 0: there is none. */
int net_fit_spans(const struct scene *scene, int along, int spans);

#endif
