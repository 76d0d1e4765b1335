/* Tests hard cases. unit: ends, tables, the cases as data; run: ends that are known
 * beforehand. */
#include "bench/stress/stress.h"

#include "bench/files/folder.h"
#include "models/reader/scene_file.h"
#include "tests/said.h"

static const double bound = 0.01;

static const struct stress_case *case_of(const char *name)
{
    int n = 0;

    while (stress_case_at(n) && strcmp(stress_case_at(n)->item.name, name))
        n++;
    REQUIRE(stress_case_at(n));
    return stress_case_at(n);
}

static const struct contestant *contestant_of(const char *name)
{
    const struct contestant *c = NULL;

    REQUIRE(contestant_find(name, &c, NULL) == STATUS_OK);
    return c;
}

/* Checks the ends by the error; one that is no number is a death. */
static void check_ends(void)
{
    CHECK(stress_result_end(0, bound) == STRESS_ACCURATE);
    CHECK(stress_result_end(bound, bound) == STRESS_ACCURATE);
    CHECK(stress_result_end(nextafter(bound, 1), bound) == STRESS_DEGRADED);
    CHECK(stress_result_end(1e300, bound) == STRESS_DEGRADED);
    CHECK(stress_result_end(INFINITY, bound) == STRESS_DIED);
    CHECK(stress_result_end(NAN, bound) == STRESS_DIED);
}

/* Checks that a case can be read and says all that it needs; otherwise all models would
 * refuse it. */
static void check_case(const struct stress_case *c, const char *path)
{
    struct scene scene = {0};
    struct discretization d = {0};
    struct message why = {""};
    int count = 0;

    while (count < STRESS_SETTINGS && c->physics[count])
        count++;
    const bool refused = !strcmp(c->item.name, "overlapping"); /* as it should be */
    const enum status st = scene_file_read(path, count, c->physics, &scene, &d, &why);
    if (!CHECK(st == (refused ? STATUS_INPUT : STATUS_OK)))
        printf("%s: %s\n", c->item.name, why.text);
    CHECK(c->bound > 0 && *c->why && *c->item.text && *stress_truth_text[c->truth]);
    CHECK(c->gamma <= 0 || scene_gamma(&scene) > 0);
    CHECK(c->truth != STRESS_SIMILAR || (c->length > 0 && c->mass > 0 && c->time > 0));
    CHECK(strspn(c->item.name, "abcdefghijklmnopqrstuvwxyz0123456789_") ==
          strlen(c->item.name));
    for (int n = 0; stress_case_at(n) != c; n++)
        CHECK(strcmp(stress_case_at(n)->item.name, c->item.name));
    scene_clear(&scene);
    discretization_clear(&d);
}

/* Counts the contestants that are chosen. */
static int chosen(const struct stress_choice *choice)
{
    const struct contestant *c = NULL;
    int count = 0;

    while ((c = stress_choice_next(choice, c)))
        count++;
    return count;
}

static void check_choice(void)
{
    static const char *const words[] = {"thin_5"};
    const struct stress_choice all = {0}, quick = {.quick = true},
                               some = {.word_count = 1, .words = words, .quick = true},
                               pair = {.models = "projective_dynamics,hex_incompatible"};
    struct message why = {""};

    for (int n = 0; stress_case_at(n); n++) {
        const struct stress_case *c = stress_case_at(n);
        CHECK(stress_choice_case(&all, c));
        CHECK(stress_choice_case(&quick, c) == c->quick);
        CHECK(stress_choice_case(&some, c) == !strcmp(c->item.name, "thin_5"));
    }
    for (int n = 0; stress_case_at(n); n++)
        CHECK(&stress_case_at(n)->item == stress_case_items[n]);
    CHECK(chosen(&pair) == 3); /* two of projective dynamics, one of hex */
    CHECK(chosen(&(struct stress_choice){.models = "iga_linear"}) == 1); /* by its name */
    CHECK(chosen(&all) >= 10);
    CHECK(stress_choice_check(&some, NULL) == STATUS_OK);
    CHECK(stress_choice_check(&pair, NULL) == STATUS_OK);
    const char *const unknown[] = {"thin"};
    CHECK(stress_choice_check(&(struct stress_choice){.word_count = 1, .words = unknown},
                              &why) == STATUS_INPUT &&
          strstr(why.text, "'thin'"));
    CHECK(stress_choice_check(&(struct stress_choice){.models = "iga,ig"}, &why) ==
              STATUS_INPUT &&
          strstr(why.text, "'ig'"));
}

