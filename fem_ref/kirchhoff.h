/* kirchhoff.h - linear Kirchhoff plate, one edge clamped, three free (CFFF): static
 * deflection and the motion from rest under a suddenly applied uniform load, exact in time.
 * A truth that no cloth model shares.
 *
 * Plate 0 <= x <= L, 0 <= y <= W, clamped along x = 0; deflection w along the normal,
 *   D lap lap w + rho h (w_tt + alpha w_t) = q,   D = E h^3 / 12 (1 - nu^2),
 * by Ritz's method on products of the functions of struct ritz: the eigenproblem M c = mu K
 * c, mu = 1 / omega^2, solved dense (LAPACK dsygvd) for modes even in y - W/2. With
 * K-orthonormal modes c_i the static answer is sum (c_i . f) c_i and the motion only
 * multiplies its terms by 1 - cos(omega_i t): nothing is divided by a small omega.
 *
 * Exact for nu = 0 under uniform load (w is then a polynomial). For nu > 0 the corners of
 * the clamped edge hold a weak singularity, which sets the pace of convergence; see
 * KIRCHHOFF_TERMS for what is reached. Poisson's ratio outside [0, 0.5) is not verified.
 */
#ifndef KIRCHHOFF_H
#define KIRCHHOFF_H

#include "models/scene.h"
#include "models/status.h"

/* Polynomial functions of one direction, for plates by Ritz's method.
 *
 * On x in [0,1] the functions phi_0 .. phi_{count-1} are double integrals of Legendre
 * polynomials, normalised so that the integral of (phi_i'')^2 is 1: phi_i'' is the
 * orthonormal Legendre polynomial of some degree. Their stiffness matrix is the identity
 * and only neighbours couple in the mass matrix, so that high degrees stay well
 * conditioned where powers of x are hopeless beyond degree 10. Every function is held as
 * its Legendre coefficients; integrals follow from orthogonality, without quadrature.
 *
 * Source: integrated Legendre (hierarchic) shape functions, Szabo and Babuska, Finite
 * Element Analysis, 1991, section 3.1, integrated twice here for C1 conformity.
 */

enum { RITZ_MAX = 96 };

enum ritz_end {
    RITZ_CLAMPED_FREE, /* phi(0) = phi'(0) = 0, free at 1                             */
    RITZ_FREE_FREE,    /* 1, x - 1/2, then the others; even i: even about 1/2         */
};

struct ritz {
    int count;              /* functions                                              */
    int terms;              /* Legendre coefficients of each, count + 3               */
    double *coefficient[3]; /* [d][count][terms]: of d^d phi_i / dx^d in P_k(2x - 1)  */
};

/* Makes functions of every degree up to count + 1 (clamped) or count - 1 (free). 4 <= count
 * <= RITZ_MAX. Caller owns; ritz_clear accepts all-zero. */
enum status ritz_init(struct ritz *r, enum ritz_end end, int count);
void ritz_clear(struct ritz *r);

/* Evaluates derivatives of order d (0..2) of all functions at x in [0,1], out[count]. */
void ritz_eval(const struct ritz *r, int d, double x, double *out);

/* Returns the integral over [0,1] of (d^a phi_i) (d^b phi_j). */
double ritz_product(const struct ritz *r, int a, int i, int b, int j);

/* Returns the integral over [0,1] of phi_i. */
double ritz_integral(const struct ritz *r, int i);

/* Functions per direction that give, on the square plate with nu = 0.3, the static
 * deflection to KIRCHHOFF_ERROR and the motion of scene cantilever_transient at 0.1 .. 0.4
 * s (rms over the plate) to KIRCHHOFF_TRANSIENT_ERROR, both over the largest deflection
 * then. Measured against 64 functions: 3e-8 static; 4e-6, 1e-6, 6e-7, 4e-7 at 0.1 .. 0.4 s.
 */
enum { KIRCHHOFF_TERMS = 48 };
#define KIRCHHOFF_ERROR           1e-7
#define KIRCHHOFF_TRANSIENT_ERROR 1e-5

struct kirchhoff_plate {
    double length, width, thickness; /* L, W, h                              [m] > 0    */
    double young, poisson, density;  /* E, nu, rho                  [Pa], -, [kg/m^3]   */
};

struct kirchhoff; /* immutable once made: may be read by any thread */

/* Solves with `terms` functions in each direction, 4 <= terms <= RITZ_MAX: an eigenproblem
 * with terms^2 / 2 unknowns, about 1 s at 48. Freed with kirchhoff_destroy (NULL is
 * allowed). */
enum status kirchhoff_create(const struct kirchhoff_plate *plate, int terms,
                             struct kirchhoff **k);
void kirchhoff_destroy(struct kirchhoff *k);

/* Returns the deflection [m] at (x, y) under load q [N/m^2]. */
double kirchhoff_static(const struct kirchhoff *k, double q, double x, double y);

/* Returns the deflection [m] at (x, y) at time t >= 0 [s] after q was applied to the plate
 * at rest; alpha >= 0 [1/s] is the mass damping. t = INFINITY: the static answer. */
double kirchhoff_transient(const struct kirchhoff *k, double q, double alpha, double t,
                           double x, double y);

/* Computes that motion at the nodes of a grid, x[nx] times y[ny]: deflection and slopes, w,
 * w_x, w_y, each [ny][nx]. */
enum status kirchhoff_grid(const struct kirchhoff *k, double q, double alpha, double t,
                           int nx, const double *x, int ny, const double *y, double *w,
                           double *w_x, double *w_y);

/* This truth as positions of the material grid, for scenes that are a cantilevered sheet
 * under its own weight. */

/* Finds the plate of a scene: whole edge u = 0 held in x, y, z at rest, gravity along the
 * normal, no or mass damping, from rest, nothing else. Otherwise STATUS_UNSUPPORTED and a
 * sentence. */
enum status kirchhoff_field_plate(const struct scene *scene, struct kirchhoff_plate *plate,
                                  struct message *why);

/* Computes positions xyz[times][GRID_W][GRID_V][GRID_U][3] [m] (grid.h) of such a scene at
 * time[times] >= 0 (INFINITY: in equilibrium under its weight) by Kirchhoff's linear
 * kinematics: a point z above the mid-surface moves by w e_w - z grad w. `terms` as for
 * kirchhoff_create. Statuses of both. */
enum status kirchhoff_field(const struct scene *scene, int terms, int times,
                            const double *time, double *const *xyz, struct message *why);

#endif
