/* mesh_patch.h - the triangles of a mesh as a tree: their order, and which boxes make up
 * the pattern around another.
 *
 * A box of level l has 2^l triangles that follow each other in the order, or what is left.
 * A box lies in a rectangle of the pattern, and its patch is that rectangle with its longer
 * side added all around. Where the part of the pattern in the patch is convex, the straight
 * line between any two of its points stays on the sheet, in the boxes that meet the patch.
 * What is sewn together has an order only, by where it starts: no patch counts as convex.
 */
#ifndef MESH_PATCH_H
#define MESH_PATCH_H

#include <stdbool.h>

#include "models/mesh_cells.h"

struct mesh_patches {
    void *room; /* of the arrays up to `convex`                                  owned  */
    int *order; /* [cells] triangles; what follows is [boxes], level by level from 1    */
    double (*part)[4]; /* rectangles: least u and v, largest                       [m] */
    int *first, *end;  /* into near                                                    */
    bool *convex;      /* what the patch has of the pattern                            */
    int start[32];     /* of levels                                                    */
    int count, most;   /* of near                                                      */
    int *near;         /* boxes of the same level that meet the patch           owned  */
};

/* Initialises for the triangles of a mesh of so many points. STATUS_MEMORY. */
enum status mesh_patches_init(struct mesh_patches *p, const struct mesh_cells *mesh,
                              int points);
void mesh_patches_clear(struct mesh_patches *p);

/* Tells whether straight lines between the boxes a and b of a level >= 1 stay on the sheet;
 * they are then in those of the boxes from *near up to *end that meet `part`. */
bool mesh_patches_between(const struct mesh_patches *p, int level, int a, int b,
                          double part[4], const int **near, const int **end);

/* Tells whether two rectangles meet. */
static inline bool mesh_patches_overlap(const double a[4], const double b[4])
{
    return a[0] <= b[2] && b[0] <= a[2] && a[1] <= b[3] && b[1] <= a[3];
}

/* Tells whether a box of a level meets a part. */
static inline bool mesh_patches_meets(const struct mesh_patches *p, int level, int a,
                                      const double part[4])
{
    return mesh_patches_overlap(p->part[p->start[level] + a], part);
}

#endif
