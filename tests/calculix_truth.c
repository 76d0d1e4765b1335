/* Hexahedra, solids and a swing against CalculiX.
 *
 *   calculix_truth stored          ours against the stored answers
 *   calculix_truth decks FOLDER    writes their decks, HASH.inp, for `ccx -i HASH`
 */
#include "fem_ref/reference.h"
#include "tests/calculix_cases.h"
#include "tests/motion_fixture.h"
#include "tests/solid_fixture.h"

/* Of the largest entry. 14 digits are written; ours and theirs round a dozen times each. */
static const double TOL_MATRIX = 1e-12;

/* The larger one; NaN if one is. */
static double worse(double a, double b)
{
    return a > b || isnan(a) ? a : b;
}

static struct reference *open_stored(const char *name)
{
    char path[512];
    struct reference *table;
    struct message why = {""};
    snprintf(path, sizeof path, REFERENCE_DIR "/calculix_%s.csv", name);
    if (!CHECK(reference_open(path, &table, &why) == STATUS_OK)) {
        printf("%s\n", why.text);
        exit(1);
    }
    return table;
}

static struct reference *open_matrices(int n)
{
    char name[64];
    snprintf(name, sizeof name, "matrices_%s", cases_matrices[n].name);
    return open_stored(name);
}

/* A stored answer belongs to a deck; if ours is another by now, it is no truth for it. */
static void check_deck(const struct calculix_job *job, const char *stored)
{
    char hash[17];
    REQUIRE(!calculix_deck_hash(job, hash));
    if (!CHECK(stored && !strcmp(hash, stored)))
        printf("  the deck is %s now, not %s\n", hash, stored ? stored : "told");
}

/* ------------------------------------------------------------------ matrices -------- */

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

