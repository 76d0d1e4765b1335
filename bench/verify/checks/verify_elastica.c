#include <math.h>
#include <string.h>

#include "bench/verify/checks/verify_strips.h"

static const double BAR = 1e-10; /* of the table, relative */
/* Way in the last half of the time, of the drop, up to which a strip counts as at rest:
 * less than the error of any net here. */
static const double REST = 1e-4;

/* Moves, damped with twice the lowest frequency, near the critical, over some ten decay
 * times; writes where the tip ends. */
static void come_to_rest(struct verify_trial *t, double gamma, double *xyz)
{
    enum { STEPS = 2000 };
    /* omega^2 = 3.516^2 B / (rho h L^4) in the beam's first mode, or that of a pendulum. */
    const double rate = sqrt(9.81 * fmax(12.36 / gamma, 1.5)), end = 20 / rate;
    double both[2][3];

    verify_trial_set(
        t, "damping.kind=mass; damping.value=%.17g; time.step=%.17g; time.end=%.17g",
        2 * rate, end / STEPS, end);
    if (!verify_trial_motion(t, 2, (double[]){end / 2, end}, 1, (double[]){1, 0.5, 0.5},
                             both[0]))
        return;
    memcpy(xyz, both[1], sizeof both[1]);
    const double moved = hypot(both[1][0] - both[0][0], both[1][2] - both[0][2]);
    if (t->net == t->subject->nets - 1 &&
        moved > REST * verify_number(t->subject, "H_over_L")) {
        verify_row_end(t->row, VERDICT_NOT_APPLICABLE,
                       "not at rest: moved %.2g L in the last half", moved);
        t->lived = false;
    }
}

/* Adds the settings of a strip of weight gamma. */
static void add_strip(struct verify_trial *t, double width, double gamma)
{
    /* E h^3 / 12 = rho g h / Gamma for L = 1: the load is kept, the stiffness follows. */
    const double thickness = 1e-3, weight = 0.05 * 9.81 * thickness;

    verify_trial_set(t, "sheet.width=%.17g; material.poisson=0; material.young=%.17g",
                     width, 12 * weight / gamma / (thickness * thickness * thickness));
}

static void measure(struct verify_trial *t, double at[2])
{
    const double gamma = verify_number(t->subject, "Gamma");
    double xyz[3] = {NAN, NAN, NAN};

    add_strip(t, VERIFY_STRIPS_WIDTH, gamma);
    if (t->subject->contestant->model->equilibrium)
        verify_trial_tip(t, xyz);
    else
        come_to_rest(t, gamma, xyz);
    at[0] = -xyz[2], at[1] = xyz[0];
}

/* No weight at all has a decade of its own, -INFINITY. */
static double decade(const struct verify_subject *s, int row)
{
    return floor(log10(reference_number(s->sheet->table, row, "Gamma")) + 1e-9);
}

/* Adds a row for the worst load of a decade, at the first of them. */
static void add_row(struct verify_subject *s)
{
    static const char *const truth[] = {"H_over_L", "W_over_L"};
    const struct reference *table = s->sheet->table;
    const bool linear = verify_subject_is_linear(s);
    const int first = s->at, rows = reference_rows(table);
    int last = first;

    if (first && decade(s, first - 1) == decade(s, first))
        return;
    while (last + 1 < rows && decade(s, last + 1) == decade(s, first))
        last++;
    const double from = verify_number(s, "Gamma"),
                 to = reference_number(table, last, "Gamma");
    struct verify_trial t = verify_trial_of(s, "cantilever", "%s, Gamma = %.3g .. %.3g",
                                            linear ? "drop / L" : "tip", from, to);
    if (!verify_strips_worst(&t, s, measure, last, s->sheet->quick ? rows : 1, truth, BAR))
        verify_row_note(t.row, "Gamma = %.4g", verify_number(s, "Gamma"));
    else if (linear && to > VERIFY_STRIPS_LINEAR_GAMMA)
        verify_row_end(t.row, VERDICT_OUT_OF_RANGE, "small strains reach to Gamma = %g",
                       VERIFY_STRIPS_LINEAR_GAMMA);
}

/* The drop of a square on the paper's own net, cured; 2 % are asked as of the plate's
 * deflection, since at Gamma = 100 the clamp's bend takes one of its eight spans. */
#define ASKED                                                                              \
    0.02, "asked of the paper's net", {10}, {10},                                          \
        .changed = "as now, in a test, where it was 2.1 % for a while after it was missed"
static const struct verify_subject square[] = {{"iga_selective", ASKED}, {NULL}};
static const struct verify_field squares = {.subject = square};

static void add_square(struct verify_subject *s)
{
    const double gamma = verify_number(s, "Gamma");
    double xyz[3];

    if (gamma != 10 && gamma != 100)
        return;
    struct verify_trial t =
        verify_trial_of(s, "cantilever", "drop / L of a square, Gamma = %g", gamma);
    add_strip(&t, 1, gamma);
    if (verify_trial_tip(&t, xyz))
        verify_row_judge(t.row, -xyz[2], verify_number(s, "H_over_L"), BAR);
}

const struct verify_check verify_elastica = {
    {"elastica", "tip of a heavy strip, clamped level, at any weight"},
    "inextensible elastica by shooting, tests/reference/heavy_elastica.csv, 1e-10; error: "
    "the tip's distance, of its drop; the worst of a decade",
    "heavy_elastica",
    .parts = {{&verify_strips, add_row}, {&squares, add_square}}};
