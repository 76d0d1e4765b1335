/* iterative.h - inside system.h: A x = b of a vector field on a node graph by conjugate
 * gradients or GMRES (krylov.h), preconditioned by a factor of an earlier A, by incomplete
 * Cholesky or by the 3 x 3 blocks on the diagonal.
 *
 * An earlier factor is kept while it takes fewer iterations than a new one would cost: A is
 * then factored anew and the iteration goes on from where it is. A body that turns keeps it
 * longer: with the frames Q of its nodes now and then, the factor of the earlier A stands
 * for that of R A R^T, R = Q_now Q_then^T node by node. Counts decide, not clocks.
 */
#ifndef ITERATIVE_H
#define ITERATIVE_H

#include "models/linalg/blocks.h"
#include "models/linalg/factor.h"
#include "models/supports.h"

struct iterative;

/* The owner's functions and data; borrowed until iterative_destroy. */
struct iterative_owner {
    void *self;
    const struct blocks *graph;
    const struct supports *held;
    const unsigned char *parity; /* or NULL                                            */
    /* Factor A (in iterative_matrix's form), and solve with that factor in place. */
    enum status (*factor)(void *self, const double (*A)[9]);
    enum status (*solve)(void *self, double *x);
    void (*precise)(void *self, bool single); /* factor_single                         */
    int patience; /* iterations that cost as much as a factorisation                   */
};

/* Creates; for incomplete Cholesky: `pattern` (free unknowns), and entry[pairs][9], the
 * places in it of A's entries, -1: none. Owned by the caller. */
enum status iterative_create(const struct iterative_owner *owner,
                             const struct factor_pattern *pattern, const long *entry,
                             enum solver solver, enum preconditioner preconditioner,
                             struct iterative **it);
void iterative_destroy(struct iterative *it); /* NULL is allowed */

/* Returns A[pairs][9] to fill before iterative_update, which clears entries that belong to
 * held unknowns or couple unlike parities. Borrowed. */
double (*iterative_matrix(struct iterative *it))[9];

/* Notes that A is new. keep: an earlier factor may be kept. STATUS_INDEFINITE if the
 * preconditioner cannot be made. */
enum status iterative_update(struct iterative *it, bool keep);

/* Follows the nodes' frames, three orthonormal columns each, of the present A: Q[nodes][9],
 * filled by `frames` at each iterative_update. guess: right-hand sides follow one another
 * smoothly, so that solutions are extrapolated. Does nothing for NULL, as the next one. */
enum status iterative_follow(struct iterative *it,
                             void (*frames)(const void *body, double (*Q)[9]),
                             const void *body, bool guess);

/* Sets the tolerance of systems that may keep an earlier factor: relative, in the norm that
 * the preconditioner gives, or `near`, by conjugate gradients, no node farther off; 1e-10
 * and 0 unless set. A system that stands alone gets it from its iterative_update on. */
void iterative_tolerate(struct iterative *it, double tolerance, double near);

/* Makes factors in single precision as long as that works: until one cannot be made so, or
 * takes more than a few iterations on its own A. */
void iterative_single(struct iterative *it);

/* Solves in place, x[nodes][3], zero at held unknowns. STATUS_UNSOLVED if that takes too
 * many iterations, STATUS_INDEFINITE, STATUS_NAN. */
enum status iterative_solve(struct iterative *it, double *x);

enum solver iterative_method(const struct iterative *it);

/* Returns products with the preconditioner and factorisations since the last call. */
void iterative_work(struct iterative *it, long *solves, long *factorisations);

#endif
