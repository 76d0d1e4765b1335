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

/* Makes the graph of elements with `local` nodes each: ien[elements][local], in any
 * order, and repeated or not. */
enum status blocks_init(struct blocks *g, int nodes, int elements, int local,
                        const int *ien);

/* Makes that of elements of any size: element e has ien[start[e]] .. ien[start[e + 1] - 1].
 */
enum status blocks_init_uneven(struct blocks *g, int nodes, int elements, const long *start,
                               const int *ien);
void blocks_clear(struct blocks *g);

/* Returns the index of the pair (a, b), a <= b; -1 if they are not coupled. O(log). */
long blocks_find(const struct blocks *g, int a, int b);

/* Finds the places of the blocks of elements whose nodes come in runs of `run` consecutive
 * numbers: *place[elements][local][local / run], the pair of (node, first of run at or
 * behind it). Owned by the caller. */
enum status blocks_places(const struct blocks *g, int elements, int local, int run,
                          const int *ien, int **place);

/* Groups elements into slabs, [slab[s], slab[s+1]), for elements numbered in columns of
 * `per_column` of which `wide` + 1 neighbouring ones share nodes: slabs s and s + 2 share
 * none. *slab is owned by the caller. */
enum status blocks_slabs(int elements, int per_column, int wide, int *slabs, int **slab);

/* Returns the length of the longest of the vectors x[nodes][3], which, unlike the largest
 * component, does not change when a scene is turned. NaN if any is NaN. */
double blocks_longest(int nodes, const double *x);

/* Compute y = K x and y = M x; x, y [nodes][3], not aliased. Serial, ordered. */
void blocks_multiply(const struct blocks *g, const double (*K)[9], const double *x,
                     double *y);
void blocks_multiply_mass(const struct blocks *g, const double *M, const double *x,
                          double *y);

/* Inverts a symmetric block by elimination, zero where held; false if it is not positive
 * definite. */
bool blocks_invert(const double A[9], const int place[3], double out[9]);

#endif
