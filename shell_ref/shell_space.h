/* shell_space.h - a bivariate B-spline or NURBS surface as the shell's assembly sees it:
 * elements (non-empty knot spans), their control points, and their basis functions with
 * first and second derivatives at the quadrature points of three rules.
 *
 * Control points are numbered v fastest: node = i m + j for i < n, j < m; elements
 * likewise.
 */
#ifndef SHELL_SPACE_H
#define SHELL_SPACE_H

#include "iga/bspline.h"

/* Rows of Gauss points and of functions are padded with zeros to a multiple of it, so that
 * the kernels, vectors of 4 doubles, have no remainders. */
enum { SHELL_LANES = 4 };
#define SHELL_PADDED(count) (((count) + SHELL_LANES - 1) / SHELL_LANES * SHELL_LANES)

enum {
    SHELL_MAX_LOCAL = BSPLINE_MAX_ORDER * BSPLINE_MAX_ORDER,
    SHELL_MAX_GAUSS = 8, /* points per span and direction                              */
    SHELL_MAX_POINTS = SHELL_MAX_GAUSS * SHELL_MAX_GAUSS,
};

/* Derivatives in the order of the tables: N, N_u, N_v, N_uu, N_vv, N_uv; of the rules that
 * bending has no part in, the first three. */
enum { SHELL_DERIVATIVES = 6, SHELL_SLOPES = 3 };

/* What is integrated, each by its own points. */
enum { SHELL_MEMBRANE, SHELL_BENDING, SHELL_PARTS, SHELL_MASS = SHELL_PARTS, SHELL_RULES };

/* Quadrature along one direction: points, weights, and values and two derivatives of the
 * functions alive there. */
struct shell_line {
    int most;       /* points a span, where they are most                              */
    int *points;    /* [spans] points in use                                   owned   */
    double *weight; /* [spans][most]                                           owned   */
    double *table;  /* [spans][most][3][order]                                 owned   */
};

struct shell_rule {
    struct shell_line line[2]; /* u, v                                                 */
    int padded; /* rows of an element's points: the most it can have, padded           */
};

struct shell_direction {
    int order, spans;
    int *span; /* [spans] knot index                                           owned   */
};

struct shell_space {
    struct bspline basis[2]; /* u, v                                           owned   */
    void *room;              /* of weight, rest and ien                        owned   */
    double *weight;          /* [nodes] > 0; NULL: all 1                               */
    double *rest;            /* [nodes][3] control points at rest  [m]                 */
    int nodes, elements;
    int local; /* functions per element, (p+1)(q+1)                                    */
    struct shell_direction direction[2];
    struct shell_rule rule[SHELL_RULES];
    int *ien;         /* [elements][local] ascending                                   */
    int slabs, *slab; /* elements slab[s] .. slab[s+1]; s and s+2 share no node owned  */
};

/* Copies bases, control points point[nodes][3] and weights (NULL: all 1).
 *
 * All three rules have gauss[2] points a span, 0: degree + 1, unless `selective`: then the
 * membrane has as many points as there are functions (bspline_reduced_points), which cures
 * its locking, bending p - 1 a span, which see every polynomial that second derivatives of
 * degree p square to, and the mass p + 1.
 *
 * STATUS_INPUT with a sentence unless degrees are 2 or more (a Kirchhoff-Love shell needs
 * slopes that are continuous), inner knots are repeated at most p - 1 times and
 * 0 <= gauss <= SHELL_MAX_GAUSS. */
enum status shell_space_init(struct shell_space *space, const struct bspline basis[2],
                             const double *point, const double *weight, const int gauss[2],
                             bool selective, struct message *why);
void shell_space_clear(struct shell_space *space);

/* Points of a rule in an element, q = qu points_v + qv, and their parametric weights. */
int shell_space_points(const struct shell_space *space, int rule, int element);
void shell_space_weights(const struct shell_space *space, int rule, int element,
                         double *weight);

/* T[SHELL_DERIVATIVES or SHELL_SLOPES][local][padded] of one element, the rule's points
 * running fastest; zeros in the padding. Pure: any thread. */
void shell_space_functions(const struct shell_space *space, int rule, int element,
                           double *T);

/* The functions alive at (u,v): T[SHELL_DERIVATIVES][local] and their nodes node[local]. */
void shell_space_at(const struct shell_space *space, double u, double v, int *node,
                    double *T);

#endif
