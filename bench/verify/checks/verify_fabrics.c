/* The cantilever of ASTM D1388, option A, for measured fabrics: a strip is pushed over an
 * edge until its tip lies 41.5 degrees below the edge; half the overhang O is the bending
 * length c, and weight per area times c^3 the flexural rigidity. */
#include <math.h>

#include "bench/verify/checks/verify_strips.h"
#include "fem_ref/elastica.h"

static const double GRAVITY = 9.81;
/* Thickness, which the table has not and only solids need: 1/60 to 1/100 of these
 * overhangs [m]. E follows from D. */
static const double THICKNESS = 5e-4;
static const double FOUND = 1e-6; /* relative step at which the secant method ends      */
enum { MOST_TRIES = 12 };
#define ANGLE (41.5 * acos(-1) / 180)

/* Finds the Gamma at which the elastica's tip lies there, 8.0042. */
static double gamma_of_angle(struct verify_sheet *sheet)
{
    double low = 7, high = 9, gamma = NAN;
    struct elastica_point e;

    for (int n = 0; n < 40; n++) {
        gamma = (low + high) / 2;
        if (!verify_sheet_holds(sheet, elastica_solve(gamma, &e)))
            break;
        *(atan2(e.drop, e.reach) < ANGLE ? &low : &high) = gamma;
    }
    return gamma;
}

/* Returns how far below 41.5 degrees the tip is at an overhang [m]. */
static double tip_angle(struct verify_trial *t, double overhang)
{
    const double D = verify_number(t->subject, "D_eq_Nm");
    const double weight = verify_number(t->subject, "area_density_kg_m2");
    double xyz[3] = {0};

    verify_trial_set(t,
                     "sheet={length: %.17g, width: %.17g, thickness: %.17g};"
                     "material={young: %.17g, poisson: 0, density: %.17g};"
                     "gravity=[0,0,-9.81]",
                     overhang, VERIFY_STRIPS_WIDTH * overhang, THICKNESS,
                     12 * D / (THICKNESS * THICKNESS * THICKNESS), weight / THICKNESS);
    verify_trial_tip(t, xyz);
    return atan2(-xyz[2], xyz[0]) - ANGLE;
}

/* Finds half the overhang at 41.5 degrees by the secant method in log(overhang). */
static double bending_length(struct verify_trial *t, void *context)
{
    const double *overhang = context;
    double x[2] = {log(*overhang), log(1.05 * *overhang)}, off[2] = {0};

    t->lived = true;
    for (int n = 0; n < 2 && t->lived; n++)
        off[n] = tip_angle(t, exp(x[n]));
    for (int n = 0; t->lived && n < MOST_TRIES && fabs(x[1] - x[0]) > FOUND; n++) {
        double step = -off[1] * (x[1] - x[0]) / (off[1] - off[0]);
        x[0] = x[1], off[0] = off[1];
        x[1] += fmin(fmax(step, -1), 1);
        off[1] = tip_angle(t, exp(x[1]));
    }
    if (t->lived && !(fabs(x[1] - x[0]) <= FOUND)) {
        t->lived = false;
        verify_row_end(t->row, VERIFY_DIED, "no overhang found in %d tries", MOST_TRIES);
    }
    return exp(x[1]) / 2;
}

static void add_row(struct verify_subject *s)
{
    const char *name = reference_text(s->sheet->table, s->at, "fabric");

    const double D = verify_number(s, "D_eq_Nm");
    const double weight = verify_number(s, "area_density_kg_m2") * GRAVITY;
    const double gamma = gamma_of_angle(s->sheet);
    double overhang = cbrt(gamma * D / weight);
    s->changed = NULL;
    struct verify_trial t =
        verify_trial_of(s, "cantilever", "bending length [m], %s", name);
    if (!s->contestant->model->equilibrium)
        verify_row_end(t.row, VERIFY_NOT_APPLICABLE,
                       "at this Gamma it does not come to rest (see elastica)");
    else if (verify_trial_nets(&t, bending_length, &overhang, overhang / 2, FOUND)) {
        verify_row_note(t.row, "%s: weight c^3 = %.4g N m for D = %.4g N m", name,
                        weight * pow(t.row->value, 3), D);
        if (verify_subject_is_linear(s))
            verify_row_end(t.row, VERIFY_OUT_OF_RANGE,
                           "small strains reach to Gamma = %g, this is at %.4g",
                           VERIFY_STRIPS_LINEAR_GAMMA, gamma);
    }
}

const struct verify_check verify_fabrics = {
    {"fabrics", "bending length of ten fabrics by the cantilever of ASTM D1388"},
    "the elastica at 41.5 degrees, Gamma = 8.0042 (fem_ref/elastica.h, 1e-10), for D and "
    "weight of tests/reference/fabrics.csv; error bar: of the overhang found; h = 0.5 mm, "
    "E = 12 D / h^3, nu = 0",
    "fabrics",
    .parts = {{&verify_strips, add_row, .every = 9}}};
