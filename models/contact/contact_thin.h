/* contact_thin.h - what of a body is thinner than the net that it meets.
 *
 * The samples of a sheet (contact_surface.h) pass a line, a peg or a corner on both sides.
 * So the features of thin bodies meet the triangles between the samples, too: the centre of
 * a ball and points of a capsule's axis, where the radius is less than the longest spacing
 * s of samples; edges and corners of a box that is thinner than 2 s; and of a mesh those
 * edges and corners from which a ball of radius s that touches the body there from inside
 * stands out by a fifth of s, and rims. A body that has none costs nothing.
 *
 * Points of axes and edges are s/2 apart. The distance of a point q from a triangle is that
 * of the place y of the sheet that is closest to it, from the axis or edge, less the
 * radius. All triangles that are near q count: the distance of each is once continuously
 * differentiable, where that of the closest one has a kink under a crease. The law acts on
 * y as on a sample, with an area of s times the length that q stands for, which the samples
 * of a row would have.
 *
 * A step carries q through a triangle if q changes sides of its plane, within it. The
 * distance is then negative, as seen from the side where the step began. Rates are those of
 * the distance of q from the sheet, over which triangles may slide.
 */
#ifndef CONTACT_THIN_H
#define CONTACT_THIN_H

#include "models/contact/contact_surface.h"

/* A point of a segment of a body, in the place that the scene gives it. */
struct contact_feature {
    int obstacle;
    double at[3], end[2][3]; /* [m]; ends are equal where it is a point              */
    double radius, area;     /* [m], [m^2]                                           */
};

struct contact_thin {
    const struct contact_surface *surface; /*                              borrowed  */
    const struct scene *scene;             /*                              borrowed  */
    double start, spacing; /* of the law; s                                       [m] */
    int count, most;
    struct contact_feature *feature; /* [count] by obstacle              owned     */
    void *room;                      /* of the next nine                  owned     */
    double (*q)[3], (*q_old)[3];     /* [count] places at the step's end and start  [m] */
    bool *passed;                    /* [count] it has been carried through a triangle */
    double *least, *least_old;       /* [count] distances from the sheet, then       [m] */
    struct contact_thin_box {
        double low[3], high[3];
    } * box; /* [count] swept, with the reach of the law                      [m] */
    double *y, *y_old; /* [samples][3], of the same times             [m] */
    double *weight;
    int *node; /* of the last contact_thin_foot                             */
    int pairs, pair_room;
    struct contact_thin_pair *pair; /* features and triangles near them  owned     */
};

struct contact_thin_pair {
    int feature, triangle;
    double before, after; /* heights of the feature over the triangle's plane         [m] */
    double distance; /* from the axis; negative: the feature has passed               [m] */
};

/* A place of the sheet near a feature. */
struct contact_thin_foot {
    int obstacle, count;
    const int *node; /* [count], valid until the next foot                              */
    const double *weight;
    double distance, before; /* from the body, now and when the step began        [m] */
    double normal[3];        /* from the body to the place                            */
    double area;             /*                                                 [m^2] */
};

/* A step of a sheet, nodes [nodes][3], among bodies [obstacles]. */
struct contact_thin_step {
    const struct scene_placement *pose_old, *pose;
    const double *x_old, *x;
};

/* Finds the features of the scene's bodies for a surface, borrowed as the scene is;
 * `start`: where contact with bodies starts [m]. STATUS_MEMORY. */
enum status contact_thin_init(struct contact_thin *t, const struct scene *scene,
                              const struct contact_surface *surface, double start);
void contact_thin_clear(struct contact_thin *t);

/* Lists the pairs that come near each other in a step, and whether features are carried
 * through the sheet in it; *passed says how many. STATUS_MEMORY. */
enum status contact_thin_look(struct contact_thin *t, const struct contact_thin_step *step,
                              int *passed);

/* Computes the foot of pair n of the last contact_thin_look; false: it is too far off. */
bool contact_thin_foot(struct contact_thin *t, int n, const struct contact_thin_step *step,
                       struct contact_thin_foot *foot);

/* Lists the pairs that come near each other in a change d[nodes][3] of x, among bodies at
 * rest. STATUS_MEMORY. */
enum status contact_thin_near(struct contact_thin *t, const struct scene_placement *pose,
                              const double *x, const double *d);

/* Returns the largest share, at most `share`, of the change that leaves pair n of the last
 * contact_thin_near half of its distance to the wall, or half of the range where that is
 * less, as contact_search_limit does; samples[3]: the triangle's. */
double contact_thin_limit(struct contact_thin *t, int n, const double *x, const double *d,
                          double wall, double range, double share, int samples[3]);

#endif
