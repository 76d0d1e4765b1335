/* The charts of compare.h. */
#include <math.h>
#include <stdio.h>

#include "bench/compare/compare.h"
#include "bench/ui/chart.h"

/* A line through the best runs of a contestant, and its others as open points. */
static void add_series(struct chart *c, const struct table *runs, const char *label,
                       const char *contestant, int colour)
{
    const struct chart_where where[] = {{"contestant", contestant}, {"front", NULL, 1}};

    chart_series(c, &(struct chart_series){label, .sorted = true, .colour = colour});
    chart_rows(c, runs, "seconds", "worst_rmse_over_length", 2, where);
    chart_series(
        c, &(struct chart_series){NULL, CHART_POINTS, .colour = colour, .second = true});
    chart_rows(c, runs, "seconds", "worst_rmse_over_length", 1, where);
}

/* All panels with the same axes, so that they can be compared; the bar is on them. */
static struct chart *create(const struct contest *c, const struct table *runs,
                            const char *of)
{
    const struct truth *truth = c->truth;
    char title[256];
    struct chart_axis x = chart_axis_of(runs, "seconds", true);
    struct chart_axis y = chart_axis_of(runs, "worst_rmse_over_length", true);
    double low = INFINITY, high = 0, error = contest_largest_bar(c), most = error;

    for (int n = 0; n < c->count; n++)
        if (!c->rows[n].probe && !isnan(c->rows[n].worst)) {
            low = fmin(low, c->rows[n].seconds);
            high = fmax(high, c->rows[n].seconds);
            error = fmin(error, c->rows[n].worst);
            most = fmax(most, c->rows[n].worst);
        }
    if (high > low)
        x.low = pow(10, floor(log10(low))), x.high = pow(10, ceil(log10(high)));
    y.low = error / 2, y.high = pow(10, ceil(log10(most)));
    snprintf(title, sizeof title, "%s to %g s, Gamma = %.4g; lines join the best runs %s",
             c->scene->name, truth->time[truth->times - 1], scene_gamma(c->scene), of);
    struct chart *chart = chart_create(title);
    chart_axes(chart, &x, &y);
    return chart;
}

/* The contestant of a model that comes nearest to the truth; NULL: none lived. */
static const struct contestant *best_of(const struct contest *c, const struct model *model)
{
    const struct contest_row *best = NULL;
    const struct contestant *who;

    for (int k = 0; (who = contest_entrant(c, k)); k++) {
        const struct contest_row *r = contest_nearest(c, who);
        if (who->model == model && r && (!best || r->worst < best->worst))
            best = r;
    }
    return best ? best->at.contestant : NULL;
}

static struct chart *chart_best(const struct contest *c, const struct table *runs)
{
    struct chart *chart = create(c, runs, "of each model's best contestant");
    const struct model *model;

    chart_band(chart, "truth's error bar", 0, contest_largest_bar(c));
    for (int m = 0, lines = 0; (model = contestant_model(m)); m++) {
        const struct contestant *who = best_of(c, model);
        if (!who || lines++ == CHART_LINES_MOST)
            continue;
        add_series(chart, runs, who->title, who->name, lines);
    }
    return chart;
}

static struct chart *chart_models(const struct contest *c, const struct table *runs)
{
    struct chart *chart = create(c, runs, "of each contestant");
    const struct model *model;
    int colour = 0;

    for (int m = 0; (model = contestant_model(m)); m++) {
        int lines = 0;
        const struct contestant *who;
        for (int k = 0; (who = contest_entrant(c, k)); k++) {
            if (who->model != model || lines == CHART_LINES_MOST)
                continue;
            if (!lines++) {
                chart_panel(chart, model->title);
                chart_band(chart, "truth's error bar", 0, contest_largest_bar(c));
            }
            add_series(chart, runs, who->title, who->name, ++colour);
        }
    }
    return chart;
}

enum status compare_chart(const struct contest *c, const struct table *runs,
                          const char *folder, struct message *why)
{
    enum status st;

    TRY(chart_save(chart_best(c, runs), folder, "compare", why));
    TRY(chart_save(chart_models(c, runs), folder, "compare_models", why));
out:
    return st;
}
