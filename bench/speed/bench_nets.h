/* bench_nets.h - the nets of solids that are held against aims and against libraries. */
#ifndef BENCH_NETS_H
#define BENCH_NETS_H

#include "bench/speed/bench_part.h"

#define UNDAMPED "damping={kind: none}"

/* A net with what to reach [ms] and what others took for the same work, on another
 * two-core machine: named, never in a ratio. */
struct bench_net {
    struct bench_run run;
    bool large; /* a band of it would take 7 GB                                         */
    double phase[3], frame; /* to reach [ms]; 0: no aim                                 */
    const char *elsewhere;
};

enum { BENCH_NETS = 4 };
extern const struct bench_net bench_nets[BENCH_NETS];

#endif
