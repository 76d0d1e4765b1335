/* compare.h - the command `compare`: speed against error, all models, one scene. */
#ifndef COMPARE_H
#define COMPARE_H

#include "bench/ui/command.h"
#include "bench/compare/ladder.h"
#include "bench/harness/rung.h"
#include "bench/ui/table.h"
#include "bench/truth/truth.h"

extern const struct command compare_command;

/* A rung with what came of it. */
struct compare_row {
    struct ladder_rung rung;
    struct rung_result result; /* owned; frames = 0 and outcome NULL if refused        */
    char refused[256];         /* the model's sentence, or empty                       */
    double worst;              /* largest RMSE / L over the times; NaN after a death   */
};

struct compare {
    const char *scene; /* name, borrowed                                               */
    double gamma, length, frame; /* 1, [m], [s]                                        */
    char physics[128]; /* how damping was read                                         */
    const struct truth *truth;
    int count;
    struct compare_row *rows;
};

/* compare_print.c: tables and sentences; CSV and plot into `folder`. */
enum status compare_print(const struct compare *c, enum table_format format, FILE *file);
enum status compare_print_files(const struct compare *c, const char *folder,
                                struct message *why);

#endif
