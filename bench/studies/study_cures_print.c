/* The tables of study_cures.h, what they say, and the chart. */
#include <math.h>

#include "bench/experiment/judge.h"
#include "bench/experiment/measurement.h"
#include "bench/experiment/study.h"
#include "bench/studies/study_cantilever.h"
#include "bench/studies/study_cures.h"

/* Two degrees, each with the paper's way first. */
enum { HALF = STUDY_CURES_SPACES / 2 };

static const char *law_name(int law, char text[48])
{
    snprintf(text, 48, study_cures_gamma[law] > 0 ? "nonlinear, Gamma = %g" : "linear",
             study_cures_gamma[law]);
    return text;
}

static bool solved(const struct study_cures *s, int law, int nu, int n)
{
    return !isnan(s->tip[STUDY_CURES_TRUTH][law][nu][n].z);
}

/* |error| at worst over the thicknesses of a nu; NaN if it died at one. */
static double worst_of(const struct study_cures *s, int space, int law, int nu)
{
    double worst = 0;

    for (int n = 0; n < STUDY_CURES_THICKNESSES; n++)
        if (solved(s, law, nu, n))
            worst = judge_most(worst, study_cures_error(s, space, law, nu, n));
    return worst;
}

/* The truth's own error bar: the coarser net's difference, at worst. */
static double bar(const struct study_cures *s, int law)
{
    double worst = 0;

    for (int nu = 0; nu < STUDY_CURES_NUS; nu++)
        worst = judge_most(worst, worst_of(s, STUDY_CURES_COARSER, law, nu));
    return worst;
}

static struct table *law_table(const struct study_cures *s, int law)
{
    static const struct table_column columns[] = {
        {"space, remedy", NULL, TABLE_LEFT, .readers = TABLE_PEOPLE},
        {"space", NULL, TABLE_LEFT, .readers = TABLE_MACHINES},
        {"nu"},
        {"h/L 1e-1"},
        {"1e-2"},
        {"1e-3"},
        {"1e-4"},
        {"1e-5"},
        {"worst", "%"},
        {"within 2 %"}};
    const double gamma = study_cures_gamma[law];
    char caption[160];

    snprintf(caption, sizeof caption,
             gamma > 0
                 ? "Nonlinear cantilever, 10x10x2, Gamma = %g: tip's drop over the truth"
                 : "Linear cantilever, 10x10x2: tip's drop over the truth",
             gamma);
    struct table *t = table_create(sizeof columns / sizeof *columns, columns, caption);
    for (int row = 0; row < STUDY_CURES_SPACES * STUDY_CURES_NUS; row++) {
        const int space = row / STUDY_CURES_NUS, nu = row % STUDY_CURES_NUS;
        const double worst = worst_of(s, space, law, nu);
        if (row == HALF * STUDY_CURES_NUS)
            table_rule(t);
        table_row(t);
        table_text(t, "%s", nu ? "" : study_cures_space[space].label);
        table_text(t, "%s", study_cures_space[space].label);
        table_fixed(t, study_cures_nu[nu], 2);
        for (int n = 0; n < STUDY_CURES_THICKNESSES; n++)
            table_fixed(t, study_cures_ratio(s, space, law, nu, n), 4);
        table_number(t, 100 * worst, 2);
        table_text(t, "%s", worst <= study_cures_target ? "yes" : "no");
    }
    table_note(
        t,
        "Truth: at h/L = 0.1 a 3-D solid of degree (4,4,3), graded; thinner, %s. On a "
        "coarser net it moves by %.2g %% at most. A dash: no equilibrium, or not asked.",
        gamma > 0 ? "the elastica at nu = 0, the shell of degree 4 at h/L = 0.01 else"
                  : "Kirchhoff's plate",
        100 * bar(s, law));
    return t;
}

/* The paper's way with locking at a space's degree. */
static int none_of(int space)
{
    return space / HALF * HALF;
}

/* Of the fastest repeats; NaN: one of the two was not timed. */
static double cost(const struct study_cures *s, int space)
{
    const struct clock_summary *own = &s->frame[space].step,
                               *none = &s->frame[none_of(space)].step;

    return own->count && none->count ? own->min / none->min : NAN;
}

/* Dearer only if more than the quartiles of the repeats leave open. */
static const char *cost_word(const struct study_cures *s, int space)
{
    const struct clock_summary *own = &s->frame[space].step,
                               *none = &s->frame[none_of(space)].step;

    return isnan(cost(s, space))       ? "one of them was not timed"
           : cost(s, space) <= 1       ? "no dearer"
           : own->lower <= none->upper ? "not told apart by these repeats"
                                       : "dearer";
}

