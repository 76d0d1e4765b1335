#include <math.h>
#include <stdio.h>
#include <string.h>

#include "bench/compare/compare.h"
#include "bench/ui/chart.h"

/* --- charts --- */

/* Adds the runs of a contestant, or the best of them only. */
static void add_points(struct chart *chart, const struct contest *c,
                       const struct contestant *who, bool front)
{
    for (const struct contest_row *r = c->rows; r < c->rows + c->count; r++)
        if (r->at.contestant == who && (!front || contest_on_front(c, r)))
            chart_point(chart, r->seconds, r->worst);
}

/* Adds a line through the best runs of a contestant, and its others as open points. */
static void add_series(struct chart *chart, const struct contest *c,
                       const struct contestant *who, int colour)
{
    chart_series(chart,
                 &(struct chart_series){who->title, .sorted = true, .colour = colour});
    add_points(chart, c, who, true);
    chart_series(chart, &(struct chart_series){NULL, CHART_POINTS, .colour = colour,
                                               .second = true});
    add_points(chart, c, who, false);
}

/* Creates a chart whose panels have the same axes, so that they can be compared; they hold
 * all runs and the bar. */
static struct chart *create_chart(const struct contest *c, const char *of)
{
    const struct truth *truth = c->truth;
    char title[256];
    struct chart_axis x = {"set-up and stepping", "s", .log = true};
    struct chart_axis y = {"RMSE / L at the worst time", .log = true};
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

/* Finds the contestant of a model that comes nearest to the truth; NULL: none lived. */
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

/* Draws a line for each model's best contestant or, with a panel a model, for all. */
static struct chart *draw(const struct contest *c, bool all)
{
    struct chart *chart =
        create_chart(c, all ? "of each contestant" : "of each model's best contestant");
    const struct model *model;
    const struct contestant *who;
    int colour = 0, lines = 0;

    if (!all)
        chart_band(chart, "truth's error bar", 0, contest_largest_bar(c));
    for (int m = 0; (model = contestant_model(m)); m++) {
        const struct contestant *best = best_of(c, model);
        lines = all ? 0 : lines;
        for (int k = 0; (who = contest_entrant(c, k)); k++) {
            if (who->model != model || !(all || who == best) || lines == CHART_LINES_MOST)
                continue;
            if (all && !lines) {
                chart_panel(chart, model->title);
                chart_band(chart, "truth's error bar", 0, contest_largest_bar(c));
            }
            lines++;
            add_series(chart, c, who, ++colour);
        }
    }
    return chart;
}

/* --- all runs --- */

enum { FIXED = 15, MOST_COLUMNS = FIXED + CONTEST_TIMES + 3 };

/* Strings that the columns of the table of runs borrow. */
struct words {
    char header[CONTEST_TIMES][32], key[CONTEST_TIMES][48], caption[256];
};

static struct table *create_runs(const struct contest *c, struct words *w)
{
    struct table_column columns[MOST_COLUMNS] = {
        {"title", NULL, TABLE_LEFT, .readers = TABLE_MACHINES},
        {"model", NULL, TABLE_LEFT, .key = "column", .readers = TABLE_PEOPLE},
        {"contestant", NULL, TABLE_LEFT, .readers = TABLE_MACHINES},
        {"model", NULL, TABLE_LEFT, .key = "model", .readers = TABLE_MACHINES},
        {"side", .readers = TABLE_MACHINES},
        {"across", .readers = TABLE_MACHINES},
        {"net", NULL, TABLE_LEFT, .readers = TABLE_PEOPLE},
        {"step", "ms", .key = "step_s", .key_unit = "s", .scale = 1e3},
        {"iterations"},
        {"unknowns"},
        {"set-up", "ms", .key = "setup_s", .key_unit = "s", .scale = 1e3},
        {"stepping", "s"},
        {"repeats"},
        {"memory", "MB", .key = "model_bytes", .key_unit = "B", .scale = 1e-6},
        {"set-up and stepping", "s", .key = "seconds", .readers = TABLE_MACHINES}};
    const struct table_column more[] = {
        {"RMSE / L at the worst time", NULL, .key = "worst_rmse_over_length",
         .readers = TABLE_MACHINES},
        {"front", .readers = TABLE_MACHINES},
        {"outcome", NULL, TABLE_LEFT, .readers = TABLE_MACHINES}};
    int count = FIXED;

