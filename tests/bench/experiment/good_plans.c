/* Good plans are taken apart into cases, ranges, values, studies, stand-ins. */
#include "tests/plan_fixture.h"

/* A study has its own keys, and others of the plan. */
static void check_studies(void)
{
    struct plan plan;
    struct plan_case c;
    struct message why = {""};

    if (!CHECK(read_plan(STUDIES, STUDY_LINES, 0, "", &plan, &why) == STATUS_OK)) {
        printf("%s\n", why.text);
        return;
    }
    const struct plan_study *edge = &plan.studies[0], *corners = &plan.studies[1];
    REQUIRE(plan.study_count == 2 && corners->level_count == 2);
    CHECK(edge->truth && !corners->truth && edge->timed == 3 && corners->timed == 3);
    CHECK(edge->time_count == 2 && edge->times[1] == 0.2);
    CHECK(corners->time_count == 1 && corners->times[0] == 0.05);
    CHECK(corners->levels[0].size == 0.3 && !strcmp(corners->levels[1].name, "9x9x2"));
    CHECK(!strcmp(edge->caption, "edge"));
    for (int quick = 0; quick < 2; quick++) {
        REQUIRE(plan_case_level(&plan, corners, &corners->levels[1], quick, &c, &why) ==
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
    struct plan plan;

    REQUIRE(read_plan(STUDIES, STUDY_LINES, STUDY_LINES + 1, "quick_times: [0.05]", &plan,
                      NULL) == STATUS_OK);
    CHECK(plan.studies[0].quick_count == 1 && plan.studies[0].quick_times[0] == 0.05);
    CHECK(plan.studies[1].quick_count == 0);
    plan_clear(&plan);
}

/* Levels are products of axes, the last changing fastest, and have what a part has. */
static void check_products(void)
{
    static const char *const text[] = {
        "name: products",
        "source: a test",
        "scene: edge_drop",
        "times: []",
        "axes: {net: {A: {size: 0.3, timed: 5}, B: {paper_ms: 7}},",
        "       step: {1 s: {}, 2 s: {phases: true}}}",
        "skip: [{net: A, step: 1 s}, {net: B, step: 2 s, quick: true}]"};
    struct plan plan;

    REQUIRE(read_plan(text, 7, 0, "", &plan, NULL) == STATUS_OK);
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

/* A name is the same in both quotes and in none, wherever a plan may have it. */
static void check_quotes(void)
{
    static const struct {
        const char *const *good;
        int lines, line;
        const char *format;
    } places[] = {
        {GOOD, LINES, 3, "scene: %sedge_drop%s"},
        {GOOD, LINES, 4, "model: %siga%s"},
        {GOOD, LINES, 7, "  case: {a: {scene: %sedge_drop%s, model: %siga%s}}"},
        {STUDIES, STUDY_LINES, 3, "scene: %sedge_drop%s"},
        {STUDIES, STUDY_LINES, 11, "  edge: {scene: %sedge_drop%s, model: %siga%s}"},
        {STUDIES, STUDY_LINES, 5, "  5x5x2: {model: %siga%s},"},
    };
    static const char *const quotes[] = {"", "\"", "'"};

    for (size_t n = 0; n < sizeof places / sizeof *places * 3; n++) {
        const char *quote = quotes[n % 3];
        struct plan plan;
        struct plan_case c;
        struct message why = {""};
        char text[256];

        snprintf(text, sizeof text, places[n / 3].format, quote, quote, quote, quote);
        if (!CHECK(read_plan(places[n / 3].good, places[n / 3].lines, places[n / 3].line,
                             text, &plan, &why) == STATUS_OK)) {
            printf("  %s: %s\n", text, why.text);
            continue;
        }
        REQUIRE(plan_case_level(&plan, plan.studies, plan.studies->levels, false, &c,
                                &why) == STATUS_OK);
        CHECK(strstr(c.run.path, "edge_drop.yaml") &&
              !strcmp(c.run.contestant->name, "iga"));
        plan_case_clear(&c);
        plan_clear(&plan);
    }
}

/* A study at rest has no truth and is not timed unless it says so. */
static void check_bare_study(void)
{
    static const char *const text[] = {"name: bare", "source: a test", "scene: edge_drop",
                                       "axes: {net: {\"Some Net, p = 2\": {}}}",
                                       "times: []"};
    struct plan plan;

    REQUIRE(read_plan(text, 5, 0, "", &plan, NULL) == STATUS_OK);
    const struct plan_study *s = &plan.studies[0];
    CHECK(plan.study_count == 1 && !strcmp(s->name, "bare") &&
          !strcmp(s->caption, "a test"));
    CHECK(s->time_count == 0 && s->truth == 0 && s->timed == 0 && s->quick_count == 0);
    CHECK(isnan(s->levels[0].paper_ms) && s->levels[0].size == 0);
    CHECK(!strcmp(s->levels[0].name, "some_net_p_2") && s->levels[0].phases == 0);
    plan_clear(&plan);
}

/* The combinations in their order, and Gamma by E. */
static void check_good(void)
{
    static const char *const dampings[] = {"0.1", "0.5"};
    static const double gammas[] = {10, 100, 1000};
    struct plan plan;
    struct message why = {""};
    const double tol_gamma = 1e-13; /* a square root and back */

    if (!CHECK(read_plan(GOOD, LINES, 0, "", &plan, &why) == STATUS_OK)) {
        printf("%s\n", why.text);
        return;
    }
    CHECK(plan_case_count(&plan) == 12 && plan.look == 5 && plan.time_limit == 10);
    CHECK(plan.intersections == 1 && plan.keep == PLAN_KEEP_SNAPSHOTS);
    for (int n = 0; n < 12; n++) {
        struct plan_case c;
        struct scene scene;

        REQUIRE(plan_case_level(&plan, plan.studies, &plan.studies->levels[n], false, &c,
                                &why) == STATUS_OK);
        REQUIRE(plan_case_scene(&c, &scene, &why) == STATUS_OK);
        CHECK(!strcmp(plan_label(c.study, c.level, "case"), n < 6 ? "a" : "b"));
        CHECK(scene.poisson == (n < 6 ? 0.3 : 0.2) && scene.end == 0.5);
        CHECK_RELATIVE(scene_gamma(&scene), gammas[n / 2 % 3], tol_gamma);
        CHECK(scene.damping.value == strtod(dampings[n % 2], NULL));
        CHECK((scene.thickness == 0.02) == (n < 6) &&
              !strcmp(c.run.contestant->name, "iga"));
        scene_clear(&scene);
        plan_case_clear(&c);
    }
    plan_clear(&plan);
}

/* From ... to, in the fewest digits that are the number. */
static void check_ranges(void)
{
    static const struct {
        const char *axis;
        int count;
        const char *values[5];
    } ranges[] = {
        {"{from: 0.1, to: 0.9, count: 3}", 3, {"0.1", "0.5", "0.9"}},
        {"{from: 1, to: 0, count: 4}",
         4,
         {"1", "0.6666666666666667", "0.33333333333333337", "0"}},
        {"{from: 0.01, to: 1, count: 5, scale: log}",
         5,
         {"0.01", "0.0316227766016838", "0.1", "0.31622776601683794", "1"}},
        {"{from: 0.1, to: 0.3, count: 2, scale: linear}", 2, {"0.1", "0.3"}},
    };

    for (size_t n = 0; n < sizeof ranges / sizeof *ranges; n++) {
        struct plan plan;
        char line[128];
        snprintf(line, sizeof line, "  damping.value: %s", ranges[n].axis);
        REQUIRE(read_plan(GOOD, LINES, 9, line, &plan, NULL) == STATUS_OK);
        const struct plan_axis *axis = &plan.studies->axis[2];
        REQUIRE(axis->count == ranges[n].count && axis->line == 9);
        for (int i = 0; i < axis->count; i++)
            if (!CHECK(!strcmp(axis->levels[i].label, ranges[n].values[i])))
                printf("  %s: %s\n", ranges[n].axis, axis->levels[i].label);
        plan_clear(&plan);
    }
}

/* Values of many parts, in one line as --set takes them. */
static void check_values(void)
{
    static const struct {
        const char *key, *value;
    } want[] = {{"a", "[{at: {u: 0, w: 1}, fix: xyz}]"},
                {"b", "{kind: mass, value: [1,2,[3]]}"},
                {"c", "'it''s: so'"},
                {"d", "plain"}};
    struct plan plan;
    struct message why = {"of another file"};
    FILE *file = fopen(path, "w");

    REQUIRE(file);
    fputs("name: values\nsource: a test\nsettings:\n  a: [{at: {u: 0, w: 1}, fix: xyz}]\n"
          "  b:\n    kind: mass\n    value: [1, 2, [3]]\n  c: \"it's: so\"\n  d: plain\n"
          "axes: {e: [1]}\n",
          file);
    REQUIRE(fclose(file) == 0);
    if (!CHECK(plan_parse(path, &plan, &why) == STATUS_OK))
        printf("%s\n", why.text);
    CHECK(!*why.text); /* nothing is left of what was wrong before */
    REQUIRE(plan.settings.count == 4);
    for (int n = 0; n < 4; n++)
        if (!CHECK(!strcmp(plan.settings.list[n].key, want[n].key) &&
                   !strcmp(plan.settings.list[n].value, want[n].value)))
            printf("  %s is %s\n", plan.settings.list[n].key, plan.settings.list[n].value);
    plan_clear(&plan);
}

/* A stand-in wherever it stands among the keys: first, here. */
static void check_first(void)
{
    static const char *const text[] = {"name: first", "source: a test",
                                       "settings: {gamma: 100}",
                                       "axes: {scene: [edge_drop], damping.value: [0.5]}"};
    struct plan plan;
    struct plan_case c;
    struct scene scene;
    const double tol_gamma = 1e-13;

    REQUIRE(read_plan(text, 4, 0, "", &plan, NULL) == STATUS_OK);
    CHECK(!strcmp(plan.keys[0], "gamma"));
    REQUIRE(plan_case_level(&plan, plan.studies, plan.studies->levels, false, &c, NULL) ==
            STATUS_OK);
    REQUIRE(plan_case_scene(&c, &scene, NULL) == STATUS_OK);
    CHECK_RELATIVE(scene_gamma(&scene), 100.0, tol_gamma);
    scene_clear(&scene);
    plan_case_clear(&c);
    plan_clear(&plan);
}

/* Nobody's line, so the first. */
static void check_many(void)
{
    struct plan plan;
    struct message why = {""};

    CHECK(read_plan(GOOD, LINES, 9,
                    "  damping.value: [0.1, 0.5]\n"
                    "  time.step: {from: 0.001, to: 0.002, count: 10000}",
                    &plan, &why) == STATUS_INPUT);
    CHECK(strstr(why.text, ".yaml:1: the plan has more than 100000 cases"));
}

int main(void)
{
    scratch_open();
    path = scratch_path("plan.yaml");
    check_good();
    check_ranges();
    check_values();
    check_first();
    check_studies();
    check_quick_times();
    check_products();
    check_quotes();
    check_bare_study();
    check_many();
    return check_result();
}
