/* Hard cases. unit: which of the four ends a result is, files, the cases as data; run: ends
 * that are known beforehand, and that each run has exactly one. */
#include "bench/stress/stress.h"

#include <unistd.h>

#include "bench/files/folder.h"
#include "bench/files/seal.h"
#include "models/reader/scene_file.h"
#include "tests/stress_fixture.h"

static const double bound = 0.01;

/* Which of the ends a result is. */
static void check_ends(void)
{
    const struct {
        enum stress_outcome outcome;
        bool quick;
        double error;
        enum stress_end end;
    } known[] = {
        {STRESS_RAN, false, 0, STRESS_ACCURATE},
        {STRESS_RAN, false, bound, STRESS_ACCURATE},
        {STRESS_RAN, false, nextafter(bound, 1), STRESS_DEGRADED},
        {STRESS_RAN, false, 1e300, STRESS_DEGRADED},
        {STRESS_RAN, false, INFINITY, STRESS_DIED},
        {STRESS_RAN, false, NAN, STRESS_DIED}, /* no silence */
        {STRESS_SAID_NO, false, NAN, STRESS_REFUSED},
        {STRESS_SAID_NO, false, 0, STRESS_REFUSED},
        {STRESS_DEAD, false, 0, STRESS_DIED},
        /* a part of the case: what it says of all of it */
        {STRESS_RAN, true, 0, STRESS_UNJUDGED},
        {STRESS_RAN, true, 1, STRESS_UNJUDGED},
        {STRESS_RAN, true, NAN, STRESS_DIED},
        {STRESS_SAID_NO, true, NAN, STRESS_REFUSED},
        {STRESS_DEAD, true, NAN, STRESS_DIED},
        {STRESS_STOPPED, false, NAN, STRESS_UNJUDGED},
        {STRESS_STOPPED, true, NAN, STRESS_UNJUDGED},
    };

    for (size_t n = 0; n < sizeof known / sizeof *known; n++)
        if (!CHECK(stress_result_end(&(struct stress_result){.outcome = known[n].outcome,
                                                             .quick = known[n].quick,
                                                             .error = known[n].error},
                                     bound) == known[n].end))
            printf("  row %zu\n", n);
}

static void check_file(const char *folder)
{
    const struct stress_result all[] = {
        {STRESS_RAN, 1 / 3., NAN, 0.1, false, {"the truth's error bar is 1e-3"}},
        {STRESS_RAN, 1e-300, 0.25, 0, true, {""}},
        {STRESS_SAID_NO, NAN, NAN, 0, false, {"unsupported: no contact"}},
        {STRESS_DEAD, NAN, 1e-3, 1e3, false, {"crashed: signal 11"}},
        {STRESS_STOPPED, NAN, 2, 20, true, {"not done after 20 s of processor time"}},
    };
    const struct contestant *at = stress_fixture_contestant("iga"),
                            *other = stress_fixture_contestant("shell");
    const struct stress_case *c = stress_fixture_case("still");
    struct stress_result r;
    struct message why = {""};

    REQUIRE(folder_make(folder, NULL) == STATUS_OK);
    for (size_t n = 0; n < sizeof all / sizeof *all; n++) {
        REQUIRE(stress_result_write(folder, c, at, &all[n], NULL) == STATUS_OK);
        REQUIRE(stress_result_read(folder, c, at, &r, NULL) == STATUS_OK);
        CHECK(r.outcome == all[n].outcome && r.quick == all[n].quick &&
              !strcmp(r.sentence.text, all[n].sentence.text));
        CHECK(r.error == all[n].error || (isnan(r.error) && isnan(all[n].error)));
        CHECK(r.time == all[n].time || (isnan(r.time) && isnan(all[n].time)));
        CHECK(r.seconds == all[n].seconds);
    }
    CHECK(stress_result_read(folder, c, other, &r, &why) == STATUS_FILE && *why.text);
}

/* Sealed, but no result of ours; damaged: every byte of a good one changed, every beginning
 * of it. None is believed. */
