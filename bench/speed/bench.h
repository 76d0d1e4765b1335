/* bench.h - the command `bench`: speed, as times and as ratios to named baselines. It is
 * made of parts, each with a table: a part is measured, its runs are kept in a folder, and
 * the table is printed from there.
 */
#ifndef BENCH_H
#define BENCH_H

#include "bench/experiment/batch.h"
#include "bench/ui/command.h"
#include "bench/data/printer.h"

struct bench {
    const char *folder, *path; /* of its results; of edge_drop's scene file         */
    const char *models;        /* of --models; NULL: all                            */
    struct printer *printer;
    bool quick;
    struct batch batch;        /* the part's runs                                       */
    struct run_result *result; /* [batch.count], when it is printed              owned  */
};

enum { BENCH_PART_RUNS = 64 };

struct bench_part {
    struct command_item item;
    enum status (*plan)(struct bench *b, struct message *why); /* adds runs              */
    enum status (*print)(const struct bench *b, struct message *why);
    enum status (*measure)(struct bench *b, struct message *why); /* instead of both:
                               measures and prints what is no run; no file of it is kept  */
};
extern const struct bench_part bench_part_solids, bench_part_contact,
    bench_part_contestants;

#endif
