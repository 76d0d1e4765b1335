/* site_chart.h - the chart of error against seconds in a page: the best contestant of each
 * model, as a drawing in the page itself. */
#ifndef SITE_CHART_H
#define SITE_CHART_H

#include <stdbool.h>
#include <stdio.h>

#include "bench/files/csv.h"

/* Writes the chart of a table of runs with its legend, in which contestants have `links` to
 * their pages. Nothing is written where no run has both numbers > 0. `bar` is the truth's
 * error bar over the length; NaN: unknown. STATUS_MEMORY. */
enum status site_chart_write(FILE *file, const struct csv_table *runs, double bar,
                             bool links);

#endif
