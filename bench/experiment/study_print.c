#include "bench/experiment/study.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "bench/ui/chart.h"
#include "bench/ui/picture.h"

enum { PATH = 4096 };

/* The next cells of a row: a number for each digit, to so many significant ones. */
static void print_numbers(struct table *t, const char *digits, const double *value)
{
    for (; *digits; digits++)
        table_number(t, *value++, *digits - '0');
}

/* Other people's milliseconds are those of their own scheme, which has no truth. */
static double paper_of(const struct study *s, int level)
{
    return s->plan->truth ? NAN : s->row[level].paper_ms;
}

/* NaN: at rest. */
static double time_of(const struct study *s, int frame)
{
    return s->time ? s->time[frame] : NAN;
}

static enum status print_cost(const struct study *s, enum table_format format, FILE *file)
{
    static const struct table_column columns[] = {
        {"level", NULL, TABLE_LEFT},  {"unknowns", NULL, 0}, {"factor", "entries", 0},
        {"a frame", "ms", 0},         {"paper", "ms", 0},    {"stepping", "s", 0},
        {"outcome", NULL, TABLE_LEFT}};
    char caption[256];

    snprintf(caption, sizeof caption, "%s: cost", s->plan->caption);
    struct table *t = table_create(sizeof columns / sizeof *columns, columns, caption);
    for (int n = 0; n < s->plan->level_count; n++) {
        const struct study_row *row = &s->row[n];
        const bool refused = run_result_refused(&row->result);
        table_row(t);
        table_text(t, "%s", row->level->label);
        if (refused)
            table_note(t, "%s: %s.", row->level->label, row->result.sentence.text);
        table_fixed(t, refused ? NAN : row->result.unknowns, 0);
        table_fixed(t, refused ? NAN : row->result.factor_entries, 0);
        table_number(t, row->milliseconds, 3);
        table_number(t, paper_of(s, n), 4);
        table_number(t, refused ? NAN : row->seconds, 3);
        table_text(t, "%s", refused ? "refused" : row->result.sentence.text);
    }
    if (s->time)
        table_note(t,
                   "A frame: median over repeats, one thread; factor: numbers stored in "
                   "it; stepping: all frames to %g s at that price.",
                   s->time[s->frames - 1]);
    else
        table_note(t, "A frame: the static equilibrium, median over repeats, one thread; "
                      "factor: numbers stored in it.");
    return table_finish(t, format, file);
}

static double bar_of(const struct study *s, int time)
{
    return s->truth ? s->truth->error[time] / s->length : NAN;
}

/* A level at a time; n: all levels: the truth's own numbers, below them. */
static void motion_row(struct table *t, const struct study *s, int n, int time)
{
    const bool truth = n == s->plan->level_count;
    const struct study_row *row = truth ? NULL : &s->row[n];
    const struct study_frame *f = truth ? &s->true_frame[time] : &row->frame[time];
    const bool ran = row && !run_result_refused(&row->result);

    table_row(t);
    table_fixed(t, time_of(s, time), 3);
    table_text(t, "%s", truth ? "truth" : row->level->label);
    table_number(t, truth ? NAN : row->level->size, 3);
    table_number(t, time_of(s, time), 3);
    table_fixed(t, ran ? row->result.unknowns : NAN, 0);
    table_fixed(t, ran ? row->result.factor_entries : NAN, 0);
    table_number(t, truth ? NAN : row->milliseconds, 3);
    table_number(t, truth ? NAN : paper_of(s, n), 4);
    table_number(t, truth ? NAN : row->seconds, 3);
    for (int k = 0; k < 3 && truth; k++)
        table_missing(t, "%s", "");
    if (truth)
        table_number(t, bar_of(s, time), 2);
    else
        print_numbers(t, "333", (double[]){f->next, f->finest, f->error});
    if (!truth)
        table_missing(t, "%s", "");
    table_number(t, truth ? 0 : f->error, 3);
    table_number(t, bar_of(s, time), 2);
    print_numbers(t, "33443",
                  (double[]){f->roughness, f->inner, f->stretch, f->drop, f->unevenness});
}

/* A row for each time and level, and one for the truth. */
static struct table *motion_of(const struct study *s)
{
    const enum table_readers with_truth = s->truth ? TABLE_PEOPLE : TABLE_NOBODY;
    const struct table_column columns[] = {
        {"t", "s", .readers = s->time ? TABLE_PEOPLE : TABLE_NOBODY},
        {"level", NULL, TABLE_LEFT},
        {"size", .readers = TABLE_MACHINES},
        {"time", "s", .readers = TABLE_MACHINES},
        {"unknowns", .readers = TABLE_MACHINES},
        {"factor entries", .readers = TABLE_MACHINES},
        {"frame", "ms", .readers = TABLE_MACHINES},
        {"paper", "ms", .readers = TABLE_MACHINES},
        {"stepping", "s", .readers = TABLE_MACHINES},
        {"to next", "L"},
        {"to finest", "L"},
        {"error", "L", .key = "shown_error", .readers = with_truth},
        {"error bar", "L", .key = "shown_bar", .readers = with_truth},
        {"error", "L", .readers = TABLE_MACHINES},
        {"error bar", "L", .readers = TABLE_MACHINES},
        {"roughness"},
        {"inner", .key = "inner_roughness"},
        {"stretch"},
        {"drop", "L"},
        {"unevenness"}};
    struct table *t =
        table_create(sizeof columns / sizeof *columns, columns, s->plan->caption);

