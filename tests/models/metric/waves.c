/* The metrics of ensembles: the mean drop; waves of known length and height. */
#include "models/metric/waves.h"

#include "models/metric/metric.h"
#include "tests/metric_fixture.h"

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