    for (int n = 0; n < c->truth->times; n++) {
        snprintf(w->header[n], sizeof w->header[n], "%.3g s", c->truth->time[n]);
        snprintf(w->key[n], sizeof w->key[n], "rmse_over_length_%.3g_s", c->truth->time[n]);
        columns[count++] = (struct table_column){w->header[n], "%", .key = w->key[n],
                                                 .key_unit = "1", .scale = 100};
    }
    for (size_t n = 0; n < sizeof more / sizeof *more; n++)
        columns[count++] = more[n];
    snprintf(w->caption, sizeof w->caption,
             "Every run on %s (Gamma = %.4g, %s): RMSE/L at %d times", c->scene->name,
             scene_gamma(c->scene), c->physics, c->truth->times);
    return table_create(count, columns, w->caption);
}

static void note_end(struct table *t, const struct contest *c, const struct contest_row *r)
{
    const char *title = r->at.contestant->title;
    const int side = r->at.size[CONTEST_NET], across = r->at.size[CONTEST_ACROSS];

    if (run_result_refused(&r->result))
        table_note(t, "%s, %dx%d: %s.", title, side, across, r->result.sentence.text);
    else if (r->result.outcome)
        table_note(t, "%s, %dx%d, step %.3g ms: %s.", title, side, across,
                   1e3 * c->scene->step / r->at.size[CONTEST_STEP],
                   r->result.sentence.text);
}

static void add_net(struct table *t, const struct contest *c, const int size[CONTEST_AXES])
{
    table_add(t, "%d|%d|%dx%d|%.3g|%.0f", size[CONTEST_NET], size[CONTEST_ACROSS],
              size[CONTEST_NET], size[CONTEST_ACROSS], c->scene->step / size[CONTEST_STEP],
              size[CONTEST_ITERATIONS] ? size[CONTEST_ITERATIONS] : NAN);
}

static void add_run(struct table *t, const struct contest *c, const struct contest_row *r)
{
    const struct contestant *who = r->at.contestant;
    const bool ran = !run_result_refused(&r->result), timed = ran && !r->probe;

    table_line(t, "%s|%s|%s|%s", who->title, who->column, who->name, who->model->name);
    add_net(t, c, r->at.size);
    table_add(t, "%.0f|%.3g|%.3g|%.0f|%.2g|%.3g", ran ? r->result.unknowns : NAN,
              timed ? r->result.create.median : NAN,
              timed ? r->result.step.median * (double)r->result.steps : NAN,
              timed ? r->result.step.count : NAN, timed ? r->result.bytes : NAN,
              timed ? r->seconds : NAN);
    for (int n = 0; n < c->truth->times; n++)
        table_add(t, "%.3g", r->error[n]);
    table_add(t, "%.3g|%d|%s", r->worst, contest_on_front(c, r), r->result.sentence.text);
    note_end(t, c, r);
}

static void add_bar(struct table *t, const struct contest *c)
{
    const bool known = c->truth->xyz;

    table_rule(t);
    table_line(t, "-|%s", c->truth->alone ? truth_bar_name(c->truth) : "truth's bar");
    for (int n = 2; n < FIXED; n++)
        table_add(t, "-");
    for (int n = 0; n < c->truth->times; n++)
        table_add(t, "%.3g", contest_bar(c, n));
    table_note(t,
               "Truth: %s. All runs used one thread, and seconds are medians of the "
               "repeats%s.",
               c->truth->source,
               known ? ". Runs without repeats were not timed; they only show what limits "
                       "the error"
                     : "");
    table_note(t,
               "Memory is what the model holds after its last step, counted by malloc. %s",
               contest_rule);
    if (c->budget > 0)
        table_note(
            t,
            "The budget was %g s of runs, cheap ones first, and %.3g s were used. It "
            "left out (contestant, runs): %s.",
            c->budget, contest_spent(c), *c->unsearched ? c->unsearched : "nothing");
}

static enum status print_runs(const struct contest *c, const char *folder,
                              enum table_format format, FILE *file, struct message *why)
{
    struct words words;
    struct table *t = create_runs(c, &words);
    const struct contestant *who;
    enum status st;