    for (int time = 0; time < s->frames; time++) {
        if (time)
            table_rule(t);
        for (int n = 0; n < s->plan->level_count + (s->truth != NULL); n++)
            motion_row(t, s, n, time);
    }
    return t;
}

static void note_motion(struct table *t, const struct study *s)
{
    for (int time = 0; time < s->frames; time++) {
        double order = study_order(s, time);
        if (isnan(order))
            continue;
        if (s->time)
            table_note(t, "Observed order at %g s: %.2g, of the %s.", s->time[time], order,
                       s->truth ? "error" : "difference from the finest");
        else
            table_note(t, "Observed order: %.2g, of the difference from the finest.",
                       order);
    }
    table_note(
        t,
        "To next, to finest: RMSE on the material grid to the next level and to the "
        "last. Roughness: L times the rms curvature; unevenness: its rms change over "
        "it, per length (metric.h). Gamma = %.4g.",
        s->gamma);
    if (s->truth)
        table_note(t, "Truth: %s.", s->truth->source);
    else if (s->plan->truth)
        table_note(t, "Truth: none; %s.", s->no_truth.text);
}

/* A line for each time, error (without truth: to the finest) against seconds. */
static struct chart *chart_of(const struct study *s)
{
    const struct chart_axis x = {"stepping", "s", .log = true};
    const struct chart_axis y = {
        s->truth ? "RMSE to truth / L" : "RMSE to the finest level / L", .log = true};
    struct chart *c = chart_create(s->plan->caption);

    chart_axes(c, &x, &y);
    for (int time = 0; time < s->frames; time++) {
        char label[32];
        snprintf(label, sizeof label, "%g s", time_of(s, time));
        chart_series(
            c, &(struct chart_series){s->time ? label : "at rest", .colour = time + 1});
        for (int n = 0; n < s->plan->level_count; n++) {
            const struct study_frame *f = &s->row[n].frame[time];
            chart_point(c, s->row[n].seconds, s->truth ? f->error : f->finest);
        }
    }
    if (s->truth)
        chart_band(c, "truth's error bar", 0, bar_of(s, s->frames - 1));
    for (int n = 0; n < s->plan->level_count; n++) {
        const struct study_row *row = &s->row[n];
        chart_mark(c, row->seconds, s->truth ? row->frame[0].error : row->frame[0].finest,
                   row->level->label);
    }
    return c;
}

enum status study_print_sheets(const struct study *s, const char *folder,
                               struct message *why)
{
    enum { MOST = PLAN_STUDY_TIMES * (PLAN_STUDY_LEVELS + 1) };
    struct picture_panel panels[MOST];
    char titles[MOST][96], name[PATH], when[32] = "at rest";
    const int columns = s->plan->level_count + (s->truth != NULL);
    int count = 0;

    for (int time = 0; time < s->frames; time++)
        for (int n = 0; n < columns; n++, count++) {
            const bool level = n < s->plan->level_count;
            const double *xyz = level ? s->row[n].frame[time].xyz : s->truth->xyz[time];
            if (s->time)
                snprintf(when, sizeof when, "t = %g s", s->time[time]);
            snprintf(titles[count], sizeof titles[count], "%.50s\n%s%s",
                     level ? s->row[n].level->label : "truth", xyz ? "" : "none left at ",
                     when);
            panels[count] = (struct picture_panel){titles[count], xyz};
        }
    snprintf(name, sizeof name, "%s_sheets", s->plan->name);
    return picture_save(folder, name, columns, count, panels, why);
}

enum status study_print(const struct study *s, const char *folder, enum table_format format,
                        FILE *file, struct message *why)
{
    struct table *t = motion_of(s);
    struct chart *chart = chart_of(s);
    enum status st;

    note_motion(t, s);
    TRY(print_cost(s, format, file));
    st = table_publish(t, folder, s->plan->name, format, file, why);
    t = NULL;
    TRY(st);
    st = chart_save(chart, folder, s->plan->name, why);
    chart = NULL;
    TRY(st);
    TRY(study_print_sheets(s, folder, why));
out:
    table_destroy(t);
    chart_destroy(chart);
    return st;
}

enum status study_print_all(const struct study_results *r, const char *folder,
                            enum table_format format, FILE *file, struct message *why)
{
    enum status st = STATUS_OK;

    for (int n = 0; n < r->count && st == STATUS_OK; n++)
        st = study_print(&r->study[n], folder, format, file, why);
    return st;
}
