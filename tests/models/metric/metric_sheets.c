/* Metrics of several sheets: those of each, wherever they lie; nothing between two counts.
 */
#include "models/metric/metric.h"

#include "tests/metric_fixture.h"

enum { SHEETS = 3 };

/* A difference of coordinates of size 10 over a step of 0.7 m / 32, and its square. */
#define TOL_STRETCH (64 * DBL_EPSILON * 33 / 0.7)
#define TOL_BENDING (64 * DBL_EPSILON * (33 / 0.7) * (33 / 0.7) * (33 / 0.7))

/* Three sheets; `apart`: some metres from each other, and each turned otherwise. */
static void init_sheets(struct scene *scene, bool apart)
{
    static const struct scene_pose pose[SHEETS] = {
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
        {{3, -8, 1}, {0, 0.6, 0.8}, {-1, 0, 0}},
        {{-5, 4, 2}, {-1, 0, 0}, {0, 0, 1}},
    };

    init_tilted(scene);
    scene->sheets = SHEETS;
    for (int k = 0; k < SHEETS; k++)
        scene->pose[k] = pose[apart ? k : 0];
}

/* Bends each sheet to a cylinder of radius R along s, from its edge s = 0 on. */
static void roll(const struct scene *scene, double R, double *xyz)
{
    for (int n = 0; n < GRID_POINTS; n++) {
        double uvw[3], s, w[3];
        grid_point(n, uvw);
        const struct scene_pose *p = &scene->pose[scene_sheet_at(scene, uvw[0], &s)];
        const double turn = s * scene->length / R, out = R * sin(turn),
                     up = R * (1 - cos(turn));
        w[0] = p->axis_u[1] * p->axis_v[2] - p->axis_u[2] * p->axis_v[1];
        w[1] = p->axis_u[2] * p->axis_v[0] - p->axis_u[0] * p->axis_v[2];
        w[2] = p->axis_u[0] * p->axis_v[1] - p->axis_u[1] * p->axis_v[0];
        for (int c = 0; c < 3; c++)
            xyz[3 * n + c] = p->origin[c] + out * p->axis_u[c] + up * w[c] +
                             uvw[1] * scene->width * p->axis_v[c];
    }
}

enum { NUMBERS = 4 };
static void measure(const struct scene *scene, const double *xyz, double number[NUMBERS])
{
    number[0] = metric_stretch(scene, xyz);
    number[1] = metric_roughness(scene, xyz);
    number[2] = metric_inner_roughness(scene, xyz);
    number[3] = metric_unevenness(scene, xyz);
}

/* What bends and stretches doesn't depend on where sheets are; cylinders have L / R. */
static void places_do_not_count(void)
{
    const double R = 0.2;
    static double xyz[COUNT];
    double here[NUMBERS], there[NUMBERS];
    struct scene scene;

    init_sheets(&scene, false);
    roll(&scene, R, xyz);
    measure(&scene, xyz, here);
    scene_clear(&scene);
    init_sheets(&scene, true);
    roll(&scene, R, xyz);
    measure(&scene, xyz, there);
    const double turn = scene.length / 32 / R, chord = 2 * sin(turn / 2) / turn;
    CHECK_NEAR(there[0], 1, 1 - sin(turn) / turn); /* chords of one step or two */
    for (int n = 1; n < 4; n++)
        CHECK_RELATIVE(there[n], scene.length / R, 1.1 * (1 - chord * chord * chord));
    for (int n = 0; n < NUMBERS; n++)
        CHECK_NEAR(there[n], here[n], TOL_BENDING);
    fill_rest(&scene, xyz);
    measure(&scene, xyz, there);
    CHECK_NEAR(there[0], 1, TOL_STRETCH);
    for (int n = 1; n < NUMBERS; n++)
        CHECK(n == 3 || there[n] < TOL_BENDING); /* unevenness divides by nothing */
    for (int n = 0; n < GRID_POINTS; n++) /* the last sheet's u runs along -x from -5 */
        xyz[3 * n] += n % GRID_U > 65 ? 0.5 * (xyz[3 * n] + 5) : 0;
    CHECK_NEAR(metric_stretch(&scene, xyz), 1.5, TOL_STRETCH);
    scene_clear(&scene);
}

/* Highest, lowest, and what is held, of all sheets; the angle of the first. */
static void heights(void)
{
    const struct scene_support held = {
        .lo = {33 / 99., 0, 0}, .hi = {33 / 99., 1, 1}, .fix = FIX_XYZ};
    static double xyz[COUNT];
    struct scene scene;

    init_sheets(&scene, true);
    fill_rest(&scene, xyz);
    /* the top of the second at 1 + 0.8 * 0.7, the third's at 2 + 0.35; the first is flat */
    CHECK_NEAR(metric_drop(&scene, xyz), 2.35 / 0.7, 1e-12);
    CHECK_NEAR(metric_angle(&scene, xyz), 0, 1e-10);
    CHECK(metric_blowup(&scene, 0, xyz) == STATUS_OK);
    REQUIRE(scene_add_support(&scene, &held) == STATUS_OK); /* the second's edge s = 0 */
    CHECK_NEAR(metric_drop(&scene, xyz), 1 / 0.7, 1e-12);
    scene_clear(&scene);
}

/* A sheet is lost when it is far from its own place, though it is near another's; without
 * gravity none is carried. */
static void each_has_its_place(void)
{
    static double xyz[COUNT];
    struct scene scene;

    init_sheets(&scene, true);
    memset(scene.gravity, 0, sizeof scene.gravity);
    fill_rest(&scene, xyz);
    for (int n = 0; n < GRID_POINTS; n++)
        if (grid_sheet(SHEETS, n % GRID_U) == 1) /* 12.2 m away, beside the third */
            xyz[3 * n] -= 7, xyz[3 * n + 1] += 10;
    CHECK(metric_blowup(&scene, 0, xyz) == STATUS_ESCAPED);
    scene_clear(&scene);
}

int main(void)
{
    places_do_not_count();
    heights();
    each_has_its_place();
    return check_result();
}
