/* study.h - a scene at several levels of one parameter (net, degree, step, thickness ...),
 * from coarse to fine: run and timed together, kept as one result file a level, and read
 * back as numbers. `clothbench study NAME` prints one or more of these; an experiment is
 * written so:
 *
 *     static const struct study printed = {.name = "printed", .scene = "edge_drop", ...};
 *     measure:  TRY(study_measure(&printed, options, why));
 *     print:    TRY(study_print_all(&printed, folder, format, file, &result, why));
 *               study_print_verdict(file, "more points, more wrinkles", holds, "...", ...);
 *               study_result_clear(&result);
 */
#ifndef STUDY_H
#define STUDY_H

#include "bench/experiment/experiment.h"
#include "bench/truth/paper.h"
#include "bench/truth/truth.h"

enum { STUDY_SETTINGS = 12, STUDY_LEVELS = 10, STUDY_TIMES = 8 };

struct study_level {
    const char *label;                    /* short, for tables and pictures: "10x10x2"   */
    const char *name;                     /* of its file, [a-z0-9_]+                     */
    const char *model;                    /* NULL: iga                                   */
    const char *settings[STUDY_SETTINGS]; /* KEY=VALUE on top of the study's; NULL ends  */
    double size; /* mesh width, step, ...: observed orders are over it; 0: no such thing */
    const struct paper_cost *paper; /* what the paper says that it costs; NULL: nothing  */
};

struct study {
    const char *name;    /* of its files, [a-z0-9_]+; unlike that of others in the folder */
    const char *caption; /* of its tables                                                */
    const char *scene;   /* name or path                                                 */
    const char *settings[STUDY_SETTINGS]; /* the physics: of all levels and the truth; NULL
                                             ends                                        */
    const char *numerics[STUDY_SETTINGS]; /* of all levels; NULL ends                    */
    int count;                            /* 1..STUDY_LEVELS                             */
    const struct study_level *levels;     /* [count], coarse to fine                     */
    int times;          /* 1..STUDY_TIMES; 0: static equilibrium as frame 0, not timed,
                           for whoever prints it: study_print tells motions              */
    const double *time; /* [times], multiples of every level's step, increasing     [s]  */
    bool truth;         /* hold it against truth.h's: for undamped physics, early times  */
};

/* A level at a time. NaN: there is no such number. */
struct study_frame {
    double *xyz;         /* field (grid.h) [m]; NULL after a death               owned   */
    double next, finest; /* RMSE / L to the next level and to the finest that lives [1]  */
    double error;        /* RMSE / L to truth [1]                                        */
    double roughness, inner, stretch, drop, unevenness; /* metric.h; inner: roughness    */
};

struct study_row {
    char refused[256]; /* the model's sentence; then nothing else is there               */
    char outcome[256]; /* "done" or the sentence of a death                              */
    double unknowns, factor_entries;
    double milliseconds; /* a frame: median over repeats (timed.h); NaN: not timed       */
    double seconds;      /* of stepping to the last time, from these                     */
    struct study_frame frame[STUDY_TIMES];
};

struct study_result {
    double gamma, length; /* of the study's scene: [1], [m]                              */
    struct truth *truth;  /* owned, or NULL                                              */
    struct study_frame true_frame[STUDY_TIMES]; /* the truth's own; xyz is NULL          */
    struct study_row row[STUDY_LEVELS];
};

/* Runs and times all levels, and the truth. Deaths and refusals are results. */
enum status study_measure(const struct study *study,
                          const struct experiment_options *options, struct message *why);

/* Numbers from what study_measure left in `folder`; *r is overwritten. */
enum status study_read(const struct study *study, const char *folder,
                       struct study_result *r, struct message *why);
void study_result_clear(struct study_result *r);

/* Observed order in level.size of the error against truth at a time; without a truth, of
 * the difference from the finest. NaN with fewer than three levels. */
double study_order(const struct study *study, const struct study_result *r, int time);

#endif
