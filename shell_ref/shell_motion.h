/* shell_motion.h - the shell of a scene: supports, loads and damping, and its motion in
 * time.
 *
 *   linear     small strain about the rest shape; K, M constant, one factorisation, average
 *              acceleration (newmark.h).
 *   nonlinear  large_motion.h: mid-point geometry with averaged stress, Newton.
 *
 * Supports. A rotation-free shell has no slopes to hold: its edge is clamped by holding two
 * rows of control points. An edge that a scene fixes in xyz over a stretch of the thickness
 * is clamped that way; an edge of which only some components or only the line w = 1/2 is
 * held is a hinge, its first row alone. A corner is a point: it holds one control point and
 * no slope (a slope held at one point has no limit under refinement). An area holds all
 * that does not vanish on it (support_knots.h), and so its border's slopes as well.
 *
 * Obstacles: samples of the mid-surface meet them (contact.h); linear steps as
 * contact_linear.h says, nonlinear as large_motion.h does.
 */
#ifndef SHELL_MOTION_H
#define SHELL_MOTION_H

#include "models/mechanics/contact_linear.h"
#include "models/mechanics/large_motion.h"
#include "shell_ref/shell_assembly.h"

struct shell_motion {
    const struct scene *scene;       /* borrowed                                       */
    const struct shell_space *space; /* borrowed                                       */
    enum kinematics kinematics;
    struct scene held_scene; /* the scene with clamped edges two rows wide; its supports
                                                                               owned   */
    struct shell_assembly assembly;
    struct supports supports;
    struct system system;
    struct newmark newmark; /* nonlinear: v and the last acceleration a                */
    unsigned char *parity;  /* [nodes][3] or NULL: which components couple      owned   */
    void *room;     /* of the arrays but dead                                  owned   */
    double (*K)[9]; /* [pairs] linear: of the rest shape               [N/m]           */
    double *x;      /* [nodes][3] present control points               [m]             */
    double *load;   /* [nodes][3] gravity, wind and loads              [N]             */
    double *dead;   /* [nodes][3] of which the scene's loads; NULL: none       owned   */
    double *lumped, *beyond; /* [pairs] masses of explicit steps, by shell_mass.h where
                                nothing moves or meets the sheet, NULL elsewhere [kg]  */
    double *held; /* [4][held_count] target d, v, a; work                            */
    double time;  /* [s]                                                             */
    bool started; /* linear: the constant system is factored; nonlinear: strain_old
                     belongs to x                                                    */

    struct large_motion large; /* nonlinear only                                       */
    struct pressure pressure;
    struct contact contact; /* all zero where there is nothing to meet                 */
    struct contact_linear meets; /* linear kinematics with contact                     */
};

/* Initialises; `space` must have been made for the scene's sheet; kinematics and solver
 * from d. STATUS_UNSUPPORTED with a sentence for the paper's kinematics and for supports
 * that miss the mid-surface. */
enum status shell_motion_init(struct shell_motion *m, const struct scene *scene,
                              const struct shell_space *space,
                              const struct discretization *d, struct message *why);
void shell_motion_clear(struct shell_motion *m);

/* Implement model.h's entries for a state that begins with a struct shell_motion. */
enum status shell_motion_step(void *state, struct counters *counters);
void shell_motion_energy(const void *state, struct energy *energy);
void shell_motion_contact(const void *state, struct model_contact *contact);
void shell_motion_size(const void *state, struct model_size *size);

/* Moves the state to equilibrium under the scene's loads, supports where it ends, at rest.
 * Linear: one solve, one pass of refinement. Nonlinear: from the rest shape by growing
 * loads, in shorter increments where Newton's method fails, at last by steps downhill (a
 * sheet on a hinge). STATUS_INPUT without supports. */
enum status shell_motion_equilibrium(void *state, struct counters *counters,
                                     struct message *why);
enum status shell_motion_modes(void *state, int count, double *omega, struct message *why);
enum status shell_motion_matrices(const void *state, struct matrix *K, struct matrix *M);

#endif
