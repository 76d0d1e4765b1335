#include <math.h>

#include "bench/verify/verify_check.h"

/* Claims: 1e-3 of tips, 1 % for triangles, as of heavy strips; 2 % of ways and pressures.
 * The clamps' distance leaves 7e-4 of the weight at mid-length, a larger share of the
 * pressure where strips hardly press. */
static const double BETWEEN = 0.02, HARDLY = 0.1;
#define CASES                                                                              \
    "contact a tenth as stiff and ratios 1.02 and 1/1.02 in place of 1.05 and 1/1.05"
static const struct verify_subject entries[] = {
    {"shell_3,shell_selective_3", 1e-3, NULL, {24}, {4}, .dear = true, .changed = CASES},
    {"triangles", 0.01, NULL, {64}, {3}, .changed = CASES},
    {NULL}};
static const struct verify_field field = {.subject = entries};

/* Two strips 1 m long, whose faces touch where both are clamped; the upper one has a third
 * of both's bending stiffness. Weight over stiffness, both's: 10. Contact is so stiff that
 * the distance of the clamps fades within a tenth of the length from there. */
static const double B[2] = {1e-3, 2e-3}, BOTH = 3e-3, WEIGHT = 0.03, THICK = 2e-3,
                    KAPPA = 0.1, G = 9.81;

/* The upper strip's weight over its stiffness, of the lower one's: pressed together,
 * hardly, hardly apart, apart. */
static const double RATIO[] = {4, 1.05, 1 / 1.05, 0.25};
enum { RATIOS = sizeof RATIO / sizeof *RATIO };

/* Return the distance under a pressure, and the pressure at a distance, of a law that
 * starts at THICK and has half of it as its range. */
static double distance_under(double p)
{
    return THICK / 2 * (1 + 1 / (1 + sqrt(p / KAPPA)));
}

static double pressure_at(double D)
{
    const double x = 2 * D / THICK - 1;

    return x < 1 ? KAPPA * (1 / x - 1) * (1 / x - 1) : 0;
}

/* A heavy strip's shape, from the clamp: x along, y up. */
struct shape {
    double middle[2], tip[2];
    double turn[2];   /* theta at mid-length, at the tip, downwards */
    double curvature; /* theta' at mid-length */
};

/* Integrates the elastica theta'' = -gamma (sigma - lean theta) cos theta from the free
 * end, sigma = 0, to the clamp; returns theta there. Places are those from the tip. */
static double integrate(double gamma, double lean, double theta, struct shape *s)
{
    enum { STEPS = 400 };
    const double h = 1.0 / STEPS;
    double y[4] = {theta}; /* theta, curvature, x, y */

    for (int n = 0; n < STEPS; n++) {
        double k[4][4], at[4];
        for (int stage = 0; stage < 4; stage++) {
            const double part = h * (stage == 3 ? 1 : stage ? 0.5 : 0);
            for (int i = 0; i < 4; i++)
                at[i] = y[i] + (stage ? part * k[stage - 1][i] : 0);
            k[stage][0] = -at[1];
            k[stage][1] = gamma * (n * h + part - lean * at[0]) * cos(at[0]);
            k[stage][2] = -cos(at[0]);
            k[stage][3] = sin(at[0]);
        }
        for (int i = 0; i < 4; i++)
            y[i] += h / 6 * (k[0][i] + 2 * k[1][i] + 2 * k[2][i] + k[3][i]);
        if (n == STEPS / 2 - 1) {
            s->middle[0] = y[2], s->middle[1] = y[3];
            s->turn[0] = y[0], s->curvature = y[1];
        }
    }
    s->turn[1] = theta;
    s->tip[0] = -y[2], s->tip[1] = -y[3];
    s->middle[0] -= y[2], s->middle[1] -= y[3];
    return y[0];
}

static struct shape hang(double gamma, double lean)
{
    double low = 0, high = acos(0);
    struct shape s = {.curvature = 0};

    for (int n = 0; n < 60; n++) {
        const double middle = (low + high) / 2;
        if (integrate(gamma, lean, middle, &s) > 0)
            high = middle;
        else
            low = middle;
    }
    return s;
}

