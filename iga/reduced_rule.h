/* reduced_rule.h - quadrature of one direction of a spline space with as many points as
 * functions: what the cure asks of a plate's strains across the sheet. Transverse
 * shear and membrane strains can then vanish wherever bending asks them to, which cures
 * locking at any thickness (patch-wise reduced integration: Adam, Bouabdallah, Zarroug,
 * Maitournam, CMAME 284, 2015; the placing of the points is ours).
 *
 * Odd degree p: Gauss points, one in the middle of each span, and one more in p of them, at
 * the ends, an odd one in the middle (at inner knots that repeat, likewise), if asked all
 * moved by line_rule_refine: as they are, constant stress is in balance between the ends
 * alone. Of an even number of spans the two in the middle share it on their knot, where
 * both have the same strains, and take Radau's points: with it in one of them a sheet
 * leans. In the middle of spans a net that zigzags from point to point has slopes, but no
 * values: the strains of one that zigzags along both directions go unseen, but it takes
 * (spans / pi)^2 to be as soft as a bend.
 *
 * Even degree: in the middle of spans a net that zigzags has no slope, whatever it does
 * across. Neither membrane nor shear, nor bending by the same points, nor tension would see
 * it; only the few points more at the ends keep it from moving freely, and on any net its
 * long waves are among the lowest modes. The rule is therefore Gauss's for continuous
 * piecewise quadratics, which at degree 2 hold all products of slopes: from the middle
 * outwards, each point sits where the hat at the inner knot and the bubble of its span have
 * their integrals, 1 / 3, then 2 / 9, soon (1 - 1 / sqrt 3) / 2 of a span from that knot,
 * and two are in the last. (Led from the ends inwards it leaves values unseen that fade
 * from an edge.) Degree 4 has two Gauss points in a span at each end besides. Inner knots
 * that repeat part nets that are treated as if alone: there it has more points than
 * functions.
 */
#ifndef REDUCED_RULE_H
#define REDUCED_RULE_H

#include "iga/line_rule.h"

/* Make rules; STATUS_MEMORY leaves *rule all-zero. `refined`: odd degrees moved. _derived:
 * of strains along the sheet, where they are products with derivatives along this line:
 * line_rule_greville's points of derivatives or, of degree 2, those above. (There the
 * former integrate derivatives alone, and no shear: a sheet under an even one was 1.4 % of
 * it off. Of two others that do integrate it, one as many as there are derivatives let
 * sheets fold, edge_drop on 16x16 points by 2.3 % of L for .95, and shear alone by these
 * locks: 13 %.) */
enum status reduced_rule_init(struct line_rule *rule, const struct bspline *b,
                              bool refined);
enum status reduced_rule_derived(struct line_rule *rule, const struct bspline *b);

#endif
