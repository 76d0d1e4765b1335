/* truth.h - what a scene's motion is held against, with its error bar.
 *
 * A closed form (truth_closed.h), where the scene is one and has come to rest if only its
 * rest shape is. Where the load is so light that linear theory holds (Gamma < TRUTH_GAMMA)
 * and the sheet is a cantilever: the Kirchhoff plate, exact in time. Where a truth of this
 * scene, with these physics and at these times, is stored (truth_file.h, made by
 * truth_make.h): that. Elsewhere nothing is known, until a truth is made.
 */
#ifndef TRUTH_H
#define TRUTH_H

#include "bench/harness/settings.h"
#include "bench/truth/truth_make.h"

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

/* Returns what is known of the scene at `path` with the settings at time[times], by what is
 * stored or was left in `folder` by truth_find_or_make; NULL: nothing was. It runs nothing.
 * STATUS_FILE: nothing is known; STATUS_UNSUPPORTED with a sentence: no truth can be had,
 * or none is claimed so late; STATUS_INPUT: the stored one was changed. */
enum status truth_find(const char *path, const struct settings *settings, int times,
                       const double *time, const char *folder, struct truth **truth,
                       struct message *why);

/* The same, but where nothing is stored one is made (truth_make.h), its runs and itself are
 * left in the folder, and a line a run is said on standard error. The statuses of both. */
enum status truth_find_or_make(const char *path, const struct settings *settings, int times,
                               const double *time, const char *folder,
                               const struct truth_wish *wish, struct truth **truth,
                               struct message *why);

/* Truth of linear kinematics, whatever the load: the Kirchhoff plate, at time INFINITY its
 * rest. STATUS_UNSUPPORTED with a sentence: the scene is no undamped cantilever. */
enum status truth_of_plate(const char *path, const struct settings *settings, int times,
                           const double *time, struct truth **truth, struct message *why);

/* Reads what is known of a scene as its truth moves: a closed form, or what is stored under
 * its name. STATUS_FILE: none is stored; STATUS_UNSUPPORTED: it can have none
 * (truth_plan_check), or what is stored is of other physics; STATUS_INPUT: it was changed;
 * with a sentence each. Free with truth_made_clear. */
enum status truth_known(const struct scene *scene, struct truth_made *made,
                        struct message *why);

/* The same at the times at which tables judge (truth_made_thin); `made->times` is 0 where
 * nothing is known. */
enum status truth_judged(const struct scene *scene, struct truth_made *made,
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
