/* Metrics of fields whose numbers are known by hand. */
#include "models/metric/metric.h"

#include "tests/metric_fixture.h"

/* A first difference over one or two steps s >= 0.35/99 loses eps/s on coordinates of
 * size 1. */
#define TOL_STRETCH (4 * DBL_EPSILON * 99 / 0.35)

/* The middle of a span is rounded to a step of the grid: angles by 1 / 99 R, at either end,
 * and by as much as these do not cancel in all. */
#define TOL_TURN 1e-2

/* Two columns of eighty have a neighbour on the edge, with a one-sided difference. */
#define TOL_EDGE 1e-2

/* Points that neither field has are beside the sheet; one that only one has is a fault. */
static void test_rmse_beside(void)
{
    static double a[COUNT], b[COUNT];

    for (int n = 0; n < 3 * GRID_POINTS; n++)
        a[n] = n < 3 * GRID_POINTS / 2 ? NAN : n, b[n] = a[n] + (n % 3 == 1 ? 0.13 : 0);
    CHECK_NEAR(metric_rmse(a, b), 0.13, 1e-9); /* n + 0.13 has 12 digits */
    a[3 * GRID_POINTS - 1] = NAN;
    CHECK(isnan(metric_rmse(a, b)));
}

static void test_rmse(void)
{
    static const double unit[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    static double a[COUNT], b[COUNT];
    struct scene scene;

    init_tilted(&scene);
    fill_rest(&scene, a);
    fill_rest(&scene, b);
    CHECK(metric_rmse(a, b) == 0);
    map_affine(b, unit, (double[]){0.03, 0.04, 0.12});
    CHECK_NEAR(metric_rmse(a, b), 0.13, TOL_RMSE);
    CHECK(metric_rmse(a, b) == metric_rmse(b, a));
    for (int c = 0; c < 3; c++) { /* along each axis, and of one layer alone */
        double by[3] = {0};
        by[c] = -0.2;
        memcpy(b, a, COUNT * sizeof *a);
        map_affine(b, unit, by);
        CHECK_NEAR(metric_rmse(a, b), 0.2, TOL_RMSE);
        memcpy(b + (c % 2) * COUNT / 2, a + (c % 2) * COUNT / 2, COUNT / 2 * sizeof *a);
        CHECK_NEAR(metric_rmse(a, b), 0.2 / sqrt(2), TOL_RMSE);
    }

    /* one point of the 20000 off by 1 m */
    memcpy(b, a, COUNT * sizeof *a);
    b[3 * 12345 + 1] += 1;
    CHECK_NEAR(metric_rmse(a, b), sqrt(1.0 / 20000), TOL_ROUND);
    b[COUNT - 1] = NAN;
    CHECK(isnan(metric_rmse(a, b)));
    b[COUNT - 1] = INFINITY;
    CHECK(isinf(metric_rmse(a, b)));
    scene_clear(&scene);
}

static void test_stretch(void)
{
    /* a rotation about (1,1,1)/sqrt 3 by 120 degrees and a stretch along the sheet's axes
     */
    static const double turn[3][3] = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
    static const double along_v[3][3] = {{1, 0, 0}, {0, 1.25, 0}, {0, 0, 1}};
    static const double shear[3][3] = {{1, 0.5, 0}, {0, 1, 0}, {0, 0, 1}};
    static double xyz[COUNT];
    struct scene scene;

    init_tilted(&scene);
    fill_rest(&scene, xyz);
    CHECK_NEAR(metric_stretch(&scene, xyz), 1.0, TOL_STRETCH);
    map_affine(xyz, turn, (double[]){1, 2, 3});
    CHECK_NEAR(metric_stretch(&scene, xyz), 1.0, TOL_STRETCH);
    fill_rest(&scene, xyz);
    map_affine(xyz, along_v, (double[]){0, 0, 0});
    CHECK_NEAR(metric_stretch(&scene, xyz), 1.25, TOL_STRETCH);

    /* simple shear by 1/2 of a level sheet: sqrt of the larger root of t^2 - 2.25 t + 1 */
    memcpy(scene.axis_u, (double[]){1, 0, 0}, sizeof scene.axis_u);
    fill_rest(&scene, xyz);
    map_affine(xyz, shear, (double[]){0, 0, 0});
    CHECK_NEAR(metric_stretch(&scene, xyz), sqrt((2.25 + sqrt(1.0625)) / 2), TOL_STRETCH);

    /* only the edge u = 1 is drawn out, by three steps: the one-sided difference sees 4 */
    fill_rest(&scene, xyz);
    for (int row = 0; row < GRID_V * GRID_W; row++)
        xyz[3 * (row * GRID_U + GRID_U - 1)] += 3 * scene.length / 99;
    CHECK_NEAR(metric_stretch(&scene, xyz), 4.0, TOL_STRETCH);
    /* a gap of four steps between the second line and the third: no difference sees all */
    for (int side = 0; side < 4; side++) {
        const int axis = side % 2, after = side < 2 ? 1 : 97;
        fill_rest(&scene, xyz);
        for (int n = 0; n < GRID_POINTS; n++)
            if ((axis ? n / GRID_U % GRID_V : n % GRID_U) > after)
                xyz[3 * n + axis] += 3 * (axis ? scene.width : scene.length) / 99;
        CHECK_NEAR(metric_stretch(&scene, xyz), 2.5, TOL_STRETCH);
    }
    xyz[7] = NAN;
    CHECK(isnan(metric_stretch(&scene, xyz)));
    scene_clear(&scene);
}

/* The sheet rolled to a cylinder of radius R, of u, or stretched by 1 + a u^2 along u. */
static void fill_bent(const struct scene *scene, double R, double a, double *xyz)
{
    for (int n = 0; n < GRID_POINTS; n++) {
        double uvw[3];
        grid_point(n, uvw);
        const double s = uvw[0] * scene->length;
        xyz[3 * n] = R > 0 ? R * sin(s / R) : s + a * s * s * s / 3;
        xyz[3 * n + 1] = uvw[1] * scene->width;
        xyz[3 * n + 2] = R > 0 ? R * cos(s / R) : 0;
    }
}

/* Even strain has no spread, and none that grows with s; of 1 + a s^2 the mean of two
 * neighbours at a distance d is a d^2 more, and that of four half of it. A cell of n along
 * a cylinder turns by L / n R, none across it; the last has no neighbour. */
static void test_spread_and_turn(void)
{
    enum { N = 9 };
    static const double R = 0.7, a = 0.3, d = 10. / 99;
    static double xyz[COUNT];
    struct scene scene;

    REQUIRE(scene_init(&scene) == STATUS_OK);
    fill_rest(&scene, xyz);
    CHECK_NEAR(metric_spread(&scene, xyz), 0, TOL_STRETCH);
    CHECK_NEAR(metric_turn(&scene, (const int[]){N, N}, xyz), 0, TOL_STRETCH);
    fill_bent(&scene, 0, a, xyz);
    CHECK_RELATIVE(metric_spread(&scene, xyz), a * d * d / 2, TOL_EDGE);
    fill_bent(&scene, R, 0, xyz);
    CHECK_NEAR(metric_turn(&scene, (const int[]){N, 4}, xyz), sqrt((N - 1.) / N) / N / R,
               TOL_TURN);
    CHECK_NEAR(metric_spread(&scene, xyz), 0, TOL_STRETCH);
    scene.shape = SCENE_CLOAK;
    CHECK(isnan(metric_turn(&scene, (const int[]){N, N}, xyz)));
    scene.shape = SCENE_FLAT;
    xyz[3 * (GRID_U * 50 + 50)] = NAN;
    CHECK(isnan(metric_spread(&scene, xyz)));
    scene_clear(&scene);
}

static void test_drop(void)
{
    static const double unit[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    static double xyz[COUNT];
    struct scene scene;
    struct scene_support edge = {.lo = {0, 0, 0}, .hi = {0, 1, 1}, .fix = FIX_XYZ};
    struct scene_support strip = {.lo = {0, 0, 0}, .hi = {0.5, 1, 1}, .fix = FIX_XYZ};

    /* the tilted sheet rises by 0.8 * 0.7 m from u = 0 to u = 1 */
    init_tilted(&scene);
    fill_rest(&scene, xyz);
    CHECK_NEAR(metric_drop(&scene, xyz), 0.8, TOL_ROUND); /* no support: from u = 1 */
    REQUIRE(scene_add_support(&scene, &edge) == STATUS_OK);
    CHECK_NEAR(metric_drop(&scene, xyz), 0.0, TOL_ROUND);
    map_affine(xyz, unit, (double[]){0, 0, -0.35});
    CHECK_NEAR(metric_drop(&scene, xyz), 0.5, TOL_ROUND);
    REQUIRE(scene_add_support(&scene, &strip) == STATUS_OK);
    CHECK_NEAR(metric_drop(&scene, xyz), 0.9, TOL_ROUND);

    /* gravity along +x: 0.6 * 0.7 m of the sheet lie below u = 0, the highest support */
    fill_rest(&scene, xyz);
    memcpy(scene.gravity, (double[]){2, 0, 0}, sizeof scene.gravity);
    CHECK_NEAR(metric_drop(&scene, xyz), 0.6, TOL_ROUND);
    xyz[COUNT - 3] = NAN;
    CHECK(isnan(metric_drop(&scene, xyz)));
    scene_clear(&scene);
}

static void test_roughness(void)
{
    static const double shear[3][3] = {{1, 0.5, 0.2}, {0.1, 1, -0.3}, {0, 0.7, 1}};
    static double xyz[COUNT];
    double radius = 0.25, kappa = 0.3;
    struct scene scene;

    init_tilted(&scene);
    fill_rest(&scene, xyz);
    map_affine(xyz, shear, (double[]){0, 0, 0});
    CHECK_NEAR(metric_roughness(&scene, xyz), 0.0, TOL_ROUGHNESS);

    /* rolled on a cylinder along u: chords give 2 R (1 - cos(s/R)) / s^2 at every point */
    for (int n = 0; n < GRID_POINTS; n++) {
        double uvw[3];
        grid_point(n, uvw);
        double angle = uvw[0] * scene.length / radius;
        xyz[3 * n] = radius * sin(angle);
        xyz[3 * n + 1] = uvw[1] * scene.width;
        xyz[3 * n + 2] = radius * cos(angle);
    }
    double s = scene.length / 99;
    double chord = 2 * radius * (1 - cos(s / radius)) / (s * s);
    CHECK_NEAR(metric_roughness(&scene, xyz), scene.length * chord, TOL_ROUGHNESS);
    CHECK_NEAR(chord, 1 / radius, pow(s / radius, 2) / 12 / radius);

    /* a twist z = kappa a b has x_ab = kappa only, which central differences get exactly */
    for (int n = 0; n < GRID_POINTS; n++) {
        double uvw[3];
        grid_point(n, uvw);
        double a = uvw[0] * scene.length, b = uvw[1] * scene.width;
        xyz[3 * n] = a, xyz[3 * n + 1] = b, xyz[3 * n + 2] = kappa * a * b;
    }
    CHECK_NEAR(metric_roughness(&scene, xyz), scene.length * sqrt(2) * kappa,
               TOL_ROUGHNESS);

    /* one grid point lifted by e on the mid-surface: 4 e/s^2 at its own and so on */
    fill_rest(&scene, xyz);
    memcpy(scene.axis_u, (double[]){1, 0, 0}, sizeof scene.axis_u);
    scene.width = scene.length;
    fill_rest(&scene, xyz);
    double lift = 0.01 * s * s;
    for (int k = 0; k < GRID_W; k++)
        xyz[3 * ((k * GRID_V + 50) * GRID_U + 40) + 2] += lift;
    /* pure: own point (2^2 + 2^2), four neighbours 1; mixed: four diagonals 2 (1/4)^2 */
    double squares = 0.01 * 0.01 * (8 + 4 + 4 * 2 / 16.0);
    CHECK_NEAR(metric_roughness(&scene, xyz), scene.length * sqrt(squares / (98 * 98)),
               TOL_ROUGHNESS);
    /* inside, 60 x 60 points; one lifted at 0.19 is out, but for its neighbour in the first
     * column: 1 and two diagonals 2 (1/4)^2 */
    CHECK_NEAR(metric_inner_roughness(&scene, xyz),
               scene.length * sqrt(squares / (60 * 60)), TOL_ROUGHNESS);
    fill_rest(&scene, xyz);
    for (int k = 0; k < GRID_W; k++)
        xyz[3 * ((k * GRID_V + 50) * GRID_U + 19) + 2] += lift;
    CHECK_NEAR(metric_inner_roughness(&scene, xyz),
               scene.length * sqrt(0.01 * 0.01 * (1 + 2 * 2 / 16.0) / (60 * 60)),
               TOL_ROUGHNESS);
    xyz[0] = NAN;
    CHECK(isnan(metric_roughness(&scene, xyz)));
    CHECK(!isnan(metric_inner_roughness(&scene, xyz)));
    scene_clear(&scene);
}

static void test_unevenness(void)
{
    const double waves = 3, turn = 2 * acos(-1), tall = 0.05;
    static double xyz[COUNT];
    double smooth;
    struct scene scene;

    init_tilted(&scene);
    for (int along = 0; along < 3; along++) { /* u, v, the diagonal */
        for (int n = 0; n < GRID_POINTS; n++) {
            double uvw[3];
            grid_point(n, uvw);
            xyz[3 * n] = uvw[0] * scene.length;
            xyz[3 * n + 1] = uvw[1] * scene.width;
            xyz[3 * n + 2] =
                tall * sin(turn * waves * ((along != 1) * uvw[0] + (along != 0) * uvw[1]));
        }
        /* three of 99 columns are left out, where the second derivative of the sine is
         * least and the third greatest */
        double k =
            turn * waves * hypot((along != 1) / scene.length, (along != 0) / scene.width);
        CHECK_RELATIVE(metric_unevenness(&scene, xyz), scene.length * k, 3 / 99.);
    }
    smooth = metric_unevenness(&scene, xyz);
    for (int n = 0; n < 3 * GRID_POINTS; n += 3) /* the height does not matter */
        xyz[n + 2] *= 7;
    CHECK_RELATIVE(metric_unevenness(&scene, xyz), smooth, 1e-9);

    /* a kink: flat, then a parabola; curvature jumps once, by all it has */
    for (int n = 0; n < GRID_POINTS; n++) {
        double uvw[3];
        grid_point(n, uvw);
        xyz[3 * n + 2] = tall * pow(fmax(0, uvw[0] - 50 / 99.), 2);
    }
    /* interior columns 1..97: 47 curved and one half curved; two jumps of one half */
    double s = scene.length / 99;
    CHECK_RELATIVE(metric_unevenness(&scene, xyz),
                   scene.length / s * sqrt((0.25 + 0.25) / (47 + 0.25)), 1e-6);
    xyz[3 * (50 * GRID_U + 50)] = NAN;
    CHECK(isnan(metric_unevenness(&scene, xyz)));
    scene_clear(&scene);
}

static void test_penetration(void)
{
    static double xyz[COUNT];
    struct scene scene;
    struct scene_obstacle obstacle[2] = {
        {.kind = OBSTACLE_PLANE, .point = {5, 5, 0.25}, .normal = {0, 0, 3}},
        {.kind = OBSTACLE_SPHERE, .point = {0.5, 0.5, 0}, .radius = 0.4},
    };

    REQUIRE(scene_init(&scene) == STATUS_OK);
    scene.thickness = 0.01;
    fill_rest(&scene, xyz);
    CHECK(metric_penetration(&scene, 0, xyz) == 0);
    scene.obstacles = obstacle;
    scene.obstacle_count = 1;
    CHECK_NEAR(metric_penetration(&scene, 0, xyz), 0.255, TOL_ROUND); /* the lower layer */
    /* a ceiling: the upper layer alone is in it; and by less than the thickness */
    obstacle[0] = (struct scene_obstacle){
        .kind = OBSTACLE_PLANE, .point = {5, 5, 0.002}, .normal = {0, 0, -2}};
    CHECK_NEAR(metric_penetration(&scene, 0, xyz), 0.003, TOL_ROUND);
    obstacle[0].normal[2] = 2, obstacle[0].point[2] = -0.002; /* a floor: the lower */
    CHECK_NEAR(metric_penetration(&scene, 0, xyz), 0.003, TOL_ROUND);
    obstacle[0].point[2] = -1;
    CHECK(metric_penetration(&scene, 0, xyz) == 0);
    /* nearest grid points to the centre: half a step off in u and v, h/2 in w */
    scene.obstacle_count = 2;
    double off = 0.5 / 99;
    CHECK_NEAR(metric_penetration(&scene, 0, xyz),
               0.4 - sqrt(2 * off * off + 0.005 * 0.005), TOL_ROUND);
    xyz[100] = NAN;
    CHECK(isnan(metric_penetration(&scene, 0, xyz)));
    scene.obstacles = NULL; /* the array is ours */
    scene.obstacle_count = 0;
    scene_clear(&scene);
}

static void test_blowup(void)
{
    static double xyz[COUNT];
    struct scene scene;
    struct scene_support edge = {.lo = {0, 0, 0}, .hi = {0, 1, 1}, .fix = FIX_XYZ};

    init_tilted(&scene);
    fill_rest(&scene, xyz);
    CHECK(metric_blowup(&scene, 0, xyz) == STATUS_OK);
    int last = 3 * (GRID_POINTS - 1);
    xyz[last + 1] += 10.01 * scene.length;
    CHECK(metric_blowup(&scene, 0, xyz) == STATUS_ESCAPED);
    xyz[last + 1] -= 0.02 * scene.length;
    CHECK(metric_blowup(&scene, 0, xyz) == STATUS_OK);

    /* from the edge u = 0 the corner (1,1,1) is L farther: sqrt(1 + 9.96^2) > 10 */
    xyz[last + 1] -= 0.03 * scene.length;
    CHECK(metric_blowup(&scene, 0, xyz) == STATUS_OK);
    REQUIRE(scene_add_support(&scene, &edge) == STATUS_OK);
    CHECK(metric_blowup(&scene, 0, xyz) == STATUS_ESCAPED);
    xyz[last + 1] -= 0.06 * scene.length; /* sqrt(1 + 9.90^2) < 10 */
    CHECK(metric_blowup(&scene, 0, xyz) == STATUS_OK);
    xyz[last] = NAN;
    CHECK(metric_blowup(&scene, 0, xyz) == STATUS_NAN);
    xyz[last] = INFINITY;
    CHECK(metric_blowup(&scene, 0, xyz) == STATUS_NAN);
    scene_clear(&scene);
}

static void test_angle(void)
{
    static double xyz[COUNT];
    double degree = atan(1) / 45;
    struct scene scene;

    REQUIRE(scene_init(&scene) == STATUS_OK);
    memcpy(scene.gravity, (double[]){0, 0, -9.81}, sizeof scene.gravity);
    for (int turn = -60; turn <= 150; turn += 30) {
        double c = cos(turn * degree), s = sin(turn * degree);
        double down[3][3] = {{c, 0, s}, {0, 1, 0}, {-s, 0, c}};
        fill_rest(&scene, xyz);
        map_affine(xyz, down, (double[]){0, 0, 0});
        CHECK_NEAR(metric_angle(&scene, xyz), turn, 180 * TOL_ROUND);
    }
    xyz[3 * (49 * GRID_U)] = NAN;
    CHECK(isnan(metric_angle(&scene, xyz)));
    scene_clear(&scene);
}

int main(void)
{
    test_rmse();
    test_rmse_beside();
    test_stretch();
    test_spread_and_turn();
    test_drop();
    test_roughness();
    test_unevenness();
    test_penetration();
    test_blowup();
    test_angle();
    return check_result();
}