/* --- tables: the numbers of each way to end, and counts --- */

static const struct told {
    struct stress_result r;
    const char *details; /* cells, from the end on                                     */
} told[] = {
    {{STRESS_ACCURATE, 1e-13, NAN, 0.5, {"well"}}, "accurate,1e-13,,0.5,well"},
    {{STRESS_DEGRADED, 0.25, 0.125, 0.5, {"moves"}}, "degraded,0.25,0.125,0.5,moves"},
    {{STRESS_REFUSED, NAN, NAN, 0, {"no contact"}}, "refused,,,0,no contact"},
    {{STRESS_DIED, NAN, 0.25, 2, {"crashed"}}, "died,,0.25,2,crashed"},
};

static void check_print(const char *folder)
{
    static const char *const ends[] = {"1 accurate, 0 degraded, 0 refused, 0 died.",
                                       "0 accurate, 1 degraded, 0 refused, 0 died.",
                                       "0 accurate, 0 degraded, 1 refused, 0 died.",
                                       "0 accurate, 0 degraded, 0 refused, 1 died."};
    const char *const name = "still";
    const struct stress_case *c = case_of(name);
    const struct stress_choice choice = {1, &name, "iga_paper,shell_2", false};
    char line[256];

    REQUIRE(folder_make(folder, NULL) == STATUS_OK);
    for (size_t n = 0; n < sizeof told / sizeof *told; n++) {
        struct said text;
        struct stress_result r = told[n].r;
        const struct stress_job job = {
            .c = c, .contestant = contestant_of("shell_2"), .result = &r};
        REQUIRE(stress_save(folder, 1, &job, NULL) == STATUS_OK);
        said_open(&text);
        CHECK(stress_print(folder, &choice, &(struct printer){TABLE_CSV, text.file, NULL},
                           NULL) == STATUS_OK);
        CHECK(stress_print(folder, &choice, &(struct printer){TABLE_TEXT, text.file, NULL},
                           NULL) == STATUS_OK);
        said_close(&text, true);
        snprintf(line, sizeof line, "still,shell_2,%.17g,%s\n", c->bound, told[n].details);
        said_has(&text, name, line);
        said_has(&text, name, ends[told[n].r.end]);
        said_clear(&text);
    }
    const struct printer nowhere = {TABLE_CSV, NULL, NULL};
    CHECK(stress_print(folder, &(struct stress_choice){.models = "iga_paper"}, &nowhere,
                       NULL) == STATUS_INPUT);
    CHECK(stress_print("nowhere", &choice, &nowhere, NULL) == STATUS_FILE);
}

/* Runs a case and checks its end, and that a refusal or a death says why. */
static struct stress_result check_run(const char *path, const char *folder, const char *c,
                                      const char *contestant, enum stress_end want)
{
    const struct stress_job job = {.c = case_of(c),
                                   .contestant = contestant_of(contestant),
                                   .path = path,
                                   .folder = folder};
    struct stress_result r;

    REQUIRE(stress_judge(&job, &r, NULL) == STATUS_OK);
    if (!CHECK(r.end == want))
        printf("%s, %s: %s with error %g (%s)\n", c, contestant, stress_end_name[r.end],
               r.error, r.sentence.text);
    if (job.c->truth == STRESS_CONTACT || job.c->truth == STRESS_SLIDE)
        CHECK(*r.sentence.text); /* nothing passes through unannounced */
    if (r.end == STRESS_REFUSED || r.end == STRESS_DIED)
        CHECK(*r.sentence.text && isnan(r.error));
    if (r.end == STRESS_DIED)
        CHECK(isfinite(r.time));
    return r;
}

