/* solid_model.h - the parts of a model that every solid shares. A model's state begins with
 * a struct solid_sheet, and so with a struct march.
 *
 *   linear       small strain about the rest shape; K, M constant (integrator_newmark.c).
 *   printed, incremental   the paper's schemes (integrator_printed.c).
 *   nonlinear    total Lagrangian, Green strain, St. Venant and Kirchhoff's law
 *                (solid_green.h), energy-momentum or explicit steps (march.h).
 *
 * Contact under `nonlinear` acts on the mid-surface; `linear` refuses it.
 */
#ifndef SOLID_MODEL_H
#define SOLID_MODEL_H

#include "models/mechanics/march.h"
#include "models/solid/solid_green.h"

/* What meets bodies: the mid-surface w = 1/2, or a face w = 0 or 1; `self` of its rows. */
struct solid_face {
    const void *body; /* the model's                                                   */
    double w;
};

struct solid_sheet {
    struct march march; /* first: march.h                                              */
    struct solid_space space;
    struct solid_assembly assembly;
    struct supports supports;
    struct solid_green green; /* nonlinear kinematics only                             */
    int points[3];
    struct solid_face face[CONTACT_OUTSIDE_FACES];
    double misfit; /* misfit of the rest shape, solid_model_misfit                 [m] */
};

/* The scene's needs that solids support; bits of scene_need. */
#define SOLID_MODEL_SERVES                                                                 \
    (SCENE_NEED_CONTACT | SCENE_NEED_SELF_CONTACT | SCENE_NEED_MOVING_OBSTACLES |          \
     SCENE_NEED_LOADS | SCENE_NEED_MOVING_SUPPORTS | SCENE_NEED_TURNING_CLAMPS |           \
     SCENE_NEED_PATCH_SUPPORTS | SCENE_NEED_COMPONENT_SUPPORTS |                           \
     SCENE_NEED_THICKNESS_SUPPORTS | SCENE_NEED_DRAG | SCENE_NEED_CURVED_REST |            \
     SCENE_NEED_INITIAL_MOTION | SCENE_NEED_SHEETS | SCENE_NEED_AIR | SCENE_NEED_GRIPPERS)

/* Refuses a fabric where no layer holds membrane and bending apart (solid_layer.h), with
 * what a solid of one law as thick would have of the fabric's bending. */
enum status solid_model_refuse_fabric(const struct scene *scene, struct message *why);

void solid_model_net(const void *state, double *xyz);

/* Makes the matrices; STATUS_UNSUPPORTED in the thickness basis and on hinges. */
enum status solid_model_matrices(const void *state, struct matrix *K, struct matrix *M);

/* Writes a sentence on a misfit above round-off; empty otherwise. */
void solid_model_describe(const void *state, struct message *line);

/* Chooses the basis through the thickness: what was asked, or the thickness basis where
 * `possible` and all supports take whole columns or the middle of one of two layers.
 * STATUS_INPUT if it was asked but is not
 * possible. */
enum status solid_model_basis(const struct scene *scene, const struct discretization *d,
                              bool possible, bool *thickness, struct message *why);

/* Makes hinges or, with the thickness basis, the space's parity; and the march at rest.
 * points[3]: the net's, numbered w fastest, then v. middle[points[2]]: values at w = 1/2 of
 * the functions through the thickness, where that is one element without weights of its
 * own; else NULL. *s must stay where it is; solid_model_clear follows a failure, too. */
enum status solid_model_init(struct solid_sheet *s, const struct scene *scene,
                             const struct discretization *d, const int points[3],
                             const double *middle, struct message *why);
void solid_model_clear(struct solid_sheet *s); /* but for the space                     */

/* Puts the scene's loads on the functions of u, v and w; once, after solid_model_init. */
enum status solid_model_load(struct solid_sheet *s, const struct dead_load_line line[3]);

/* Names the surfaces that meet bodies, from face 0 on, up to NULL, which is the first where
 * there is nothing to meet; and takes the surface of one over. */
const struct solid_face *solid_model_face(struct solid_sheet *s, const void *body,
                                          int face);
enum status solid_model_meet(struct solid_sheet *s, const struct solid_face *face,
                             struct contact_surface *surface);

/* Makes the air against the mid-surface of `row` and `body`, after solid_model_init, which
 * has at most `width` nodes; its elements lie between the lines[breaks] of a sheet along s
 * and v, with polynomials of the degree along u and v. Slopes are differences that are
 * exact up to degree 4, beyond of fourth order in a hundredth of an element. */
enum status solid_model_air(struct solid_sheet *s, const void *body, contact_row *row,
                            int width, const int breaks[2], const double *const lines[2],
                            const int degree[2]);

/* Measures how far a curved rest shape (`probe` of the state) lies from the scene's, at
 * most over the grid; 0 for flat ones, unmeasured. */
enum status solid_model_misfit(struct solid_sheet *s,
                               void (*probe)(const void *state, int n, const double *uvw,
                                             double *xyz));

#endif
