/* sweep_map.h - the feasibility map: labels in colours over two keys or measures, a panel
 * for each value of a third, with the plan's marks on it. Drawn by gnuplot from map.dat.
 */
#ifndef SWEEP_MAP_H
#define SWEEP_MAP_H

#include "bench/files/output.h"
#include "bench/experiment/plan_case.h"
#include "bench/sweep/sweep_folder.h"

struct sweep_map;

/* Begins map.dat in the folder; *map is NULL for a plan that asks for none, and so all else
 * does nothing. `best`: the label that comes first in the legend, even if no case has it.
 * STATUS_FILE, STATUS_MEMORY. */
enum status sweep_map_open(struct sweep_map **map, const struct plan *plan,
                           const struct sweep_folder *folder, const char *best,
                           struct message *why);

/* `labels`: of the case, its colour. */
void sweep_map_row(struct sweep_map *map, const struct plan_case *c,
                   const struct sweep_row *row, const char *labels);

/* Ends the data, writes map.gp and draws map.png; frees. STATUS_UNSUPPORTED with a sentence
 * if there is no gnuplot; STATUS_FILE, STATUS_LIBRARY. */
enum status sweep_map_close(struct sweep_map *map, struct message *why);
void sweep_map_discard(struct sweep_map *map);

#endif
