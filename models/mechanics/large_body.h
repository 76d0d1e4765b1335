/* large_body.h - a body as stepping, Newton's method and equilibrium see it (march.h): its
 * elements' strains, forces and tangents, which shell, solids and nets provide. */
#ifndef LARGE_BODY_H
#define LARGE_BODY_H

#include <stdbool.h>
#include <stddef.h>

#include "models/status.h"

/* The stress and geometry of an equation: stress of s0 e_old + s1 e(x) on the geometry (1 -
 * g1) x_old + g1 x. */
struct large_path {
    double s0, s1, g1;
    double lag, back;         /* of the body's stiff strains: how much the stress takes of
                                 the step's gain e(x) - e_old, less of the gain before   */
    const double *x_old;      /* [nodes][3]; NULL if g1 == 1                   borrowed   */
    const double *strain_old; /* NULL if s0 == 0                               borrowed   */
    const double *gain;       /* the gain before; NULL if back == 0            borrowed   */
};

extern const struct large_path large_path_statics; /* the stress and geometry of x itself */

/* The stress that the geometric part of a tangent takes; all unset: that of the path. A
 * thin body whose step has turned it has spurious membrane stress to second order in the
 * step, enormous beside the true one; Newton's method then takes an order of magnitude more
 * iterations. */
struct large_foresight {
    const double *strain; /* these strains, such as those at the step's start          */
    const double *change; /* [nodes][3] the change d that led to x: the strains that its
                             linearisation foresaw                                     */
    const double *beside; /* [nodes][3] w with `change`: those of the tangent, whose
                             geometry is not that of x, differ from those at x by the
                             product of w and d, in statics d itself (large_newton.c)  */
    bool none;            /* no stress at all: a tangent that is never indefinite      */
};

/* The body: elements whose nodes have coefficients x[nodes][3], and the functions of
 * each. A thread keeps what it found: geometry, force and tangent come after the
 * element's strain. Elements of one slab are one thread's, in order; slabs s and s + 2
 * share no node. */
struct large_body {
    const void *self;
    int nodes, slabs, threads;
    const int *slab; /* [slabs + 1]                                          borrowed  */
    long pairs;      /* blocks of K                                                    */
    size_t strains;  /* numbers an element                                             */
    size_t lagged;   /* the first of these, to which the lag applies                   */

    bool plain; /* one element, whose tangent takes no stress: its geometry, x itself, is
                   set alone, and all of K written. Its damping is by the tangent where a
                   step begins, not by the rate of strains.                               */

    /* Returns strains at x, in the thread's own room, or NULL if x is not a valid shape
     * there. With `foresight` they are the strains that its change's linearisation foresaw;
     * bodies of no membrane that steps turn far may take `change` for `beside`. */
    double *(*strain)(const void *self, int thread, int element, const double *x,
                      const struct large_foresight *foresight);
    /* Sets the geometry to (1 - share) x_old + share x; x_old is NULL if share == 1. */
    void (*geometry)(const void *self, int thread, int element, const double *x_old,
                     double share);
    /* Add the element's part to force[nodes][3] and K[pairs], of the strains in the
     * room. */
    void (*force)(const void *self, int thread, int element, double *force);
    void (*tangent)(const void *self, int thread, int element,
                    const struct large_path *path, double (*K)[9]);
    /* Returns elastic energy at x [J]; for explicit steps. STATUS_NAN or _INVERTED. */
    enum status (*energy)(const void *self, const double *x, double *energy);
};

/* Returns the length of an array of strains. */
size_t large_body_strains(const struct large_body *b);

/* Evaluate all elements, in parallel; the sums' order does not depend on the number of
 * threads. STATUS_NAN, or STATUS_INVERTED where x is not a valid shape; results are then
 * unusable.
 *
 * K is symmetric: exact in statics without foresight; in time, where the derivative of the
 * force is not symmetric, with the geometry's strain variations on both sides, and without
 * terms that are negligible beside the inertia (shell_element.h). */
enum status large_body_strain(const struct large_body *b, const double *x, double *strain);
enum status large_body_force(const struct large_body *b, const struct large_path *path,
                             const double *x, double *force);
enum status large_body_tangent(const struct large_body *b, const struct large_path *path,
                               const double *x, struct large_foresight foresight,
                               double (*K)[9]);

#endif
