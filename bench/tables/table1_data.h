/* table1_data.h - the result files of Table 1, read: what its tables and sentences are made
 * of.
 */
#ifndef TABLE1_DATA_H
#define TABLE1_DATA_H

#include "bench/tables/table1.h"
#include "bench/truth/truth_plate.h"
#include "models/clock.h"

/* What the tables need of one result file. */
struct table1_cell {
    int frames; /* fewer than TABLE1_TIMES after a death                               */
    double *xyz[TABLE1_TIMES]; /* owned                                                */
    double rmse[TABLE1_TIMES]; /* against the baseline, NaN if not reached        [m]  */
    double unknowns;
    struct clock_summary create, step; /* [s] over repeats; count = 0 for statics      */
    char *outcome; /* owned                                                */
};

struct table1_data {
    struct table1_cell cell[TABLE1_PARTS][TABLE1_VARIANTS];
    struct truth_plate truth;
};

/* Reads all of FOLDER's files and computes the truth of their scene. *d is freed with
 * table1_data_clear. */
enum status table1_data_load(const char *folder, struct table1_data **d,
                             struct message *why);
void table1_data_clear(struct table1_data *d); /* NULL is allowed */

/* Whether the paper's criterion holds at all times. */
bool table1_data_within(const struct table1_cell *c);

/* The first hexahedral density (a variant) that meets it; -1 if none does. */
int table1_data_first(const struct table1_cell *cells, bool incompatible);

/* What a reader should take away, in sentences from the numbers; where they were measured.
 */
void table1_text(const struct table1_data *d, const char *folder, FILE *file);

#endif
