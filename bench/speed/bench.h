/* bench.h - the command `bench`: speed, as times and as ratios to named baselines. It is
 * made of parts, each with a table: a part is measured, its runs are kept in a folder, and
 * the table is printed from there.
 */
#ifndef BENCH_H
#define BENCH_H

#include "bench/experiment/batch.h"
#include "bench/ui/command.h"
#include "bench/ui/table.h"

/* A run on edge_drop, with the time it should reach [ms] (0: no aim). peers.csv has what
 * other programs take for the work of its title. */
struct bench_row {
    const char *title, *contestant;
    const char *settings[5]; /* KEY=VALUE; NULL ends                                    */
    double end; /* all frames up to it are timed [s]; 0: twenty, and the phases, apart  */
    double frame, phase[3];
};

struct bench {
    const struct bench_part *part; /* that is measured or printed                       */
    const char *folder, *path;     /* of its results; of edge_drop's scene file         */
    const char *models;            /* of --models; NULL: all                            */
    enum table_format format;
    FILE *file; /* to print to                                                          */
    bool quick;
    struct batch batch;        /* the part's runs                                       */
    struct run_result *result; /* [batch.count], when it is printed              owned  */
};

enum { BENCH_PART_RUNS = 64 };

struct bench_part {
    struct command_item item;
    const char *caption, *note; /* of its table                                         */
    const char *peers; /* name of the same work in peers.csv; NULL: none                */
    int count;
    const struct bench_row *rows; /* [count] its runs                                   */
    enum status (*plan)(struct bench *b, struct message *why); /* adds runs; NULL: none  */
    enum status (*print)(const struct bench *b, struct message *why);
    enum status (*measure)(struct bench *b, struct message *why); /* measures and prints
                               what is no run, of which nothing is kept; NULL: runs     */
};
extern const struct bench_part bench_part_solids, bench_part_projective,
    bench_part_nonlinear, bench_part_contact, bench_part_contestants;

/* Adds a run. STATUS_INPUT: there is no such contestant. */
enum status bench_part_add(struct bench *b, const struct bench_row *row,
                           struct message *why);

#endif
