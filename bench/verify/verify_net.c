#include "bench/verify/verify_net.h"

#include <math.h>
#include <stdio.h>

#define LINEAR "discretization.kinematics=linear "
#define LARGE  "discretization.kinematics=nonlinear "
#define CUBIC  "discretization.degree=[3,3,1] "
#define CURE   "discretization.remedy="

struct verify_series verify_net_plate(enum verify_plate plate, struct verify_claim claim)
{
    /* clang-format off */
    static const struct verify_series all[VERIFY_PLATES] = {
        [VERIFY_PLATE_NONE] =
            {{"iga, none", "iga", LINEAR, 0, 0}, {6, 10}, {6, 10}, 2, 2, 0},
        [VERIFY_PLATE_NONE_3] =
            {{"iga, none, p = 3", "iga", LINEAR CUBIC, 0, 0}, {7, 10}, {7, 10}, 2, 3, 0},
        [VERIFY_PLATE_NONE_32] =
            {{"iga, none, p = 3, r = 2", "iga", LINEAR "discretization.degree=[3,3,2]", 0,
              0}, {7, 10}, {7, 10}, 3, 3, 0},
        [VERIFY_PLATE_REDUCED] =
            {{"iga, reduced", "iga", LINEAR CURE "reduced", 0, 0}, {6, 10}, {6, 10}, 2, 2,
             0},
        [VERIFY_PLATE_REDUCED_3] =
            {{"iga, reduced, p = 3", "iga", LINEAR CUBIC CURE "reduced", 0, 0}, {7, 10},
             {7, 10}, 2, 3, 0},
        [VERIFY_PLATE_SELECTIVE] =
            {{"iga, selective", "iga", LINEAR CURE "selective", 0, 0}, {6, 10}, {6, 10}, 2,
             2, 0},
        [VERIFY_PLATE_SELECTIVE_3] =
            {{"iga, selective, p = 3", "iga", LINEAR CUBIC CURE "selective", 0, 0}, {7, 10},
             {7, 10}, 2, 3, 0},
        [VERIFY_PLATE_HEX] =
            {{"hex, none", "hex", LINEAR, 0, 0}, {16, 32}, {16, 32}, 2, 1, 0},
        [VERIFY_PLATE_INCOMPATIBLE] =
            {{"hex, incompatible", "hex", LINEAR CURE "incompatible", 0, 0}, {16, 32},
             {16, 32}, 2, 1, 0},
        [VERIFY_PLATE_SHELL] =
            {{"shell, p = 2", "shell", LINEAR "discretization.degree=[2,2]", 0, 0}, {10, 20},
             {10, 20}, 0, 2, 0},
        [VERIFY_PLATE_SHELL_3] =
            {{"shell, p = 3", "shell", LINEAR "discretization.degree=[3,3]", 0, 0}, {7, 10},
             {7, 10}, 0, 3, 0},
        [VERIFY_PLATE_SPRINGS] =
            {{"mass_spring, matched", "mass_spring", NULL, 0, 0}, {10, 20}, {10, 20}, 0, 1,
             0},
        [VERIFY_PLATE_PROJECTIVE] =
            {{"projective_dynamics, matched", "projective_dynamics", NULL, 0, 0}, {10, 20},
             {10, 20}, 0, 1, 0},
        [VERIFY_PLATE_LARGE_REDUCED] =
            {{"iga, reduced, nonlinear", "iga", LARGE CURE "reduced", 0, 0}, {6, 10},
             {6, 10}, 2, 2, 0},
        [VERIFY_PLATE_LARGE_SELECTIVE] =
            {{"iga, selective, nonlinear", "iga", LARGE CURE "selective", 0, 0}, {6, 10},
             {6, 10}, 2, 2, 0},
        [VERIFY_PLATE_LARGE_INCOMPATIBLE] =
            {{"hex, incompatible, nonlinear", "hex", LARGE CURE "incompatible", 0, 0},
             {16, 32}, {16, 32}, 2, 1, 0},
        [VERIFY_PLATE_LARGE_SHELL] =
            {{"shell, p = 3, nonlinear", "shell", LARGE "discretization.degree=[3,3]", 0, 0},
             {7, 10}, {7, 10}, 0, 3, 0},
    };
    /* clang-format on */
    struct verify_series series = all[plate];

    series.subject.tolerance = claim.tolerance > 0 ? claim.tolerance : NAN;
    series.subject.reason = claim.reason;
    return series;
}

/* Open knots of `points` functions, inner ones at (k / spans)^grade. */
static void write_knots(int points, int degree, double grade, char text[VERIFY_KNOTS])
{
    int spans = points - degree, used = 0;

    used = snprintf(text, VERIFY_KNOTS, "discretization.knots_u=[");
    for (int k = -degree; k <= spans + degree && used < VERIFY_KNOTS; k++) {
        double x = fmin(fmax((double)k / spans, 0), 1);
        used += snprintf(text + used, (size_t)(VERIFY_KNOTS - used), "%s%.17g",
                         k == -degree ? "" : ",", pow(x, grade));
    }
    if (used < VERIFY_KNOTS)
        snprintf(text + used, (size_t)(VERIFY_KNOTS - used), "]");
}

void verify_net_make(const struct verify_series *series, int n, struct verify_net *net)
{
    int u = series->along[n], v = series->across[n], w = series->layers;
    char layers[16] = "";

    *net = (struct verify_net){.subject = series->subject, .spans = u - series->degree};
    if (w)
        snprintf(layers, sizeof layers, "x%d", w);
    snprintf(net->title, sizeof net->title, "%s, %dx%d%s%s", series->subject.title, u, v,
             layers, series->grade ? ", graded" : "");
    snprintf(net->points, sizeof net->points, "discretization.points=[%d,%d,%d]", u, v,
             w ? w : 1);
    if (series->grade)
        write_knots(u, series->degree, series->grade, net->knots);
    net->subject.title = net->title;
}

double verify_net_order(const struct verify_series *series, const double error[VERIFY_NETS],
                        double bar)
{
    int coarse = series->along[0] - series->degree,
        fine = series->along[1] - series->degree;

    if (!(error[1] > 3 * bar) || !(error[0] > 0))
        return NAN;
    return log(error[0] / error[1]) / log((double)fine / coarse);
}
