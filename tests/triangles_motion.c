/* Triangles at rest and in motion: small and large deflections of a cantilever, its first
 * frequencies, the clamp and the hinge, orders in time, energy, and what is refused. */
#include "fem_ref/elastica.h"
#include "tests/triangles.h"

/* A strip with nu = 0, clamped: plane, however wide. */
static void strip(struct sheet *s, int n, enum bending bending, double gamma)
{
    sheet_init(s, n, 3);
    s->d.bending = bending;
    s->scene.width = 0.2;
    s->scene.thickness = 1e-3;
    s->scene.young = 1e6;
    s->scene.density = 10;
    s->scene.gravity[2] =
        -gamma * scene_bending_stiffness(&s->scene) / (s->scene.density * 1e-3);
    sheet_clamp(s);
}

/* Second order in the net, seen between two of them. The end of a free edge stands for half
 * a cell, whose moment vanishes as the square. */
static const double ORDER = 0.25;

/* Asked of forty cells, of the drop: to Gamma = 100 the bend at the clamp takes eight. */
static const double ELASTICA = 1e-3;

/* The tip against the heavy elastica; the order while its errors have one sign. */
static void check_cantilever(enum bending bending, double gamma)
{
    struct elastica want;
    double error[2];

    REQUIRE(elastica_solve(gamma, &want) == STATUS_OK);
    for (int k = 0; k < 2; k++) {
        struct sheet s;
        double tip[3];
        strip(&s, k ? 41 : 21, bending, gamma);
        sheet_start(&s);
        sheet_settle(&s);
        sheet_point(&s, 1, 0.5, tip);
        error[k] = hypot(tip[2] + want.drop, tip[0] - want.reach) / want.drop;
        sheet_clear(&s);
    }
    printf("Gamma %g, bending %d: %.2e, %.2e\n", gamma, (int)bending, error[0], error[1]);
    if (gamma < 1)
        CHECK_NEAR(log2(error[0] / error[1]), 2, ORDER);
    CHECK_NEAR(error[1], 0, ELASTICA);
}

/* The first two of a strip that bends: 1.8751^2 and 4.6941^2 sqrt(D / rho h L^4); wide
 * enough to turn and to swing sideways later. */
static void check_frequencies(enum bending bending)
{
    const double beta[2] = {1.875104068711961, 4.694091132974175};
    double error[2][2];

    for (int k = 0; k < 2; k++) {
        struct sheet s;
        double omega[3];
        struct message why = {{0}};
        strip(&s, k ? 41 : 21, bending, 0);
        s.scene.width = 0.05;
        sheet_start(&s);
        REQUIRE(tri_model.modes(s.m, 3, omega, &why) == STATUS_OK);
        double unit =
            sqrt(scene_bending_stiffness(&s.scene) / (s.scene.density * s.scene.thickness));
        for (int n = 0; n < 2; n++)
            error[k][n] = fabs(omega[n] / (beta[n] * beta[n] * unit) - 1);
        sheet_clear(&s);
    }
    for (int n = 0; n < 2; n++) {
        printf("mode %d, bending %d: %.2e, %.2e\n", n + 1, (int)bending, error[0][n],
               error[1][n]);
        CHECK_NEAR(log2(error[0][n] / error[1][n]), 2, ORDER);
        CHECK(error[1][n] < 5e-3);
    }
}

/* A support of the mid-surface alone is a hinge, on which the strip turns freely; nothing
 * else does. */
static void check_hinge(enum bending bending)
{
    struct sheet s;
    double omega[2];
    struct message why = {{0}};

    strip(&s, 11, bending, 0);
    s.scene.supports[0].lo[2] = s.scene.supports[0].hi[2] = 0.5;
    sheet_start(&s);
    REQUIRE(tri_model.modes(s.m, 2, omega, &why) == STATUS_OK);
    CHECK(omega[0] < 1e-3 * omega[1]);
    sheet_clear(&s);
}

struct scheme {
    const char *name;
    enum integrator integrator;
    enum membrane membrane;
    enum bending bending;
    int iterations, substeps, order;
    enum precision precision;
};

/* A swing that lifts the strip through a quarter turn, softly, so that every scheme has
 * come to its order. */
static void swing(struct sheet *s, const struct scheme *by, int substeps)
{
    sheet_init(s, 6, 4);
    s->scene.width = 0.6;
    s->scene.thickness = 0.05;
    s->scene.young = 2e3;
    s->scene.poisson = 0.3;
    s->scene.density = 4;
    s->scene.gravity[0] = 0.5, s->scene.gravity[2] = -3;
    s->scene.step = 0.05;
    s->d.integrator = by->integrator, OWN(tri_own, &s->d)->membrane = by->membrane;
    s->d.bending = by->bending, s->d.iterations = by->iterations;
    s->d.substeps = substeps, s->d.precision = by->precision;
    sheet_clamp(s);
    sheet_start(s);
}

enum { SWING = 12 };

