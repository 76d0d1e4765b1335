/* quantity.h - every number that can be read off the levels of a study, each defined once:
 * a plan names it as a column, claims ask for it, CSV and JSON have it under its name. A
 * new quantity is one function and one row.
 */
#ifndef QUANTITY_H
#define QUANTITY_H

#include <stdbool.h>

#include "bench/harness/measures.h"

struct study;         /* study.h */
struct study_results; /* study.h */

enum quantity {
    QUANTITY_SIZE,
    QUANTITY_CONTROL_POINTS,
    QUANTITY_UNKNOWNS,
    QUANTITY_FACTOR_ENTRIES,
    QUANTITY_CREATE,
    QUANTITY_FRAME,
    QUANTITY_FRAME_LOWER,
    QUANTITY_FRAME_UPPER,
    QUANTITY_OF_REFERENCE,
    QUANTITY_ASSEMBLE,
    QUANTITY_FACTOR,
    QUANTITY_SOLVE,
    QUANTITY_PAPER,
    QUANTITY_PAPER_OF_REFERENCE,
    QUANTITY_SECONDS,
    QUANTITY_FACTORISATIONS,
    QUANTITY_SOLVES,
    QUANTITY_ITERATIONS,
    QUANTITY_APART,
    QUANTITY_TIP,
    QUANTITY_TIP_OF_REFERENCE,
    QUANTITY_DEPTH,
    QUANTITY_SPEED,
    QUANTITY_SWING,
    QUANTITY_EDGE_MOVED,
    QUANTITY_DEATH,
    QUANTITY_APART_MOST,
    QUANTITY_NEXT,
    QUANTITY_FINEST,
    QUANTITY_ERROR,
    QUANTITY_OFF,
    QUANTITY_BAR,
    QUANTITY_ROUGHNESS,
    QUANTITY_INNER,
    QUANTITY_STRETCH,
    QUANTITY_DROP,
    QUANTITY_UNEVENNESS,
    QUANTITY_ANGLE,
    QUANTITY_CROSSINGS,
#define QUANTITY_CODE(code, name, unit, sentence) QUANTITY_##code,
    MEASURE_LIST(QUANTITY_CODE) /* measures.h: over all looks of a run                   */
#undef QUANTITY_CODE
    QUANTITIES
};

struct quantity_row {
    const char *name; /* "frame_ms": in plans, CSV and JSON                            */
    const char *head; /* "a frame": column head in a table; "": for machines alone      */
    const char *unit; /* "ms", "L", "1"; NULL for a pure number                        */
    int digits;       /* significant ones that a table shows; 0: a whole number        */
    bool moves;       /* it is another one at each time                                 */
    /* Its value, in the unit, of a level at one of its study's times, both from 0. NaN
     * where the result has none. */
    double (*at)(const struct study_results *d, const struct study *s, int level, int time);
    const char *help; /* words that say what it measures                                */
};

extern const struct quantity_row quantity_table[QUANTITIES];

/* By its name; -1: there is none. */
int quantity_find(const char *name);

#endif
