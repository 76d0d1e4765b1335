/* The tables and charts of compare.h. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/compare/compare.h"
#include "bench/ui/chart.h"

static const double targets[] = {0.1, 0.03, 0.01, 0.001};
enum { TARGETS = sizeof targets / sizeof *targets };

/* Rows of the contestant whose first row is this one. */
static int length(const struct compare *c, int first)
{
    int count = 1;

    while (first + count < c->count &&
           c->rows[first + count].at.contestant == c->rows[first].at.contestant)
        count++;
    return count;
}

/* Of a contestant's rows: the one nearest to the truth; NULL if none lived. */
static const struct compare_row *nearest(const struct compare_row *rows, int count)
{
    const struct compare_row *best = NULL;

    for (int n = 0; n < count; n++)
        if (!isnan(rows[n].worst) && (!best || rows[n].worst < best->worst))
            best = &rows[n];
    return best;
}

static double bar_of(const struct compare *c)
{
    double bar = 0;

    for (int n = 0; n < c->truth->times; n++)
        bar = fmax(bar, c->truth->error[n] / c->scene->length);
    return bar;
}

/* No run of its contestant is cheaper and as good: the line a plot draws. */
static bool on_front(const struct compare *c, const struct compare_row *r)
{
    for (const struct compare_row *k = c->rows; k < c->rows + c->count; k++)
        if (k->at.contestant == r->at.contestant && k->worst <= r->worst &&
            k->seconds < r->seconds)
            return false;
    return !isnan(r->worst);
}

enum { FIXED = 12, MOST_COLUMNS = FIXED + COMPARE_TIMES + 3 };

/* What a table borrows. */
struct words {
    char header[COMPARE_TIMES][32], key[COMPARE_TIMES][48], caption[256];
};

static struct table *create_runs(const struct compare *c, struct words *w)
{
    struct table_column columns[MOST_COLUMNS] = {
        {"model", NULL, TABLE_LEFT, .key = "title"},
        {"contestant", NULL, TABLE_LEFT, .readers = TABLE_MACHINES},
        {"model", NULL, TABLE_LEFT, .key = "model", .readers = TABLE_MACHINES},
        {"side", .readers = TABLE_MACHINES},
        {"net", NULL, TABLE_LEFT, .readers = TABLE_PEOPLE},
        {"step", "ms", .key = "step_s", .key_unit = "s", .scale = 1e3},
        {"iterations"},
        {"unknowns"},
        {"set-up", "ms", .key = "setup_s", .key_unit = "s", .scale = 1e3},
        {"stepping", "s"},
        {"repeats"},
        {"set-up and stepping", "s", .key = "seconds", .readers = TABLE_MACHINES}};
    const struct table_column more[] = {
        {"RMSE / L at the worst time", NULL, .key = "worst_rmse_over_length",
         .readers = TABLE_MACHINES},
        {"front", .readers = TABLE_MACHINES},
        {"outcome", NULL, TABLE_LEFT, .readers = TABLE_MACHINES}};
    int count = FIXED;

    for (int n = 0; n < c->truth->times; n++) {
        snprintf(w->header[n], sizeof w->header[n], "%s%.3g s", n ? "" : "RMSE/L ",
                 c->truth->time[n]);
        snprintf(w->key[n], sizeof w->key[n], "rmse_over_length_%.3g_s", c->truth->time[n]);
        columns[count++] = (struct table_column){w->header[n], "%", .key = w->key[n],
                                                 .key_unit = "1", .scale = 100};
    }
    for (size_t n = 0; n < sizeof more / sizeof *more; n++)
        columns[count++] = more[n];
    snprintf(w->caption, sizeof w->caption, "Every run on %s (Gamma = %.4g, %s)",
             c->scene->name, scene_gamma(c->scene), c->physics);
    return table_create(count, columns, w->caption);
}