static double median(const struct clock_summary *c)
{
    return c->count ? c->median : NAN;
}

static struct table *cost_table(const struct study_cures *s)
{
    static const struct table_column columns[] = {
        {"space, remedy", NULL, TABLE_LEFT},
        {"zero modes", "free", .key_unit = "1"},
        {"frame", "ms", .key = "frame_s", .key_unit = "s", .scale = 1e3},
        {"fastest", "ms", .key = "fastest_s", .key_unit = "s", .scale = 1e3},
        {"over none", "fastest", .key_unit = "1"},
        {"assemble", "ms", .key = "assemble_s", .key_unit = "s", .scale = 1e3},
        {"factor", "ms", .key = "factor_s", .key_unit = "s", .scale = 1e3}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns,
                                   "A rebuilt frame (incremental, edge_drop, 10x10x2)");

    for (int n = 0; n < STUDY_CURES_SPACES; n++) {
        const struct run_result *r = &s->frame[n];
        if (n == HALF)
            table_rule(t);
        table_row(t);
        table_text(t, "%s", study_cures_space[n].label);
        table_integer(t, s->zero_modes[n]);
        study_print_numbers(t, "33333",
                            (double[]){median(&r->step), r->step.count ? r->step.min : NAN,
                                       cost(s, n), median(&r->phase[0]),
                                       median(&r->phase[1])});
        if (r->outcome)
            table_note(t, "%s: %s.", study_cures_space[n].label, r->sentence.text);
    }
    table_note(
        t, "All spaces in turn; the fastest repeat tells them apart on a busy machine.");
    return t;
}

/* Which cells of a cure miss the target, in words. */
static void tell_misses(const struct study_cures *s, int space, FILE *file)
{
    enum { NAMED = 6 };
    int misses = 0, cells = 0;
    char name[48];

    fprintf(file, "- %s: ", study_cures_space[space].label);
    for (int law = 0; law < STUDY_CURES_LAWS; law++)
        for (int nu = 0; nu < STUDY_CURES_NUS; nu++)
            for (int n = 0; n < STUDY_CURES_THICKNESSES; n++) {
                const double error = study_cures_error(s, space, law, nu, n);
                cells += solved(s, law, nu, n);
                if (!solved(s, law, nu, n) || error <= study_cures_target)
                    continue;
                if (++misses > NAMED)
                    continue;
                fprintf(file, "%s%s nu %g h/L %g ", misses > 1 ? "; " : "misses ",
                        law_name(law, name), study_cures_nu[nu], study_cures_thickness[n]);
                fprintf(file, isnan(error) ? "(died)" : "(%.2g %%)", 100 * error);
            }
    fprintf(file, "%s%d of %d cells within %g %%.\n",
            misses > NAMED ? "; ...; "
            : misses       ? "; "
                           : "",
            cells - misses, cells, 100 * study_cures_target);
}

/* At h/L = 0.1 and large nu: how much of the miss the clamp's hold on the thickness is. */
static void tell_clamp(const struct study_cures *s, FILE *file)
{
    const int nu = STUDY_CURES_NUS - 1;
    const double slit = study_cures_ratio(s, STUDY_CURES_SLIT, 0, nu, 0) - 1;
    const double plate = study_cures_ratio(s, 5, 0, nu, 0) - 1;

    judge_say(
        file,
        "At h/L = 0.1, nu = %g a plate of one linear layer with plane stress is %.2g "
        "%% %s. A 3-D solid whose clamp leaves the thickness free (x and y held on the "
        "face, z on its lower edge) falls %.2g %% %s than the clamped one%s",
        study_cures_nu[nu], 100 * fabs(plate), plate > 0 ? "too soft" : "too stiff",
        100 * fabs(slit), slit > 0 ? "farther" : "less far",
        judge_words(judge_both(judge_below(0, plate), judge_below(plate, 2 * slit)),
                    ": that the clamp keeps the solid from changing its thickness, "
                    "which stiffens it over a length of some h and no plate knows, is "
                    "most of it.",
                    ": the clamp's hold on the thickness is not most of it.", "."));
}

