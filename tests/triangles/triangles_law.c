/* Triangles: forces and tangents against differences, rigid motions, homogeneous strain for
 * every nu, bending about every axis. */
#include <float.h>

#include "tests/derivative_fixture.h"
#include "tests/noise.h"
#include "tests/opened_run.h"
#include "triangles/tri_model.h"

static const double PI = 3.14159265358979323846;

#define MEMBRANE(word) "discretization.membrane=" word
#define BENDING(word)  "discretization.bending=" word
static const char *const membranes[] = {MEMBRANE("green"), MEMBRANE("corotational"),
                                        MEMBRANE("baraff_witkin")};
static const char *const bendings[] = {BENDING("quadratic"), BENDING("hinge")};

/* Opens oblong cells, askew in space, so that no product vanishes by chance; returns the
 * state. */
static struct tri_motion *start(struct run *run, int n, int m, const char *membrane,
                                const char *bending, double poisson, bool held)
{
    char points[64], material[96], pose[192];

    snprintf(points, sizeof points, "discretization.points=[%d,%d]", n, m);
    snprintf(material, sizeof material, "material={young: 1e4, poisson: %g, density: 0.5}",
             poisson);
    snprintf(pose, sizeof pose,
             "pose={origin: [0,0,0], u: [%.17g,%.17g,%.17g], "
             "v: [%.17g,%.17g,%.17g]}",
             2. / 3, 2. / 3, 1. / 3, -2. / 3, 1. / 3, 2. / 3);
    OPENED_RUN(run, "cantilever", "triangles",
               "sheet={length: 0.8, width: 0.5, thickness: 0.02}", material, pose, points,
               membrane, bending,
               held ? "supports=[{at: {u: 0}, fix: xyz}]" : "supports=[]");
    return run->state;
}

/* Opens a net that softens, some of it within the law's range, some beyond. */
static struct tri_motion *start_soft(struct run *run)
{
    OPENED_RUN(run, "cantilever", "triangles", "sheet={length: 0.8, width: 0.5}",
               "material={membrane: [2000, 5000, 800, 300], areal_density: 0.1, "
               "bending: [1e-2, 4e-2, 4e-3, 6e-3], warp: 30, softening: [-1e-3, -3e-3]}",
               "discretization.points=[6,5]", "supports=[{at: {u: 0}, fix: xyz}]");
    return run->state;
}

static size_t count_of(const struct tri_motion *m)
{
    return 3 * (size_t)m->net.mesh.nodes;
}

enum { MOST = 3 * 200 };

/* A shape far from rest: stretched, sheared, bent by half a radian a cell. */
static void bend(const struct tri_motion *m, double *x)
{
    const double *rest = m->net.mesh.rest;

    for (size_t t = 0; t < count_of(m); t++)
        x[t] = 1.1 * rest[t] + 0.02 * noise((int)t) + 0.05 * rest[t / 3 * 3 + (t + 1) % 3];
}

/* derivative_fixture.h; energy and forces of a turned shape at rest against a deformed
 * one's: squares of strains that are a few roundings of positions over cells. */
static const double DIFFERENCE = 5e-9, RIGID_ENERGY = 1e-24, RIGID_FORCE = 1e-11;

static void check_derivatives(const char *membrane, const char *bending, bool held,
                              bool softens)
{
    struct run run;
    double x[MOST], d[MOST];

    struct tri_motion *m =
        softens ? start_soft(&run) : start(&run, 6, 5, membrane, bending, 0.3, held);
    bend(m, x);
    for (size_t t = 0; t < count_of(m); t++)
        d[t] = noise((int)(3 * t + 1));
    derivative_check(&m->body.body, &m->triangles.graph, x, d, DIFFERENCE);
    if (!held) /* which clamps don't turn with */
        derivative_rigid(&m->body.body, m->net.mesh.rest, 0.3,
                         derivative_energy(&m->body.body, x), RIGID_ENERGY, RIGID_FORCE);
    run_close(&run);
}

/* Foresight: what the linearisation at x - d says of the strains at x, by central
 * differences, which are exact of strains quadratic in x and to third order of others. */
