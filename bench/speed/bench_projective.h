/* bench_projective.h - projective dynamics: what a frame's parts cost, and what
 * acceleration pays. */
#ifndef BENCH_PROJECTIVE_H
#define BENCH_PROJECTIVE_H

#include "bench/ui/table.h"

/* Local step, solve and frame of 10 iterations on nets of three sizes, against aims; then
 * how far a step is from its end after so many iterations, plain and accelerated. To
 * standard output. */
enum status bench_projective_print(enum table_format format, struct message *why);

#endif
