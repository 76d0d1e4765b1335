#include "bench/studies/studies.h"

#include <math.h>
#include <stdlib.h>

#include "bench/experiment/judge.h"
#include "bench/experiment/study.h"
#include "bench/ui/chart.h"
#include "bench/ui/picture.h"
#include "models/grid.h"
#include "models/metric/metric.h"

/* Levels of the plan: the first and the last are the paper's. */
enum { LEVELS = 3, THIN = 0, THICK = LEVELS - 1 };

/* Solids of the plan, then the shell on two nets, whose difference is its error bar. */
enum { PAPER, BETTER, UNDAMPED, COARSE, FINE, SCHEMES, SOLIDS = COARSE };

static const char *const solid_name[SOLIDS] = {"printed", "printed_better", "incremental"};
static const char *const scheme_name[SCHEMES] = {
    "printed, mu = 0.5, 10x10x2", "printed, mu = 0.5, better net",
    "incremental, undamped, 10x10x2", "nonlinear shell, undamped, coarse net",
    "nonlinear shell, undamped, fine net"};

/* A swing is the largest turn, at any of the times, of the line from the neck's middle to
 * the hem's, out of its angle at rest. */
struct cloak {
    const struct study *paper; /* of its scheme and net                                 */
    const struct study_row *row[SCHEMES][LEVELS];
    double angle;                  /* at rest [degrees]                                 */
    double swing[SCHEMES][LEVELS]; /* NaN: none                               [degrees] */
    double sunk[LEVELS];           /* the hem in linear equilibrium, rms            [m] */
};

static double thickness(const struct cloak *c, int level)
{
    return c->row[PAPER][level]->run.scene.thickness;
}

/* Of the scene as it hangs before it moves. */
static void rest_of(const struct scene *scene, double *rest)
{
    double uvw[3];

    for (int n = 0; n < GRID_POINTS; n++) {
        grid_point(n, uvw);
        scene_rest_point(scene, uvw, rest + 3 * n);
    }
}

/* Rms displacement of the hem [m]; NaN without a field. */
static double hem_moved(const double *rest, const double *xyz)
{
    double sum = 0;

    for (int n = GRID_U - 1; xyz && n < GRID_POINTS; n += GRID_U)
        for (int c = 0; c < 3; c++)
            sum += pow(xyz[3 * n + c] - rest[3 * n + c], 2);
    return xyz ? sqrt(sum / (GRID_V * GRID_W)) : NAN;
}

static double swing_of(const struct cloak *c, const struct study_row *row)
{
    double swing = NAN;

    for (int t = 0; t < c->paper->frames; t++)
        if (row->frame[t].xyz)
            swing =
                fmax(swing, metric_angle(&row->run.scene, row->frame[t].xyz) - c->angle);
    return swing;
}

static enum status measure(const struct study_results *r, struct cloak *c)
{
    const struct study *linear = study_find(r, "linear"),
                       *shell = study_find(r, "nonlinear_shell");
    double *rest = malloc(3 * GRID_POINTS * sizeof *rest);

    if (!rest)
        return STATUS_MEMORY;
    c->paper = study_find(r, "printed");
    rest_of(&c->paper->row[0].run.scene, rest);
    c->angle = metric_angle(&c->paper->row[0].run.scene, rest);
    for (int h = 0; h < LEVELS; h++) {
        for (int n = 0; n < SCHEMES; n++) {
            c->row[n][h] = n < SOLIDS ? &study_find(r, solid_name[n])->row[h]
                                      : &shell->row[2 * h + n - COARSE];
            c->swing[n][h] = swing_of(c, c->row[n][h]);
        }
        rest_of(&linear->row[h].run.scene, rest);
        c->sunk[h] = hem_moved(rest, linear->row[h].frame[0].xyz);
    }
    free(rest);
    return STATUS_OK;
}

static struct table *swing_table(const struct cloak *c)
{
    static const struct table_column columns[] = {
        {"scheme", NULL, TABLE_LEFT, .key = "shown", .readers = TABLE_PEOPLE},
        {"scheme", NULL, TABLE_LEFT, .readers = TABLE_MACHINES},
        {"unknowns"},
        {"h", "mm", .key = "thickness_m", .key_unit = "m", .scale = 1e3},
        {"swing", "degrees"},
        {"stepping", "s"}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns,
                                   "Fig. 10: how far the cloak swings, and cost");

    for (int n = 0; n < SCHEMES; n++) {
        if (n)
            table_rule(t);
        for (int h = 0; h < LEVELS; h++) {
            table_row(t);
            table_text(t, "%s", h ? "" : scheme_name[n]);
            table_text(t, "%s", scheme_name[n]);
            table_fixed(t, c->row[n][h]->result.unknowns, 0);
            table_number(t, thickness(c, h), 1);
            table_fixed(t, c->swing[n][h], 1);
            table_number(t, c->row[n][h]->seconds, 3);
        }
    }
    return t;
}

static enum status print_swing(const struct cloak *c, const char *folder,
                               enum table_format format, FILE *file, struct message *why)
{
    const double *time = c->paper->time;
    struct table *t = swing_table(c);
    struct chart *chart = chart_create("Fig. 10: swing of the cloak");
    const struct chart_axis x = {"thickness", "mm", .low = 0, .high = 6};
    const struct chart_axis y = {"swing", "degrees", .low = 0, .high = NAN};
    enum status st;

