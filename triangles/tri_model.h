/* tri_model.h - the model `triangles`. */
#ifndef TRI_MODEL_H
#define TRI_MODEL_H

#include "models/mechanics/march.h"
#include "models/net/spring_leapfrog.h"
#include "triangles/tri_body.h"
#include "triangles/tri_shell.h"

/* A net of triangles in time.
 *
 * momentum  march.h: energy-momentum steps, second order, Newton's method.
 * implicit  Euler's implicit steps, Newton's method; iterations = 1: one linear solve a
 *           step (Baraff and Witkin 1998).
 * leapfrog  explicit, second order: spring_leapfrog.h's sweeps; with hinges, whose forces
 *           no sweep knows, integrator_leapfrog.c's steps.
 *
 * A grid with bending=quadratic or hinge is tri_body.h's; with midedge, or on another mesh,
 * the sheet is tri_shell.h's.
 *
 * Mass is lumped: every point has its part of the area. A point has no slope to hold: where
 * a column is held whole, clamps hold it (spring_plate.h); a support that takes the
 * mid-surface or single components alone is a hinge.
 */

/* Whether edges know that they are arcs (tri_shell.h). */
enum tri_arc { TRI_ARC_OFF, TRI_ARC_ON };

struct tri_own { /* choices of its own (models/option.h) */
    enum membrane membrane;
    enum tri_arc arc;
};

struct tri_motion {
    struct march march;          /* first: march.h                                       */
    struct discretization asked; /* integrator, substeps, iterations, solver           */
    struct net net;
    bool meshed; /* tri_shell.h, else the grid of tri_body.h                           */
    struct tri_net triangles;
    struct tri_body body;
    struct tri_shell shell;
    struct spring_cells cells; /* swept only, as what follows                    */
    struct spring_stencil stencil;
    struct spring_body swept; /* net NULL: steps are not spring_leapfrog.h's              */
};

extern const struct model tri_model;

#endif
