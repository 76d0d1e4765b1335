/* Tests hard cases. unit: the cases as data; run: verdicts that are known beforehand. */
#include "bench/verify/checks/stress.h"

#include "models/reader/scene_file.h"
#include "tests/check.h"

static const struct stress_case *case_at(int n)
{
    return (const struct stress_case *)stress_checks[n];
}

/* Checks that a case can be read and says all that it needs; otherwise all models would
 * refuse it. */
static void check_case(int at, const char *path)
{
    const struct stress_case *c = case_at(at);
    const struct command_item *item = &c->check.item;
    struct scene scene = {0};
    struct discretization d = {0};
    struct message why = {""};
    int count = 0;

    while (count < STRESS_SETTINGS && c->physics[count])
        count++;
    const bool refused = !strcmp(item->name, "overlapping"); /* as it should be */
    const enum status st = scene_file_read(path, count, c->physics, &scene, &d, &why);
    if (!CHECK(st == (refused ? STATUS_INPUT : STATUS_OK)))
        printf("%s: %s\n", item->name, why.text);
    CHECK(c->field.tolerance > 0 && *c->check.source && *item->text && c->truth);
    CHECK(c->gamma <= 0 || scene_gamma(&scene) > 0);
    CHECK(c->truth != &stress_similar || (c->length > 0 && c->mass > 0 && c->time > 0));
    CHECK(strspn(item->name, "abcdefghijklmnopqrstuvwxyz0123456789_") ==
          strlen(item->name));
    for (int n = 0; n < at; n++)
        CHECK(strcmp(stress_checks[n]->item.name, item->name));
    CHECK(stress_items[at] == item);
    scene_clear(&scene);
    discretization_clear(&d);
}

/* Checks who takes part: all that enter, or those that are named. */
static void check_choice(void)
{
    static const struct {
        const char *models;
        int count;
    } known[] = {{"projective_dynamics,hex_incompatible", 3}, {"iga_linear", 1}, {NULL, 0}};
    struct verify_subject all[VERIFY_MOST];

    for (size_t n = 0; n < sizeof known / sizeof *known; n++) {
        struct verify_sheet sheet = {
            .check = stress_checks[0], .models = known[n].models, .quick = n % 2};
        const int count = verify_sheet_subjects(&sheet, &case_at(0)->field, all);
        CHECK(known[n].models ? count == known[n].count : count >= 10);
        CHECK(all[0].nets == 1 && all[0].along[0] == 10 && all[0].across[0] == 10);
    }
}

/* Runs a case and checks its verdict, and that a refusal or a death says why. */
static double check_run(const char *folder, const char *name, const char *contestant,
                        enum verdict want)
{
    struct verify_sheet sheet = {.folder = folder, .models = contestant};
    struct verify_subject all[VERIFY_MOST];
    int n = 0, k = 0;

    while (stress_checks[n] && strcmp(stress_checks[n]->item.name, name))
        n++;
    REQUIRE(stress_checks[n]);
    sheet.check = stress_checks[n];
    const int count = verify_sheet_subjects(&sheet, &case_at(n)->field, all);
    while (k < count && strcmp(all[k].contestant->name, contestant))
        k++;
    if (k == count)
        printf("%s, %s: does not enter\n", name, contestant);
    REQUIRE(k < count);
    stress_add_row(&all[k]);
    REQUIRE(sheet.status == STATUS_OK && sheet.count == 1);
    const struct verify_row row = *sheet.rows;
    if (!CHECK(row.verdict == want))
        printf("%s, %s: %s with error %g (%s)\n", name, contestant,
               verdict_word(row.verdict), row.error, row.note);
    if (case_at(n)->truth == &stress_contact || case_at(n)->truth == &stress_slide)
        CHECK(*row.note); /* nothing passes through unannounced */
    if (want == VERDICT_NOT_APPLICABLE || want == VERDICT_DIED)
        CHECK(*row.note && isnan(row.error));
    if (want == VERDICT_DIED)
        CHECK(isfinite(row.until));
    verify_sheet_clear(&sheet);
    return row.error;
}

