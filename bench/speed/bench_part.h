/* bench_part.h - what `bench` is made of: parts that are measured, kept in a folder and
 * printed from there.
 */
#ifndef BENCH_PART_H
#define BENCH_PART_H

#include "bench/experiment/batch.h"
#include "bench/speed/samples.h"
#include "bench/ui/command.h"
#include "bench/ui/table.h"

struct bench {
    const char *folder, *path; /* of the results; of edge_drop's scene file             */
    const char *models;        /* as --models has them                                  */
    enum table_format format;
    bool quick;
    struct batch batch;     /* of the part at work                                      */
    struct samples samples; /* likewise                                                 */
};

enum { BENCH_CASES = 64 };

struct bench_part {
    struct command_item item;
    enum status (*plan)(struct bench *b, struct message *why);   /* its runs; NULL: none */
    enum status (*sample)(struct bench *b, struct message *why); /* else; NULL: nothing  */
    enum status (*print)(const struct bench *b, struct message *why);
};
extern const struct bench_part bench_part_solids, bench_part_baselines, bench_part_levers,
    bench_part_growth, bench_part_intersection, bench_part_projective, bench_part_nonlinear,
    bench_part_swings, bench_part_contestants;

/* A run on edge_drop. */
struct bench_run {
    const char *title, *contestant;
    const char *settings[4]; /* KEY=VALUE; NULL ends                                    */
    double end; /* all frames up to it are timed [s]; 0: twenty, and the phases, apart  */
};
enum status bench_part_add(struct bench *b, const struct bench_run *run,
                           struct message *why);

/* A row's cells of seconds: median, least, quartiles, how many repeats; what to reach, in
 * milliseconds (0: no aim), and whether the median does. */
#define BENCH_PART_TIMES                                                                   \
    {"median", "ms"}, {"min", "ms"}, {"lower", "ms"}, {"upper", "ms"},                     \
    {                                                                                      \
        "repeats"                                                                          \
    }
#define BENCH_PART_AIM                                                                     \
    {"aim", "ms"},                                                                         \
    {                                                                                      \
        "reached", NULL, TABLE_LEFT                                                        \
    }
void bench_part_times(struct table *t, const struct clock_summary *s);
void bench_part_aim(struct table *t, const struct clock_summary *s, double aim);

#endif
