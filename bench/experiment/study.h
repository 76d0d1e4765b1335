/* study.h - measures the studies of a plan (plan.h) together, keeps a result file of each
 * level, FOLDER/STUDY_LEVEL.h5, in a sweep FOLDER/case_000001.h5, and reads the files as
 * numbers. A sweep is a plan without times: whatever comes of its cases is a row.
 */
#ifndef STUDY_H
#define STUDY_H

#include "bench/experiment/measurement.h"
#include "bench/experiment/plan.h"
#include "bench/harness/run_result.h"
#include "bench/truth/truth.h"

/* --- Quantities (quantity.c): every number that can be read off the levels of a study is
 * defined once: a plan names it as a column, claims ask for it, CSV and JSON have it under
 * its name. A new quantity is one function and one row. */

struct place;

/* Code, function, and the members of struct quantity_row. */
/* clang-format off */
#define QUANTITY_LIST(X) \
    X(SIZE, size, "size", "size", NULL, 3, false,                                          \
      "what the plan calls the size of a level: a mesh width, a step [s], ...")            \
    X(CONTROL_POINTS, control_points, "control_points", "points", NULL, 0, false,          \
      "points of the net")                                                                 \
    X(UNKNOWNS, unknowns, "unknowns", "unknowns", NULL, 0, false,                          \
      "components of points that are not held")                                            \
    X(FACTOR_ENTRIES, factor_entries, "factor_entries", "factor", NULL, 0, false,          \
      "numbers stored in the factor")                                                      \
    X(CREATE, create, "create_ms", "set-up", "ms", 3, false,                               \
      "building the model, median over repeats")                                           \
    X(FRAME, frame, "frame_ms", "a frame", "ms", 3, false,                                 \
      "a time step, or the equilibrium: processor time on one thread, the least of the "    \
      "repeats")                                                                           \
    X(FRAME_LOWER, frame_lower, "frame_lower_ms", "", "ms", 3, false,                      \
      "lower quartile of a frame's milliseconds")                                          \
    X(FRAME_UPPER, frame_upper, "frame_upper_ms", "", "ms", 3, false,                      \
      "upper quartile of them")                                                            \
    X(OF_REFERENCE, of_reference, "of_reference", "of reference", NULL, 3, false,          \
      "a frame's milliseconds over those of the reference")                                \
    X(PROCESSOR, processor, "processor", "", NULL, 3, false,                               \
      "share of the timing in which the program had a processor")                          \
    X(ASSEMBLE, assemble, "assemble_ms", "K and M", "ms", 3, false,                        \
      "assembly of K and M alone")                                                         \
    X(FACTOR, factor, "factor_ms", "factor", "ms", 3, false, "one factorisation alone")    \
    X(SOLVE, solve, "solve_ms", "solve", "ms", 3, false,                                   \
      "one solution with the factor alone")                                                \
    X(PAPER, paper, "paper_ms", "paper", "ms", 0, false,                                   \
      "what the paper prints for a frame")                                                 \
    X(PAPER_OF_REFERENCE, paper_of_reference, "paper_of_reference", "paper's", NULL, 3, false, \
      "the paper's milliseconds over its own for the reference")                           \
    X(SECONDS, seconds, "stepping_s", "stepping", "s", 3, false,                           \
      "all frames to the last time")                                                       \
    X(FACTORISATIONS, factorisations, "factorisations", "factors", "a frame", 3, false,    \
      "factorisations, mean over the frames")                                              \
    X(SOLVES, solves, "solves", "solves", "a frame", 3, false,                             \
      "products with the factor or the preconditioner, mean over the frames")              \
    X(ITERATIONS, iterations, "iterations", "iterations", "a frame", 3, false,             \
      "iterations of the step, mean over the frames")                                      \
    X(TESTED, tested, "tested", "tested", "a frame", 3, false,                             \
      "samples held against a body by printed and incremental kinematics, mean over the "   \
      "frames")                                                                            \
    X(LEFT, left, "left", "left", NULL, 2, false,                                          \
      "most that iterations leave of a step: vbd of the loads, projective_dynamics of "    \
      "the step's movement, position_based as strain")                                     \
    X(LOSS, loss, "loss", "loss", "1/s", 2, false,                                         \
      "share of the energy in play that is lost a second")                                 \
    X(STIFFNESS, stiffness, "stiffness", "stiffness", NULL, 3, false,                      \
      "of a strip that hangs: E by the most it was longer, rho g L / 2 E, over the scene's") \
    X(APART, apart, "apart", "apart", "L", 2, true,                                        \
      "rms distance to the reference on the material grid, over the length")               \
    X(TIP, tip, "tip", "tip", NULL, 4, false,                                              \
      "how far the middle of a cantilever's free edge drops, over Kirchhoff's plate "      \
      "or, not linear, over a strip, the elastica")                                        \
    X(TIP_OF_REFERENCE, tip_of_reference, "tip_of_reference", "over reference", NULL, 4, false, \
      "tip over that of the reference; without one, tip")                                  \
    X(DEPTH, depth, "depth", "depth", "m", 4, true,                                        \
      "how far the middle of the edge u = 1 is below z = 0")                               \
    X(SPEED, speed, "speed", "speed", "m/s", 4, true,                                      \
      "mean speed at which it sinks, since the time before")                               \
    X(SWING, swing, "swing", "swing", "degrees", 3, true,                                  \
      "largest turn, at any of the times so far, of the line between the middles of "      \
      "the edges u = 0 and 1 out of its angle at rest")                                    \
    X(EDGE_MOVED, edge_moved, "edge_moved", "edge moved", "m", 3, true,                    \
      "rms displacement of the edge u = 1")                                                \
    X(DEATH, death, "death_s", "death", "s", 3, false, "when the run died")                \
    X(APART_MOST, apart_most, "apart_most", "most apart", "L", 2, false,                   \
      "the largest of these distances over all times")                                     \
    X(NEXT, next, "to_next", "to next", "L", 3, true, "rms distance to the next level")    \
    X(FINEST, finest, "to_finest", "to finest", "L", 3, true,                              \
      "rms distance to the last level")                                                    \
    X(ERROR, error, "error", "error", "L", 3, true, "rms distance to the scene's truth")   \
    X(OFF, off, "off", "off", NULL, 3, true,                                               \
      "rms distance to the truth over the rms way that the truth has moved")               \
    X(BAR, bar, "error_bar", "error bar", "L", 2, true, "error bar of the truth")          \
    X(ROUGHNESS, roughness, "roughness", "roughness", NULL, 3, true,                       \
      "length times the rms curvature")                                                    \
    X(INNER, inner, "inner_roughness", "inner", NULL, 3, true,                             \
      "the same away from the edges")                                                      \
    X(STRETCH, stretch, "stretch", "stretch", NULL, 4, true, "largest principal stretch")  \
    X(DROP, drop, "drop", "drop", "L", 4, true, "lowest point below the support")          \
    X(UNEVENNESS, unevenness, "unevenness", "unevenness", NULL, 3, true,                   \
      "rms change of the curvature over it, per length")                                   \
    X(ANGLE, angle, "angle_degrees", "angle", "degrees", 3, true,                          \
      "angle of the middle line below level")                                              \
    X(PENETRATION, penetration, "penetration", "depth in body", "m", 3, true,              \
      "how deep a body is in the sheet, as far as its faces")                              \
    X(CROSSINGS, crossings, "crossings", "crossings", "pairs", 0, true,                    \
      "pairs of the mid-surface's triangles that cross")                                   \
    X(DRAPE, drape, "drape", "drape", NULL, 3, true,                                       \
      "drape coefficient of a disc (ISO 9073-9)")                                          \
    X(FOLDS, folds, "folds", "folds", NULL, 0, true, "folds of its shadow")
