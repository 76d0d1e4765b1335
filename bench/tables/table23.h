/* table23.h - the paper's Tables 2 and 3: milliseconds a frame over scenes, nets and
 * degrees, rebuilt every frame as the paper does and with one factorisation for all frames.
 * Their rows are the studies of the plans table2 and table3, their kinematics the levels.
 */
#ifndef TABLE23_H
#define TABLE23_H

#include "bench/experiment/experiment.h"
#include "bench/experiment/study.h"
#include "bench/experiment/bench_solid.h"

extern const struct experiment table23_second, table23_third;

/* How a frame is made: the levels of the plans. */
enum table23_kind { TABLE23_PRINTED, TABLE23_INCREMENTAL, TABLE23_LINEAR, TABLE23_KINDS };

/* Rows of Table 2: the sheet that falls onto the ground; those that differ in their net
 * alone; the flag. */
enum {
    TABLE23_CONTACT = 2,
    TABLE23_GROWTH = 3,
    TABLE23_GROWTH_ROWS = 4,
    TABLE23_FLAG = 9,
};

struct table23 {
    bool second;                   /* of the two                                        */
    const struct study_results *r; /*                                         borrowed  */
};

const struct run_result *table23_result(const struct table23 *t, int row,
                                        enum table23_kind kind);

/* Of its net and degree. */
const struct discretization *table23_net(const struct table23 *t, int row);

enum table23_quantity {
    TABLE23_PAPER_MS, /* a frame [ms]: the paper's; medians of ours                     */
    TABLE23_PRINTED_MS,
    TABLE23_INCREMENTAL_MS,
    TABLE23_PREFACTORED_MS,
    TABLE23_ASSEMBLE_MS, /* phases of the rebuilt one                                   */
    TABLE23_FACTOR_MS,
    TABLE23_SOLVE_MS,
    TABLE23_POINTS,   /* control points                                                 */
    TABLE23_ELEMENTS, /* of the net                                                     */
    TABLE23_ENTRIES,  /* of the factor                                                  */
    /* Multiplications, up to a factor: of one assembly, elements x functions^2 x Gauss
     * points; of one factorisation, unknowns x bandwidth^2, the bandwidth taken as entries
     * / unknowns. */
    TABLE23_ASSEMBLY_WORK,
    TABLE23_FACTOR_WORK,
};

/* NaN if there is none. */
double table23_value(const struct table23 *t, int row, enum table23_quantity q);

/* Exponent of the control points in a quantity of `count` rows; NaN if one has none. */
double table23_exponent(const struct table23 *t, int first, int count,
                        enum table23_quantity q);

/* How far the rebuilt sheet is from its obstacle when it was last looked at [m]; NaN. */
double table23_gap(const struct table23 *t, int row);

/* Whether it was followed over the times of a quick run alone. */
bool table23_quick(const struct table23 *t, int row);

/* Tables, CSV and chart in the folder, in prose the headline first and what a reader should
 * take away behind them. */
enum status table23_print(const struct table23 *t, const char *folder,
                          enum table_format format, FILE *file, struct message *why);

/* cost.png: a frame over the control points. */
enum status table23_draw(const struct table23 *t, const char *folder, struct message *why);

/* --- The judging (table23_text.c): the one line to remember; sentences from the numbers.
 */
void table23_headline(const struct table23 *t, FILE *file);
void table23_text(const struct table23 *t, FILE *file);

#endif
