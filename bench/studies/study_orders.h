/* study_orders.h - refinement and elevation of one net in either order, by knot insertion
 * and degree elevation proper (iga/refine.h): whether the shape, the control points and the
 * motion of the paper's scheme are the same.
 *
 * Elevation raises the multiplicity of the inner knots that are there, so that the orders
 * give the same knots only if the second one inserts each new knot as often as the first
 * one ends up with it; inserted once, the new knots are smoother (k-refinement; Hughes,
 * Cottrell, Bazilevs 2005).
 */
#ifndef STUDY_ORDERS_H
#define STUDY_ORDERS_H

#include "bench/experiment/experiment.h"
#include "iga/patch.h"

enum { STUDY_ORDERS_TIMES = 3 };

enum study_order_path {
    STUDY_ORDERS_REFINE_FIRST,  /* each span halved, then p = 2 to 3                   */
    STUDY_ORDERS_ELEVATE_FIRST, /* p = 2 to 3, then each span halved by a double knot  */
    STUDY_ORDERS_K,             /* p = 2 to 3, then each span halved by a single knot  */
    STUDY_ORDERS
};

/* The path's patch from a uniform one of side x side x 2 points, degrees (2,2,1), with its
 * corner in the origin and 1 m x 1 m x 1 mm. `base` (may be NULL) gets the one it starts
 * from. Both are freed by the receiver with patch_clear. */
enum status study_orders_patch(enum study_order_path path, int side, struct patch *patch,
                               struct patch *base, struct message *why);

/* Moves all three under the paper's scheme, the sheet of Fig. 12 held along an edge, and
 * leaves FOLDER/orders_PATH.h5 of each. Quick: a smaller net. */
enum status study_orders_measure(const struct experiment_options *options,
                                 struct message *why);

/* What came of it; the shapes are computed anew. */
struct study_orders_result {
    int side;                   /* points a side of the net that all start from          */
    int points[STUDY_ORDERS];   /* and of those that they end with                       */
    double shape[STUDY_ORDERS]; /* greatest change of the shape [m]                      */
    double knots, net; /* greatest difference of the first two: knots [1], control points
                          [m]; NaN if they do not have as many                           */
    /* RMSE / L of the motion from the first path's; NaN after a death                   */
    double motion[STUDY_ORDERS][STUDY_ORDERS_TIMES];
};

/* From what study_orders_measure left. */
enum status study_orders_read(const char *folder, struct study_orders_result *r,
                              struct message *why);
/* Its table and sentence. */
enum status study_orders_print(const struct study_orders_result *r,
                               enum table_format format, FILE *file);

#endif
