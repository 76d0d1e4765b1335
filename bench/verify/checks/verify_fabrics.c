/* Measured fabrics: the test by which they bend, and how far they stretch.
 *
 * The cantilever of ASTM D1388, option A, for measured fabrics: a strip is pushed over an
 * edge until its tip lies 41.5 degrees below the edge; half the overhang O is the bending
 * length c, and weight per area times c^3 the flexural rigidity. */
#include <math.h>
#include <string.h>

#include "bench/verify/checks/verify_strips.h"
#include "fem_ref/elastica.h"
#include "models/law/law_fabrics.h"

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
        verify_row_end(t->row, VERDICT_DIED, "no overhang found in %d tries", MOST_TRIES);
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
        verify_row_end(t.row, VERDICT_NOT_APPLICABLE,
                       "at this Gamma it does not come to rest (see elastica)");
    else if (verify_trial_nets(&t, bending_length, &overhang, overhang / 2, FOUND)) {
        verify_row_note(t.row, "%s: weight c^3 = %.4g N m for D = %.4g N m", name,
                        weight * pow(t.row->value, 3), D);
        if (verify_subject_is_linear(s))
            verify_row_end(t.row, VERDICT_OUT_OF_RANGE,
                           "small strains reach to Gamma = %g, this is at %.4g",
                           VERIFY_STRIPS_LINEAR_GAMMA, gamma);
    }
}

/* --- 251 fabrics with their own law, warp, weft and bias. */

/* Width over overhang: so narrow that cross-sections bend freely (verify_orthotropic.c),
 * and that the clamp, which keeps the bias from twisting over a width or two, matters
 * little. Thin [m], so that no strip is thicker than wide: such would tip over. */
static const double NARROW = 0.005, THIN = 5e-5;
static const double LEAST_SHEAR = 0.1; /* S_66 over sqrt(S_11 S_22); 20 fabrics need it */
/* Twist over bend up to which a strip along the bias stays in its plane, as 107 fabrics do.
 * The rest wind out of it, and their overhang is not the formula's. */
static const double TWIST = 0.1;
static const double angles[] = {0, 90, 45, 45};
static const char *const names[] = {"warp", "weft", "bias that hardly twists", "bias"};
enum { STRAIGHT_BIAS = 2, BIAS, DIRECTIONS, QUICK_EVERY = 25 };

#define ASKED 0.01, "1 % is asked of the nonlinear solid"
static const struct verify_subject bent[] = {
    {"shell_3", ASKED, {20}, {4}, 2},
    {"iga_selective_3", ASKED, {20}, {4}, 2, .dear = true},
    {"triangles", ASKED, {80}, {3}},
    {NULL}};
static const struct verify_field bent_field = {bent};

/* Computes a law that the three strips have, by the compliances S = B^-1: 4 / B_bias = S_11
 * + S_22 + 2 S_12 + S_66. S_12 was not measured: it is 0 unless that leaves too little
 * S_66. Returns the twist k12 over the bend k11 along the bias. */
static double bending_of(const struct verify_subject *s, double B[LAW_MODULI])
{
    const double warp = 1 / verify_number(s, "B_warp"),
                 weft = 1 / verify_number(s, "B_weft");
    const double bias = 4 / verify_number(s, "B_bias") - warp - weft;
    const double shear = fmax(bias, LEAST_SHEAR * sqrt(warp * weft));
    const double cross = (bias - shear) / 2, determinant = warp * weft - cross * cross;

    B[LAW_WARP] = weft / determinant, B[LAW_WEFT] = warp / determinant;
    B[LAW_CROSS] = -cross / determinant, B[LAW_SHEAR] = 1 / shear;
    return fabs(warp - weft) / 4 * verify_number(s, "B_bias");
}

/* Returns the angle to which the tip comes nearer with the logarithm of the overhang. */
static double slope_of_angle(struct verify_sheet *sheet, double gamma)
{
    const double more = 1.01;
    struct elastica_point e = {0}, f = {0};

    verify_sheet_holds(sheet, elastica_solve(gamma, &e));
    verify_sheet_holds(sheet, elastica_solve(gamma * pow(more, 3), &f));
    return (atan2(f.drop, f.reach) - atan2(e.drop, e.reach)) / log(more);
}

/* Judges the overhang of one fabric: what remains of the angle where the formula has it,
 * turned into a change of the overhang. */
static bool judge_overhang(struct verify_trial *t, int direction,
                           const double B[LAW_MODULI], double gamma, double slope)
{
    const double weight = verify_number(t->subject, "areal_density") * GRAVITY;
    const char *const column[] = {"B_warp", "B_weft", "B_bias", "B_bias"};
    const double stiffness = verify_number(t->subject, column[direction]);
    const double overhang = cbrt(gamma * stiffness / weight);
    const double solid = 12 / (THIN * THIN); /* Y / B of a solid sheet as thick */
    double xyz[3] = {0};

    verify_trial_set(t,
                     "sheet={length: %.17g, width: %.17g}; gravity=[0,0,-9.81]; material="
                     "{membrane: [%.17g, %.17g, %.17g, %.17g], bending: [%.17g, %.17g, "
                     "%.17g, %.17g], areal_density: %.17g, warp: %g}",
                     overhang, NARROW * overhang, B[0] * solid, B[1] * solid, B[2] * solid,
                     B[3] * solid, B[0], B[1], B[2], B[3], weight / GRAVITY,
                     angles[direction]);
    if (!verify_trial_tip(t, xyz))
        return false;
    const double off = (ANGLE - atan2(-xyz[2], xyz[0])) / slope;
    verify_trial_worst(t, overhang * exp(off), overhang, (double[]){fabs(off)}, off * off);
    return true;
}

