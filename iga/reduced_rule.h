/* reduced_rule.h - quadrature of one direction of a spline space with as many points as
 * functions, one a span but for a few: what remedy=reduced and remedy=selective ask of a
 * plate's strains. Transverse shear and membrane strains can then vanish wherever bending
 * asks them to, which cures locking at any thickness (patch-wise reduced integration: Adam,
 * Bouabdallah, Zarroug, Maitournam, CMAME 284, 2015; the placing of the points is ours).
 *
 * Odd degree: Gauss points, one in the middle of each span, and one more in as many spans
 * at the ends as the space has functions more than spans, an odd one in the middle (at
 * inner knots that repeat, likewise).
 *
 * Even degree: in the middle of spans a net that zigzags from point to point has no slope,
 * whatever its wave number across, and neither strain nor tension would see it. The rule
 * is therefore that of Gauss for continuous piecewise quadratics, which hold products of
 * slopes of degree 2: towards the ends of a piece its points lie a third of a span off its
 * outer knot, then at (1 - 1/sqrt 3) / 2. Such a piece has a point more than spans; degree
 * 2 has two of them, meeting in the middle (of an odd number of spans: one, with a point
 * more in the middle), degree 4 sets off a span at each end besides. Inner knots that
 * repeat part nets that are treated as if alone.
 */
#ifndef REDUCED_RULE_H
#define REDUCED_RULE_H

#include "iga/bspline.h"

struct reduced_rule {
    int most;     /* points a span, where they are most; at most p + 1                  */
    int *count;   /* [spans] points                                             owned   */
    double *x;    /* [spans][p + 1] place in the span, 0 .. 1                   owned   */
    double *part; /* [spans][p + 1] weight, of the span's length; positive      owned   */
};

/* STATUS_MEMORY leaves *rule all-zero, which clear accepts. */
enum status reduced_rule_init(struct reduced_rule *rule, const struct bspline *b);
void reduced_rule_clear(struct reduced_rule *rule);

#endif
