/* dead_load.h - a scene's loads as forces on the coefficients of tensor-product nets:
 * their work over a displacement sum N_a d_a, N_a a product of functions of u, v, w. */
#ifndef DEAD_LOAD_H
#define DEAD_LOAD_H

#include "models/scene.h"

/* The functions of one direction on [0,1]; along u they are those of each sheet, s. */
struct dead_load_line {
    int n;            /* functions                                                 */
    int degree;       /* degree of the pieces                                      */
    int breaks;       /* values in `at`                                            */
    const double *at; /* [breaks] pieces' ends, non-decreasing, from 0 to 1;
                         NULL: k / (n - 1)                                borrowed */
    /* Evaluates all functions at t, N[n]; NULL: hats at k / (n - 1), 1 if n = 1. */
    void (*value)(const void *context, double t, double *N);
    const void *context;
};

/* Adds to f[sheets][line[0].n][line[1].n][line[2].n][3] [N]. STATUS_MEMORY. */
enum status dead_load_add(const struct scene *scene, const struct dead_load_line line[3],
                          double *f);

/* Computes the scene's loads, *dead[nodes][3], owned by the caller, and adds them to
 * load[nodes][3]; NULL if there are none. */
enum status dead_load_make(const struct scene *scene, const struct dead_load_line line[3],
                           double **dead, double *load);

#endif
