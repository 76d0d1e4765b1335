/* Frequencies of thin plates at degree 4 in plane and 2 through the thickness against the
 * Kirchhoff table, and the six zero frequencies of a free one. omega a^2 sqrt(rho h / D).
 */
#include "fem_ref/reference.h"
#include "tests/plate_fixture.h"

/* At h / a = 1/200 a solid is below Kirchhoff by what its free edges twist, about 0.05 h /
 * a = 3e-4 (measured on FFFF: 3.2e-4, and 5e-5 at h / a = 1/500), by shear and rotary
 * inertia, (h / a)^2 lambda / 10 = 1e-4; and above by what the net locks: the rest of 0.2
 * %. */
static const double TOL_FREQUENCY = 2e-3;
/* Zero frequencies of a free plate, of the first one: omega runs up to some 10 c / h, the
 * first is 4 c h / a^2, so that lambda's errors, 1e-15 of the largest, are 1e-5 of the
 * first: a root of 3e-3. */
static const double TOL_ZERO = 3e-3;

static const double THICKNESS = 5e-3;
enum { DEGREE = 4, MODES_MAX = 16 };

struct plate {
    const char *edges; /* u = 0, v = 0, u = 1, v = 1; as in the table                  */
    double nu, width;
    int modes, points[2];
    double grade; /* knots along u are those of a uniform net to this power            */
};

/* Knots drawn towards a clamp at u = 0, where the bending moment is largest. */
static void graded_knots(int n, double grade, double *U)
{
    int spans = n - DEGREE;

    for (int k = -DEGREE; k <= spans + DEGREE; k++) {
        double x = (double)k / spans;
        *U++ = x <= 0 ? 0 : x >= 1 ? 1 : pow(x, grade);
    }
}

static void hold_edges(const char *edges, struct scene *scene)
{
    for (int e = 0; e < 4; e++) {
        unsigned simple = e % 2 ? FIX_X | FIX_Z : FIX_Y | FIX_Z;
        if (edges[e] != 'F')
            plate_hold(scene, e % 2, e / 2, edges[e] == 'C' ? FIX_XYZ : simple);
    }
}

/* The first row of the table for this plate: mode 1. */
static int find_row(const struct reference *table, const struct plate *p)
{
    int row = reference_find(table, 0, "bc", p->edges);

    while (row >= 0 && !(reference_number(table, row, "nu") == p->nu &&
                         reference_number(table, row, "Ly") == p->width))
        row = reference_find(table, row + 1, "bc", p->edges);
    REQUIRE(row >= 0 && reference_number(table, row, "mode") == 1);
    return row;
}

static void check_plate(const struct reference *table, const struct plate *p)
{
    int row = find_row(table, p), zero = strcmp(p->edges, "FFFF") ? 0 : 6;
    double knots[64], omega[MODES_MAX];
    struct discretization d =
        plate_degrees(DEGREE, DEGREE, 2, p->points[0], p->points[1], 3);
    struct message why = {""};
    struct scene scene;
    void *state = NULL;

    graded_knots(p->points[0], p->grade, knots);
    d.knots[0] = knots;
    d.knot_count[0] = p->points[0] + DEGREE + 1;
    plate_scene(&scene, THICKNESS, p->nu);
    scene.width = p->width;
    hold_edges(p->edges, &scene);
    REQUIRE(plate_model.create(&scene, &d, &state, &why) == STATUS_OK);
    CHECK(plate_model.modes(state, zero + p->modes, omega, &why) == STATUS_OK);
    double unit = sqrt(scene_bending_stiffness(&scene) / (scene.density * THICKNESS));
    for (int n = 0; n < zero; n++)
        CHECK_NEAR(omega[n] / omega[zero], 0, TOL_ZERO);
    for (int n = 0; n < p->modes; n++) {
        double lambda = omega[zero + n] / unit;
        if (!CHECK_RELATIVE(lambda, reference_number(table, row + n, "lambda"),
                            TOL_FREQUENCY))
            printf("  %s, nu %g, mode %d\n", p->edges, p->nu, n + 1);
    }
    plate_model.destroy(state);
    scene_clear(&scene);
}

int main(void)
{
    static const struct plate plates[] = {
        {"CFFF", 0.3, 1, 5, {15, 11}, 2},    {"CFFF", 0, 1, 4, {15, 11}, 2},
        {"CFFF", 0.49, 0.5, 3, {16, 10}, 2}, {"SSSS", 0.3, 1, 4, {14, 14}, 1},
        {"FFFF", 0.3, 1, 7, {14, 14}, 1},
    };
    struct reference *table = NULL;

    REQUIRE(reference_open(REFERENCE_DIR "/leissa_plate_frequencies.csv", &table, NULL) ==
            STATUS_OK);
    for (size_t n = 0; n < sizeof plates / sizeof *plates; n++)
        check_plate(table, &plates[n]);
    reference_close(table);
    return check_result();
}
