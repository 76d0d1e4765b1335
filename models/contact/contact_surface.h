/* contact_surface.h - the mid-surface of a sheet as contact sees it: a grid of samples,
 * each a weighted sum of a model's nodes, with its share of the area at rest. Several
 * sheets have as many rows each, one after the other, and no cells in between. A mesh has
 * one sample a row, at its vertices, and triangles between them in any order.
 *
 * Contact is integrated at the samples (trapezoidal rule), and the triangles between them
 * are what other samples and other surfaces meet. A net of points has them at its nodes; a
 * smooth surface may have several a span.
 */
#ifndef CONTACT_SURFACE_H
#define CONTACT_SURFACE_H

#include "models/mesh_cells.h"
#include "models/scene.h"

/* Fills node[width] and shape[width] such that the mid-surface's point (u,v) is the sum of
 * shape[k] x[node[k]]; returns how many there are, at most the width that the surface was
 * made with. Nodes differ. */
typedef int contact_row(const void *self, double u, double v, int *node, double *shape);

/* The most nodes of a row of a surface that goes on beyond its ends. */
enum { CONTACT_SURFACE_NODES = 256 };

struct contact_surface {
    const void *self; /* of `row`                                            borrowed  */
    contact_row *row;
    int points[2];   /* samples along u, of all sheets, and v                            */
    int rows;        /* samples along u of one sheet                                     */
    int count;       /* points[0] points[1]; sample = i points[1] + j                    */
    int width;       /* most nodes of a row                                              */
    bool smooth;     /* feet lie on the surface of `row`, not on the samples' triangles  */
    int nodes;       /* of the model                                                     */
    void *room;      /* of the arrays                                         owned   */
    double *line[2]; /* [points] parameters, ascending from 0 to 1; along u the ends of
                        sheets are those of scene.h                                     */
    int *used;       /* [count] nodes of the row                                      */
    int *node;       /* [count][width]                                                */
    double *shape;   /* [count][width]                                                */
    double *area;    /* [count]                                               [m^2]   */
    double *flat[2]; /* [points] lengths at rest along u (v = 1/2) and v (u = 0) from the
                        edge of each sheet, for distances along it             [m]     */
    double spacing;  /* longest of neighbouring samples at rest                       [m] */
    struct mesh_cells mesh; /* none: the samples are a grid                    */
    double around; /* length at rest along v of a sheet closed around, or 0 [m]         */
};

/* Tells whether two samples are of two sheets, which no way along a sheet connects. */
static inline bool contact_surface_apart(const struct contact_surface *s, int a, int b)
{
    return s->rows < s->points[0] &&
           a / (s->rows * s->points[1]) != b / (s->rows * s->points[1]);
}

/* Tells whether the cells from row i on would lie between two sheets: there are none. */
static inline bool contact_surface_cut(const struct contact_surface *s, int i)
{
    return s->rows < s->points[0] && (i + 1) % s->rows == 0;
}

/* Makes the samples at line[0] x line[1] (copied); `row` NULL: they are the nodes. A
 * surface of wider rows is smooth. */
enum status contact_surface_init(struct contact_surface *s, const struct scene *scene,
                                 const void *self, contact_row *row, int width, int nodes,
                                 const double *const line[2], const int points[2]);

/* Makes samples that lie evenly on each sheet. */
enum status contact_surface_init_even(struct contact_surface *s, const struct scene *scene,
                                      const void *self, contact_row *row, int width,
                                      int nodes, const int points[2]);

/* Makes the samples of a net whose nodes, number i points[1] + j, lie evenly on each sheet;
 * points[0] are those of all sheets. */
enum status contact_surface_init_net(struct contact_surface *s, const struct scene *scene,
                                     const int points[2]);

/* Makes the samples of a mesh: its first `count` nodes, with their areas. */
enum status contact_surface_init_mesh(struct contact_surface *s, int nodes, int count,
                                      const struct mesh_cells *mesh, double spacing);
void contact_surface_clear(struct contact_surface *s);

/* Fills line[(breaks - 1) per + 1] with `per` samples a span of the ascending
 * break[breaks]; returns how many. */
int contact_surface_line(int breaks, const double *at, int per, double *line);

/* How far a smooth surface goes on beyond its ends, straight on [low, high] along u and v,
 * each with `step`, the step of differences along it: errors of 1e-8 in slopes and in
 * curvatures. A sheet closed around does not go on along v. */
struct contact_ends {
    double low[2], high[2], least[2], most[2], step[2];
};

/* Returns the lines along u of the sheet at u, the first of s->rows. */
const double *contact_surface_sheet(const struct contact_surface *s, double u);

/* Returns the ends of the sheet at u. */
struct contact_ends contact_surface_ends(const struct contact_surface *s, double u);

/* Returns the place nearest to `at` along u (d = 0) or v around which all differences lie
 * on one side of the ends. */
double contact_surface_middle(const struct contact_ends *e, int d, double at);

/* Does as the surface's row, beyond its ends, too. */
int contact_surface_row(const struct contact_surface *s, const struct contact_ends *e,
                        double u, double v, int *node, double *shape);

/* Computes the point y there of a surface with nodes x[nodes][3] as well. */
int contact_surface_point(const struct contact_surface *s, const struct contact_ends *e,
                          const double *x, double u, double v, int *node, double *shape,
                          double y[3]);

/* A smooth surface near a place (u,v) to second order: its point, and the derivatives by u
 * and v; by uu, uv and vv [m]. */
struct contact_bend {
    double u, v;
    double y[3], d[2][3], dd[3][3];
};

/* Fills *b by differences of points around the place nearest to (u,v) that allows them;
 * node and shape have room for a row. */
void contact_surface_bend(const struct contact_surface *s, const struct contact_ends *e,
                          const double *x, double u, double v, int *node, double *shape,
                          struct contact_bend *b);

/* Computes A = F_a F_b - way F_ab for uu, uv and vv: the second derivatives of half the
 * squared distance from the end of a way [m] that leads away from b's point [m^2]. */
void contact_bend_rounds(const struct contact_bend *b, const double way[3], double A[3]);

/* Lists the nodes of a weighted sum of samples that differ, each once, with their weights;
 * returns how many, at most count times the width. */
int contact_surface_mix(const struct contact_surface *s, int count, const int *sample,
                        const double *share, int *node, double *weight);

/* Computes where a sample is, for nodes x[nodes][3]. */
void contact_surface_at(const struct contact_surface *s, int sample, const double *x,
                        double y[3]);

#endif
