/* truth_made.h - a truth as it was made or read: fields and error bars at times, and until
 * when it is claimed. */
#ifndef TRUTH_MADE_H
#define TRUTH_MADE_H

#include "bench/truth/truth_level.h"

/* What is known at each time: name, unit. Orders are NaN where differences do not shrink.
 */
#define TRUTH_COLUMN_LIST(X)                                                               \
    X(SOLID_SPACE, "solid_space_order", "1")                                               \
    X(SOLID_TIME, "solid_time_order", "1")                                                 \
    X(SOLID_BAR, "solid_bar", "m")                                                         \
    X(SHELL_SPACE, "shell_space_order", "1")                                               \
    X(SHELL_TIME, "shell_time_order", "1")                                                 \
    X(SHELL_BAR, "shell_bar", "m")                                                         \
    X(DIFFERENCE, "difference", "m")                                                       \
    X(GROWTH, "growth", "1") /* of the change of gravity: rms / (1e-6 L) */                \
    X(ERROR, "error", "m")   /* the error bar   */

enum truth_column {
#define TRUTH_COLUMN_CODE(code, name, unit) TRUTH_##code,
    TRUTH_COLUMN_LIST(TRUTH_COLUMN_CODE)
#undef TRUTH_COLUMN_CODE
        TRUTH_STORED,
    /* Not of its file, but of that beside it (truth_third.h), NaN where there is none: */
    TRUTH_THIRD = TRUTH_STORED, /* how far it is [m]                                    */
    TRUTH_THIRD_BAR,            /* its own error bar [m]                                */
    TRUTH_COLUMNS
};

enum { TRUTH_WATCH_TEXT = 256 };

/* Where TRUTH_PERTURBATION has grown so many times (rms over the length), a net's own 1e-3
 * has grown to the size of the sheet: nothing can be claimed. */
#define TRUTH_MOST_GROWTH 1e3

/* Nothing is claimed from the first time on at which this or TRUTH_MOST_GROWTH is passed: a
 * truth that leaves 5 % of the length open tells few models apart. */
#define TRUTH_MOST_ERROR 0.05 /* error bar / L                                         */

struct truth_made {
    int times, claimed;             /* times before the horizon                          */
    double **xyz;                   /* [times] (grid.h) [m]; owns the other arrays, too  */
    double *time;                   /* [times] [s]                                       */
    double (*value)[TRUTH_COLUMNS]; /* [times]                                           */
    struct truth_level level;       /* whose field it is, at most of the claimed times   */
    bool closed;                    /* nobody's: a closed form (truth_closed.h)          */
    bool foreign;                   /* somebody else's (truth_third.h)                   */
    char note[512];                 /* a sentence: source and error bar                  */
    char horizon[TRUTH_WATCH_TEXT]; /* until when it is predictable: gravity is
 changed a little, and the change watched as long as the scene lasts */
    char commit[64], changed[16];   /* of one that is stored: the program's that made it,
   and how many files differed from it; "unknown" */
    char third[640]; /* on the third mechanics, a sentence; "": none is stored           */
};

/* Arrays of zeros for these times, fields for the first `claimed` of them, else NULL. */
enum status truth_made_init(struct truth_made *made, int times, int claimed,
                            const double *time);
void truth_made_clear(struct truth_made *made); /* all-zero is allowed, and left */

/* Leaves of a stored truth the times at which tables judge (truth_plan_judges): one with
 * many frames and one with few are judged alike. Where none is, the last that is claimed
 * stays. */
void truth_made_thin(struct truth_made *made, const struct scene *scene);

#endif
