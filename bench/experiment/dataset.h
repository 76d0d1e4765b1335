/* dataset.h - reads the results of a plan's studies as rows that labels name, for tables
 * and claims.
 *
 * The labels of a level are its study's name on the axis "study", and its label on each
 * axis of the study, or on the axis "level" where levels are listed. A row is a level at
 * the study's last time unless {"at", "0.5"} names another, or {"at", "*"} all of them.
 *
 *     dataset_at(d, QUANTITY_FRAME, WHERE({"solver", "direct"}, {"net", "5x5x2"}))
 */
#ifndef DATASET_H
#define DATASET_H

#include "bench/experiment/judge.h"
#include "bench/experiment/study.h"

/* --- Quantities (quantity.c): every number that can be read off the levels of a study is
 * defined once: a plan names it as a column, claims ask for it, CSV and JSON have it under
 * its name. A new quantity is one function and one row.
 */
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
      "a time step, or the equilibrium: median over repeats, one thread")                  \
    X(FRAME_LOWER, frame_lower, "frame_lower_ms", "", "ms", 3, false,                      \
      "lower quartile of a frame's milliseconds")                                          \
    X(FRAME_UPPER, frame_upper, "frame_upper_ms", "", "ms", 3, false,                      \
      "upper quartile of them")                                                            \
    X(OF_REFERENCE, of_reference, "of_reference", "of reference", NULL, 3, false,          \
      "a frame's milliseconds over those of the reference")                                \
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
    X(CROSSINGS, crossings, "crossings", "crossings", "pairs", 0, true,                    \
      "pairs of the mid-surface's triangles that cross")
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
    double (*at)(const struct place *p); /* its value, in the unit; NaN: there is none */
    const char *help; /* words that say what it measures                                */
};

extern const struct quantity_row quantity_table[QUANTITIES];

/* Finds a quantity by its name; -1: there is none. */
int quantity_find(const char *name);

/* --- Rows. */

struct where {
    const char *axis, *label; /* "!LABEL": any other; "WORD*": any that begins so      */
};
#define WHERE(...) ((const struct where[]){__VA_ARGS__, {NULL, NULL}})

/* Returns the label of a level on an axis; NULL: its study has no such axis. */
const char *dataset_label(const struct study *s, int level, const char *axis);

/* Lists at most `most` labels of an axis, each once, in the plan's order; returns how many.
 */
int dataset_labels(const struct study_results *d, const char *axis, int most,
                   const char **label);

/* Returns the value in the row that all labels name; NaN if none or several are named. */
double dataset_at(const struct study_results *d, enum quantity q,
                  const struct where *where);

/* Judges whether the plan's rules give that row's run a label (verdict.h); NULL: whether
 * they call it feasible. Open: no such row, or nothing to judge by. */
enum judge dataset_verdict(const struct study_results *d, const char *label,
                           const struct where *where);

/* Return the largest and the smallest value of all rows that the labels name and that have
 * one; NaN if there is none. The third returns the largest, and NaN if a row has none. */
double dataset_most(const struct study_results *d, enum quantity q,
                    const struct where *where);
double dataset_least(const struct study_results *d, enum quantity q,
                     const struct where *where);
double dataset_all_most(const struct study_results *d, enum quantity q,
                        const struct where *where);

/* Lists the values of the first `most` rows that the labels name, in the plan's order, and
 * returns how many. The second writes all of them as "2.1, died, 5.6". */
int dataset_values(const struct study_results *d, enum quantity q,
                   const struct where *where, int most, double *values);
void dataset_write(const struct study_results *d, enum quantity q,
                   const struct where *where, FILE *file);

/* Returns the value of one row over that of another; NaN unless each names one row. */
double dataset_ratio(const struct study_results *d, enum quantity q, const struct where *a,
                     const struct where *b);

/* Returns the rms distance of two rows at the first one's time over the length; NaN unless
 * each names one row. */
double dataset_apart(const struct study_results *d, const struct where *a,
                     const struct where *b);

/* Returns the slope of log y over log x in the rows that the labels name; NaN with fewer
 * than two. */
double dataset_exponent(const struct study_results *d, enum quantity x, enum quantity y,
                        const struct where *where);

/* Checks that the plan's table and chart name quantities. STATUS_INPUT with a sentence
 * `plan:line: ...`. */
enum status dataset_check(const struct plan *plan, struct message *why);

/* Prints the table that the plan asks for, also as FOLDER/NAME.csv, and draws its chart as
 * FOLDER/NAME.png and its sheets; NAME is the plan's or what the plan says. Studies of a
 * plan without a table are printed one by one, under their names: cost and differences of
 * the levels, with observed orders, and error over seconds as the chart. */
enum status dataset_print(const struct study_results *d, const char *folder,
                          enum table_format format, FILE *file, struct message *why);

#endif