static void check_foresight(const char *membrane)
{
    const double EXACT = 1e-12, TOL_ORDER = 0.1;
    struct run run;
    double x[MOST], d[MOST], error[2] = {0, 0};

    struct tri_motion *m = start(&run, 6, 5, membrane, bendings[0], 0.3, false);
    const size_t count = count_of(m);
    const struct tri_body *b = &m->body;
    for (int k = 0; k < 2; k++) {
        double want[MOST] = {0};
        bend(m, x);
        for (size_t t = 0; t < count; t++)
            d[t] = (k ? 1e-3 : 2e-3) * noise((int)(3 * t + 1)), x[t] -= d[t];
        for (int at = -1; at <= 1; at++) {
            const double *e = b->body.strain(b, 0, 0, x, NULL);
            REQUIRE(e && b->forms_from <= MOST);
            for (int n = 0; n < b->forms_from; n++)
                want[n] += at ? at * e[n] / 2 : e[n];
            for (size_t t = 0; t < count && at < 1; t++)
                x[t] += d[t];
        }
        const double *e =
            b->body.strain(b, 0, 0, x, &(struct large_foresight){.change = d});
        REQUIRE(e);
        for (int n = 0; n < b->forms_from; n++)
            error[k] = hypot(error[k], e[n] - want[n]);
    }
    if (m->body.membrane == MEMBRANE_GREEN)
        CHECK_NEAR(error[0], 0, EXACT);
    else
        CHECK_NEAR(log2(error[0] / error[1]), 3, TOL_ORDER);
    run_close(&run);
}

/* d' K d / 2 of a field over the sheet at rest. */
static double quadratic(struct tri_motion *m, const double *d)
{
    double Kd[MOST];

    REQUIRE(count_of(m) <= MOST);
    CHECK(large_body_tangent(&m->body.body, &large_path_statics, m->net.mesh.rest,
                             (struct large_foresight){0}, m->march.K) == STATUS_OK);
    blocks_multiply(&m->triangles.graph, (const double(*)[9])m->march.K, d, Kd);
    return derivative_dot(count_of(m), d, Kd) / 2;
}

/* Sums over a few hundred triangles whose edges are rounded. */
static const double SUM = 1e-11;

/* Homogeneous strain (e_u, e_v, g): plane stress for every nu, in every triangle; Baraff
 * and Witkin's conditions lack C12. At large strain, and turned, St. Venant and Kirchhoff's
 * energy, and that of Biot's strain, which is the small one of a stretch. */
static void check_membrane(const char *membrane, double nu)
{
    static const double strains[][3] = {{1, 0, 0},    {0, 1, 0}, {1, 1, 0},
                                        {1, -0.4, 0}, {0, 0, 1}, {0.3, -0.8, 0.5}};

    for (size_t k = 0; k < sizeof strains / sizeof *strains; k++) {
        struct run run;
        double field[MOST], x[MOST];
        const double *e = strains[k];
        struct tri_motion *m =
            start(&run, k % 2 ? 2 : 6, k % 2 ? 2 : 5, membrane, bendings[0], nu, false);
        const struct scene *scene = &run.scene;
        for (size_t a = 0; a < count_of(m) / 3; a++) {
            double p = m->net.mesh.uvw[a][0] * scene->length;
            double q = m->net.mesh.uvw[a][1] * scene->width;
            double y[3];
            for (int i = 0; i < 3; i++) {
                field[3 * a + (size_t)i] = (e[0] * p + e[2] / 2 * q) * scene->axis_u[i] +
                                           (e[2] / 2 * p + e[1] * q) * scene->axis_v[i];
                y[i] = m->net.mesh.rest[3 * a + (size_t)i] + field[3 * a + (size_t)i];
            }
            x[3 * a] = cos(1) * y[0] - sin(1) * y[1];
            x[3 * a + 1] = sin(1) * y[0] + cos(1) * y[1], x[3 * a + 2] = y[2];
        }
        double area = scene->length * scene->width;
        double C11 = scene->young * scene->thickness / (1 - nu * nu),
               C12 = m->body.membrane == MEMBRANE_BARAFF_WITKIN ? 0 : nu * C11;
        double C33 = scene->young * scene->thickness / (2 * (1 + nu));
        double want =
            area / 2 *
            (C11 * (e[0] * e[0] + e[1] * e[1]) + 2 * C12 * e[0] * e[1] + C33 * e[2] * e[2]);
        CHECK_RELATIVE(quadratic(m, field), want, SUM);
        if (m->body.membrane == MEMBRANE_COROTATIONAL)
            CHECK_RELATIVE(tri_body_energy(&m->body, x), want, SUM);
        double E1 = e[0] + (e[0] * e[0] + e[2] * e[2] / 4) / 2;
        double E2 = e[1] + (e[1] * e[1] + e[2] * e[2] / 4) / 2;
        double G = e[2] + (e[0] + e[1]) * e[2] / 2;
        want = area / 2 * (C11 * (E1 * E1 + E2 * E2) + 2 * C12 * E1 * E2 + C33 * G * G);
        if (m->body.membrane == MEMBRANE_GREEN)
            CHECK_RELATIVE(tri_body_energy(&m->body, x), want, SUM);
        run_close(&run);
    }
}

