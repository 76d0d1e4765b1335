/* bench_intersection.h - what counting self-intersections costs, and what its tree saves.
 */
#ifndef BENCH_INTERSECTION_H
#define BENCH_INTERSECTION_H

#include "bench/ui/table.h"

/* Surfaces of 100 x 100 points from flat to crumpled: seconds with the tree and for every
 * pair, to standard output. STATUS_LIBRARY if the two counts differ. */
enum status bench_intersection_print(enum table_format format, struct message *why);

#endif