static void add_run(struct table *t, const struct compare *c, const struct compare_row *r)
{
    const struct contestant *who = r->at.contestant;
    const bool ran = !run_result_refused(&r->result);

    table_row(t);
    table_text(t, "%s", who->title);
    table_text(t, "%s", who->name);
    table_text(t, "%s", who->model->name);
    table_integer(t, r->at.side);
    table_text(t, "%dx%d", r->at.side, r->at.side);
    table_number(t, c->scene->step / r->at.divisor, 3);
    table_fixed(t, r->at.iterations ? r->at.iterations : NAN, 0);
    table_fixed(t, ran ? r->result.unknowns : NAN, 0);
    table_number(t, ran ? r->result.create.median : NAN, 3);
    table_number(t, ran ? r->result.step.median * (double)r->result.steps : NAN, 3);
    table_fixed(t, ran ? r->result.step.count : NAN, 0);
    table_number(t, ran ? r->seconds : NAN, 3);
    for (int n = 0; n < c->truth->times; n++)
        table_number(t, r->error[n], 3);
    table_number(t, r->worst, 3);
    table_integer(t, on_front(c, r));
    table_text(t, "%s", r->result.sentence.text);
    if (!ran)
        table_note(t, "%s, %dx%d: %s.", who->title, r->at.side, r->at.side,
                   r->result.sentence.text);
    else if (r->result.outcome)
        table_note(t, "%s, %dx%d, step %.3g ms: %s.", who->title, r->at.side, r->at.side,
                   1e3 * c->scene->step / r->at.divisor, r->result.sentence.text);
}

