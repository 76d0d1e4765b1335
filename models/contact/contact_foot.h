/* contact_foot.h - the place of a sheet that is closest to one of its samples.
 *
 * The grid of samples (contact_surface.h) is cut into triangles as intersection.h cuts its
 * cells; they are numbered by the sample at their first corner:
 *   2 (i points[1] + j):      (i,j), (i+1,j), (i+1,j+1)
 *   2 (i points[1] + j) + 1:  (i,j), (i+1,j+1), (i,j+1).
 * A mesh has triangles of its own, with their own numbers. The closest point of those is
 * refined, so that foot, distance and normal move continuously with the sheet. Positions
 * y[count][3] of the samples come from x[nodes][3].
 *
 * A smooth surface (rows of several nodes) has the foot that is closest on itself, and on
 * where it goes on straight beyond its ends: D is then once continuously differentiable,
 * and the normal its gradient.
 *
 * A net is its triangles, and has the foot at which y - foot is parallel to the normal
 * interpolated between the corners (from central differences, on a mesh the mean of the
 * triangles around by their areas). The closest point of the triangles would not do: on the
 * hollow side of an edge it jumps from face to face, and with it the normal, just where the
 * force pushes a sample to, so that Newton's method finds no end. Here foot and normal are
 * continuous. The force lies along y - foot, and the foot's weights are those of the point
 * where it acts, so momentum and angular momentum are kept exactly; it differs from the
 * energy's gradient by the angle between face and normal, of first order in the cell's size
 * and of mean 0 across a cell.
 *
 * A foot on the border of a net goes on beyond it, too, along the plane of the triangle
 * there, to where the way is normal: its weights are then below 0 and above 1, and momenta
 * are kept. The closest point would be the edge, from which a sample that has come over it
 * is pushed off. In the limit of fine nets that is a force of the law's potential a length
 * of edge, p r (1 - x) / 3, but a net has a row of samples along each edge that it takes at
 * once: cards that lie on each other without friction were unstable, at a rate of sqrt(g /
 * 2 n t) a second on n cells, and parted at sqrt(g r (1 - x) / 3 n).
 */
#ifndef CONTACT_FOOT_H
#define CONTACT_FOOT_H

#include "models/contact/contact_tree.h"

/* The distance of a point from a triangle, which may be a segment or a point. */
struct contact_face {
    const double *p[4]; /* places of the point and the corners          [m]    borrowed  */
    double share[3];    /* of the corners in the closest point; sum 1                    */
    double way[3];      /* from there to the point                      [m]              */
    double square;      /* of its length                                [m^2]            */
};

/* Computes share, way and square. */
void contact_face_nearest(struct contact_face *f);

struct contact_foot {
    int sample;
    int side; /* of its sample: 0 above, along the normal, 1 below                   */
    int first, count; /* its nodes and weights in the lists of contact_search         */
    double u, v, w;   /* of a mesh: its place for distances along it (tree's flat) [m] */
    double distance;  /*                                                     [m] >= 0 */
    double normal[3]; /* unit, from the foot to the sample                             */
    double strength;  /* its share in the law, 0 to 1                                  */
};

/* A sheet at some time. */
struct contact_sheet {
    const struct contact_surface *surface; /*                              borrowed  */
    const struct contact_tree *tree; /* for distances along the sheet      borrowed  */
    double start; /* the distance at which contact starts                            [m] */
    const double *x, *y;  /* [nodes][3], [samples][3]                     borrowed  */
    const double *normal; /* [samples][3] as contact_foot_normal computes them, of those
                             at which they are needed                                 */
};

/* A point of a triangle and its distance from a sample. */
struct contact_place {
    int sample, side, triangle; /* triangle -1: there is none                           */
    double share[3];   /* of the corners; their sum is 1                                 */
    double square;     /* of the distance                                           [m^2] */
    double square_cos; /* of the way's angle to the sheet's normal                     */
};

/* Computes the samples at the corners of a triangle. */
static inline void contact_foot_corners(const struct contact_surface *s, int triangle,
                                        int corner[3])
{
    const int m = s->points[1], first = triangle / 2;

    if (s->mesh.count) {
        memcpy(corner, s->mesh.corner[triangle], 3 * sizeof *corner);
        return;
    }
    corner[0] = first;
    corner[1] = triangle % 2 ? first + m + 1 : first + m;
    corner[2] = triangle % 2 ? first + 1 : first + m + 1;
}

/* Returns a sample of places y[samples][3] and the triangle of three others. */
static inline struct contact_face contact_foot_face(const double *y, int sample,
                                                    const int corner[3])
{
    return (struct contact_face){.p = {y + 3 * (long)sample, y + 3 * (long)corner[0],
                                       y + 3 * (long)corner[1], y + 3 * (long)corner[2]}};
}

/* Returns the squared distance of y from the triangle p, and the shares of the corners in
 * the closest point, as contact_face_nearest does. */
double contact_foot_nearest(const double y[3], const double *const p[3], double share[3]);

/* Computes the parameters of a point of a triangle of a grid. */
void contact_foot_place(const struct contact_surface *s, int triangle,
                        const double share[3], double *u, double *v);

/* Returns the distance of the segments p[0] p[1] and p[2] p[3], and the parameters of the
 * closest points on them; segments may be points. */
double contact_foot_between(const double *const p[4], double at[2]);

/* Computes the normal of the sheet at a sample, along (d/du) x (d/dv), of any length; 0 if
 * it has none. */
void contact_foot_normal(const struct contact_sheet *sheet, int sample, double normal[3]);

/* Computes normal[samples][3] at the samples of row i that are marked in wanted[samples].
 */
void contact_foot_normals(const struct contact_sheet *sheet, int i, const bool *wanted,
                          double *normal);

/* Begins with nothing on either side of a sample nearer than `start` [m]. */
static inline void contact_foot_begin(double start, struct contact_place best[2])
{
    best[0].triangle = best[1].triangle = -1;
    best[0].square = best[1].square = start * start;
}

/* Takes a triangle for the closest on its side of a sample, of whose two sides best[2] are
 * the closest, if it is, and is not too near along the sheet, or seen from beside. The
 * sheet's normals there must be ready. */
void contact_foot_consider(const struct contact_sheet *sheet, int sample, int triangle,
                           struct contact_place best[2]);

/* Returns how many nodes a foot has at most. */
int contact_foot_width(const struct contact_surface *s);

/* Refines closest points of the triangles, *place[count], into foot[count], all but
 * `first`, with node and weight[count][contact_foot_width]. In a foot at the sample itself
 * the normal is the surface's. */
void contact_foot_refine(const struct contact_sheet *sheet, int count,
                         const struct contact_place *const *place,
                         struct contact_foot *foot, int *node, double *weight);

/* Return shares of a foot in the law, 0 to 1. The first is 0 where two places (u,v), on a
 * mesh those in the tree's flat, are near along the sheet; the second, of the squared
 * cosine of the angle to the face's normal under which a foot is seen, is 0 from 45 degrees
 * on. Forces would else jump. */
double contact_foot_far(const struct contact_sheet *sheet, const double uv[3],
                        const double other[3]);
double contact_foot_seen(double square);

#endif
