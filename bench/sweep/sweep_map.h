/* sweep_map.h - the feasibility map: labels in colours over two keys or measures, a panel
 * for each value of a third, with the plan's marks on it; hatched where the plan's second
 * opinion, if it has one, finds nothing against a case.
 */
#ifndef SWEEP_MAP_H
#define SWEEP_MAP_H

#include "bench/sweep/sweep_folder.h"
#include "bench/ui/chart.h"

struct sweep_map;

/* *map is NULL for a plan that asks for none, and so all else does nothing. `best`: the
 * label that comes first in the legend, even if no case has it. STATUS_MEMORY. */
enum status sweep_map_create(struct sweep_map **map, const struct plan *plan,
                             const char *best);
void sweep_map_destroy(struct sweep_map *map);

/* `labels`: of the case, its colour; `learnt`: it is hatched. STATUS_MEMORY. */
enum status sweep_map_row(struct sweep_map *map, const struct plan_case *c,
                          const struct sweep_row *row, const char *labels, bool learnt);

/* As a chart; NULL: there is no map. STATUS_INPUT: a mark; STATUS_MEMORY. */
enum status sweep_map_chart(const struct sweep_map *map, struct chart **chart,
                            struct message *why);

#endif