/* clang-format on */

enum quantity {
#define QUANTITY_ROW(code, ...) QUANTITY_##code,
    QUANTITY_LIST(QUANTITY_ROW)
#undef QUANTITY_ROW
#define QUANTITY_CODE(code, name, unit, sentence) QUANTITY_##code,
        MEASURE_LIST(QUANTITY_CODE) /* measures.h: over all looks of a run */
#undef QUANTITY_CODE
    QUANTITIES
};

struct quantity_row {
    const char *name; /* "frame_ms": in plans, CSV and JSON                            */
    const char *head; /* "a frame": column head in a table; "": for machines alone      */
    const char *unit; /* "ms", "L", "1"; NULL for a pure number                        */
    int digits;       /* significant ones that a table shows; 0: a whole number        */
    bool moves;       /* it is another one at each time                                 */
    double (*at)(const struct place *p); /* computes it, in the unit; NaN: there is none */
    const char *help; /* words that say what it measures                                */
};

extern const struct quantity_row quantity_table[QUANTITIES];

/* Finds a quantity by its name; -1: there is none. */
int quantity_find(const char *name);

/* Returns the value of a quantity at a place, in its unit, which is computed when it is
 * first asked for; NaN: there is none. */
double quantity_at(const struct place *p, enum quantity q);