/* A case: the strips' weights, and the pressure between them if they stay together.
 *
 * An inextensible strip carries p = -B (k'' + k^3 / 2) + w (cos theta + k z), z its height
 * over the tip. Of one shape, without friction, the upper one's p is therefore the second
 * bracket times (w1 B2 - w2 B1) / (B1 + B2): it presses everywhere or nowhere. Strips D
 * apart are parallel curves, d1, d2 beside one with B1 d1 + B2 d2 = 0: their tips have its
 * tip as their mean, they bend as one but for (D k)^2, and their weight bends by w (sigma -
 * lean theta) in place of w sigma, lean = (w1 d1 + w2 d2) / w. */
struct pair {
    double weight[2];
    double excess;   /* (w1 B2 - w2 B1) / (B1 + B2); with D = 0 they part where it is 0 */
    double pressure; /* on the upper strip at mid-length [Pa]                       */
    struct shape both;
};

/* Returns p of the upper strip at mid-length, to first order in d: its curvature is k - d
 * k^2, and its length 1 + d k times that of the curve beside it. */
static double pressure_of(const struct pair *p, double lean, double d)
{
    const double gamma = WEIGHT / BOTH, theta = p->both.turn[0], end = p->both.turn[1];
    const double k = p->both.curvature, arm = 0.5 - lean * theta;
    const double slope = -gamma * arm * cos(theta),
                 second = gamma * ((1 + lean * k) * cos(theta) + arm * k * sin(theta));
    const double bend = second - d * (4 * k * second + 3 * slope * slope) + k * k * k / 2 -
                        1.5 * d * k * k * k * k;
    const double over =
        p->both.middle[1] - p->both.tip[1] + d * (cos(theta) - cos(end) - end * sin(end));

    return -B[0] * bend + p->weight[0] * (cos(theta) + (k - d * k * k) * over);
}

static struct pair pair_of(double ratio)
{
    const double lower = WEIGHT / (1 + ratio * B[0] / B[1]);
    struct pair p = {.weight = {WEIGHT - lower, lower}};
    double gap = THICK;

    p.excess = (p.weight[0] * B[1] - p.weight[1] * B[0]) / BOTH;
    for (int n = 0; n < 4 && p.excess > 0; n++) {
        const double lean = gap * p.excess / WEIGHT;
        p.both = hang(WEIGHT / BOTH, lean);
        p.pressure = pressure_of(&p, lean, gap * B[1] / BOTH);
        gap = distance_under(p.pressure);
    }
    return p;
}

/* The places at rest: tips and middles of the upper strip and the lower one, and the upper
 * one's near its middle. */
enum { TIPS, MIDDLES = 2, NEAR = 4, LOOKS = 41, PLACES = NEAR + LOOKS };

static const struct scene two = {.sheets = 2};

static bool settle(struct verify_trial *t, const struct pair *p, double xyz[PLACES][3])
{
    const double cube = THICK * THICK * THICK, reach = 2 * THICK;
    double uvw[PLACES][3];

    for (int n = 0; n < PLACES; n++) {
        const double s = n < MIDDLES ? 1
                         : n < NEAR  ? 0.5
                                     : 0.5 + reach * (2.0 * (n - NEAR) / (LOOKS - 1) - 1);
        uvw[n][0] = scene_sheet_u(&two, n < NEAR ? n % 2 : 0, s);
        uvw[n][1] = uvw[n][2] = 0.5;
    }
    verify_trial_set(
        t,
        "sheet={length: 1, width: 0.1, thickness: %g}; obstacles=[]; snapshots=[];"
        "material={young: 1, poisson: 0, density: 1}; sheets=["
        "{origin: [0,0,%.17g], material: {young: %.17g, poisson: 0, density: %.17g}},"
        "{origin: [0,0,%.17g], material: {young: %.17g, poisson: 0, density: %.17g}}];"
        "supports=[{at: {sheet: 1, u: 0}, fix: xyz}, {at: {sheet: 2, u: 0}, fix: xyz}];"
        "contact={thickness: %g, range: %g, stiffness: %g}; gravity=[0,0,%g]",
        THICK, THICK * B[1] / BOTH, 12 * B[0] / cube, p->weight[0] / THICK / G,
        -THICK * B[0] / BOTH, 12 * B[1] / cube, p->weight[1] / THICK / G, THICK, THICK / 2,
        KAPPA, -G);
    return verify_trial_equilibrium(t, PLACES, uvw[0], xyz[0]);
}

