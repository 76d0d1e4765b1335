/* pb_sweep.h - one step of a net under constraints, on flat arrays, in single or double
 * precision.
 *
 * What is kept is the positions x at the step's start and the step's displacement d, not
 * the new positions: velocities d / dt then have the precision of d. Taken as differences
 * of positions of order 1 they have an error of rounding / dt, which adds up over steps and
 * is the drift of single precision (position_based_model.h).
 *
 * Constraints are projected one after the other (Gauss-Seidel), those of a colour at once:
 * no two of them share a point, so that their order does not matter and the bits are the
 * same however they are done (red-black: Pall, Nylen, Fratarcangeli 2018). Colours take
 * every second or third row, and along a row masks. Every other iteration goes through the
 * kinds backwards, or the sheet would lean to one side.
 *
 * A constraint with the inverse masses w and the strength s = dt^2 / compliance moves its
 * points by w grad C times (Macklin et al. 2016, eq. 18 and 26)
 *     -(s (C + gamma grad C . d) + lambda) / (1 + s (1 + gamma) sum w |grad C|^2),
 * which is added to its lambda. lambda begins at 0; a single iteration never reads it.
 */
#ifndef PB_SWEEP_H
#define PB_SWEEP_H

#include <stdbool.h>
#include <stddef.h>

#include "models/discretization.h"
#include "models/net/net_origin.h"
#include "models/status.h"

/* Springs go from a point to the next along u, along v, (i+1, j+1) and (i+1, j-1); bending
 * (spring_plate.h) is at its point. */
enum pb_kind {
    PB_U,
    PB_V,
    PB_DOWN,
    PB_UP,
    PB_SPRINGS,
    PB_LINE_U = PB_SPRINGS,
    PB_LINE_V,
    PB_TWIST,
    PB_MEAN,
    PB_KINDS,
    PB_FORMS = PB_KINDS - PB_SPRINGS
};

/* The fields, a number per point each; zero to begin with. */
enum pb_field {
    PB_X = 0,                            /* [3] positions                          [m]    */
    PB_D = 3,                            /* [3] displacement of the step           [m]    */
    PB_W = 6,                            /* [3] inverse mass, 0 where held         [1/kg] */
    PB_KICK = 9,                         /* [3] displacement by constant forces    [m]    */
    PB_KEEP = 12,                        /* share of the last displacement         [1]    */
    PB_STRENGTH = 13,                    /* [kinds] springs: s; bending: pb_sweep_form    */
    PB_RECALL = 13 + PB_KINDS,           /* [forms] bending: of lambda                    */
    PB_LAMBDA = PB_RECALL + PB_FORMS,    /* [springs]                              [kg m] */
    PB_LAMBDAS = PB_LAMBDA + PB_SPRINGS, /* [forms][3]                          [kg m] */
    PB_FIELDS = PB_LAMBDAS + 3 * PB_FORMS
};

enum { PB_ODD_NODES = 6 };

/* A constraint between points anywhere, projected after the others: C = sum weight x +
 * shift.
 */
struct pb_odd {
    int count, node[PB_ODD_NODES];
    double weight[PB_ODD_NODES], shift[3];
    double strength, recall; /* pb_sweep_form                                          */
    double lambda[3];
    ptrdiff_t place[PB_ODD_NODES]; /* of the nodes; set by pb_sweep_make                */
};

/* A spring between two points anywhere. */
struct pb_link {
    int node[2];
    double rest, strength, lambda;
};

/* The part of a sweep that does not change from step to step. */
struct pb_plan {
    int n, m;  /* points                                                                */
    int sheet; /* rows after which another sheet begins; n: there is one               */
    enum precision precision;
    double rest[PB_SPRINGS];  /* lengths                                         [m]    */
    double mean[2];           /* spring_plate_mean                                      */
    double gain;              /* 1 + gamma                                              */
    double dt;                /* of a step                                       [s]    */
    struct net_origin origin; /* from which places and ways are counted                 */
    int odd_count;
    struct pb_odd *odd; /* borrowed; lambda and place are written */
    int link_count; /* > 0: all springs are in the list, and there is one row          */
    struct pb_link *link; /* borrowed; lambda is written */
};

struct pb_sweep; /* opaque */

/* Makes a sweep; *sweep is owned by the caller. */
enum status pb_sweep_make(const struct pb_plan *plan, struct pb_sweep **sweep);
void pb_sweep_free(struct pb_sweep *sweep);

/* Computes a form's strength and recall from s = dt^2 / compliance and sum w |grad C|^2. */
void pb_sweep_form(double s, double gain, double sum, double *strength, double *recall);

/* Put and get `count` fields from the first one on, values[nodes][count], rounded. */
void pb_sweep_put(struct pb_sweep *sweep, int first, int count, const double *values);
void pb_sweep_get(const struct pb_sweep *sweep, int first, int count, double *values);

/* Lets the origin follow x and v. Returns whether it did: places, ways and kicks must be
 * put again then, and kicks have (keep - 1) times its way in a step, which is `way`,
 * besides. */
bool pb_sweep_follow(struct pb_sweep *sweep, const double *x, const double *v,
                     double way[3]);

/* Do the parts of a step: d <- keep d + kick, lambda <- 0 if `recalls`; held components to
 * where they shall be; iterations, with bending or with springs alone; x <- x + d. */
void pb_sweep_predict(struct pb_sweep *sweep, bool recalls);
void pb_sweep_hold(struct pb_sweep *sweep, int node, int component, double x);
void pb_sweep_project(struct pb_sweep *sweep, int iterations, bool bends, bool recalls);
void pb_sweep_finish(struct pb_sweep *sweep);

#endif
