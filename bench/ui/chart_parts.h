/* chart_parts.h - what chart.c collects and chart_script.c writes, no business of others.
 */
#ifndef CHART_PARTS_H
#define CHART_PARTS_H

#include "bench/files/output.h"
#include "bench/ui/chart.h"

struct chart_place {
    double x, y, x_side[2], y_side[2]; /* sides are NaN for those that have none       */
};

struct chart_item {
    struct chart_series as; /* label and rgb                                     owned */
    int look;               /* from 0                                                  */
    bool band;              /* of chart_band                                           */
    bool barred, celled;    /* its points have sides in y; in x and y                  */
    int count;
    struct chart_place *at; /* [count]                                           owned */
};

struct chart_list {
    int count;
    struct chart_item *item; /* [count]                                          owned */
};

struct chart_pane {
    char *title;               /*                                                  owned */
    struct chart_axis axis[2]; /* x, y; with all they point to                   owned */
    struct chart_list series;
    struct chart_list stripes, marks; /* of one place each; a stripe's has sides in y  */
};

struct chart {
    char *title; /*                                                              owned */
    int columns, pane_count, look_count;
    struct chart_pane *pane; /*                                                  owned */
    bool failed;             /* out of memory somewhere                                */
};

/* Of chart_look.c: ` with STYLE ... lc rgb ...`, as the plot or as the legend has it. */
void chart_look_write(struct output *out, const struct chart_item *item, bool legend);
extern const char chart_look_band[]; /* colour of a band */
const char *chart_look_rgb(const struct chart_item *item);

/* What stands below the panels, a label once. */
enum { CHART_ENTRIES = 64, CHART_CHARACTER = 8 /* its width in points */ };
struct chart_legend {
    int count, columns, rows;
    const struct chart_item *entry[CHART_ENTRIES];
};
struct chart_legend chart_look_legend(const struct chart *c, int width);
void chart_look_write_legend(struct output *out, const struct chart_legend *l);

#endif
