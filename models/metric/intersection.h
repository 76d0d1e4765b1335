/* intersection.h - finds where a sheet passes through itself: pairs of triangles of its
 * grid with common points that they should not have.
 *
 * The surface is a grid of points xyz[n_v][n_u][3], u fastest. Cell (i,j), number
 * j (n_u - 1) + i, is cut along the diagonal from (i,j) to (i+1,j+1) into the triangles
 *   2 cell:      (i,j), (i+1,j), (i+1,j+1)
 *   2 cell + 1:  (i,j), (i+1,j+1), (i,j+1).
 * Exchanging u and v, or turning both round, gives the same triangles; turning round one of
 * them gives the other diagonals, another surface.
 *
 * Two triangles intersect if they have a point in common that is not in the hull of the
 * grid points they share (triangle.h). So touching in a point counts, neighbours along an
 * edge count only when folded flat onto each other, neighbours at a vertex when they pass
 * through or overlap each other. Two grid points at the same place stay two points: a
 * closed tube touches itself along the seam. But where the whole last row lies on the
 * first, to round-off, as in a sheet that is closed along v, they are the same points.
 * Without degenerate triangles the count is 0 exactly if the surface is embedded.
 *
 * Decided without round-off, of the coordinates as they are, except that a coordinate below
 * 2^-247 (about 1e-75) of the largest is taken for 0. Thickness plays no role.
 *
 * Several sheets that share a field (grid.h) are one surface, without the cells that would
 * connect them: where one passes through another, the surface passes through itself.
 *
 * A mesh is a list of triangles between vertices, of any topology, and the same holds for
 * it; triangles that follow each other in the list should be near each other.
 *
 * Cost: O(cells + pairs of cells whose boxes overlap), by a tree of boxes over the grid, or
 * over the list.
 */
#ifndef INTERSECTION_H
#define INTERSECTION_H

#include <stdbool.h>

#include "models/status.h"

struct intersection_pair {
    int first, second; /* triangles, first < second                                    */
};

/* Work space, kept from call to call; all-zero before the first, free with
 * intersection_clear, which leaves all-zero. */
struct intersection {
    bool keep_pairs;                 /* set by the caller: fill `pairs` too            */
    double shake;                    /* set by the caller: points are moved by up to so
                                        much, each otherwise, so that none lies on the
                                        plane of others; 0: not [m]                    */
    bool sparse;                     /* set by the caller: NaN is a place of a field that is
                                        beside the sheet                               */
    long most;                       /* set by the caller: end a count at about so many
                                        pairs, lest a heap take for ever; 0: no end    */
    struct intersection_pair *pairs; /* [pair_count], ascending                 owned  */
    long pair_count;                 /* 0 unless keep_pairs                            */
    long tests;                      /* pairs of triangles tested, of the last call    */

    long points;
    int triangles;
    double scale;  /* units of `point`                                           [m]   */
    double *point; /* [points][3], scaled to 1                                  owned  */

    /* private */
    int n_u, n_v, levels;
    int sheets, step; /* of intersection_count_field                                   */
    bool closed;      /* the grid's last row is its first                              */
    int (*corner)[3]; /* [triangles] of a mesh; NULL: the grid's            borrowed */
    long room, pair_room;
    struct intersection_level {
        int n_u, n_v;     /* boxes; those of level 0 are the cells                  */
        double (*box)[6]; /* [n_v][n_u][low xyz, high xyz], into `boxes`            */
    } level[32];
    double (*boxes)[6]; /*                                                 owned  */
    struct intersection_pair *candidate; /* cells whose boxes overlap           owned  */
    unsigned char *hit; /* a bit for each pair of each candidate           owned  */
    int candidate_count;
};

void intersection_clear(struct intersection *s);

/* Counts the intersecting pairs of a grid of n_u x n_v points, each at least 2 and at most
 * 2^30 triangles. Allocates when a grid is larger than those before. The same count and
 * pairs for any number of threads. STATUS_NAN with *count = -1 if a coordinate is not
 * finite; STATUS_MEMORY. */
enum status intersection_count(struct intersection *s, int n_u, int n_v, const double *xyz,
                               long *count);

/* Counts those of the middle of a field (grid.h) of so many sheets, through every `step`-th
 * grid point, step a divisor of 99. */
enum status intersection_count_field(struct intersection *s, int sheets, int step,
                                     const double *xyz, long *count);

/* Counts those of a mesh; the list corner[triangles][3] is borrowed until the next count.
 */
enum status intersection_count_mesh(struct intersection *s, int vertices, const double *xyz,
                                    int triangles, int (*corner)[3], long *count);

/* Returns the grid points of a triangle. */
void intersection_corners(int n_u, int triangle, int corner[3]);

/* Finds the corners of a triangle of the last count. False: it lies between two sheets,
 * where nothing is. */
bool intersection_triangle(const struct intersection *s, int triangle, int corner[3]);

/* A search, among the triangles of the last count, for the one nearest to a point. */
struct intersection_search {
    const double *x;     /* in the units of `point`                            borrowed */
    const void *context; /*                                                    borrowed */
    /* Tells whether a triangle with its nearest point counts; NULL: each does. */
    bool (*counts)(const struct intersection *s, const struct intersection_search *search,
                   const int corner[3], const double foot[3]);
    double least;   /* the distance found; the caller sets the largest that is looked for */
    int corner[3];  /* of the triangle found                                              */
    double foot[3]; /* the point found                                                   */
};

/* Searches; returns whether a triangle was found. */
bool intersection_nearest(const struct intersection *s, struct intersection_search *search);

#endif
