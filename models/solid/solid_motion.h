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
 * Contact under `nonlinear` acts on the mid-surface, as in large_motion.h; `linear` refuses
 * it. Of contact, the paper says only that it is looked for at the control net (4.2), so
 * that `printed` and `incremental` do the least: after a step, and the damping of
 * velocities, what is inside a body, of the control points or samples of both faces, is put
 * on its surface (contact_outside.h), and velocities lose what points into the body. Let s
 * be the way of the body's point in the step, and n its normal. A body that goes on at its
 * speed s / dt is not entered by a point that goes on with it, under no force, if
 *
 *   printed      d . n >= s . n  and  v . n >= 0, where d is the increment of P, and v dt
 *                that of d, 0 at a constant speed;
 *   incremental  d . n >= s . n  and  v . n >= s . n / dt, where v is the velocity of P.
 *
 * d and v lose what they lack of that; so afterwards d is not the last increment of P, but
 * what goes on from it. a stays: contact is an impulse at the step's end, and a, by which
 * loads and stress move the sheet, has none of it. There is no friction, no energy, and no
 * force to report. The sheet does not meet itself: that it crosses is counted where it is
 * looked at.
 */
#ifndef SOLID_MOTION_H
#define SOLID_MOTION_H

#include "models/contact/contact_outside.h"
#include "models/mechanics/dead_load.h"
#include "models/mechanics/large_motion.h"
#include "models/mechanics/newmark.h"
#include "models/solid/solid_green.h"

/* What meets bodies: the mid-surface w = 1/2, or a face w = 0 or 1; `self` of its rows. */
struct solid_face {
    const void *body; /* the model's                                                   */
    double w;
};

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
    struct solid_face face[CONTACT_OUTSIDE_FACES];
    struct contact contact;         /* nonlinear                                       */
    struct contact_outside outside; /* printed, incremental                            */

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

/* After solid_motion_init: names the surfaces that meet bodies, from face 0 on, up to NULL,
 * which is the first where there is nothing to meet; and takes the surface of one over. */
const struct solid_face *solid_motion_face(struct solid_motion *m, const void *body,
                                           int face);
enum status solid_motion_meet(struct solid_motion *m, const struct solid_face *face,
                              struct contact_surface *surface);

/* Puts the scene's loads on the functions of u, v and w; once, before the first step. */
enum status solid_motion_add_loads(struct solid_motion *m,
                                   const struct dead_load_line line[3]);

/* Takes one step of scene->step; an entry of struct model, as the next. *motion is a struct
 * solid_motion. */
enum status solid_motion_step(void *motion, struct counters *counters);

/* Returns energies; the elastic one is NaN under `printed` and `incremental`. */
void solid_motion_energy(const void *motion, struct energy *energy);

#endif
