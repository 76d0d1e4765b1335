/* solid_motion.h - the motion of a solid in time:
 *
 *   linear       small strain about the rest shape; K, M constant, one factorisation.
 *   printed      Ren et al. 2024, eq. 18-22 to the letter: K, M, b rebuilt on the present
 *                control points each step, d += dt v + dt^2/4 (a + a_new), P += d.
 *   incremental  the same with d = 0 after each step.
 *   nonlinear    total Lagrangian, Green strain, St. Venant and Kirchhoff's law
 *                (solid_green.h), energy-momentum or explicit steps (large_motion.h).
 *
 * `printed` and `incremental` start at d = v = a = 0 in a scene at rest, `linear` with the
 * acceleration that the loads give. A free sheet under `printed` falls with
 * g (1 + mu) / (2 (1 - mu)): d is never reset, so it acts as velocity times dt, and K d as
 * a viscosity E dt. Body drag, of which the paper has none, therefore acts on d / dt there,
 * and on v elsewhere; and an initial velocity, which it has not either, begins as d / dt.
 *
 * Contact acts on the mid-surface: `nonlinear` as in large_motion.h, the others as in
 * contact_linear.h. `printed` and `incremental` have no energy, and no bound of it.
 */
#ifndef SOLID_MOTION_H
#define SOLID_MOTION_H

#include "models/mechanics/contact_linear.h"
#include "models/mechanics/dead_load.h"
#include "models/mechanics/large_motion.h"
#include "models/mechanics/newmark.h"
#include "models/solid/solid_green.h"

struct solid_motion {
    const struct scene *scene;       /* borrowed                                       */
    const struct solid_space *space; /* borrowed                                       */
    enum kinematics kinematics;
    int points[3];
    struct solid_assembly assembly;
    struct supports supports;
    struct system system;
    struct newmark newmark;
    void *room;   /* memory of the arrays but dead                            owned   */
    double *x;    /* [nodes][3] present coefficients                   [m]            */
    double *load; /* [nodes][3] gravity, wind and loads                [N]            */
    double *dead; /* [nodes][3] of which the scene's loads; NULL: none        owned   */
    double *held; /* [4][held_count] target d, v, a; work                             */
    double time;  /* [s]                                                              */
    bool started; /* the constant system is factored                                  */

    /* These are used where there is something to meet only. */
    struct contact contact;
    struct contact_linear meets; /* but in nonlinear kinematics                        */

    /* These are used in nonlinear kinematics only. */
    struct solid_green green;
    struct large_motion large;
    double (*tangent)[9]; /* [pairs] assembly.K stays the stiffness at rest             */
};

/* Initialises, including the assembled matrices of the rest shape. `order`: node order for
 * the factorisation or NULL. *m must stay where it is: it holds pointers into itself. */
enum status solid_motion_init(struct solid_motion *m, const struct scene *scene,
                              const struct solid_space *space,
                              const struct discretization *d, const int *order,
                              struct message *why);
void solid_motion_clear(struct solid_motion *m);

/* Takes over the mid-surface that meets bodies and itself, after solid_motion_init; where
 * the scene wants it (contact_wanted). */
enum status solid_motion_meet(struct solid_motion *m, struct contact_surface *surface);

/* Puts the scene's loads on the functions of u, v and w; once, before the first step. */
enum status solid_motion_add_loads(struct solid_motion *m,
                                   const struct dead_load_line line[3]);

/* Takes one step of scene->step; an entry of struct model, as the next. *motion is a struct
 * solid_motion. */
enum status solid_motion_step(void *motion, struct counters *counters);

/* Returns energies; the elastic one is NaN under `printed` and `incremental`. */
void solid_motion_energy(const void *motion, struct energy *energy);

#endif
