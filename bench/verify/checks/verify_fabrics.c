/* The cantilever of ASTM D1388, option A, in numbers: a strip is pushed over an edge until
 * its tip lies 41.5 degrees below the edge; half the overhang O is the bending length c,
 * and weight per area times c^3 the flexural rigidity. For measured fabrics, by every
 * model.
 */
#include <math.h>
#include <stdio.h>

#include "bench/verify/verify_strips.h"
#include "fem_ref/elastica.h"

extern const struct verify_check verify_fabrics;

static const double GRAVITY = 9.81;
/* Fabrics have no thickness in the table, and no model but a solid asks for one: half a
 * millimetre, which is 1/60 to 1/100 of these overhangs; E follows from D. */
static const double THICKNESS = 5e-4;
/* The secant method ends at this part of the overhang. */
static const double FOUND = 1e-6;
enum { MOST_TRIES = 12 };

static double angle_wanted(void)
{
    return 41.5 * acos(-1) / 180;
}

/* Gamma at which the elastica's tip is there: 8.0042. */
static enum status gamma_wanted(double *gamma)
{
    enum status st = STATUS_OK;
    double low = 7, high = 9;

    for (int n = 0; n < 40; n++) {
        struct elastica e;
        *gamma = (low + high) / 2;
        TRY(elastica_solve(*gamma, &e));
        if (atan2(e.drop, e.reach) < angle_wanted())
            low = *gamma;
        else
            high = *gamma;
    }
out:
    return st;
}

struct fabric {
    const char *name;
    double weight, D; /* area density [kg/m^2], bending stiffness [N m]                */
};

/* Angle of the tip below the edge at an overhang [m]. */
static enum status tip_angle(struct verify_row *row, const struct verify_strip *strip,
                             int net, const struct fabric *f, double overhang,
                             double *angle, bool *lived, struct message *why)
{
    const double tip[3] = {1, 0.5, 0.5};
    double xyz[3] = {0};
    char length[64], width[64], thickness[64], density[64], young[64];
    struct verify_net n;

    verify_net_make(&strip->nets, net, &n);
    const char *settings[] = {length,
                              width,
                              thickness,
                              density,
                              young,
                              "material.poisson=0",
                              "gravity=[0,0,-9.81]",
                              n.points,
                              *n.knots ? n.knots : NULL,
                              NULL};
    snprintf(length, sizeof length, "sheet.length=%.17g", overhang);
    snprintf(width, sizeof width, "sheet.width=%.17g", VERIFY_STRIPS_WIDTH * overhang);
    snprintf(thickness, sizeof thickness, "sheet.thickness=%.17g", THICKNESS);
    snprintf(density, sizeof density, "material.density=%.17g", f->weight / THICKNESS);
    snprintf(young, sizeof young, "material.young=%.17g",
             12 * f->D / (THICKNESS * THICKNESS * THICKNESS));
    enum status st = verify_equilibrium(row, &n.subject, "cantilever", settings, 1, tip,
                                        xyz, lived, why);
    *angle = atan2(-xyz[2], xyz[0]);
    return st;
}

/* The overhang at 41.5 degrees, by the secant method in log(overhang), from a guess. */
static enum status find_overhang(struct verify_row *row, const struct verify_strip *strip,
                                 int net, const struct fabric *f, double guess,
                                 double *overhang, bool *lived, struct message *why)
{
    enum status st;
    double x[2] = {log(guess), log(1.05 * guess)}, off[2] = {0};

    for (int n = 0; n < 2; n++) {
        TRY(tip_angle(row, strip, net, f, exp(x[n]), &off[n], lived, why));
        if (!*lived)
            return STATUS_OK;
        off[n] -= angle_wanted();
    }
    for (int n = 0; n < MOST_TRIES && fabs(x[1] - x[0]) > FOUND; n++) {
        double step = -off[1] * (x[1] - x[0]) / (off[1] - off[0]);
        x[0] = x[1], off[0] = off[1];
        x[1] += fmin(fmax(step, -1), 1);
        TRY(tip_angle(row, strip, net, f, exp(x[1]), &off[1], lived, why));
        if (!*lived)
            return STATUS_OK;
        off[1] -= angle_wanted();
    }
    *overhang = exp(x[1]);
    if (!(fabs(x[1] - x[0]) <= FOUND)) {
        *lived = false;
        verify_died(row, "no overhang found in %d tries", MOST_TRIES);
    }
out:
    return st;
}

static enum status add_row(struct verify_sheet *sheet, const struct verify_strip *strip,
                           const struct fabric *f, double gamma, struct message *why)
{
    enum status st = STATUS_OK;
    const double load = f->weight * GRAVITY, exact = cbrt(gamma * f->D / load);
    double overhang = NAN, error[VERIFY_NETS];
    struct verify_net fine;

    verify_net_make(&strip->nets, 1, &fine);
    struct verify_row *row =
        verify_add(sheet, &fine.subject, "bending length [m], %s", f->name);
    if (strip->settles) {
        verify_not_applicable(row, "at this Gamma it does not come to rest (see elastica)");
        return STATUS_OK;
    }
    for (int net = 0; net < VERIFY_NETS; net++) {
        bool lived;
        TRY(find_overhang(row, strip, net, f, exact, &overhang, &lived, why));
        if (!lived)
            return STATUS_OK;
        error[net] = fabs(overhang / exact - 1);
    }
    verify_judge(row, overhang / 2, exact / 2, FOUND);
    row->order = verify_net_order(&strip->nets, error, FOUND);
    verify_note(row, "%s: weight c^3 = %.4g N m for D = %.4g N m", f->name,
                load * pow(overhang / 2, 3), f->D);
    if (strip->linear)
        verify_out_of_range(row, "small strains reach to Gamma = %g, this is at %.4g",
                            VERIFY_STRIPS_LINEAR_GAMMA, gamma);
out:
    return st;
}

static enum status run(struct verify_sheet *sheet, struct message *why)
{
    enum status st;
    struct reference *table = NULL;
    double gamma;

    TRY(gamma_wanted(&gamma));
    TRY(verify_reference("fabrics", &table, why));
    int rows = reference_rows(table), every = verify_quick(sheet) ? rows - 1 : 1;
    for (int n = 0; n < rows; n += every) {
        const struct fabric f = {reference_text(table, n, "fabric"),
                                 reference_number(table, n, "area_density_kg_m2"),
                                 reference_number(table, n, "D_eq_Nm")};
        for (int s = 0; s < VERIFY_STRIPS; s++)
            if (verify_wanted(sheet, &verify_strips[s].nets.subject))
                TRY(add_row(sheet, &verify_strips[s], &f, gamma, why));
    }
out:
    reference_close(table);
    return st;
}

const struct verify_check verify_fabrics = {
    .item = {"fabrics", "bending length of ten fabrics by the cantilever of ASTM D1388"},
    .source =
        "the elastica at 41.5 degrees, Gamma = 8.0042 (fem_ref/elastica.h, 1e-10), for "
        "D and weight of tests/reference/fabrics.csv; error bar: of the overhang found; "
        "h = 0.5 mm, E = 12 D / h^3, nu = 0",
    .run = run,
};
