/* spring_gauge.h - springs in squares of lengths that measure their stretch over a gauge
 * length: each feels the mean of all runs of g springs in line that it is part of,
 *     s(i) = sum over |t| < g of (g - |t|) / g^2 (l(i+t)^2 - r^2),
 * in place of its own l^2 - r^2. A stretch that is the same all along a line is resisted as
 * before; one that changes its sign from spring to spring hardly: the highest frequency of
 * a line is 1 / g of that of its springs, and explicit steps may be g times as long. What
 * the net loses is detail of the membrane below the gauge length; bending loses nothing.
 * The energy is that of the runs' means, sum over springs of k (l^2 - r^2) s / 8 r^2.
 *
 * A line ends at a point that is held, where it goes on as its mirror image, and at the
 * rim, beyond which there is none: the last springs there are softer. Lines from rim to rim
 * that are shorter than a run are one run. A small share of its stiffness stays with each
 * spring (ALONE in spring_gauge.c). Explicit steps alone know the means.
 */
#ifndef SPRING_GAUGE_H
#define SPRING_GAUGE_H

#include "models/mechanics/supports.h"
#include "models/net/spring_stencil.h"

/* The longest run, and how many springs one of its springs then feels. */
enum { SPRING_GAUGE_MOST = 4, SPRING_GAUGE_TAPS = 2 * SPRING_GAUGE_MOST - 1 };

/* The lines of a net by the step from point to point: (0, 1), (1, -1), (1, 0), (1, 1). */
enum {
    SPRING_GAUGE_V,
    SPRING_GAUGE_FALLING,
    SPRING_GAUGE_U,
    SPRING_GAUGE_RISING,
    SPRING_GAUGE_LINES
};
extern const int spring_gauge_step[SPRING_GAUGE_LINES][2];

/* Springs belong to the node that they begin at. */
struct spring_gauge {
    int springs[SPRING_GAUGE_LINES];   /* g of each line                                 */
    bool all;                          /* lines are taken, else those along u alone      */
    bool taken[SPRING_GAUGE_LINES];    /* has springs, which are taken over runs       */
    double square[SPRING_GAUGE_LINES]; /* r^2                                  [m^2]   */
    void *room; /* memory of the arrays                      owned   */
    double (*weight[SPRING_GAUGE_LINES])[SPRING_GAUGE_TAPS]; /* [nodes] k / 2 r^2 times the
                           shares of the springs g - 1 behind to g - 1 ahead   [N/m^3] */
    double *there[SPRING_GAUGE_LINES]; /* [nodes] 1 / r^2, 0: no spring        [1/m^2] */
    double *turns[SPRING_GAUGE_LINES]; /* [nodes] the same at free points between two  */
    double *x[3], *turn; /* [nodes] work, with zeros on either side                     */
};

/* Initialises for a gauge length of `cells` of the shorter side, up to SPRING_GAUGE_MOST:
 * lines of longer springs have as many in a run as cover it. If none but those along u have
 * more than one, the others keep their own stretch. */
enum status spring_gauge_init(struct spring_gauge *g, const struct supports *supports,
                              const struct spring_net *net, int cells);
void spring_gauge_clear(struct spring_gauge *g);

/* Returns by how much the energy of a stencil's springs at x[nodes][3] differs from what it
 * would be by their own stretches [J]. */
double spring_gauge_energy(const struct spring_gauge *g, const struct spring_stencil *s,
                           const double *x);

/* Returns by how much the largest eigenvalue of all springs' stiffness is larger at
 * x[nodes][3] than at rest, at most: (3 s - 1) / 2 for the largest s = l^2 / r^2, times 1 +
 * g / 4 sum of turn^2 over the points of a run, for the largest. A turn is a second
 * difference over r: a run that turns resists the points between its ends, too. The bound
 * is that of the rows of the runs' products. */
double spring_gauge_stiffer(const struct spring_gauge *g, const struct spring_net *net,
                            const double *x);

#endif
