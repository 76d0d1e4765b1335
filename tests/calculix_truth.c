/* CalculiX's stored answers belong to the decks that are written now; and hexahedra of a
 * shape that no scene has, against its matrices. (`clothbench verify outside` holds models
 * against the rest.)
 *
 *   calculix_truth stored          decks and matrices against the stored ones
 *   calculix_truth decks FOLDER    writes their decks, HASH.inp, for `ccx -i HASH`
 */
#include "fem_ref/reference.h"
#include "tests/calculix_cases.h"
#include "tests/solid_fixture.h"

/* Of the largest entry. 14 digits are written; ours and theirs round a dozen times each. */
static const double TOL_MATRIX = 1e-12;

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

/* Frees both. */
static void check_same(const char *what, int rows, double *ours, double *theirs)
{
    double most = 0, far = 0;
    for (int n = 0; n < rows * rows; n++) {
        most = fmax(most, fabs(theirs[n]));
        far = fabs(ours[n] - theirs[n]) <= far ? far : fabs(ours[n] - theirs[n]);
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
    struct solid_material material = solid_element_material(1e5, 0.3, 0.5);
    struct reference *table = open_stored("matrices_distorted");
    struct patch patch;
    struct solid s;

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

/* ------------------------------------------------------------------ decks ----------- */

static void check_decks(void)
{
    struct calculix_job job = cases_swing_job(20, 1e-3);
    struct reference *table = open_stored("swing_h5mm");

    check_deck(&job, reference_note(table, "deck_fnv1a"));
    reference_close(table);
    for (int n = 0; n < CASES_MATRICES; n++) {
        char name[64];
        snprintf(name, sizeof name, "matrices_%s", cases_matrices[n].name);
        table = open_stored(name);
        job = cases_matrix_job(n);
        check_deck(&job, reference_note(table, "deck_fnv1a"));
        reference_close(table);
    }
    table = open_stored("tips");
    CHECK(reference_rows(table) == CASES_TIPS);
    for (int n = 0; n < CASES_TIPS; n++) {
        job = cases_tip_job(n);
        check_deck(&job, reference_text(table, n, "deck_fnv1a"));
        CHECK(!strcmp(reference_text(table, n, "element"),
                      calculix_element_name(job.element)));
        CHECK(reference_number(table, n, "thickness") == job.thickness);
    }
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
        check_decks();
        check_distorted();
    }
    return check_result();
}
