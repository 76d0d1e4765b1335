/* compare.h - the command `compare`: speed against error, all contestants, one scene. */
#ifndef COMPARE_H
#define COMPARE_H

#include "bench/compare/refinement.h"
#include "bench/harness/run_result.h"
#include "bench/truth/truth.h"
#include "bench/ui/command.h"
#include "bench/ui/table.h"

extern const struct command compare_command;

enum { COMPARE_TIMES = 5 };

/* A contestant, refined so far, with what came of it. */
struct compare_row {
    struct refinement at;
    struct run_result result;    /* without fields                                     */
    double seconds;              /* set-up and stepping, medians over the repeats      */
    double error[COMPARE_TIMES]; /* RMSE / L at each time; NaN after a death           */
    double worst;                /* the largest; NaN after a death                     */
};

struct compare {
    const char *scene;           /* name, borrowed                                     */
    double gamma, length, frame; /* 1, [m], [s]                                        */
    char physics[128];           /* how damping was read                               */
    const struct truth *truth;   /* of COMPARE_TIMES times at most                     */
    int count;
    struct compare_row *rows; /* those of a contestant stand together                  */
};

/* Rows of the contestant whose first row is this one. */
int compare_length(const struct compare *c, int first);

/* Of a contestant's rows: the one nearest to the truth; NULL if none lived. */
const struct compare_row *compare_nearest(const struct compare_row *rows, int count);

/* compare_print.c: the table of all runs to `file` and as compare.csv in the folder, where
 * the charts are; seconds to given errors; no contestant's run is cheaper and as good. */
enum status compare_print(const struct compare *c, const char *folder,
                          enum table_format format, FILE *file, struct message *why);

/* compare_chart.c: seconds against error from the table of all runs; the best of each model
 * in compare.png, all by model in compare_models.png. */
enum status compare_chart(const struct compare *c, const struct table *runs,
                          const char *folder, struct message *why);

#endif
