/* svg_chart.h - a small chart of errors in a page, as SVG that needs no program. */
#ifndef SVG_CHART_H
#define SVG_CHART_H

#include <stdbool.h>
#include <stdio.h>

/* The points of a line at most, and the bytes of words. */
enum { SVG_CHART_POINTS = 256, SVG_CHART_WORDS = 80 };

struct svg_chart_line {
    const char *label; /*                                                       borrowed */
    bool bar;          /* the area below it is filled                                    */
    int count;
    double xy[SVG_CHART_POINTS][2]; /* [count] with y in per cent                         */
    char note[SVG_CHART_POINTS][SVG_CHART_WORDS]; /* [count] shown behind the label where
                                                     a point is pointed at; "": nothing  */
    char link[SVG_CHART_WORDS];                   /* of the legend; "": none              */
};

/* Writes a figure with its legend; y is logarithmic. Points below its axis, which spans
 * three decades or four, are drawn on it. The title may be NULL; `x_name` has its unit and
 * is not escaped. The page's style has the colours c0 to c7 of lines and `area` of bars. */
void svg_chart_write(const char *title, const char *x_name, bool log_x, int lines,
                     const struct svg_chart_line *line, FILE *file);

#endif
