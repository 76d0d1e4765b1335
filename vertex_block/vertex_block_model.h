/* vertex_block_model.h - the model `vbd`. */
#ifndef VERTEX_BLOCK_MODEL_H
#define VERTEX_BLOCK_MODEL_H

#include "models/net/net.h"
#include "triangles/tri_shell.h"
#include "vertex_block/vb_body.h"

/* A net in time by vertex block descent (Chen, Liu, Yang, Yuksel 2024, ACM Trans. Graph.
 * 43(4)).
 *
 * A step of dt is Euler's implicit one: it ends where
 *     sum (m / dt^2 + c / dt) |x - y|^2 / 2 + E(x)
 * is least, y the place that inertia, drag c and loads alone would lead to. Sweeps go over
 * the points, colour by colour, each of which is moved to where the function is least if
 * all others stand still, to second order (vb_body.h), until the step has arrived
 * (arrival.h). Its cost does not depend on how stiff the sheet is; how far the sweeps come
 * does: a sweep moves a wave of the net by a share of about (m / dt^2 + k_wave) / (m / dt^2
 * + k_point) of its way, k_wave its stiffness and k_point that of a point between fixed
 * neighbours. Small steps do more than iterations, therefore.
 *
 * Start of the sweeps (Chen et al., sec. 3.7): x + dt v + dt^2 of that part of the loads'
 * acceleration that the last step's velocity change shows, between none and all of it; its
 * change before contact, of which the sweeps know nothing: what a body carries falls in
 * them. Chebyshev (sec. 3.8; Wang 2015): after sweep k x_k <- w (x_k - x_(k-2)) + x_(k-2).
 *
 * On a mesh that is no grid the elements are its triangles, or its edges' springs, and
 * bending is spring_plate.h's, with slopes that are points without mass.
 *
 * Damping: mass and alpha, and drag, are c; velocity_scale and velocity_rate act once a
 * frame; stiffness damping is refused: the paper's resists rigid turns, too. Contact ends
 * each step, after the sweeps (contact_project).
 */

/* The elements of the membrane: triangles of constant strain, St. Venant and Kirchhoff's
 * law; or springs, mass_spring's. */
enum vb_elements { VB_TRIANGLES, VB_SPRINGS };

/* The stiffness of hinges: the scene's bending (tri_body.h); or, as an engine has it that
 * takes the torque k l theta at an edge of length l (newton 1.0, its solver `vbd`),
 * whatever the triangles' size, the scene's only if the sheet has ten cells along its
 * length, and proportional to the cells' width. */
enum vb_hinge_scale { VB_MATCHED, VB_EDGE_LENGTH };

struct vb_own { /* choices of its own (models/option.h) */
    enum vb_elements elements;
    enum vb_hinge_scale hinge_scale;
    double chebyshev; /* estimate of a sweep's spectral radius; 0: no acceleration  [1] */
};

struct vb_motion {
    struct net net; /* first: net.h                                                    */
    struct tri_net triangles;
    struct spring_net springs; /* of VB_SPRINGS, else empty                             */
    struct tri_body law;
    struct tri_shell shell; /* on a mesh that is no grid, else the net and law before   */
    struct vb_body body;
    struct vb_own own;
    struct arrival arrival;
    int substeps;
    double dt;           /* length of a substep                                  [s]   */
    double rest_energy;  /* round-off of the energy at rest                      [J]   */
    long substep, frame; /* taken so far                                               */
    void *room;
    double *inertia;   /* [nodes] m / dt^2 + c / dt                          [N/m] */
    double *gain;      /* [nodes][3] change of velocity by the last sweeps   [m/s] */
    double *start;     /* [nodes][3] where the step starts                   [m]   */
    double *target;    /* [nodes][3] y                                       [m]   */
    double *force;     /* [nodes][3] that sweeps left                          [N] */
    double *before[2]; /* [nodes][3] the last two sweeps', with Chebyshev    [m]   */
};

void vb_motion_energy(const void *motion, struct energy *energy);

extern const struct model vertex_block_model;

#endif
