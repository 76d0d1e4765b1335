/* contact_solve.h - one linear step under contact: the x that minimises x'A x / 2 - b'x
 * with no node beyond the tangent planes of contact_set.h, and friction.
 *
 * Primal-dual active set (Hintermueller, Ito, Kunisch 2003, SIAM J. Optim. 13): solve with
 * the present set, then let go what pulls and take in what has gone too far, until nothing
 * changes. Where that stops making progress, as it may with thin sheets, whose matrix is no
 * M-matrix, the primal active set method takes over (Nocedal, Wright 2006, alg. 16.3): from
 * where nothing has moved, one pair a pass, downhill, so that it ends. A set that the last
 * step has left costs a solve and, on planes, no factorisation.
 *
 * Friction: along the surface a node feels -drag (x - still), in the matrix, with a drag
 * that gives mu lambda at the speed of the last pass, until that repeats (Kacanov's
 * method). It therefore never gains energy, settled or not. What sticks creeps, slower than
 * 1e-7 of what gravity moves from rest in a step. Steps that did not settle are counted in
 * contact_set.
 */
#ifndef CONTACT_SOLVE_H
#define CONTACT_SOLVE_H

#include "models/mechanics/contact_set.h"
#include "models/mechanics/system.h"

/* The passes of a solve over friction: until it settles; one, for an outer iteration that
 * continues from call to call until contact_set is `settled`; or none, with the present
 * drags, for such an iteration that does not end. */
enum contact_friction {
    CONTACT_FRICTION_SETTLES,
    CONTACT_FRICTION_ONCE,
    CONTACT_FRICTION_KEPT
};

/* The problem has A = k K + m M. The unknown x and a node's displacement u over the step
 * are related by x = still + scale u. */
struct contact_problem {
    double k;
    const double (*K)[9];
    double m;
    const double *M;     /* NULL if m == 0                                             */
    const double *b;     /* [nodes][3], without what held unknowns contribute          */
    double scale;        /* > 0                                                        */
    const double *still; /* [nodes][3], or NULL for zeros                              */
    enum contact_friction friction;
};

/* Solves for x[nodes][3]: on entry the held unknowns, on return the solution beside them.
 * Gaps and normals are those of contact_set_detect. Factorises where the system's factor
 * does not fit the set (contact_set_forget). STATUS_DIVERGED if no set is found. */
enum status contact_solve(struct contact_set *c, struct system *s,
                          const struct contact_problem *p, double *x,
                          struct counters *counters);

#endif
