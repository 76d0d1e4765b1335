/* study_cures.h - the cures for locking beside each other: a square cantilever under its
 * own weight on the paper's own net, at every thickness and Poisson's ratio, in linear and
 * nonlinear statics, against a truth that is computed in the same run by something else:
 *
 *   h/L = 0.1, linear and nonlinear   a 3-D solid of degree (4,4,3), graded to the clamp;
 *   thinner, linear                   Kirchhoff's plate;
 *   thinner, nonlinear                the elastica at nu = 0 (a strip does not curl), the
 *                                     shell of degree 4 at h/L = 1e-2 else: at the same
 *                                     Gamma thin sheets have one shape.
 *
 * Error bars: the same on a coarser net. What a rebuilt frame costs is timed on edge_drop.
 */
#ifndef STUDY_CURES_H
#define STUDY_CURES_H

#include "bench/experiment/experiment.h"
#include "bench/harness/run_result.h"

enum {
    STUDY_CURES_SPACES = 6,
    STUDY_CURES_THICKNESSES = 5,
    STUDY_CURES_NUS = 3,
    STUDY_CURES_LAWS = 3, /* linear; nonlinear at two Gammas                           */
    /* what is solved: the spaces, then */
    STUDY_CURES_TRUTH = STUDY_CURES_SPACES,
    STUDY_CURES_COARSER, /* the truth's error bar                                      */
    STUDY_CURES_SLIT,    /* the 3-D solid whose clamp leaves the thickness free        */
    STUDY_CURES_WHATS
};

struct study_cures_space {
    const char *label, *name; /* of tables; of files, [a-z0-9_]+                       */
    const char *contestant;   /* its kinematics are the law's                          */
};
extern const struct study_cures_space study_cures_space[STUDY_CURES_SPACES];
extern const double study_cures_thickness[STUDY_CURES_THICKNESSES]; /* h/L             */
extern const double study_cures_nu[STUDY_CURES_NUS];
extern const double study_cures_gamma[STUDY_CURES_LAWS]; /* 0: linear                  */

/* Asked of a cure: tip over truth, but for this.                                      */
extern const double study_cures_target;

/* A tip; NaN: not found, not asked for, or there is none. */
struct study_cures_tip {
    double x, z; /* along and below the clamp                                      [L] */
};

struct study_cures {
    struct study_cures_tip tip[STUDY_CURES_WHATS][STUDY_CURES_LAWS][STUDY_CURES_NUS]
                              [STUDY_CURES_THICKNESSES];
    int zero_modes[STUDY_CURES_SPACES];
    struct run_result frame[STUDY_CURES_SPACES];
    bool quick;         /* not all thicknesses, coarser truths                          */
    char machine[4096]; /* file of a timed run                                          */
};

/* The tip of a space or a truth (STUDY_CURES_TRUTH, _COARSER, _SLIT); NaN after a death and
 * where there is no truth. Quick: truths on coarser nets. */
enum status study_cures_solve(int what, int law, int nu, int thickness, bool quick,
                              struct study_cures_tip *tip, struct message *why);

/* Result files of tips found by a solver such as that, zero modes, and frames. */
typedef enum status study_cures_solver(int what, int law, int nu, int thickness, bool quick,
                                       struct study_cures_tip *tip, struct message *why);
enum status study_cures_measure(const struct experiment_options *options,
                                study_cures_solver *solver, struct message *why);

/* Zero modes of the free sheet, h/L = 0.02, by the eigenvalues of its stiffness. */
enum status study_cures_zero_modes(const struct study_cures_space *space, int *count,
                                   struct message *why);

/* Tip over truth of one cell, and how far that is from 1. */
double study_cures_ratio(const struct study_cures *s, int space, int law, int nu, int n);
double study_cures_error(const struct study_cures *s, int space, int law, int nu, int n);

enum status study_cures_read(const char *folder, struct study_cures **s,
                             struct message *why);
void study_cures_destroy(struct study_cures *s); /* NULL is allowed */

/* Tables and sentences; errors.csv and the chart `cures` into the folder
 * (study_cures_print.c). */
enum status study_cures_tell(const struct study_cures *s, const char *folder,
                             enum table_format format, FILE *file, struct message *why);

#endif
