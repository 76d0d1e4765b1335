/* Depths of sheets that pass through themselves, known by construction; and sheets that
 * touch themselves, which do not pass through. */
#include "models/metric/crossing.h"

#include "models/grid.h"
#include "tests/check.h"
#include "tests/noise.h"

enum { N = 41, POINTS = N * N };
static double xyz[POINTS][3];

/* Points are moved by so much before they are counted [m]. */
#define SHAKEN CROSSING_SHAKE

/* Fills the grid with a profile (x, z) of u, extruded along y = v. */
static void extrude(void (*profile)(double u, double v, double *x, double *z))
{
    for (int n = 0; n < POINTS; n++) {
        const double u = n % N / (N - 1.), v = n / N / (N - 1.);
        profile(u, v, &xyz[n][0], &xyz[n][2]);
        xyz[n][1] = v;
    }
}

static double deep, tilt; /* of the flap's end [m], along v                             */

/* A sheet from x = 0 to 1 at z = 0, and back above it to x = .312, where its end is `deep`
 * below at v = 1, and `tilt` less at v = 0. */
static void flap(double u, double v, double *x, double *z)
{
    const double top = .3141, end = -deep + tilt * (1 - v);

    *x = u < .5 ? 2 * u : u < .6 ? 1 : 1 - 1.72 * (u - .6);
    *z = u < .5 ? 0 : u < .6 ? 10 * top * (u - .5) : top + (end - top) * (u - .6) / .4;
}

/* Folds it in half, without a gap. */
static void doubled(double u, double v, double *x, double *z)
{
    (void)v;
    *x = u < .5 ? u : 1 - u, *z = 0;
}

/* Folds it back over itself, with a ridge of the upper side that touches the lower one. */
static void ridged(double u, double v, double *x, double *z)
{
    (void)v;
    *x = u < .5 ? 2 * u : u < .6 ? 1 : 1 - 1.72 * (u - .6);
    *z = u < .5 ? 0 : u < .6 ? u - .5 : fabs(u - .8) / 2;
}

/* A square tube, closed along the seam u = 0, 1. */
static void tube(double u, double v, double *x, double *z)
{
    const double s = 4 * u - (int)(4 * u);
    const int side = (int)(4 * u) % 4;

    (void)v;
    *x = side == 0 ? s : side == 1 ? 1 : side == 2 ? 1 - s : 0;
    *z = side == 0 ? 0 : side == 1 ? s : side == 2 ? 1 : 1 - s;
}

static void heap(double u, double v, double *x, double *z)
{
    (void)u, (void)v;
    *x = *z = 0;
}

/* Counts and measures; a sheet that does not touch itself has no pair. */
static struct crossing measure(double tolerance, bool touches)
{
    struct intersection work = {.keep_pairs = true, .most = 1 << 18};
    struct crossing found;
    long pairs, shaken;

    CHECK(intersection_count(&work, N, N, xyz[0], &pairs) == STATUS_OK);
    CHECK((pairs > 0) == touches);
    work.shake = CROSSING_SHAKE;
    CHECK(intersection_count(&work, N, N, xyz[0], &shaken) == STATUS_OK);
    CHECK(crossing_measure(&work, tolerance, &found) == STATUS_OK);
    CHECK(found.pairs <= shaken && found.triangles <= 2 * found.pairs);
    intersection_clear(&work);
    return found;
}

/* The end of a flap comes through the sheet by a known way, all of it or one corner; up to
 * the tolerance it only touches. However the sheet is turned, but for what rounding parts.
 */
static void comes_through(void)
{
    static const struct {
        double deep, tilt, tolerance;
        bool meets, passes;
    } row[] = {{.1, 0, 1e-6, true, true},      {.01, 0, 1e-6, true, true},
               {.1, .15, 1e-6, true, true},    {1e-5, 0, 1e-6, true, true},
               {1e-5, 0, 1.1e-5, true, false}, {0, 0, 1e-6, true, false},
               {-.01, 0, 1e-6, false, false},  {1e-7, 0, 1e-6, true, false}};

    for (size_t k = 0; k < 2 * sizeof row / sizeof *row; k++) {
        const size_t n = k / 2;
        deep = row[n].deep, tilt = row[n].tilt;
        extrude(flap);
        for (int p = 0; k % 2 && deep != 0 && p < POINTS; p++) {
            const double x = xyz[p][0], z = xyz[p][2];
            xyz[p][0] = 10 + .6 * x - .8 * z, xyz[p][2] = .8 * x + .6 * z;
        }
        const struct crossing c = measure(row[n].tolerance, row[n].meets);
        CHECK((c.pairs > 0) == row[n].passes && (c.triangles > 0) == row[n].passes);
        CHECK_NEAR(c.depth, row[n].passes ? deep : 0, SHAKEN);
    }
}

/* Flaps that come through by 0.1 mm to 10 cm, askew and beyond the rim: each is found, and
 * but for one in a hundred its depth is right to a factor of two. */
static void random_flaps(void)
{
    enum { FLAPS = 100 };
    int off = 0;

    for (int k = 0; k < FLAPS; k++) {
        deep = pow(10, -4 + 3 * noise_unit());
        tilt = k % 2 ? 0 : .15 * noise_unit();
        extrude(flap);
        const double aside = k % 3 ? .05 * noise_unit() : 0;
        for (int n = 0; n < POINTS; n++)
            xyz[n][1] += n % N > .55 * N ? aside * (n % N / (N - 1.) - .55) : 0;
        const bool meets = !tilt || aside * .45 < deep / tilt; /* else it is beside it */
        const struct crossing c = measure(1e-6, meets);
        off += meets && !(c.depth > deep / 2 && c.depth < deep * 2);
        CHECK((c.pairs > 0) == meets);
    }
    CHECK_SAY(off <= FLAPS / 100, "%d of %d depths are off", off, FLAPS);
}

