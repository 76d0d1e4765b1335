/* protocol_chart.h - a small chart of errors in a page, as SVG that needs no program. */
#ifndef PROTOCOL_CHART_H
#define PROTOCOL_CHART_H

#include <stdbool.h>
#include <stdio.h>

struct protocol_line {
    const char *label; /*                                                       borrowed */
    int count;
    const double (*xy)[2]; /* [count] with y in per cent                        borrowed */
    bool bar;              /* the area below it is filled                                */
};

struct protocol_chart {
    const char *title, *x_name; /* with its unit                                         */
    bool log_x;                 /* y always is                                           */
    int count;
    const struct protocol_line *line; /* [count]                                borrowed */
};

/* Writes a figure with its legend. Points below its axis, which spans RANGE at most, are
 * drawn on it. */
void protocol_chart_write(const struct protocol_chart *c, FILE *file);

#endif
