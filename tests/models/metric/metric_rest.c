/* Rest shapes as metrics need them: steps and bending over oblique and uneven nets of a
 * plane, whose second derivatives are known, and points of cylinder and cone. */
#include "models/metric/metric_rest.h"

#include "tests/cloak_fixture.h"

/* Second differences of numbers of size 1 over steps of 1/99: 8 eps 99^2. */
static const double TOL_SECOND = 8 * DBL_EPSILON * 99 * 99;
/* An uneven net: the next term of the differences, (1/99)^2 times numbers of size 10. */
static const double TOL_UNEVEN = 1e-3;
static const double TOL_POINT = 16 * DBL_EPSILON;

/* A net in the plane: u, v into X, Y; `bend` makes it uneven. */
static void place(double bend, int i, int j, double x[3])
{
    const double u = i / 99., v = j / 99.;

    x[0] = 0.9 * u + 0.4 * v + bend * (0.3 * u * u - 0.2 * u * v);
    x[1] = 0.1 * u + 0.7 * v + bend * (0.2 * v * v + 0.1 * u * v);
    x[2] = 0;
}

/* z = (a X^2 + 2 b X Y + c Y^2) / 2: its second derivatives are a, b, c all over. And
 * nothing comes of what is linear in X and Y. */
static void lift(const double k[3], double x[3])
{
    const double X = x[0], Y = x[1];

    x[0] = 1 + X - 0.3 * Y, x[1] = 2 * Y + 0.2 * X;
    x[2] = (k[0] * X * X + 2 * k[1] * X * Y + k[2] * Y * Y) / 2 - 3 * X + Y;
}

static void test_bending(void)
{
    static const double k[][3] = {{0, 0, 0}, {1, 0, 0},  {0, 1, 0},
                                  {0, 0, 1}, {1, -2, 3}, {-2, 1, 0.5}};
    struct metric_rest rest = {.xyz = malloc(3 * GRID_U * GRID_V * sizeof(double))};

    REQUIRE(rest.xyz);
    for (int bend = 0; bend < 2; bend++) {
        for (int n = 0; n < GRID_U * GRID_V; n++)
            place(bend, n % GRID_U, n / GRID_U, rest.xyz + 3 * n);
        for (size_t n = 0; n < sizeof k / sizeof *k; n++)
            for (int turn = 0; turn < 3; turn++) { /* x, y, z exchanged in space */
                double x[3][3][3], at[3];
                for (int q = 0; q < 3; q++)
                    for (int p = 0; p < 3; p++) {
                        place(bend, 39 + p, 69 + q, at);
                        lift(k[n], at);
                        for (int c = 0; c < 3; c++)
                            x[q][p][c] = at[(c + turn) % 3];
                    }
                const double want =
                    k[n][0] * k[n][0] + 2 * k[n][1] * k[n][1] + k[n][2] * k[n][2];
                CHECK_NEAR(metric_rest_bending(&rest, 40, 70, x), want,
                           bend ? TOL_UNEVEN * (1 + want) : TOL_SECOND * (1 + want) * 20);
            }
    }
    metric_rest_clear(&rest);
    CHECK(!rest.xyz);
}

/* Along and across an oblique net, in space. */
static void test_steps(void)
{
    const struct scene scene = {0}; /* whose lengths do not matter */
    struct metric_rest rest = {&scene, malloc(3 * GRID_U * GRID_V * sizeof(double))};
    static const double along[3] = {3, 0, 4},
                        across[3] = {6, 2, 8}; /* 10 along, 2 beside */

    REQUIRE(rest.xyz);
    for (int n = 0; n < GRID_U * GRID_V; n++)
        for (int c = 0; c < 3; c++)
            rest.xyz[3 * n + c] = n % GRID_U * along[c] + n / GRID_U * across[c];
    struct metric_rest_step s = metric_rest_step(&rest, 5, 7, 4, 6, 6, 8);
    CHECK_NEAR(s.a, 2 * 5.0, 10 * TOL_POINT);
    CHECK_NEAR(s.shear, 2 * 10.0, 20 * TOL_POINT);
    CHECK_NEAR(s.b, 2 * 2.0, 400 * TOL_POINT);
    s = metric_rest_step(&rest, 0, 99, 0, 1, 98, 99); /* at an edge, one step */
    CHECK_NEAR(s.a, 5.0, 10 * TOL_POINT);
    CHECK_NEAR(s.b, 2.0, 400 * TOL_POINT);
    metric_rest_clear(&rest);
}

