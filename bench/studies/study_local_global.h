/* study_local_global.h - what is wrong with a motion of projective dynamics, told apart:
 * what its iterations leave, what its step does, and what its net does; plain iterations,
 * Chebyshev's and ADMM's, implicit Euler and BDF2.
 */
#ifndef STUDY_LOCAL_GLOBAL_H
#define STUDY_LOCAL_GLOBAL_H

#include "bench/experiment/experiment.h"

enum study_local_global_scheme { STUDY_LOCAL_GLOBAL_EULER, STUDY_LOCAL_GLOBAL_BDF2 };
enum study_local_global_method {
    STUDY_LOCAL_GLOBAL_PLAIN,
    STUDY_LOCAL_GLOBAL_CHEBYSHEV,
    STUDY_LOCAL_GLOBAL_ADMM
};
enum {
    STUDY_LOCAL_GLOBAL_SCENES = 2,
    STUDY_LOCAL_GLOBAL_SCHEMES = 2,
    STUDY_LOCAL_GLOBAL_STEPS = 2,
    STUDY_LOCAL_GLOBAL_METHODS = 3,
    STUDY_LOCAL_GLOBAL_COUNTS = 5
};

/* What is judged, of one scheme and step; rms over the length; NaN: not run, or died. */
struct study_local_global_motion {
    double left[STUDY_LOCAL_GLOBAL_METHODS]
               [STUDY_LOCAL_GLOBAL_COUNTS]; /* from the motion iterated to its end      */
    double frame[STUDY_LOCAL_GLOBAL_METHODS][STUDY_LOCAL_GLOBAL_COUNTS]; /* [s], median */
    double step; /* of that from one in small steps of second order, on the same net    */
};

struct study_local_global {
    struct study_local_global_motion motion[STUDY_LOCAL_GLOBAL_SCENES]
                                           [STUDY_LOCAL_GLOBAL_SCHEMES]
                                           [STUDY_LOCAL_GLOBAL_STEPS];
    double net[STUDY_LOCAL_GLOBAL_SCENES]; /* of the one in small steps from the truth  */
    double bar[STUDY_LOCAL_GLOBAL_SCENES]; /* the truth's                               */
};

/* Table and sentences; local_global.csv into the folder. */
enum status study_local_global_tell(const struct study_local_global *s, bool quick,
                                    const char *folder, enum table_format format,
                                    FILE *file, struct message *why);

extern const struct experiment study_local_global_experiment;

#endif
