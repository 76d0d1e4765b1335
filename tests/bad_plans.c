#define _DEFAULT_SOURCE /* mkstemps */
/* Malformed plans: each is refused with one sentence at the right line; and what a good one
 * is taken apart into. */
#include <stdlib.h>
#include <unistd.h>

#include "bench/experiment/plan_case.h"
#include "bench/experiment/plan_read.h"
#include "bench/harness/derived_key.h"
#include "tests/check.h"

/* A good plan; the rows below replace one of its lines, counted from 1, or add one. */
static const char *const GOOD[] = {
    "name: good",
    "source: a test",
    "scene: edge_drop",
    "model: iga",
    "settings: {time.end: 0.5, discretization.points: [6,6,2]}",
    "axes:",
    "  - {key: gamma, from: 10, to: 1000, count: 3, scale: log, by: sheet.thickness}",
    "  - {key: damping.value, values: [0.1, 0.5]}",
    "cases: [{name: a, material.young: 1e5}, {material.poisson: 0.2}]",
    "look: 5",
    "intersections: true",
    "keep: snapshots",
    "time_limit: 10",
    "verdicts: [{label: big, measure: drop_max, above: 1, why: a test}]",
    "map: {x: gamma, y: damping.value}",
};
enum { LINES = sizeof GOOD / sizeof *GOOD };

