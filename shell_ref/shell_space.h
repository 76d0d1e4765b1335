/* shell_space.h - a bivariate B-spline or NURBS surface as the shell's assembly sees it:
 * elements (non-empty knot spans), their control points, and their basis functions with
 * first and second derivatives at the quadrature points of three rules.
 *
 * Control points are numbered v fastest: node = i m + j for i < n, j < m; elements
 * likewise. The basis of v may be closed; m then counts its different functions.
 */
#ifndef SHELL_SPACE_H
#define SHELL_SPACE_H

#include <stdbool.h>
#include <stddef.h>

#include "iga/line_rule.h"

/* Rows of Gauss points and of functions are padded with zeros to a multiple of it, so that
 * the kernels, vectors of 4 doubles, have no remainders. */
enum { SHELL_LANES = 4 };
#define SHELL_PADDED(count) (((count) + SHELL_LANES - 1) / SHELL_LANES * SHELL_LANES)

enum {
    SHELL_MAX_LOCAL = BSPLINE_MAX_ORDER * BSPLINE_MAX_ORDER,
    SHELL_MAX_GAUSS = 8, /* points per span and direction                              */
    SHELL_MAX_POINTS = 3 * SHELL_MAX_LOCAL, /* more than 8 x 8                         */
};

/* Derivatives in the order of the tables: N, N_u, N_v, N_uu, N_vv, N_uv; of the rules that
 * bending has no part in, the first three. */
enum { SHELL_DERIVATIVES = 6, SHELL_SLOPES = 3 };

/* The integrals, each with points of its own. */
enum { SHELL_MEMBRANE, SHELL_BENDING, SHELL_PARTS, SHELL_MASS = SHELL_PARTS, SHELL_RULES };

/* The strains that a point of the membrane is asked for: all; or with others of its row,
 * the part of that along u, or v, which those do not see. */
enum shell_share { SHELL_ALL, SHELL_UNSEEN_U, SHELL_UNSEEN_V };

/* Gauss points of the full rule; line_rule.h's of bending, and as many points as there are
 * derivatives. */
enum { SHELL_FULL, SHELL_BENT, SHELL_DERIVED, SHELL_LINES };

struct shell_direction {
    int order, spans;
    double unseen[BSPLINE_MAX_ORDER];    /* factors of a row's strains along it           */
    struct line_table line[SHELL_LINES]; /* values and two derivatives                 */
};

/* Grids of points, one after the other: each the product of a line of u and one of v. */
struct shell_rule {
    int grids;
    struct shell_grid {
        int line[2];
        enum shell_share share;
    } grid[3];
    int padded; /* rows of an element's points: the most it can have, padded           */
};

struct shell_space {
    struct bspline basis[2]; /* u, v                                           owned   */
    void *room;              /* of weight, rest, ien and table                 owned   */
    double *weight;          /* [nodes] > 0; NULL: all 1                               */
    double *rest;            /* [nodes][3] control points at rest  [m]                 */
    int nodes, elements;
    int local; /* functions per element, (p+1)(q+1)                                    */
    struct shell_direction direction[2];
    struct shell_rule rule[SHELL_RULES];
    bool alike;       /* membrane and bending have the same points                     */
    double *table;    /* [elements][SHELL_PARTS] of their functions; NULL: too many    */
    int *ien;         /* [elements][local] ascending                                   */
    int slabs, *slab; /* elements slab[s] .. slab[s+1]; s and s+2 share no node owned  */
};

/* Copies bases, control points point[nodes][3] and weights (NULL: all 1). All rules have
 * gauss[2] points a span, 0: degree + 1, unless `selective`.
 *
 * Selective. The strain along u is a product of derivatives of degree p - 1 in u and values
 * of degree p in v. Asked for at more points than such a space has functions, it must
 * vanish where a thin sheet's bending lets it not: the membrane locks. All strains are
 * therefore asked for at the points of SHELL_DERIVED in u and v (reduced_rule_derived).
 * These are fewer by one along v than the strain along u has functions: a zigzag from span
 * to span along v is zero at all of them. A row of p + 1 Gauss points along v adds, at each
 * point of u, the energy of its part of degree p (3 of 5) in the span, of which the zigzag
 * has one and a smooth strain next to none; likewise the strain along v. Poisson's ratio
 * has no part in it, so that even states leave no stress in the rows.
 *
 * (Casquero and Mathews, CMAME 417, 2023, interpolate the strain along u from as many
 * points along v as it has functions. As a quadrature beside SHELL_DERIVED's, with some of
 * Young's modulus at their own points, they press a strip that is pulled: the stress across
 * is what pulls there, less what nu takes off it elsewhere. It vanishes in the mean alone,
 * and waves of two spans feel one of the two.)
 *
 * Bending has the points of line_rule_bending (of degree 2 one a span leaves no mode
 * unseen, yet a zigzag from point to point bends so softly then that Newton's method needs
 * 1.6 times the tangents: edge_drop, 16x16). The mass has p + 1.
 *
 * STATUS_INPUT with a sentence unless degrees are 2 or more (a Kirchhoff-Love shell needs
 * slopes that are continuous), inner knots are repeated at most p - 1 times and
 * 0 <= gauss <= SHELL_MAX_GAUSS. */
enum status shell_space_init(struct shell_space *space, const struct bspline basis[2],
                             const double *point, const double *weight, const int gauss[2],
                             bool selective, struct message *why);
void shell_space_clear(struct shell_space *space);

/* A point of a rule in an element: parametric weight; [3][order] of u and of v. */
struct shell_place {
    double weight;
    const double *N[2];
};

/* Lists the points of a rule, place[SHELL_MAX_POINTS]; returns how many. */
int shell_space_places(const struct shell_space *space, int rule, int element,
                       struct shell_place *place);

/* Returns the size of T below. */
size_t shell_space_size(const struct shell_space *space, int rule);

/* Computes T[SHELL_DERIVATIVES or SHELL_SLOPES][local][padded] of one element, the
 * rule's points running fastest; zeros in the padding up to a multiple of SHELL_LANES.
 * Values N are there for the mass and in a rational space alone. *T is the space's own
 * where it keeps them, or made in room[shell_space_size]. Returns how many points. Pure:
 * any thread. */
int shell_space_functions(const struct shell_space *space, int rule, int element,
                          double *room, const double **T);

/* Evaluates the functions alive at s of a part (bspline.h) along u, and v:
 * T[SHELL_DERIVATIVES][local], node[local]. */
void shell_space_at(const struct shell_space *space, int part, double s, double v,
                    int *node, double *T);

#endif
