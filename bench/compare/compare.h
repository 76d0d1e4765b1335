/* compare.h - the command `compare`: speed against error, all contestants, one scene. */
#ifndef COMPARE_H
#define COMPARE_H

#include "bench/harness/contestant.h"
#include "bench/harness/run_result.h"
#include "bench/truth/truth.h"
#include "bench/ui/command.h"
#include "bench/ui/table.h"

extern const struct command compare_command;

enum { COMPARE_TIMES = 5 };

/* The steps on which each contestant is set: nets, time steps, iterations, from cheap to
 * dear, as its row of the table has them. */
struct refinement {
    const struct contestant *contestant;
    int side;       /* points along u and v                                            */
    int divisor;    /* the scene's frame is divided into so many steps                 */
    int iterations; /* local-global iterations, 0: the model has none                  */
};

/* A contestant, refined so far, with what came of it. */
struct compare_row {
    struct refinement at;
    struct run_result result;    /* without fields                                     */
    double seconds;              /* set-up and stepping, medians over the repeats      */
    double error[COMPARE_TIMES]; /* RMSE / L at each time; NaN after a death           */
    double worst;                /* the largest; NaN after a death                     */
};

struct compare {
    const struct scene *scene; /*                                             borrowed */
    char physics[128];         /* how damping was read                                 */
    const struct truth *truth; /* of COMPARE_TIMES times at most                       */
    int count;
    struct compare_row *rows; /* those of a contestant stand together                  */
};

/* The table of all runs to `file` and as compare.csv in the folder; seconds to given
 * errors; charts of seconds against error, the best of each model in compare.png, all by
 * model in compare_models.png (compare_print.c). */
enum status compare_print(const struct compare *c, const char *folder,
                          enum table_format format, FILE *file, struct message *why);

#endif
