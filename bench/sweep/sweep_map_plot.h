/* sweep_map_plot.h - the script that draws map.dat and marks.dat of a sweep. */
#ifndef SWEEP_MAP_PLOT_H
#define SWEEP_MAP_PLOT_H

#include <stdbool.h>

#include "models/status.h"

/* Names as they come, each with its number; those beyond the room are "other". */
enum { SWEEP_MAP_NAMES = 24, SWEEP_MAP_NAME = 160 };
struct sweep_map_names {
    int count;
    long uses[SWEEP_MAP_NAMES]; /* how often each came                                 */
    char name[SWEEP_MAP_NAMES][SWEEP_MAP_NAME];
};

/* Its number, a new one for a new name. */
int sweep_map_names_add(struct sweep_map_names *names, const char *name);

struct sweep_map_side {
    const char *name;
    bool log;
    char tics[1024]; /* "" for those of numbers                                        */
};

struct sweep_map_plot {
    const char *title;
    struct sweep_map_side x, y;
    const char *panel; /* what the panels differ in; NULL: there is one                */
    bool cells;        /* boxes that fill the map, else points                         */
    const bool (*seen)[SWEEP_MAP_NAMES];   /* [panel][class]: there is such a case     */
    const bool (*marked)[SWEEP_MAP_NAMES]; /* [panel][label of a mark], as well        */
    const struct sweep_map_names *panels, *classes, *marks;
};

/* Writes map.gp. STATUS_FILE. */
enum status sweep_map_plot(const char *folder, const struct sweep_map_plot *plot,
                           struct message *why);

#endif
