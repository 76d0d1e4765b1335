/* table4_learn.h - a second verdict on Table 4: bounds that are learnt from the paper's own
 * words, and what they say of rows that they were not learnt from.
 *
 * Each label keeps the measure that its rule judges by; its bound is what agrees best with
 * the paper. A row is then judged by bounds learnt from the other rows alone (leave one
 * out: Stone, J. R. Stat. Soc. B 36, 1974), which shows whether there is anything to learn.
 */
#ifndef TABLE4_LEARN_H
#define TABLE4_LEARN_H

#include "bench/tables/table4.h"

struct table4_lesson {
    struct table4_interval bounds;    /* learnt from all rows; half way to the next value
                                         outside, where there is one                    */
    bool fitted[PAPER_TABLE4_ROWS];   /* what they say of the rows                      */
    bool left_out[PAPER_TABLE4_ROWS]; /* of each row, those learnt from the others     */
};

/* From value[count] and the answers yes[count], count at most PAPER_TABLE4_ROWS. NaN is
 * always answered no. */
struct table4_lesson table4_learn(int count, const double *value, const bool *yes,
                                  enum table4_bounds shape);

/* Table and its sentence, of a scene's printed runs and of E/rho. */
enum status table4_learn_print(const struct table4_data *d, enum table_format format,
                               FILE *file);

#endif
