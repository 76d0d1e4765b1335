/* study_ensemble.h - beyond the horizon: where a change of 1e-6 has grown a thousandfold,
 * points cannot be compared, but distributions can.
 *
 * Of each scene an ensemble of runs, the n-th with gravity pushed in direction n
 * (truth_level.h), by the cured shell on two nets, the truth, and by each contestant. Of
 * numbers of the sheet (STUDY_ENSEMBLE_LIST), averaged over windows of time beyond the
 * horizon, means and spreads are compared in standard errors (distribution.h). A run is a
 * file; what is there already of the same program is not run again.
 */
#ifndef STUDY_ENSEMBLE_H
#define STUDY_ENSEMBLE_H

#include "bench/experiment/experiment.h"
#include "bench/experiment/judge.h"
#include "bench/harness/contestant.h"
#include "bench/harness/run.h"
#include "bench/studies/studies.h"

/* Numbers that are compared: name, unit, words; behind WAVES the bands of waves.h. */
#define STUDY_ENSEMBLE_LIST(X)                                                             \
    X(DROP, "mean_drop", "1", "drop")                                                      \
    X(ANGLE, "angle", "degrees", "angle")                                                  \
    X(STRETCH, "stretch", "1", "stretch")                                                  \
    X(ROUGHNESS, "roughness", "1", "roughness")                                            \
    X(KINETIC, "kinetic", "J", "kinetic energy")                                           \
    X(WAVES, "waves_long", "1", "waves > L")                                               \
    X(WAVES_2, "waves_half", "1", "waves > L/2")                                           \
    X(WAVES_4, "waves_quarter", "1", "waves > L/4")                                        \
    X(WAVES_8, "waves_eighth", "1", "waves > L/8")

enum study_ensemble_number {
#define STUDY_ENSEMBLE_CODE(code, name, unit, words) STUDY_ENSEMBLE_##code,
    STUDY_ENSEMBLE_LIST(STUDY_ENSEMBLE_CODE)
#undef STUDY_ENSEMBLE_CODE
        STUDY_ENSEMBLE_NUMBERS
};
extern const char *const study_ensemble_name[STUDY_ENSEMBLE_NUMBERS],
    *const study_ensemble_unit[STUDY_ENSEMBLE_NUMBERS],
        *const study_ensemble_words[STUDY_ENSEMBLE_NUMBERS];

enum {
    STUDY_ENSEMBLE_MODELS = 16,
    STUDY_ENSEMBLE_FIELDS = 12, /* times at which points are kept                       */
    STUDY_ENSEMBLE_WINDOWS = 3, /* of time, beyond the horizon                          */
};

/* Of each scene: the truth on its coarser and its finer net, then the contestants. */
enum { STUDY_ENSEMBLE_COARSE, STUDY_ENSEMBLE_FINE, STUDY_ENSEMBLE_TRUTHS };

/* What is run (study_ensemble_job.c). FOLDER/ensemble.txt has it. */
struct study_ensemble_job {
    const char *folder; /*                                                     borrowed */
    bool quick;
    int runs; /* of each at most                                                       */
    int scenes, models;
    struct {
        char path[512], name[64];
        double until; /* a multiple of 20 ms [s]                                        */
        int runs;     /* of each here                                                   */
    } scene[STUDIES_SCENES];
    const struct contestant *model[STUDY_ENSEMBLE_MODELS];
};

/* Fills it in from what the user chose, or from the folder. STATUS_INPUT with a sentence:
 * no such scene or contestant, one twice, no gravity, too short; STATUS_FILE. */
enum status study_ensemble_choose(const struct experiment_options *options,
                                  struct study_ensemble_job *job, struct message *why);
enum status study_ensemble_find(const char *folder, struct study_ensemble_job *job,
                                struct message *why);
enum status study_ensemble_keep(const struct study_ensemble_job *job, struct message *why);

/* Runs what is not in the folder (study_ensemble.c), `slots` at a time, and leaves
 * ensemble.txt. *ran, if not NULL: how many it had to. A signal that asks to stop ends the
 * program after a sentence. */
enum status study_ensemble_run(const struct study_ensemble_job *job, int slots, long *ran,
                               struct message *why);

/* A few runs of each first: a scene whose change has then grown a thousandfold on none of
 * the truth's nets has nothing to judge, and no more. Else all; job->scene[].runs says. */
enum status study_ensemble_run_all(struct study_ensemble_job *job, int slots,
                                   struct message *why);

