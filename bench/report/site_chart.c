#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/report/report_summary.h"
#include "bench/report/site_parts.h"
#include "bench/ui/svg_chart.h"

static const char error_key[] = "worst_rmse_over_length";

/* Returns the next run of a contestant's front behind `row`, by seconds; -1: none. */
static int next_run(const struct csv_table *t, const char *contestant, int row)
{
    const double from = row < 0 ? 0 : csv_number_of(t, row, "seconds");
    int next = -1;

    for (int n = 0; n < t->rows; n++) {
        const double seconds = csv_number_of(t, n, "seconds");
        if (!strcmp(csv_words_of(t, n, "contestant"), contestant) &&
            csv_number_of(t, n, "front") == 1 && csv_number_of(t, n, error_key) > 0 &&
            seconds > from && (next < 0 || seconds < csv_number_of(t, next, "seconds")))
            next = n;
    }
    return next;
}

/* Makes the line of a contestant through the runs of its front. */
static void make_line(struct svg_chart_line *line, const struct csv_table *t,
                      const struct report_run *best, bool links)
{
    const struct contestant *who;
    struct message why;

    *line = (struct svg_chart_line){.label = best->title};
    if (links && contestant_find(best->contestant, &who, &why) == STATUS_OK)
        snprintf(line->link, sizeof line->link, "contestant_%s.html", who->name);
    for (int n = next_run(t, best->contestant, -1);
         n >= 0 && line->count < SVG_CHART_POINTS; n = next_run(t, best->contestant, n)) {
        const double side = csv_number_of(t, n, "side"),
                     across = csv_number_of(t, n, "across");
        snprintf(line->note[line->count], SVG_CHART_WORDS, "%gx%g points, step %g s", side,
                 isnan(across) ? side : across, csv_number_of(t, n, "step_s"));
        line->xy[line->count][0] = csv_number_of(t, n, "seconds");
        line->xy[line->count++][1] = 100 * csv_number_of(t, n, error_key);
    }
}

/* Returns the count of lines, the truth's error bar from end to end first. */
static int make_lines(struct svg_chart_line *line, const struct csv_table *t,
                      const struct report_run *best, int models, double bar, bool links)
{
    struct svg_chart_line *truth = line;
    int lines = bar > 0;

    *truth = (struct svg_chart_line){.label = "the truth's error bar", .bar = true};
    truth->xy[0][0] = INFINITY, truth->xy[0][1] = truth->xy[1][1] = 100 * bar;
    truth->count = 2;
    for (int n = 0; n < models; n++) {
        struct svg_chart_line *mine = &line[lines];
        make_line(mine, t, &best[n], links);
        lines += mine->count > 0;
        if (bar > 0 && mine->count) {
            truth->xy[0][0] = fmin(truth->xy[0][0], mine->xy[0][0]);
            truth->xy[1][0] = fmax(truth->xy[1][0], mine->xy[mine->count - 1][0]);
        }
    }
    return lines > (bar > 0) ? lines : 0;
}

enum status site_chart_write(FILE *file, const struct csv_table *runs, double bar,
                             bool links)
{
    struct report_run *best = malloc(((size_t)runs->rows + 1) * sizeof *best);
    const int models = best ? report_summary_best(runs, best) : 0;
    struct svg_chart_line *line = malloc(((size_t)models + 2) * sizeof *line);

    if (best && line) {
        const int lines = make_lines(line, runs, best, models, bar, links);
        if (lines) {
            fputs("<p>Error (RMSE over the length at the worst time) against seconds: the "
                  "best contestant of each model. Lower is more accurate, further left is "
                  "faster.</p>\n",
                  file);
            svg_chart_write(NULL, "seconds", true, lines, line, file);
        }
    }
    const enum status st = best && line ? STATUS_OK : STATUS_MEMORY;
    free(best);
    free(line);
    return st;
}
