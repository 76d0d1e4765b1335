/* march.h - a body with mass, forces and a tangent in time, at rest, and its modes. Shell,
 * solids and nets give the body (large_body.h), their rest shape and what is held; damping,
 * supports, loads, pressure, contact and counters are dealt with here, once. A scheme in
 * time is a row of march.c's table and a file:
 *
 *   newmark    a linear body, whose tangent is constant: one factorisation, average
 *              acceleration (integrator_newmark.c).
 *   printed    the paper's schemes, on matrices of the present shape in every step:
 *              kinematics printed and incremental (integrator_printed.c).
 *   momentum   large displacements, implicit: energy-momentum steps, or Euler's
 *              (integrator_momentum.c), by Newton's method (large_newton.h).
 *   leapfrog   large displacements, explicit (integrator_leapfrog.c).
 *
 * A net whose steps are sweeps brings a row of its own (net/spring_leapfrog.h).
 *
 * Equilibrium is in march_rest.c. A model's state begins with a struct march, so that the
 * functions at the end serve as entries of struct model.
 */
#ifndef MARCH_H
#define MARCH_H

#include "models/contact/contact_outside.h"
#include "models/mechanics/air.h"
#include "models/mechanics/contact_coupled.h"
#include "models/mechanics/dead_load.h"
#include "models/mechanics/large_body.h"
#include "models/mechanics/newton.h"
#include "models/mechanics/pressure.h"
#include "models/model.h"

enum { MARCH_GAINS = 5 };

struct march {
    /* The owner sets these before march_init; borrowed. */
    struct large_body body; /* not needed by `newmark` and `printed`, which have K        */
    const struct scene *scene;
    const struct blocks *graph;
    const double *mass;   /* [nodes] lumped mass, of which M is made then; or NULL [kg]   */
    const double *drag;   /* [nodes] of points, with mass, in place of the scene's damping;
                             NULL: the scene's                               [N s/m]    */
    const double *M;      /* [pairs] mass                                        [kg]    */
    const double *beyond; /* [pairs] of explicit steps, whose M is diagonal: the mass is M
                             less this, below 2 M; NULL: M itself               [kg]    */
    const double (*stiffness)[9]; /* [pairs] about rest, of the present shape under
                                     `printed`; NULL: the body's tangent at rest [N/m]   */
    const double *rest;           /* [nodes][3]                                  [m]     */
    const double (*uvw)[3]; /* [nodes] parameters if some nodes are differences, or NULL */
    const double *measure;  /* [nodes] int N_a over area or volume       [m^2 or m^3]    */
    double depth;           /* of what that does not measure: thickness, or 1  [m or 1]  */
    double *x;              /* [nodes][3] present coefficients; NULL: made here  [m]     */
    double *load; /* [nodes][3] gravity, wind and loads; NULL: made here, of measure [N] */
    int net[3]; /* nodes along u, v, w, numbered w fastest, then v                       */
    const int *order; /* [nodes] of a factorisation; NULL: by `net`                      */
    enum status (*surface)(const void *sheet, const struct scene *scene,
                           struct contact_surface *surface); /* makes what contact sees, of
                           the sheet here; NULL: the owner makes the contact             */
    const void *sheet; /*                                                  borrowed  */
    struct supports *supports;
    const unsigned char *parity; /* [nodes][3] system.h, linear bodies only; or NULL     */
    const char *unknowns;        /* their basis, in struct model_size                    */
    const char *singular; /* what else a singular stiffness may mean; NULL: nothing      */
    enum status (*follow)(struct march *m);  /* sets up an iterated system, after march_init
                            and where other unknowns are held; or NULL                    */
    enum status (*rebuild)(struct march *m); /* of `printed`: M, stiffness, measure at x */
    double lag;  /* algorithmic viscosity (integrator_momentum.c)                 */
    bool relief; /* lag is march_lag for a while after a step that Newton's method cannot
                    take without                                                         */

