#include <math.h>

#include "bench/verify/verify_check.h"

/* Claims: 2e-3 of a shell's crest, which stands 0.9 l high on spans of 0.16 l, 1 % of
 * solids and triangles, as of heavy strips. Those marked have one gap. */
static const struct verify_subject entries[] = {
    {"iga_selective", 0.01, NULL, {64}, {3}, .mark = true},
    {"shell_3", 1e-3, NULL, {64}, {4}},
    {"triangles", 0.01, NULL, {64, 128}, {3, 3}},
    {"mass_spring,position_based,projective_dynamics", 0, NULL, {48}, {3}, .mark = true},
    {NULL}};
static const struct verify_field field = {.subject = entries};

/* A strip 1 m long, of l = 0.1 m, whose end is carried over to its other end. The weight
 * compresses contact by a share ROOT / (1 + ROOT) of its range, half the gap. */
static const double L0 = 0.1, WIDTH = 0.1, THICK = 0.002, WEIGHT = 100 * 9.81 * 0.002,
                    ROOT = 0.02, CARRIED = 1.5;

/* The claim on the layers' distance, of which the law takes ROOT / 2. */
static const double APART = 1e-3;

enum { LAST = 50, POINTS = 801 };

/* Means of the last half second. */
struct shape {
    double crest, tip; /* above the lower layer, out of the held ends [m] */
    double apart;      /* of the layers where they lie flat           [m] */
};

static enum status look(void *context, const struct motion *m, struct message *why)
{
    struct shape *s = context;
    double lower[3], upper[3], x[3], crest = -INFINITY, tip = -INFINITY;

    (void)why;
    if (m->frames + LAST <= m->frame_count)
        return STATUS_OK;
    m->model->probe(m->state, 1, (double[]){0.1, 0.5, 0.5}, lower);
    m->model->probe(m->state, 1, (double[]){0.9, 0.5, 0.5}, upper);
    for (int n = 0; n < POINTS; n++) {
        m->model->probe(m->state, 1, (double[]){n / (POINTS - 1.0), 0.5, 0.5}, x);
        crest = fmax(crest, x[2] - lower[2]);
        tip = fmax(tip, x[0]);
    }
    s->crest += crest / LAST, s->tip += tip / LAST;
    s->apart += (upper[2] - lower[2]) / LAST;
    return STATUS_OK;
}

/* Carries the end u = 1 over to the other one, above it by what separates the layers. */
static void add_supports(struct verify_trial *t, double apart)
{
    enum { ROWS = 24 };

    settings_set(&t->settings, "supports=[{at: {u: 0, w: 0.5}, fix: xyz}, {at: {u: 1, w: "
                               "0.5}, fix: xyz, path: [");
    for (int n = 0; n <= ROWS; n++) {
        const double turn = 3.14159265358979 * n / ROWS;
        settings_more(&t->settings, "%s[%g,%.17g,0,%.17g]", n ? "," : "",
                      CARRIED * n / ROWS, (cos(turn) - 1) / 2,
                      sin(turn) / 2 + apart * n / ROWS);
    }
    settings_more(&t->settings, "]}]");
}

/* Folds; returns the shape's distance from the truth, over l. */
static double fold(struct verify_trial *t, void *context)
{
    const struct verify_subject *s = t->subject;
    const double gap = verify_number(s, "gap_over_l") * L0, range = gap / 2;
    const double start = gap + range * ROOT / (1 + ROOT);
    struct shape *shape = context;

    *shape = (struct shape){0};
    add_supports(t, gap);
    verify_trial_set(
        t,
        "sheet={length: 1, width: %g, thickness: %g}; pose={origin: [0,0,%.17g]};"
        "material={young: %.17g, poisson: 0, density: 100};"
        "damping={kind: mass, value: 10};"
        "obstacles=[{plane: {point: [0,0,0], normal: [0,0,1]}}];"
        "contact={thickness: %.17g, range: %.17g, stiffness: %.17g};"
        "time={step: 0.01, end: 2.5}",
        WIDTH, THICK, start / 2, 12 * WEIGHT * L0 * L0 * L0 / (THICK * THICK * THICK),
        start, range, WEIGHT / ROOT / ROOT);
    verify_trial_watch(t, look, shape);
    return shape->crest / L0;
}

static void add_rows(struct verify_subject *s)
{
    const double gap = verify_number(s, "gap_over_l");
    const double tip =
        0.5 / L0 + verify_number(s, "tip_over_l") -
        (verify_number(s, "arc_over_l") + verify_number(s, "back_over_l")) / 2;
    struct shape shape;

    if (gap < 0.02 || (s->mark && gap != 0.05))
        return;
    struct verify_trial t = verify_trial_of(s, "free_fall", "crest / l, gap = %g l", gap);
    if (!verify_trial_nets(&t, fold, &shape, verify_number(s, "crest_over_l"), 1e-7))
        return;
    verify_row_judge(verify_sheet_add(s, "reach of the fold / l, gap = %g l", gap),
                     shape.tip / L0, tip, 1e-7);
    verify_subject_claim(s, APART, NULL);
    verify_row_judge(verify_sheet_add(s, "layers apart / l, gap = %g l", gap),
                     shape.apart / L0, gap, 0);
}

const struct verify_check verify_fold = {
    {"fold", "a heavy strip folded upon itself on the ground"},
    "inextensible elastica by shooting, tests/reference/contact_fold.csv, 1e-8",
    "contact_fold",
    .slow = true,
    .parts = {{&field, add_rows}}};