struct wrong {
    int line; /* replaced; beyond the last: added */
    const char *text, *part;
};
static const struct wrong BAD[] = {
    {1, "name: Good plan", "name is 'Good plan', but must be 1 to 64 of the characters"},
    {1, "nam: good", "the plan has no key 'nam'; did you mean 'name'?"},
    {1, "name: [good]", "name is a list of 1, but must be a line of text"},
    {3, "scene: nowhere", "no scene 'nowhere'; give the path of a file, or one of"},
    {3, "scene: ./nowhere.yaml", "cannot be read as a scene: No such file"},
    {3, "scene: [edge_drop]", "scene is a list of 1, but must be the name or the path"},
    {4, "model: ibm", "no model 'ibm'; models: iga"},
    {5, "settings: 5", "settings is '5', but must be a map {KEY: VALUE, ...}"},
    {5, "settings: {material.density: heavy}", "density is 'heavy', but must be a number"},
    {5, "settings: {material.colour: red}", "has no key 'colour'"},
    {5, "settings: {discretization.degree: [9,9,1]}", "degree holds '9', but must be"},
    {5, "settings: [{time.end: 1}, {time.end: 2}]", "settings has 'time.end' already"},
    {5, "settings: {\"material.young=5e4 #\": 3}", "is no key that --set could take"},
    {5, "settings: {\"material.young\\n\": 3}", "is no key that --set could take"},
    {5, "settings: {\"\": 3}", "'' is no key that --set could take"},
    {8, "  - {key: damping.value=2, values: [1]}", "'damping.value=2' is no key that"},
    {8, "  - {key: \"damping\\r\", values: [1]}", "key is 'damping?' in quotes, but must"},
    {5, "settings: {time.end: \"1\\n2\"}",
     "time.end' is '1?2' in quotes, but must be a value in one"},
    {5, "settings: {time.end: }", "but must be a value in one line"},
    {5, "settings: {look: 3}", "has no key 'look'"},
    {5, "settings: {sheet.thickness: 0.01}", "also set by gamma in line 7"},
    {7, "  - {from: 10, to: 1000, count: 3}",
     "an axis lacks the key 'key', a line of text"},
    {7, "  - {key: gamma, from: 10, to: 1000}", "needs either values or all of from, to"},
    {7, "  - {key: gamma, from: 1, to: 2, count: 3, values: [1]}",
     "needs either values or"},
    {7, "  - {key: gamma, from: 1, to: 2, count: 1}", "count is '1', but must be a whole"},
    {7, "  - {key: gamma, from: 0, to: 2, count: 3, scale: log}", "both must be above 0"},
    {7, "  - {key: gamma, from: 1, to: 2, count: 3, scale: cubic}", "one of linear, log"},
    {7, "  - {key: gamma, values: []}", "values is an empty list, but must be a list of 1"},
    {7, "  - {key: gamma, values: [1, -1], by: sheet.thickness}",
     "must be a number above 0"},
    {7, "  - {key: gamma, values: [1, x], by: sheet.thickness}",
     "gamma is 'x', but must be"},
    {7, "  - {key: gamma, values: [1], by: sheet.width}", "gamma cannot be set by sheet.w"},
    {7, "  - {key: gamma, values: [1e-30], by: sheet.thickness}", "thickness is '"},
    {7, "  - {key: time.step, values: [1], by: time.end}",
     "only gamma and young_over_dens"},
    {8, "  - {key: damping.value, values: [0.1, -3]}",
     "value is '-3', but must be a number"},
    {8, "  - {key: damping.value, values: {a: 1}}",
     "values is a section, but must be a list"},
    {8, "  - {key: gamma, values: [3]}", "the key 'gamma' is given in line 7, too"},
    {8, "  - {key: time.end, values: [3]}", "the key 'time.end' is given in line 5, too"},
    {8, "  - {key: material.young, values: [1]}",
     "'material.young' is given in line 9, too"},
    {8, "  - {key: scene, values: [edge_drop]}", "the key 'scene' is given in line 3, too"},
    {9, "cases: []", "cases is an empty list, but must be a list of 1 to 10000"},
    {9, "cases: [5]", "a case is '5', but must be a map {KEY: VALUE}"},
    {9, "cases: [{name: [a]}]", "name is a list of 1, but must be a line of text"},
    {9, "cases: [{name: ''}]", "name is '' in quotes, but must be a line of text"},
    {9, "cases: [{name: \"a\\n!touch pwned\"}]", "name is 'a?!touch pwned' in quotes, but"},
    {9, "cases: [{name: \"a\\e[2J\"}]", "name is 'a?[2J' in quotes, but must be a line"},
    {9, "cases: [{name: \"a\\x9b2J\"}]", "name is 'a??2J' in quotes, but must be a line"},
    {9, "cases: [{material.poisson: 0.2}, {material.poisson: 0.5}]", "poisson is '0.5'"},
    {10, "look: 0", "look is '0', but must be a whole number from 1"},
    {11, "intersections: maybe",
     "intersections is 'maybe', but must be one of false, true"},
    {12, "keep: all", "keep is 'all', but must be one of none, snapshots"},
    {13, "time_limit: -1", "time_limit is '-1', but must be a number from 0.001"},
    {14, "verdicts: []", "verdicts is an empty list, but must be a list of 1"},
    {14, "verdicts: nowhere", "verdicts: no plan 'nowhere'; give the path"},
    {14, "verdicts: [{label: big, measure: size, above: 1, why: x}]", "measure is 'size'"},
    {15, "map: {x: gamma}", "map lacks the key 'y', a line of text"},
    {15, "map: {x: weather, y: gamma}", "the map shows 'weather', which is neither a key"},
    {15, "map: {x: gamma, y: weather}", "the map shows 'weather', which is neither a key"},
    {15, "map: {x: gamma, y: drop_max, marks: [5]}",
     "a mark is '5', but must be a section"},
    {15, "map: {x: gamma, y: damping.value, marks: [{text: a, label: b, at: {}}]}",
     "the mark 'a' lacks the key damping.value, which the map shows"},
    /* an unknown key, at every depth */
    {7, "  - {key: gamma, valus: [10, 100]}", "no key 'valus'; did you mean 'values'?"},
    {9, "cases: [{material.yung: 1e5}]", "has no key 'yung'; did you mean 'young'?"},
    {14, "verdicts: [{label: big, measure: drop_max, abov: 1, why: x}]",
     "no key 'abov'; did you mean 'above'?"},
    {15, "map: {x: gamma, y: drop_max, pannel: name}",
     "no key 'pannel'; did you mean 'panel'"},
    {15, "map: {x: gamma, y: drop_max, marks: [{txt: a, label: b, at: {}}]}",
     "no key 'txt'; did you mean 'text'?"},
    {15,
     "map: {x: damping.value, y: gamma, marks: [{text: a, label: b, at: {damping.value: "
     "1, material.colour: 1}}]}",
     "has no key 'colour'"},
    {16, "colour: red", "the plan has no key 'colour'"},
    {16, "look: 3", "key 'look' for the second time"},
    {16, "times: [0.1]", "times is for studies, but the plan has no levels"},
    {16, "truth: true", "truth is for studies, but the plan has no levels"},
    {16, "timed: 3", "timed is for studies, but the plan has no levels"},
    {16, "- x", "not YAML"},
};