    const struct march_integrator *integrator; /* NULL: that of the kinematics          */
    const void *moved; /* of an integrator of nets: spring_leapfrog.h                    */

    bool learns;  /* a step is guessed by extrapolating the gains of velocity          */
    bool euler;   /* implicit steps are Euler's                                           */
    int substeps; /* of a frame; 0: one                                                  */
    double loose; /* tolerance of an iterated system's changes; 0: the system's own   */
    double tolerance; /* change that ends Newton's iteration; 0: its own        [m]      */
    double still;     /* newton.h's; 0: none                                     [m]    */
    int enough; /* iterations after which a step is taken; 0: converged                 */

    enum kinematics kinematics;
    struct discretization asked; /* kinematics, solver and preconditioner only          */
    struct system system;
    double dt;          /* length of a step                              [s]     */
    double alpha, beta; /* Rayleigh damping, drag in alpha              [1/s, s] */
    double keep;        /* factor on velocities after each frame         [1]     */
    double gamma;       /* K + gamma M acts on d [1/s^2]; of `printed` only      */
    double density[SCENE_MAX_SHEETS]; /*                                       [kg/m^3]  */
    void *room;        /* of the arrays but dead and Newton's           owned   */
    void *tangents;    /* of Newton's: V, K, past, newton, strain_old   owned   */
    double *d, *v, *a; /* [nodes][3] displacement (integrator_printed.c: increment),
                          velocity, mean acceleration of the last step */
    double *work;      /* [3][nodes][3]                                         */
    double *dead;      /* [nodes][3] of which the scene's loads; or NULL owned  */
    double *held;      /* [4][held_count] march_path                            */
    double (*V)[9];    /* [pairs] of a plain body with beta: the tangent where a step began,
                          which damps; else NULL                      [N/m]   */
    double (*K)[9];    /* [pairs] room for tangents                     [N/m]   */
    double time;       /*                                               [s]     */
    bool started; /* newmark: the system is factored; else strain_old belongs to x       */
    struct pressure pressure; /* value 0: none                                         */
    struct air air; /* density 0: none; made by the owner of a body, before steps      */
    struct contact *contact; /* NULL: nothing to meet                         owned   */
    struct contact_outside outside; /* `printed`, in its place                           */
    double (*push)[6];     /* [obstacles] force and moment of bodies, mean over the last
                              step                                       [N, N m]  */
    double (*reaction)[6]; /* [supports] theirs, if that step was weighed              */
    bool weighs, weighed;  /* the next step is to be (march_forces), the last one was     */
    bool clamps;           /* the body is a net, whose clamps turn it by no point's force */

    /* The rest is of large displacements. */
    bool full;                      /* a new tangent in each iteration                   */
    struct contact_coupled coupled; /* where the sheet touches itself            owned   */
    double *strain_old;             /* strains at the step's start                       */
    double *gain;    /* of the last substep, gain_dt long; NULL: no viscosity        */
    double gain_dt;  /*                                                      [s]     */
    int stay, stays; /* with relief: substeps that the lag is still for, was last    */
    double *past;    /* [MARCH_GAINS][nodes][3] gain of velocity in the last step, and its
                        backward differences of orders 1, 2, ..., past_dt long  [m/s]    */
    double past_dt;  /*                                                          [s]     */
    int orders;      /* those that would have foretold the last gain best, in their sum */
    double *newton; /* [3 + NEWTON_ROOM][nodes][3]: x_old, hat, work, newton.h            */
    double factored; /* mass factor of the tangent that is factored; -1: none        */
    double added;    /* mass added to the factored tangent; 0: none         [1/s^2]  */
    bool stressless; /* the present tangent leaves out the stress                    */
    bool worn;       /* the last equation could not do with one factored tangent     */
    bool rested;     /* x is an equilibrium (march_rest.c)                           */
    int halvings;    /* the present substep is step / 2^halvings                     */
    void *own;       /* the integrator's own state                          owned   */
};

