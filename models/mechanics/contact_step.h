/* contact_step.h - steps in time of bodies that meet obstacles: what the schemes share.
 *
 * A contact force r that is constant over the step, where a point in contact moves by
 * exactly its gap, does the work -r_n gap0 <= 0. What velocity such a point has left, into
 * the obstacle or off it, is then taken away in the norm of M: an inelastic impact, without
 * which points in contact would be thrown back at every step (the oscillation that
 * Deuflhard, Krause, Ertel 2008, Int. J. Numer. Meth. Engng. 73, remove by projecting the
 * predictor). A projection shortens: neither adds energy.
 */
#ifndef CONTACT_STEP_H
#define CONTACT_STEP_H

#include "models/mechanics/contact_solve.h"
#include "models/mechanics/newmark.h"

struct contact_step {
    struct contact_set set;
    struct system mass;  /* M, for impacts                                              */
    double (*arrest)[9]; /* [nodes] projectors of the present impact           owned   */
};

/* Nothing is allocated for a scene without obstacles: contact_set_used says false.
 * offset: contact_set.h; order as for system_init. */
enum status contact_step_init(struct contact_step *c, const struct scene *scene,
                              const struct blocks *graph, const struct supports *supports,
                              double offset, const int *order,
                              const struct discretization *d);
void contact_step_clear(struct contact_step *c);

/* Makes the inelastic impact of the points in contact: v <- the velocity nearest to it in
 * the norm of M that has none along the set's normals, nor any where a point sticks. The
 * impulse times `unit` is added to the set's forces; dt is the step [s]. work: 2
 * [nodes][3]. */
enum status contact_step_impact(struct contact_step *c, const double *M, double dt,
                                double unit, double *v, double *work,
                                struct counters *counters);

/* Takes a step of the trapezoidal rule with r constant over the step,
 *     M (v1 - v0) / dt = f - K (d0 + d1) / 2 - C (v0 + v1) / 2 + r,
 *     d1 - d0 = dt (v0 + v1) / 2,
 * that is average acceleration with the contact force taken wholly at the step's end (Kane,
 * Repetto, Ortiz, Marsden 1999, Comput. Methods Appl. Mech. Engrg. 180; Kane, Marsden,
 * Ortiz, West 2000), which spares it the half of the last step's force that makes Newmark's
 * method gain energy; then the impact.
 * Bound: E1 - E0 = -sum r_n gap0 - friction - damping - impact <= 0 up to round-off, for
 * every step size, with E = v'Mv/2 + d'Kd/2 - f'd. Impact loses the energy of the points
 * that touch, which is none in the limit of a fine net.
 * n->a is not used. x[nodes][3]: where the step starts; `held` as for newmark_step. Forces
 * of the set come out in N s: contact_set_report with 1 / dt. */
enum status contact_step_linear(struct contact_step *c, struct newmark *n, struct system *s,
                                const double (*K)[9], const double *M, const double *load,
                                const struct newmark_held *held, const double *x,
                                struct counters *counters);

#endif
