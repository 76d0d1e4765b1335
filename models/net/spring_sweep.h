/* spring_sweep.h - one explicit step of a whole net, on flat arrays: for every point
 *     v <- keep v + kick + sum over neighbours of (A + B |e|^2) e,    x <- x + dt v,
 * e the edge to the neighbour; cells of triangles have their tensions in place of B |e|^2.
 * All coefficients are per step and per mass. Stiffness damping beta takes edges between
 * the points x + beta v, which are then what is kept in place of x: springs resist where
 * they will be, so that they resist how fast they change.
 *
 * Each point gathers from its neighbours, nothing is scattered: one pass, and the same bits
 * in whatever order points are done. Rows lie one behind the other, and the compiler's
 * vectors run on over their ends: coefficients are zero where there is no neighbour, and a
 * net costs what its points cost, however narrow. A net of more than some hundred points is
 * cut into strips of rows; strips with equal coefficients share them: a plain net has a few
 * kinds, which stay near.
 */
#ifndef SPRING_SWEEP_H
#define SPRING_SWEEP_H

#include "models/discretization.h"
#include "models/net/net_origin.h"
#include "models/status.h"

/* The coefficients of a point, in the order of spring_stencil_step. */
enum spring_sweep_place {
    SWEEP_A = 0,    /* [8] constant part, neighbours that share a cell   [1/s]          */
    SWEEP_B = 8,    /* [8] part in squares of lengths                   [1/(s m^2)]    */
    SWEEP_FAR = 16, /* [4] constant part, neighbours two away           [1/s]          */
    SWEEP_KEEP = 20,
    SWEEP_FREE = 21, /* [3] 1, or 0 for held components                                 */
    SWEEP_KICK = 24, /* [3] of constant forces, zero where held          [m/s]           */
    SWEEP_PUSH = 27, /* velocity per force of cells                   [m/s/N]          */
    SWEEP_COUNT = 28
};

/* The strain measure of triangles (triangles/tri_body.h). */
enum membrane {
    MEMBRANE_GREEN,
    MEMBRANE_COROTATIONAL,
    MEMBRANE_BARAFF_WITKIN,
    MEMBRANE_SPRINGS /* of tri_shell.h only */
};

/* A membrane of triangles in place of springs: each cell cut along one diagonal, in turns
 * (triangles/tri_body.h). */
struct spring_cells {
    enum membrane membrane;
    double D[4];    /* D11, D12, D22, D33 of strains (triangles/tri_body.h) [N/m]    */
    double cell[2]; /* a_u, a_v                                                [m]     */
};

struct spring_sweep; /* opaque; positions, velocities and coefficients                  */

/* The plan of n x m points. All of it is copied. */
struct spring_sweep_plan {
    int n, m;
    int sheet; /* rows after which another sheet begins; n: there is one               */
    enum precision precision;
    double lag; /* beta [s]                                                            */
    const struct spring_cells *cells; /* NULL: springs in squares of lengths           */
    struct net_origin origin;         /* from which places are counted                 */
};

/* Makes a sweep, at rest at the origin. *sweep is owned by the caller. */
enum status spring_sweep_make(const struct spring_sweep_plan *plan,
                              struct spring_sweep **sweep);
void spring_sweep_free(struct spring_sweep *sweep);

/* Sets coefficients c[n m][SWEEP_COUNT] of the steps that follow. */
void spring_sweep_set(struct spring_sweep *sweep, const double (*c)[SWEEP_COUNT]);

/* Put and get x + lag v and v, [n m][3]; rounded to the precision. NULL: leaves them. */
void spring_sweep_put(struct spring_sweep *sweep, const double *x, const double *v);
void spring_sweep_get(const struct spring_sweep *sweep, double *x, double *v);

/* Sets one component of x + lag v [m] and v [m/s] of one point. */
void spring_sweep_hold(struct spring_sweep *sweep, int node, int component, double x,
                       double v);

/* Lets the origin follow x + lag v and v, as they were got. Returns whether it did: they
 * are put again then, and coefficients must be set again, whose kicks depend on its
 * velocity. */
bool spring_sweep_follow(struct spring_sweep *sweep, const double *x, const double *v);

/* Returns the origin. */
const struct net_origin *spring_sweep_origin(const struct spring_sweep *sweep);

/* Runs `count` steps of dt [s]. dt = 0 is a kick without a drift. */
void spring_sweep_run(struct spring_sweep *sweep, double dt, int count);

#endif
