/* CalculiX's answers that are stored in tests/reference/calculix_*.csv: their decks are
 * ours still, and what `verify outside` has no model for agrees: a distorted element,
 * another element's tips, the swing of an elastica computed elsewhere.
 *
 *   calculix_truth stored          against the stored answers
 *   calculix_truth decks FOLDER    writes their decks, HASH.inp, for `ccx -i HASH`
 */
#include "fem_ref/calculix_deck.h"
#include "fem_ref/reference.h"
#include "tests/opened_run.h"
#include "tests/solid_fixture.h"

/* Of the largest entry. 14 digits are written; ours and theirs round a dozen times each. */
static const double TOL_MATRIX = 1e-12;

/* Cubics, and reduced quadratics at spans of L / 20 (measured 2e-3). */
static const double TOL_TIP = 4e-3;

/* Asked of answers that share nothing [L]. */
static const double TOL_SWING = 1e-3;

/* On dyadic points this is exact in the deck's 13 digits. No angle stays right. */
static void distort(double x[3])
{
    x[0] += 0.25 * x[1] * x[2] + 0.125 * x[1];
    x[1] += 0.125 * x[0] - 0.25 * x[2];
    x[2] += 0.25 * x[0] * x[1];
}

/* Matrices of a box, or distorted. */
static struct calculix_job matrix_job(bool distorted)
{
    return (struct calculix_job){
        .task = CALCULIX_MATRICES,
        .element = CALCULIX_C3D8,
        .length = 1,
        .width = 0.75,
        .thickness = 0.125,
        .cells = {2, 2, 1},
        .young = 1e5,
        .poisson = 0.3,
        .density = 0.5,
        .place = distorted ? distort : NULL,
    };
}

/* Tips of the square cantilever under its own weight. */
enum { THICKNESSES = 6, TIPS = 2 * THICKNESSES };

static struct calculix_job tip_job(int n)
{
    static const double thickness[] = {0.1, 0.05, 0.02, 0.01, 0.005, 0.001};
    bool quadratic = n >= THICKNESSES;
    int cells = quadratic ? 20 : 32;

    return (struct calculix_job){
        .task = CALCULIX_STATIC,
        .element = quadratic ? CALCULIX_C3D20R : CALCULIX_C3D8I,
        .length = 1,
        .width = 1,
        .thickness = thickness[n % THICKNESSES],
        .cells = {cells, cells, 1},
        .young = 1e5,
        .poisson = 0.3,
        .density = 0.5,
        .gravity = 9.81,
    };
}

/* The swing of pendulum_C0: nu = 0, uniform across the width, so one element is enough. */
static struct calculix_job swing_job(void)
{
    return (struct calculix_job){
        .task = CALCULIX_SWING,
        .element = CALCULIX_C3D20R,
        .length = 1,
        .width = 0.05,
        .thickness = 0.005,
        .cells = {20, 1, 1},
        .young = 1e5,
        .density = 0.3,
        .gravity = 9.81,
        .step = 1e-3,
        .end = 0.3,
        .every = 10,
    };
}

static struct reference *open_stored(const char *name)
{
    char path[512];
    struct reference *table = NULL;

    snprintf(path, sizeof path, REFERENCE_DIR "/%s.csv", name);
    REQUIRE(reference_open(path, &table, NULL) == STATUS_OK);
    return table;
}

/* A stored answer belongs to a deck; if ours is another by now, it is no truth for it. */
static void check_deck(const struct calculix_job *job, const char *stored)
{
    char hash[17];
    REQUIRE(!calculix_deck_hash(job, hash));
    if (!CHECK(stored && !strcmp(hash, stored)))
        printf("  the deck is %s now, not %s\n", hash, stored ? stored : "told");
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
    struct calculix_job job = matrix_job(true);
    struct solid_material material = solid_element_material(1e5, 0.3, 0.5);
    struct reference *table = open_stored("calculix_matrices_distorted");
    struct patch patch;
    struct solid s;

    check_deck(&job, reference_note(table, "deck_fnv1a"));
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

/* Decks of all jobs, and of C3D20R the fall of the free edge's middle and corner. */
static void check_tips(void)
{
    static const double uvw[2][3] = {{1, 0.5, 0.5}, {1, 1, 0.5}};
    static const char *const column[] = {"middle", "corner"};
    struct reference *table = open_stored("calculix_tips");

    CHECK(reference_rows(table) == TIPS);
    for (int n = 0; n < TIPS; n++) {
        struct calculix_job job = tip_job(n);
        char height[64];
        double x[2][3];
        struct run run;

        check_deck(&job, reference_text(table, n, "deck_fnv1a"));
        CHECK(!strcmp(reference_text(table, n, "element"),
                      calculix_element_name(job.element)));
        CHECK(reference_number(table, n, "thickness") == job.thickness);
        if (job.element == CALCULIX_C3D8I) /* the same element: in `verify outside` */
            continue;
        snprintf(height, sizeof height, "sheet.thickness=%.17g", job.thickness);
        OPENED_RUN(&run, "cantilever", "iga_paper", height, "material.density=0.5",
                   "discretization.points=[13,13,3]", "discretization.degree=[3,3,2]");
        opened_settle(&run);
        run.model->probe(run.state, 2, uvw[0], x[0]);
        for (int c = 0; c < 2; c++)
            CHECK_NEAR(-x[c][2] / reference_number(table, n, column[c]), 1, TOL_TIP);
        run_close(&run);
    }
    reference_close(table);
}

static void check_swing(void)
{
    static const char *const name[2][4] = {{"x1.00", "z1.00", "x1", "z1"},
                                           {"x0.50", "z0.50", "x05", "z05"}};
    struct calculix_job job = swing_job();
    struct reference *swing = open_stored("calculix_swing_h5mm"),
                     *truth = open_stored("pendulum_C0_E1e5_h5mm_undamped");
    int compared = 0;

    check_deck(&job, reference_note(swing, "deck_fnv1a"));
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

static void check_box_deck(void)
{
    const struct calculix_job job = matrix_job(false);
    struct reference *table = open_stored("calculix_matrices_box");

    check_deck(&job, reference_note(table, "deck_fnv1a"));
    reference_close(table);
}

static void write_deck(const char *folder, const struct calculix_job *job)
{
    char hash[17], path[512];
    REQUIRE(!calculix_deck_hash(job, hash));
    snprintf(path, sizeof path, "%s/%s.inp", folder, hash);
    FILE *file = fopen(path, "w");
    REQUIRE(file);
    calculix_deck_write(job, file);
    REQUIRE(!fclose(file));
}

int main(int count, char **argument)
{
    REQUIRE(count >= 2);
    if (!strcmp(argument[1], "decks")) {
        struct calculix_job job = swing_job();
        REQUIRE(count == 3);
        write_deck(argument[2], &job);
        for (int n = 0; n < 2; n++)
            job = matrix_job(n), write_deck(argument[2], &job);
        for (int n = 0; n < TIPS; n++)
            job = tip_job(n), write_deck(argument[2], &job);
    } else {
        check_box_deck();
        check_distorted();
        check_tips();
        check_swing();
    }
    return check_result();
}
