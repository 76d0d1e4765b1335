/* What ensembles add to metrics: the mean drop; waves of known length and height. */
#include "models/metric/waves.h"

#include <float.h>
#include <stdlib.h>

#include "models/grid.h"
#include "models/metric/metric.h"
#include "tests/check.h"

/* A few operations on numbers of size 1, each a rounding off. */
#define TOL_ROUND (16 * DBL_EPSILON)
/* 60000 squares summed by rows: 300 + 200 roundings at most, far fewer on average. */
#define TOL_RMSE (500 * DBL_EPSILON)
/* A second difference loses 4 eps/s^2 on coordinates of size 1; s = 0.7/99, 0.35/99. */
#define TOL_ROUGHNESS (8 * DBL_EPSILON * (99 / 0.35) * (99 / 0.35))

enum { COUNT = GRID_POINTS * 3 };

static double *new_field(void)
{
    double *xyz = malloc(COUNT * sizeof *xyz);
    REQUIRE(xyz);
    return xyz;
}

static void fill_rest(const struct scene *scene, double *xyz)
{
    for (int n = 0; n < GRID_POINTS; n++) {
        double uvw[3];
        grid_point(n, uvw);
        scene_rest_point(scene, uvw, xyz + 3 * n);
    }
}

/* A sheet 0.7 m x 0.35 m x 2 cm in a tilted pose. */
static void init_tilted(struct scene *scene)
{
    REQUIRE(scene_init(scene) == STATUS_OK);
    scene->length = 0.7, scene->width = 0.35, scene->thickness = 0.02;
    memcpy(scene->axis_u, (double[]){0.6, 0.0, 0.8}, sizeof scene->axis_u);
    memcpy(scene->axis_v, (double[]){0.0, 1.0, 0.0}, sizeof scene->axis_v);
    memcpy(scene->origin, (double[]){0.1, -0.2, 0.3}, sizeof scene->origin);
    memcpy(scene->gravity, (double[]){0, 0, -9.81}, sizeof scene->gravity);
}

/* x -> A x + b for every point. */
static void map_affine(double *xyz, const double A[3][3], const double b[3])
{
    for (int n = 0; n < GRID_POINTS; n++) {
        double x[3] = {xyz[3 * n], xyz[3 * n + 1], xyz[3 * n + 2]};
        for (int i = 0; i < 3; i++)
            xyz[3 * n + i] = A[i][0] * x[0] + A[i][1] * x[1] + A[i][2] * x[2] + b[i];
    }
}

/* The mean of what goes down is told whatever else moves. */
static void test_mean_drop(void)
{
    static const double turned[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    double *xyz = new_field();
    struct scene scene;

    init_tilted(&scene);
    fill_rest(&scene, xyz);
    CHECK_NEAR(metric_mean_drop(&scene, xyz), 0, TOL_ROUND);
    map_affine(xyz, turned, (double[]){0.3, -0.2, -0.07});
    for (int n = 0; n < COUNT / 2; n += 3) /* half of the points 0.14 lower, one layer's  */
        xyz[n + 2] -= 0.14;
    CHECK_NEAR(metric_mean_drop(&scene, xyz), 0.2, TOL_RMSE);
    xyz[5] = NAN;
    CHECK(isnan(metric_mean_drop(&scene, xyz)));
    scene_clear(&scene);
    free(xyz);
}

/* A sum of cosines that the inner points' own differences keep, of heights in metres along
 * a direction; k and l halves over the sheet. */
struct wave {
    int k, l, band;
    double height, along[3];
};

static void add_wave(const struct wave *w, double *xyz)
{
    const double pi = 3.14159265358979323846;

    for (int n = 0; n < GRID_POINTS; n++) {
        const int i = n % GRID_U, j = n / GRID_U % GRID_V;
        const double by = w->height * cos(pi * w->k * (i - 0.5) / (GRID_U - 2)) *
                          cos(pi * w->l * (j - 0.5) / (GRID_V - 2));
        for (int c = 0; c < 3; c++)
            xyz[3 * n + c] += by * w->along[c];
    }
}

/* Waves of length 2 L / k, in a sheet 0.7 m x 0.35 m, land in their octave with their
 * height, one by one and together (Parseval), however the sheet is turned and stretched.
 * Of an edge of this sheet's inner points 98/99 are left. */
static void test_waves(void)
{
    static const double affine[3][3] = {{0, -1, 0}, {0, 0, 1.2}, {-1, 0, 0}};
    static const struct wave wave[] = {
        {1, 0, 0, 0.02, {0.8, 0, -0.6}}, {2, 0, 1, 0.01, {0, 1, 0}},
        {0, 2, 2, 0.01, {0, 0, 1}},      {0, 1, 1, 0.02, {1, 0, 0}},
        {10, 0, 3, 0.003, {0, 0, 1}},    {6, 5, 3, 0.004, {0, 0, 1}},
        {20, 0, 4, 0.001, {0, 1, 0}},    {40, 30, 5, 0.0005, {0, 0, 1}}};
    enum { WAVES = sizeof wave / sizeof *wave };
    double *xyz = new_field(), rms[WAVES_BANDS], all[WAVES_BANDS] = {0};
    struct scene scene;

    init_tilted(&scene);
    fill_rest(&scene, xyz);
    waves_spectrum(&scene, xyz, rms);
    for (int b = 0; b < WAVES_BANDS; b++)
        CHECK_NEAR(rms[b], 0, TOL_ROUGHNESS);
    for (int n = 0; n < WAVES; n++) {
        const double part = wave[n].k && wave[n].l ? 4 : 2;
        const double square = wave[n].height * wave[n].height / part / (0.7 * 0.7);
        fill_rest(&scene, xyz);
        map_affine(xyz, affine, (double[]){3, 2, 1});
        add_wave(&wave[n], xyz);
        waves_spectrum(&scene, xyz, rms);
        for (int b = 0; b < WAVES_BANDS; b++)
            CHECK_NEAR(rms[b], b == wave[n].band ? sqrt(square) : 0, TOL_ROUGHNESS);
        all[wave[n].band] += square;
    }
    fill_rest(&scene, xyz);
    for (int n = 0; n < WAVES; n++)
        add_wave(&wave[n], xyz);
    waves_spectrum(&scene, xyz, rms);
    for (int b = 0; b < WAVES_BANDS; b++)
        CHECK_NEAR(rms[b], sqrt(all[b]), TOL_ROUGHNESS);
    xyz[3 * (50 * GRID_U + 50)] = NAN;
    waves_spectrum(&scene, xyz, rms);
    CHECK(isnan(rms[0]));
    scene_clear(&scene);
    free(xyz);
}

int main(void)
{
    test_mean_drop();
    test_waves();
    return check_result();
}