/* Likewise of studies. */
static const char *const STUDIES[] = {
    "name: studies",
    "source: a test",
    "scene: edge_drop",
    "levels:",
    "  - {label: 5x5x2, size: 0.3, settings: {discretization.points: [5,5,2]}}",
    "  - {label: 9x9x2, settings: {discretization.points: [9,9,2]}, quick: {time.step: "
    "0.01}}",
    "times: [0.1, 0.2]",
    "truth: true",
    "timed: 3",
    "studies:",
    "  - {name: edge}",
    "  - {name: corners, scene: corners_drop, truth: false, times: [0.05]}",
};
enum { STUDY_LINES = sizeof STUDIES / sizeof *STUDIES };

static const struct wrong BAD_STUDIES[] = {
    {3, "scene: nowhere", "no scene 'nowhere'"},
    {5, "  - {size: 0.3}", "a level lacks the key 'label', a line of text"},
    {5, "  - {label: a, size: -1}", "size is '-1', but must be a number between 0 and"},
    {5, "  - {label: a, colour: red}", "has no key 'colour'"},
    {5, "  - {label: a, model: ibm}", "there is no model 'ibm'; models: iga"},
    {5, "  - {label: a, settings: 5}", "settings is '5', but must be a map {KEY: VALUE"},
    {5, "  - {label: a, settings: {discretization.degree: [9,9,1]}}", "degree holds '9'"},
    {5, "  - {label: a, settings: {material.colour: red}}", "has no key 'colour'"},
    {5, "  - {label: a, quick: {sheet.thickness: -1}}", "thickness is '-1'"},
    {5, "  - {label: a, name: A a}", "a level has the name 'A a', but must have 1 to 64"},
    {5, "  - {label: a, phases: maybe}", "phases is 'maybe', but must be one of false"},
    {6, "  - {label: 5X5X2}", "a level has the name '5x5x2' as another has"},
    {7, "times: 0.1", "times is '0.1', but must be a list of numbers"},
    {7, "times: [0.2, 0.1]", "times has 0.1 after 0.2, but must be increasing"},
    {7, "times: [0]", "times holds '0', but must be"},
    {7, "times: [0.1, 0.123]", "the time 0.123 s is no multiple of the step, 0.005 s, of"},
    {7, "times: [0.105]", "the time 0.105 s is no multiple of the step, 0.01 s, of the"},
    {8, "truth: shell", "truth is 'shell', but must be one of false, true"},
    {9, "timed: 0.5", "timed is '0.5', but must be a whole number from 0"},
    {9, "timed: yes", "timed is 'yes', but must be a whole number from 0"},
    {11, "  - {caption: edge}", "a study lacks the key 'name', a line of text"},
    {11, "  - {name: edge drop}", "a study has the name 'edge drop', but must have 1 to"},
    {12, "  - {name: edge}", "a study has the name 'edge' as another has"},
    {11, "  - {name: edge, times: []}", "has truth, but no times"},
    {11, "  - {name: edge, levels: []}",
     "levels is an empty list, but must be a list of 1"},
    {11, "  - {name: edge, scene: nowhere}", "no scene 'nowhere'"},
    {11, "  - {name: edge, settings: {time.end: x}}", "end is 'x', but must be a number"},
    /* an unknown key, at every depth */
    {5, "  - {label: a, setings: {time.end: 1}}",
     "no key 'setings'; did you mean 'settings'"},
    {5, "  - {label: a, quick: {material.yung: 1}}",
     "has no key 'yung'; did you mean 'young'"},
    {11, "  - {name: edge, captin: x}", "no key 'captin'; did you mean 'caption'?"},
    {11, "  - {name: edge, settings: {time.edn: 1}}",
     "has no key 'edn'; it knows step, end"},
    {11, "  - {name: edge, levels: [{label: a, sice: 1}]}",
     "no key 'sice'; did you mean 'size'?"},
    {11, "  - {name: edge, levels: [{label: a, settings: {sheet.depth: 1}}]}",
     "has no key 'depth'"},
    {13, "cases: [{name: a}]", "a plan with levels has no axes, cases and map"},
    {13, "axes: [{key: gamma, values: [1]}]", "a plan with levels has no axes, cases and"},
};

