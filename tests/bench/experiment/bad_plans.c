/* Malformed plans: each is refused with one sentence at the right line. */
#include "tests/plan_fixture.h"

struct wrong {
    int line; /* replaced; beyond the last: added */
    const char *text;
};
static const struct wrong BAD[] = {
    {1, "name: Good plan"},
    {1, "nam: good"},
    {1, "name: [good]"},
    {3, "scene: nowhere"},
    {3, "scene: ./nowhere.yaml"},
    {3, "scene: [edge_drop]"},
    {4, "model: ibm"},
    {5, "settings: 5"},
    {5, "settings: {material.density: heavy}"},
    {5, "settings: {material.colour: red}"},
    {5, "settings: {discretization.degree: [9,9,1]}"},
    {5, "settings: [{time.end: 1}, {time.end: 2}]"},
    {5, "settings: {\"material.young=5e4 #\": 3}"},
    {5, "settings: {\"material.young\\n\": 3}"},
    {5, "settings: {\"\": 3}"},
    {8, "  - {key: damping.value=2, values: [1]}"},
    {8, "  - {key: \"damping\\r\", values: [1]}"},
    {5, "settings: {time.end: \"1\\n2\"}"},
    {5, "settings: {time.end: }"},
    {5, "settings: {look: 3}"},
    {5, "settings: {sheet.thickness: 0.01}"},
    {7, "  - {from: 10, to: 1000, count: 3}"},
    {7, "  - {key: gamma, from: 10, to: 1000}"},
    {7, "  - {key: gamma, from: 1, to: 2, count: 3, values: [1]}"},
    {7, "  - {key: gamma, from: 1, to: 2, count: 1}"},
    {7, "  - {key: gamma, from: 0, to: 2, count: 3, scale: log}"},
    {7, "  - {key: gamma, from: 1, to: 2, count: 3, scale: cubic}"},
    {7, "  - {key: gamma, values: []}"},
    {7, "  - {key: gamma, values: [1, -1], by: sheet.thickness}"},
    {7, "  - {key: gamma, values: [1, x], by: sheet.thickness}"},
    {7, "  - {key: gamma, values: [1], by: sheet.width}"},
    {7, "  - {key: gamma, values: [1e-30], by: sheet.thickness}"},
    {7, "  - {key: time.step, values: [1], by: time.end}"},
    {8, "  - {key: damping.value, values: [0.1, -3]}"},
    {8, "  - {key: damping.value, values: {a: 1}}"},
    {8, "  - {key: gamma, values: [3]}"},
    {8, "  - {key: time.end, values: [3]}"},
    {8, "  - {key: material.young, values: [1]}"},
    {8, "  - {key: scene, values: [edge_drop]}"},
    {9, "cases: []"},
    {9, "cases: [5]"},
    {9, "cases: [{name: [a]}]"},
    {9, "cases: [{name: ''}]"},
    {9, "cases: [{name: \"a\\n!touch pwned\"}]"},
    {9, "cases: [{name: \"a\\e[2J\"}]"},
    {9, "cases: [{name: \"a\\x9b2J\"}]"},
    {9, "cases: [{material.poisson: 0.2}, {material.poisson: 0.5}]"},
    {10, "look: 0"},
    {11, "intersections: maybe"},
    {12, "keep: all"},
    {13, "time_limit: -1"},
    {14, "verdicts: []"},
    {14, "verdicts: nowhere"},
    {14, "verdicts: [{label: big, measure: size, above: 1, why: x}]"},
    {15, "map: {x: gamma}"},
    {15, "map: {x: weather, y: gamma}"},
    {15, "map: {x: gamma, y: weather}"},
    {15, "map: {x: gamma, y: drop_max, marks: [5]}"},
    {15, "map: {x: gamma, y: damping.value, marks: [{text: a, label: b, at: {}}]}"},

    /* an unknown key, at every depth */
    {7, "  - {key: gamma, valus: [10, 100]}"},
    {9, "cases: [{material.yung: 1e5}]"},
    {14, "verdicts: [{label: big, measure: drop_max, abov: 1, why: x}]"},
    {15, "map: {x: gamma, y: drop_max, pannel: name}"},
    {15, "map: {x: gamma, y: drop_max, marks: [{txt: a, label: b, at: {}}]}"},
    {15,
     "map: {x: damping.value, y: gamma, marks: [{text: a, label: b, at: {damping.value: "
     "1, material.colour: 1}}]}"},
    {16, "falls: {along: gamma}"},
    {16, "falls: {measure: drop_max}"},
    {16, "falls: {measure: size, along: gamma}"},
    {16, "falls: {measure: drop_max, along: gamma, by: 3}"},
    {16, "falls: {measure: drop_max, along: drop_end}"},
    {16, "falls: {measure: drop_max, along: gamma, bye: x}"},
    {16, "colour: red"},
    {16, "look: 3"},
    {16, "times: [0.1]"},
    {16, "truth: true"},
    {16, "timed: 3"},
    {16, "table: {columns: [drop]}"},
    {16, "skip: [{study: edge}]"},
    {16, "- x"},
};

