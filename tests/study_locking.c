/* Locking of a square cantilever under its own weight, from the study's result files: every
 * space against the numbers of an independent prototype, and the two kinds of locking
 * apart.
 *
 *   study_locking FOLDER
 */
#include "bench/studies/studies.h"
#include "bench/studies/study_locking.h"
#include "tests/fresh.h"

/* What the prototype's table must be met to; or half a unit of its last digit, if more. */
static const double TOL_TABLE = 0.01;

/* Degree 3 on 10 x 10 points at nu = 0, a strip bent by its weight: nothing locks;
 * transverse shear adds (h/L)^2, and the grid's two points stand beside the middle of the
 * edge. */
static const double TOL_NOTHING = 1e-3;

/* The theory of r = 1 is of the thin limit; corners of the clamped edge converge slowly. */
static const double TOL_LIMIT = 0.01;

/* Positions are kept as 32-bit floats: half a unit of 24 bits, on either side. */
static const double TOL_FLOAT = 1.2e-7;

static struct study_locking *measured(const char *folder)
{
    struct experiment_options options = {.folder = folder,
                                         .quick = true,
                                         .repeats = 1,
                                         .value_count = STUDY_LOCKING_PROTOTYPES,
                                         .value = study_locking_thickness};
    struct study_locking *s = NULL;
    struct message why = {""};

    fresh_folder(folder);
    if (!CHECK(study_locking_experiment.measure(&options, &why) == STATUS_OK) ||
        !CHECK(study_locking_read(folder, &s, &why) == STATUS_OK)) {
        printf("%s\n", why.text);
        exit(check_result());
    }
    return s;
}

static int place(const char *name)
{
    for (int n = 0; n < STUDY_LOCKING_SPACES; n++)
        if (!strcmp(study_locking_space[n].name, name))
            return n;
    REQUIRE(!"a space of that name");
    return 0;
}

static void against_prototype(const struct study_locking *s)
{
    int found = 0;

    for (int space = 0; space < STUDY_LOCKING_SPACES; space++)
        for (int n = 0; n < STUDY_LOCKING_PROTOTYPES; n++) {
            double wanted, half;
            if (!study_locking_prototype(&study_locking_space[space], n, &wanted, &half))
                continue;
            CHECK_NEAR(s->cell[space][1][n].tip, wanted, fmax(TOL_TABLE * wanted, half));
            found++;
        }
    CHECK(found == 21);
}

static void kinds(const struct study_locking *s)
{
    int quartic = place("iga_441_10"), cured = place("iga_442_10"),
        paper = place("iga_221_10"), finer = place("iga_221_20"), hex = place("hex_10");
    const int thin = 0, thick = STUDY_LOCKING_PROTOTYPES - 1;

    CHECK_NEAR(study_locking_shear(s, quartic, thin), 1, TOL_NOTHING);
    CHECK_NEAR(study_locking_shear(s, cured, thin), 1, TOL_NOTHING);
    CHECK_NEAR(study_locking_through(s, quartic, thin), s->limit, TOL_LIMIT);
    CHECK_NEAR(study_locking_through(s, quartic, thick), s->limit, TOL_LIMIT);
    CHECK(study_locking_through(s, cured, thick) > 0.98);
    /* a plate's limit lies above the strip's (1 - 2 nu) / (1 - nu)^2, below none at all */
    CHECK(s->limit > 0.4 / 0.49 && s->limit < 1);
    for (int n = 1; n < s->count; n++) /* thicker locks less */
        CHECK(study_locking_shear(s, paper, n) > study_locking_shear(s, paper, n - 1) &&
              study_locking_shear(s, hex, n) > study_locking_shear(s, hex, n - 1));
    CHECK(study_locking_shear(s, finer, thin) > study_locking_shear(s, paper, thin));
}

/* A Kirchhoff-Love shell knows no shear: the same share of Kirchhoff's tip, all of it, at
 * any thickness. */
static void without_shear(const struct study_locking *s)
{
    int shell = place("shell_3_20");

    for (int n = 1; n < s->count; n++)
        CHECK_RELATIVE(study_locking_shear(s, shell, n), study_locking_shear(s, shell, 0),
                       TOL_FLOAT);
    CHECK_NEAR(study_locking_shear(s, shell, 0), 1, TOL_NOTHING);
}

static void prints(const char *folder)
{
    char text[1 << 16];
    FILE *file = tmpfile();

    REQUIRE(file);
    for (int format = TABLE_JSON; format >= TABLE_TEXT; format--) {
        rewind(file);
        CHECK(study_locking_experiment.print(folder, (enum table_format)format, file,
                                             NULL) == STATUS_OK);
    }
    rewind(file);
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    CHECK(strstr(text, "0.605") && strstr(text, "h 20") && !strstr(text, "nan"));
    fclose(file);
    CHECK(study_locking_experiment.print("/proc/nowhere", TABLE_TEXT, stdout, NULL) ==
          STATUS_FILE);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    struct study_locking *s = measured(argv[1]);

    CHECK(s->count == STUDY_LOCKING_PROTOTYPES);
    against_prototype(s);
    kinds(s);
    without_shear(s);
    prints(argv[1]);
    free(s);
    return check_result();
}
