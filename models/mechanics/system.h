/* system.h - the symmetric positive definite system k K + m M of a vector field with held
 * unknowns (Dirichlet data by elimination; Ren et al. 2024, eq. 20-22): pattern and
 * symbolic factorisation once, numbers as often as needed. It is solved by a factor, or
 * iteratively (iterative.h) where the discretization's solver says so. */
#ifndef SYSTEM_H
#define SYSTEM_H

#include "models/linalg/blocks.h"
#include "models/linalg/factor.h"
#include "models/mechanics/iterative.h"
#include "models/supports.h"
#include "models/model.h"

struct system {
    const struct blocks *graph;  /* borrowed                                        */
    const struct supports *held; /* borrowed                                        */
    const unsigned char *parity; /* borrowed or NULL                                */
    struct factor *factor;       /* NULL: preconditioned by other means             */
    struct iterative *iterative; /* NULL: solved by the factor; owned, as it is     */
    void *room;      /* memory of the arrays                                    owned   */
    ptrdiff_t *slot; /* [pairs][9] place of each block entry in the factor's values     */
    double *packed;  /* [free_count]                                                    */
    long factorisations; /* system_work                                                */
};

/* Initialises; *s must stay where it is. parity[nodes][3] or NULL: entries that couple
 * unlike parities are left out (they must be zero; see solid_space.h). order[nodes] or
 * NULL: a node order for the factorisation. d has the solver; NULL: a factor, as the
 * program chooses. */
enum status system_init(struct system *s, const struct blocks *graph,
                        const struct supports *held, const unsigned char *parity,
                        const int *order, const struct discretization *d);
void system_clear(struct system *s);

/* Finds the parity of a flat sheet, of functions of the mid-surface or of Legendre
 * functions through the thickness, so many of each column, in linear kinematics: what moves
 * along the normal by even ones, or across it by odd ones, is bending. *parity, owned by
 * the caller, stays NULL unless there is one sheet whose normal is a coordinate axis.
 * STATUS_MEMORY. */
enum status system_parity(const struct scene *scene, int nodes, int layers,
                          unsigned char **parity);

/* Has a factored system, one of a row that differ little (system_update), solved by
 * conjugate gradients on an earlier factor, where a factorisation takes so long that this
 * pays. STATUS_MEMORY. */
enum status system_iterate(struct system *s);

/* Returns the size as a model reports it (model.h); unknown_basis is static. */
struct model_size system_size(const struct system *s, const char *unknown_basis);

/* Factorises k K + m M; M may be NULL if m == 0. STATUS_INDEFINITE if it can't be. */
enum status system_factor(struct system *s, double k, const double (*K)[9], double m,
                          const double *M);

/* Factorises one of a row of systems that differ little, as in steps in time and
 * iterations: iterative solvers keep an earlier factor as preconditioner. Counts its
 * factorisations in system_work, as system_factor does not. */
enum status system_update(struct system *s, double k, const double (*K)[9], double m,
                          const double *M);

/* Makes factors of a system that is iterated in single precision (iterative_single), unless
 * they are small. */
void system_single(struct system *s);

/* Adds to *counters the factorisations of system_update and system_solve since the last
 * call, and a solve for each product with the preconditioner but the first of each
 * system_solve, which its caller counts. */
void system_work(struct system *s, struct counters *counters);

/* Solves for the free unknowns: x[nodes][3] holds the right-hand side on entry, the
 * solution on return; held entries become zero. */
enum status system_solve(struct system *s, double *x);

/* Makes the lower triangle by columns of the free unknowns of k K + m M for eigen.h and
 * the like: start[free_count + 1], row and value [start[free_count]], all owned by the
 * caller. */
enum status system_columns(const struct blocks *graph, const struct supports *held,
                           const unsigned char *parity, double k, const double (*K)[9],
                           double m, const double *M, long **start, int **row,
                           double **value);

#endif
