/* rung.h - one run kept at given times: the unit of `compare`.
 *
 * A run is a result file FOLDER/NAME.h5 (store.h). Running and reading are apart, so that
 * tables and plots are made again without running.
 */
#ifndef RUNG_H
#define RUNG_H

#include "models/model.h"

struct rung_plan {
    const char *path; /* scene file                                                    */
    int setting_count;
    const char *const *settings; /* the last ones win                                  */
    const char *model;
    int times;
    const double *time; /* multiples of the scene's step [s], increasing                */
    const char *folder, *name;
};

struct rung_result {
    int frames;              /* kept; fewer than the plan's times after a death       */
    double **xyz;            /* [frames] (grid.h) [m]                         owned   */
    double create, stepping; /* [s]                                                   */
    double unknowns;
    long steps;
    char *outcome; /* "done" or the sentence of a death             owned   */
};

/* Runs and leaves the file. STATUS_UNSUPPORTED: the model leaves out what the scene needs;
 * no file then. Deaths are results. */
enum status rung_run(const struct rung_plan *plan, struct message *why);

/* Reads the file of a plan. STATUS_FILE if there is none. */
enum status rung_read(const struct rung_plan *plan, struct rung_result *r,
                      struct message *why);
void rung_clear(struct rung_result *r);

#endif
