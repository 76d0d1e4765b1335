/* solid_model.h - the parts of struct model that every solid shares. A model's state begins
 * with a struct solid_sheet, so that these functions, solid_motion_step (advance) and
 * solid_motion_energy serve as its entries.
 */
#ifndef SOLID_MODEL_H
#define SOLID_MODEL_H

#include "models/solid/solid_motion.h"

struct solid_sheet {
    struct solid_motion motion; /* first: tests and benchmarks reach it                */
    struct solid_space space;
    double misfit; /* misfit of the rest shape, solid_model_misfit                 [m] */
};

/* The scene's needs that solid_motion supports; bits of scene_need. */
#define SOLID_MODEL_SERVES                                                                 \
    (SCENE_NEED_CONTACT | SCENE_NEED_SELF_CONTACT | SCENE_NEED_MOVING_OBSTACLES |          \
     SCENE_NEED_LOADS | SCENE_NEED_MOVING_SUPPORTS | SCENE_NEED_TURNING_CLAMPS |           \
     SCENE_NEED_PATCH_SUPPORTS | SCENE_NEED_COMPONENT_SUPPORTS |                           \
     SCENE_NEED_THICKNESS_SUPPORTS | SCENE_NEED_DRAG | SCENE_NEED_CURVED_REST |            \
     SCENE_NEED_INITIAL_MOTION | SCENE_NEED_SHEETS)

/* Refuses a fabric where no layer holds membrane and bending apart (solid_layer.h), with
 * what a solid of one law as thick would have of the fabric's bending. */
enum status solid_model_refuse_fabric(const struct scene *scene, struct message *why);

void solid_model_size(const void *state, struct model_size *size);
void solid_model_contact(const void *state, struct model_contact *contact);
void solid_model_net(const void *state, double *xyz);

/* Moves to static equilibrium under the loads, supports where the scene ends. In linear
 * kinematics one step of iterative refinement measures the digits left: STATUS_INDEFINITE,
 * with a sentence, if fewer than two. */
enum status solid_model_equilibrium(void *state, struct counters *counters,
                                    struct message *why);
enum status solid_model_modes(void *state, int count, double *omega, struct message *why);

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

/* Makes hinges or, with the thickness basis, the space's parity; and the motion. points[3]:
 * the net's, numbered w fastest, then v. middle[points[2]]: values at w = 1/2 of the
 * functions through the thickness, where that is one element without weights of its own;
 * else NULL. */
enum status solid_model_init(struct solid_sheet *s, const struct scene *scene,
                             const struct discretization *d, const int points[3],
                             const double *middle, struct message *why);

/* Measures how far a curved rest shape (`probe` of the state) lies from the scene's, at
 * most over the grid; 0 for flat ones, unmeasured. */
enum status solid_model_misfit(struct solid_sheet *s,
                               void (*probe)(const void *state, int n, const double *uvw,
                                             double *xyz));

#endif
