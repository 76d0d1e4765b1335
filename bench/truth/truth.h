/* truth.h - what a scene's motion is held against, with its error bar.
 *
 * Four kinds. A closed form (truth_closed.h), where the scene is one and has come to rest
 * if only its rest shape is. Where the load is so light that linear theory holds
 * (Gamma < TRUTH_GAMMA)
 * and the sheet is a cantilever: the Kirchhoff plate, exact in time. Where a truth of this
 * scene, with these physics and at these times, is stored (truth_file.h, made by
 * truth_make.h): that. Elsewhere runs made now: for commands that compare models the solid
 * and the shell (truth_find_sharp), whose difference enters the bar, as nets of one model
 * may lock alike; else the finest nonlinear Kirchhoff-Love shell alone, its difference from
 * the next coarser one (net and time step both) as error bar.
 */
#ifndef TRUTH_H
#define TRUTH_H

#include "bench/harness/settings.h"
#include "bench/truth/truth_made.h"
#include "bench/truth/truth_sharp.h"

/* A cantilever's tip is off by 0.0125 Gamma^2 in linear theory (heavy elastica): 1e-4. */
#define TRUTH_GAMMA 0.09

struct truth { /* with its arrays                                                      */
    int times;
    double *time;          /* [times] [s]                                                */
    double **xyz;          /* [times] fields (grid.h) [m]                                */
    double *error;         /* [times] rms error bar [m]                                  */
    char source[640];      /* a sentence                                                 */
    bool alone;            /* the bar is one model's own                                 */
    char unresolved[1200]; /* a sentence on why it is none at some times; else ""       */
};

enum truth_effort {
    TRUTH_FULL,
    TRUTH_QUICK, /* a coarser shell                                                    */
    TRUTH_READ,  /* runs nothing: the best that an earlier call left; else STATUS_FILE */
};

/* Truth of `path` with the settings at time[times]. The shell's motions are kept as result
 * files in `folder` and found again there. STATUS_UNSUPPORTED with a sentence: none, or
 * none is claimed so late. STATUS_INPUT: the stored one was changed. */
enum status truth_find(const char *path, const struct settings *settings, int times,
                       const double *time, const char *folder, enum truth_effort effort,
                       struct truth **truth, struct message *why);

/* The same, but where nothing is stored runs of two models are made until the bar is as
 * small as is asked for, or time is up (truth_sharp.h), and what comes next is told on
 * standard error. STATUS_LATE with a sentence: the deadline (deadline.h) came before two
 * runs of a model were made. */
enum status truth_find_sharp(const char *path, const struct settings *settings, int times,
                             const double *time, const char *folder,
                             const struct truth_wish *wish, struct truth **truth,
                             struct message *why);

/* What is known without a run, of a scene as its truth moves: a closed form, or what is
 * stored, at the times at which tables judge (truth_made_thin); `made->times` is 0 where
 * there is none. STATUS_INPUT: the stored one was changed. Free with truth_made_clear. */
enum status truth_known(const struct scene *scene, struct truth_made *made,
                        struct message *why);

/* Its times up to `until`: the last ones, at most `most` of them, into time[most]. *count
 * is 0 if there is none. STATUS_INPUT: the scene is wrong, or as above. */
enum status truth_stored_times(const char *path, const struct settings *settings,
                               double until, int most, double *time, int *count,
                               struct message *why);

/* Fills in `alone` and `unresolved` of a truth whose runs, fields and bars are made: from
 * where on it is none, and why, be it what its bars leave open or that its own fields can't
 * be right. STATUS_MEMORY. */
enum status truth_doubt(const struct scene *scene, const struct truth_made *made,
                        struct truth *t);

/* "truth's error bar", or "one model's own bar". */
const char *truth_bar_name(const struct truth *t);

void truth_destroy(struct truth *t); /* NULL is allowed */

#endif