/* w = (a s^2 + b t^2) / 2 + c s t: what a net with n x m points has of Kirchhoff's energy,
 * curvatures along u between the lines that have points on both sides, twist in cells. */
static double plate_energy(const struct scene *s, const char *bending, int n, int m,
                           const double k[3])
{
    double nu = s->poisson, cell = s->length / (n - 1) * s->width / (m - 1);
    double D = scene_bending_stiffness(s), rim = 1 - nu * nu;
    double u = (n - 2) * (m - 2) + rim * (n - 2), v = (n - 2) * (m - 2) + rim * (m - 2);
    double both = 2 * nu * (n - 2) * (m - 2), twist = 2 * (1 - nu);

    if (bending == bendings[1])
        u = (n - 2) * (m - 1), v = (m - 2) * (n - 1), both = 0, twist = 2;
    return D / 2 * cell *
           (k[0] * k[0] * u + k[1] * k[1] * v + k[0] * k[1] * both +
            k[2] * k[2] * twist * (n - 1) * (m - 1));
}

/* Hinges sum a few square roots more. */
static const double BEND = 1e-9;

static void check_bending(const char *bending, double nu, double turn, double saddle)
{
    enum { N = 9, M = 8 };
    struct run run;
    double field[MOST], normal[3], c = cos(turn), w = sin(turn);
    const double k[3] = {c * c + saddle * w * w, w * w + saddle * c * c,
                         (1 - saddle) * c * w};

    struct tri_motion *m = start(&run, N, M, membranes[0], bending, nu, false);
    scene_normal(&run.scene, normal);
    for (size_t a = 0; a < count_of(m) / 3; a++) {
        double p = m->net.mesh.uvw[a][0] * run.scene.length;
        double q = m->net.mesh.uvw[a][1] * run.scene.width;
        for (int i = 0; i < 3; i++)
            field[3 * a + (size_t)i] =
                (k[0] * p * p / 2 + k[1] * q * q / 2 + k[2] * p * q) * normal[i];
    }
    CHECK_RELATIVE(quadratic(m, field), plate_energy(&run.scene, bending, N, M, k), BEND);
    /* and on fine nets Kirchhoff's: D / 2 under cylindrical bending about any axis */
    double D = scene_bending_stiffness(&run.scene),
           area = run.scene.length * run.scene.width;
    double gauss = bending == bendings[1] ? 0 : nu;
    double want = area * D / 2 * ((1 + saddle) * (1 + saddle) - 2 * (1 - gauss) * saddle);
    const double FINE = 1e-2;
    CHECK_RELATIVE(plate_energy(&run.scene, bending, 1000, 1000, k), want, FINE);
    run_close(&run);
}

/* Computes the curvature with the k_uu, or k_vv, that costs least. */
static void rim_curvature(const double B[LAW_ENTRIES], const double k[3], int along,
                          double least[3])
{
    const int other = along ? LAW_11 : LAW_22, to = along ? LAW_13 : LAW_23;

    memcpy(least, k, 3 * sizeof *k);
    least[1 - along] = -(B[LAW_12] * k[along] + B[to] * k[2]) / B[other];
}

static double softening(const struct law *law, const double k[3])
{
    double sum = 0;

    for (int n = 0; n < 2; n++) {
        const double *part = law->along[n];
        sum += law_soft_energy(&law->soft[n],
                               part[0] * k[0] + part[1] * k[1] + part[2] * k[2]);
    }
    return sum;
}

static double softening_of(const struct spring_soft *soft, const double *x)
{
    double sum = 0, value[3];

    for (int k = 0; k < soft->forms.count; k++) {
        spring_form_value(&soft->forms, k, x, value);
        sum += spring_soft_energy(soft, k, value);
    }
    return sum;
}

