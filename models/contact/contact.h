/* contact.h - a sheet that meets bodies and itself: forces, tangents, and steps that stay
 * outside. The law is contact_law.h's.
 *
 * A touch is a sample of the sheet (contact_surface.h) near a body or near another place of
 * the sheet. Its distance is D, and a force f along the normal n at the touch acts on the
 * model's nodes with the weights that give the sample's motion relative to what it meets:
 * those of its row, less those of the foot's on the sheet.
 *
 * A step in time runs from x_old at the time t to x at t + dt. Bodies are where they are at
 * its end; rates (rebound, friction) are the way of the step over dt. Implicit models take
 * contact_find, contact_force and contact_system.h's tangent in Newton's method, each
 * change cut short by contact_limit; explicit and constraint models contact_project at a
 * step's end.
 */
#ifndef CONTACT_H
#define CONTACT_H

#include "models/contact/contact_law.h"
#include "models/contact/contact_rim.h"
#include "models/contact/contact_search.h"
#include "models/bodies/body_shape.h"
#include "models/contact/contact_surface.h"
#include "models/contact/contact_thin.h"
#include "models/model.h"

struct contact_touch {
    int sample, obstacle;   /* obstacle -1: the sheet itself; sample -1: a rim's point, or a
                               place that meets a body's feature (contact_thin.h)         */
    int first, count;       /* its nodes and weights in contact's lists                  */
    double D, normal[3];    /* distance [m]; the gradient of D by the sample's place     */
    bool mean;              /* the normal is the mean one of the step                    */
    double at[2];           /* u and v of the sheet's own place, where a sample meets it */
    double bound;           /* the push that bounds friction                   [N]     */
    double D_old, D_flat;   /* when the step began, 0: not known; D less its way along the
                               normal                                               [m]   */
    double area;            /* [m^2]                                                     */
    double push, stiffness; /* area times pressure [N] and its slope [N/m]             */
    double rub[3];          /* friction's force                                [N]     */
    double drag;            /* its force over the slip                         [N/m]   */
    double grip;            /* its change by more slip the same way            [N/m]   */
    double share;           /* of the most that friction may have                     */
    double foretold[3];     /* by the last change, over that, and against the force    */
};

struct contact {
    const struct scene *scene; /*                                            borrowed  */
    struct contact_surface surface; /*                            owned     */
    struct contact_law body, self;
    struct contact_search search;    /* with contact.self                       owned     */
    struct contact_rim rim;          /* the same                                owned     */
    int meetings;                    /* places that cut a change short and have no sample */
    struct contact_meeting *meeting; /* [samples]                                    */
    struct contact_thin thin;        /*                                         owned     */
    long crossed; /* steps that ended with a feature of a body through the sheet        */
    enum status failed; /* of contact_limit: the next contact_find returns it          */
    void *arrays; /* memory of those that are not owned by themselves      owned     */
    struct scene_placement *pose, *pose_old; /* [obstacles]                          */
    double dt;           /* of the step; INFINITY: no rates                     [s]    */
    bool held;           /* by contact_hold                                              */
    bool released;       /* held touches were found anew in this step                   */
    bool fresh;          /* no change has followed a release yet                        */
    bool cycles;         /* a release did not lead nearer                               */
    double anew;         /* the change that the last one made                       [m] */
    double share;        /* of their pushes less their bounds, which a release adds     */
    int bounds;          /* how often held touches took their push for its bound        */
    double least_change; /* of contact_hold's in this step, by halves                [m] */
    int waited;          /* changes since                                               */
    int listed[2];       /* touches and meetings then                                    */
    bool rests;          /* the pressure has no rate, only friction                      */
    bool middle;    /* bodies press along the step's mean normal, not that of its end */
    double *x_old;  /* [nodes][3] where it starts                                   */
    double *area;   /* [nodes] their shares of the samples'       [m^2]              */
    bool measured;  /* contact_find has filled `before` in this step                    */
    double *before; /* [samples][2] distances from the sheet above and below when the
                       step began; 0: none is within reach, or known            [m]    */
    double (*foretold)[3]; /* [samples][2] of the touches with bodies, the sheet itself */
    int count, room; /* touches; of the last contact_find or contact_project         */
    struct contact_touch *touch; /*                            owned     */
    int weights, weight_room;
    int *node;       /* [weights]                                          owned     */
    double *weight;  /* [weights]                                          owned     */
    double *spare;   /* [samples][4] a place, and how far from it no still body is met by
                        contact_project [m]                                          */
    int *near;       /* [samples] those that it looks at                             */
    double *pressed; /* [nodes] their shares of the areas that touch                 */
    double energy;   /* of the last contact_find                            [J]      */
    double least;    /* least D of the same, less the start of its law; of
                        contact_project a lower bound where that is positive [m] */
    double (*landed)[6]; /* [obstacles] of contact_force_bodies, what contact_system_land
                            added to the same                                        */
};

/* Returns whether the scene has anything to meet: without it nothing here is needed. */
bool contact_wanted(const struct scene *scene);

/* Returns whether anything in its scene has friction. */
bool contact_rubs(const struct contact *c);

