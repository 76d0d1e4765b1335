/* bench_nonlinear.h - frames of the models that iterate, over a whole motion. */
#ifndef BENCH_NONLINEAR_H
#define BENCH_NONLINEAR_H

#include "bench/ui/table.h"

/* Shell, mass-spring and nonlinear solids on edge_drop to 0.4 s, undamped, against their
 * aims; a second of the solid on 20x20x2. To standard output. */
enum status bench_nonlinear_print(enum table_format format, struct message *why);

#endif
