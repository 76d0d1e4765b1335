/* backward.h - second order in time for schemes that are written as implicit Euler: BDF2
 * (Curtiss and Hirschfelder 1952). Of x' = v, v' = a,
 *     x_n+1 = o + s v_n+1,    o = (4 x_n - x_n-1) / 3,    s = 2 dt / 3,
 *     v_n+1 = w + s a_n+1,    w = (4 v_n - v_n-1) / 3,
 * a step of implicit Euler over s from position o and velocity w: its matrix is constant
 * where Euler's is. A-stable and damping as Euler's, of amplitudes a part (omega dt)^4 / 4
 * a step for (omega dt)^2 / 2.
 */
#ifndef BACKWARD_H
#define BACKWARD_H

#include "models/status.h"

/* The history of `count` coordinates [m]; those of held points follow their path. */
struct backward {
    size_t count;
    double *x, *v;          /* a step ago                                              */
    double *origin, *speed; /* o, w                                                    */
    void *room;             /* memory of the arrays; NULL: not in use          owned   */
};

/* Allocates; *b must be all zero, or initialised. */
enum status backward_init(struct backward *b, size_t count);
void backward_clear(struct backward *b);

/* Makes the history of x, v with the constant acceleration a, all [count]; NULL: none. */
void backward_start(struct backward *b, double dt, const double *x, const double *v,
                    const double *a);

/* Computes origin and speed of the step from x, v, which then are those of a step ago. */
void backward_begin(struct backward *b, const double *x, const double *v);

/* Follows v <- factor v as an impulse: a step ago it was as much slower, and the
 * acceleration stays. */
void backward_scale(struct backward *b, double dt, double factor, const double *v);

/* Returns s [s]. */
double backward_span(double dt);

#endif