/* A fabric on the bias, under any constant curvature: that of its matrix at points, of a
 * narrow strip on rims; the twist that is left, 1 / (B^-1)_33, in cells. What softens is at
 * points and on rims. */
static void check_bias(double warp)
{
    enum { N = 9, M = 8 };
    static const double curvature[][3] = {
        {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, -0.4, 0.7}, {-0.3, 1, 0.6}};
    char material[200];
    struct run run;

    snprintf(material, sizeof material,
             "material={membrane: [2000, 5000, 800, 300], areal_density: 0.1, "
             "bending: [1e-2, 4e-2, 4e-3, 6e-3], warp: %g, softening: [-4e-3, -3e-2]}",
             warp);
    OPENED_RUN(&run, "cantilever", "triangles", material, "sheet={length: 0.8, width: 0.5}",
               "supports=[]", "discretization.points=[9,8]");
    struct tri_motion *m = run.state;
    const struct law law = scene_law(&run.scene);
    const double *B = law.matrix[LAW_BENDING];
    double inverse[LAW_ENTRIES], field[MOST] = {0};
    law_invert(B, inverse);
    for (size_t n = 0; n < sizeof curvature / sizeof *curvature; n++) {
        const double *k = curvature[n], twist = k[2] * k[2] / inverse[LAW_33];
        for (size_t a = 0; a < count_of(m) / 3; a++) {
            const double p = m->net.mesh.uvw[a][0] * 0.8;
            const double q = m->net.mesh.uvw[a][1] * 0.5;
            field[3 * a + 2] = (k[0] * p * p + k[1] * q * q + k[2] * p * q) / 2;
        }
        const double area = m->net.mesh.cell[0] * m->net.mesh.cell[1];
        double u[3], v[3];
        rim_curvature(B, k, 0, u), rim_curvature(B, k, 1, v);
        const double want = (N - 2) * (M - 2) * (2 * law_energy(B, k) - twist) +
                            (N - 2) * (2 * law_energy(B, u) - twist) +
                            (M - 2) * (2 * law_energy(B, v) - twist) +
                            (N - 1) * (M - 1) * twist;
        const double soft = (N - 2) * (M - 2) * softening(&law, k) +
                            (N - 2) * softening(&law, u) + (M - 2) * softening(&law, v);
        CHECK_RELATIVE(quadratic(m, field), want / 2 * area, BEND);
        CHECK_RELATIVE(quadratic(m, field) + softening_of(&m->triangles.soft, field),
                       (want / 2 + soft) * area, BEND);
    }
    run_close(&run);
}

/* Rolled up to a cylinder, hinges turn by the angle of a cell, and only those across. */
static void check_roll(void)
{
    enum { N = 9, M = 5 };
    struct run run;
    double x[MOST], radius = 0.2;

    struct tri_motion *m = start(&run, N, M, membranes[0], bendings[1], 0.3, false);
    double a = run.scene.length / (N - 1), angle = 2 * asin(a / (2 * radius));
    for (size_t p = 0; p < count_of(m) / 3; p++) {
        double t = (double)(p / M) * angle;
        x[3 * p] = radius * sin(t), x[3 * p + 2] = radius * (1 - cos(t));
        x[3 * p + 1] = m->net.mesh.uvw[p][1] * run.scene.width;
    }
    CHECK_RELATIVE(tri_body_energy(&m->body, x),
                   scene_bending_stiffness(&run.scene) / 2 * (angle * angle / a) *
                       run.scene.width * (N - 2),
                   BEND);
    CHECK_NEAR(angle * radius / a, 1, 0.02);
    run_close(&run);
}

int main(void)
{
    for (int k = 0; k < 3; k++) {
        for (int b = 0; b < 4; b++)
            check_derivatives(membranes[k], bendings[b / 2], b % 2, false);
        check_foresight(membranes[k]);
        for (int nu = -1; nu < 5; nu++)
            check_membrane(membranes[k], 0.1 * nu);
    }
    check_derivatives(NULL, NULL, true, true);
    for (int b = 0; b < 2; b++)
        for (int nu = -1; nu < 5; nu++)
            for (int turn = 0; turn < 4; turn++)
                for (int saddle = -1; saddle < 2; saddle++)
                    check_bending(bendings[b], 0.1 * nu, turn * PI / 4, saddle);
    for (int warp = 0; warp < 180; warp += 15)
        check_bias(warp);
    check_roll();
    return check_result();
}
