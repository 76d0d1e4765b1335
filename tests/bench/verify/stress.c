/* Tests hard cases as data. (Verdicts that are known beforehand:
 * commands/stress.cases.) */
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
    CHECK_SAY(st == (refused ? STATUS_INPUT : STATUS_OK), "%s: %s", item->name, why.text);
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

int main(void)
{
    char *path = NULL;

    REQUIRE(scene_file_find(stress_scene, &path, NULL) == STATUS_OK);
    check_choice();
    for (int n = 0; stress_checks[n]; n++)
        check_case(n, path);
    free(path);
    return check_result();
}