    for (int k = 0; (who = contest_entrant(c, k)); k++) {
        if (k)
            table_rule(t);
        for (int n = 0; n < c->count; n++)
            if (c->rows[n].at.contestant == who)
                add_run(t, c, &c->rows[n]);
    }
    TRY(table_save(t, folder, "compare", why));
    if (c->truth->xyz) {
        TRY(chart_save(draw(c, false), folder, "compare", why));
        TRY(chart_save(draw(c, true), folder, "compare_models", why));
    }
    add_bar(t, c);
out:
    if (st == STATUS_OK)
        return table_finish(t, format, file);
    table_destroy(t);
    return st;
}

/* --- for errors, and limits --- */

/* A run in five columns for machines, after one for people: "0.078 20x12/4". */
enum { RUN_COLUMNS = 6 };

/* Strings that the columns of a run borrow. */
struct run_words {
    char header[16], key[RUN_COLUMNS - 1][32];
};

/* Fills the columns of a run; a key is `before`, the word for what it holds, `after`. */
static void set_columns(struct table_column *column, struct run_words *w, const char *unit,
                        const char *value, const char *before, const char *after)
{
    const char *const what[] = {value, "side", "across", "step_s", "iterations"};

    *column++ = (struct table_column){w->header, unit, .readers = TABLE_PEOPLE};
    for (int n = 0; n < RUN_COLUMNS - 1; n++) {
        snprintf(w->key[n], sizeof w->key[n], "%s%s%s", before, what[n], after);
        *column++ =
            (struct table_column){w->key[n], .key = w->key[n], .readers = TABLE_MACHINES};
    }
}

/* Fills the cells of a run, with a value that people see `scale` times as large; r NULL:
 * there is no such run, `none`. */
static void add_shown(struct table *t, const struct contest *c, const struct contest_row *r,
                      double value, double scale, const char *none)
{
    if (!r) {
        table_missing(t, "%s", none);
        for (int n = 1; n < RUN_COLUMNS; n++)
            table_add(t, "-");
        return;
    }
    const int *size = r->at.size, iterations = size[CONTEST_ITERATIONS];
    char last[16] = "";
    if (iterations)
        snprintf(last, sizeof last, "/%d", iterations);
    table_text(t, scale * value < 99.5 ? "%.2g %dx%d/%d%s" : "%.0f %dx%d/%d%s",
               scale * value, size[CONTEST_NET], size[CONTEST_ACROSS], size[CONTEST_STEP],
               last);
    table_add(t, "%.3g|%d|%d|%.3g|%.0f", value, size[CONTEST_NET], size[CONTEST_ACROSS],
              c->scene->step / size[CONTEST_STEP], iterations ? iterations : NAN);
}

static enum status print_targets(const struct contest *c, const char *folder,
                                 enum table_format format, FILE *file, struct message *why)
{
    enum { WHO = 2, COLUMNS = WHO + CONTEST_TARGETS * RUN_COLUMNS + 1 };
    struct table_column columns[COLUMNS] = {
        {"model", NULL, TABLE_LEFT, .key = "title"},
        {"contestant", NULL, TABLE_LEFT, .readers = TABLE_MACHINES},
        [COLUMNS - 1] = {"growth", .key = "growth"}};
    struct run_words words[CONTEST_TARGETS];
    const struct contestant *who;

