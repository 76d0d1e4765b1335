/* frequency.h - the largest natural frequency of a body, which limits explicit steps.
 * Lanczos' method finds it from below, without reorthogonalisation (the extreme value does
 * not need it), in 200 steps at most. */
#ifndef FREQUENCY_H
#define FREQUENCY_H

#include "models/linalg/blocks.h"
#include "models/supports.h"

/* The most explicit steps of a frame. */
enum { FREQUENCY_MOST_STEPS = 1000000 };

/* Finds it with lumped mass[nodes]; K[pairs of graph][9]. 0 if nothing can move. `beyond`
 * [pairs] as large_body.h's, NULL: none. STATUS_MEMORY. */
enum status frequency_largest(const struct blocks *graph, const struct supports *supports,
                              const double *mass, const double *beyond,
                              const double (*K)[9], double *omega);

/* A stiffness as the forces that it makes: computes y = K x, [nodes][3], in the free
 * unknowns at least. x is zero in the others, and x' M x = 1 kg m^2. */
struct frequency_body {
    const struct supports *supports;
    const double *mass; /* [nodes] */
    void (*multiply)(const void *self, const double *x, double *y);
    /* optional: y = `beyond` x, as large_body.h's; by frequency_largest from a matrix */
    void (*beyond)(const void *self, const double *x, double *y);
    const void *self;
};
enum status frequency_of_body(const struct frequency_body *body, double *omega);

/* Returns the greatest stable step of explicit steps (leapfrog, symplectic Euler) with this
 * frequency [rad/s] and stiffness damping beta [s]: INFINITY if nothing can move. */
double frequency_limit(double omega, double beta);

/* The chosen step, as a share of the greatest stable one about rest. */
extern const double frequency_chosen;

/* Chooses the number of steps of a frame [s], `asked` or, if 0, as many as keep that share
 * of the limit. STATUS_INPUT with a sentence if they are more than a million. */
enum status frequency_steps(double frame, double limit, int asked, int *steps,
                            struct message *why);

#endif
