/* truth_plate.h - cantilevered sheets held against the Kirchhoff plate: whole fields at
 * times and in equilibrium, and the middle of the free edge.
 */
#ifndef TRUTH_PLATE_H
#define TRUTH_PLATE_H

#include "fem_ref/kirchhoff_field.h"
#include "models/grid.h"

enum { TRUTH_PLATE_TIMES = 8 };

struct truth_plate {
    int times;
    double *xyz[TRUTH_PLATE_TIMES + 1]; /* [times], then the static one [m]; xyz[0] owned */
    double *rest;                       /* rest positions                [m]    owned   */
    double thickness_ratio;             /* h / L                                        */
    double gamma;
};

/* Fields xyz[times] of the scene (undamped, linear) at time[times]; INFINITY: in
 * equilibrium. */
enum status truth_plate_fields(const struct scene *scene, int times, const double *time,
                               double *const *xyz, struct message *why);

/* Computes it for the scene (undamped, linear) at time[times]. */
enum status truth_plate_init(struct truth_plate *t, const struct scene *scene, int times,
                             const double *time, struct message *why);
void truth_plate_clear(struct truth_plate *t); /* all-zero is allowed, and left */

/* Where the middle of the free edge is along z in a field, or how far from `rest` [m]: of
 * the two grid points nearest it, either side, both layers. */
double truth_plate_edge(const double *xyz, const double *rest);

/* Drop of a cantilever's tip under its own weight, over its length: Kirchhoff's plate or,
 * if displacements are not `linear`, the elastica. NaN: the scene is no such sheet. */
double truth_plate_drop(const struct scene *scene, bool linear);

/* Kirchhoff's w D / (q L^4) there, of a square that `terms` functions a direction solve. */
enum status truth_plate_coefficient(double nu, int terms, double *coefficient);

#endif
