/* protocol_chart.h - a small chart of errors in a page, as SVG that needs no program. */
#ifndef PROTOCOL_CHART_H
#define PROTOCOL_CHART_H

#include <stdbool.h>
#include <stdio.h>

enum { PROTOCOL_POINTS = 256 }; /* of a line at most */

struct protocol_line {
    const char *label; /*                                                       borrowed */
    bool bar;          /* the area below it is filled                                    */
    int count;
    double xy[PROTOCOL_POINTS][2]; /* [count] with y in per cent                         */
};

/* Writes a figure with its legend; y is logarithmic. Points below its axis, which spans
 * three decades or four, are drawn on it. `x_name` has its unit and is not escaped. */
void protocol_chart_write(const char *title, const char *x_name, bool log_x, int lines,
                          const struct protocol_line *line, FILE *file);

#endif
