/* Locking of a square cantilever under its own weight: tip against Kirchhoff for every
 * space of the design's table, as this harness must be able to show it.
 *
 *   locking iga|hex
 */
#include "tests/plate_fixture.h"

/* Middle of the free edge of a Kirchhoff plate, nu = 0.3: w D / (q L^4), as in
 * tests/reference and tests/kirchhoff.c. */
static const double KIRCHHOFF_TIP = 0.129074;

/* What the table must be met to; or half a unit of its last digit, if that is more. */
static const double TOL_TABLE = 0.01;

struct row {
    const struct model *model;
    int degree[3], points[3];
    enum remedy remedy;
    double tip[3]; /* over Kirchhoff, at the thicknesses below                         */
    double unit;   /* of the last digit of the first column                            */
};

static const double thickness[3] = {1e-3, 5e-3, 20e-3}; /* [m], of 1 m                 */

/* clang-format off */
static const struct row rows[] = {
    {&plate_model, {2, 2, 1}, {10, 10, 2}, REMEDY_NONE, {0.605, 0.749, 0.834}, 1e-3},
    {&plate_model, {2, 2, 1}, {20, 20, 2}, REMEDY_NONE, {0.753, 0.838, 0.847}, 1e-3},
    {&plate_model, {3, 3, 1}, {10, 10, 2}, REMEDY_NONE, {0.832, 0.842, 0.846}, 1e-3},
    {&plate_model, {3, 3, 2}, {10, 10, 3}, REMEDY_NONE, {0.981, 0.986, 0.989}, 1e-3},
    {&hex_model, {1, 1, 1}, {10, 10, 2}, REMEDY_NONE, {0.0002, 0.0056, 0.081}, 1e-4},
    {&hex_model, {1, 1, 1}, {32, 32, 2}, REMEDY_NONE, {0.00265, 0.061, 0.465}, 1e-5},
    {&hex_model, {1, 1, 1}, {32, 32, 2}, REMEDY_INCOMPATIBLE, {0.989, 0.999, 1.001}, 1e-3},
};
/* clang-format on */

static void check_row(const struct row *row)
{
    struct discretization d = plate_degrees(row->degree[0], row->degree[1], row->degree[2],
                                            row->points[0], row->points[1], row->points[2]);

    d.remedy = row->remedy;
    for (int n = 0; n < 3; n++) {
        struct scene scene;
        plate_scene(&scene, thickness[n], 0.3);
        plate_hold(&scene, 0, 0, FIX_XYZ);
        scene.gravity[2] = -1e-3;
        double load = -scene.density * scene.gravity[2] * thickness[n];
        double sag = plate_sag(row->model, &scene, &d, 1, 0.5);
        double tip = sag * scene_bending_stiffness(&scene) / load / KIRCHHOFF_TIP;
        double tolerance = fmax(TOL_TABLE * row->tip[n], row->unit / 2);
        CHECK_NEAR(tip, row->tip[n], tolerance);
        scene_clear(&scene);
    }
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++)
        if (!strcmp(rows[n].model->name, argv[1]))
            check_row(&rows[n]);
    return check_result();
}
