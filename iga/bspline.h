/* bspline.h - univariate B-spline basis functions.
 *
 * Notation: degree p, n functions N_0..N_{n-1}, knots U[0 .. n+p] (n+p+1 of them), open:
 * p+1 equal knots at either end, non-decreasing, U[0] = 0, U[n+p] = 1, inner multiplicity
 * <= p (continuity C^{p-m} >= C^0). On span k, U[k] <= u < U[k+1], exactly the p+1
 * functions N_{k-p}..N_k are not zero; every routine returns only those.
 *
 * A basis may be several of such parts, alike and side by side on [0, parts], for as many
 * sheets: a knot between two parts is there p + 1 times, so that nothing connects them.
 *
 * A closed basis is periodic: uniform knots of step 1 / (n - p) from -p steps to 1 + p
 * steps, and its last p functions are the first p again. Source: Piegl & Tiller 1997, The
 * NURBS Book, ch. 2; numbering of algorithms from there.
 */
#ifndef BSPLINE_H
#define BSPLINE_H

#include "models/discretization.h"

enum { BSPLINE_MAX_DEGREE = 5, BSPLINE_MAX_ORDER = BSPLINE_MAX_DEGREE + 1 };

struct bspline {
    int p;     /* degree 1..BSPLINE_MAX_DEGREE                                         */
    int n;     /* functions, > p                                                       */
    double *U; /* knots [n + p + 1]                                            owned   */
    int parts; /* 0, 1: one                                                            */
    int wrap;  /* functions at the end that are the first ones again: p if closed, or 0 */
};

/* Makes uniform open knots. STATUS_INPUT (with sentence) unless 1 <= p <= max and n > p. */
enum status bspline_init_uniform(struct bspline *b, int p, int n, struct message *why);

/* Makes a closed basis of `points` > p different functions. STATUS_INPUT otherwise. */
enum status bspline_init_closed(struct bspline *b, int p, int points, struct message *why);

/* Returns the number of different functions, and the number, below it, of function i. */
int bspline_points(const struct bspline *b);
int bspline_point(const struct bspline *b, int i);

/* Copies given knots U[count]; n = count - p - 1. STATUS_INPUT, saying which rule of the
 * notation above they break. */
enum status bspline_init(struct bspline *b, int p, int count, const double *U,
                         struct message *why);

/* Makes direction i of a discretization: its knots, or uniform ones. */
enum status bspline_init_direction(struct bspline *b, const struct discretization *d, int i,
                                   struct message *why);
/* Returns the degree of a direction that leaves it open: `usual`, or what its knots imply,
 * or what few points allow. */
int bspline_open_degree(const struct discretization *d, int i, int usual);
enum status bspline_copy(const struct bspline *from, struct bspline *to);
void bspline_clear(struct bspline *b);

/* Puts so many copies of a basis of one part in its place. STATUS_MEMORY. */
enum status bspline_repeat(struct bspline *b, int parts);

/* Returns a part, k <= u <= k + 1, whose functions begin at k n of the basis; borrows its
 * knots. */
struct bspline bspline_part(const struct bspline *b, int k);

/* Evaluates as bspline_eval the functions alive at s, 0 to 1, of a part, out[order + 1][p +
 * 1]; returns the first. */
int bspline_alive(const struct bspline *b, int part, double s, int order, double *out);

/* Returns span k of u in [0,1]; u = 1 belongs to the last non-empty span (A2.1). Below 0
 * and above 1 it is the first and the last span, whose polynomials bspline_eval then
 * continues. */
int bspline_span(const struct bspline *b, double u);

/* Values and derivatives of the p+1 functions alive on `span` (not empty), at u: eq. 2.7.
 *   out [order + 1][p + 1]; out[d][a] = d^d N_{span-p+a} / du^d;   order 0..p
 * Pure, no allocation: safe from any thread. */
void bspline_eval(const struct bspline *b, int span, double u, int order, double *out);

/* Computes values of all n functions of the struct bspline *b at u, N[n]. */
void bspline_values(const void *b, double u, double *N);

/* Returns the number of non-empty spans and writes the knot index k of each, ascending;
 * span has room for n - p. */
int bspline_spans(const struct bspline *b, int *span);

/* Returns the Greville abscissa of function i: (U[i+1] + ... + U[i+p]) / p. With these as
 * control points the curve is the identity. Of a closed basis it is moved into [0,1). */
double bspline_greville(const struct bspline *b, int i);

#endif
