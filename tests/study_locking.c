/* Locking of a square cantilever under its own weight, from the study's result files: every
 * space against the numbers of an independent prototype, and the two kinds of locking
 * apart.
 *
 *   study_locking FOLDER
 */
#include "bench/files/folder.h"
#include "bench/files/store.h"
#include "bench/harness/run_result.h"
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

/* What a label says, "IGA (4,4,1) 10x10x2", is what ran: degree, and unknowns of a sheet
 * with one edge held (a shell holds two rows); each file is of the sheet that its name
 * says. */
static void check_file(const char *folder, int space, int nu, double h)
{
    const struct study_locking_space *s = &study_locking_space[space];
    const bool shell = !strncmp(s->label, "shell", 5);
    const char *net = strpbrk(s->label, "0123456789");
    int side = 0, other = 0, layers = 1;
    char path[4096], degree[64] = "";
    struct store_read *file = NULL;
    struct scene scene;
    struct run_result r;

    while (net && sscanf(net, "%dx%dx%d", &side, &other, &layers) < 2 + !shell)
        net = strpbrk(net + strspn(net, "0123456789"), "0123456789");
    CHECK(net && side == s->points && other == side);
    if (s->degree) {
        snprintf(degree, sizeof degree, "(%.5s)", strchr(s->degree, '[') + 1);
        CHECK(strstr(s->label, degree));
    }
    snprintf(path, sizeof path, "%s/%s_nu%g_h%gmm.h5", folder, s->name,
             study_locking_nu[nu], 1e3 * h);
    REQUIRE(run_result_read(path, false, &r, NULL) == STATUS_OK);
    CHECK(r.unknowns == 3 * side * (shell ? side - 2 : (side - 1) * layers));
    REQUIRE(store_read_open(path, &file, NULL) == STATUS_OK);
    REQUIRE(store_scene(file, path, &scene, NULL) == STATUS_OK);
    CHECK(scene.poisson == study_locking_nu[nu] && scene.thickness == h);
    scene_clear(&scene);
    store_read_close(file);
    run_result_clear(&r);
}

/* Also what was timed: at nu = 0.3 alone, of what has an equilibrium. */
static void files(const char *folder, const struct study_locking *s)
{
    char path[4096];

    for (int n = 0; n < s->count; n++) {
        CHECK(s->thickness[n] == study_locking_thickness[n]);
        for (int space = 0; space < STUDY_LOCKING_SPACES; space++)
            for (int nu = 0; nu < STUDY_LOCKING_NUS; nu++) {
                const struct study_locking_cell *c = &s->cell[space][nu][n];
                const bool timed = nu == STUDY_LOCKING_BOTH;
                check_file(folder, space, nu, s->thickness[n]);
                CHECK(timed ? c->setup > 0 && c->equilibrium > 0
                            : isnan(c->setup) && isnan(c->equilibrium));
            }
    }
    snprintf(path, sizeof path, "%s/iga_221_10_nu0.3_h1mm.h5", folder);
    CHECK(!strcmp(s->machine, path));
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
    files(argv[1], s);
    prints(argv[1]);
    free(s);
    return check_result();
}