static char path[] = "bad_plans_XXXXXX.yaml";

/* A good plan with another line. */
static enum status read_plan(const char *const *good, int lines, int line, const char *text,
                             struct plan *plan, struct message *why)
{
    FILE *file = fopen(path, "w");

    REQUIRE(file);
    for (int n = 1; n <= lines + 1; n++)
        fprintf(file, "%s\n", n == line ? text : n <= lines ? good[n - 1] : "");
    REQUIRE(fclose(file) == 0);
    memset(plan, 'x', sizeof *plan);
    return plan_read(path, plan, why);
}

static void check_bad(const char *const *good, int lines, const struct wrong *bad,
                      size_t count)
{
    static const struct plan zero;

    for (size_t n = 0; n < count; n++) {
        struct plan plan;
        struct message why = {""};
        char beginning[64];
        enum status st = read_plan(good, lines, bad[n].line, bad[n].text, &plan, &why);
        size_t length = strlen(why.text);
        bool fine = st == STATUS_INPUT && !memcmp(&plan, &zero, sizeof plan);

        snprintf(beginning, sizeof beginning, "%s:%d: ", path, bad[n].line);
        fine = fine && !strncmp(why.text, beginning, strlen(beginning));
        fine = fine && strstr(why.text, bad[n].part) && length < sizeof why.text - 1;
        for (size_t i = 0; i < length; i++)
            fine = fine && (unsigned char)why.text[i] >= ' ';
        if (!CHECK(fine))
            printf("  '%s': wanted '%s...%s', got status %d '%s'\n", bad[n].text, beginning,
                   bad[n].part, st, why.text);
        plan_clear(&plan);
    }
}

/* What a study has of its own, and what of the plan. */
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
        CHECK(!strcmp(settings_value(&c.settings, "discretization.points"), "[9,9,2]"));
        CHECK(!settings_value(&c.settings, "time.step") == !quick);
        CHECK(strstr(c.path, "corners_drop.yaml"));
        plan_case_clear(&c);
    }
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
        {GOOD, LINES, 9, "cases: [{scene: %sedge_drop%s, model: %siga%s}]"},
        {STUDIES, STUDY_LINES, 3, "scene: %sedge_drop%s"},
        {STUDIES, STUDY_LINES, 11,
         "  - {name: edge, scene: %sedge_drop%s, model: %siga%s}"},
        {STUDIES, STUDY_LINES, 5, "  - {label: 5x5x2, model: %siga%s}"},
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
        const struct plan_study *s = plan.study_count ? &plan.studies[0] : NULL;
        const enum status st = s ? plan_case_level(&plan, s, s->levels, false, &c, &why)
                                 : plan_case_open(&plan, 0, &c, &why);
        REQUIRE(st == STATUS_OK);
        CHECK(strstr(c.path, "edge_drop.yaml") && !strcmp(c.contestant->name, "iga"));
        plan_case_clear(&c);
        plan_clear(&plan);
    }
}

