/* krylov.h - Krylov methods for A x = b, by products with A and a symmetric positive
 * definite preconditioner P ~ A^-1. Serial and ordered: the same bits on any machine with
 * the same arithmetic, whatever the number of threads.
 */
#ifndef KRYLOV_H
#define KRYLOV_H

#include "models/status.h"

struct krylov {
    int n;
    void *self;
    void (*multiply)(void *self, const double *x, double *y);            /* y = A x    */
    enum status (*precondition)(void *self, const double *x, double *y); /* y = P x    */
    double tolerance; /* relative, see below                                           */
    double near;      /* conjugate gradients: see there; 0: not asked                  */
    int most;         /* iterations                                                    */
    double *work;     /* [krylov_work(n)]                                     borrowed */
    bool multiplied;  /* conjugate gradients: work[n] is A x already; cleared          */
    int iterations;   /* products of P that the last call took, written                */
};

/* Returns a b, added one after the other; all vectors have n entries. */
double krylov_product(int n, const double *a, const double *b);

/* Return the numbers of work space: conjugate gradients; GMRES. */
size_t krylov_cg_work(int n);
size_t krylov_gmres_work(int n);

/* Solves by conjugate gradients (Hestenes, Stiefel 1952) from x[n], A symmetric positive
 * definite. *done: the residual r in the norm of P is below `tolerance` times the larger of
 * its first value and (x b)^1/2 of the guess, about its value at x = 0; or no vector of
 * three entries of P r, the estimated error of x, is longer than `near`. STATUS_INDEFINITE
 * where A or P turns out not to be positive definite, STATUS_NAN. */
enum status krylov_cg(struct krylov *k, const double *b, double *x, bool *done);

/* Solves by GMRES (Saad, Schultz 1986; modified Gram-Schmidt, restarted after
 * KRYLOV_RESTART products) from x[n], preconditioned from the left: the norm is that of P
 * r, of P b. A need not be definite. STATUS_NAN. */
enum { KRYLOV_RESTART = 60 };
enum status krylov_gmres(struct krylov *k, const double *b, double *x, bool *done);

#endif
