/* ichol.h - incomplete Cholesky factor without fill-in, IC(0) (Meijerink, van der Vorst,
 * Math. Comp. 31, 1977): a preconditioner. Where a pivot is not positive the diagonal grows
 * and the factorisation starts again (Manteuffel, Math. Comp. 34, 1980). */
#ifndef ICHOL_H
#define ICHOL_H

#include "models/linalg/factor.h"

struct ichol;

/* Creates a factor; of the pattern (factor.h) the order is not used. Owned by the
 * caller. */
enum status ichol_create(const struct factor_pattern *pattern, struct ichol **f);
void ichol_destroy(struct ichol *f); /* NULL is allowed */

/* Returns the values to fill before ichol_refactor, which leaves them. Borrowed. */
double *ichol_values(struct ichol *f);

/* Factors. STATUS_INDEFINITE if a diagonal is not positive or the shift passes 1. */
enum status ichol_refactor(struct ichol *f);

/* Computes x = (L L^T)^-1 x. */
void ichol_solve(const struct ichol *f, double *x);

#endif
