/* Tables, sentences and chart of study_locking.h. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/experiment/judge.h"
#include "bench/experiment/measurement.h"
#include "bench/experiment/study.h"
#include "bench/harness/fit.h"
#include "bench/studies/study_cantilever.h"
#include "bench/studies/study_locking.h"

enum { FIXED = 4, MOST = FIXED + STUDY_LOCKING_MOST, TEXT = 32 };

/* Places in study_locking_space. */
enum {
    PAPER = 0,
    FINER = 1,
    CUBIC = 2,
    QUARTIC = 3,
    CUBIC_R2 = 5,
    HEX = 7,
    PAPER_HEX = 8,
    CURED = 9
};

/* At nu = 0.3. */
static const struct study_locking_cell *at(const struct study_locking *s, int space, int n)
{
    return &s->cell[space][STUDY_LOCKING_BOTH][n];
}

static double tip(const struct study_locking *s, int space, int n)
{
    return at(s, space, n)->tip;
}

static const struct model *model_of(int space)
{
    const struct contestant *c = NULL;

    contestant_find(study_locking_space[space].contestant, &c, NULL);
    return c->model;
}

/* A column for each thickness, behind what a space costs or not; a line between models. */
static struct table *pivot(const struct study_locking *s, const char *caption, bool cost,
                           double value(const struct study_locking *s, int space, int n),
                           char header[STUDY_LOCKING_MOST][TEXT])
{
    const int fixed = cost ? FIXED : 1;
    struct table_column columns[MOST] = {
        {"space", NULL, TABLE_LEFT},
        {"unknowns"},
        {"set-up", "ms", .key = "setup_s", .key_unit = "s", .scale = 1e3},
        {"equilibrium", "ms", .key = "equilibrium_s", .key_unit = "s", .scale = 1e3}};

    for (int n = 0; n < s->count; n++) {
        snprintf(header[n], TEXT, "%sh %g", n ? "" : "at ", 1e3 * s->thickness[n]);
        columns[fixed + n] = (struct table_column){header[n], "mm", .key_unit = "1"};
    }
    struct table *t = table_create(fixed + s->count, columns, caption);
    for (int space = 0; space < STUDY_LOCKING_SPACES; space++) {
        if (space && model_of(space) != model_of(space - 1))
            table_rule(t);
        table_row(t);
        table_text(t, "%s", study_locking_space[space].label);
        if (cost) {
            table_fixed(t, at(s, space, s->count / 2)->unknowns, 0);
            table_number(t, at(s, space, s->count / 2)->setup, 3);
            table_number(t, at(s, space, s->count / 2)->equilibrium, 3);
        }
        for (int n = 0; n < s->count; n++)
            table_number(t, value(s, space, n), 4);
    }
    return t;
}

static enum status print_tips(const struct study_locking *s, enum table_format format,
                              FILE *file)
{
    char header[STUDY_LOCKING_MOST][TEXT];
    const double *h = s->thickness, thickest = h[s->count - 1];
    struct table *t =
        pivot(s, "Cantilever under its own weight, nu = 0.3: tip over Kirchhoff's", true,
              tip, header);

    for (int space = 0; space < STUDY_LOCKING_SPACES; space++)
        for (int n = 0; n < s->count; n++)
            if (*at(s, space, n)->said.text)
                table_note(t, "%s at h = %g mm: %s.", study_locking_space[space].label,
                           1e3 * h[n], at(s, space, n)->said.text);
    table_note(
        t,
        "1 m x 1 m, linear kinematics: the load scales out. Milliseconds at h = %g mm, "
        "median of repeats, all spaces in turn; equilibrium: factor and solve. Kirchhoff's "
        "theory itself leaves out shear, of order (h/L)^2 = %.0e at h = %g mm.",
        1e3 * h[s->count / 2], pow(thickest, 2), 1e3 * thickest);
    return table_finish(t, format, file);
}

static enum status print_parts(const struct study_locking *s, enum table_format format,
                               FILE *file)
{
    const double nu = study_locking_nu[STUDY_LOCKING_BOTH];
    char header[STUDY_LOCKING_MOST][TEXT];
    struct table *t;
    enum status st;

    t = pivot(s, "Transverse shear locking alone: tip over Kirchhoff's at nu = 0", false,
              study_locking_shear, header);
    table_note(t, "At nu = 0 bending does not couple to the thickness, and r = 1 is no "
                  "restriction.");
    TRY(table_finish(t, format, file));
    t = pivot(s, "Thickness locking alone: the tip at nu = 0.3 over that at nu = 0", false,
              study_locking_through, header);
    table_note(
        t,
        "A plate that cannot change its thickness freely (r = 1) has %.4f of Kirchhoff's "
        "tip in the thin limit; a strip (1 - 2 nu)/(1 - nu)^2 = %.4f.",
        s->limit, (1 - 2 * nu) / pow(1 - nu, 2));
    st = table_finish(t, format, file);
out:
    return st;
}

