/* The tables, CSV file and plots of study_timestep.h. */
#include <math.h>
#include <string.h>

#include "bench/files/output.h"
#include "bench/ui/plot.h"
#include "bench/experiment/study_print.h"
#include "bench/studies/study_timestep.h"

enum { LAST = STUDY_TIMESTEP_TIMES - 1 };

static void cell(struct table *t, double value, int digits)
{
    if (isnan(value))
        table_dash(t);
    else
        table_number(t, value, digits);
}

static enum status finish(struct table *t, enum table_format format, FILE *file)
{
    enum status st = table_print(t, format, file);

    table_destroy(t);
    if (st == STATUS_OK)
        fprintf(file, "\n");
    return st;
}

static void motion_row(struct table *t, const struct study_timestep *s, int kind, int n)
{
    const struct study *study = &study_timestep_kind[kind];
    const struct study_row *row = &s->kind[kind].row[n];

    table_row(t);
    table_text(t, "%s", study->caption);
    table_number(t, 1e3 * study->levels[n].size, 3);
    if (*row->refused) {
        table_note(t, "%s: %s.", study->caption, row->refused);
        return;
    }
    cell(t, row->milliseconds, 3);
    cell(t, row->seconds, 3);
    for (int time = 0; time < STUDY_TIMESTEP_TIMES; time++)
        cell(t, row->frame[time].drop, 4);
    cell(t, row->frame[LAST].stretch, 4);
    cell(t, 100 * row->frame[LAST].next, 3);
    if (strcmp(row->outcome, "done") != 0)
        table_note(t, "%s, step %s: %s.", study->caption, study->levels[n].label,
                   row->outcome);
}

static enum status print_motions(const struct study_timestep *s, enum table_format format,
                                 FILE *file)
{
    static const struct table_column columns[] = {{"scheme", NULL, TABLE_LEFT},
                                                  {"step", "ms", 0},
                                                  {"a frame", "ms", 0},
                                                  {"stepping", "s", 0},
                                                  {"drop 0.1 s", "L", 0},
                                                  {"0.2 s", "L", 0},
                                                  {"0.3 s", "L", 0},
                                                  {"0.4 s", "L", 0},
                                                  {"stretch 0.4 s", NULL, 0},
                                                  {"to next step", "% L", 0}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns,
                                   "edge_drop at ever shorter steps (IGA: remedy none)");

    for (int kind = 0; kind < STUDY_TIMESTEP_KINDS; kind++) {
        if (kind)
            table_rule(t);
        for (int n = 0; n < STUDY_TIMESTEP_LEVELS; n++)
            motion_row(t, s, kind, n);
    }
    table_note(
        t, "IGA 10x10x2, (2,2,1). drop: lowest point below the support; to next step: RMSE "
           "over the material grid between this step and the next shorter one at 0.4 s; a "
           "frame: median over repeats; stepping: all frames to 0.4 s at that price.");
    return finish(t, format, file);
}

static enum status print_limits(const struct study_timestep *s, enum table_format format,
                                FILE *file)
{
    static const struct table_column columns[] = {{"scheme", NULL, TABLE_LEFT},
                                                  {"largest difference", "% L", 0},
                                                  {"smallest", "% L", 0},
                                                  {"exponent of dt", NULL, 0}};
    struct table *t = table_create(
        sizeof columns / sizeof *columns, columns,
        "Differences from step to half step at 0.4 s: a limit, and of what order");

    for (int kind = 0; kind < STUDY_TIMESTEP_KINDS; kind++) {
        double most = NAN, least = NAN;
        for (int n = 0; n < STUDY_TIMESTEP_LEVELS; n++) {
            most = fmax(most, s->kind[kind].row[n].frame[LAST].next);
            least = fmin(least, s->kind[kind].row[n].frame[LAST].next);
        }
        table_row(t);
        table_text(t, "%s", study_timestep_kind[kind].caption);
        cell(t, 100 * most, 3);
        cell(t, 100 * least, 3);
        cell(t, study_timestep_order(s, kind), 3);
    }
    table_note(
        t, "A motion with a limit of order e has differences ~ dt^e; at e near or below 0 "
           "halving the step changes the motion as much as the halving before. With v <- "
           "mu v the limit of incremental and nonlinear is a sheet that does not move.");
    return finish(t, format, file);
}