static void check_runs(const char *folder)
{
    static const struct {
        const char *c, *contestant;
        enum verdict want;
    } known[] = {
        {"still", "iga_paper", VERDICT_MET},
        {"still", "iga_nonlinear", VERDICT_MET},
        {"still", "hex_incompatible", VERDICT_MET},
        {"still", "shell_2", VERDICT_MET},
        {"still", "mass_spring", VERDICT_MET},
        {"still", "projective_dynamics", VERDICT_MET},
        {"thin_5", "iga_selective", VERDICT_MET},
        {"thin_5", "iga_nonlinear", VERDICT_MISSED}, /* locks */
        {"thin_5", "hex_nonlinear", VERDICT_MISSED},
        {"poisson_04999", "iga_selective", VERDICT_MET},
        {"poisson_04999", "iga_nonlinear", VERDICT_MISSED},
        {"folded_knots", "iga_nonlinear", VERDICT_NOT_APPLICABLE},
        {"folded_knots", "shell_2", VERDICT_NOT_APPLICABLE},
        {"folded_knots", "mass_spring", VERDICT_NOT_APPLICABLE},
        {"torn_knots", "iga_nonlinear", VERDICT_NOT_APPLICABLE},
        {"one_element", "iga_nonlinear", VERDICT_MISSED}, /* a parabola for a quartic */
        {"millimetres", "iga_selective", VERDICT_MET},
        {"inches", "mass_spring", VERDICT_MET},
        {"soft", "shell_2", VERDICT_MET},
        {"stiff", "iga_paper", VERDICT_MET},
        {"spinning_bar", "shell_2", VERDICT_MET},
        {"spinning_bar", "mass_spring", VERDICT_MISSED}, /* implicit Euler */
        {"step_large", "iga_paper", VERDICT_MISSED},
        {"swing_10000", "iga_paper", VERDICT_NOT_APPLICABLE}, /* has no elastic energy */
        {"swing_10000", "mass_spring_leapfrog", VERDICT_MET},
        {"rest_start", "shell_2", VERDICT_MET},
        {"rest_start", "projective_dynamics", VERDICT_NOT_APPLICABLE},
        {"rest_start", "iga_paper", VERDICT_DIED}, /* creeps */
        {"thrown", "shell_2", VERDICT_MET},
        {"buckling", "mass_spring", VERDICT_MET},
        {"touching", "iga_selective", VERDICT_MET},
        {"overlapping", "triangles", VERDICT_NOT_APPLICABLE},
        {"coplanar", "shell_2", VERDICT_MET},
        {"closing", "hex_nonlinear", VERDICT_MET},
        {"crushed", "mass_spring_leapfrog", VERDICT_MET}, /* two walls, no room */
        {"crushed", "position_based", VERDICT_MET},
        {"stopping", "projective_dynamics", VERDICT_MET},
        {"struck", "shell_2", VERDICT_MET},
        {"struck", "mass_spring", VERDICT_MET},
        {"struck", "projective_dynamics", VERDICT_MET},
        {"struck", "position_based", VERDICT_MET},
        {"thrown_at_ball", "triangles", VERDICT_MET},
        {"pressed_fold", "mass_spring_leapfrog", VERDICT_MET},
        {"thick_contact", "triangles", VERDICT_MET},
        {"friction_0", "shell_2", VERDICT_MET},
        {"friction_5", "position_based", VERDICT_MET},
        {"needles", "mass_spring", VERDICT_MET},
        {"flat_triangle", "iga_nonlinear", VERDICT_NOT_APPLICABLE},
    };

    for (size_t n = 0; n < sizeof known / sizeof *known; n++)
        check_run(folder, known[n].c, known[n].contestant, known[n].want);
}

/* Checks one parabola in the linear statics of `printed`: it gives 2/3 of the tip, Gamma /
 * 12 for Gamma / 8, but for shear, (h/L)^2 of it. */
static void check_parabola(const char *folder)
{
    const double TOL_SHEAR = 1e-3;
    const double error = check_run(folder, "one_element", "iga_paper", VERDICT_MISSED);

    CHECK_NEAR(error, 1 / 3., TOL_SHEAR);
}

int main(int argc, char **argv)
{
    char *path = NULL;

    REQUIRE(argc == 3);
    REQUIRE(scene_file_find(stress_scene, &path, NULL) == STATUS_OK);
    if (!strcmp(argv[1], "unit")) {
        check_choice();
        for (int n = 0; stress_checks[n]; n++)
            check_case(n, path);
    } else {
        check_runs(argv[2]);
        check_parabola(argv[2]);
    }
    free(path);
    return check_result();
}
