/* score_print.h - scores as one sheet: a table, or JSON. */
#ifndef SCORE_PRINT_H
#define SCORE_PRINT_H

#include "bench/score/score_diagnosis.h"
#include "bench/ui/table.h"

/* The part of a score that outlives its fields. */
struct score_result {
    char *scene;            /* its name                                        owned */
    char source[640];       /* of the truth                                          */
    struct message refused; /* why there is no score; empty: there is one            */
    int times, frames, vertices;
    struct score_time *row; /* [times]                                         owned */
    bool undamped, by_position;
    double first, last; /* times of frames [s]                                   */
    struct score_diagnosis diagnosis;
};

void score_result_clear(struct score_result *result); /* all-zero is allowed */

/* Prints scores: CSV has scene,time,error,bar,floor, over the length; JSON an object a
 * scene. */
enum status score_print(const struct score_result *results, int count,
                        enum table_format format, FILE *file);

#endif
