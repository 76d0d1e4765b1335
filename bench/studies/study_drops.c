#include "bench/studies/studies.h"

#include <math.h>

#include "bench/experiment/gallery.h"
#include "bench/experiment/judge.h"

/* Of each figure the paper's scheme, then what the same sheet does as an elastic shell. */
enum { PRINTED, SHELL, SCHEMES, FIGURES = 2, CASES = FIGURES * SCHEMES };
enum { TIMES = 6 };

static const char *const quote[FIGURES] = {
    "Fig. 7, an edge held: the sheet falls, swings through, and back",
    "Fig. 8, two corners held: the sheet falls, swings through, and back"};

/* Down along gravity [degrees]. */
static const double PLUMB = 90;

static void add_settings(int n, bool quick, struct settings *s)
{
    static const int side[SCHEMES] = {10, 12}, small[SCHEMES] = {5, 6};
    const int points = (quick ? small : side)[n % SCHEMES];

    settings_integers(s, "discretization.points", 2, (int[]){points, points});
    if (n % SCHEMES == SHELL)
        settings_set(s, "damping={kind: none}");
}

static const struct gallery gallery = {
    .name = "drops",
    .times = TIMES,
    .time = {0.5, 1.5, 2.0, 3.25, 3.5, 4.25},
    .count = CASES,
    .item = {{"Fig. 7, printed", "edge_printed", "edge_drop", "iga_paper"},
             {"Fig. 7, undamped shell", "edge_shell", "edge_drop", STUDIES_SHELL},
             {"Fig. 8, printed", "corners_printed", "corners_drop", "iga_paper"},
             {"Fig. 8, undamped shell", "corners_shell", "corners_drop", STUDIES_SHELL}},
    .settings = add_settings,
    .tell = study_drops_tell};

/* The largest angle of a case, and the least one after it; NaN: it died before its end. */
static void swing_of(const struct gallery_result *r, int n, double *most, double *after)
{
    int top = 0;

    *most = *after = NAN;
    for (int t = 0; t < TIMES; t++) {
        if (isnan(r->frame[n][t].angle))
            return;
        top = r->frame[n][t].angle > r->frame[n][top].angle ? t : top;
    }
    *most = *after = r->frame[n][top].angle;
    for (int t = top; t < TIMES; t++)
        *after = fmin(*after, r->frame[n][t].angle);
}

static void tell_figure(const struct gallery_result *r, int figure, FILE *file)
{
    const int n = figure * SCHEMES;
    double most, after, shell, unused;

    swing_of(r, n + PRINTED, &most, &after);
    swing_of(r, n + SHELL, &shell, &unused);
    judge_print(
        file, quote[figure],
        r->quick ? JUDGE_QUICK
                 : judge_both(judge_below(PLUMB, most), judge_below(after, PLUMB)),
        "At the paper's six times the printed scheme's sheet is inclined by %.3g degrees "
        "at "
        "most, where %g is plumb, by %.3g at least after that, and in the end stretched by "
        "a factor of %.3g; an undamped shell with the same E, nu, rho and thickness: %.3g "
        "degrees, a factor of %.3g.",
        most, PLUMB, after, r->frame[n + PRINTED][TIMES - 1].stretch, shell,
        r->frame[n + SHELL][TIMES - 1].stretch);
}

enum status study_drops_tell(const struct gallery_result *r, const char *folder,
                             enum table_format format, FILE *file, struct message *why)
{
    enum status st;

    TRY(gallery_print(&gallery, r, "Figs. 7 and 8, falling sheets at the paper's times",
                      folder, format, file, why));
    if (!table_format_is_prose(format))
        return STATUS_OK;
    fputc('\n', file);
    for (int figure = 0; figure < FIGURES; figure++)
        tell_figure(r, figure, file);
out:
    return st;
}

const struct experiment study_drops_experiment = {
    .item = {"drops", "Ren et al. 2024, Figs. 7 and 8: sheets fall, held at an edge or at "
                      "two corners"},
    .gallery = &gallery,
};