static const struct scheme SCHEMES[] = {
    {"momentum", INTEGRATOR_MOMENTUM, MEMBRANE_GREEN, BENDING_QUADRATIC, 0, 40, 2},
    {"momentum, corotational", INTEGRATOR_MOMENTUM, MEMBRANE_COROTATIONAL, BENDING_HINGE, 0,
     40, 2},
    {"Euler", INTEGRATOR_IMPLICIT, MEMBRANE_GREEN, BENDING_HINGE, 0, 40, 1},
    {"Baraff and Witkin", INTEGRATOR_IMPLICIT, MEMBRANE_BARAFF_WITKIN, BENDING_QUADRATIC, 1,
     40, 1},
    {"leapfrog", INTEGRATOR_LEAPFROG, MEMBRANE_GREEN, BENDING_QUADRATIC, 0, 40, 2},
    {"leapfrog, corotational", INTEGRATOR_LEAPFROG, MEMBRANE_COROTATIONAL,
     BENDING_QUADRATIC, 0, 40, 2},
    {"leapfrog, hinges", INTEGRATOR_LEAPFROG, MEMBRANE_GREEN, BENDING_HINGE, 0, 40, 2},
};
enum { SCHEME_COUNT = sizeof SCHEMES / sizeof *SCHEMES };

/* Differences between three steps, each half the one before. Without the viscosity of a
 * tenth of a step in the membrane of energy-momentum steps, which is of first order, and
 * small. */
static void check_order(const struct scheme *by)
{
    const double TOL_TIME = 0.3;
    double x[3][3 * 24], d[2] = {0, 0};

    for (int k = 0; k < 3; k++) {
        struct sheet s;
        swing(&s, by, by->substeps << k);
        s.m->large.motion.lag = 0;
        sheet_frames(&s, SWING);
        CHECK(s.counters.substeps == SWING * (by->substeps << k));
        memcpy(x[k], s.m->x, sizeof x[k]);
        sheet_clear(&s);
    }
    for (int k = 0; k < 2; k++)
        for (int t = 0; t < 3 * 24; t++)
            d[k] += (x[k][t] - x[k + 1][t]) * (x[k][t] - x[k + 1][t]);
    double order = log2(d[0] / d[1]) / 2;
    printf("%s: order %.2f, difference %.2e\n", by->name, order, sqrt(d[1]));
    CHECK_NEAR(order, by->order, TOL_TIME);
}

/* Explicit steps know the same forces as implicit ones, each law, in both precisions. */
static void check_same(enum membrane membrane, enum bending bending,
                       enum precision precision)
{
    const struct scheme schemes[2] = {
        {"", INTEGRATOR_MOMENTUM, membrane, bending, 0, 0, 2},
        {"", INTEGRATOR_LEAPFROG, membrane, bending, 0, 0, 2, .precision = precision}};
    const double SAME = 2e-3; /* m, of 0.5: momentum's steps; single precision 1e-4 */
    double x[2][3 * 24];

    for (int k = 0; k < 2; k++) {
        struct sheet s;
        swing(&s, &schemes[k], 80);
        sheet_frames(&s, SWING);
        memcpy(x[k], s.m->x, sizeof x[k]);
        sheet_clear(&s);
    }
    for (int t = 0; t < 3 * 24; t++)
        CHECK_NEAR(x[1][t], x[0][t], SAME);
}

/* What a swing gains or loses, of the energy that has turned. Leapfrog's oscillates as the
 * square of its step; energy-momentum steps lose what the membrane's viscosity takes. */
static void check_energy(const struct scheme *by, double most)
{
    struct sheet s;
    struct energy e;
    double off = 0, turned = 0;

    swing(&s, by, by->substeps);
    for (int n = 0; n < 40; n++) {
        sheet_frames(&s, 1);
        tri_model.energy(s.m, &e);
        off = fmax(off, fabs(e.kinetic + e.elastic + e.potential));
        turned = fmax(turned, -e.potential);
    }
    printf("%s: energy %.2e of what turned\n", by->name, off / turned);
    CHECK(off < most * turned);
    CHECK(turned > 0);
    sheet_clear(&s);
}

/* One solve a step where a cell rings a dozen times in it: each step has the tangent of its
 * own start, or the sheet flies apart in a tenth of a second. The free edge falls freely at
 * first, g t^2 / 2 (1 + dt / t). */
static void check_stiff(void)
{
    enum { FRAMES = 30 };
    const double FREE = 0.1; /* of the fall: what the clamp already holds back          */
    struct sheet s;
    double tip[3];

    sheet_init(&s, 10, 10);
    s.d.integrator = INTEGRATOR_IMPLICIT, s.d.iterations = 1;
    OWN(tri_own, &s.d)->membrane = MEMBRANE_BARAFF_WITKIN, s.d.bending = BENDING_HINGE;
    s.scene.thickness = 1.177e-3;
    s.scene.young = 1e5, s.scene.poisson = 0.3, s.scene.density = 0.5;
    s.scene.gravity[2] = -9.81;
    sheet_clamp(&s);
    sheet_start(&s);
    sheet_frames(&s, FRAMES);
    sheet_point(&s, 1, 0.5, tip);
    double t = FRAMES * s.scene.step;
    CHECK_RELATIVE(tip[2], -9.81 / 2 * t * (t + s.scene.step), FREE);
    CHECK(s.counters.iterations == FRAMES && s.counters.substeps == FRAMES);
    sheet_clear(&s);
}

