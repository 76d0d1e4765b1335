/* table1.h - the paper's Table 1: what a hexahedral mesh costs that comes within an RMSE of
 * 0.04 of the IGA plate 10 x 10 x 2, and what either is worth against truth. Its parts are
 * the studies of the plan table1, its variants the levels. Deaths and refusals are rows.
 */
#ifndef TABLE1_H
#define TABLE1_H

#include "bench/experiment/experiment.h"
#include "bench/experiment/study.h"

extern const struct experiment table1_exhibit;

enum table1_part { TABLE1_PRINTED, TABLE1_INCREMENTAL, TABLE1_LINEAR, TABLE1_STATIC };

/* The IGA baseline, hexahedra of rising density, the same with incompatible modes, the
 * shell. */
enum {
    TABLE1_DENSITIES = 5,
    TABLE1_HEX = 1,
    TABLE1_HEX32 = TABLE1_HEX + 3,
    TABLE1_CURED = TABLE1_HEX + TABLE1_DENSITIES,
    TABLE1_SHELL = TABLE1_CURED + TABLE1_DENSITIES,
    TABLE1_VARIANTS,
    TABLE1_TIMES = 4
};

/* Of a row of a part against the baseline; NaN if either has not reached the time [m]. */
double table1_rmse(const struct study *part, int variant, int time);

#endif