static enum status print_falls(const struct study_timestep *s, enum table_format format,
                               FILE *file)
{
    static const struct table_column columns[] = {
        {"mu", NULL, 0},         {"step", "ms", 0},
        {"printed", "m/s^2", 0}, {"g (1+mu)/2(1-mu)", "m/s^2", 0},
        {"ratio", NULL, 0},      {"incremental", "m/s", 0},
        {"that dt", "m/s", 0},   {"ratio", NULL, 0}};
    const double g = study_timestep_viscous_gravity;
    struct table *t = table_create(
        sizeof columns / sizeof *columns, columns,
        "A free sheet, v <- mu v: acceleration under printed, speed under incremental");

    for (int n = 0; n < STUDY_TIMESTEP_FALLS; n++) {
        const struct study_timestep_fall *f = &s->fall[n];
        double expected = g * study_timestep_factor(f->mu);
        table_row(t);
        table_number(t, f->mu, 3);
        table_number(t, 1e3 * f->step, 3);
        cell(t, f->acceleration, 5);
        table_number(t, expected, 5);
        cell(t, f->acceleration / expected, 6);
        cell(t, f->speed, 5);
        table_number(t, expected * f->step, 5);
        cell(t, f->speed / (expected * f->step), 6);
    }
    table_note(
        t, "From positions at 0.5, 0.75 and 1 s: printed falls with a constant "
           "acceleration that is not g, incremental with a constant speed that vanishes "
           "with the step.");
    return finish(t, format, file);
}

static enum status print_creeps(const struct study_timestep *s, enum table_format format,
                                FILE *file)
{
    static const struct table_column columns[] = {
        {"E", "Pa", 0},         {"step", "ms", 0},           {"tip's speed", "m/s", 0},
        {"static sag", "m", 0}, {"speed dt / sag", NULL, 0}, {"speed E dt", "Pa m", 0}};
    struct table *t =
        table_create(sizeof columns / sizeof *columns, columns,
                     "A loaded cantilever under printed creeps: viscosity E dt");

    for (int n = 0; n < STUDY_TIMESTEP_CREEPS; n++) {
        const struct study_timestep_creep *c = &s->creep[n];
        table_row(t);
        table_number(t, c->young, 3);
        table_number(t, 1e3 * c->step, 3);
        cell(t, c->speed, 5);
        cell(t, c->sag, 5);
        cell(t, c->speed * c->step / c->sag, 6);
        cell(t, c->speed * c->young * c->step, 5);
    }
    table_note(
        t, "h = 20 mm, mu = 0.5, gravity 0.1 m/s^2, speed from 0.5 to 0.75 s. Each step "
           "adds the whole elastic sag of the load and forgets it: a sheet of viscosity "
           "E dt, which no elastic force holds up.");
    return finish(t, format, file);
}

static enum status write_csv(const struct study_timestep *s, const char *folder,
                             struct message *why)
{
    struct output *out = NULL;
    char path[TIMED_PATH];
    enum status st;

    snprintf(path, sizeof path, "%s/timestep.csv", folder);
    TRY(output_create(path, &out, why));
    output_print(out, "scheme,step_s,time_s,drop,stretch,rmse_to_next_over_length,"
                      "frame_ms\n");
    for (int kind = 0; kind < STUDY_TIMESTEP_KINDS; kind++) {
        if (kind)
            output_print(out, "\n\n"); /* gnuplot's next block */
        for (int t = 0; t < STUDY_TIMESTEP_TIMES; t++)
            for (int n = 0; n < STUDY_TIMESTEP_LEVELS; n++) {
                const struct study_row *row = &s->kind[kind].row[n];
                const struct study_frame *f = &row->frame[t];
                output_print(out, "\"%s\",%.9g,%g,%.9g,%.9g,%.9g,%.9g\n",
                             study_timestep_kind[kind].caption,
                             study_timestep_kind[kind].levels[n].size,
                             study_timestep_time[t], f->drop, f->stretch, f->next,
                             row->milliseconds);
            }
    }
    return output_close(out, why);
out:
    return st;
}