/* What nobody gives: at rest, no truth, not timed, nobody else's milliseconds. */
static void check_bare_study(void)
{
    static const char *const text[] = {"name: bare", "source: a test", "scene: edge_drop",
                                       "levels: [{label: \"Some Net, p = 2\"}]"};
    struct plan plan;

    REQUIRE(read_plan(text, 4, 0, "", &plan, NULL) == STATUS_OK);
    const struct plan_study *s = &plan.studies[0];
    CHECK(plan.study_count == 1 && !strcmp(s->name, "bare") &&
          !strcmp(s->caption, "a test"));
    CHECK(s->time_count == 0 && s->truth == 0 && s->timed == 0 && s->quick_count == 0);
    CHECK(isnan(s->paper_ms) && isnan(s->levels[0].paper_ms) && s->levels[0].size == 0);
    CHECK(!strcmp(s->levels[0].name, "some_net_p_2") && s->levels[0].phases == 0);
    plan_clear(&plan);
}

/* The combinations in their order, and Gamma through the thickness. */
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

        REQUIRE(plan_case_open(&plan, n, &c, &why) == STATUS_OK);
        REQUIRE(plan_case_scene(&c, &scene, &why) == STATUS_OK);
        CHECK(n < 6 ? c.name && !strcmp(c.name, "a") : !c.name);
        CHECK(scene.poisson == (n < 6 ? 0.3 : 0.2) && scene.end == 0.5);
        CHECK_RELATIVE(scene_gamma(&scene), gammas[n / 2 % 3], tol_gamma);
        CHECK(scene.damping.value == strtod(dampings[n % 2], NULL));
        CHECK(scene.young == 1e5 && !strcmp(c.contestant->name, "iga"));
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
        {"{key: damping.value, from: 0.1, to: 0.9, count: 3}", 3, {"0.1", "0.5", "0.9"}},
        {"{key: damping.value, from: 1, to: 0, count: 4}",
         4,
         {"1", "0.6666666666666667", "0.33333333333333337", "0"}},
        {"{key: damping.value, from: 0.01, to: 1, count: 5, scale: log}",
         5,
         {"0.01", "0.0316227766016838", "0.1", "0.31622776601683794", "1"}},
        {"{key: damping.value, from: 0.1, to: 0.3, count: 2, scale: linear}",
         2,
         {"0.1", "0.3"}},
    };

    for (size_t n = 0; n < sizeof ranges / sizeof *ranges; n++) {
        struct plan plan;
        char line[128];
        snprintf(line, sizeof line, "  - %s", ranges[n].axis);
        REQUIRE(read_plan(GOOD, LINES, 8, line, &plan, NULL) == STATUS_OK);
        const struct plan_axis *axis = &plan.axes[1];
        REQUIRE(axis->values.count == ranges[n].count && axis->line == 8);
        for (int i = 0; i < axis->values.count; i++)
            if (!CHECK(!strcmp(axis->values.list[i].value, ranges[n].values[i])))
                printf("  %s: %s\n", ranges[n].axis, axis->values.list[i].value);
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
    struct message why = {""};
    FILE *file = fopen(path, "w");

    REQUIRE(file);
    fputs("name: values\nsource: a test\nsettings:\n  a: [{at: {u: 0, w: 1}, fix: xyz}]\n"
          "  b:\n    kind: mass\n    value: [1, 2, [3]]\n  c: \"it's: so\"\n  d: plain\n",
          file);
    REQUIRE(fclose(file) == 0);
    if (!CHECK(plan_parse(path, &plan, &why) == STATUS_OK))
        printf("%s\n", why.text);
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
    static const char *const text[] = {
        "name: first", "source: a test", "settings: {gamma: 100}",
        "axes: [{key: scene, values: [edge_drop]}, {key: damping.value, values: [0.5]}]"};
    struct plan plan;
    struct plan_case c;
    struct scene scene;
    const double tol_gamma = 1e-13;

    REQUIRE(read_plan(text, 4, 0, "", &plan, NULL) == STATUS_OK);
    CHECK(!strcmp(plan.keys[0], "gamma"));
    REQUIRE(plan_case_open(&plan, 0, &c, NULL) == STATUS_OK);
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

    CHECK(read_plan(GOOD, LINES, 8,
                    "  - {key: damping.value, values: [0.1, 0.5]}\n"
                    "  - {key: time.step, from: 0.001, to: 0.002, count: 10000}",
                    &plan, &why) == STATUS_INPUT);
    CHECK(strstr(why.text, ".yaml:1: the plan has more than 100000 cases"));
}

