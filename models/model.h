/* model.h - the contract every cloth model fills: one `const struct model` each, named in
 * bench/harness/contestant_table.c and nowhere else.
 *
 * A model turns scene + discretization into motion. It never prints, times itself or
 * computes its own error. Numerical death is a status (status_is_death), not an abort.
 * Function pointers that say "optional" may be NULL: the model has no such thing.
 */
#ifndef MODEL_H
#define MODEL_H

#include "models/option.h"
#include "models/scene.h"

/* Work done, added up by the model; does not jitter as seconds do. */
struct counters {
    long steps, assemblies, factorisations, solves, iterations;
    long substeps; /* sum over all steps; 0: the model never divides steps */
    long viscous;  /* steps with a viscosity that Newton's method failed without          */
    long tested;   /* samples that were held against a body, where that is counted        */
    double left;   /* largest share of a step's loads that iterations left so far
                      (models/mechanics/arrival.h) [1]; 0: not measured                 */
    long missed;   /* steps whose iterations have not arrived at their limit            */
    double astray; /* `left` where a chosen number of iterations of a descent left more
                      than all loads; else 0 [1]                                        */
};

struct energy {
    double kinetic, elastic, potential; /* [J]; potential of gravity, zero at rest; what
                                           contact stores: struct model_contact        */
};

/* The size of what was built. */
struct model_size {
    long nodes;          /* control points or nodes                                    */
    long unknowns;       /* 3 nodes - held components                                  */
    long factor_entries; /* numbers stored in the factor; 0 if none                    */
    const char *solver;  /* "banded", "cholmod" or "mixed"; static storage            */
    const char *unknown_basis; /* "control points", "thickness"; static storage        */
};

/* The contact of a sheet with the scene's obstacles, after the last step. */
struct model_contact {
    int nodes;        /* samples of the sheet that an obstacle carries                 */
    double least_gap; /* least distance of them from an obstacle, less that at which
                         contact starts: minus the compression of what rests; INFINITY
                         without obstacles                                       [m]   */
    double energy;    /* stored in the pressure                                  [J]   */
    double force[3];  /* force on the sheet, mean over the last step             [N]   */
    long crossed;     /* steps so far that ended with part of an obstacle through the sheet:
                         a line, a corner, that is thinner than the net (contact_thin.h)    */
};

/* Sparse symmetric matrix handed out for inspection; coordinates, lower triangle, 0-based,
 * both arrays [entries], owned by the receiver (free with matrix_clear). */
struct matrix {
    int rows;
    long entries;
    int *row, *column;
    double *value;
};
void matrix_clear(struct matrix *m);

/* Refuse a scene that needs more than `serves`, SCENE_NEED_* bits: STATUS_UNSUPPORTED with
 * a sentence that names what is missing. model_refuse_net: more than d->model serves by a
 * net of points on the mid-surface, points=[n,m,1]; a support on part of the thickness is
 * served if it takes the mid-surface: it holds the points, and the sheet may turn about
 * them. It calls model_refuse_options, too. */
enum status model_refuse(const struct scene *scene, unsigned serves, struct message *why);
enum status model_refuse_net(const struct scene *scene, const struct discretization *d,
                             struct message *why);

/* Refuses, with a sentence, a choice that d->model does not have (STATUS_INPUT), or has
 * with other words only (STATUS_UNSUPPORTED). */
enum status model_refuse_options(const struct discretization *d, struct message *why);

/* Fills *d with the model's defaults. */
void model_defaults(const struct model *model, struct discretization *d);

/* Fill *d with the model's defaults, but for points, degrees and the remedy, which depend
 * on each other; and, once settings were read into it, fill in those that are still open:
 * with the defaults, or with what suits the rest, which *told then says (else empty). */
void model_open(const struct model *model, struct discretization *d);
void model_complete(const struct model *model, const struct scene *scene,
                    struct discretization *d, struct message *told);

struct model {
    const char *name;   /* key: command line, result file, test name                   */
    const char *title;  /* as printed in tables                                        */
    const char *source; /* citation of the formulation                                 */
    unsigned serves;    /* the SCENE_NEED_* bits it supports                           */

    const struct schema_key *options; /* its numerical choices (option.h)              */
    struct discretization defaults;   /* owns nothing                                  */

    /* optional: fills in degrees and the remedy where they were left open and the scene or
     * the rest of *d excludes the defaults; with a reason, unless points and knots are it.
     */
    void (*adapt)(const struct scene *scene, struct discretization *d,
                  struct message *reason);