static void touches(void)
{
    void (*const shape[])(double, double, double *, double *) = {doubled, ridged, tube,
                                                                 heap};
    for (size_t n = 0; n < sizeof shape / sizeof *shape; n++) {
        extrude(shape[n]);
        const struct crossing c = measure(1e-6, true);
        CHECK_SAY(c.pairs == 0 && c.triangles == 0 && c.depth == 0,
                  "shape %zu: %ld pairs, %g m", n, c.pairs, c.depth);
    }
}

/* Two squares slit into each other: every edge that passes through ends .05 to both sides
 * at least. */
static void slit(void)
{
    enum { SIDE = 11, SQUARE = SIDE * SIDE, CELLS = 2 * (SIDE - 1) * (SIDE - 1) };
    static double x[2 * SQUARE][3];
    static int corner[2 * CELLS][3];
    struct intersection work = {.keep_pairs = true, .shake = CROSSING_SHAKE};
    struct crossing found;
    long pairs;

    for (int n = 0; n < SQUARE; n++) {
        const double s = n % SIDE / 10., t = n / SIDE / 10.;
        memcpy(x[n], (double[]){s, t, 0}, sizeof *x);
        memcpy(x[n + SQUARE], (double[]){.55, t + .53, s - .45}, sizeof *x);
    }
    for (int n = 0; n < CELLS; n++) {
        intersection_corners(SIDE, n, corner[n]);
        for (int k = 0; k < 3; k++)
            corner[n + CELLS][k] = corner[n][k] + SQUARE;
    }
    REQUIRE(intersection_count_mesh(&work, 2 * SQUARE, x[0], 2 * CELLS, corner, &pairs) ==
            STATUS_OK);
    REQUIRE(crossing_measure(&work, 1e-6, &found) == STATUS_OK);
    CHECK(pairs > 0 && found.pairs == pairs);
    CHECK(found.depth >= .05);
    x[7][1] = NAN;
    CHECK(intersection_count_mesh(&work, 2 * SQUARE, x[0], 2 * CELLS, corner, &pairs) ==
              STATUS_NAN &&
          pairs == -1);
    intersection_clear(&work);
}

enum { SHEETS = 3 };
static double field[GRID_POINTS][3];

/* Fills a field with sheets from x = 0 to 1, v along y, sheet k at z[k][0] where x = 0 and
 * z[k][1] where x = 1. */
static void lay(const double z[SHEETS][2])
{
    for (int n = 0; n < GRID_POINTS; n++) {
        const int i = n % GRID_U, k = grid_sheet(SHEETS, i);
        int column[2];
        grid_columns(SHEETS, k, column);
        const double s = (double)(i - column[0]) / (column[1] - column[0]);
        memcpy(field[n],
               (double[]){s, n / GRID_U % GRID_V / 99., z[k][0] + s * (z[k][1] - z[k][0])},
               sizeof *field);
    }
}

/* Counts the pairs of the triangles that the field has, listed one by one, backwards; one
 * that is listed twice adds no pair with its copy. */
static long listed(int step)
{
    enum { CELLS = 2 * (GRID_U - 1) * (GRID_V - 1) };
    static int corner[CELLS + 1][3];
    static double middle[GRID_U * GRID_V][3];
    const int n_u = (GRID_U - 1) / step + 1, all = 2 * (n_u - 1) * (n_u - 1);
    struct intersection mesh = {.shake = CROSSING_SHAKE};
    int count = 0;
    long pairs;

    grid_middle(field[0], step, middle[0]);
    for (int n = all - 1; n >= 0; n--) {
        intersection_corners(n_u, n, corner[count]);
        const int from = step * (corner[count][0] % n_u), to = from + step;
        count += grid_sheet(SHEETS, from) == grid_sheet(SHEETS, to);
    }
    memcpy(corner[count], corner[count - 1], sizeof *corner); /* which meets nothing */
    REQUIRE(intersection_count_mesh(&mesh, n_u * n_u, middle[0], count + 1, corner,
                                    &pairs) == STATUS_OK);
    intersection_clear(&mesh);
    return pairs;
}

/* Between two sheets is nothing, which what passes there does not meet; a sheet that comes
 * through another one is found, with its depth. */
static void sheets(int step)
{
    static const struct {
        double z[SHEETS][2], depth;
    } row[] = {{{{0, 0}, {.1, .1}, {.05, .05}}, 0},
               {{{.05, .05}, {0, 0}, {.1, .1}}, 0},
               {{{0, 0}, {.2, .2}, {.1, -.02}}, .02},
               {{{0, 0}, {.03, -.1}, {.2, .2}}, .03}};

    for (size_t n = 0; n < sizeof row / sizeof *row; n++) {
        struct intersection work = {0};
        struct crossing found;
        long pairs;
        lay(row[n].z);
        REQUIRE(crossing_of_field(&work, SHEETS, step, field[0], 1e-6, &found) ==
                STATUS_OK);
        CHECK((found.depth > 0) == (row[n].depth > 0));
        if (step == 1) /* else the last columns of a sheet may be left out */
            CHECK_NEAR(found.depth, row[n].depth, SHAKEN);
        CHECK(found.pairs == listed(step));
        REQUIRE(intersection_count_field(&work, 1, step, field[0], &pairs) == STATUS_OK);
        CHECK(pairs > found.pairs); /* as one sheet it meets what is not there */
        intersection_clear(&work);
    }
}

int main(void)
{
    comes_through();
    random_flaps();
    touches();
    slit();
    sheets(1);
    sheets(3);
    return check_result();
}
