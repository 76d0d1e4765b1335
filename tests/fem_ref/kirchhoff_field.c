/* The Kirchhoff truth on the material grid: where points go, and which scenes it refuses.
 */
#include "fem_ref/kirchhoff.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "tests/check.h"

/* Positions of order 1 m; a few operations. */
#define TOL_POSITION 1e-13

enum { TERMS = 16 };
static double field[GRID_POINTS][3], still[GRID_POINTS][3];

static const struct scene_support edge = {.hi = {0, 1, 1}, .fix = FIX_XYZ};

/* A sheet in a vertical plane, gravity along its normal, so that axes cannot be mixed up.
 */
static void make_scene(struct scene *s)
{
    REQUIRE(!scene_init(s));
    s->length = 2, s->width = 0.8, s->thickness = 0.01;
    s->young = 1e6, s->poisson = 0.3, s->density = 40;
    const double origin[3] = {1, 2, 3}, u[3] = {0, 1, 0}, v[3] = {0, 0, 1}; /* w = x */
    memcpy(s->origin, origin, sizeof origin);
    memcpy(s->axis_u, u, sizeof u);
    memcpy(s->axis_v, v, sizeof v);
    const double gravity[3] = {-9.81, 0, 0};
    memcpy(s->gravity, gravity, sizeof gravity);
    s->damping.kind = DAMPING_MASS, s->damping.value = 0.7;
    REQUIRE(!scene_add_support(s, &edge));
}

static void check_positions(const struct scene *s, const struct kirchhoff *k, double t)
{
    const double q = -9.81 * s->thickness * s->density;
    const int some[][2] = {{0, 0}, {99, 0}, {99, 99}, {40, 73}};

    REQUIRE(!kirchhoff_field(s, TERMS, 1, &t, (double *[]){field[0]}, NULL));
    for (int n = 0; n < 4; n++) {
        int i = some[n][0], j = some[n][1];
        double x = 2 * i / 99.0, y = 0.8 * j / 99.0;
        const double *low = field[j * GRID_U + i], *high = field[GRID_U * (GRID_V + j) + i];
        double w = isinf(t) ? kirchhoff_static(k, q, x, y)
                            : kirchhoff_transient(k, q, 0.7, t, x, y);
        CHECK_NEAR((low[0] + high[0]) / 2, 1 + w, TOL_POSITION);
        CHECK_NEAR((low[1] + high[1]) / 2, 2 + x, TOL_POSITION);
        CHECK_NEAR((low[2] + high[2]) / 2, 3 + y, TOL_POSITION);
        CHECK_NEAR(high[0] - low[0], 0.01, TOL_POSITION);
    }
    /* Slopes from differences of the deflection over a grid step d: relative error
     * (d / l)^2 / 6; across the plate w bends within l = W / 20 of the free edge. */
    const double TOL_SLOPE = 400.0 / (99 * 99) / 6;
    for (int c = 1; c < 3; c++) {
        int step = c == 1 ? 1 : GRID_U, at = 20 * GRID_U + 60;
        double length = c == 1 ? 2 : 0.8;
        double slope = (field[at + step][0] - field[at - step][0]) / (2 * length / 99);
        double lean = field[at + GRID_U * GRID_V][c] - field[at][c];
        CHECK(fabs(slope) > 1e-4);
        CHECK_RELATIVE(lean, -0.01 * slope, TOL_SLOPE);
    }
}

static void check_field(void)
{
    struct scene s = {0};
    struct kirchhoff_plate plate;
    struct kirchhoff *k = NULL;

    make_scene(&s);
    REQUIRE(!kirchhoff_field_plate(&s, &plate, NULL));
    CHECK(plate.length == 2 && plate.width == 0.8 && plate.thickness == 0.01);
    CHECK(plate.young == 1e6 && plate.poisson == 0.3 && plate.density == 40);
    REQUIRE(!kirchhoff_create(&plate, TERMS, &k));
    check_positions(&s, k, 0.4);
    check_positions(&s, k, INFINITY);
    REQUIRE(!kirchhoff_field(&s, TERMS, 1, (double[]){0}, (double *[]){still[0]}, NULL));
    double rest = 0;
    for (int n = 0; n < GRID_POINTS; n++) {
        double uvw[3], x[3];
        grid_point(n, uvw);
        scene_rest_point(&s, uvw, x);
        for (int c = 0; c < 3; c++)
            rest = fmax(rest, fabs(still[n][c] - x[c]));
    }
    CHECK_NEAR(rest, 0, TOL_POSITION); /* starts from rest */
    CHECK(metric_rmse(field[0], still[0]) > 0.01);
    kirchhoff_destroy(k);
    scene_clear(&s);
}

static void check_refusals(void)
{
    struct kirchhoff_plate plate;
    struct message why;
    struct scene s;
#define REFUSED(change, word)                                                              \
    do {                                                                                   \
        make_scene(&s);                                                                    \
        change;                                                                            \
        why.text[0] = 0;                                                                   \
        CHECK(kirchhoff_field_plate(&s, &plate, &why) == STATUS_UNSUPPORTED);              \
        CHECK(strstr(why.text, word));                                                     \
        scene_clear(&s);                                                                   \
    } while (0)
    REFUSED(s.supports[0].hi[1] = 0.5, "support");
    REFUSED(s.supports[0].hi[0] = 0.1, "support");
    REFUSED(s.supports[0].hi[2] = 0, "support");
    REFUSED(s.supports[0].fix = FIX_X, "support");
    REFUSED(CHECK(!scene_add_support(&s, &edge)), "support");
    REFUSED(s.gravity[1] = 0.1, "gravity");
    REFUSED(s.gravity[2] = -9.81, "gravity");
    REFUSED(s.drag = 1, "drag");
    REFUSED(s.velocity[2] = 1, "rest");
    REFUSED(s.spin[0] = 1, "rest");
    REFUSED(s.damping.kind = DAMPING_VELOCITY_SCALE, "damping");
    REFUSED(s.poisson = -0.2, "nu");
    REFUSED((s.shape = SCENE_CLOAK, s.opening = 90), "flat");
}

int main(void)
{
    check_field();
    check_refusals();
    return check_result();
}
