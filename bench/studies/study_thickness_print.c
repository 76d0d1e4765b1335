#include <math.h>
#include <stdlib.h>

#include "bench/files/output.h"
#include "bench/ui/picture.h"
#include "bench/ui/plot.h"
#include "bench/experiment/study_print.h"
#include "bench/studies/study_thickness.h"
#include "models/metric/metric.h"

enum {
    LEVELS = STUDY_THICKNESS_LEVELS,
    SCHEMES = STUDY_THICKNESS_SCHEMES,
    LAST = STUDY_THICKNESS_TIMES - 1,
    THIN = 0,
    THICK = LEVELS - 1,
    PAPER = 0,
    BETTER = 1,
    UNDAMPED = 2,
    COARSE = STUDY_THICKNESS_SOLIDS,
    FINE = SCHEMES - 1,
    PATH = 4096,
};

static const char *const scheme_name[SCHEMES] = {
    "printed, mu = 0.5, 10x10x2", "printed, mu = 0.5, better net",
    "incremental, undamped, 10x10x2", "nonlinear shell, undamped, coarse net",
    "nonlinear shell, undamped, fine net"};

/* Seconds of stepping, and unknowns. */
struct work {
    double seconds, unknowns;
};

static struct work work_of(const struct study_thickness *s, int scheme, int level)
{
    if (scheme < COARSE) {
        const struct study_row *row = &s->solid[scheme].row[level];
        return (struct work){row->seconds, row->unknowns};
    }
    const struct rung_result *shell = &s->shell[level][scheme - COARSE];
    return (struct work){shell->stepping, shell->unknowns};
}

static enum status print_swing(const struct study_thickness *s, enum table_format format,
                               FILE *file)
{
    static const struct table_column columns[] = {{"scheme", NULL, TABLE_LEFT},
                                                  {"unknowns", NULL, 0},
                                                  {"h", "mm", 0},
                                                  {"swing", "degrees", 0},
                                                  {"stepping", "s", 0}};
    const double *time = study_thickness_solid[PAPER].time;
    struct table *t =
        table_create(5, columns, "Fig. 10: how far the cloak swings, and cost");
    enum status st;

    for (int n = 0; n < SCHEMES; n++) {
        if (n)
            table_rule(t);
        for (int h = 0; h < LEVELS; h++) {
            struct work work = work_of(s, n, h);
            table_row(t);
            table_text(t, "%s", h ? "" : scheme_name[n]);
            table_integer(t, lround(work.unknowns));
            table_number(t, 1e3 * study_thickness_of(h), 1);
            if (isnan(s->swing[n][h]))
                table_dash(t);
            else
                table_fixed(t, s->swing[n][h], 1);
            table_number(t, work.seconds, 3);
        }
    }
    table_note(t,
               "Swing: the largest turn of the line from the neck's middle to the hem's at "
               "%g, %g, %g or %g s, from %.3g degrees below level at rest. Stepping: all "
               "frames to %g s; of the shell in one run.",
               time[0], time[1], time[2], time[3], s->angle, time[LAST]);
    st = table_print(t, format, file);
    table_destroy(t);
    fprintf(file, "\n");
    return st;
}

/* thickness.csv: a block a scheme; thickness.gp, thickness.png. */
static enum status plot_swing(const struct study_thickness *s, const char *folder,
                              struct message *why)
{
    struct output *out = NULL;
    char path[PATH];
    enum status st;

    snprintf(path, sizeof path, "%s/thickness.csv", folder);
    TRY(output_create(path, &out, why));
    output_print(out, "scheme,thickness_m,swing_degrees,stepping_s,unknowns\n");
    for (int n = 0; n < SCHEMES; n++) {
        if (n)
            output_print(out, "\n\n");
        for (int h = 0; h < LEVELS; h++) {
            struct work work = work_of(s, n, h);
            output_print(out, "\"%s\",%.9g,%.9g,%.6g,%.0f\n", scheme_name[n],
                         study_thickness_of(h), s->swing[n][h], work.seconds,
                         work.unknowns);
        }
    }
    TRY(output_close(out, why));
    snprintf(path, sizeof path, "%s/thickness.gp", folder);
    TRY(output_create(path, &out, why));
    output_print(
        out,
        "set terminal pngcairo noenhanced size 800,550\n"
        "set output 'thickness.png'\nset datafile separator ','\n"
        "set datafile missing 'nan'\nset grid\nset key inside bottom left Left reverse\n"
        "set xlabel 'thickness [mm]'\nset xrange [0:6]\nset yrange [0:*]\n"
        "set ylabel 'swing by %g s [degrees]'\nplot ",
        study_thickness_solid[PAPER].time[LAST]);
    for (int n = 0; n < SCHEMES; n++)
        output_print(out,
                     "%s'thickness.csv' index %d %s using (1e3*$2):3 with linespoints lw 2 "
                     "title '%s'",
                     n ? ", \\\n" : "", n, n ? "" : "every ::1", scheme_name[n]);
    output_print(out, "\n");
    TRY(output_close(out, why));
    st = plot_run(folder, "thickness.gp", why);
out:
    return st;
}

