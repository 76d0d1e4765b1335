#include "bench/experiment/study_print.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "bench/ui/chart.h"
#include "bench/ui/picture.h"

enum { PATH = 4096 };

/* The paper's milliseconds are those of its own scheme, which has no truth. */
static double paper_of(const struct study *study, int level)
{
    const struct paper_cost *paper = study->levels[level].paper;

    return paper && !study->truth ? paper->milliseconds : NAN;
}

static enum status print_cost(const struct study *study, const struct study_result *r,
                              enum table_format format, FILE *file)
{
    static const struct table_column columns[] = {
        {"level", NULL, TABLE_LEFT},  {"unknowns", NULL, 0}, {"factor", "entries", 0},
        {"a frame", "ms", 0},         {"paper", "ms", 0},    {"stepping", "s", 0},
        {"outcome", NULL, TABLE_LEFT}};
    char caption[256];

    snprintf(caption, sizeof caption, "%s: cost", study->caption);
    struct table *t = table_create(sizeof columns / sizeof *columns, columns, caption);
    for (int n = 0; n < study->count; n++) {
        const struct study_row *row = &r->row[n];
        table_row(t);
        table_text(t, "%s", study->levels[n].label);
        if (*row->refused) {
            table_note(t, "%s: %s.", study->levels[n].label, row->refused);
            continue;
        }
        table_integer(t, lround(row->unknowns));
        table_integer(t, lround(row->factor_entries));
        table_number(t, row->milliseconds, 3);
        table_number(t, paper_of(study, n), 4);
        table_number(t, row->seconds, 3);
        table_text(t, "%s", row->outcome);
    }
    table_note(t,
               "A frame: median over repeats, one thread; factor: numbers stored in it; "
               "stepping: all frames to %g s at that price.",
               study->time[study->times - 1]);
    return table_finish(t, format, file);
}

/* The columns of a row that stand for a sheet at a time, the truth's or a level's. */
static void metric_cells(struct table *t, const struct study_frame *f)
{
    table_number(t, f->roughness, 3);
    table_number(t, f->inner, 3);
    table_number(t, f->stretch, 4);
    table_number(t, f->drop, 4);
    table_number(t, f->unevenness, 3);
}

static double bar_of(const struct study_result *r, int time)
{
    return r->truth ? r->truth->error[time] / r->length : NAN;
}

static void motion_row(struct table *t, const struct study *study,
                       const struct study_result *r, int n, int time)
{
    const struct study_row *row = &r->row[n];
    const struct study_frame *f = &row->frame[time];

    table_row(t);
    table_fixed(t, study->time[time], 3);
    table_text(t, "%s", study->levels[n].label);
    table_number(t, study->levels[n].size, 3);
    table_number(t, study->time[time], 3);
    table_fixed(t, row->unknowns, 0);
    table_fixed(t, row->factor_entries, 0);
    table_number(t, row->milliseconds, 3);
    table_number(t, paper_of(study, n), 4);
    table_number(t, row->seconds, 3);
    table_number(t, f->next, 3);
    table_number(t, f->finest, 3);
    table_number(t, f->error, 3);
    table_missing(t, "%s", "");
    table_number(t, f->error, 3);
    table_number(t, bar_of(r, time), 2);
    metric_cells(t, f);
}

/* The truth's own numbers, below the levels. */
static void true_row(struct table *t, const struct study *study,
                     const struct study_result *r, int time)
{
    enum { OF_LEVELS = 7 }; /* columns from size to stepping; the second is the time */

    table_row(t);
    table_fixed(t, study->time[time], 3);
    table_text(t, "truth");
    for (int n = 0; n < OF_LEVELS; n++)
        table_number(t, n == 1 ? study->time[time] : NAN, 3);
    for (int n = 0; n < 3; n++)
        table_missing(t, "%s", "");
    table_number(t, bar_of(r, time), 2);
    table_number(t, 0, 3);
    table_number(t, bar_of(r, time), 2);
    metric_cells(t, &r->true_frame[time]);
}

/* A row for each time and level, and one for the truth. */
static struct table *motion_of(const struct study *study, const struct study_result *r)
{
    const enum table_readers with_truth = r->truth ? TABLE_PEOPLE : TABLE_NOBODY;
    const struct table_column columns[] = {
        {"t", "s", .readers = TABLE_PEOPLE},
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
        table_create(sizeof columns / sizeof *columns, columns, study->caption);

    for (int time = 0; time < study->times; time++) {
        if (time)
            table_rule(t);
        for (int n = 0; n < study->count; n++)
            motion_row(t, study, r, n, time);
        if (r->truth)
            true_row(t, study, r, time);
    }
    return t;
}

static enum status print_motion(const struct study *study, const struct study_result *r,
                                enum table_format format, FILE *file)
{
    struct table *t = motion_of(study, r);

    for (int time = 0; time < study->times; time++) {
        double order = study_order(study, r, time);
        if (!isnan(order))
            table_note(t, "Observed order at %g s: %.2g, of the %s.", study->time[time],
                       order, r->truth ? "error" : "difference from the finest");
    }
    table_note(
        t,
        "To next, to finest: RMSE on the material grid to the next level and to the "
        "last. Roughness: L times the rms curvature; unevenness: its rms change over "
        "it, per length (metric.h). Gamma = %.4g.",
        r->gamma);
    if (r->truth)
        table_note(t, "Truth: %s.", r->truth->source);
    return table_finish(t, format, file);
}

enum status study_print(const struct study *study, const struct study_result *r,
                        enum table_format format, FILE *file)
{
    enum status st;