/* Grows: to more than double from h/L 1e-3 to 1e-5. */
static void tell_bends(const struct study_cures *s, FILE *file)
{
    static const int space[] = {2, 5, 0};
    const int law = STUDY_CURES_LAWS - 1;
    const double clamp = pow(study_cures_gamma[law], -1. / 3);
    double thick[3], thin[3];
    enum judge grows[3];

    for (int n = 0; n < 3; n++) {
        const double h3 = study_cures_error(s, space[n], law, 0, 2);
        const double h5 = study_cures_error(s, space[n], law, 0, 4);
        thick[n] = 100 * h3, thin[n] = 100 * h5;
        grows[n] = n < 2 ? judge_below(h5, 2 * h3) : judge_below(2 * h3, h5);
    }
    judge_say(
        file,
        "At Gamma = %g the sheet bends within Gamma^(-1/3) = %.2g L of its clamp, on %.2g "
        "spans of eight. A cured sheet's error there %s as the sheet gets thinner (nu = 0, "
        "1e-3 and 1e-5: selective (2,2,1) %.2g %% and %.2g %%, (3,3,1) %.2g %% and %.2g "
        "%%). Without a cure it %s: %.2g %% and %.2g %%.",
        study_cures_gamma[law], clamp, 8 * clamp,
        judge_words(judge_both(grows[0], grows[1]),
                    "is one of resolution: it does not grow", "grows", "may grow"),
        thick[0], thin[0], thick[1], thin[1],
        judge_words(grows[2], "does", "does not", "may"), thick[2], thin[2]);
}

static void print_text(const struct study_cures *s, FILE *file)
{
    for (int n = 0; n < STUDY_CURES_SPACES && !s->quick; n++)
        tell_misses(s, n, file);
    if (s->quick)
        judge_say(file, "Cells within %g %%, and the clamp: not judged: quick.",
                  100 * study_cures_target);
    else
        tell_clamp(s, file);
    tell_bends(s, file);
    for (int n = 0; n < STUDY_CURES_SPACES; n++)
        if (n != none_of(n))
            judge_say(file, "A rebuilt frame of %s costs %.2f of none's: %s.",
                      study_cures_space[n].label, cost(s, n), cost_word(s, n));
    measurement_machine(s->machine, file);
}

/* --- Files. */

static struct table *fill_errors(const struct study_cures *s)
{
    enum { EACH = STUDY_CURES_SPACES * STUDY_CURES_THICKNESSES };
    static const struct table_column columns[] = {
        {"space", NULL, TABLE_LEFT}, {"gamma"},          {"poisson"},
        {"h/L", .key = "thickness"}, {"tip over truth"}, {"error"}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns, NULL);

    for (int cell = 0; cell < STUDY_CURES_LAWS * STUDY_CURES_NUS * EACH; cell++) {
        const int law = cell / EACH / STUDY_CURES_NUS, nu = cell / EACH % STUDY_CURES_NUS;
        const int space = cell % EACH / STUDY_CURES_THICKNESSES;
        const int n = cell % STUDY_CURES_THICKNESSES;
        const double row[] = {study_cures_gamma[law], study_cures_nu[nu],
                              study_cures_thickness[n],
                              study_cures_ratio(s, space, law, nu, n),
                              study_cures_error(s, space, law, nu, n)};
        if (isnan(row[3]))
            continue;
        table_row(t);
        table_text(t, "%s", study_cures_space[space].label);
        study_print_numbers(t, "66666", row);
    }
    return t;
}

/* A row of panels for each law, a column for each Poisson's ratio. */
static struct chart *make_chart(const struct table *t)
{
    const struct chart_axis h = {"h/L", NULL, true, 5e-6, 0.2},
                            error = {"|1 - tip / truth|", NULL, true, 1e-5, 2};
    struct chart *c = chart_create("Cures for locking, 10x10x2: tip against truth");
    char text[48];

    chart_columns(c, STUDY_CURES_NUS);
    chart_axes(c, &h, &error);
    for (int law = 0; law < STUDY_CURES_LAWS; law++)
        for (int nu = 0; nu < STUDY_CURES_NUS; nu++) {
            study_cantilever_panel(c, law_name(law, text), study_cures_nu[nu]);
            chart_band(c, "asked of a cure", study_cures_target, study_cures_target);
            for (int space = 0; space < STUDY_CURES_SPACES; space++) {
                const struct chart_series look = {study_cures_space[space].label,
                                                  .colour = space % HALF + 1,
                                                  .second = space >= HALF};
                study_cantilever_line(c, t, "thickness", &look, study_cures_nu[nu],
                                      &study_cures_gamma[law]);
            }
        }
    return c;
}

enum status study_cures_tell(const struct study_cures *s, const char *folder,
                             enum table_format format, FILE *file, struct message *why)
{
    struct table *errors;
    enum status st = STATUS_OK;

    for (int law = 0; law < STUDY_CURES_LAWS; law++)
        TRY(table_finish(law_table(s, law), format, file));
    TRY(table_finish(cost_table(s), format, file));
    if (table_format_is_prose(format))
        print_text(s, file);
    errors = fill_errors(s);
    st = study_cantilever_save(errors, "errors", make_chart(errors), "cures", folder, why);
out:
    return st;
}
