/* shell_space.h - a bivariate B-spline or NURBS surface as the shell's assembly sees it:
 * elements (non-empty knot spans), their control points, and their basis functions with
 * first and second derivatives at Gauss points.
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

/* Derivatives in the order of the tables: N, N_u, N_v, N_uu, N_vv, N_uv. */
enum { SHELL_DERIVATIVES = 6 };

/* One direction: values and two derivatives of the functions alive on each span at each of
 * the element's Gauss points, [spans][3][order][padded]. */
struct shell_direction {
    int order, spans;
    int *span;     /* [spans] knot index                                       owned   */
    double *table; /*                                                          owned   */
};

struct shell_space {
    struct bspline basis[2]; /* u, v                                           owned   */
    void *room;              /* of weight, rest, parametric and ien            owned   */
    double *weight;          /* [nodes] > 0; NULL: all 1                               */
    double *rest;            /* [nodes][3] control points at rest  [m]                 */
    int nodes, elements;
    int local;         /* functions per element, (p+1)(q+1)                           */
    int gauss, padded; /* Gauss points per element; rows of them, padded              */
    struct shell_direction direction[2];
    double *parametric; /* [elements][padded] parametric quadrature weights            */
    int *ien;           /* [elements][local] ascending                                 */
    int slabs, *slab;   /* elements slab[s] .. slab[s+1]; s and s+2 share no node owned */
};

/* Copies bases, control points point[nodes][3] and weights (NULL: all 1). gauss[2]: points
 * per span, 0: degree + 1. STATUS_INPUT with a sentence unless degrees are 2 or more (a
 * Kirchhoff-Love shell needs slopes that are continuous), inner knots are repeated at most
 * p - 1 times and 0 <= gauss <= SHELL_MAX_GAUSS. */
enum status shell_space_init(struct shell_space *space, const struct bspline basis[2],
                             const double *point, const double *weight, const int gauss[2],
                             struct message *why);
void shell_space_clear(struct shell_space *space);

/* T[SHELL_DERIVATIVES][local][padded] of one element, Gauss points running fastest; zeros
 * in the padding. Pure: any thread. */
void shell_space_functions(const struct shell_space *space, int element, double *T);

/* The functions alive at (u,v): T[SHELL_DERIVATIVES][local] and their nodes node[local]. */
void shell_space_at(const struct shell_space *space, double u, double v, int *node,
                    double *T);

#endif