static const struct wrong BAD_STUDIES[] = {
    {3, "scene: nowhere"},
    {5, "  - {size: 0.3}"},
    {5, "  - {label: a, size: -1}"},
    {5, "  - {label: a, colour: red}"},
    {5, "  - {label: a, model: ibm}"},
    {5, "  - {label: a, settings: 5}"},
    {5, "  - {label: a, settings: {discretization.degree: [9,9,1]}}"},
    {5, "  - {label: a, settings: {material.colour: red}}"},
    {5, "  - {label: a, quick: {sheet.thickness: -1}}"},
    {5, "  - {label: a, name: A a}"},
    {5, "  - {label: a, phases: maybe}"},
    {6, "  - {label: 5X5X2}"},
    {7, "times: 0.1"},
    {7, "times: [0.2, 0.1]"},
    {7, "times: [0]"},
    {7, "times: [0.1, 0.123]"},
    {7, "times: [0.105]"},
    {8, "truth: shell"},
    {9, "timed: 0.5"},
    {9, "timed: yes"},
    {11, "  - {caption: edge}"},
    {11, "  - {name: edge drop}"},
    {12, "  - {name: edge}"},
    {11, "  - {name: edge, times: []}"},
    {11, "  - {name: edge, levels: []}"},
    {11, "  - {name: edge, scene: nowhere}"},
    {11, "  - {name: edge, settings: {time.end: x}}"},
    {11, "  - {name: edge, settings: {material.fabric: denim, gamma: 100}}"},

    /* an unknown key, at every depth */
    {5, "  - {label: a, setings: {time.end: 1}}"},
    {5, "  - {label: a, quick: {material.yung: 1}}"},
    {11, "  - {name: edge, captin: x}"},
    {11, "  - {name: edge, settings: {time.edn: 1}}"},
    {11, "  - {name: edge, levels: [{label: a, sice: 1}]}"},
    {11, "  - {name: edge, levels: [{label: a, settings: {sheet.depth: 1}}]}"},
    {13, "paper: [{study: edge}]"},
    {13, "paper: [{study: edge, paper_ms: 0}]"},
    {13, "paper: [{study: ege, paper_ms: 9}]"},
#define STATED(rest) "statements: [{quote: a, section: b, " rest "}]"
#define RATIO        "ratio: [drop, {study: edge}, {study: corners}]"
    {13, STATED(RATIO)},
    {13, STATED("paper: 2")},
    {13, STATED(RATIO ", paper: 0")},
    {13, STATED(RATIO ", exponent: [drop, size, {study: edge}], paper: 2")},
    {13, STATED("ratio: [drop, {study: edge}], paper: 2")},
    {13, STATED("ratio: [drop, drop, {study: edge}], paper: 2")},
    {13, STATED("ratio: [drop, {study: ege}, {study: edge}], paper: 2")},
    {13, STATED(RATIO ", paper: 2, readings: [{study: edge}]")},
    {13, STATED(RATIO ", paper: 2, readings: [{name: a, study: ege}]")},
    {13, STATED(RATIO ", paper: 2, readings: [{ours: a, study: edge}]")},
    {13, STATED(RATIO ", paper: 2, readings: []")},
    {13, "cases: [{name: a}]"},
    {13, "skip: [{study: ege}]"},
    {13, "skip: [{colour: red}]"},
    {13, "skip: [{study: edge, quick: maybe}]"},
    {13, "skip: [5]"},
    {13, "reference: {level: [5x5x2, [a]]}"},
    {11, "  - {name: edge, levels: {net: []}}"},
    {11, "  - {name: edge, levels: {}}"},
    {13, "table: {columns: [stretch], shown: {colour: red}}"},
    {13, "axes: [{key: gamma, values: [1]}]"},
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
        fine = fine && length < sizeof why.text - 1;
        for (size_t i = 0; i < length; i++)
            fine = fine && (unsigned char)why.text[i] >= ' ';
        if (!CHECK(fine))
            printf("  '%s': wanted '%s...', got status %d '%s'\n", bad[n].text, beginning,
                   st, why.text);
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
