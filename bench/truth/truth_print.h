/* truth_print.h - a truth as a table: orders, bars, differences and growth at its times,
 * and until when it is claimed. */
#ifndef TRUTH_PRINT_H
#define TRUTH_PRINT_H

#include "bench/truth/truth_made.h"
#include "bench/ui/table.h"

/* Of a truth with many frames the times at which tables judge (truth_plan_judges), and the
 * last that is claimed. As table_print. */
enum status truth_print(const struct truth_made *made, const struct scene *scene,
                        enum table_format format, FILE *file);

#endif
