/* pd_dual.h - the small system of what pushes nodes: rows that each take one node in one
 * direction d. With C the rows and A the constant matrix of the global step,
 *   S = C A^-1 C^T,   S_rs = sum over components c of d_rc d_sc (A_c^-1)_ab,
 * is symmetric and positive definite, for A is. A never changes, so that the entries of
 * A^-1 between nodes that were ever in a row are found once: one solve a node.
 *
 * Memory: up to PD_DUAL_DENSE rows S is dense and factored (Cholesky), 8 PD_DUAL_DENSE^2
 * bytes = 8 MB for it and as much again for each matrix A^-1 kept (one; three if supports
 * hold components). When other nodes have been in rows than fit, those kept are forgotten.
 * With more rows, a net of 100 x 100 nodes flat on the floor say, nothing is kept:
 * conjugate gradients on S, each product a solve with A, preconditioned by C A C^T (exact
 * where all nodes are in rows of one direction; Farhat and Roux 1991).
 */
#ifndef PD_DUAL_H
#define PD_DUAL_H

#include "projective_dynamics/pd_system.h"

enum { PD_DUAL_DENSE = 1000 };

struct pd_push {
    int node;
    double direction[3]; /* unit                                                       */
};

/* The kinds of matrices, of each of which the last factor is kept. */
enum pd_dual_kind { PD_DUAL_NORMALS, PD_DUAL_TANGENTS, PD_DUAL_KINDS };

struct pd_dual_factor {
    int count, room;     /* rows; 0: none                                              */
    struct pd_push *row; /* [count]                                          owned     */
    double *S;           /* [count][count] lower factor                      owned     */
};

struct pd_dual {
    struct pd_system *system; /*                                             borrowed  */
    int dense;                /* rows, at most, of a dense S                           */
    int known, room;          /* nodes whose entries are kept, and could be            */
    int *place;               /* [nodes] among those known, -1               owned     */
    double *entry[3];         /* [room][room] of A^-1, one per group         owned     */
    struct pd_dual_factor factor[PD_DUAL_KINDS];
    double *column;   /* [nodes] work                                owned     */
    double *field[2]; /* [3] fields, work                            owned     */
    double *work;     /* [4][rows] conjugate gradients               owned     */
    int work_room;
    long solves; /* with A so far                                                      */
};

/* Initialises; computes nothing before rows come. */
enum status pd_dual_init(struct pd_dual *d, struct pd_system *system);
void pd_dual_clear(struct pd_dual *d);

/* Solves S x = r in place for `count` rows. A row that depends on those before it (an
 * obstacle given twice, a node that is held in its direction) gets 0. near: the largest
 * component of the residual at which conjugate gradients stop. */
enum status pd_dual_solve(struct pd_dual *d, enum pd_dual_kind kind,
                          const struct pd_push *row, int count, double near, double *r);

/* Computes z = A^-1 C^T x, three fields. */
enum status pd_dual_push(struct pd_dual *d, const struct pd_push *row, int count,
                         const double *x, double *z);

#endif