static void check_broken(const char *folder)
{
    static const char *const sealed[] = {
        "", "outcome slept\nerror 1\ntime 1\nseconds 1\nquick 0\nsentence \n",
        "outcome ran\nerror x\ntime 1\nseconds 1\nquick 0\nsentence \n",
        "outcome ran\nerror 1\ntime 1\nseconds 1\nsentence \n",
        "outcome ran\nerror 1\ntime 1\nseconds 1\nquick 0\nsentence\n"};
    enum { SEALED = sizeof sealed / sizeof *sealed };
    const struct stress_case *broken = stress_fixture_case("thrown");
    const struct contestant *at = stress_fixture_contestant("iga");
    char path[512], good[1024] = "";
    struct stress_result r = {.outcome = STRESS_RAN, .error = 1, .sentence = {"well"}};

    snprintf(path, sizeof path, "%s/%s.%s.txt", folder, broken->item.name, at->name);
    REQUIRE(stress_result_write(folder, broken, at, &r, NULL) == STATUS_OK);
    FILE *file = fopen(path, "r");
    REQUIRE(file);
    const size_t size = fread(good, 1, sizeof good - 1, file);
    fclose(file);
    for (size_t n = 0; n < SEALED + 2 * size; n++) {
        struct message why = {""};
        const size_t k = n - SEALED, count = k < size ? k : size;
        if (n < SEALED) {
            REQUIRE(seal_text_write(path, sealed[n], NULL) == STATUS_OK);
        } else {
            good[k % size] ^= k >= size;
            file = fopen(path, "w");
            REQUIRE(file && fwrite(good, 1, count, file) == count && fclose(file) == 0);
            good[k % size] ^= k >= size;
        }
        if (!CHECK(stress_result_read(folder, broken, at, &r, &why) == STATUS_INPUT))
            printf("  change %zu of %zu is believed\n", n, size);
        CHECK(strstr(why.text, path) &&
              strstr(why.text, n < SEALED ? "is no result of this" : "is damaged"));
    }
    unlink(path);
}

/* A case that no model can read would be refused by all, and say nothing. */
static void check_case(const struct stress_case *c, const char *path)
{
    struct scene scene = {0};
    struct discretization d = {0};
    struct message why = {""};
    int count = 0;

    while (count < STRESS_SETTINGS && c->physics[count])
        count++;
    if (!CHECK(scene_file_read(path, count, c->physics, &scene, &d, &why) == STATUS_OK))
        printf("%s: %s\n", c->item.name, why.text);
    CHECK(c->bound > 0 && *c->why && *c->item.text && *stress_truth_text[c->truth]);
    CHECK(c->gamma <= 0 || scene_gamma(&scene) > 0);
    CHECK(!c->quick_end == !c->quick_text && (c->quick || !c->quick_end));
    CHECK(c->truth != STRESS_SIMILAR || (c->length > 0 && c->mass > 0 && c->time > 0));
    CHECK(strspn(c->item.name, "abcdefghijklmnopqrstuvwxyz0123456789_") ==
          strlen(c->item.name));
    for (int n = 0; stress_case_at(n) != c; n++)
        CHECK(strcmp(stress_case_at(n)->item.name, c->item.name));
    scene_clear(&scene);
    discretization_clear(&d);
}

/* How many contestants are chosen. */
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
    static const char *const words[] = {"thin_5", "map"};
    const struct stress_choice all = {0}, quick = {.quick = true},
                               some = {.word_count = 2, .words = words, .quick = true},
                               pair = {.models = "projective_dynamics,hex_incompatible"};
    struct message why = {""};

    for (int n = 0; stress_case_at(n); n++) {
        const struct stress_case *c = stress_case_at(n);
        CHECK(stress_choice_case(&all, c));
        CHECK(stress_choice_case(&quick, c) == c->quick);
        CHECK(stress_choice_case(&some, c) == !strcmp(c->item.name, "thin_5"));
    }
    CHECK(!strcmp(stress_case_items[0]->name, "map")); /* the cases are behind it */
    for (int n = 0; stress_case_at(n); n++)
        CHECK(&stress_case_at(n)->item == stress_case_items[n + 1]);
    CHECK(stress_choice_map(&all) && stress_choice_map(&quick) && stress_choice_map(&some));
    CHECK(!stress_choice_map(&(struct stress_choice){.word_count = 1, .words = words}));
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

