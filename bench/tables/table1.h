/* table1.h - the paper's Table 1: what a hexahedral mesh costs that comes within an RMSE of
 * 0.04 of the IGA plate 10 x 10 x 2, and what either is worth against truth. Its parts are
 * the studies of the plan table1, its variants the levels. Deaths and refusals are rows.
 *
 * table1_read reduces the results to numbers; what is printed is made from these alone, so
 * that tests can feed any.
 */
#ifndef TABLE1_H
#define TABLE1_H

#include "bench/experiment/experiment.h"
#include "models/clock.h"

extern const struct experiment table1_exhibit;

enum table1_part {
    TABLE1_PRINTED,
    TABLE1_INCREMENTAL,
    TABLE1_LINEAR,
    TABLE1_STATIC,
    TABLE1_PARTS
};

/* The IGA baseline, hexahedra of rising density, the same with incompatible modes, the
 * shell. */
enum {
    TABLE1_DENSITIES = 5,
    TABLE1_HEX = 1,
    TABLE1_HEX32 = TABLE1_HEX + 3,
    TABLE1_CURED = TABLE1_HEX + TABLE1_DENSITIES,
    TABLE1_SHELL = TABLE1_CURED + TABLE1_DENSITIES,
    TABLE1_VARIANTS,
    TABLE1_TIMES = 4,
    TABLE1_ALL = TABLE1_TIMES, /* of the times                                          */
    TABLE1_REST = TABLE1_TIMES /* after them, of errors                                 */
};

struct table1_variant {
    const char *model; /*                                                     borrowed  */
    bool cured;        /* by incompatible modes                                         */
    int side, layers;  /* of points; layers 0: a surface                                */
    double unknowns;
    struct clock_summary create, step; /* [s]; count 0: not timed                       */
    double rmse[TABLE1_TIMES]; /* to the baseline [m]; NaN: one has not got there       */
    const char *trouble;       /* why not; NULL                               borrowed  */
};

struct table1 {
    double time[TABLE1_TIMES]; /* [s]                                                   */
    struct table1_variant variant[TABLE1_PARTS][TABLE1_VARIANTS];
    /* Linear motion and rest against the Kirchhoff plate: RMSE over the rms displacement,
     * and the middle of the free edge over its deflection; NaN: there is none. */
    double error[TABLE1_VARIANTS][TABLE1_TIMES + 1], tip[TABLE1_VARIANTS];
    double gamma, thickness_ratio;
};

/* Borrows from the results. Errors as truth_plate_init. */
enum status table1_read(const struct study_results *r, struct table1 *t,
                        struct message *why);

/* What is in a result in a line, tables, in prose what a reader should take away. */
enum status table1_print(const struct table1 *t, enum table_format format, FILE *file);

/* --- The judging (table1_text.c). */

/* A frame, in frames of the baseline; NaN: one was not timed. */
double table1_cost(const struct table1 *t, enum table1_part part, int variant);

/* Whether the paper's criterion holds at a time, or at all of them (TABLE1_ALL). */
bool table1_within(const struct table1 *t, enum table1_part part, int variant, int time);

/* The one line to remember. */
void table1_headline(const struct table1 *t, FILE *file);

/* Below a part's table: which densities meet the criterion, whether refinement leads there.
 */
void table1_notes(const struct table1 *t, enum table1_part part, struct table *table);

void table1_text(const struct table1 *t, FILE *file);

#endif