/* --- Results. */

struct study_row {
    const struct plan_level *level; /*                                        borrowed  */
    bool left_out;    /* by a quick run, or lost: there is nothing else                   */
    const char *lost; /* why a sweep has no result of it; NULL: it has                  */
    bool again;       /* lost, but the next sweep runs it                               */
    struct run_result result; /* with its fields; of the truth its scene alone   owned  */
    double
        theory; /* drop of a cantilever's tip at rest over L (truth_plate_drop), or NaN */
    const double *xyz[PLAN_STUDY_TIMES]; /* sheet (grid.h) [m]; NULL after a death      */
    double value[PLAN_STUDY_TIMES][QUANTITIES]; /* as far as known (quantity_at)        */
    bool known[PLAN_STUDY_TIMES][QUANTITIES];
};

struct study {
    const struct plan_study *plan; /*                                         borrowed  */
    int frames;              /* kept of a level that lives: its times, or 1: at rest */
    const double *time;      /* [frames] [s]; NULL: at rest             borrowed  */
    double gamma, length;    /* of its scene: [1], [m]                            */
    struct truth *truth;     /* owned; NULL: none was asked for, or there is none */
    struct message no_truth; /* why not                                           */
    struct study_row *row;   /* [plan->level_count]; one more for the truth, whose
                                label is "truth" and which has sheets alone      owned */
};

/* A label on an axis (results.h). */
struct where {
    const char *axis, *label; /* "!LABEL": any other; "WORD*": any that begins so      */
};
#define WHERE(...) ((const struct where[]){__VA_ARGS__, {NULL, NULL}})

struct study_results {
    const struct plan *plan; /*                                               borrowed  */
    /* Labels that results.h looks for wherever an axis of theirs is not named; NULL: none,
       borrowed. They say how a statement is read that leaves a choice open. */
    const struct where *reading;
    int count;
    struct study *study; /* [count]                                                     */
    bool quick;          /* some of it is of less than the plan says                    */
    struct arena arena;  /* of studies, rows and why cases are lost              owned  */
    char machine[4096];  /* a file whose provenance holds for all                       */
};

/* A level of a study at one of the study's times, both from 0. */
struct place {
    const struct study_results *d;
    const struct study *s;
    int level, time;
};

/* Runs and times all levels of all studies, interleaved, and their truths. Deaths and
 * refusals are results; in a sweep, whose cases are run once each, so is all that may come
 * of a case. The folder is locked meanwhile. */
enum status study_measure(const struct plan *plan, const char *folder,
                          const struct measurement_options *options, struct message *why);

/* Reads the numbers from the files that study_measure left in `folder`. *r is overwritten;
 * free it with study_clear, which accepts all-zero. */
enum status study_read(const struct plan *plan, const char *folder, struct study_results *r,
                       struct message *why);
void study_clear(struct study_results *r);

/* Returns the level that the plan has this one compared with; -1: there is none. */
int study_reference(const struct study_results *r, const struct study *s, int level);

/* Returns the rms distance of two levels at the first one's time over its length; NaN: one
 * did not live to see it. */
double study_distance(const struct place *a, const struct place *b);

#endif
