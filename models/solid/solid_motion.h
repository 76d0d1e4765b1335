/* solid_motion.h - the motion of a solid in time:
 *
 *   linear       small strain about the rest shape; K, M constant, one factorisation.
 *   printed      Ren et al. 2024, eq. 18-22 to the letter: K, M, b rebuilt on the present
 *                control points each step, d += dt v + dt^2/4 (a + a_new), P += d.
 *   incremental  the same with d = 0 after each step.
 *   nonlinear    total Lagrangian, Newton's method (solid_large.h).
 *
 * `printed` and `incremental` start at d = v = a = 0 in a scene at rest, `linear` with the
 * acceleration that the loads give. A free sheet under `printed` falls with
 * g (1 + mu) / (2 (1 - mu)): d is never reset, so it acts as velocity times dt, and K d as
 * a viscosity E dt. Body drag, of which the paper has none, therefore acts on d / dt there,
 * and on v elsewhere; and an initial velocity, which it has not either, begins as d / dt.
 */
#ifndef SOLID_MOTION_H
#define SOLID_MOTION_H

#include "models/mechanics/dead_load.h"
#include "models/model.h"
#include "models/solid/solid_state.h"

/* Initialises, including the assembled matrices of the rest shape. `order`: node order for
 * the factorisation or NULL. *m must stay where it is: it holds pointers into itself. */
enum status solid_motion_init(struct solid_motion *m, const struct scene *scene,
                              const struct solid_space *space,
                              const struct discretization *d, const int *order,
                              struct message *why);
void solid_motion_clear(struct solid_motion *m);

/* Puts the scene's loads on the functions of u, v and w; once, before the first step. */
enum status solid_motion_add_loads(struct solid_motion *m,
                                   const struct dead_load_line line[3]);

/* Takes one step of scene->step. */
enum status solid_motion_step(struct solid_motion *m, struct counters *counters);

/* Returns energies; the elastic one is NaN under `printed` and `incremental`. */
void solid_motion_energy(const struct solid_motion *m, struct energy *energy);

void solid_motion_contact(const struct solid_motion *m, struct model_contact *contact);
void solid_motion_size(const struct solid_motion *m, struct model_size *size);

#endif
