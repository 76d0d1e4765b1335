#include "bench/experiment/study_print.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>

#include "bench/files/output.h"
#include "bench/ui/picture.h"
#include "bench/ui/plot.h"

enum { PATH = 4096 };

static void cell(struct table *t, double value, int digits)
{
    if (isnan(value))
        table_dash(t);
    else
        table_number(t, value, digits);
}

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
    struct table *t;
    enum status st;

    snprintf(caption, sizeof caption, "%s: cost", study->caption);
    t = table_create(sizeof columns / sizeof *columns, columns, caption);
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
        cell(t, row->milliseconds, 3);
        cell(t, paper_of(study, n), 4);
        cell(t, row->seconds, 3);
        table_text(t, "%s", row->outcome);
    }
    table_note(t,
               "A frame: median over repeats, one thread; factor: numbers stored in it; "
               "stepping: all frames to %g s at that price.",
               study->time[study->times - 1]);
    st = table_print(t, format, file);
    table_destroy(t);
    return st;
}

static void motion_row(struct table *t, const struct study *study,
                       const struct study_result *r, int n, int time)
{
    const struct study_frame *f = &r->row[n].frame[time];

    table_row(t);
    table_fixed(t, study->time[time], 3);
    table_text(t, "%s", study->levels[n].label);
    if (!f->xyz)
        return;
    cell(t, f->next, 3);
    cell(t, f->finest, 3);
    if (r->truth) {
        cell(t, f->error, 3);
        table_text(t, "%s", "");
    }
    cell(t, f->roughness, 3);
    cell(t, f->inner, 3);
    cell(t, f->stretch, 4);
    cell(t, f->drop, 4);
    cell(t, f->unevenness, 3);
}

/* The truth's own numbers, below the levels. */
static void true_row(struct table *t, const struct study *study,
                     const struct study_result *r, int time)
{
    const struct study_frame *f = &r->true_frame[time];

    table_row(t);
    table_fixed(t, study->time[time], 3);
    table_text(t, "truth");
    for (int n = 0; n < 3; n++)
        table_text(t, "%s", "");
    cell(t, r->truth->error[time] / r->length, 2);
    cell(t, f->roughness, 3);
    cell(t, f->inner, 3);
    cell(t, f->stretch, 4);
    cell(t, f->drop, 4);
    cell(t, f->unevenness, 3);
}

static enum status print_motion(const struct study *study, const struct study_result *r,
                                enum table_format format, FILE *file)
{
    static const struct table_column with[] = {
        {"t", "s", 0},          {"level", NULL, TABLE_LEFT}, {"to next", "L", 0},
        {"to finest", "L", 0},  {"error", "L", 0},           {"error bar", "L", 0},
        {"roughness", NULL, 0}, {"inner", NULL, 0},          {"stretch", NULL, 0},
        {"drop", "L", 0},       {"unevenness", NULL, 0}};
    struct table_column without[9];
    struct table *t;
    enum status st;

    memcpy(without, with, 4 * sizeof *with);
    memcpy(without + 4, with + 6, 5 * sizeof *with);
    t = table_create(r->truth ? 11 : 9, r->truth ? with : without, study->caption);
    for (int time = 0; time < study->times; time++) {
        double order = study_order(study, r, time);
        if (time)
            table_rule(t);
        for (int n = 0; n < study->count; n++)
            motion_row(t, study, r, n, time);
        if (r->truth)
            true_row(t, study, r, time);
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
    st = table_print(t, format, file);
    table_destroy(t);
    return st;
}

enum status study_print(const struct study *study, const struct study_result *r,
                        enum table_format format, FILE *file)
{
    enum status st;