/* The line that lists show of a plan, and of it as a study. */
static void check_lists(void)
{
    static const struct {
        const char *const *good;
        int lines, line;
        const char *text, *plan, *study;
    } cases[] = {
        {GOOD, LINES, 0, "", "a test", ""},
        {GOOD, LINES, 16, "what: in a word", "in a word", ""},
        {STUDIES, STUDY_LINES, 0, "", "a test", "a test"},
        {STUDIES, STUDY_LINES, 13, "what: in a word", "in a word", "in a word"},
        {GOOD, LINES, 2, "what: no source", "lacks the key 'source'", "lacks the key"},
    };

    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        struct plan plan;

        read_plan(cases[n].good, cases[n].lines, cases[n].line, cases[n].text, &plan, NULL);
        plan_clear(&plan);
        char *is = plan_kind.describe(path), *study = plan_study_kind.describe(path);
        CHECK(is && study && strstr(is, cases[n].plan));
        CHECK(*cases[n].study ? strstr(study, cases[n].study) != NULL : !*study);
        free(is);
        free(study);
    }
}

/* Each stand-in through each key it may be set by. */
static void check_derived_keys(void)
{
    static const char *const by[] = {"material.young", "material.density",
                                     "sheet.thickness", "sheet.length"};
    const double tol_power = 1e-14; /* one rounding of pow each way */

    for (int n = 0; n < 4; n++) {
        struct scene scene;
        double *const value[] = {&scene.young, &scene.density, &scene.thickness,
                                 &scene.length};

        REQUIRE(scene_init(&scene) == STATUS_OK);
        scene.gravity[2] = -9.81;
        scene.poisson = 0.3;
        double solved = derived_key_solve("gamma", by[n], 123, &scene);
        *value[n] = solved;
        CHECK_RELATIVE(scene_gamma(&scene), 123.0, tol_power);
        solved = derived_key_solve("young_over_density", by[n], 77, &scene);
        CHECK(isnan(solved) == (n > 1));
        *value[n] = solved;
        if (n < 2)
            CHECK_RELATIVE(scene.young / scene.density, 77.0, tol_power);
        scene_clear(&scene);
    }
    CHECK(!derived_key_is("material.young") && derived_key_is("gamma"));
}

int main(void)
{
    int file = mkstemps(path, 5);

    REQUIRE(file >= 0);
    close(file);
    check_good();
    check_ranges();
    check_values();
    check_first();
    check_studies();
    check_quotes();
    check_bare_study();
    check_lists();
    check_many();
    check_bad(GOOD, LINES, BAD, sizeof BAD / sizeof *BAD);
    check_bad(STUDIES, STUDY_LINES, BAD_STUDIES, sizeof BAD_STUDIES / sizeof *BAD_STUDIES);
    check_derived_keys();
    unlink(path);
    return check_result();
}
