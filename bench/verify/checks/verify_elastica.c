/* The heavy elastica: a strip of nu = 0 that is clamped level and hangs under its weight.
 */
#include <math.h>
#include <stdio.h>

#include "bench/verify/verify_strips.h"

extern const struct verify_check verify_elastica;

/* Of the table, relative. */
static const double BAR = 1e-10;
enum { MOST = 32 }; /* rows of the table in a decade of Gamma                           */
/* What a strip may still move in the last half of its time, of its drop, and count as at
 * rest: less than any net here errs by. */
static const double REST = 1e-4;

struct point {
    double gamma, drop, reach; /* of the table, over L                                 */
};

/* Motion with twice the lowest frequency as mass damping, near the critical, over some ten
 * decay times; *xyz of the tip at the end, *moved in the last half. */
static enum status settle(struct verify_row *row, const struct verify_subject *subject,
                          const char **settings, int count, double gamma, double *xyz,
                          double *moved, bool *lived, struct message *why)
{
    enum { STEPS = 2000 };
    /* omega^2 = 3.516^2 B / (rho h L^4) in the beam's first mode, or that of a pendulum. */
    const double rate = sqrt(9.81 * fmax(12.36 / gamma, 1.5)), end = 20 / rate;
    const double tip[3] = {1, 0.5, 0.5}, time[2] = {end / 2, end};
    double both[6];
    char damping[64], step[64], last[64];

    snprintf(damping, sizeof damping, "damping.value=%.17g", 2 * rate);
    snprintf(step, sizeof step, "time.step=%.17g", end / STEPS);
    snprintf(last, sizeof last, "time.end=%.17g", end);
    settings[count++] = "damping.kind=mass";
    settings[count++] = damping;
    settings[count++] = step;
    settings[count++] = last;
    settings[count] = NULL;
    enum status st = verify_motion(row, subject, "cantilever", settings, 2, time, 1, tip,
                                   both, lived, why);
    for (int i = 0; i < 3; i++)
        xyz[i] = both[3 + i];
    *moved = hypot(both[3] - both[0], both[5] - both[2]);
    return st;
}

/* Drop and error of one net at one weight; *moved: of a strip not yet at rest. */
static enum status measure(struct verify_row *row, const struct verify_strip *strip,
                           int net, const struct point *truth, double *drop, double *error,
                           double *moved, bool *lived, struct message *why)
{
    /* E h^3 / 12 = rho g h / Gamma for L = 1: the load is kept, the stiffness follows. */
    const double thickness = 1e-3, weight = 0.05 * 9.81 * thickness;
    const double tip[3] = {1, 0.5, 0.5};
    double xyz[3] = {NAN, NAN, NAN};
    char young[64], width[64];
    const char *settings[12] = {width, "material.poisson=0", young};
    int count = 3;
    struct verify_net n;
    enum status st;

    verify_net_make(&strip->nets, net, &n);
    snprintf(width, sizeof width, "sheet.width=%g", VERIFY_STRIPS_WIDTH);
    snprintf(young, sizeof young, "material.young=%.17g",
             12 * weight / truth->gamma / (thickness * thickness * thickness));
    settings[count++] = n.points;
    if (*n.knots)
        settings[count++] = n.knots;
    *moved = 0;
    if (strip->settles)
        st = settle(row, &n.subject, settings, count, truth->gamma, xyz, moved, lived, why);
    else
        st = verify_equilibrium(row, &n.subject, "cantilever", settings, 1, tip, xyz, lived,
                                why);
    *drop = -xyz[2];
    *error = strip->linear ? fabs(*drop - truth->drop)
                           : hypot(xyz[0] - truth->reach, *drop - truth->drop);
    *error /= truth->drop;
    return st;
}

/* Points of a decade, one in `every`; the row tells of the worst of them. */
static enum status add_row(struct verify_sheet *sheet, const struct verify_strip *strip,
                           int count, const struct point *point, int every,
                           struct message *why)
{
    enum status st = STATUS_OK;
    double error[2] = {NAN, NAN}, moved[2], drop, worst = -1;
    struct verify_net fine;

    verify_net_make(&strip->nets, 1, &fine);
    struct verify_row *row = verify_add(sheet, &fine.subject,
                                        strip->linear ? "drop / L, Gamma = %.3g .. %.3g"
                                                      : "tip, Gamma = %.3g .. %.3g",
                                        point[0].gamma, point[count - 1].gamma);
    for (int n = 0; n < count; n += every) {
        bool lived;
        for (int net = 0; net < VERIFY_NETS; net++) {
            TRY(measure(row, strip, net, &point[n], &drop, &error[net], &moved[net], &lived,
                        why));
            if (!lived) {
                verify_note(row, "Gamma = %.4g", point[n].gamma);
                return STATUS_OK;
            }
        }
        if (moved[1] > REST * point[n].drop) {
            verify_not_applicable(row, "not at rest: moved %.2g L in the last half",
                                  moved[1]);
            return STATUS_OK;
        }
        if (error[1] > worst) {
            worst = error[1];
            row->value = drop;
            row->truth = point[n].drop;
            row->order = verify_net_order(&strip->nets, error, BAR);
        }
    }
    verify_judge_error(row, worst, BAR);
    if (strip->linear && point[count - 1].gamma > VERIFY_STRIPS_LINEAR_GAMMA)
        verify_out_of_range(row, "small strains reach to Gamma = %g",
                            VERIFY_STRIPS_LINEAR_GAMMA);
out:
    return st;
}

/* Rows of the table from `first` on in the same decade of Gamma; returns their number. */
static int read_decade(const struct reference *table, int first, struct point point[MOST])
{
    int count = 0, decade = 0;

    for (int n = first; n < reference_rows(table) && count < MOST; n++) {
        double gamma = reference_number(table, n, "Gamma");
        int in = (int)floor(log10(gamma) + 1e-9);
        if (count && in != decade)
            break;
        decade = in;
        point[count++] = (struct point){gamma, reference_number(table, n, "H_over_L"),
                                        reference_number(table, n, "W_over_L")};
    }
    return count;
}

static enum status run(struct verify_sheet *sheet, struct message *why)
{
    enum status st;
    struct reference *table = NULL;
    struct point point[MOST];
    int every = verify_quick(sheet) ? MOST : 1;

    TRY(verify_reference("heavy_elastica", &table, why));
    for (int first = 0, count; first < reference_rows(table); first += count) {
        count = read_decade(table, first, point);
        for (int s = 0; s < VERIFY_STRIPS; s++)
            if (verify_wanted(sheet, &verify_strips[s].nets.subject))
                TRY(add_row(sheet, &verify_strips[s], count, point, every, why));
    }
out:
    reference_close(table);
    return st;
}

const struct verify_check verify_elastica = {
    .item = {"elastica", "tip of a heavy strip, clamped level, at any weight"},
    .source = "inextensible elastica by shooting, tests/reference/heavy_elastica.csv, "
              "1e-10; error: the tip's distance, of its drop; the worst of a decade",
    .run = run,
};
