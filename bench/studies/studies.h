/* studies.h - the commands `table` and `study`. */
#ifndef STUDIES_H
#define STUDIES_H

#include "bench/ui/command.h"
#include "bench/ui/table.h"

enum { STUDIES_SCENES = 8 }; /* most that study ensemble takes */

/* --- Ensembles (study_ensemble.c): beyond the horizon, where a change of 1e-6 has grown a
 * thousandfold, points cannot be compared, but distributions can (doc/truths.md). Of a
 * scene that begins with random waves, each run has a seed of its own instead. */

struct study_ensemble_options {
    const char *folder; /* of the result files; exists                                  */
    bool quick;         /* fewer runs on coarser nets                                   */
    int scene_count;    /* 0: the usual ones                                            */
    const char *const *scene; /* [scene_count] names or paths of scene files            */
    const char *models;       /* "a,b", names of contestants; NULL: the usual ones      */
    int runs;                 /* of a scene and a model; 0: as many as usual            */
    double until;             /* [s]; 0: to the scene's end                             */
};

/* Runs all ensembles, each run in a process of its own, on all processors. STATUS_INPUT,
 * STATUS_FILE, STATUS_MEMORY with a sentence; deaths of runs are results. */
enum status study_ensemble_measure(const struct study_ensemble_options *options,
                                   struct message *why);

/* Prints what study_ensemble_measure left in a folder. */
enum status study_ensemble_print(const char *folder, enum table_format format, FILE *file,
                                 struct message *why);

/* The first two ensembles are the truth's, contestants follow. */
enum { STUDY_ENSEMBLE_TRUTHS = 2, STUDY_ENSEMBLE_MOST = STUDY_ENSEMBLE_TRUTHS + 16 };
enum { STUDY_ENSEMBLE_NUMBERS = 11, STUDY_ENSEMBLE_FIELDS = 12 };

struct study_ensemble {
    char scene[64];
    bool quick, ripples; /* runs differ by the seed of the scene's waves, else gravity */
    int runs, looks, fields, count;           /* count of ensembles                     */
    double *time;                             /* [looks] [s]                      owned */
    double field_time[STUDY_ENSEMBLE_FIELDS]; /* of points, up to the end [s]           */
    struct study_ensemble_one {
        char title[96], net[24];
        int lived, died; /* runs that came to the end, and others, of which the first:  */
        struct message sentence;
        double growth[STUDY_ENSEMBLE_FIELDS]; /* rms spread of points / (1e-6 L)        */
        double points[STUDY_ENSEMBLE_FIELDS]; /* mean positions off the truth's / L     */
        double *value;                        /* [NUMBERS][looks][runs]           owned */
    } one[STUDY_ENSEMBLE_MOST];
};

/* Judges the contestants and prints table and sentences, as data also their growth. */
enum status study_ensemble_tell(const struct study_ensemble *e, const char *folder,
                                enum table_format format, FILE *file, struct message *why);

/* --- What runs say of a number, and whether two ensembles say the same (distribution.c).
 * Runs are independent, and nothing but means of them is taken to be normal. */

enum { DISTRIBUTION_RUNS = 256 };

/* Returns the mean of value[n]; *error becomes its standard error, sd / sqrt(n). NaN of too
 * few. */
double distribution_mean(int n, const double *value, double *error);

/* Returns how far the means of a[n] and b[m] are apart in standard errors, (mean a - mean
 * b) / sqrt(se^2 + se^2 + bar^2) (Welch 1938); b's mean may be off by `bar` besides. Equal
 * means are 0 apart, others without any error infinitely. */
double distribution_apart(int n, const double *a, int m, const double *b, double bar);

/* Fills deviation[n] with |value - median|: their means tell spreads apart, whatever the
 * shape of the distribution (Brown, Forsythe 1974). n <= DISTRIBUTION_RUNS. */
void distribution_deviations(int n, const double *value, double *deviation);

/* Returns how far apart means of n runs each may be in standard errors before they are not
 * of one distribution: none of so many comparisons passes it by chance in all but 5 of 100
 * cases (Bonferroni; Student's t of n - 1 degrees of freedom, the fewest that Welch's may
 * have). INFINITY for fewer than two runs. */
double distribution_bound(int comparisons, int n);

#endif