/* A scheme in time. */
struct march_integrator {
    bool explicit; /* steps need no system; equilibrium makes it                       */
    /* Makes what it needs besides, at the end of march_init; NULL: nothing. */
    enum status (*make)(struct march *m, const struct discretization *d,
                        struct message *why);
    /* Takes a step of m->dt from time t, x and v; neither damps nor counts it. */
    enum status (*step)(struct march *m, double t, struct counters *counters);
    /* Remakes what depends on which unknowns are held, before a step; NULL: nothing. */
    enum status (*hold)(struct march *m);
    /* Ends a step after velocities were damped; NULL: nothing is left to do. */
    void (*end)(struct march *m, struct counters *counters);
    /* Moves x to equilibrium, at m->time. */
    enum status (*rest)(struct march *m, struct counters *counters, struct message *why);
    /* Finds model.h's modes about an equilibrium that is m->rested; NULL: none is. */
    enum status (*modes)(struct march *m, int count, double *omega, struct message *why);
    /* Returns the free unknowns' kinetic energy where the mass is not M [J]. */
    double (*kinetic)(const struct march *m);
    void (*describe)(const struct march *m, struct message *line); /* NULL: nothing       */
    /* Set by steps that do not need the march's contact, tangents and their room either,
     * which are then made when equilibrium asks for them: the contact of the last step, and
     * v brought up to x. */
    void (*contact)(const struct march *m, struct model_contact *contact);
    void (*look)(const struct march *m);
    void (*clear)(struct march *m); /* frees m->own        */
};
extern const struct march_integrator integrator_newmark, integrator_printed;
#define MARCH_DECLARE(name, word, file)                                                    \
    extern const struct march_integrator integrator_##file;
INTEGRATORS(MARCH_DECLARE)

/* Returns the numbers of a vector field. */
static inline size_t march_count(const struct march *m)
{
    return 3 * (size_t)m->graph->nodes;
}

/* Tells whether the scheme asked for is explicit. */
bool march_explicit(const struct discretization *d);

/* The viscosity of bodies that need one. */
extern const double march_lag;

/* Initialises at rest, of zeros but what the owner sets; *m must stay where it is: it holds
 * pointers into itself. march_clear follows a failure, too. */
enum status march_init(struct march *m, const struct discretization *d,
                       struct message *why);

void march_clear(struct march *m);

/* Returns v, brought up to x: nets compute their energies from it. Borrowed. */
const double *march_velocity(const struct march *m);

/* Forgets the forces of supports and bodies. */
void march_forget(struct march *m);

/* Notes that x is at rest at time t: no velocity, and no history of steps. */
void march_still(struct march *m, double t);

/* Puts the scene's loads on the functions of u, v and w, once. */
enum status march_load(struct march *m, const struct dead_load_line line[3]);

/* Computes gravity and wind on the present measure, and adds the scene's loads. */
void march_weigh(struct march *m);

/* The motion of the held unknowns at the end of a step, each [held_count]; NULL of what
 * does not move. */
struct march_held {
    const double *d, *v, *a;
};

/* Returns the motion by the supports' paths at time t, by central differences over +-dt,
 * in m->held. */
struct march_held march_path(struct march *m, double t, double dt);

/* Gives held unknowns the velocity of supports that move, at time t. */
void march_follow(struct march *m, double t);

/* Entries of struct model, of a state that begins with a struct march. The elastic energy
 * is NaN under `printed`. march_describe tells of explicit steps and their mass.
 * march_modes: about equilibrium if that was found last (march_rest.c), else about rest. */
enum status march_step(void *state, struct counters *counters);
void march_energy(const void *state, struct energy *energy);
void march_contact(const void *state, struct model_contact *contact);
enum status march_forces(void *state, double (*support)[6], double (*body)[6]);
void march_size(const void *state, struct model_size *size);
void march_describe(const void *state, struct message *line);
enum status march_equilibrium(void *state, struct counters *counters, struct message *why);
enum status march_modes(void *state, int count, double *omega, struct message *why);
enum status march_matrices(const void *state, struct matrix *K, struct matrix *M);

#endif
