/* air.h - a scene's air: drag that grows with the square of the velocity against it, by
 * area and direction of the sheet.
 *
 * Let w be the wind less the velocity of a point of the mid-surface, n its unit normal, and
 * w_n = (w n) n and w_t = w - w_n the parts of w. The force per present area, of both faces
 * together, is
 *
 *   f = rho / 2 (c_n |w_n| w_n + c_t |w_t| w_t):
 *
 * a plate across the stream has the drag coefficient c_n by its area, one along it c_t.
 * Each part knows its own velocity alone, as the cross-flow principle has it for inclined
 * wires (Hoerner 1965, Fluid-Dynamic Drag); for forces of an air flow on cloth see Ling,
 * Damodaran and Gay 1996, Aerodynamic force models for animating cloth motion in an air
 * flow. No part of a sheet shelters another, there is no lift beyond this, and air has no
 * mass.
 *
 * The force on a coefficient x_a with the function N_a is int N_a f |x_u x x_v| du dv. The
 * tangent is the symmetric part of its derivative by the velocity, which is positive
 * semidefinite, and by normal and area; Newton's method can do without the rest.
 *
 * Sweeps, which know no tangent but their own, take the force as constant in a step
 * (air_ahead): it is the one that the step would end with if nothing but loads and air
 * acted, linear in the change of velocity. It never turns a relative velocity round,
 * however long the step is.
 */
#ifndef AIR_H
#define AIR_H

#include "models/linalg/blocks.h"
#include "models/scene.h"

enum { AIR_MOST = 64 }; /* points an element                                           */

struct air {
    double density; /* 0: there is none                              [kg/m^3]      */
    double drag[2]; /* c_n, c_t                                                     */
    double wind[3]; /* at the time of air_blow                           [m/s]     */
    int elements, points, local; /* points an element, functions alive there            */
    void *room;                  /* of the arrays                               owned   */
    int *node;                   /* [elements][local]                                   */
    double *shape; /* [elements][points][3][local] N times the weight, N_u, N_v        */
};

/* Makes room for nodes and functions, which the caller fills in; nothing for a scene
 * without air. STATUS_MEMORY. */
enum status air_init(struct air *air, const struct scene *scene, int elements, int points,
                     int local);
void air_clear(struct air *air);

/* Sets the wind to the one that blows at time t [s]. */
void air_blow(struct air *air, const struct scene *scene, double t);

/* A sheet has the shape (1 - share) x_old + share x and the velocity v, or, if that is
 * NULL, rate (x - x_old). x_old may be NULL if share is 1 and rate 0. */
struct air_motion {
    const double *x_old, *x, *v; /* [nodes][3]                              [m], [m/s] */
    double share, rate;          /*                                         [1], [1/s] */
};

/* Adds `factor` times the force to f[nodes][3]. */
void air_force(const struct air *air, double factor, const struct air_motion *at,
               double *f);

/* Adds `factor` times minus that force's derivative by x to K[pairs]. `firm` leaves out the
 * part of normal and area. */
void air_tangent(const struct air *air, double factor, const struct air_motion *at,
                 bool firm, const struct blocks *graph, double (*K)[9]);

/* A step of points begins with the velocities `from` and has the forces `load`. */
struct air_step {
    int nodes;
    double dt;                        /*                              [s]      */
    const double *mass, *drag, *load; /* [nodes] [kg], [nodes] or NULL, force
                                         over velocity [N s/m]; [nodes][3] [N] */
    const double *x, *v, *from;       /* [nodes][3]: shape and velocities about which the
                                         force is linear         [m], [m/s]    */
    double *force;     /* [nodes][3] computed                           [N]     */
    double (*hold)[9]; /* [nodes] work                                          */
};

/* Computes the air's force on the points, constant in the step; 0 on those without mass. */
void air_ahead(const struct air *air, const struct air_step *s);

#endif