    TRY(print_cost(study, r, format, file));
    fprintf(file, "\n");
    TRY(print_motion(study, r, format, file));
    fprintf(file, "\n");
out:
    return st;
}

static void csv_row(struct output *out, const struct study *study,
                    const struct study_result *r, int n, int time)
{
    const struct study_level *level = &study->levels[n];
    const struct study_row *row = &r->row[n];
    const struct study_frame *f = &row->frame[time];

    output_print(out,
                 "\"%s\",%.9g,%.9g,%.0f,%.0f,%.6g,%.6g,%.6g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,"
                 "%.9g,%.9g,%.9g\n",
                 level->label, level->size, study->time[time], row->unknowns,
                 row->factor_entries, row->milliseconds, paper_of(study, n), row->seconds,
                 f->next, f->finest, f->error,
                 r->truth ? r->truth->error[time] / r->length : NAN, f->roughness, f->inner,
                 f->stretch, f->drop, f->unevenness);
}

static void csv_truth(struct output *out, const struct study *study,
                      const struct study_result *r, int time)
{
    const struct study_frame *f = &r->true_frame[time];

    output_print(out,
                 "\"truth\",nan,%.9g,nan,nan,nan,nan,nan,nan,nan,0,%.9g,%.9g,%.9g,%.9g,"
                 "%.9g,%.9g\n",
                 study->time[time], r->truth->error[time] / r->length, f->roughness,
                 f->inner, f->stretch, f->drop, f->unevenness);
}

static enum status write_csv(const struct study *study, const struct study_result *r,
                             const char *folder, struct message *why)
{
    struct output *out = NULL;
    char path[PATH];
    enum status st;

    snprintf(path, sizeof path, "%s/%s.csv", folder, study->name);
    TRY(output_create(path, &out, why));
    output_print(out,
                 "level,size,time_s,unknowns,factor_entries,frame_ms,paper_ms,stepping_s,"
                 "to_next_over_length,to_finest_over_length,error_over_length,"
                 "error_bar_over_length,roughness,inner_roughness,stretch,drop_over_length,"
                 "unevenness\n");
    for (int time = 0; time < study->times; time++) {
        if (time)
            output_print(out, "\n\n"); /* gnuplot's next block */
        for (int n = 0; n < study->count; n++)
            csv_row(out, study, r, n, time);
        if (r->truth)
            csv_truth(out, study, r, time);
    }
    return output_close(out, why);
out:
    return st;
}

static enum status write_plot(const struct study *study, const struct study_result *r,
                              const char *folder, struct message *why)
{
    const int column = r->truth ? 11 : 10; /* of write_csv */
    struct output *out = NULL;
    char path[PATH];
    enum status st;

    snprintf(path, sizeof path, "%s/%s.gp", folder, study->name);
    TRY(output_create(path, &out, why));
    output_print(out,
                 "set terminal pngcairo noenhanced size 900,650\nset output '%s.png'\n"
                 "set datafile separator ','\nset datafile missing 'nan'\nset logscale xy\n"
                 "set grid\nset format '%%g'\nset key outside right\n"
                 "set xlabel 'seconds of stepping'\nset ylabel '%s'\nset title \"%s\"\n"
                 "plot \\\n",
                 study->name,
                 r->truth ? "RMSE to truth / L" : "RMSE to the finest level / L",
                 study->caption);
    for (int time = 0; time < study->times; time++)
        output_print(out,
                     "%s'%s.csv' index %d using 8:%d with linespoints lw 2 lc %d pt %d "
                     "title '%g s'",
                     time ? ", \\\n" : "", study->name, time, column, time + 1, time + 4,
                     study->time[time]);
    output_print(
        out, ", \\\n'' index 0 using 8:%d:1 with labels offset 0,-0.8 font ',9' notitle",
        column);
    output_print(out, "\n");
    return output_close(out, why);
out:
    return st;
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
    return picture_surfaces(folder, name, columns, count, panels, why);
}

enum status study_print_files(const struct study *study, const struct study_result *r,
                              const char *folder, struct message *why)
{
    struct message plot = {""};
    char script[PATH];
    enum status st;

    TRY(write_csv(study, r, folder, why));
    TRY(write_plot(study, r, folder, why));
    snprintf(script, sizeof script, "%s.gp", study->name);
    st = plot_run(folder, script, &plot);
    if (st == STATUS_OK)
        st = draw_sheets(study, r, folder, &plot);
    if (st == STATUS_OK)
        fprintf(stderr, "%s.png and %s_sheets.png beside %s.csv in %s\n", study->name,
                study->name, study->name, folder);
    else
        fprintf(stderr, "%s\n", plot.text);
    st = STATUS_OK;
out:
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
