/* chart.h - a chart is data: panels with axes, series of points, bands, marks. It becomes
 * one script of gnuplot and NAME.png, NAME.svg (for pages) and NAME.pdf (for papers).
 *
 *     struct chart *c = chart_create("A frame, the paper and here");
 *     chart_axes(c, &(struct chart_axis){"control points", .log = true},
 *                &(struct chart_axis){"a frame", "ms", .log = true});
 *     chart_series(c, &(struct chart_series){"paper"});
 *     chart_point(c, 540, 0.8);
 *     chart_band(c, "truth's error bar", 0, bar);
 *     TRY(chart_save(c, folder, "cost", why));
 *
 * The legend stands below, never over data. A look (colour, point, dash) belongs to a
 * label: the same label looks the same in every panel and stands in the legend once. Words
 * are copied; none is ever read as a command by gnuplot, whatever it holds. Running out of
 * memory on the way is remembered and reported by chart_write.
 */
#ifndef CHART_H
#define CHART_H

#include <stdbool.h>

#include "models/status.h"

struct chart;

/* The most lines in a panel that a reader can follow. */
enum { CHART_LINES_MOST = 8 };

/* Creates a chart, with one panel without title and without axes' names. NULL without
 * memory, which every function below accepts. */
struct chart *chart_create(const char *title);
void chart_destroy(struct chart *c); /* NULL is allowed */

struct chart_tic {
    double at;
    const char *text;
};

struct chart_axis {
    const char *name; /* for people, no key                                              */
    const char *unit; /* stands in brackets behind it; NULL, "1": none */
    bool log;
    double low, high; /* low < high: its ends; else as the data                          */
    int tic_count;    /* 0: gnuplot's                                                    */
    const struct chart_tic *tics;
};

/* Sets the axes of all panels; before any points. */
void chart_axes(struct chart *c, const struct chart_axis *x, const struct chart_axis *y);

/* Starts the next panel; a first call before anything else names the first panel. */
void chart_panel(struct chart *c, const char *title);

enum chart_style {
    CHART_LINESPOINTS,
    CHART_POINTS,
    CHART_SQUARES, /* for classes                                                      */
    CHART_CELLS    /* boxes of chart_cell, for classes                                 */
};

struct chart_series {
    const char *label; /* NULL: not in the legend                                        */
    enum chart_style style;
    int colour;      /* from 1; 0: the label's, the next one for a new label           */
    bool second;     /* second of its colour: a dashed line, open points               */
    bool sorted;     /* points are sorted by x                                         */
    const char *rgb; /* "#8cd17d", for a class that has its own; NULL: by `colour`;
                        a constant of the program                                      */
};

/* Starts a series of the panel, to which the points behind it go. A point that is no
 * number, or <= 0 on a log axis, is left out. */
void chart_series(struct chart *c, const struct chart_series *series);
void chart_point(struct chart *c, double x, double y);
void chart_cell(struct chart *c, double x, double y, const double x_side[2],
                const double y_side[2]);

/* Adds a band across the panel, such as a truth's error bar. */
void chart_band(struct chart *c, const char *label, double low, double high);

/* Writes words at a point. */
void chart_mark(struct chart *c, double x, double y, const char *text);

/* Writes FOLDER/NAME.gp and draws it. STATUS_UNSUPPORTED with a sentence if a panel has
 * more lines than CHART_LINES_MOST, or if there is no gnuplot (the script is there then);
 * STATUS_LIBRARY if it fails; STATUS_FILE, STATUS_INPUT as plot_begin, STATUS_MEMORY. */
enum status chart_write(const struct chart *c, const char *folder, const char *name,
                        struct message *why);

/* Writes the chart, says on standard error whether it is drawn or why not, and destroys it.
 * Only STATUS_FILE, STATUS_INPUT and STATUS_MEMORY are failures: results are worth having
 * without their picture. */
enum status chart_save(struct chart *c, const char *folder, const char *name,
                       struct message *why);

#endif
