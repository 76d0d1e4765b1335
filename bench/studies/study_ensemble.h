/* study_ensemble.h - beyond the horizon: where a change of 1e-6 has grown a thousandfold,
 * points cannot be compared, but distributions can (doc/truths.md). */
#ifndef STUDY_ENSEMBLE_H
#define STUDY_ENSEMBLE_H

#include "bench/ui/table.h"

/* The first two ensembles are the truth's, contestants follow. */
enum { STUDY_ENSEMBLE_TRUTHS = 2, STUDY_ENSEMBLE_MOST = STUDY_ENSEMBLE_TRUTHS + 16 };
enum { STUDY_ENSEMBLE_NUMBERS = 9, STUDY_ENSEMBLE_FIELDS = 12 };

struct study_ensemble {
    char scene[64];
    bool quick;
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

/* Judges the contestants and prints tables, sentences and a chart. */
enum status study_ensemble_tell(const struct study_ensemble *e, const char *folder,
                                enum table_format format, FILE *file, struct message *why);

#endif
