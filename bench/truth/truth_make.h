/* truth_make.h - a scene's truth made: the nonlinear solid and the nonlinear shell, each on
 * three nets and three steps, against each other, and one of them pushed a little.
 *
 * The two share the B-spline basis and the Newton solver, nothing of their mechanics. The
 * field kept is that of the model with the smaller bar of its own; the error bar is the
 * largest of the two own bars and of the difference of the two models.
 */
#ifndef TRUTH_MAKE_H
#define TRUTH_MAKE_H

#include "bench/truth/truth_level.h"
#include "bench/truth/truth_plan.h"

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
    struct truth_level level;       /* whose field it is                                 */
    bool closed;                    /* nobody's: a closed form (truth_closed.h)          */
    char note[400];                 /* a sentence: source and error bar                  */
    char horizon[TRUTH_WATCH_TEXT]; /* until when it is predictable: gravity is
 changed a little, and the change watched as long as the scene lasts */
    char commit[64], changed[16];   /* of one that is stored: the program's that made it,
   and how many files differed from it; "unknown" */
};

/* Runs what is not in the folder yet; `quiet`: no progress bar. STATUS_DIVERGED: a run
 * died; STATUS_UNSUPPORTED: a model cannot serve the scene. Free with truth_made_clear. */
enum status truth_make(const struct truth_plan *plan, const struct truth_runs *runs,
                       const struct scene *scene, bool quiet, struct truth_made *made,
                       struct message *why);

/* Arrays of zeros for these times, fields for the first `claimed` of them, else NULL. */
enum status truth_made_init(struct truth_made *made, int times, int claimed,
                            const double *time);
void truth_made_clear(struct truth_made *made); /* all-zero is allowed, and left */

/* The order at which three runs approach a limit, and how far the finest may still be from
 * it (Roache, J. Fluids Eng. 116, 1994; Celik et al., same, 130, 2008). */
struct truth_order {
    double order; /* observed [1]; NaN: the differences do not shrink                  */
    double bar;   /* of the finest run, in the unit of the differences                 */
};

/* From sizes h[0] > h[1] > h[2] > 0, the differences first = |x0 - x1| and second = |x1 -
 * x2|, both >= 0, and the order that theory promises. The bar is the difference that the
 * order leaves, times the usual factor of safety: 1.25. An order above the promised one is
 * not believed; one below 0.5, or none, counts as 0.5 with a factor of 3. Two equal runs:
 * 0. */
struct truth_order truth_order(const double h[3], double first, double second,
                               double promised);

/* Times before one of the bounds is passed. */
int truth_made_claimed(int times, double (*value)[TRUTH_COLUMNS], double length);

/* Whose field is the truth: the model's that can claim more times; of two that can claim
 * the same, the one's with the smaller bar at the last of them. Fills the error bars that
 * follow, and `claimed`. */
enum truth_model truth_made_choose(struct truth_made *made, double length);

#endif
