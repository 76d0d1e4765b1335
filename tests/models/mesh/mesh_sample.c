/* Nets as surfaces: flat ones are the sheet, in place and thickness, as bilinear patches
 * and as B-splines; splines go through corners, and past points by their second
 * differences. */
#include "models/mesh/mesh.h"

#include "tests/check.h"

enum { N = 6, M = 4 };
static const double TOL = 1e-14; /* some roundings of numbers up to 1 */

static double x[N][M][3];
static struct scene scene;
static struct mesh mesh;

static void fill(double (*height)(double u, double v))
{
    for (int i = 0; i < N; i++)
        for (int j = 0; j < M; j++) {
            const double u = i / (N - 1.), v = j / (M - 1.);
            x[i][j][0] = u, x[i][j][1] = v, x[i][j][2] = height(u, v);
        }
}

static void at(int degree, double u, double v, double w, double xyz[3])
{
    const struct mesh_field field = {x[0][0], 3, 1, degree};
    const double uvw[3] = {u, v, w};

    mesh_sample(&mesh, &scene, &field, 1, uvw, xyz);
}

static double plane(double u, double v)
{
    return u / 4 + v / 2;
}

static double bumpy(double u, double v)
{
    return sin(7 * u) * cos(5 * v);
}

static void test_flat(void)
{
    static const double normal[3] = {-0.25, -0.5, 1};
    const double length = sqrt(1 + 0.25 * 0.25 + 0.5 * 0.5);
    double xyz[3];

    fill(plane);
    for (int degree = 0; degree <= 3; degree += degree ? 1 : 2)
        for (int k = 0; k <= 20; k++) {
            const double u = k / 20., v = 1 - u * u, off = 0.3 * scene.thickness;
            at(degree, u, v, 0.8, xyz);
            CHECK_NEAR(xyz[0], u + off * normal[0] / length, TOL);
            CHECK_NEAR(xyz[1], v + off * normal[1] / length, TOL);
            CHECK_NEAR(xyz[2], plane(u, v) + off / length, TOL);
        }
}

/* Compares splines at points, where they lie a share of the second differences off, and at
 * corners, where they do not. */
static void test_spline(void)
{
    static const double share[] = {[2] = 1. / 8, [3] = 1. / 6};
    double xyz[3];

    fill(bumpy);
    for (int degree = 2; degree <= 3; degree++) {
        for (int c = 0; c < 4; c++) {
            at(degree, c / 2, c % 2, 0.5, xyz);
            CHECK_NEAR(xyz[2], x[c / 2 * (N - 1)][c % 2 * (M - 1)][2], TOL);
        }
        for (int i = 1; i < N - 1; i++) {
            const double second = x[i - 1][0][2] - 2 * x[i][0][2] + x[i + 1][0][2];
            at(degree, i / (N - 1.), 0, 0.5, xyz);
            CHECK_NEAR(xyz[2], x[i][0][2] + share[degree] * second, TOL);
        }
    }
    /* between points: by the quadratic's three pieces */
    at(2, 1.75 / (N - 1), 0, 0.5, xyz);
    CHECK_NEAR(xyz[2], (9 * x[1][0][2] + 22 * x[2][0][2] + x[3][0][2]) / 32, TOL);
}

int main(void)
{
    REQUIRE(scene_init(&scene) == STATUS_OK);
    scene.length = scene.width = 1, scene.thickness = 0.1;
    REQUIRE(mesh_init(&mesh, &scene, (int[]){N, M}) == STATUS_OK);
    test_flat();
    test_spline();
    mesh_clear(&mesh);
    scene_clear(&scene);
    return check_result();
}
