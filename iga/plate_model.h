/* plate_model.h - the IGA thick plate: a trivariate B-spline solid of linear elasticity
 * (Ren, Dai, Lin 2024). Key `iga`.
 */
#ifndef PLATE_MODEL_H
#define PLATE_MODEL_H

#include "iga/line_rule.h"
#include "iga/patch.h"
#include "models/model.h"
#include "models/solid/solid_space.h"

/* A B-spline patch as a solid_space: elements are the non-empty knot spans, nodes the
 * control points or, with the thickness basis, Legendre coefficients of each column of
 * control points. Their parameters along u are those of their part (bspline.h). */

/* The lines of points of the cure: across the sheet reduced_rule.h's as they are; of values
 * line_rule.h's; of derivatives reduced_rule.h's refined ones up to degree 3; of bending.
 * (With refined points across it, or line_rule.h's of derivatives for its shear, a sheet of
 * degree 3 that falls on a ball is stretched by 1.11 and 1.26 on 10x10 and 9x9 points
 * for 1.04, and its director turns over on 8x7. With those for its stretch alone a sheet of
 * h/L = 1e-5 locks. Above degree 3 not all nets have refined ones.) */
enum { PLATE_ACROSS, PLATE_VALUES, PLATE_DERIVED, PLATE_BENDING, PLATE_LINES };

struct plate_tables {
    struct line_table direction[3];         /* values and slopes, as of `cure` */
    struct line_table cure[PLATE_LINES][2]; /* u, v of a cure; else all zero           */
    double layer[2][2]; /* its functions through the thickness at w = 1/2: N, dN/dw    */
    const double *point_weight; /* [nodes] NURBS weights or NULL; borrowed from patch  */
};

/* Builds *space and *tables of the patch's present shape; gauss[3] points per span, 0: p+1.
 * `thickness` asks for the Legendre basis through w: one span there, and weights, if any,
 * that do not vary through it. The patch is borrowed for its weights. Parity is left NULL.
 */
enum status plate_model_space(struct solid_space *space, struct plate_tables *tables,
                              const struct patch *patch, const int gauss[3],
                              bool thickness);
void plate_model_clear(struct solid_space *space, struct plate_tables *tables);

/* Sets the stiffness of *space, one linear layer, to solid_layer.h's, at as many points as
 * functions, but strains along the sheet as the shell's (shell_space.h), at
 * points of derivatives, and bending by line_rule_bending. A net that zigzags along
 * u and v stands still at all products of reduced_rule.h's points (of odd degree): in the
 * folds of a flag it stretched ninefold. The stretch along u is therefore seen from the
 * points along v where what zigzags has values, and that along v likewise. (Tried, and
 * left: transverse shear at these, and the stretch across the thickness at the Greville
 * points of both: the director then collapses between its points in a fold; or at those of
 * bending: a sheet of 10x10 that falls locks, .08 of its length off for .016 at .4 s.)
 * Weights do not vary through w. */
enum status plate_model_select(struct solid_space *space, struct plate_tables *tables,
                               const struct patch *patch);

extern const struct model plate_model;

#endif
