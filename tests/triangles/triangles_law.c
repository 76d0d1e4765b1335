/* Triangles: forces and tangents against differences, rigid motions, homogeneous strain for
 * every nu, bending about every axis. */
#include <float.h>

#include "tests/derivative_fixture.h"
#include "tests/triangles.h"

static const double PI = 3.14159265358979323846;

static const enum membrane MEMBRANES[] = {MEMBRANE_GREEN, MEMBRANE_COROTATIONAL,
                                          MEMBRANE_BARAFF_WITKIN};
static const enum bending BENDINGS[] = {BENDING_QUADRATIC, BENDING_HINGE};

/* Oblong cells, askew in space, so that no product vanishes by chance. */
static void start(struct sheet *s, int n, int m, enum membrane membrane,
                  enum bending bending, double poisson, bool held)
{
    const double u[3] = {2. / 3, 2. / 3, 1. / 3}, v[3] = {-2. / 3, 1. / 3, 2. / 3};

    sheet_init(s, n, m);
    s->scene.length = 0.8;
    s->scene.width = 0.5;
    s->scene.thickness = 0.02;
    s->scene.young = 1e4;
    s->scene.poisson = poisson;
    memcpy(s->scene.axis_u, u, sizeof u);
    memcpy(s->scene.axis_v, v, sizeof v);
    OWN(tri_own, &s->d)->membrane = membrane, s->d.bending = bending;
    if (held)
        sheet_clamp(s);
    sheet_start(s);
}

static size_t count_of(const struct sheet *s)
{
    return 3 * (size_t)s->m->net.points.nodes;
}

/* Numbers in (-1, 1), the same on every run. */
static double noise(size_t n)
{
    return 2 * fmod((double)(n + 1) * 0.6180339887498949, 1) - 1;
}

enum { MOST = 3 * 200 };

/* A shape far from rest: stretched, sheared, bent by half a radian a cell. */
static void bend(const struct sheet *s, double *x)
{
    const double *rest = s->m->net.points.rest;

    for (size_t t = 0; t < count_of(s); t++)
        x[t] = 1.1 * rest[t] + 0.02 * noise(t) + 0.05 * rest[t / 3 * 3 + (t + 1) % 3];
}

/* derivative_fixture.h */
static const double DIFFERENCE = 5e-9;

static void check_derivatives(enum membrane membrane, enum bending bending)
{
    struct sheet s;
    double x[MOST], d[MOST];

    start(&s, 6, 5, membrane, bending, 0.3, true);
    bend(&s, x);
    for (size_t t = 0; t < count_of(&s); t++)
        d[t] = noise(3 * t + 1);
    derivative_check(&s.m->body.body, &s.m->net.graph, x, d, DIFFERENCE);
    sheet_clear(&s);
}

/* Foresight: what the linearisation at x - d says of the strains at x, by central
 * differences, which are exact of strains quadratic in x and to third order of others. */