    /* optional: how many points direction i needs on this scene besides the default ones,
     * at the degree of *d. */
    int (*extra_points)(const struct scene *scene, const struct discretization *d, int i);

    size_t bytes; /* of its state                                                      */

    /* Builds everything that does not depend on time in a state of zeros.
     * STATUS_UNSUPPORTED with a sentence ("no contact") if the scene has physics the model
     * leaves out; STATUS_INPUT if the discretization is impossible. Scene and
     * discretization are borrowed until clear, which follows a failure, too. */
    enum status (*init)(void *state, const struct scene *scene,
                        const struct discretization *d, struct message *why);

    /* Takes one time step (scene->step) and adds to *counters. After a death the state may
     * still be sampled and cleared. */
    enum status (*advance)(void *state, struct counters *counters);

    /* optional: fills xyz[GRID_W][GRID_V][GRID_U][3] with positions of the material grid
     * [m], the bits of `probe`, where that is slower. */
    void (*sample)(const void *state, double *xyz);

    /* Fills xyz[n][3] with positions of material points uvw[n][3] [m]. */
    void (*probe)(const void *state, int n, const double *uvw, double *xyz);

    void (*size)(const void *state, struct model_size *size);

    /* optional: writes what users should know of what was built and could not guess (a
     * misfit, a limit), as sentences in one line; empty if there is nothing. */
    void (*describe)(const void *state, struct message *line);

    /* optional: writes doubts about the motion so far (iterations that end too early). */
    void (*doubt)(const void *state, struct message *line);

    /* optional */ void (*energy)(const void *state, struct energy *energy);

    /* optional: reports contact; needed where SCENE_NEED_CONTACT is supported. */
    void (*contact)(const void *state, struct model_contact *contact);

    /* optional: fills support[support_count][6] and body[obstacle_count][6] with the force
     * [N] and its moment about the scene's origin [N m] that each support and each obstacle
     * exerts on the sheet: mean over the last step, or of the equilibrium; NaN where it is
     * not known. A step may have them only if it was asked for them, by a call with NULL
     * for both before it; one that was not asked for them has no work with it.
     *
     * A body's force is that of model_contact; under kinematics=printed and incremental it
     * is NaN, and supports' are those of these schemes' own equations. Schemes that sweep
     * over points (integrator=leapfrog on a grid, position_based, vbd, projective_dynamics)
     * keep no momentum of what is held: theirs is what elastic forces, loads and inertia
     * need at the step's end; with PBD, NaN. The couple by which a clamp keeps a net of
     * points from turning has no points to act on: with more than one support moments of
     * nets are NaN, those of projective_dynamics always. Damping that scales velocities is
     * no force. */
    enum status (*forces)(void *state, double (*support)[6], double (*body)[6]);

    /* optional: fills xyz[nodes][3] with the present control points of a sheet that does
     * not go through them, numbered as for `matrices`. In scenes with obstacles. */
    void (*net)(const void *state, double *xyz);

    /* optional: moves the state to static equilibrium under the scene's loads, at rest, on
     * obstacles if there are any. On success *why may say how it was found.
     * Supports that move end where the scene does, and a motion goes on from there; what
     * depends on the way, as a strip that is pressed until it buckles, follows them: loads
     * first, then the paths. */
    enum status (*equilibrium)(void *state, struct counters *counters, struct message *why);

    /* optional: finds the `count` lowest angular frequencies [rad/s], ascending: about the
     * shape that `equilibrium` left, under its stress, where kinematics are nonlinear and
     * no step has been taken since; else about the rest shape, where zero modes of an
     * unsupported sheet come first. Modes of an unstable equilibrium that grow as exp(s t)
     * are given as -s, before all others. */
    enum status (*modes)(void *state, int count, double *omega, struct message *why);

    /* optional: makes K and M of the rest shape, all 3*nodes rows, control-point unknowns,
     * row = 3 node + component, node = (i m + j) l + k (w fastest, then v, then u). */
    enum status (*matrices)(const void *state, struct matrix *K, struct matrix *M);

    /* optional: frees what the state owns, after a failure of init what there is of it. */
    void (*clear)(void *state);
};

/* Creates the state of a model as its `init` says, aligned for vectors; destroys it, NULL
 * is allowed. On failure *state is untouched. */
enum status model_create(const struct model *model, const struct scene *scene,
                         const struct discretization *d, void **state, struct message *why);
void model_destroy(const struct model *model, void *state);

/* Fills xyz with positions of the material grid, as `sample` says. */
void model_sample(const struct model *model, const void *state, double *xyz);

#endif