/* Where a net is cut into strips (spring_sweep.h), whole, ended early, of even and odd
 * rows: explicit steps have the slope of the energy that implicit ones have. */
static void check_slope(int n, int m, enum membrane membrane)
{
    enum { EVERY = 37 };
    const double SLOPE = 1e-5; /* of differences, of the greatest                       */
    struct sheet s;
    struct energy e;
    double most = 0, off = 0;

    sheet_init(&s, n, m);
    s.d.integrator = INTEGRATOR_LEAPFROG, OWN(tri_own, &s.d)->membrane = membrane,
    s.d.substeps = 1;
    s.scene.step = 1e-9;
    sheet_start(&s);
    double *x = s.m->x, small = 1e-4 * s.scene.length / n;
    for (int t = 0; t < 3 * n * m; t++)
        x[t] += 1e3 * small * sin(7. * t);
    spring_leapfrog_place(s.m->leapfrog, 0, x);
    sheet_frames(&s, 1);
    tri_model.energy(s.m, &e);
    for (int t = 0; t < 3 * n * m; t += EVERY) {
        double was = x[t], slope;
        x[t] = was + small, slope = tri_body_energy(&s.m->body, x);
        x[t] = was - small, slope -= tri_body_energy(&s.m->body, x);
        x[t] = was, slope = s.m->load.load[t] - slope / (2 * small);
        off = fmax(off, fabs(s.m->v[t] * s.m->load.mass[t / 3] / s.scene.step - slope));
        most = fmax(most, fabs(slope));
    }
    if (!CHECK(off < SLOPE * most))
        printf("%d x %d, membrane %d: %g of %g\n", n, m, (int)membrane, off, most);
    sheet_clear(&s);
}

static void check_refusals(void)
{
    static const struct {
        struct scheme by;
        enum precision precision;
        const char *says;
    } cases[] = {
        {{.integrator = INTEGRATOR_EXPLICIT}, 0, "integrator=leapfrog"},
        {{.integrator = INTEGRATOR_BDF2}, 0, "integrator=bdf2"},
        {{.integrator = INTEGRATOR_MIDPOINT}, 0, "integrator=midpoint"},
        {{.integrator = INTEGRATOR_MOMENTUM, .bending = BENDING_STRUT}, 0, "bending=strut"},
        {{.integrator = INTEGRATOR_LEAPFROG, .bending = BENDING_HINGE},
         PRECISION_SINGLE,
         "bending=quadratic"},
        {{.integrator = INTEGRATOR_MOMENTUM, .iterations = 1}, 0, "iterations"},
        {{.integrator = INTEGRATOR_MOMENTUM}, PRECISION_SINGLE, "precision=single"}};

    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        struct scene scene;
        struct discretization d;
        struct message why = {{0}};
        void *state = NULL;
        REQUIRE(scene_init(&scene) == STATUS_OK);
        model_defaults(&tri_model, &d);
        d.integrator = cases[k].by.integrator, d.bending = cases[k].by.bending;
        d.iterations = cases[k].by.iterations, d.precision = cases[k].precision;
        CHECK(tri_model.create(&scene, &d, &state, &why) != STATUS_OK && !state);
        if (!CHECK(strstr(why.text, cases[k].says)))
            printf("%s\n", why.text);
        scene_clear(&scene);
    }
}

int main(void)
{
    for (int b = 0; b < 2; b++) {
        enum bending bending = b ? BENDING_HINGE : BENDING_QUADRATIC;
        check_cantilever(bending, 0.01);
        check_cantilever(bending, 10);
        check_cantilever(bending, 100);
        check_frequencies(bending);
        check_hinge(bending);
    }
    for (int k = 0; k < SCHEME_COUNT; k++)
        check_order(&SCHEMES[k]);
    for (enum membrane law = MEMBRANE_GREEN; law <= MEMBRANE_BARAFF_WITKIN; law++) {
        for (enum precision p = PRECISION_DOUBLE; p <= PRECISION_SINGLE; p++)
            check_same(law, BENDING_QUADRATIC, p);
        check_same(law, BENDING_HINGE, PRECISION_DOUBLE);
    }
    check_energy(&SCHEMES[0], 1e-3);
    check_energy(&SCHEMES[1], 1e-3);
    check_energy(&SCHEMES[4], 1e-4);
    check_energy(&SCHEMES[5], 1e-4);
    check_slope(6, 5, MEMBRANE_GREEN);
    check_slope(33, 31, MEMBRANE_COROTATIONAL);
    check_slope(4, 260, MEMBRANE_GREEN);
    check_energy(&SCHEMES[6], 1e-4);
    check_stiff();
    check_refusals();
    return check_result();
}