/* The mid-surface, not a face, of a cone. */
static void test_middle(void)
{
    struct metric_rest rest;
    struct scene s;
    double *field;

    init_cloak(&s, 60, 10);
    REQUIRE(metric_rest_init(&rest, &s) == STATUS_OK && rest.xyz);
    for (int n = 0; n < GRID_U * GRID_V; n += 37) {
        const double uvw[3] = {n % GRID_U / 99., n / GRID_U / 99., 0.5};
        double x[3];
        scene_rest_point(&s, uvw, x);
        for (int c = 0; c < 3; c++)
            CHECK_NEAR(rest.xyz[3 * n + c], x[c], TOL_POINT);
    }
    field = metric_rest_field(&s); /* both faces */
    REQUIRE(field);
    for (int n = 0; n < GRID_POINTS; n += 331) {
        double uvw[3], x[3];
        grid_point(n, uvw);
        scene_rest_point(&s, uvw, x);
        CHECK(!memcmp(x, field + 3 * n, sizeof x));
    }
    free(field);
    metric_rest_clear(&rest);
    scene_clear(&s);
}

/* The height of part of a half cylinder of radius 1/2: on its ridge, at its rims, at either
 * end. */
static void test_highest(void)
{
    static const struct {
        double lo[3], hi[3];
        int along;   /* up is the axis (1), or out of the ridge (2)                     */
        double sign; /* up, or down                                                    */
        double height;
    } cases[] = {
        {{0, 0, 0.9}, {1, 1, 1}, 2, 1, 0.5},      /* the ridge */
        {{0, 0.75, 0.1}, {1, 1, 1}, 2, -1, 0},    /* the rim v = 1 */
        {{0, 0, 0.9}, {1, 0.25, 1}, 2, -1, 0},    /* the rim v = 0 */
        {{0.25, 0, 0.9}, {0.5, 1, 1}, 1, 1, 0.4}, /* L = 0.8 */
        {{0.25, 0, 0.9}, {0.5, 1, 1}, 1, -1, -0.2},
    };
    struct scene s;

    init_cloak(&s, 180, 0);
    s.width = 0.5 * PI;
    memset(s.origin, 0, sizeof s.origin);
    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        double w[3], down[3];
        scene_normal(&s, w);
        for (int c = 0; c < 3; c++)
            down[c] = -cases[n].sign * (cases[n].along == 1 ? s.axis_u[c] : w[c]);
        SAY_UNLESS(CHECK_NEAR(metric_rest_highest(&s, cases[n].lo, cases[n].hi, down),
                              cases[n].height, TOL_POINT),
                   "case %zu", n);
    }
    scene_clear(&s);
}

/* From the neck of a cone, of which three points are looked at; from a part of a flat
 * sheet, exactly. */
static void test_distance(void)
{
    static const double all[3] = {1, 1, 1}, zero[3] = {0, 0, 0}, neck[3] = {0, 1, 1};
    static const double off[3] = {0.03, -0.04, 0.12};
    struct scene s;
    double x[3], first[3], sum = 0;

    init_cloak(&s, 60, 10);
    for (int v = 0; v < 3; v++) { /* each of the three is found */
        scene_rest_point(&s, (double[]){0, v / 2., 0.5}, x);
        for (int c = 0; c < 3; c++)
            x[c] += off[c];
        CHECK_NEAR(metric_rest_distance(&s, zero, neck, 0, x), 0.0169, TOL_POINT);
    }
    /* the far edge, of the whole sheet */
    scene_rest_point(&s, (double[]){1, 0.5, 0.5}, x);
    CHECK_NEAR(metric_rest_distance(&s, zero, all, 0, x), 0, TOL_POINT);
    /* near enough: the first point will do */
    scene_rest_point(&s, (double[]){0, 0, 0.5}, first);
    for (int c = 0; c < 3; c++)
        sum += (x[c] - first[c]) * (x[c] - first[c]);
    CHECK_NEAR(metric_rest_distance(&s, zero, all, 8, x), sum, TOL_POINT);
    scene_clear(&s);

    REQUIRE(scene_init(&s) == STATUS_OK);
    s.length = 2, s.width = 1, s.thickness = 0.1;
    memcpy(s.origin, (double[]){1, 2, 3}, sizeof s.origin);
    memcpy(s.axis_u, (double[]){0, 1, 0}, sizeof s.axis_u);
    memcpy(s.axis_v, (double[]){0, 0, 1}, sizeof s.axis_v); /* so that w is x */
    const double lo[3] = {0.25, 0.5, 0}, hi[3] = {0.5, 1, 0.5};
    CHECK_NEAR(metric_rest_distance(&s, lo, hi, 0, (double[]){0.97, 2.7, 3.7}), 0,
               TOL_POINT);
    CHECK_NEAR(metric_rest_distance(&s, lo, hi, 0, (double[]){1.2, 3.3, 3.3}),
               0.2 * 0.2 + 0.3 * 0.3 + 0.2 * 0.2, TOL_POINT);
    CHECK_NEAR(metric_rest_distance(&s, lo, hi, 0, (double[]){0.85, 2.1, 4.5}),
               0.1 * 0.1 + 0.4 * 0.4 + 0.5 * 0.5, TOL_POINT);
    scene_clear(&s);
}

int main(void)
{
    test_bending();
    test_steps();
    test_middle();
    test_highest();
    test_distance();
    return check_result();
}