    TRY(print_cost(study, r, format, file));
    TRY(print_motion(study, r, format, file));
out:
    return st;
}

/* The truth's error bar at a time, across the levels' seconds. */
static void draw_bar(struct chart *c, const struct study *study,
                     const struct study_result *r, int time)
{
    double low = INFINITY, high = -INFINITY;

    chart_series(c, &(struct chart_series){.label = time ? NULL : "truth's error bar",
                                           .style = CHART_LINE,
                                           .colour = time + 1,
                                           .second = true});
    for (int n = 0; n < study->count; n++) {
        low = fmin(low, r->row[n].seconds);
        high = fmax(high, r->row[n].seconds);
    }
    chart_point(c, low, bar_of(r, time));
    chart_point(c, high, bar_of(r, time));
}

/* A line for each time, error (without truth: to the finest) against seconds. */
static struct chart *chart_of(const struct study *study, const struct study_result *r,
                              const struct table *t)
{
    const char *error = r->truth ? "error_over_length" : "to_finest_over_length";
    const struct chart_axis x = chart_axis_of(t, "stepping_s", true);
    const struct chart_axis y = {
        r->truth ? "RMSE to truth / L" : "RMSE to the finest level / L", .log = true};
    struct chart *c = chart_create(study->caption);

    chart_axes(c, &x, &y);
    for (int time = 0; time < study->times; time++) {
        char label[32];
        snprintf(label, sizeof label, "%g s", study->time[time]);
        chart_series(c, &(struct chart_series){label, .colour = time + 1});
        chart_rows(c, t, "stepping_s", error, 1,
                   &(struct chart_where){"time_s", .number = study->time[time]});
        if (r->truth)
            draw_bar(c, study, r, time);
    }
    for (int n = 0; n < study->count; n++) {
        const struct study_row *row = &r->row[n];
        chart_mark(c, row->seconds, r->truth ? row->frame[0].error : row->frame[0].finest,
                   study->levels[n].label);
    }
    return c;
}

/* A row for each time; the truth, if there is one, in the last column. */
static enum status draw_sheets(const struct study *study, const struct study_result *r,
                               const char *folder, struct message *why)
{
    enum { MOST = STUDY_TIMES * (STUDY_LEVELS + 1) };
    struct picture_panel panels[MOST];
    char titles[MOST][96], name[PATH];
    int columns = study->count + (r->truth != NULL), count = 0;

    for (int time = 0; time < study->times; time++)
        for (int n = 0; n < columns; n++, count++) {
            bool level = n < study->count;
            const double *xyz = level ? r->row[n].frame[time].xyz : r->truth->xyz[time];
            snprintf(titles[count], sizeof titles[count], "%s\n%st = %g s",
                     level ? study->levels[n].label : "truth", xyz ? "" : "none left at ",
                     study->time[time]);
            panels[count] = (struct picture_panel){titles[count], xyz};
        }
    snprintf(name, sizeof name, "%s_sheets", study->name);
    return picture_save(folder, name, columns, count, panels, why);
}

enum status study_print_files(const struct study *study, const struct study_result *r,
                              const char *folder, struct message *why)
{
    struct table *t = motion_of(study, r);
    enum status st;

    TRY(table_save(t, folder, study->name, why));
    TRY(chart_save(chart_of(study, r, t), folder, study->name, why));
    TRY(draw_sheets(study, r, folder, why));
out:
    table_destroy(t);
    return st;
}

enum status study_print_all(const struct study *study, const char *folder,
                            enum table_format format, FILE *file, struct study_result *r,
                            struct message *why)
{
    enum status st;

    TRY(study_read(study, folder, r, why));
    TRY(study_print(study, r, format, file));
    TRY(study_print_files(study, r, folder, why));
out:
    if (st != STATUS_OK)
        study_result_clear(r);
    return st;
}

struct study_trend study_print_trend(const struct study *study,
                                     const struct study_result *r, int time, size_t member)
{
    struct study_trend trend = {"", 0};
    int rises = 0, falls = 0;
    double before = NAN;

    for (int n = 0; n < study->count; n++) {
        const struct study_frame *f = &r->row[n].frame[time];
        double value = *(const double *)((const char *)f + member);
        size_t used = strlen(trend.text), room = sizeof trend.text - used;
        const char *comma = n ? ", " : "";
        if (isnan(value) && !f->xyz)
            snprintf(trend.text + used, room, "%s%s", comma,
                     *r->row[n].refused ? "refused" : "died");
        else
            snprintf(trend.text + used, room, "%s%.3g", comma, value);
        rises += value > before;
        falls += value < before;
        before = value;
    }
    trend.sign = (rises == study->count - 1) - (falls == study->count - 1);
    return trend;
}

void study_print_verdict(FILE *file, const char *quote, bool holds, const char *format, ...)
{
    char sentence[1024], text[1400];
    va_list words;

    va_start(words, format);
    vsnprintf(sentence, sizeof sentence, format, words);
    va_end(words);
    snprintf(text, sizeof text, "- \"%s\": %s. %s\n", quote,
             holds ? "holds" : "does not hold", sentence);
    table_print_wrapped(text, file);
}
