/* A sheet that is held everywhere is a legal one, with no unknown at all: it stays where it
 * was, in every model and kinematics, moving, at rest and over an obstacle; it has no
 * modes, and that is a sentence.
 */
#include "bench/harness/contestant.h"
#include "models/reader/scene_file.h"
#include "tests/opened_run.h"

/* Positions are sums over a basis that is one up to its round-off. */
static const double ROUND_OFF = 1e-15;

static const double still[3] = {0};

static void check_stays(const struct contestant *c, const char *scene, const char *supports)
{
    struct settings settings = {0};
    struct run_plan plan = {.contestant = c, .settings = &settings};
    struct counters work = {0};
    struct message why = {""};
    struct run run;
    char *path = NULL;

    REQUIRE(scene_file_find(scene, &path, NULL) == STATUS_OK);
    plan.path = path;
    settings_word(&settings, "supports", supports);
    contestant_points(c, contestant_least(c), contestant_least(c), &settings);
    if (!CHECK(run_open(&run, &plan, &why) == STATUS_OK))
        printf("%s on %s: %s\n", c->name, scene, why.text);
    for (int n = 0; run.state && n < 5; n++)
        CHECK(run.model->advance(run.state, &work) == STATUS_OK);
    CHECK(!run.state || opened_deviation(&run, still) <= ROUND_OFF);
    if (run.state && run.model->equilibrium && !run.scene.obstacle_count) {
        CHECK(run_settle(&run, &work, &why) == STATUS_OK);
        CHECK(opened_deviation(&run, still) <= ROUND_OFF);
    }
    if (run.state && run.model->modes) {
        double omega;
        CHECK(run_modes(&run, 1, &omega, &why) == STATUS_INPUT && *why.text);
    }
    run_close(&run);
    settings_clear(&settings);
    free(path);
}

int main(void)
{
    static const char all[] = "[{at: {u: [0,1]}, fix: xyz}]";
    static const char ends[] = "[{at: {u: 0}, fix: xyz}, {at: {u: 1}, fix: xyz}]";

    for (const struct contestant *c = contestant_table; c->name; c++) {
        check_stays(c, "edge_drop", all);
        if (c->settings[0] && strstr(c->settings[0], "linear"))
            check_stays(c, "ground", all);
        if (c->degree == 1)
            check_stays(c, "edge_drop", ends);
    }
    return check_result();
}