static void check_runs(const char *path, const char *folder)
{
    static const struct {
        const char *c, *contestant;
        enum stress_end want;
    } known[] = {
        {"still", "iga_paper", STRESS_ACCURATE},
        {"still", "iga_nonlinear", STRESS_ACCURATE},
        {"still", "hex_incompatible", STRESS_ACCURATE},
        {"still", "shell", STRESS_ACCURATE},
        {"still", "mass_spring", STRESS_ACCURATE},
        {"still", "projective_dynamics", STRESS_ACCURATE},
        {"thin_5", "iga_selective", STRESS_ACCURATE},
        {"thin_5", "iga_nonlinear", STRESS_DEGRADED}, /* locks */
        {"thin_5", "hex_nonlinear", STRESS_DEGRADED},
        {"poisson_04999", "iga_selective", STRESS_ACCURATE},
        {"poisson_04999", "iga_nonlinear", STRESS_DEGRADED},
        {"folded_knots", "iga_nonlinear", STRESS_REFUSED},
        {"folded_knots", "shell", STRESS_REFUSED},
        {"folded_knots", "mass_spring", STRESS_REFUSED},
        {"torn_knots", "iga_nonlinear", STRESS_REFUSED},
        {"one_element", "iga_nonlinear", STRESS_DEGRADED}, /* a parabola for a quartic */
        {"millimetres", "iga_selective", STRESS_ACCURATE},
        {"inches", "mass_spring", STRESS_ACCURATE},
        {"soft", "shell", STRESS_ACCURATE},
        {"stiff", "iga_paper", STRESS_ACCURATE},
        {"spinning_bar", "shell", STRESS_ACCURATE},
        {"spinning_bar", "mass_spring", STRESS_DEGRADED}, /* implicit Euler */
        {"step_large", "iga_paper", STRESS_DEGRADED},
        {"swing_10000", "iga_paper", STRESS_REFUSED}, /* has no elastic energy */
        {"swing_10000", "mass_spring_leapfrog", STRESS_ACCURATE},
        {"rest_start", "shell", STRESS_ACCURATE},
        {"rest_start", "projective_dynamics", STRESS_REFUSED},
        {"rest_start", "iga_paper", STRESS_DIED}, /* creeps */
        {"thrown", "shell_2", STRESS_ACCURATE},
        {"buckling", "mass_spring", STRESS_ACCURATE},
        {"touching", "iga_selective", STRESS_ACCURATE},
        {"overlapping", "triangles", STRESS_REFUSED},
        {"coplanar", "shell_2", STRESS_ACCURATE},
        {"closing", "hex_nonlinear", STRESS_ACCURATE},
        {"crushed", "mass_spring_leapfrog", STRESS_ACCURATE}, /* two walls, no room */
        {"crushed", "position_based", STRESS_ACCURATE},
        {"stopping", "projective_dynamics", STRESS_ACCURATE},
        {"struck", "shell_2", STRESS_ACCURATE},
        {"struck", "mass_spring", STRESS_ACCURATE},
        {"struck", "projective_dynamics", STRESS_ACCURATE},
        {"struck", "position_based", STRESS_ACCURATE},
        {"thrown_at_ball", "triangles", STRESS_ACCURATE},
        {"pressed_fold", "mass_spring_leapfrog", STRESS_ACCURATE},
        {"thick_contact", "triangles", STRESS_ACCURATE},
        {"friction_0", "shell_2", STRESS_ACCURATE},
        {"friction_5", "position_based", STRESS_ACCURATE},
        {"needles", "mass_spring", STRESS_ACCURATE},
        {"flat_triangle", "iga_nonlinear", STRESS_REFUSED},
    };

    for (size_t n = 0; n < sizeof known / sizeof *known; n++)
        check_run(path, folder, known[n].c, known[n].contestant, known[n].want);
}

/* Checks one parabola in the linear statics of `printed`: it gives 2/3 of the tip, Gamma /
 * 12 for Gamma / 8, but for shear, (h/L)^2 of it. */
static void check_parabola(const char *path, const char *folder)
{
    const double TOL_SHEAR = 1e-3;
    const struct stress_result r =
        check_run(path, folder, "one_element", "iga_paper", STRESS_DEGRADED);

    CHECK_NEAR(r.error, 1 / 3., TOL_SHEAR);
}

int main(int argc, char **argv)
{
    char *path = NULL;

    REQUIRE(argc == 3);
    REQUIRE(scene_file_find(stress_case_scene, &path, NULL) == STATUS_OK);
    if (!strcmp(argv[1], "unit")) {
        check_ends();
        check_choice();
        check_print(argv[2]);
        for (int n = 0; stress_case_at(n); n++)
            check_case(stress_case_at(n), path);
    } else {
        check_runs(path, argv[2]);
        check_parabola(path, argv[2]);
    }
    free(path);
    return check_result();
}
