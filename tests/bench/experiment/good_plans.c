/* Good plans are taken apart into studies, levels and values. (Cases, ranges, stand-ins:
 * commands/sweep.cases.) */
#include "tests/plan_fixture.h"
#include "tests/scratch.h"

static const char *path;

#define STUDIES                                                                            \
    "name: studies\nsource: a test\nscene: edge_drop\n"                                    \
    "axes: {level: {\n"                                                                    \
    "  5x5x2: {size: 0.3, discretization.points: [5,5,2]},\n"                              \
    "  9x9x2: {discretization.points: [9,9,2], quick: {time.step: 0.01}}}}\n"              \
    "times: [0.1, 0.2]\ntruth: true\ntimed: 3\n"                                           \
    "studies:\n  edge: {}\n"                                                               \
    "  corners: {scene: corners_drop, truth: false, times: [0.05]}\n"

/* A study has its own keys, and others of the plan. */
static void check_studies(void)
{
    struct plan plan = plan_of(path, STUDIES);
    struct plan_case c;

    const struct plan_study *edge = &plan.studies[0], *corners = &plan.studies[1];
    REQUIRE(plan.study_count == 2 && corners->level_count == 2);
    CHECK(edge->truth && !corners->truth && edge->timed == 3 && corners->timed == 3);
    CHECK(edge->time_count == 2 && edge->times[1] == 0.2);
    CHECK(corners->time_count == 1 && corners->times[0] == 0.05);
    CHECK(corners->levels[0].size == 0.3 && !strcmp(corners->levels[1].name, "9x9x2"));
    CHECK(!strcmp(edge->caption, "edge"));
    for (int quick = 0; quick < 2; quick++) {
        REQUIRE(plan_case_level(&plan, corners, &corners->levels[1], quick, &c, NULL) ==
                STATUS_OK);
        CHECK(!strcmp(settings_value(&c.run.settings, "discretization.points"), "[9,9,2]"));
        CHECK(!settings_value(&c.run.settings, "time.step") == !quick);
        CHECK(strstr(c.run.path, "corners_drop.yaml"));
        plan_case_clear(&c);
    }
    plan_clear(&plan);
}

/* A study with times of its own has none of the plan's for a quick run. */
static void check_quick_times(void)
{
    struct plan plan = plan_of(path, STUDIES "quick_times: [0.05]\n");

    CHECK(plan.studies[0].quick_count == 1 && plan.studies[0].quick_times[0] == 0.05);
    CHECK(plan.studies[1].quick_count == 0);
    plan_clear(&plan);
}

/* Levels are products of axes, the last changing fastest, and have what a part has. */
static void check_products(void)
{
    struct plan plan =
        plan_of(path, "name: products\nsource: a test\nscene: edge_drop\ntimes: []\n"
                      "axes: {net: {A: {size: 0.3, timed: 5}, B: {paper_ms: 7}},\n"
                      "       step: {1 s: {}, 2 s: {phases: true}}}\n"
                      "skip: [{net: A, step: 1 s}, {net: B, step: 2 s, quick: true}]\n");
    const struct plan_level *level = plan.studies->levels;
    REQUIRE(plan.studies->level_count == 3);
    CHECK(!strcmp(level[0].label, "A, 2 s") && !strcmp(level[0].name, "a_2_s"));
    CHECK(level[0].size == 0.3 && level[0].timed == 5 && isnan(level[0].paper_ms));
    CHECK(level[0].phases == 1 && level[1].phases == 0);
    CHECK(!strcmp(level[1].label, "B, 1 s") && level[1].size == 0);
    CHECK(level[1].timed == -1 && level[1].paper_ms == 7);
    CHECK(!level[0].slow && !level[1].slow && level[2].slow);
    plan_clear(&plan);
}

/* A study at rest has no truth and is not timed unless it says so. */
static void check_bare_study(void)
{
    struct plan plan = plan_of(path, "name: bare\nsource: a test\nscene: edge_drop\n"
                                     "axes: {net: {\"Some Net, p = 2\": {}}}\ntimes: []\n");
    const struct plan_study *s = &plan.studies[0];
    CHECK(plan.study_count == 1 && !strcmp(s->name, "bare") &&
          !strcmp(s->caption, "a test"));
    CHECK(s->time_count == 0 && s->truth == 0 && s->timed == 0 && s->quick_count == 0);
    CHECK(isnan(s->levels[0].paper_ms) && s->levels[0].size == 0);
    CHECK(!strcmp(s->levels[0].name, "some_net_p_2") && s->levels[0].phases == 0);
    plan_clear(&plan);
}

/* Values of many parts, in one line as --set takes them. */
static void check_values(void)
{
    static const struct {
        const char *key, *value;
    } want[] = {{"scene", "edge_drop"},
                {"supports", "[{at: {u: 0, w: 1}, fix: xyz, path: [[0,0,0,0],[1,0,0,1]]}]"},
                {"damping", "{kind: mass, value: 1}"},
                {"about", "'it''s: so'"},
                {"time.end", "0.5"},
                {"model", "iga"}};
    struct plan plan =
        plan_of(path, "name: values\nsource: a test\nscene: edge_drop\nsettings:\n"
                      "  supports: [{at: {u: 0, w: 1}, fix: xyz, path: [[0, 0, 0, 0],\n"
                      "    [1, 0, 0, 1]]}]\n"
                      "  damping:\n    kind: mass\n    value: 1\n  about: \"it's: so\"\n"
                      "  time.end: 0.5\naxes: {time.step: [0.005]}\n");

    REQUIRE(plan.settings.count == 6);
    for (int n = 0; n < 6; n++)
        CHECK_SAY(!strcmp(plan.settings.list[n].key, want[n].key) &&
                      !strcmp(plan.settings.list[n].value, want[n].value),
                  "%s is %s", plan.settings.list[n].key, plan.settings.list[n].value);
    plan_clear(&plan);
}

int main(void)
{
    scratch_open();
    path = scratch_path("plan.yaml");
    check_values();
    check_studies();
    check_quick_times();
    check_products();
    check_bare_study();
    return check_result();
}