static bool lives(const struct study_timestep *s, int kind)
{
    for (int n = 0; n < STUDY_TIMESTEP_LEVELS; n++)
        if (s->kind[kind].row[n].frame[LAST].xyz)
            return true;
    return false;
}

/* A line for each scheme that lives, of column `column` at the last time. */
static void panel(struct output *out, const struct study_timestep *s, int column)
{
    const char *separator = "";

    output_print(out, "plot \\\n");
    for (int kind = 0; kind < STUDY_TIMESTEP_KINDS; kind++) {
        if (!lives(s, kind))
            continue;
        output_print(out,
                     "%s'timestep.csv' index %d using (1e3*$2):($3 == %g ? $%d : NaN) with "
                     "linespoints lc %d pt %d lw 2 title \"%s\"",
                     separator, kind, study_timestep_time[LAST], column, kind + 1, kind + 4,
                     study_timestep_kind[kind].caption);
        separator = ", \\\n";
    }
    output_print(out, "\n");
}

static enum status write_script(const struct study_timestep *s, const char *folder,
                                struct message *why)
{
    struct output *out = NULL;
    char path[TIMED_PATH];
    enum status st;

    snprintf(path, sizeof path, "%s/timestep.gp", folder);
    TRY(output_create(path, &out, why));
    output_print(out, "set terminal pngcairo noenhanced size 1000,1000\n"
                      "set output 'timestep.png'\nset datafile separator ','\n"
                      "set datafile missing 'nan'\nset logscale x\nset grid\n"
                      "set xtics (0.625, 1.25, 2.5, 5, 10)\nset xrange [0.5:12]\n"
                      "set format y '%%g'\nset xlabel 'step [ms]'\nset key outside right\n"
                      "set multiplot layout 2,1\nset ylabel 'drop / L at 0.4 s'\n"
                      "set title 'edge_drop: the motion against the step'\n");
    panel(out, s, 4);
    output_print(out, "set logscale y\nset ylabel 'RMSE / L to half the step'\n"
                      "set title 'does halving the step still change it?'\n");
    panel(out, s, 6);
    output_print(out, "unset multiplot\n");
    return output_close(out, why);
out:
    return st;
}

static enum status print_files(const struct study_timestep *s, const char *folder,
                               struct message *why)
{
    static const enum study_timestep_kind shown[] = {
        STUDY_TIMESTEP_PAPER, STUDY_TIMESTEP_SHEET, STUDY_TIMESTEP_SHEET_MASS};
    struct message plot = {""};
    enum status st;

    TRY(write_csv(s, folder, why));
    TRY(write_script(s, folder, why));
    st = plot_run(folder, "timestep.gp", &plot);
    if (st == STATUS_OK)
        fprintf(stderr, "plot in %s/timestep.png beside timestep.csv\n", folder);
    else
        fprintf(stderr, "%s\n", plot.text);
    for (size_t n = 0; n < sizeof shown / sizeof *shown; n++)
        TRY(study_print_files(&study_timestep_kind[shown[n]], &s->kind[shown[n]], folder,
                              why));
    st = STATUS_OK;
out:
    return st;
}

enum status study_timestep_print(const char *folder, enum table_format format, FILE *file,
                                 struct message *why)
{
    struct study_timestep *s = NULL;
    enum status st;

    TRY(study_timestep_read(folder, &s, why));
    TRY(print_motions(s, format, file));
    TRY(print_limits(s, format, file));
    TRY(print_falls(s, format, file));
    TRY(print_creeps(s, format, file));
    if (format == TABLE_TEXT)
        study_timestep_text(s, file);
    TRY(print_files(s, folder, why));
out:
    study_timestep_destroy(s);
    return st;
}
