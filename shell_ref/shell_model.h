/* shell_model.h - the rotation-free isogeometric Kirchhoff-Love shell behind the common
 * contract, key `shell`. Defaults: points [10,10], degree [3,3], kinematics nonlinear,
 * remedy selective (shell_space.h); a third number of points or degree must be 1 or left
 * alone.
 */
#ifndef SHELL_MODEL_H
#define SHELL_MODEL_H

#include "models/mechanics/march.h"
#include "shell_ref/shell_assembly.h"
#include "shell_ref/shell_space.h"

/* The shell of a scene: supports, loads and damping, and its motion in time.
 *
 *   linear     small strain about the rest shape; K, M constant, one factorisation, average
 *              acceleration (integrator_newmark.c).
 *   nonlinear  mid-point geometry with averaged stress, or explicit steps (march.h).
 *
 * Supports. A rotation-free shell has no slopes to hold: its edge is clamped by holding its
 * row of control points and, of the second row, the components across the direction that
 * the sheet has there at rest: it may stretch into the sheet. (Where all of the second row
 * is held the strain at the clamp is none: a strip that is pulled was 2 % of its strain too
 * short on 10 points.) Where that direction is no coordinate axis, or turns with the clamp,
 * the row's nodes have frames of their own (supports_frame). An edge that a scene fixes in
 * xyz over a stretch of the thickness is clamped that way; an edge of which only some
 * components or only the line w = 1/2 is held is a hinge, its first row alone. A corner is
 * a point: it holds one control point and no slope (a slope held at one point has no limit
 * under refinement). An area holds all that does not vanish on it (support_knots.h), and so
 * its border's slopes as well.
 *
 * Obstacles: samples of the mid-surface meet them (contact.h), in nonlinear kinematics.
 */

struct shell {
    struct march march; /* first: march.h                                              */
    struct shell_space space;
    const struct scene *scene; /* held_scene once that is made                borrowed */
    struct scene held_scene;   /* the scene with clamped edges two rows wide; its supports
                                                                                 owned   */
    int slopes; /* the first of these that holds a direction, not an edge             */
    int *clamp; /* the support of whose edge it is                             owned  */
    struct shell_assembly assembly;
    struct supports supports;
    unsigned char *parity;   /* [nodes][3] or NULL: which components couple       owned  */
    void *room;              /* of the next two                                  owned   */
    double *lumped, *beyond; /* [pairs] masses of explicit steps, by shell_mass_beyond where
                                nothing moves or meets the sheet, NULL elsewhere [kg]  */
};

extern const struct model shell_model;

#endif
