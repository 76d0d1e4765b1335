/* bench.h - the command `bench`: speed, as times and as ratios to named baselines. */
#ifndef BENCH_H
#define BENCH_H

#include "bench/ui/command.h"

extern const struct command bench_command;

#endif
