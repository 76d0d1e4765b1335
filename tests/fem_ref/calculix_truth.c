/* CalculiX's stiffness and mass of distorted elements, tests/reference/calculix_*.csv: a
 * shape that no scene has. (Others: `clothbench verify outside`; what was asked of it:
 * fem_ref/calculix/decks.) */
#include "fem_ref/reference.h"
#include "tests/solid_fixture.h"

/* A part of the largest entry. 14 digits are written; ours and theirs round a dozen times
 * each. */
static const double TOL_MATRIX = 1e-12;

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

int main(void)
{
    check_distorted();
    return check_result();
}
