/* table1_truth.h - what Table 1's spaces are held against: the Kirchhoff plate of the
 * scene, in motion at table1_time and in equilibrium.
 */
#ifndef TABLE1_TRUTH_H
#define TABLE1_TRUTH_H

#include "bench/tables/table1.h"
#include "fem_ref/kirchhoff_field.h"
#include "models/grid.h"

struct table1_truth {
    double *xyz[TABLE1_TIMES + 1]; /* the last one static               [m]    owned   */
    double *rest;                  /* rest positions                    [m]    owned   */
    double thickness_ratio;        /* h / L                                            */
    double gamma;
};

/* Computes it for the scene (undamped, linear). */
enum status table1_truth_init(struct table1_truth *t, const struct scene *scene,
                              struct message *why);
void table1_truth_clear(struct table1_truth *t);

/* RMSE of a field against the truth at table1_time[time] (TABLE1_TIMES: static), over the
 * truth's rms displacement. */
double table1_truth_error(const struct table1_truth *t, int time, const double *xyz);

/* Deflection along z of the middle of the free edge over the truth's, static. */
double table1_truth_tip(const struct table1_truth *t, const double *xyz);

#endif
