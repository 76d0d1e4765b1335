/* Malformed plans: each is refused with one sentence at the right line. */
#include "tests/plan_fixture.h"

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
    {4, "model: ibm", "no model or contestant 'ibm'; models: iga"},
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
    {16, "falls: {along: gamma}", "falls lacks the key 'measure', the name of"},
    {16, "falls: {measure: drop_max}", "falls lacks the key 'along', a line of text"},
    {16, "falls: {measure: size, along: gamma}", "measure is 'size', but must be the"},
    {16, "falls: {measure: drop_max, along: gamma, by: 3}", "by is '3', but must be the"},
    {16, "falls: {measure: drop_max, along: drop_end}",
     "falls is along 'drop_end', but must be along the key of an axis of two values"},
    {16, "falls: {measure: drop_max, along: gamma, bye: x}", "no key 'bye'; did you mean"},
    {16, "colour: red", "the plan has no key 'colour'"},
    {16, "look: 3", "key 'look' for the second time"},
    {16, "times: [0.1]", "times is for studies, but the plan has no levels"},
    {16, "truth: true", "truth is for studies, but the plan has no levels"},
    {16, "timed: 3", "timed is for studies, but the plan has no levels"},
    {16, "table: {columns: [drop]}", "table is for studies, but the plan has no levels"},
    {16, "skip: [{study: edge}]", "skip is for studies, but the plan has no levels"},
    {16, "- x", "not YAML"},
};

static const struct wrong BAD_STUDIES[] = {
    {3, "scene: nowhere", "no scene 'nowhere'"},
    {5, "  - {size: 0.3}", "a level lacks the key 'label', a line of text"},
    {5, "  - {label: a, size: -1}", "size is '-1', but must be a number between 0 and"},
    {5, "  - {label: a, colour: red}", "has no key 'colour'"},
    {5, "  - {label: a, model: ibm}", "there is no model or contestant 'ibm'; models: iga"},
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
    {8, "truth: shell", "truth is 'shell', but must be one of false, true, plate"},
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
    {11, "  - {name: edge, settings: {material.fabric: denim, gamma: 100}}",
     "gamma cannot be set by material.young in this scene: its material is a fabric"},
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
    {13, "paper: [{study: edge}]", "an entry of paper lacks the key paper_ms"},
    {13, "paper: [{study: edge, paper_ms: 0}]", "paper_ms is '0', but must be a number"},
    {13, "paper: [{study: ege, paper_ms: 9}]",
     "the axis 'study', which has no label 'ege'"},
    {13, "cases: [{name: a}]", "a plan with levels has no axes, cases and map"},
    {13, "skip: [{study: ege}]", "the axis 'study', which has no label 'ege'"},
    {13, "skip: [{colour: red}]", "no study has an axis 'colour', nor a label 'red'"},
    {13, "skip: [{study: edge, quick: maybe}]", "quick is 'maybe', but must be true or"},
    {13, "skip: [5]", "a map {AXIS: LABEL} is wanted"},
    {13, "reference: {level: [5x5x2, [a]]}", "but must be a label of the axis"},
    {11, "  - {name: edge, levels: {net: []}}", "levels is an empty list, but must be"},
    {11, "  - {name: edge, levels: {}}", "or a map of up to 4 axes"},
    {13, "table: {columns: [stretch], shown: {colour: red}}", "no study has an axis"},
    {13, "axes: [{key: gamma, values: [1]}]", "a plan with levels has no axes, cases and"},
};

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

int main(void)
{
    scratch_open();
    path = scratch_path("plan.yaml");
    check_bad(GOOD, LINES, BAD, sizeof BAD / sizeof *BAD);
    check_bad(STUDIES, STUDY_LINES, BAD_STUDIES, sizeof BAD_STUDIES / sizeof *BAD_STUDIES);
    return check_result();
}