static void check_foresight(enum membrane membrane)
{
    const double EXACT = 1e-12, TOL_ORDER = 0.1;
    struct sheet s;
    double x[MOST], d[MOST], error[2] = {0, 0};

    start(&s, 6, 5, membrane, BENDING_QUADRATIC, 0.3, false);
    const size_t count = count_of(&s);
    const struct tri_body *b = &s.m->body;
    for (int k = 0; k < 2; k++) {
        double want[MOST] = {0};
        bend(&s, x);
        for (size_t t = 0; t < count; t++)
            d[t] = (k ? 1e-3 : 2e-3) * noise(3 * t + 1), x[t] -= d[t];
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
    if (membrane == MEMBRANE_GREEN)
        CHECK_NEAR(error[0], 0, EXACT);
    else
        CHECK_NEAR(log2(error[0] / error[1]), 3, TOL_ORDER);
    sheet_clear(&s);
}

/* A turn and a shift: squares of strains that are a few roundings of positions over cells.
 */
static const double RIGID = 1e-26;

static void check_rigid(enum membrane membrane, enum bending bending)
{
    struct sheet s;
    double x[MOST];

    start(&s, 5, 6, membrane, bending, 0.3, false);
    for (size_t t = 0; t < count_of(&s); t += 3) {
        const double *p = s.m->net.points.rest + t;
        double c = cos(2), w = sin(2);
        x[t] = c * p[0] - w * p[2] + 0.3, x[t + 1] = p[1] - 0.2;
        x[t + 2] = w * p[0] + c * p[2] + 0.1;
    }
    CHECK_NEAR(tri_body_energy(&s.m->body, x) / (s.scene.young * s.scene.thickness), 0,
               RIGID);
    sheet_clear(&s);
}

/* d' K d / 2 of a field over the sheet at rest. */
static double quadratic(struct sheet *s, const double *d)
{
    double Kd[MOST];

    REQUIRE(count_of(s) <= MOST);
    CHECK(large_body_tangent(&s->m->body.body, &derivative_statics, s->m->net.points.rest,
                             (struct large_foresight){0}, s->m->large.K) == STATUS_OK);
    blocks_multiply(&s->m->net.graph, (const double(*)[9])s->m->large.K, d, Kd);
    return derivative_dot(count_of(s), d, Kd) / 2;
}

/* Sums over a few hundred triangles whose edges are rounded. */
static const double SUM = 1e-11;

/* Homogeneous strain (e_u, e_v, g): plane stress for every nu, in every triangle; Baraff
 * and Witkin's conditions lack C12. St. Venant and Kirchhoff's energy at large strain, too.
 */
static void check_membrane(enum membrane membrane, double nu)
{
    static const double strains[][3] = {{1, 0, 0},    {0, 1, 0}, {1, 1, 0},
                                        {1, -0.4, 0}, {0, 0, 1}, {0.3, -0.8, 0.5}};

    for (size_t k = 0; k < sizeof strains / sizeof *strains; k++) {
        struct sheet s;
        double field[MOST], x[MOST];
        const double *e = strains[k];
        start(&s, k % 2 ? 2 : 6, k % 2 ? 2 : 5, membrane, BENDING_QUADRATIC, nu, false);
        const struct scene *scene = &s.scene;
        for (size_t a = 0; a < count_of(&s) / 3; a++) {
            double p = s.m->net.points.uvw[a][0] * scene->length;
            double q = s.m->net.points.uvw[a][1] * scene->width;
            for (int i = 0; i < 3; i++) {
                field[3 * a + (size_t)i] = (e[0] * p + e[2] / 2 * q) * scene->axis_u[i] +
                                           (e[2] / 2 * p + e[1] * q) * scene->axis_v[i];
                x[3 * a + (size_t)i] =
                    s.m->net.points.rest[3 * a + (size_t)i] + field[3 * a + (size_t)i];
            }
        }
        double area = scene->length * scene->width;
        double C11 = scene->young * scene->thickness / (1 - nu * nu),
               C12 = membrane == MEMBRANE_BARAFF_WITKIN ? 0 : nu * C11;
        double C33 = scene->young * scene->thickness / (2 * (1 + nu));
        double want =
            area / 2 *
            (C11 * (e[0] * e[0] + e[1] * e[1]) + 2 * C12 * e[0] * e[1] + C33 * e[2] * e[2]);
        CHECK_RELATIVE(quadratic(&s, field), want, SUM);
        double E1 = e[0] + (e[0] * e[0] + e[2] * e[2] / 4) / 2;
        double E2 = e[1] + (e[1] * e[1] + e[2] * e[2] / 4) / 2;
        double G = e[2] + (e[0] + e[1]) * e[2] / 2;
        want = area / 2 * (C11 * (E1 * E1 + E2 * E2) + 2 * C12 * E1 * E2 + C33 * G * G);
        if (membrane == MEMBRANE_GREEN)
            CHECK_RELATIVE(tri_body_energy(&s.m->body, x), want, SUM);
        sheet_clear(&s);
    }
}

/* Biot's strain of a stretch and a turn is what it was before the turn. */
static void check_corotational(void)
{
    struct sheet s;
    double x[MOST];
    const double U[3] = {1.4, 0.7, 0.2};

    start(&s, 4, 4, MEMBRANE_COROTATIONAL, BENDING_QUADRATIC, 0.3, false);
    for (size_t a = 0; a < count_of(&s) / 3; a++) {
        double p = s.m->net.points.uvw[a][0] * s.scene.length;
        double q = s.m->net.points.uvw[a][1] * s.scene.width;
        double f = U[0] * p + U[2] * q, g = U[2] * p + U[1] * q;
        x[3 * a] = cos(1) * f, x[3 * a + 1] = sin(1) * f, x[3 * a + 2] = g;
    }
    const double *D = s.m->body.D;
    double e = U[0] - 1, f = U[1] - 1, area = s.scene.length * s.scene.width;
    CHECK_RELATIVE(tri_body_energy(&s.m->body, x),
                   area / 2 *
                       (D[0] * (e * e + f * f) + 2 * D[1] * e * f + 4 * D[2] * U[2] * U[2]),
                   SUM);
    sheet_clear(&s);
}

/* w = (a s^2 + b t^2) / 2 + c s t: what a net with n x m points has of Kirchhoff's energy,
 * curvatures along u between the lines that have points on both sides, twist in cells. */
static double plate_energy(const struct scene *s, enum bending bending, int n, int m,
                           const double k[3])
{
    double nu = s->poisson, cell = s->length / (n - 1) * s->width / (m - 1);
    double D = scene_bending_stiffness(s), rim = 1 - nu * nu;
    double u = (n - 2) * (m - 2) + rim * (n - 2), v = (n - 2) * (m - 2) + rim * (m - 2);
    double both = 2 * nu * (n - 2) * (m - 2), twist = 2 * (1 - nu);

    if (bending == BENDING_HINGE)
        u = (n - 2) * (m - 1), v = (m - 2) * (n - 1), both = 0, twist = 2;
    return D / 2 * cell *
           (k[0] * k[0] * u + k[1] * k[1] * v + k[0] * k[1] * both +
            k[2] * k[2] * twist * (n - 1) * (m - 1));
}

/* Hinges sum a few square roots more. */
static const double BEND = 1e-9;

static void check_bending(enum bending bending, double nu, double turn, double saddle)
{
    enum { N = 9, M = 8 };
    struct sheet s;
    double field[MOST], normal[3], c = cos(turn), w = sin(turn);
    const double k[3] = {c * c + saddle * w * w, w * w + saddle * c * c,
                         (1 - saddle) * c * w};

    start(&s, N, M, MEMBRANE_GREEN, bending, nu, false);
    scene_normal(&s.scene, normal);
    for (size_t a = 0; a < count_of(&s) / 3; a++) {
        double p = s.m->net.points.uvw[a][0] * s.scene.length;
        double q = s.m->net.points.uvw[a][1] * s.scene.width;
        for (int i = 0; i < 3; i++)
            field[3 * a + (size_t)i] =
                (k[0] * p * p / 2 + k[1] * q * q / 2 + k[2] * p * q) * normal[i];
    }
    CHECK_RELATIVE(quadratic(&s, field), plate_energy(&s.scene, bending, N, M, k), BEND);
    /* and on fine nets Kirchhoff's: D / 2 under cylindrical bending about any axis */
    double D = scene_bending_stiffness(&s.scene), area = s.scene.length * s.scene.width;
    double gauss = bending == BENDING_HINGE ? 0 : nu;
    double want = area * D / 2 * ((1 + saddle) * (1 + saddle) - 2 * (1 - gauss) * saddle);
    const double FINE = 1e-2;
    CHECK_RELATIVE(plate_energy(&s.scene, bending, 1000, 1000, k), want, FINE);
    sheet_clear(&s);
}

/* Rolled up to a cylinder, hinges turn by the angle of a cell, and only those across. */
static void check_roll(void)
{
    enum { N = 9, M = 5 };
    struct sheet s;
    double x[MOST], radius = 0.2;

    start(&s, N, M, MEMBRANE_GREEN, BENDING_HINGE, 0.3, false);
    double a = s.scene.length / (N - 1), angle = 2 * asin(a / (2 * radius));
    for (size_t p = 0; p < count_of(&s) / 3; p++) {
        double t = (double)(p / M) * angle;
        x[3 * p] = radius * sin(t), x[3 * p + 2] = radius * (1 - cos(t));
        x[3 * p + 1] = s.m->net.points.uvw[p][1] * s.scene.width;
    }
    CHECK_RELATIVE(tri_body_energy(&s.m->body, x),
                   scene_bending_stiffness(&s.scene) / 2 * (angle * angle / a) *
                       s.scene.width * (N - 2),
                   BEND);
    CHECK_NEAR(angle * radius / a, 1, 0.02);
    sheet_clear(&s);
}

int main(void)
{
    for (int k = 0; k < 3; k++) {
        for (int b = 0; b < 2; b++) {
            check_derivatives(MEMBRANES[k], BENDINGS[b]);
            check_rigid(MEMBRANES[k], BENDINGS[b]);
        }
        check_foresight(MEMBRANES[k]);
        for (int nu = -1; nu < 5; nu++)
            check_membrane(MEMBRANES[k], 0.1 * nu);
    }
    check_corotational();
    for (int b = 0; b < 2; b++)
        for (int nu = -1; nu < 5; nu++)
            for (int turn = 0; turn < 4; turn++)
                for (int saddle = -1; saddle < 2; saddle++)
                    check_bending(BENDINGS[b], 0.1 * nu, turn * PI / 4, saddle);
    check_roll();
    return check_result();
}