static enum status draw(const struct study_thickness *s, const char *folder,
                        struct message *why)
{
    enum { COLUMNS = STUDY_THICKNESS_SOLIDS + 1, PANELS = LEVELS * COLUMNS };
    static const char *const scheme[COLUMNS] = {"printed", "printed, better net",
                                                "incremental", "nonlinear shell"};
    struct picture_panel panel[PANELS];
    char title[PANELS][64];

    for (int n = 0; n < PANELS; n++) {
        const int h = n / COLUMNS;
        const struct rung_result *shell = &s->shell[h][FINE - COARSE];
        const double *xyz = n % COLUMNS < COARSE
                                ? s->solid[n % COLUMNS].row[h].frame[LAST].xyz
                            : shell->frames > LAST ? shell->xyz[LAST]
                                                   : NULL;
        snprintf(title[n], sizeof *title, "%s\n%g mm, t = %g s", scheme[n % COLUMNS],
                 1e3 * study_thickness_of(h), study_thickness_solid[PAPER].time[LAST]);
        panel[n] = (struct picture_panel){title[n], xyz};
    }
    return picture_surfaces(folder, "thickness_sheets", COLUMNS, PANELS, panel, why);
}

static void judge_scheme(const struct study_thickness *s, int n, const char *words,
                         FILE *file)
{
    const double *swing = s->swing[n];

    study_print_verdict(file, "the thinner one swings more", swing[THIN] > swing[THICK],
                        "%s: %.1f degrees at %g mm, %.1f at %g mm.", words, swing[THIN],
                        1e3 * study_thickness_of(THIN), swing[THICK],
                        1e3 * study_thickness_of(THICK));
}

static void judge_shell(const struct study_thickness *s, FILE *file)
{
    const double *fine = s->swing[FINE], *coarse = s->swing[COARSE];
    double apart = fmax(fabs(fine[THIN] - coarse[THIN]), fabs(fine[THICK] - coarse[THICK]));
    double effect = fabs(fine[THIN] - fine[THICK]);

    judge_scheme(s, FINE, "Nonlinear shell", file);
    fprintf(file,
            "\nThe shell's nets differ by up to %.1f degrees, its thicknesses by %.1f: "
            "which of "
            "them swings\nmore is %s.\n",
            apart, effect, 2 * apart < effect ? "resolved" : "not resolved by these nets");
}

/* What thickness does to statics, and to the look of the paper's scheme. */
static void explain(const struct study_thickness *s, FILE *file)
{
    double h = study_thickness_of(THICK) / study_thickness_of(THIN);
    double thin = s->swing[BETTER][THIN] - s->swing[PAPER][THIN];
    double thick = s->swing[BETTER][THICK] - s->swing[PAPER][THICK];
    double effect = fabs(s->swing[PAPER][THIN] - s->swing[PAPER][THICK]);

    fprintf(
        file,
        "Linear theory: Gamma ~ 1/h^2, %.4g and %.4g. At rest, what only bends would sink "
        "%.3g times\nas far when thin, what only stretches just as far; this cloak's hem "
        "sinks %.3g times as far\n(%.3g m and %.3g m): its curvature makes it stretch.\n",
        s->gamma, s->gamma / (h * h), h * h, s->sunk[THIN] / s->sunk[THICK], s->sunk[THIN],
        s->sunk[THICK]);
    fprintf(
        file,
        "The paper's scheme has no elastic memory: at any thickness its cloak flows down "
        "as "
        "a viscous\nsheet, and h enters through bending alone. A better net lets the thin "
        "one swing %.1f degrees\nfarther and the thick one %.1f: the paper's net locks, "
        "and "
        "that is %s its two thicknesses\ndiffer by (%.1f).\n",
        thin, thick, thin > effect ? "more than" : "less than", effect);
}

enum status study_thickness_print(const char *folder, enum table_format format, FILE *file,
                                  struct message *why)
{
    struct study_thickness *s = NULL;
    struct message plot = {""};
    enum status st;

    TRY(study_thickness_read(folder, &s, why));
    for (int n = 0; n < STUDY_THICKNESS_SOLIDS; n++) {
        TRY(study_print(&study_thickness_solid[n], &s->solid[n], format, file));
        TRY(study_print_files(&study_thickness_solid[n], &s->solid[n], folder, why));
    }
    TRY(print_swing(s, format, file));
    st = plot_swing(s, folder, &plot);
    if (st == STATUS_OK)
        st = draw(s, folder, &plot);
    if (st == STATUS_OK)
        fprintf(stderr,
                "thickness.png and thickness_sheets.png beside thickness.csv in %s\n",
                folder);
    else
        fprintf(stderr, "%s\n", plot.text);
    st = STATUS_OK;
    fprintf(file,
            "The paper's sentence (its cloak's shape, size and pose are not known; these "
            "are ours)\n\n");
    judge_scheme(s, PAPER, "The paper's scheme on its net", file);
    judge_scheme(s, BETTER, "The paper's scheme on a better net", file);
    judge_scheme(s, UNDAMPED, "Incremental, undamped, the paper's net", file);
    judge_shell(s, file);
    explain(s, file);
out:
    study_thickness_destroy(s);
    return st;
}