/* A result, whatever it is, says all that its end asks for. */
static struct stress_result check_run(const char *path, const char *folder, const char *c,
                                      const char *contestant, enum stress_end want)
{
    const struct stress_job job = {.c = stress_fixture_case(c),
                                   .contestant = stress_fixture_contestant(contestant),
                                   .path = path,
                                   .folder = folder,
                                   .quick = true};
    struct stress_result r;

    REQUIRE(stress_judge(&job, &r, NULL) == STATUS_OK);
    CHECK(r.quick == (job.c->quick_end != NULL));
    r.quick = false; /* of the part that was run */
    const enum stress_end end = stress_result_end(&r, job.c->bound);
    if (!CHECK(end == want))
        printf("%s, %s: %s with error %g (%s)\n", c, contestant, stress_end_name[end],
               r.error, r.sentence.text);
    if (end == STRESS_REFUSED || end == STRESS_DIED)
        CHECK(*r.sentence.text && isnan(r.error));
    if (end == STRESS_DIED)
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
        {"thin_5", "iga_reduced", STRESS_ACCURATE},
        {"thin_5", "iga_selective", STRESS_ACCURATE},
        {"thin_5", "iga_nonlinear", STRESS_DEGRADED}, /* locks */
        {"thin_5", "hex_nonlinear", STRESS_DEGRADED},
        {"poisson_04999", "iga_reduced", STRESS_ACCURATE},
        {"poisson_04999", "iga_nonlinear", STRESS_DEGRADED},
        {"folded_knots", "iga_nonlinear", STRESS_REFUSED},
        {"folded_knots", "shell", STRESS_REFUSED},
        {"folded_knots", "mass_spring", STRESS_REFUSED},
        {"torn_knots", "iga_nonlinear", STRESS_REFUSED},
        {"one_element", "iga_nonlinear", STRESS_DEGRADED}, /* a parabola for a quartic */
        {"millimetres", "iga_reduced", STRESS_ACCURATE},
        {"inches", "mass_spring", STRESS_ACCURATE},
        {"soft", "shell", STRESS_ACCURATE},
        {"stiff", "iga_paper", STRESS_ACCURATE},
        {"spinning_bar", "shell", STRESS_ACCURATE},
        {"spinning_bar", "mass_spring", STRESS_DEGRADED}, /* implicit Euler */
        {"step_large", "iga_paper", STRESS_DEGRADED},
        {"swing_10000", "iga_paper", STRESS_REFUSED}, /* has no elastic energy */
        {"swing_10000", "iga_reduced", STRESS_ACCURATE},
        {"rest_start", "shell", STRESS_ACCURATE},
        {"rest_start", "projective_dynamics", STRESS_REFUSED},
        {"rest_start", "iga_paper", STRESS_DIED}, /* creeps */
        {"thrown", "shell_2", STRESS_ACCURATE},
        {"buckling", "mass_spring", STRESS_ACCURATE},
    };

    for (size_t n = 0; n < sizeof known / sizeof *known; n++)
        check_run(path, folder, known[n].c, known[n].contestant, known[n].want);
}

/* Statics of `printed` are linear: one parabola gives 2/3 of the tip, Gamma / 12 for
 * Gamma / 8, but for shear, (h/L)^2 of it. */
static void check_parabola(const char *path, const char *folder)
{
    const double TOL_SHEAR = 1e-3;
    const struct stress_result r =
        check_run(path, folder, "one_element", "iga_paper", STRESS_DEGRADED);

    CHECK_NEAR(r.error, 1 / 3., TOL_SHEAR);
}

/* The map of two models: each spot is one of the words, the finest steps are references,
 * and implicit Euler's longest step is told from its finest. */
static void check_map(const char *folder)
{
    const struct stress_choice pair = {.models = "shell_2,mass_spring", .quick = true};
    bool there = false;
    char path[512], line[256];
    int lines = 0, references = 0, degraded = 0;
    struct message why = {""};
    FILE *null = fopen("/dev/null", "w");

    REQUIRE(null);
    for (int n = 0; n < 2; n++) /* the second does not go on with the first */
        REQUIRE(stress_map_measure(folder, &pair, 2, &why) == STATUS_OK);
    REQUIRE(stress_map_print(folder, TABLE_TEXT, null, &there, &why) == STATUS_OK);
    CHECK(there);
    fclose(null);
    snprintf(path, sizeof path, "%s/map/stability.csv", folder);
    FILE *csv = fopen(path, "r");
    REQUIRE(csv && fgets(line, sizeof line, csv));
    while (fgets(line, sizeof line, csv)) {
        lines++;
        references += strstr(line, ",reference,") != NULL;
        degraded += !strncmp(line, "mass_spring,1e8,0.1,degraded,", 29);
        CHECK(strstr(line, ",accurate,") || strstr(line, ",degraded,") ||
              strstr(line, ",died,") || strstr(line, ",1e-3,reference,"));
    }
    fclose(csv);
    CHECK(lines == 4 * 3 * 3 && references == 4 * 3 && degraded == 1);
}

int main(int argc, char **argv)
{
    char *path = NULL;

    REQUIRE(argc == 3);
    REQUIRE(scene_file_find(stress_case_scene, &path, NULL) == STATUS_OK);
    if (!strcmp(argv[1], "unit")) {
        check_ends();
        check_choice();
        check_file(argv[2]);
        check_broken(argv[2]);
        for (int n = 0; stress_case_at(n); n++)
            check_case(stress_case_at(n), path);
    } else {
        check_runs(path, argv[2]);
        check_parabola(path, argv[2]);
        check_map(argv[2]);
    }
    free(path);
    return check_result();
}