    for (int n = 0; n < CONTEST_TARGETS; n++) {
        char target[16];
        snprintf(words[n].header, sizeof words[n].header, "%g %%", 100 * contest_target[n]);
        snprintf(target, sizeof target, "_%g", contest_target[n]);
        set_columns(&columns[WHO + n * RUN_COLUMNS], &words[n], "s", "seconds", "", target);
    }
    struct table *t =
        table_create(COLUMNS, columns,
                     "Least seconds (set-up and stepping) to an RMSE/L at the worst of the "
                     "times, and what reaches it");
    for (int k = 0; (who = contest_entrant(c, k)); k++) {
        table_line(t, "%s|%s", who->title, who->name);
        for (int n = 0; n < CONTEST_TARGETS; n++) {
            const struct contest_row *r = contest_cheapest(c, who, contest_target[n]);
            add_shown(t, c, r, r ? r->seconds : NAN, 1, "not reached");
        }
        table_add(t, "%.2g", contest_growth(c, who));
    }
    table_note(
        t,
        "40x12/16 means 40 points along u and 12 across, and 16 steps to the scene's frame "
        "of %.3g ms; a third number counts iterations.",
        1e3 * c->scene->step);
    table_note(
        t, "Growth is the power p with which seconds grow as error^-p along the best runs "
           "(three or more).");
    return table_publish(t, folder, "compare_targets", format, file, why);
}

static void add_limit(struct table *t, const struct contest *c,
                      const struct contestant *who)
{
    const struct contest_row *best = contest_nearest(c, who);
    const struct contest_row *real =
        contest_within(c, who, c->truth->time[c->truth->times - 1]);
    const struct contest_limit limit = contest_limit(c, who);
    struct message words;

    table_line(t, "%s|%s", who->title, who->name);
    add_shown(t, c, real, real ? real->worst : NAN, 100, "none");
    add_shown(t, c, best, best ? best->worst : NAN, 100, "none");
    contest_tell(c, &limit, &words);
    table_add(t, "%s|%s", words.text, contest_kind_name[limit.kind]);
    for (int axis = 0; axis < CONTEST_AXES; axis++)
        table_add(t, "%.3g", limit.gain[axis]);
}

static enum status print_limits(const struct contest *c, const char *folder,
                                enum table_format format, FILE *file, struct message *why)
{
    enum { REAL = 2, LOWEST = REAL + RUN_COLUMNS, LIMIT = LOWEST + RUN_COLUMNS };
    static const struct table_column limit[] = {
        {"limited by", NULL, TABLE_LEFT, .key = "sentence"},
        {"limit", NULL, TABLE_LEFT, .readers = TABLE_MACHINES},
        {"net_gain", .key = "net_gain", .readers = TABLE_MACHINES},
        {"across_gain", .key = "across_gain", .readers = TABLE_MACHINES},
        {"step_gain", .key = "step_gain", .readers = TABLE_MACHINES},
        {"iterations_gain", .key = "iterations_gain", .readers = TABLE_MACHINES}};
    struct table_column columns[LIMIT + sizeof limit / sizeof *limit] = {
        {"model", NULL, TABLE_LEFT, .key = "title"},
        {"contestant", NULL, TABLE_LEFT, .readers = TABLE_MACHINES}};
    struct run_words real = {"in real time"}, lowest = {"lowest"};
    const struct contestant *who;