/* Returns the distance of the lower strip's middle from the upper one. */
static double distance(double xyz[PLACES][3])
{
    const double *x = xyz[MIDDLES + 1];
    double least = INFINITY;

    for (int n = NEAR; n + 1 < PLACES; n++) {
        const double e[2] = {xyz[n + 1][0] - xyz[n][0], xyz[n + 1][2] - xyz[n][2]};
        const double d[2] = {x[0] - xyz[n][0], x[2] - xyz[n][2]};
        const double share = (d[0] * e[0] + d[1] * e[1]) / (e[0] * e[0] + e[1] * e[1]);
        const double along = fmin(fmax(share, 0), 1);
        least = fmin(least, hypot(d[0] - along * e[0], d[1] - along * e[1]));
    }
    return least;
}

static void add_together(struct verify_subject *s, struct verify_trial *t, double ratio,
                         const struct pair *p)
{
    double xyz[PLACES][3], off[2];

    if (!settle(t, p, xyz))
        return;
    for (int i = 0; i < 2; i++)
        off[i] =
            (B[0] * xyz[TIPS][2 * i] + B[1] * xyz[TIPS + 1][2 * i]) / BOTH - p->both.tip[i];
    verify_row_judge_error(t->row, hypot(off[0], off[1]) / -p->both.tip[1], 0);
    verify_subject_claim(s, ratio < 2 ? HARDLY : BETWEEN, NULL);
    s->changed = ratio < 2 ? "2 %, as where strips press; " CASES : CASES;
    verify_row_judge(
        verify_sheet_add(s, "pressure at mid-length / weight of both, ratio %.3g", ratio),
        pressure_at(distance(xyz)) / WEIGHT, p->pressure / WEIGHT, 0);
}

static void add_apart(struct verify_subject *s, struct verify_trial *t, double ratio,
                      const struct pair *p)
{
    double xyz[PLACES][3], error = 0, between[2], truth[2];
    struct shape alone[2];

    if (!settle(t, p, xyz))
        return;
    for (int k = 0; k < 2; k++) {
        const double z = k ? -THICK * B[0] / BOTH : THICK * B[1] / BOTH;
        alone[k] = hang(p->weight[k] / B[k], 0);
        error = verify_row_worse(hypot(xyz[TIPS + k][0] - alone[k].tip[0],
                                       xyz[TIPS + k][2] - z - alone[k].tip[1]) /
                                     -alone[k].tip[1],
                                 error);
    }
    verify_row_judge_error(t->row, error, 0);
    for (int i = 0; i < 2; i++) {
        between[i] = xyz[MIDDLES][2 * i] - xyz[MIDDLES + 1][2 * i];
        truth[i] = alone[0].middle[i] - alone[1].middle[i] + i * THICK;
    }
    verify_subject_claim(s, BETWEEN, NULL);
    verify_row_judge(
        verify_sheet_add(s, "way between the middles / contact thickness, ratio %.3g",
                         ratio),
        hypot(between[0], between[1]) / THICK, hypot(truth[0], truth[1]) / THICK, 0);
}

static void add_rows(struct verify_subject *s)
{
    const double ratio = RATIO[s->at];
    const struct pair p = pair_of(ratio);
    struct verify_trial t = verify_trial_of(
        s, "stack",
        p.excess > 0 ? "tips as of one strip, ratio %.3g" : "tips alone, ratio %.3g",
        ratio);

    if (p.excess > 0)
        add_together(s, &t, ratio, &p);
    else
        add_apart(s, &t, ratio, &p);
}

const struct verify_check verify_unequal = {
    {"unequal", "two unequal strips on one clamp, together or apart"},
    "inextensible elastica by shooting: as one strip of B1 + B2 and w1 + w2, with pressure "
    "(w1 B2 - w2 B1) / (B1 + B2) (cos theta + k z), while w1 / B1 > w2 / B2; each by "
    "itself "
    "otherwise",
    .slow = true,
    .parts = {{&field, add_rows, RATIOS, .every = 3}}};