static double *dense(const struct matrix *m)
{
    double *A = calloc((size_t)m->rows * (size_t)m->rows, sizeof *A);
    REQUIRE(A);
    for (long t = 0; t < m->entries; t++)
        A[m->row[t] * m->rows + m->column[t]] = A[m->column[t] * m->rows + m->row[t]] =
            m->value[t];
    return A;
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

/* The model's own matrices of the box. */
static void check_box(void)
{
    struct calculix_job job = cases_matrix_job(0);
    struct reference *table = open_matrices(0);
    struct matrix K, M;
    struct run run;

    check_deck(&job, reference_note(table, "deck_fnv1a"));
    run_open(&run, "hex", "cantilever",
             RUN_SETTINGS("sheet.width=0.75", "sheet.thickness=0.125",
                          "material.density=0.5", "discretization.points=[3,3,2]",
                          "discretization.unknowns=points"));
    REQUIRE(!run.model->matrices(run.state, &K, &M));
    check_same("box, K", K.rows, dense(&K), stored_matrix(table, "stiffness", K.rows));
    check_same("box, M", M.rows, dense(&M), stored_matrix(table, "mass", M.rows));
    matrix_clear(&K);
    matrix_clear(&M);
    run_close(&run);
    reference_close(table);
}

/* A shape that no scene has: the element code below the model. */
static void check_distorted(void)
{
    const struct solid_case box = {SOLID_HEX, {1, 1, 1}, {3, 3, 2}, {1, 0.75, 0.125}};
    struct calculix_job job = cases_matrix_job(1);
    struct solid_material material = solid_element_material(1e5, 0.3, 0.5);
    struct reference *table = open_matrices(1);
    struct patch patch;
    struct solid s;

    check_deck(&job, reference_note(table, "deck_fnv1a"));
    solid_box(&box, &patch);
    for (int a = 0; a < patch_nodes(&patch); a++) {
        double *x = patch.point + 3 * a;
        x[0] += 0.5, x[1] += 0.375; /* to a corner at the origin */
        cases_distort(x);
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

/* ------------------------------------------------------------------ tips ------------ */

/* Fall of the free edge's middle and corner. */
static void our_tips(const char *model, double thickness, const char *points,
                     const char *degree, const char *remedy, double fall[2])
{
    static const double uvw[2][3] = {{1, 0.5, 0.5}, {1, 1, 0.5}};
    struct message why = {""};
    char height[64];
    double x[2][3];
    struct run run;

    snprintf(height, sizeof height, "sheet.thickness=%.17g", thickness);
    run_open(&run, model, "cantilever",
             RUN_SETTINGS(height, "material.density=0.5", points, degree, remedy));
    REQUIRE(!run.model->equilibrium(run.state, &run.counters, &why));
    run.model->probe(run.state, 2, uvw[0], x[0]);
    fall[0] = -x[0][2], fall[1] = -x[1][2];
    run_close(&run);
}

/* The same element on the same mesh: 7 digits, and round-off by the condition of K in nodes
 * of both faces, which is theirs: 2.5e12 at h = 1 mm, and as h^-4 [relative]. */
static double tip_rounding(double h)
{
    return 1e-6 + 1e-16 * 2.5e12 * pow(h / 1e-3, -4);
}

static void check_tips(void)
{
    /* Another element: cubics, and reduced quadratics at spans of L / 20 (measured 2e-3).
     */
    const double OTHER = 4e-3;
    struct reference *table = open_stored("tips");

    CHECK(reference_rows(table) == CASES_TIPS);
    for (int n = 0; n < CASES_TIPS; n++) {
        struct calculix_job job = cases_tip_job(n);
        bool same = job.element == CALCULIX_C3D8I;
        double h = job.thickness, fall[2];
        const double TOL_TIP = same ? tip_rounding(h) : OTHER;
        const char *column[] = {"middle", "corner"};

        check_deck(&job, reference_text(table, n, "deck_fnv1a"));
        CHECK(!strcmp(reference_text(table, n, "element"),
                      calculix_element_name(job.element)));
        CHECK(reference_number(table, n, "thickness") == h);
        if (same)
            our_tips("hex", h, "discretization.points=[33,33,2]",
                     "discretization.degree=[1,1,1]", "discretization.remedy=incompatible",
                     fall);
        else
            our_tips("iga", h, "discretization.points=[13,13,3]",
                     "discretization.degree=[3,3,2]", "discretization.remedy=none", fall);
        for (int c = 0; c < 2; c++) {
            double theirs = reference_number(table, n, column[c]);
            printf("%s, h = %g m, %s: CalculiX %.6e m, ours %.6e m, off by %.1e\n",
                   reference_text(table, n, "element"), h, column[c], theirs, fall[c],
                   fall[c] / theirs - 1);
            CHECK_NEAR(fall[c] / theirs, 1, TOL_TIP);
        }
    }
    reference_close(table);
}

/* ------------------------------------------------------------------ swing ----------- */

/* Row of the table at that time; -1 if there is none. */
static int row_at(const struct reference *table, double time)
{
    for (int n = 0; n < reference_rows(table); n++)
        if (fabs(reference_number(table, n, "t") - time) < 1e-9)
            return n;
    return -1;
}

static double off(const double x[3], const struct reference *table, int row,
                  const char *name)
{
    char column[2][16];
    snprintf(column[0], sizeof column[0], "x%s", name);
    snprintf(column[1], sizeof column[1], "z%s", name);
    return hypot(x[0] - reference_number(table, row, column[0]),
                 x[2] - reference_number(table, row, column[1]));
}

static void check_swing(void)
{
    /* What is asked of three answers that share nothing [L]: an outside code, ours, and an
     * elastica computed elsewhere. */
    const double TOL_SWING = 1e-3;
    static const double uvw[2][3] = {{1, 0.5, 0.5}, {0.5, 0.5, 0.5}};
    struct calculix_job job = cases_swing_job(20, 1e-3);
    struct reference *swing = open_stored("swing_h5mm"), *truth;
    double most[3] = {0};
    struct run run;

    check_deck(&job, reference_note(swing, "deck_fnv1a"));
    CHECK(reference_rows(swing) == 30);
    REQUIRE(
        !reference_open(REFERENCE_DIR "/pendulum_C0_E1e5_h5mm_undamped.csv", &truth, NULL));
    run_open(&run, "iga", "edge_drop",
             RUN_SETTINGS("material.poisson=0", "sheet.thickness=0.005", "sheet.width=0.05",
                          "material.density=0.3", "damping={kind: none}", "time.step=0.005",
                          "discretization.points=[19,4,3]", "discretization.degree=[3,3,2]",
                          "discretization.remedy=none",
                          "discretization.kinematics=nonlinear"));
    for (int n = 0; n < reference_rows(swing); n++) {
        double t = reference_number(swing, n, "t"), ours[2][3], theirs[2][3];
        int row = row_at(truth, t);
        REQUIRE(row >= 0);
        for (int p = 0; p < 2; p++) {
            theirs[p][0] = reference_number(swing, n, p ? "x0.50" : "x1.00");
            theirs[p][2] = reference_number(swing, n, p ? "z0.50" : "z1.00");
            most[0] = worse(most[0], off(theirs[p], truth, row, p ? "05" : "1"));
        }
        run_until(&run, t);
        run.model->probe(run.state, 2, uvw[0], ours[0]);
        for (int p = 0; p < 2; p++) {
            most[1] = worse(most[1], off(ours[p], swing, n, p ? "0.50" : "1.00"));
            most[2] = worse(most[2], off(ours[p], truth, row, p ? "05" : "1"));
        }
    }
    printf("swing to 0.3 s: CalculiX and elastica %.1e m apart, ours and CalculiX %.1e m, "
           "ours and elastica %.1e m\n",
           most[0], most[1], most[2]);
    for (int k = 0; k < 3; k++)
        CHECK_NEAR(most[k], 0, TOL_SWING);
    run_close(&run);
    reference_close(truth);
    reference_close(swing);
}

/* ------------------------------------------------------------------ decks ----------- */

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

static void write_decks(const char *folder)
{
    struct calculix_job job = cases_swing_job(20, 1e-3);

    write_deck(folder, &job);
    for (int n = 0; n < CASES_MATRICES; n++)
        job = cases_matrix_job(n), write_deck(folder, &job);
    for (int n = 0; n < CASES_TIPS; n++)
        job = cases_tip_job(n), write_deck(folder, &job);
}

int main(int count, char **argument)
{
    REQUIRE(count >= 2);
    if (!strcmp(argument[1], "decks")) {
        REQUIRE(count == 3);
        write_decks(argument[2]);
    } else {
        REQUIRE(!strcmp(argument[1], "stored"));
        check_box();
        check_distorted();
        check_tips();
        check_swing();
    }
    return check_result();
}