    set_columns(&columns[REAL], &real, "% L", "rmse_over_length", "real_time_", "");
    set_columns(&columns[LOWEST], &lowest, "% L", "rmse_over_length", "lowest_", "");
    memcpy(&columns[LIMIT], limit, sizeof limit);
    struct table *t = TABLE_OF(columns, "Lowest RMSE/L at the worst of the times, and why");
    for (int k = 0; (who = contest_entrant(c, k)); k++)
        add_limit(t, c, who);
    table_note(
        t,
        "The column `in real time` is the lowest error of runs that took no longer, set-up "
        "included, than the %.3g s that they simulate. The column `limited by` follows "
        "from "
        "repeating the most accurate run with half as many points more (in both directions "
        "if its cells are about square, else along u), with half as many more across, with "
        "half the step, or with twice the iterations, one at a time: it names the change "
        "that lowers the error most, by %.0f %% at least. `The truth` means that the error "
        "is within the truth's bar, %.2g %% at most.",
        c->truth->time[c->truth->times - 1], 100 * CONTEST_LEAST_GAIN,
        100 * contest_largest_bar(c));
    return table_publish(t, folder, "compare_limits", format, file, why);
}

/* --- more threads --- */

/* Strings that the columns of the table of threads borrow. */
struct team_words {
    char header[CONTEST_TEAMS][16], key[CONTEST_TEAMS][24], ratio[CONTEST_TEAMS][24];
};

static struct table *create_teams(const struct contest *c, struct team_words *w)
{
    struct table_column columns[9 + 2 * CONTEST_TEAMS + 1] = {
        {"model", NULL, TABLE_LEFT, .key = "title"},
        {"contestant", NULL, TABLE_LEFT, .readers = TABLE_MACHINES},
        {"side", .readers = TABLE_MACHINES},
        {"across", .readers = TABLE_MACHINES},
        {"net", .readers = TABLE_PEOPLE},
        {"step", "ms", .key = "step_s", .key_unit = "s", .scale = 1e3},
        {"iterations"},
        {"error", "%", .key = "worst_rmse_over_length", .key_unit = "1", .scale = 100},
        {"1 thread", "s", .key = "seconds_1_thread"}};
    int count = 9;

    for (int t = 0; t < c->teams; t++) {
        snprintf(w->header[t], sizeof w->header[t], "%d threads", c->team[t]);
        snprintf(w->key[t], sizeof w->key[t], "seconds_%d_threads", c->team[t]);
        snprintf(w->ratio[t], sizeof w->ratio[t], "times_%d_threads", c->team[t]);
        columns[count++] = (struct table_column){w->header[t], "s", .key = w->key[t]};
        columns[count++] = (struct table_column){"times", .key = w->ratio[t]};
    }
    columns[count++] = (struct table_column){"same bits", NULL, TABLE_LEFT};
    return table_create(count, columns,
                        "The best runs again with more threads, set-up and stepping");
}

static void add_best(struct table *t, const struct contest *c, const struct contest_row *r)
{
    table_line(t, "%s|%s", r->at.contestant->title, r->at.contestant->name);
    add_net(t, c, r->at.size);
    table_add(t, "%.2g|%.3g", r->worst, r->seconds);
    for (int n = 0; n < c->teams; n++)
        table_add(t, "%.3g|%.2g", r->team_seconds[n], r->team_seconds[n] / r->seconds);
    table_add(t, "%s", r->parted ? "no" : "yes");
}

static enum status print_teams(const struct contest *c, const char *folder,
                               enum table_format format, FILE *file, struct message *why)
{
    const struct contestant *who;
    struct team_words words;
    struct table *t = create_teams(c, &words);
    for (int k = 0; (who = contest_entrant(c, k)); k++)
        for (int n = 0; n < c->count; n++)
            if (c->rows[n].at.contestant == who && contest_is_best(c, &c->rows[n]))
                add_best(t, c, &c->rows[n]);
    if (isfinite(c->team_longest))
        table_note(
            t, "These are the runs that take up to %.2g s, as far as the budget allows.",
            c->team_longest);
    table_note(t,
               "The column `times` is the ratio to the seconds on one thread. `Same bits` "
               "means that all errors are the same numbers with every number of threads.");
    return table_publish(t, folder, "compare_threads", format, file, why);
}

enum status compare_print(const struct contest *c, const char *folder,
                          enum table_format format, FILE *file, struct message *why)
{
    enum status st;

    TRY(print_runs(c, folder, format, file, why));
    if (!c->truth->xyz)
        return st;
    TRY(print_targets(c, folder, format, file, why));
    TRY(print_limits(c, folder, format, file, why));
    if (c->teams)
        TRY(print_teams(c, folder, format, file, why));
out:
    return st;
}
