/* newmark.h - one step of M a + C v + K d = f by Newmark's average acceleration
 * (beta = 1/4, gamma = 1/2; Newmark 1959; Ren et al. 2024, eq. 18-19), C = alpha M + beta
 * K.
 *
 * The paper solves (M + dt^2/4 K) a = f - K (d + dt v + dt^2/4 a_old). With the predictor
 * p = d + dt v + dt^2/4 a_old the same equation reads (M + c K)(a + p/c) = f + M p/c,
 * c = dt^2/4: a product with M (a ninth of the numbers) in place of one with K.
 */
#ifndef NEWMARK_H
#define NEWMARK_H

#include "models/mechanics/system.h"

struct newmark {
    double dt;          /* [s]                                                         */
    double alpha, beta; /* Rayleigh damping [1/s], [s]                                 */
    double gamma;       /* K + gamma M acts on d [1/s^2]; 0 unless set after init      */
    double *d, *v, *a;  /* [nodes][3] displacement, velocity, acceleration             */
    double *work;       /* [3][nodes][3]                                               */
};

/* Starts with all zero. */
enum status newmark_init(struct newmark *n, int nodes, double dt, double alpha,
                         double beta);
void newmark_clear(struct newmark *n);

/* Return the factors of K and M in the step's system: k K + m M. */
double newmark_k(const struct newmark *n);
double newmark_m(const struct newmark *n);

/* The motion of the held unknowns at the end of the step, each [held_count]. */
struct newmark_held {
    const double *d, *v, *a;
};

/* Returns the motion by the supports' paths at time t, by central differences over +-dt;
 * borrowed from room[4][held_count]. */
struct newmark_held newmark_follow(const struct supports *s, const struct scene *scene,
                                   double t, double dt, double *room);

/* Computes the acceleration of the present d and v (rest, static equilibrium, any start):
 *   M a = load - M alpha v - K (d + beta v),
 * held unknowns taking the motion given (NULL: at rest); then factors the steps' system in
 * `s`. Counts both factorisations. */
enum status newmark_begin(struct newmark *n, struct system *s, const double (*K)[9],
                          const double *M, const double *load,
                          const struct newmark_held *held, struct counters *counters);

/* Takes one step. `s` holds the factor of newmark_k K + newmark_m M; load[nodes][3] [N] at
 * the end of the step. `held` NULL: held unknowns stay as they are (at rest), and K is not
 * read; it may then be NULL. */
enum status newmark_step(struct newmark *n, struct system *s, const double (*K)[9],
                         const double *M, const double *load,
                         const struct newmark_held *held);

/* Do the two halves of a step, for callers that solve between them: the right-hand side of
 *   (newmark_k K + newmark_m M) w = rhs,   newmark_k w = d + beta v at the end of the step,
 * is left in n->work[nodes][3], without the part of held unknowns; then w (which may
 * be n->work; held entries are not read) becomes the new d, v, a. */
void newmark_predict(struct newmark *n, struct system *s, const double (*K)[9],
                     const double *M, const double *load, const struct newmark_held *held);
void newmark_correct(struct newmark *n, const struct system *s, const double *w,
                     const struct newmark_held *held);

#endif
