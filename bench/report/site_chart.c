#include "bench/report/site_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/report/html.h"
#include "bench/report/report_summary.h"

/* Size of the drawing and of the part with data. */
enum { WIDTH = 480, HEIGHT = 340, LEFT = 52, RIGHT = 470, TOP = 12, BOTTOM = 296 };

static const char error_key[] = "worst_rmse_over_length";

/* An axis of powers of ten. */
struct axis {
    double low, high; /* exponents                                                      */
    double at[2];     /* their places                                                   */
};

static double place(const struct axis *a, double value)
{
    return a->at[0] + (log10(value) - a->low) / (a->high - a->low) * (a->at[1] - a->at[0]);
}

static double number(const struct csv_table *t, int row, const char *key)
{
    return csv_number(t, row, csv_column(t, key));
}

/* Returns whether a run of the table belongs to the front of a contestant. */
static bool is_front(const struct csv_table *t, int row, const struct report_run *best)
{
    return !strcmp(csv_words(t, row, csv_column(t, "contestant")), best->contestant) &&
           number(t, row, "front") == 1 && number(t, row, "seconds") > 0 &&
           number(t, row, error_key) > 0;
}

static void widen(struct axis *a, double value)
{
    a->low = fmin(a->low, floor(2 * log10(value)) / 2);
    a->high = fmax(a->high, ceil(2 * log10(value)) / 2);
}

static void write_axis(FILE *file, const struct axis *a, bool across)
{
    for (int p = (int)ceil(a->low); p <= (int)floor(a->high); p++) {
        const double x = place(a, pow(10, p));
        if (across)
            fprintf(file,
                    "<path class=\"grid\" d=\"M%.1f %dV%d\"/><text x=\"%.1f\" y=\"%d\" "
                    "text-anchor=\"middle\">%g s</text>",
                    x, TOP, BOTTOM, x, BOTTOM + 18, pow(10, p));
        else
            fprintf(file,
                    "<path class=\"grid\" d=\"M%d %.1fH%d\"/><text x=\"%d\" y=\"%.1f\" "
                    "text-anchor=\"end\">%g %%</text>",
                    LEFT, x, RIGHT, LEFT - 5, x + 4, 100 * pow(10, p));
    }
}

static double seconds_of(const struct csv_table *t, int row)
{
    return number(t, row, "seconds");
}

/* Returns the next run of a contestant's front behind `row`, by seconds; -1: none. */
static int next_run(const struct csv_table *t, const struct report_run *best, int row)
{
    int next = -1;

    for (int n = 0; n < t->rows; n++)
        if (is_front(t, n, best) && (row < 0 || seconds_of(t, n) > seconds_of(t, row)) &&
            (next < 0 || seconds_of(t, n) < seconds_of(t, next)))
            next = n;
    return next;
}

static void write_point(FILE *file, const struct csv_table *t, int row,
                        const struct axis axis[2])
{
    const double error = number(t, row, error_key), side = number(t, row, "side"),
                 across = number(t, row, "across");

    fprintf(file, "<circle r=\"4\" cx=\"%.1f\" cy=\"%.1f\">",
            place(&axis[0], seconds_of(t, row)), place(&axis[1], error));
    html_print(file, "<title>%s, %gx%g points, step %g s: %g %% in %g s</title></circle>",
               csv_words(t, row, csv_column(t, "title")), side,
               isnan(across) ? side : across, number(t, row, "step_s"), 100 * error,
               seconds_of(t, row));
}

/* Writes the line of a contestant through the runs of its front. */
static void write_line(FILE *file, const struct csv_table *t, const struct report_run *best,
                       const struct axis axis[2], const char *colour)
{
    fprintf(file, "<g fill=\"%s\"><path fill=\"none\" stroke=\"%s\" d=\"", colour, colour);
    for (int n = next_run(t, best, -1), first = n; n >= 0; n = next_run(t, best, n))
        fprintf(file, "%c%.1f %.1f", n == first ? 'M' : 'L',
                place(&axis[0], seconds_of(t, n)),
                place(&axis[1], number(t, n, error_key)));
    fputs("\"/>", file);
    for (int n = next_run(t, best, -1); n >= 0; n = next_run(t, best, n))
        write_point(file, t, n, axis);
    fputs("</g>\n", file);
}

static void write_legend(FILE *file, const struct report_run *best, const char *colour,
                         bool links)
{
    const struct contestant *who;
    struct message why;

    html_print(file, "<span class=\"key\"><b style=\"color:%s\">&#9679;</b> ", colour);
    if (links && contestant_find(best->contestant, &who, &why) == STATUS_OK)
        html_print(file, "<a href=\"contestant_%s.html\">%s</a></span>\n", who->name,
                   best->title);
    else
        html_print(file, "%s</span>\n", best->title);
}

static void write_bar(FILE *file, const struct axis *y, double bar)
{
    if (!(bar > 0) || log10(bar) <= y->low || log10(bar) >= y->high)
        return;
    const double at = place(y, bar);
    fprintf(file,
            "<path class=\"bar\" d=\"M%d %.1fH%d\"/><text x=\"%d\" y=\"%.1f\">the truth is "
            "known no better than this</text>\n",
            LEFT, at, RIGHT, LEFT + 6, at - 5);
}

static void write_chart(FILE *file, const struct csv_table *t,
                        const struct report_run *best, int models, double bar, bool links)
{
    struct axis axis[2] = {{INFINITY, -INFINITY, {LEFT, RIGHT}},
                           {INFINITY, -INFINITY, {BOTTOM, TOP}}};
    char colour[32];

    for (int n = 0; n < models; n++)
        for (int row = 0; row < t->rows; row++)
            if (is_front(t, row, &best[n])) {
                widen(&axis[0], number(t, row, "seconds"));
                widen(&axis[1], number(t, row, error_key));
            }
    if (!(axis[0].low < axis[0].high && axis[1].low < axis[1].high))
        return;
    html_print(file,
               "<p>Error (RMSE over the length at the worst time) against seconds: the "
               "best contestant of each model. Lower is more accurate, further left is "
               "faster.</p>\n<svg class=\"chart\" viewBox=\"0 0 %d %d\" role=\"img\" "
               "aria-label=\"error against seconds\">\n",
               WIDTH, HEIGHT);
    write_axis(file, &axis[0], true);
    write_axis(file, &axis[1], false);
    for (int n = 0; n < models; n++) {
        snprintf(colour, sizeof colour, "hsl(%d 65%% 45%%)", 360 * n / models);
        write_line(file, t, &best[n], axis, colour);
    }
    write_bar(file, &axis[1], bar);
    fputs("</svg>\n<p class=\"soft\">", file);
    for (int n = 0; n < models; n++) {
        snprintf(colour, sizeof colour, "hsl(%d 65%% 45%%)", 360 * n / models);
        write_legend(file, &best[n], colour, links);
    }
    fputs("</p>\n", file);
}

enum status site_chart_write(FILE *file, const struct csv_table *runs, double bar,
                             bool links)
{
    struct report_run *best = malloc(((size_t)runs->rows + 1) * sizeof *best);

    if (!best)
        return STATUS_MEMORY;
    write_chart(file, runs, best, report_summary_best(runs, best), bar, links);
    free(best);
    return STATUS_OK;
}
