/* table1.h - the paper's Table 1: what a hexahedral mesh costs that comes within an RMSE of
 * 0.04 of the IGA plate 10 x 10 x 2, and what either is worth against truth.
 *
 * Measuring runs every case and leaves one result file each in a folder; the tables are
 * made from those files alone. Deaths and refusals are rows.
 */
#ifndef TABLE1_H
#define TABLE1_H

#include "bench/experiment/experiment.h"
#include "bench/harness/run_result.h"
#include "bench/truth/truth_plate.h"

extern const struct experiment table1_exhibit;

enum table1_part {
    TABLE1_PRINTED,
    TABLE1_INCREMENTAL,
    TABLE1_LINEAR,
    TABLE1_STATIC,
    TABLE1_PARTS
};

/* Variants: the IGA baseline, hexahedra of rising density, the same with incompatible
 * modes, the shell. This knows neither the printed nor the incremental scheme: in those
 * parts it moves by its own nonlinear one, undamped. */
enum {
    TABLE1_DENSITIES = 5,
    TABLE1_HEX = 1,
    TABLE1_HEX32 = TABLE1_HEX + 3,
    TABLE1_CURED = TABLE1_HEX + TABLE1_DENSITIES,
    TABLE1_SHELL = TABLE1_CURED + TABLE1_DENSITIES,
    TABLE1_VARIANTS
};
const struct contestant *table1_contestant(enum table1_part part, int variant);
int table1_side(int variant); /* points or nodes along u and v */

/* FOLDER/printed_hex_32_incompatible.h5 into path[size]. */
void table1_path(const char *folder, enum table1_part part, int variant, char *path,
                 int size);

/* The result files, read. */
enum { TABLE1_TIMES = 4 };
extern const double table1_time[TABLE1_TIMES]; /* [s] */
struct table1_cell {
    struct run_result run; /* a field at each time that it lived to see; of rest, one    */
    double rmse[TABLE1_TIMES]; /* against the baseline, NaN if not reached          [m]  */
};
struct table1_data {
    struct table1_cell cell[TABLE1_PARTS][TABLE1_VARIANTS];
    struct truth_plate truth; /* at table1_time, of the linear runs                      */
};

/* Reads all of FOLDER's files; *d is freed with table1_clear. */
enum status table1_load(const char *folder, struct table1_data **d, struct message *why);
void table1_clear(struct table1_data *d); /* NULL is allowed */

/* Tables and sentences (table1_print.c). */
enum status table1_print(const char *folder, enum table_format format, FILE *file,
                         struct message *why);

#endif
