/* Small deflections and frequencies of flat shells against Kirchhoff's plate: deflections
 * in closed form or by Ritz series (reference/README's values), frequencies of
 * reference/leissa_plate_frequencies.csv. */
#include "fem_ref/reference.h"
#include "tests/shell_sheet.h"

/* The references print six digits. With nu > 0 the corner where a clamped edge meets a free
 * one is singular and slows convergence: measured 2e-4 with 16 cubic spans. */
static const double DEFLECTION = 1e-5, DEFLECTION_CORNER = 3e-4;
/* Linear and nonlinear equilibria at a deflection of 1e-5 of the thickness differ by its
 * square. */
static const double SMALL = 1e-8;
/* Ritz values are exact to their est_err, at most 1e-4 lambda; 16 cubic spans stay below
 * that in six modes, but for the singular corners, by nu: measured 2.5e-4 at 0.3, 5e-4 at
 * 0.49. */
static const double FREQUENCY = 1e-4, FREQUENCY_CORNER = 2e-3;

enum { SPANS = 16 };

static void plate(struct sheet *s, double nu, enum kinematics kinematics)
{
    sheet_init(s, 3, SPANS, SPANS);
    s->d.kinematics = kinematics;
    s->scene.poisson = nu;
    s->scene.thickness = 1e-3;
    s->scene.young = 1e9;
}

/* A load that gives q L^4 / D = 1e-5 h / 0.1. */
static double load(struct sheet *s)
{
    double deflection = 1e-4 * s->scene.thickness;

    s->scene.density = 1;
    s->scene.gravity[2] =
        -deflection * scene_bending_stiffness(&s->scene) / s->scene.thickness;
    return deflection;
}

static double deflection(struct sheet *s, double u, double v)
{
    double by[3];

    sheet_moved(s, u, v, by);
    return -by[2];
}

static void check_cantilever(double nu, double corner, double middle)
{
    struct sheet s;

    plate(&s, nu, KINEMATICS_LINEAR);
    double unit = load(&s);
    sheet_hold(&s, 0, 0, FIX_XYZ, true);
    sheet_start(&s);
    sheet_settle(&s);
    CHECK_RELATIVE(deflection(&s, 1, 0) / unit, corner,
                   nu > 0 ? DEFLECTION_CORNER : DEFLECTION);
    CHECK_RELATIVE(deflection(&s, 1, 0.5) / unit, middle,
                   nu > 0 ? DEFLECTION_CORNER : DEFLECTION);
    sheet_clear(&s);
}

static void check_simply_supported(enum kinematics kinematics, double *centre)
{
    struct sheet s;

    plate(&s, 0.3, kinematics);
    double unit = load(&s);
    for (int edge = 0; edge < 4; edge++)
        sheet_hold(&s, edge / 2, edge % 2, FIX_XYZ, false);
    sheet_start(&s);
    sheet_settle(&s);
    *centre = deflection(&s, 0.5, 0.5) / unit;
    CHECK_RELATIVE(*centre, 0.00406235, DEFLECTION);
    sheet_clear(&s);
}

/* Clamped all round: Taylor and Govindjee 2004, 0.00126532. */
static void check_clamped(void)
{
    struct sheet s;

    plate(&s, 0.3, KINEMATICS_LINEAR);
    double unit = load(&s);
    for (int edge = 0; edge < 4; edge++)
        sheet_hold(&s, edge / 2, edge % 2, FIX_XYZ, true);
    sheet_start(&s);
    sheet_settle(&s);
    CHECK_RELATIVE(deflection(&s, 0.5, 0.5) / unit, 0.00126532, DEFLECTION);
    sheet_clear(&s);
}

/* Rows of one plate in the table, from `row` on; returns the row behind them. */
static int check_frequencies(const struct reference *table, int row)
{
    enum { MODES = 6, ZEROS = 6 };
    const char *bc = reference_text(table, row, "bc");
    double nu = reference_number(table, row, "nu"),
           width = reference_number(table, row, "Ly");
    double omega[MODES + ZEROS];
    bool clamped = !strcmp(bc, "CFFF"), free = !strcmp(bc, "FFFF");
    struct message why = {{0}};
    struct sheet s;
    int next = row, skip = free ? ZEROS : 0;

    while (next < reference_rows(table) && !strcmp(reference_text(table, next, "bc"), bc) &&
           reference_number(table, next, "nu") == nu &&
           reference_number(table, next, "Ly") == width)
        next++;
    if ((!clamped && !free) || reference_number(table, row, "Lx") != 1)
        return next;
    plate(&s, nu, KINEMATICS_LINEAR);
    s.scene.width = width;
    if (clamped)
        sheet_hold(&s, 0, 0, FIX_XYZ, true);
    sheet_start(&s);
    if (!CHECK(shell_model.modes(s.state, MODES + skip, omega, &why) == STATUS_OK))
        printf("%s\n", why.text);
    double scale =
        sqrt(s.scene.density * s.scene.thickness / scene_bending_stiffness(&s.scene));
    for (int n = row; n < next && n < row + MODES; n++) {
        double lambda = reference_number(table, n, "lambda");
        double tolerance = lambda * (clamped && nu > 0 ? FREQUENCY_CORNER * nu : FREQUENCY);
        tolerance += reference_number(table, n, "est_err");
        if (!CHECK_NEAR(omega[skip + n - row] * scale, lambda, tolerance))
            printf("%s nu %g Ly %g mode %d\n", bc, nu, width, n - row + 1);
    }
    for (int n = 0; n < skip;
         n++) /* rigid motions: rounding of 1e-15 of the largest mode */
        CHECK(omega[n] * scale < 0.05);
    sheet_clear(&s);
    return next;
}

int main(void)
{
    struct reference *table = NULL;
    struct message why = {{0}};
    double linear, nonlinear;

    check_cantilever(0.3, 0.127235, 0.129074);
    check_cantilever(0, 0.125, 0.125);
    check_simply_supported(KINEMATICS_LINEAR, &linear);
    check_simply_supported(KINEMATICS_NONLINEAR, &nonlinear);
    CHECK_RELATIVE(nonlinear, linear, SMALL);
    check_clamped();
    REQUIRE(reference_open(REFERENCE_DIR "/leissa_plate_frequencies.csv", &table, &why) ==
            STATUS_OK);
    for (int row = 0; row < reference_rows(table);)
        row = check_frequencies(table, row);
    reference_close(table);
    return check_result();
}
