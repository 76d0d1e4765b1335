/* pd_motion.h - the sheet in time: implicit Euler or BDF2, by local and global
 * steps in turn (Bouaziz et al. 2014, algorithm 1).
 *
 * A step solves M (x - x_old - dt v) / dt^2 + alpha M (x - x_old) / dt = f - dE/dx: the
 * free flight is the first guess, then b = M (...) + dt^2 sum w G^T p(G x), A x = b, over
 * and over. Damping: mass (and Rayleigh's alpha) and drag in alpha; velocity_scale and
 * velocity_rate after each frame. The paper's set has v <- (1 - 0.005) v a frame in place
 * of the scene's.
 */
#ifndef PD_MOTION_H
#define PD_MOTION_H

#include "models/mechanics/air.h"
#include "models/mechanics/arrival.h"
#include "models/model.h"
#include "projective_dynamics/pd_contact.h"
#include "projective_dynamics/pd_local.h"
#include "projective_dynamics/pd_system.h"

/* A node that moves by d in an iteration is about d / (1 - rate) from its end, and the rate
 * is 0.999 or more where stretching is stiff against the mass: a tolerance of 1e-8 spoils a
 * motion in steps of 0.06 ms (tests/projective_dynamics/projective_dynamics_truth.c uses
 * 1e-10). */
struct pd_options {
    int points[2];
    char *mesh; /* discretization.h, with the next two; NULL: a grid         borrowed  */
    int seed, refine;
    enum constraint constraint;
    enum parameters parameters;
    int substeps;     /* steps a frame, >= 1                                           */
    int iterations;   /* a step: as many, or at most so many if tolerance > 0; 0: until
                         the step has arrived (arrival.h)                              */
    double tolerance; /* stop where no node moves farther, as a share of the length    */
    bool chebyshev;   /* Wang 2015, and taken back where it does not descend           */
    bool split;       /* ADMM; of triangles                                            */
    bool second;      /* BDF2 for implicit Euler                                       */
    enum solver solver;
};

/* Second order in time for what is written as implicit Euler: BDF2 (Curtiss and
 * Hirschfelder 1952). Of x' = v, v' = a,
 *     x_n+1 = o + s v_n+1,    o = (4 x_n - x_n-1) / 3,    s = 2 dt / 3,
 *     v_n+1 = w + s a_n+1,    w = (4 v_n - v_n-1) / 3,
 * a step of implicit Euler over s from position o and velocity w: its matrix is constant
 * where Euler's is. A-stable and damping as Euler's, of amplitudes a part (omega dt)^4 / 4
 * a step for (omega dt)^2 / 2. Coordinates of held points follow their path. */
struct pd_backward {
    size_t count;
    double *x, *v;          /* a step ago                                              */
    double *origin, *speed; /* o, w                                                    */
    void *room;             /* memory of the arrays; NULL: not in use          owned   */
};

struct pd_motion {
    const struct scene *scene; /*                                           borrowed  */
    struct pd_options options;
    struct mesh mesh;
    struct pd_energy energy;
    struct supports supports;
    struct pd_system system;
    struct pd_local local;
    struct pd_contact contact; /* all zero without obstacles                           */
    double (*push)[6]; /* [obstacles] force and moment, mean over the last frame [N, N m] */
    double dt, alpha;  /* [s], [1/s]                                                    */
    double share;      /* ADMM's weight of the split; 0: there is none                   */
    double span;       /* Euler's step [s]: dt, less with BDF2                          */
    struct pd_backward backward;  /* all zero without BDF2                             */
    const double *origin, *speed; /* where and how fast the span begins, three fields  */
    double radius; /* Chebyshev: of the iteration about the rest shape              */
    double weight; /* weight of the last iteration                                  */
    struct arrival arrival;
    long frame;     /* taken so far                                                      */
    double *fields; /* memory of the next seven                             owned    */
    double *x, *v;  /* three fields each                                            */
    double *base, *start, *next, *before; /* work, the same                           */
    double *saved;  /* Chebyshev: what it may fall back to, as x                       */
    double *shift;  /* [held]                                                          */
    double *spread; /* [nodes][3] with grippers: x                                      */
    double *dead;   /* accelerations by the scene's loads, as x; NULL: none    owned    */
    struct air air; /* density 0: none                                                 */
    double *blow;   /* accelerations by it in the step, as x; NULL: none      owned    */
    struct air_step gust; /* of the step's air                                         */
    double *gust_x, *gust_v, *gust_from; /* its x, v and from                          */
    void *room, *gust_room; /* memory of push, shift and spread; of the air's   owned  */
    double time;
    bool counted; /* the factorisation of create                                       */
};

/* Initialises; *m must stay where it is until pd_motion_clear. */
enum status pd_motion_init(struct pd_motion *m, const struct scene *scene,
                           const struct pd_options *options, struct message *why);
void pd_motion_clear(void *motion);

/* Implement model.h's entries for a struct pd_motion: frame that of advance. STATUS_NAN. */
enum status pd_motion_frame(void *motion, struct counters *counters);
void pd_motion_energy(const void *motion, struct energy *energy);
void pd_motion_size(const void *motion, struct model_size *size);
void pd_motion_contact(const void *motion, struct model_contact *contact);
enum status pd_motion_forces(void *motion, double (*support)[6], double (*body)[6]);

/* Do the parts of a step, for tests and measurements. begin computes its constants (base,
 * and the free flight as first guess in m->x, the old positions in m->start); iterate does
 * one local and global step `number` = 0, 1, ..., and finds how far a node moved at most
 * [m] (0 if NULL). */
void pd_motion_begin(struct pd_motion *m);
enum status pd_motion_iterate(struct pd_motion *m, int number, double *moved);

/* Returns what a step minimises, in J: 1/2 |x - free flight|^2_M (1 + alpha s)/s^2 + E(x),
 * s the span, at m->x, between pd_motion_begin and the end of the step. */
double pd_motion_objective(const struct pd_motion *m);

/* Looks back after `number` accelerated iterations, every few and after the last; tells
 * whether that took them back: m->x is then what it was at the look before, and *number 0.
 * *value is the least objective so far, INFINITY at first. */
bool pd_motion_take_back(struct pd_motion *m, bool last, int *number, double *value);

#endif
