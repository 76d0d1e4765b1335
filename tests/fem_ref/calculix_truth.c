/* CalculiX's answers that are stored in tests/reference/calculix_*.csv, where `verify
 * outside` has no model for them: a distorted element, another element's tips, the swing of
 * an elastica computed elsewhere. (fem_ref/calculix/decks: what was asked of it.) */
#include "fem_ref/reference.h"
#include "tests/opened_run.h"
#include "tests/solid_fixture.h"

/* A part of the largest entry. 14 digits are written; ours and theirs round a dozen times
 * each. */
static const double TOL_MATRIX = 1e-12;

/* Cubics, and reduced quadratics at spans of L / 20 (measured 2e-3). */
static const double TOL_TIP = 4e-3;

/* The distance allowed of answers that share nothing [L]. */
static const double TOL_SWING = 1e-3;

/* Moves a node as the deck does: no angle stays right. */
static void distort(double x[3])
{
    x[0] += 0.25 * x[1] * x[2] + 0.125 * x[1];
    x[1] += 0.125 * x[0] - 0.25 * x[2];
    x[2] += 0.25 * x[0] * x[1];
}

static struct reference *open_stored(const char *name)
{
    char path[512];
    struct reference *table = NULL;

    snprintf(path, sizeof path, REFERENCE_DIR "/%s.csv", name);
    REQUIRE(reference_open(path, &table, NULL) == STATUS_OK);
    return table;
}

/* Dense [rows][rows], both triangles, of a column of the stored table. */
static double *stored_matrix(const struct reference *table, const char *column, int rows)
{
    double *A = calloc((size_t)rows * (size_t)rows, sizeof *A);
    REQUIRE(A);
    for (int n = 0; n < reference_rows(table); n++) {
        int i = (int)reference_number(table, n, "row");
        int j = (int)reference_number(table, n, "column");
        REQUIRE(i >= j && j >= 0 && i < rows);
        A[i * rows + j] = A[j * rows + i] = reference_number(table, n, column);
    }
    return A;
}

/* The larger one; NaN if one is. */
static double worse(double a, double b)
{
    return a > b || isnan(a) ? a : b;
}

/* Frees both. */
static void check_same(const char *what, int rows, double *ours, double *theirs)
{
    double most = 0, far = 0;
    for (int n = 0; n < rows * rows; n++) {
        most = fmax(most, fabs(theirs[n]));
        far = worse(fabs(ours[n] - theirs[n]), far);
    }
    printf("%s: %d rows, largest entry %.3e, off by %.1e of it\n", what, rows, most,
           far / most);
    CHECK(most > 0);
    CHECK_NEAR(far / most, 0, TOL_MATRIX);
    free(ours);
    free(theirs);
}

/* A shape that no scene has: the element code below the model. */
static void check_distorted(void)
{
    const struct solid_case box = {SOLID_HEX, {1, 1, 1}, {3, 3, 2}, {1, 0.75, 0.125}};
    const struct law law = law_isotropic(1e5, 0.3, 1);
    struct solid_material material = solid_element_material(&law, 0.5);
    struct reference *table = open_stored("calculix_matrices_distorted");
    struct patch patch;
    struct solid s;

    solid_box(&box, &patch);
    for (int a = 0; a < patch_nodes(&patch); a++) {
        double *x = patch.point + 3 * a;
        x[0] += 0.5, x[1] += 0.375; /* to a corner at the origin */
        distort(x);
    }
    solid_make(&s, SOLID_HEX, &patch, NULL, false, &material);
    int nodes = s.space.nodes, rows = 3 * nodes;
    double *M = calloc((size_t)rows * (size_t)rows, sizeof *M);
    REQUIRE(M);
    for (int a = 0; a < nodes; a++)
        for (long t = s.assembly.graph.start[a]; t < s.assembly.graph.start[a + 1]; t++)
            for (int i = 0; i < 3; i++) {
                int p = 3 * a + i, q = 3 * s.assembly.graph.node[t] + i;
                M[p * rows + q] = M[q * rows + p] = s.assembly.M[t];
            }
    check_same("distorted, K", rows, solid_dense(&s.assembly.graph, s.assembly.K),
               stored_matrix(table, "stiffness", rows));
    check_same("distorted, M", rows, M, stored_matrix(table, "mass", rows));
    solid_clear(&s);
    reference_close(table);
}

/* The fall of the free edge's middle and corner, of cubics and of C3D20R; C3D8I, which is a
 * model of ours, is in `verify outside`. */
static void check_tips(void)
{
    static const double uvw[2][3] = {{1, 0.5, 0.5}, {1, 1, 0.5}};
    static const char *const column[] = {"middle", "corner"};
    struct reference *table = open_stored("calculix_tips");
    int compared = 0;

    for (int n = reference_find(table, 0, "element", "C3D20R"); n >= 0;
         n = reference_find(table, n + 1, "element", "C3D20R"), compared++) {
        char height[64];
        double x[2][3];
        struct run run;

        snprintf(height, sizeof height, "sheet.thickness=%.17g",
                 reference_number(table, n, "thickness"));
        OPENED_RUN(&run, "cantilever", "iga_paper", height, "material.density=0.5",
                   "discretization.points=[13,13,3]", "discretization.degree=[3,3,2]");
        opened_settle(&run);
        run.model->probe(run.state, 2, uvw[0], x[0]);
        for (int c = 0; c < 2; c++)
            CHECK_NEAR(-x[c][2] / reference_number(table, n, column[c]), 1, TOL_TIP);
        run_close(&run);
    }
    CHECK(compared == 6);
    reference_close(table);
}

static void check_swing(void)
{
    static const char *const name[2][4] = {{"x1.00", "z1.00", "x1", "z1"},
                                           {"x0.50", "z0.50", "x05", "z05"}};
    struct reference *swing = open_stored("calculix_swing_h5mm"),
                     *truth = open_stored("pendulum_C0_E1e5_h5mm_undamped");
    int compared = 0;

    for (int n = 0; n < reference_rows(swing); n++)
        for (int row = 0; row < reference_rows(truth); row++) {
            if (!(fabs(reference_number(truth, row, "t") -
                       reference_number(swing, n, "t")) < 1e-9))
                continue;
            for (int p = 0; p < 2; p++)
                CHECK_NEAR(hypot(reference_number(swing, n, name[p][0]) -
                                     reference_number(truth, row, name[p][2]),
                                 reference_number(swing, n, name[p][1]) -
                                     reference_number(truth, row, name[p][3])),
                           0, TOL_SWING);
            compared++;
        }
    CHECK(reference_rows(swing) == 30 && compared == 30);
    reference_close(truth);
    reference_close(swing);
}

int main(void)
{
    check_distorted();
    check_tips();
    check_swing();
    return check_result();
}