/* Adds the worst of all fabrics in a direction. */
static void add_overhang(struct verify_subject *s)
{
    const int direction = s->at, rows = reference_rows(s->sheet->table);
    const double gamma = gamma_of_angle(s->sheet);
    const double slope = slope_of_angle(s->sheet, gamma);
    if (direction == BIAS)
        s->tolerance = NAN, s->reason = "strips wind out of their plane";
    struct verify_trial t = verify_trial_of(
        s, "cantilever", "overhang [m], %s, worst of Feng's fabrics", names[direction]);

    for (s->at = 0; s->at < rows; s->at += s->sheet->quick ? QUICK_EVERY : 1) {
        double B[LAW_MODULI];
        if (bending_of(s, B) > TWIST && direction == STRAIGHT_BIAS)
            continue;
        if (!judge_overhang(&t, direction, B, gamma, slope))
            return;
    }
}

/* --- The stretch of fabrics that `list fabrics` has, by the tables they come from. */

static const double STRAIN = 1e-4; /* does not wrinkle at the clamp */
static const double PULLED_LENGTH = 0.4, PULLED_WIDTH = 0.01; /* [m] */
static const struct verify_subject pulled[] = {
    {"shell_3", 0.005, "splines have its strain", {40}, {5}},
    {"triangles", 0.01, "constant strains on each side of u = 1/2", {81}, {5}},
    {NULL}};
static const struct verify_field pulled_field = {pulled};

/* Judges the worst direction against 1 / (A^-1)_11, from Y11, Y22, Y12 and G [N/m]. */
static void judge_stretch(struct verify_subject *s, const char *name, double warp,
                          double weft, double cross, double shear)
{
    const bool bias = s->contestant->model->serves & SCENE_NEED_BIAS;
    const double determinant = warp * weft - cross * cross;
    const double soft[] = {weft / determinant, warp / determinant,
                           ((warp + weft - 2 * cross) / determinant + 1 / shear) / 4};
    const double uvw[2][3] = {{0.25, 0.5, 0.5}, {0.75, 0.5, 0.5}};
    struct verify_trial t = verify_trial_of(s, "cantilever", "stretch, %s, worst of %s",
                                            name, bias ? "warp, weft, bias" : "warp, weft");

    for (int d = 0; d < (bias ? 3 : 2); d++) {
        double xyz[2][3] = {{0}};
        verify_trial_set(&t,
                         "sheet={length: %g, width: %g}; material={fabric: %s, warp: %g}; "
                         "gravity=[0,0,0]; loads=[{at: {u: 1}, force: [%.17g, 0, 0]}]",
                         PULLED_LENGTH, PULLED_WIDTH, name, angles[d],
                         STRAIN / soft[d] * PULLED_WIDTH);
        if (!verify_trial_equilibrium(&t, 2, uvw[0], xyz[0]))
            return;
        const double stretch = (xyz[1][0] - xyz[0][0]) / (0.5 * PULLED_LENGTH) - 1;
        verify_trial_worst(&t, stretch, STRAIN, (double[]){fabs(stretch / STRAIN - 1)},
                           1.5 * STRAIN); /* of Green's strain */
    }
}

static void add_clyde(struct verify_subject *s)
{
    const double h = verify_number(s, "h");

    judge_stretch(s, reference_text(s->sheet->table, s->at, "fabric"),
                  verify_number(s, "k11") * h, verify_number(s, "k22") * h,
                  verify_number(s, "k12") * h, verify_number(s, "G12") / 2 * h);
}

/* ARCSim's energies are k0 E11^2 + 2 k1 E11 E22 + k2 E22^2 + k3 E12^2. The fabric that the
 * list leaves out has no row. */
static void add_wang(struct verify_subject *s)
{
    const char *file = reference_text(s->sheet->table, s->at, "fabric");

    for (const struct law_fabrics_row *f = law_fabrics; f->name; f++)
        if (strstr(f->what, file))
            judge_stretch(s, f->name, 2 * verify_number(s, "k0"),
                          2 * verify_number(s, "k2"), 2 * verify_number(s, "k1"),
                          verify_number(s, "k3") / 2);
}

const struct verify_check verify_fabrics = {
    {"fabrics", "measured fabrics: cantilever test of ASTM D1388, stretch"},
    "the elastica at 41.5 degrees, Gamma = 8.0042 (fem_ref/elastica.h, 1e-10), for D and "
    "weight of tests/reference/fabrics.csv; error bar: of the overhang found; h = 0.5 mm, "
    "E = 12 D / h^3, nu = 0; for B of tests/reference/feng2022.csv; stretch by 1 / "
    "(A^-1)_11 of tests/reference/clyde2017.csv and fabrics.csv",
    "fabrics",
    .parts = {{&verify_strips, add_row, .every = 9},
              {&pulled_field, add_wang, .every = 3},
              {&bent_field, add_overhang, DIRECTIONS, .table = "feng2022"},
              {&pulled_field, add_clyde, .every = 3, .table = "clyde2017"}}};