    chart_axes(chart, &x, &y);
    for (int n = 0; n < SCHEMES; n++) {
        chart_series(chart, &(struct chart_series){scheme_name[n]});
        chart_rows(chart, t, "thickness_m", "swing_degrees", 1,
                   &(struct chart_where){"scheme", scheme_name[n]});
    }
    TRY(chart_save(chart, folder, "thickness", why));
    TRY(table_save(t, folder, "thickness", why));
    table_note(t,
               "Swing: the largest turn of the line from the neck's middle to the hem's at "
               "%g, %g, %g or %g s, from %.3g degrees below level at rest. Stepping: all "
               "frames to %g s; of the shell in one run.",
               time[0], time[1], time[2], time[3], c->angle, time[3]);
    return table_finish(t, format, file);
out:
    table_destroy(t);
    return st;
}

static enum status draw(const struct cloak *c, const char *folder, struct message *why)
{
    static const struct {
        int scheme;
        const char *title;
    } column[] = {{PAPER, "printed"},
                  {BETTER, "printed, better net"},
                  {UNDAMPED, "incremental"},
                  {FINE, "nonlinear shell"}};
    enum { COLUMNS = sizeof column / sizeof *column, PANELS = LEVELS * COLUMNS };
    const int last = c->paper->frames - 1;
    struct picture_panel panel[PANELS];
    char title[PANELS][64];

    for (int n = 0; n < PANELS; n++) {
        const int h = n / COLUMNS;
        snprintf(title[n], sizeof *title, "%s\n%g mm, t = %g s", column[n % COLUMNS].title,
                 1e3 * thickness(c, h), c->paper->time[last]);
        panel[n] = (struct picture_panel){
            title[n], c->row[column[n % COLUMNS].scheme][h]->frame[last].xyz};
    }
    return picture_save(folder, "thickness_sheets", COLUMNS, PANELS, panel, why);
}

static void judge_scheme(const struct cloak *c, int n, bool quick, const char *words,
                         FILE *file)
{
    const double *swing = c->swing[n];

    judge_print(file, "the thinner one swings more",
                quick ? JUDGE_QUICK : judge_below(swing[THICK], swing[THIN]),
                "%s: %.1f degrees at %g mm, %.1f at %g mm.", words, swing[THIN],
                1e3 * thickness(c, THIN), swing[THICK], 1e3 * thickness(c, THICK));
}

static void judge_shell(const struct cloak *c, bool quick, FILE *file)
{
    const double *fine = c->swing[FINE], *coarse = c->swing[COARSE];
    const double apart =
        judge_most(fabs(fine[THIN] - coarse[THIN]), fabs(fine[THICK] - coarse[THICK]));
    const double effect = fabs(fine[THIN] - fine[THICK]);

    judge_scheme(c, FINE, quick, "Nonlinear shell", file);
    judge_say(
        file,
        "The shell's nets differ by up to %.1f degrees, its thicknesses by %.1f: which "
        "of them swings more %s.",
        apart, effect,
        judge_words(quick ? JUDGE_QUICK : judge_below(2 * apart, effect), "is resolved",
                    "is not resolved by these nets", "cannot be judged"));
}

/* What thickness does to statics, and to the look of the paper's scheme. */
static void explain(const struct cloak *c, FILE *file)
{
    const double gamma = scene_gamma(&c->row[PAPER][THIN]->run.scene);
    const double h = thickness(c, THICK) / thickness(c, THIN);
    const double *paper = c->swing[PAPER], *better = c->swing[BETTER];
    const double thin = better[THIN] - paper[THIN], thick = better[THICK] - paper[THICK];
    const double effect = fabs(paper[THIN] - paper[THICK]);
    const double sunk = c->sunk[THIN] / c->sunk[THICK];

    judge_say(
        file,
        "Linear theory: Gamma ~ 1/h^2, %.4g and %.4g. At rest, what only bends would "
        "sink %.3g times as far when thin, what only stretches just as far; this cloak's "
        "hem sinks %.3g times as far (%.3g m and %.3g m)%s",
        gamma, gamma / (h * h), h * h, sunk, c->sunk[THIN], c->sunk[THICK],
        judge_words(judge_below(2 * sunk, h * h), ": its curvature makes it stretch.",
                    ": it bends.", "."));
    judge_say(file,
              "The paper's scheme has no elastic memory: at any thickness its cloak flows "
              "down as a viscous sheet, and h enters through bending alone. A better net "
              "lets the thin one swing %.1f degrees farther and the thick one %.1f; the "
              "paper's two thicknesses differ by %.1f: %s.",
              thin, thick, effect,
              judge_words(judge_below(effect, thin),
                          "the paper's net locks by more than that",
                          "the net makes less of a difference than the thickness",
                          "what the net does to that cannot be judged"));
}

static enum status tell(const struct study_results *r, const char *folder,
                        enum table_format format, FILE *file, struct message *why)
{
    struct cloak c;
    enum status st;

    TRY(measure(r, &c));
    for (int n = 0; n < SOLIDS; n++)
        TRY(study_print(study_find(r, solid_name[n]), folder, format, file, why));
    TRY(print_swing(&c, folder, format, file, why));
    TRY(draw(&c, folder, why));
    if (!table_format_is_prose(format))
        return STATUS_OK;
    fprintf(file,
            "The paper's sentence (its cloak's shape, size and pose are not known; these "
            "are ours)\n\n");
    judge_scheme(&c, PAPER, false, "The paper's scheme on its net", file);
    judge_scheme(&c, BETTER, false, "The paper's scheme on a better net", file);
    judge_scheme(&c, UNDAMPED, false, "Incremental, undamped, the paper's net", file);
    judge_shell(&c, r->quick, file);
    explain(&c, file);
out:
    return st;
}

const struct experiment study_thickness_swing = {
    .item = {"thickness", NULL}, .plan = "thickness", .tell = tell};
