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
    {5, "settings: {\"material.young=5e4 #\": 3}"},
    {5, "settings: {\"material.young\\n\": 3}"},
    {5, "settings: {\"\": 3}"},
    {9, "  \"damping.value=2\": [1]"},
    {9, "  \"damping\\r\": [1]"},
    {5, "settings: {time.end: \"1\\n2\"}"},
    {5, "settings: {time.end: }"},
    {5, "settings: {look: 3}"},
    {5, "settings: {material.young: 1e5}"},
    {8, "  gamma: {from: 10, to: 1000}"},
    {8, "  gamma: {from: 1, to: 2, count: 3, by: sheet.length}"},
    {8, "  gamma: {from: 1, to: 2, count: 1}"},
    {8, "  gamma: {from: 0, to: 2, count: 3, scale: log}"},
    {8, "  gamma: {from: 1, to: 2, count: 3, scale: cubic}"},
    {8, "  gamma: []"},
    {8, "  gamma: 5"},
    {8, "  gamma: [1, -1]"},
    {8, "  gamma: [1, x]"},
    {8, "  gamma: [0]"},
    {9, "  damping.value: [0.1, -3]"},
    {9, "  damping.value: {a: 1}"},
    {9, "  gamma: [3]"},
    {7, "  case: {a: {material.young: 1e5}, b: [x]}"},
    {7, "  case: {a: {material.young: 1e5}}"},
    {7, "  case: {\"a\\n!touch pwned\": {}}"},
    {7, "  case: {\"a\\e[2J\": {}}"},
    {7, "  case: {\"a\\x9b2J\": {}}"},
    {7, "  case: {'': {}}"},
    {7, "  case: {a: {material.poisson: 0.2}, b: {material.poisson: 0.5}}"},
    {7, "  case: {a: {material.young: 1e5}, a: {}}"},
    {10, "look: 0"},
    {11, "intersections: maybe"},
    {12, "keep: all"},
    {13, "time_limit: -1"},
    {14, "verdicts: []"},
    {14, "verdicts: nowhere"},
    {14, "verdicts: [{label: big, measure: size, above: 1, why: x}]"},

    /* an unknown key, at every depth */
    {8, "  gamma: {from: 1, to: 2, count: 3, valus: 3}"},
    {7, "  case: {a: {material.yung: 1e5}}"},
    {14, "verdicts: [{label: big, measure: drop_max, abov: 1, why: x}]"},
    {15, "colour: red"},
    {15, "look: 3"},
    {12, "reference: {damping.value: 0.1}"}, /* it keeps no snapshots */
    {15, "skip: [{study: edge}]"},
    {15, "- x"},
};

static const struct wrong BAD_STUDIES[] = {
    {3, "scene: nowhere"},
    {5, "  a: {size: -1},"},
    {5, "  a: {colour: red},"},
    {5, "  a: {model: ibm},"},
    {5, "  a: 5,"},
    {5, "  a: {discretization.degree: [9,9,1]},"},
    {5, "  a: {material.colour: red},"},
    {5, "  a: {quick: {sheet.thickness: -1}},"},
    {5, "  a: {name: A a},"},
    {5, "  a: {phases: maybe},"},
    {6, "  5X5X2: {}}}"},
    {7, "times: 0.1"},
    {7, "times: [0.2, 0.1]"},
    {7, "times: [0]"},
    {7, "times: [0.1, 0.123]"},
    {7, "times: [0.105]"},
    {8, "truth: shell"},
    {9, "timed: 0.5"},
    {9, "timed: yes"},
    {11, "  edge: 5"},
    {11, "  edge drop: {}"},
    {12, "  edge: {}"},
    {11, "  edge: {times: []}"},
    {11, "  edge: {axes: []}"},
    {11, "  edge: {axes: {level: []}}"},
    {11, "  edge: {scene: nowhere}"},
    {11, "  edge: {time.end: x}"},
    {11, "  edge: {material.fabric: denim, gamma: 100}"},

    /* an unknown key, at every depth */
    {5, "  a: {quick: {material.yung: 1}},"},
    {11, "  edge: {captin: x}"},
    {11, "  edge: {time.edn: 1}"},
    {11, "  edge: {axes: {level: {a: {sice: 1}}}}"},
    {11, "  edge: {axes: {level: {a: {sheet.depth: 1}}}}"},
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
    {13, STATED(RATIO ", paper: 2, readings: {a: edge}")},
    {13, STATED(RATIO ", paper: 2, readings: {a: {study: ege}}")},
    {13, STATED(RATIO ", paper: 2, readings: {a: {ours: true, study: edge}}")},
    {13, STATED(RATIO ", paper: 2, readings: {}")},
    {13, STATED(RATIO ", paper: 2, reason: x")},
    {13, "levels: [{label: a}]"},
    {13, "skip: [{study: ege}]"},
    {13, "skip: [{colour: red}]"},
    {13, "skip: [{study: edge, quick: maybe}]"},
    {13, "skip: [5]"},
    {13, "reference: {level: [5x5x2, [a]]}"},
    {13, "table: {columns: [stretch], shown: {colour: red}}"},
    {13, "reference: {level: 7x7x2}"},
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
