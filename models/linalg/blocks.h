/* blocks.h - symmetric matrices of a vector field on a node graph.
 *
 * The graph holds each pair of coupled nodes once: row a lists its neighbours b >= a,
 * ascending, a itself first. A stiffness is K[pairs][3][3], K[n][i][j] coupling component i
 * of a with component j of b; a mass is M[pairs], times the identity.
 */
#ifndef BLOCKS_H
#define BLOCKS_H

#include "models/status.h"

struct blocks {
    int nodes;
    long *start; /* [nodes + 1]                                                owned   */
    int *node;   /* [pairs = start[nodes]]                                     owned   */
};

/* Graph of elements with `local` nodes each: ien[elements][local], ascending per element.
 */
enum status blocks_init(struct blocks *g, int nodes, int elements, int local,
                        const int *ien);
void blocks_clear(struct blocks *g);

/* Index of the pair (a, b), a <= b; -1 if they are not coupled. O(log). */
long blocks_find(const struct blocks *g, int a, int b);

/* Where the blocks of an element go whose nodes come in runs of `run` consecutive numbers:
 * *place[elements][local][local / run], the pair of (node, first of run at or behind it).
 * Owned by the caller. */
enum status blocks_places(const struct blocks *g, int elements, int local, int run,
                          const int *ien, int **place);

/* Slabs of elements, [slab[s], slab[s+1]), numbered in columns of `per_column` of which
 * `wide` + 1 neighbouring ones share nodes: slabs s and s + 2 share none. *slab is owned by
 * the caller. */
enum status blocks_slabs(int elements, int per_column, int wide, int *slabs, int **slab);

/* The longest of the vectors x[nodes][3]: iterations must end alike in a turned scene. NaN
 * if any is none. */
double blocks_longest(int nodes, const double *x);

/* y = K x and y = M x; x, y [nodes][3], not aliased. Serial, ordered. */
void blocks_multiply(const struct blocks *g, const double (*K)[9], const double *x,
                     double *y);
void blocks_multiply_mass(const struct blocks *g, const double *M, const double *x,
                          double *y);

/* The inverse of a symmetric block by elimination, zero where held; false if it is not
 * positive definite. */
bool blocks_invert(const double A[9], const int place[3], double out[9]);

#endif
