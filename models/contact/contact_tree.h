/* contact_tree.h - which cells of a sheet may be near which: a tree of boxes over the grid
 * of its samples, 2 x 2 to a box, that is fitted again in O(n). The cells of a mesh are its
 * triangles, in an order in which those that follow each other lie together in the pattern;
 * two are in a box.
 *
 * A box holds the least and largest of each coordinate of its part's samples, of the two
 * derivatives by the lengths at rest along u and v, and, for limits of steps, of the
 * samples' displacements. The derivatives tell that a part is nearly flat: if their
 * components in the plane of two vectors A, B stay within e1, e2 of those, two points at a
 * distance s along the sheet are at least s (sigma - sqrt(e1^2 + e2^2)) apart, sigma the
 * least singular value of [A B]. Pairs nearer than a material distance do not count, so
 * such a part, alone or with its neighbours, need not be opened.
 */
#ifndef CONTACT_TREE_H
#define CONTACT_TREE_H

#include <math.h>
#include <string.h>

#include "models/contact/contact_surface.h"
#include "models/mesh_patch.h"

struct contact_tree {
    const struct contact_surface *surface; /*                              borrowed  */
    double apart; /* pairs nearer along the sheet do not count                    [m] */
    int levels;
    const double *y, *d;   /* of contact_tree_fit                            borrowed  */
    void *room;            /* of the arrays                                 owned     */
    double *per_length[2]; /* [points - 1] inverse lengths at rest              [1/m] */
    double (*flat)[3];     /* [samples] lengths at rest along u and v, 0; places in a mesh's
                              pattern, or where it starts                         [m] */
    struct mesh_patches patches; /* of a mesh                          owned     */
    struct contact_box *boxes;
    struct contact_tree_level {
        int n[2]; /* boxes along u and v; of level 0 the cells              */
        struct contact_box *box; /* [n[0]][n[1]], in `boxes`                             */
    } level[32];
};

enum status contact_tree_init(struct contact_tree *t, const struct contact_surface *s,
                              double apart);
void contact_tree_clear(struct contact_tree *t);

/* Returns a way along v between two places, of a closed sheet the shorter way around [m].
 */
static inline double contact_tree_across(const struct contact_tree *t, double way)
{
    const double around = t->surface->around;

    return around > 0 ? way - around * round(way / around) : way;
}

/* Tells whether a point of a triangle, by the shares of its corners, is nearer to a sample
 * than `apart` along the sheet [m]; on a mesh straight across the pattern, which is no
 * farther. */
static inline bool contact_tree_near(const struct contact_tree *t, double apart, int sample,
                                     const int corner[3], const double share[3])
{
    double du = -t->flat[sample][0], dv = -t->flat[sample][1], dw = -t->flat[sample][2];

    if (contact_surface_apart(t->surface, sample, corner[0]))
        return false;
    for (int k = 0; k < 3; k++) {
        du += share[k] * t->flat[corner[k]][0];
        dv += share[k] * t->flat[corner[k]][1];
        dw += share[k] * t->flat[corner[k]][2];
    }
    dv = contact_tree_across(t, dv);
    return du * du + dv * dv + dw * dw < apart * apart;
}

/* Returns the first of a cell's triangles (contact_foot.h); a grid's has the next, too. */
int contact_tree_triangle(const struct contact_tree *t, int cell);

/* Returns how many triangles a cell has. */
static inline int contact_tree_triangles(const struct contact_tree *t)
{
    return t->patches.order ? 1 : 2;
}

/* Lists the samples at a cell's corners; of a triangle the last one twice. */
static inline void contact_tree_corners(const struct contact_tree *t, int cell,
                                        int corner[4])
{
    const int m = t->surface->points[1];

    if (t->patches.order) {
        memcpy(corner, t->surface->mesh.corner[t->patches.order[cell]], 3 * sizeof *corner);
        corner[3] = corner[2];
        return;
    }
    corner[0] = cell + cell / (m - 1), corner[1] = corner[0] + 1;
    corner[2] = corner[0] + m, corner[3] = corner[2] + 1;
}

/* List the samples and the edges that a cell owns, so that each has one owner; return how
 * many. */
int contact_tree_samples(const struct contact_tree *t, int cell, int sample[4]);
int contact_tree_edges(const struct contact_tree *t, int cell, int edge[5][2]);

/* Fits the boxes to the samples y[count][3] and, unless NULL, their displacements
 * d[count][3], both borrowed until the last visit. */
void contact_tree_fit(struct contact_tree *t, const double *y, const double *d);

/* A search for pairs of cells. Those are left out that are at least reach + share w apart,
 * with w a bound on how far two of their points move relative to each other. */
struct contact_tree_search {
    double reach, share; /* [m]; may be changed by `visit`                             */
    void *context;
    enum status (*visit)(struct contact_tree_search *search, int cell, int other);
};

/* Visits all pairs that the search does not leave out, each once, a cell with itself, too.
 * Returns the first failure of `visit`. */
enum status contact_tree_visit(const struct contact_tree *t,
                               struct contact_tree_search *search);

#endif