static void add_bar(struct table *t, const struct truth *truth, double length)
{
    table_rule(t);
    table_row(t);
    table_text(t, "truth's error bar");
    for (int n = 1; n < FIXED; n++)
        table_dash(t);
    for (int n = 0; n < truth->times; n++)
        table_number(t, truth->error[n] / length, 3);
    table_note(t, "Truth: %s. One thread; seconds are medians of the repeats.",
               truth->source);
}

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
static struct chart *create(const struct compare *c, const struct table *runs,
                            const char *of)
{
    const struct truth *truth = c->truth;
    char title[256];
    struct chart_axis x = chart_axis_of(runs, "seconds", true);
    struct chart_axis y = chart_axis_of(runs, "worst_rmse_over_length", true);
    double low = INFINITY, high = 0, error = bar_of(c), most = error;

    for (int n = 0; n < c->count; n++)
        if (!isnan(c->rows[n].worst)) {
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

/* The first row of the contestant of a model that comes nearest to the truth; -1: none. */
static int best_of(const struct compare *c, const struct model *model)
{
    const struct compare_row *best = NULL;
    int found = -1;

    for (int n = 0; n < c->count; n += length(c, n)) {
        const struct compare_row *r = nearest(&c->rows[n], length(c, n));
        if (c->rows[n].at.contestant->model == model && r &&
            (!best || r->worst < best->worst))
            best = r, found = n;
    }
    return found;
}

static struct chart *chart_best(const struct compare *c, const struct table *runs)
{
    struct chart *chart = create(c, runs, "of each model's best contestant");
    const struct model *model;

    chart_band(chart, "truth's error bar", 0, bar_of(c));
    for (int m = 0, lines = 0; (model = contestant_model(m)); m++) {
        const int n = best_of(c, model);
        if (n < 0 || lines++ == CHART_LINES_MOST)
            continue;
        const struct contestant *who = c->rows[n].at.contestant;
        add_series(chart, runs, who->title, who->name, lines);
    }
    return chart;
}

static struct chart *chart_models(const struct compare *c, const struct table *runs)
{
    struct chart *chart = create(c, runs, "of each contestant");
    const struct model *model;
    int colour = 0;

    for (int m = 0; (model = contestant_model(m)); m++) {
        int lines = 0;
        for (int n = 0; n < c->count; n += length(c, n)) {
            const struct contestant *who = c->rows[n].at.contestant;
            if (who->model != model || lines == CHART_LINES_MOST)
                continue;
            if (!lines++) {
                chart_panel(chart, model->title);
                chart_band(chart, "truth's error bar", 0, bar_of(c));
            }
            add_series(chart, runs, who->title, who->name, ++colour);
        }
    }
    return chart;
}

static enum status draw(const struct compare *c, const struct table *runs,
                        const char *folder, struct message *why)
{
    enum status st;

    TRY(chart_save(chart_best(c, runs), folder, "compare", why));
    TRY(chart_save(chart_models(c, runs), folder, "compare_models", why));
out:
    return st;
}

static enum status print_runs(const struct compare *c, const char *folder,
                              enum table_format format, FILE *file, struct message *why)
{
    struct words words;
    struct table *t = create_runs(c, &words);
    enum status st;

    for (int n = 0; n < c->count; n++) {
        if (n && c->rows[n].at.contestant != c->rows[n - 1].at.contestant)
            table_rule(t);
        add_run(t, c, &c->rows[n]);
    }
    TRY(table_save(t, folder, "compare", why));
    TRY(draw(c, t, folder, why));
    add_bar(t, c->truth, c->scene->length);
out:
    if (st == STATUS_OK)
        return table_finish(t, format, file);
    table_destroy(t);
    return st;
}

/* Of one contestant: the cheapest run within `target`, NULL if there is none. */
static const struct compare_row *cheapest(const struct compare_row *rows, int count,
                                          double target)
{
    const struct compare_row *best = NULL;

    for (int n = 0; n < count; n++)
        if (rows[n].worst <= target && (!best || rows[n].seconds < best->seconds))
            best = &rows[n];
    return best;
}

/* The dearest run and one with the next coarser net at the same step: does refinement still
 * help? A floor is where the finer net takes off less than a quarter. */
static const char *floor_of(const struct compare *c, const struct compare_row *rows,
                            int count)
{
    static const double STILL_FALLING = 0.75;
    const struct compare_row *fine = &rows[count - 1], *coarse = NULL;
    const double bar = bar_of(c);

    for (int n = 0; n < count - 1; n++)
        if (rows[n].at.divisor == fine->at.divisor &&
            rows[n].at.iterations == fine->at.iterations)
            coarse = &rows[n];
    if (isnan(fine->worst))
        return run_result_refused(&fine->result) ? "the finest net is refused"
                                                 : "the finest run died";
    if (fine->worst < 2 * bar)
        return "down to the truth's error bar";
    if (!coarse || isnan(coarse->worst))
        return "one net only";
    if (fine->worst < STILL_FALLING * coarse->worst)
        return "still falling with the net";
    return fine->worst > coarse->worst / STILL_FALLING ? "grows with the net: a floor"
                                                       : "a floor: finer nets do not help";
}

static void add_reach(struct table *t, const struct compare *c,
                      const struct compare_row *rows, int count)
{
    const struct compare_row *best = nearest(rows, count);

    table_row(t);
    table_text(t, "%s", rows->at.contestant->title);
    for (int n = 0; n < TARGETS; n++) {
        const struct compare_row *r = cheapest(rows, count, targets[n]);
        if (r)
            table_number(t, r->seconds, 3);
        else
            table_missing(t, "not reached");
    }
    if (!best) {
        table_dash(t);
        table_dash(t);
        table_text(t, "%s",
                   run_result_refused(&rows->result) ? "not applicable" : "every run died");
        return;
    }
    table_number(t, best->worst, 3);
    table_text(t, "%dx%d", best->at.side, best->at.side);
    table_text(t, "%s", floor_of(c, rows, count));
}

static enum status print_reach(const struct compare *c, enum table_format format,
                               FILE *file)
{
    static const struct table_column columns[] = {
        {"model", NULL, TABLE_LEFT},
        {"10 %", "s"},
        {"3 %", "s"},
        {"1 %", "s"},
        {"0.1 %", "s"},
        {"lowest", "% L", .key = "lowest_rmse_over_length", .key_unit = "1", .scale = 100},
        {"at", NULL, TABLE_LEFT},
        {"floor", NULL, TABLE_LEFT}};
    struct table *t = table_create(
        sizeof columns / sizeof *columns, columns,
        "Seconds (set-up and stepping) to an RMSE/L, at the worst of the times");

    for (int n = 0; n < c->count; n += length(c, n))
        add_reach(t, c, c->rows + n, length(c, n));
    return table_finish(t, format, file);
}

enum status compare_print(const struct compare *c, const char *folder,
                          enum table_format format, FILE *file, struct message *why)
{
    const enum status st = print_runs(c, folder, format, file, why);

    return st == STATUS_OK ? print_reach(c, format, file) : st;
}