/* Initialises, and takes over the surface (also on failure). */
enum status contact_init(struct contact *c, const struct scene *scene,
                         struct contact_surface *surface);
void contact_clear(struct contact *c);

/* Begins a step at x_old[nodes][3] and time t [s]; dt INFINITY: statics at time t. */
void contact_begin(struct contact *c, double t, double dt, const double *x_old);

/* Begins a step of a search for rest, at time t: the pressure has no rate, and friction is
 * that of a way in the time dt. */
void contact_begin_rest(struct contact *c, double t, double dt, const double *x_old);

/* Finds the touches at x[nodes][3], with forces, stiffness, energy and report. STATUS_NAN,
 * STATUS_MEMORY. */
enum status contact_find(struct contact *c, const double *x);

/* Returns the work that bodies that move did in the step to x[nodes][3] [J]. */
double contact_body_work(const struct contact *c, const double *x);

/* Computes the stiffness K of a touch's friction, g(|s|) against the slip s [N/m]. With f,
 * that force, as an unknown of its own, linearised in f |s| / g = s,
 *
 *     K = g/|s| (1 - (1 - k |s|/g) (f s^T + s f^T) / (2 |f||s|)),   k = dg/d|s|,
 *
 * in which f has the direction that the last change foretold, and is shorter than g where
 * it foretold less. K is Newton's tangent where the change foretold the present force, and
 * never indefinite. The tangent by itself leads from one way of slipping to the other for
 * ever, and g/|s| there in many short changes (Chan, Golub, Mulet 1999, SIAM J. Sci.
 * Comput. 20, 1964, on total variation). */
void contact_grip(const struct contact_touch *t, double K[9]);

/* Adds the forces of the touches to force[nodes][3]. */
void contact_force(const struct contact *c, double *force);

/* Adds `share` of what each body exerts on the sheet at x[nodes][3] to body[obstacles]: the
 * touches' force [N], and its moment about the origin [N m], at the places that forces are
 * taken at: with `middle` those in the middle of the step. */
void contact_force_bodies(const struct contact *c, const double *x, double share,
                          double (*body)[6]);

/* Adds `share` of a force at a place, and of its moment about the origin, to sum. */
void contact_force_at(const double at[3], const double force[3], double share,
                      double sum[6]);

/* Computes the force of all, model_contact's. */
void contact_force_sum(const struct contact *c, const double (*body)[6], double force[3]);

/* Cuts a change d of x to the largest share, returned, at most 1, that leaves each sample
 * half of its distance to the wall, or half of the range where that is less. Places of the
 * sheet that allow no more, and that no sample presses apart, as two edges, are touches
 * from then on. */
double contact_limit(struct contact *c, const double *x, double *d);

/* Shortens the way from the step's start to x[nodes][3], where a step is thought to end, by
 * contact_limit. */
void contact_lead(struct contact *c, double *x);

/* Shortens the change d[nodes][3] of x so that each sample leaves as much: before bodies
 * each node's by a share of its own, before the sheet itself all by one; returns whether
 * any was shortened. For samples of one node. */
bool contact_shorten(struct contact *c, const double *x, double *d);

/* Moves x[nodes][3], where a step would end without contact, to where it ends with it:
 * a body's touches at once, the sheet's own one after the other, each by the force that the
 * law has where it then is (contact_law_solve). compliance[nodes]: a node's move at the
 * step's end by a force on it [m/N]; held[3 nodes] (negative: held, as supports'
 * free_index) does not move. STATUS_NAN, STATUS_MEMORY. */
enum status contact_project(struct contact *c, const double *compliance, const int *held,
                            double *x);

/* Does so as if the sheet could not meet itself. */
enum status contact_project_bodies(struct contact *c, const double *compliance,
                                   const int *held, double *x);

/* Does so for the features of thin bodies alone. */
enum status contact_project_features(struct contact *c, const double *compliance,
                                     const int *held, double *x);

/* Computes change[nodes][3], by the touches with one body, or CONTACT_ANY, which takes
 * from v[nodes][3], the velocity at x after contact_find at the end of a step of the
 * trapezoidal rule, the bounce that is the rule's: it ends with twice the mean velocity
 * less that of its start, so that it throws back what a body stops within a step, and what
 * sticks trembles. Touches that open faster than in the mean of the step, and what sticks,
 * lose a share of the difference; the nodes have a change by their shares of the samples'
 * areas.
 *
 * The share is a^2 / (1 + a^2), a = k dt^2 / 2m of the touch's stiffness k and the mass m
 * of its area. The rule makes (1 - a) / (1 + a) of a velocity v_0 that should become
 * e^(-2a) v_0, its mean being v_0 / (1 + a); with the share it makes (1 - a / (1 + a^2)) /
 * (1 + a), which is right to a^2, as the rule is, and never negative. So what a step
 * resolves keeps the order of the rule, and what it does not resolve ends in the step. */
enum { CONTACT_ANY = -2 };
void contact_landing(const struct contact *c, int obstacle, const double *x,
                     const double *v, double *change);

/* Fills *report from the last contact_find or contact_project, but for the force. */
void contact_report(const struct contact *c, struct model_contact *report);

#endif
