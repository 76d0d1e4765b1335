/* The shell's supports: which control points are held; damping of small motions, linear and
 * nonlinear alike; a sheet that has no stiffness where its search for rest begins. */
#include "tests/shell_sheet.h"

/* Slopes of 1e-4 differ by their square between the kinematics, which then are one rule;
 * measured 2e-9. */
static const double SMALL_SWING = 1e-7;
/* Newton's tolerance, and the square of a strain of 1.5e-5. */
static const double HANGING = 1e-7;
static long unknowns(int d, double at, unsigned fix, bool clamped)
{
    struct sheet s;
    struct model_size size;

    sheet_init(&s, 2, 8, 8);
    sheet_hold(&s, d, at, fix, clamped);
    sheet_start(&s);
    shell_model.size(s.state, &size);
    sheet_clear(&s);
    return size.unknowns;
}

static void check_held(void)
{
    const struct scene_support corner = {.lo = {0, 1, 0}, .hi = {0, 1, 1}, .fix = FIX_XYZ};
    const struct scene_support half = {.lo = {1, 0, 0}, .hi = {1, 0.5, 1}, .fix = FIX_XYZ};
    struct model_size size;
    struct sheet s;

    for (int d = 0; d < 2; d++)
        for (int at = 0; at < 2; at++) {
            CHECK(unknowns(d, at, FIX_XYZ, true) == 300 - 60); /* clamped: two rows */
            CHECK(unknowns(d, at, FIX_XYZ, false) == 300 - 30);
            CHECK(unknowns(d, at, FIX_Y | FIX_Z, true) == 300 - 20);
        }
    sheet_init(&s, 2, 8, 8);
    REQUIRE(scene_add_support(&s.scene, &corner) == STATUS_OK);
    REQUIRE(scene_add_support(&s.scene, &half) == STATUS_OK);
    sheet_start(&s);
    shell_model.size(s.state, &size);
    CHECK(size.unknowns == 300 - 3 - 2 * 6 * 3); /* half an edge: four spans, two rows */
    sheet_clear(&s);
}

/* Tip of a cantilever after 40 steps under a load so small that slopes are 1e-3. */
static double small_tip(enum kinematics kinematics, struct scene_damping damping)
{
    struct sheet s;
    double by[3];

    sheet_init(&s, 3, 8, 2);
    s.d.kinematics = kinematics;
    s.scene.width = 0.2;
    s.scene.thickness = 0.02;
    s.scene.young = 1e6;
    s.scene.poisson = 0.3;
    s.scene.density = 100;
    s.scene.gravity[2] = -0.0025;
    s.scene.damping = damping;
    sheet_hold(&s, 0, 0, FIX_XYZ, true);
    sheet_start(&s);
    for (int n = 0; n < 40; n++)
        CHECK(shell_model.advance(s.state, &s.counters) == STATUS_OK);
    sheet_moved(&s, 1, 0.5, by);
    sheet_clear(&s);
    return by[2];
}

static void check_damping(void)
{
    static const struct scene_damping kind[] = {
        {.kind = DAMPING_NONE},
        {.kind = DAMPING_MASS, .value = 3},
        {.kind = DAMPING_RAYLEIGH, .alpha = 1, .beta = 0.02},
        {.kind = DAMPING_VELOCITY_SCALE, .value = 0.9},
        {.kind = DAMPING_VELOCITY_RATE, .value = 5},
    };
    double last = 0;

    for (size_t n = 0; n < sizeof kind / sizeof *kind; n++) {
        double linear = small_tip(KINEMATICS_LINEAR, kind[n]);
        double nonlinear = small_tip(KINEMATICS_NONLINEAR, kind[n]);
        CHECK(linear < -1e-5 && fabs(linear - last) > 1e-3 * fabs(linear)); /* it matters */
        CHECK_RELATIVE(nonlinear, linear, SMALL_SWING);
        last = linear;
    }
}

/* A strip hinged at u = 0, flat at rest, has no stiffness against falling: it ends up
 * hanging, longer by rho g L^2 / 2 E. */
static void check_hanging(void)
{
    struct sheet s;
    double by[3];

    sheet_init(&s, 2, 8, 2);
    s.scene.width = 0.3;
    s.scene.thickness = 1e-3;
    s.scene.young = 1e5;
    s.scene.density = 0.3;
    s.scene.gravity[2] = -9.81;
    sheet_hold(&s, 0, 0, FIX_XYZ, false);
    sheet_start(&s);
    sheet_settle(&s);
    sheet_moved(&s, 1, 0.5, by);
    double strain = s.scene.density * 9.81 / (2 * s.scene.young);
    CHECK_NEAR(by[0], -1, HANGING);
    CHECK_NEAR(by[2], -1 - strain, HANGING);
    sheet_clear(&s);
}

int main(void)
{
    check_held();
    check_damping();
    check_hanging();
    return check_result();
}