/* Which of the thicknesses it is; -1: none. */
static int find(const struct study_locking *s, double h)
{
    for (int n = 0; n < s->count; n++)
        if (fabs(s->thickness[n] / h - 1) < 1e-9)
            return n;
    return -1;
}

/* Nothing where none of its thicknesses was run. */
static enum status print_prototype(const struct study_locking *s, enum table_format format,
                                   FILE *file)
{
    static const struct table_column columns[] = {{"space", NULL, TABLE_LEFT},
                                                  {"1 mm", "here", .key_unit = "1"},
                                                  {"1 mm", "prototype", .key_unit = "1"},
                                                  {"5 mm", "here", .key_unit = "1"},
                                                  {"5 mm", "prototype", .key_unit = "1"},
                                                  {"20 mm", "here", .key_unit = "1"},
                                                  {"20 mm", "prototype", .key_unit = "1"}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns,
                                   "Against an independent prototype, nu = 0.3");
    double worst = -INFINITY, wanted, half;

    for (int space = 0; space < STUDY_LOCKING_SPACES; space++) {
        const struct study_locking_space *sp = &study_locking_space[space];
        if (!*sp->prototype)
            continue;
        table_row(t);
        table_text(t, "%s", sp->label);
        for (int n = 0; n < STUDY_LOCKING_PROTOTYPES; n++) {
            const int k = find(s, study_locking_thickness[n]);
            const double here = k < 0 ? NAN : tip(s, space, k);
            study_locking_prototype(sp, n, &wanted, &half);
            table_number(t, here, 3);
            table_text(t, "%s", sp->prototype[n]);
            /* beyond what its printed digits leave open */
            worst = fmax(worst, (fabs(here - wanted) - half) / wanted);
        }
    }
    table_note(t,
               "Prototype: the same spaces in Python, written before this program, to the "
               "digits it printed. Largest difference beyond those digits: %.2g %%.",
               100 * fmax(0, worst));
    if (worst > -INFINITY)
        return table_finish(t, format, file);
    table_destroy(t);
    return STATUS_OK;
}

/* --- What a reader should take away. */

/* Over the paper's. */
static double cost(const struct study_locking *s, int space)
{
    const struct study_locking_cell *c = at(s, space, s->count / 2),
                                    *paper = at(s, PAPER, s->count / 2);

    return (c->setup + c->equilibrium) / (paper->setup + paper->equilibrium);
}

/* Kirchhoff's tip over the hexahedra's is 1 + C (L/h)^e where they lock. */
static double growth(const struct study_locking *s, int space)
{
    double slender[STUDY_LOCKING_MOST], excess[STUDY_LOCKING_MOST];

    for (int n = 0; n < s->count; n++) {
        slender[n] = 1 / s->thickness[n];
        excess[n] = 1 / study_locking_shear(s, space, n) - 1;
    }
    return s->count > 1 ? fit_exponent(s->count, slender, excess) : NAN;
}

static void tell_shear(const struct study_locking *s, int n, FILE *file)
{
    const int places[] = {PAPER, FINER, CUBIC, QUARTIC, PAPER_HEX}, thick = s->count - 1;
    double here[5], paper[STUDY_LOCKING_MOST];

    for (int k = 0; k < 5; k++)
        here[k] = study_locking_shear(s, places[k], n);
    for (int k = 0; k < s->count; k++)
        paper[k] = study_locking_shear(s, PAPER, k);
    judge_say(
        file,
        "Shear locking (nu = 0). At h = %g mm the paper's space has %.3f of the tip, twice "
        "the points %.3f, degree 3 %.3f, degree 4 %.3f; the paper's hexahedra %.4f. "
        "Thinner "
        "%s: the paper's space goes from %.3f at %g mm to %.3f at %g mm. Plain hexahedra "
        "are "
        "too stiff by a factor 1 + C (L/h)^%.2f (2 in theory).",
        1e3 * s->thickness[n], here[0], here[1], here[2], here[3], here[4],
        judge_words(judge_order(s->count, paper, 1, 0), "is worse", "is not always worse",
                    "may be worse"),
        paper[thick], 1e3 * s->thickness[thick], paper[0], 1e3 * s->thickness[0],
        growth(s, HEX));
}

/* Whether a space has more of the tip than halfway from what r = 1 has to all of it. */
static const char *helps(const struct study_locking *s, int space, int n)
{
    return judge_words(judge_below((1 + s->limit) / 2, study_locking_through(s, space, n)),
                       "helps", "does not help", "has no equilibrium");
}

