/* bench_nonlinear.h - frames of the models that iterate, over a whole motion. */
#ifndef BENCH_NONLINEAR_H
#define BENCH_NONLINEAR_H

#include "bench/table.h"

/* Shell and mass-spring on edge_drop to 0.4 s, undamped, against their aims. To standard
 * output. */
enum status bench_nonlinear_print(enum table_format format, struct message *why);

#endif