enum { STUDY_ENSEMBLE_PATH = 4096 };

/* FOLDER/SCENE_ENSEMBLE_MEMBER.h5. */
void study_ensemble_file(const struct study_ensemble_job *job, int scene, int ensemble,
                         int member, char path[STUDY_ENSEMBLE_PATH]);

/* Who an ensemble is: its contestant, its net and its other settings. */
enum status study_ensemble_settings(const struct study_ensemble_job *job, int scene,
                                    int ensemble, int member,
                                    const struct contestant **contestant,
                                    struct settings *settings, struct message *why);

/* An ensemble as it was read. */
struct study_ensemble_one {
    char title[96], net[24];
    int lived, died;         /* runs to the end; others, the first of which         */
    struct message sentence; /* says so                                             */
    double growth[STUDY_ENSEMBLE_FIELDS]; /* rms spread of points / (1e-6 L)           */
    double points[STUDY_ENSEMBLE_FIELDS]; /* mean positions off the truth's, rms / L   */
    double *value; /* [NUMBERS][looks][lived]; NaN: unknown        owned  */
};

struct study_ensemble {
    char name[64]; /* of the scene                                                     */
    bool quick;
    int runs, looks, fields, count; /* ensembles                                       */
    double *time;                   /* [looks] [s]                              owned  */
    double field_time[STUDY_ENSEMBLE_FIELDS]; /* [fields] [s]                          */
    struct study_ensemble_one one[STUDY_ENSEMBLE_TRUTHS + STUDY_ENSEMBLE_MODELS];
};

/* Reads a scene's runs (study_ensemble_read.c). STATUS_FILE, STATUS_INPUT, STATUS_MEMORY
 * with a sentence. */
enum status study_ensemble_read(const struct study_ensemble_job *job, int scene,
                                struct study_ensemble *e, struct message *why);
void study_ensemble_clear(struct study_ensemble *e); /* all-zero is allowed */

double *study_ensemble_values(const struct study_ensemble *e,
                              const struct study_ensemble_one *one, int number, int look);

/* --- What follows from it (study_ensemble_judge.c). */

/* A contestant against the truth, of one number in one window. */
struct study_ensemble_apart {
    double mean, spread; /* in standard errors, what the truth's nets differ by included */
    double net_mean, net_spread; /* the truth's nets from each other                   */
    enum judge known;            /* the truth's nets agree within the bound            */
    enum judge turn; /* right in distribution; open: as far as it is known             */
};

struct study_ensemble_verdict {
    int horizon;  /* index of field_time from which on it is judged; -1: there is none  */
    bool doubted; /* the change has grown a thousandfold on one of the nets alone       */
    int windows;
    double begin, end; /* of them [s]                                                  */
    double bound;      /* standard errors                                              */
    struct study_ensemble_apart
        apart[STUDY_ENSEMBLE_TRUTHS + STUDY_ENSEMBLE_MODELS][STUDY_ENSEMBLE_NUMBERS]
             [STUDY_ENSEMBLE_WINDOWS]; /* of the truths themselves: unused             */
    enum judge turn[STUDY_ENSEMBLE_TRUTHS + STUDY_ENSEMBLE_MODELS];
};

/* Index of the first field_time at which a change has grown a thousandfold; -1: none. */
int study_ensemble_horizon(const struct study_ensemble *e, int ensemble);

/* All of it. A look belongs to the window that its time falls into. */
void study_ensemble_judge(const struct study_ensemble *e, struct study_ensemble_verdict *v);

/* Means of a number over a window, one a run, into mean[lived]; their count. */
int study_ensemble_window(const struct study_ensemble *e,
                          const struct study_ensemble_verdict *v, int ensemble, int number,
                          int window, double *mean);

/* The worst of a contestant's windows, signed; NaN: none was judged. `number` to before
 * `end`; of spreads or of means. */
double study_ensemble_worst(const struct study_ensemble_verdict *v, int ensemble,
                            int number, int end, bool spread);

/* SCENE.png and so on (study_ensemble_chart.c): growth, and means with their bands. */
enum status study_ensemble_chart(const struct study_ensemble *e, const char *folder,
                                 struct message *why);

/* Tables and sentences of a scene, with its chart (study_ensemble_print.c). */
enum status study_ensemble_tell(const struct study_ensemble *e, const char *folder,
                                enum table_format format, FILE *file, struct message *why);

#endif