static void tell(const struct study_locking *s, FILE *file)
{
    static const double LITTLE = 0.05; /* of the tip */
    const int paper = find(s, 1e-3), n = paper < 0 ? 0 : paper;
    const double h = 1e3 * s->thickness[n],
                 change = tip(s, CUBIC_R2, n) / tip(s, CUBIC, n) - 1;

    fprintf(file, "What locks, and what does not\n\n");
    tell_shear(s, n, file);
    judge_say(
        file,
        "Thickness locking. At h = %g mm the tip at nu = 0.3 over that at nu = 0 is %.3f "
        "for "
        "degree (3,3,1), %.3f for (4,4,1), %.3f for (3,3,2); theory has %.3f for r = 1. "
        "Degree 4 in the plane %s, r = 2 %s, with incompatible modes (%.3f) a hexahedron "
        "%s.",
        h, study_locking_through(s, CUBIC, n), study_locking_through(s, QUARTIC, n),
        study_locking_through(s, CUBIC_R2, n), s->limit, helps(s, QUARTIC, n),
        helps(s, CUBIC_R2, n), study_locking_through(s, CURED, n), helps(s, CURED, n));
    judge_say(
        file,
        "Cost. Hexahedra with incompatible modes, 10x10x2, have %.3f of the tip at h = %g "
        "mm "
        "for %.2g times the paper's set-up and solve; degree (3,3,2) %.3f for %.2g times; "
        "the paper's own space has %.3f.",
        tip(s, CURED, n), h, cost(s, CURED), tip(s, CUBIC_R2, n), cost(s, CUBIC_R2),
        tip(s, PAPER, n));
    judge_print(file, "higher degree through the thickness makes little difference",
                judge_below(fabs(change), LITTLE),
                "From r = 1 to r = 2 the tip at h = %g mm falls %.1f %% farther (degree 3; "
                "little: below %.0f %%).",
                h, 100 * change, 100 * LITTLE);
    measurement_machine(s->machine, file);
}

/* --- Files. */

/* A row for each equilibrium. */
static struct table *fill(const struct study_locking *s)
{
    static const struct table_column columns[] = {
        {"space", NULL, TABLE_LEFT},
        {"model", NULL, TABLE_LEFT},
        {"poisson"},
        {"thickness", "mm", .key = "thickness_m", .key_unit = "m", .scale = 1e3},
        {"tip over Kirchhoff", .key = "tip_over_kirchhoff"},
        {"error"},
        {"unknowns"},
        {"set-up", "s", .key = "setup_s"},
        {"equilibrium", "s"}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns, NULL);

    for (int k = 0; k < STUDY_LOCKING_NUS * STUDY_LOCKING_SPACES * s->count; k++) {
        const int nu = STUDY_LOCKING_BOTH - k / s->count / STUDY_LOCKING_SPACES;
        const int space = k / s->count % STUDY_LOCKING_SPACES, n = k % s->count;
        const struct study_locking_cell *c = &s->cell[space][nu][n];
        const double row[] = {study_locking_nu[nu], s->thickness[n], c->tip,
                              fabs(1 - c->tip),     c->unknowns,     c->setup,
                              c->equilibrium};
        table_row(t);
        table_text(t, "%s", study_locking_space[space].label);
        table_text(t, "%s", model_of(space)->name);
        study_print_numbers(t, "4444444", row);
    }
    return t;
}

/* A row of panels for each family, a column for each Poisson's ratio. */
static struct chart *make_chart(const struct table *t)
{
    const struct study_locking_space *space = study_locking_space;
    const struct chart_axis h = chart_axis_of(t, "thickness_m", true),
                            error = {"|1 - tip / Kirchhoff|", NULL, true, 1e-4, 1.2};
    struct chart *c = chart_create(
        "Locking of a cantilever: of shear alone at nu = 0, both kinds at nu = 0.3");

    chart_columns(c, STUDY_LOCKING_NUS);
    chart_axes(c, &h, &error);
    for (int first = 0, end; first < STUDY_LOCKING_SPACES; first = end)
        for (int nu = 0; nu < STUDY_LOCKING_NUS; nu++) {
            study_cantilever_panel(c, space[first].family, study_locking_nu[nu]);
            for (end = first; end < STUDY_LOCKING_SPACES &&
                              !strcmp(space[end].family, space[first].family);
                 end++)
                study_cantilever_line(c, t, "thickness_m",
                                      &(struct chart_series){space[end].label},
                                      study_locking_nu[nu], NULL);
        }
    return c;
}

enum status study_locking_tell(const struct study_locking *s, const char *folder,
                               enum table_format format, FILE *file, struct message *why)
{
    struct table *all;
    enum status st;

    TRY(print_tips(s, format, file));
    TRY(print_parts(s, format, file));
    TRY(print_prototype(s, format, file));
    if (table_format_is_prose(format))
        tell(s, file);
    all = fill(s);
    st = study_cantilever_save(all, "locking", make_chart(all), "locking", folder, why);
out:
    return st;
}
