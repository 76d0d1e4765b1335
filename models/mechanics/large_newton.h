/* large_newton.h - Newton's method for one equation of a body at large displacements, in
 * statics and in a step:
 *
 *   load F - M mass (x - hat) - f(x) = 0   at the free unknowns.
 *
 * The stress in the tangent's geometric part is what the last step's linearisation foresaw,
 * at first that of m->strain_old (large_foresight; "mixed integration point" Newton of
 * Magisano, Leonetti, Garcea, CMAME 313, 2017). Full steps then converge from afar where a
 * line search on energy or residuals creeps: they judge a step by its spurious stress. The
 * cantilever of 32 cubic spans, h/L = 1e-3, at Gamma = 1000: 29 iterations in 4 increments
 * of the load; with a line search 478. Steps are halved only where the surface they lead to
 * is none. A factored tangent is kept while its steps shrink fast (chord; much faster after
 * a new equation's first step with its own, by far the longest), and for the next
 * equation, of the same mass, if this one did with it from its start: one that is too old
 * costs more in first steps astray than in assemblies (edge_drop, undamped, 5 ms, of
 * the time of keeping it always: shell 10x10, p = 2, .74; IGA selective p = 3, 16x16, .79).
 * In time, a tangent that is not positive definite (a sheet about to buckle) is replaced by
 * one without stress; the next is tried with its stress again. (napkin_hung, solid, 13x13,
 * to 0.4 s: 1101 assemblies, and 2040 where the rest of an equation goes without.)
 */
#ifndef LARGE_NEWTON_H
#define LARGE_NEWTON_H

#include "models/mechanics/march.h"

struct large_equation {
    struct large_path path;
    double mass;       /* >= 0                                                [1/s^2]  */
    const double *hat; /* [nodes][3]; NULL if mass == 0                       borrowed */
    double drag;       /* factor of drag on the way from path.x_old            [1/s]   */
    double viscosity;  /* factor of V on that way                              [1]      */
    double load;       /* factor on m->load                                            */
    double chord;      /* a tangent is kept while steps shrink by this; 0: never       */
    double tolerance;  /* steps below it end the iteration; 0: 1e-7 lengths     [m]    */
    int limit;         /* iterations                                                   */
    int enough;        /* iterations to stop after, converged or not; 0: none          */
};

/* Adds `share` of the forces of supports in a step that this equation took, or in an
 * equilibrium, to m->reaction: at m->x, where contact was found last. Uses m->work. */
enum status large_newton_weigh(struct march *m, const struct large_equation *equation,
                               double share);

/* Solves for x[nodes][3]: predictor on entry, with held unknowns where they shall be;
 * solution on return. Stops when a step is below the tolerance, at most 1e-7 of the sheet's
 * length. Mass that had to be added to the tangent shortens steps before convergence: then
 * the steps must shrink fast as well, as they do towards an unstable equilibrium (which
 * m->added > 0 indicates). STATUS_DIVERGED if that takes too many iterations; the codes of
 * body and factor. */
enum status large_newton_solve(struct march *m, const struct large_equation *equation,
                               double *x, struct counters *counters);

#endif
