/* plan_fixture.h - plans that are right, for tests to change a line of. */
#ifndef TESTS_PLAN_FIXTURE_H
#define TESTS_PLAN_FIXTURE_H

#include <stdlib.h>

#include "bench/experiment/plan.h"
#include "bench/harness/derived_key.h"
#include "tests/scratch.h"

/* A good plan; tests replace one of its lines, counted from 1, or add one. */
static const char *const GOOD[] = {
    "name: good",
    "source: a test",
    "scene: edge_drop",
    "model: iga",
    "settings: {time.end: 0.5, discretization.points: [6,6,2]}",
    "axes:",
    "  case: {a: {sheet.thickness: 0.02}, b: {material.poisson: 0.2}}",
    "  gamma: {from: 10, to: 1000, count: 3, scale: log}",
    "  damping.value: [0.1, 0.5]",
    "look: 5",
    "intersections: true",
    "keep: snapshots",
    "time_limit: 10",
    "verdicts: [{label: big, measure: drop_max, above: 1, why: a test}]",
};
enum { LINES = sizeof GOOD / sizeof *GOOD };

/* A good plan of studies. */
static const char *const STUDIES[] = {
    "name: studies",
    "source: a test",
    "scene: edge_drop",
    "axes: {level: {",
    "  5x5x2: {size: 0.3, discretization.points: [5,5,2]},",
    "  9x9x2: {discretization.points: [9,9,2], quick: {time.step: 0.01}}}}",
    "times: [0.1, 0.2]",
    "truth: true",
    "timed: 3",
    "studies:",
    "  edge: {}",
    "  corners: {scene: corners_drop, truth: false, times: [0.05]}",
};
enum { STUDY_LINES = sizeof STUDIES / sizeof *STUDIES };

static const char *path; /* where a test puts them */

/* A good plan with another line. */
static inline enum status read_plan(const char *const *good, int lines, int line,
                                    const char *text, struct plan *plan,
                                    struct message *why)
{
    FILE *file = fopen(path, "w");

    REQUIRE(file);
    for (int n = 1; n <= lines + 1; n++)
        fprintf(file, "%s\n", n == line ? text : n <= lines ? good[n - 1] : "");
    REQUIRE(fclose(file) == 0);
    memset(plan, 'x', sizeof *plan);
    return plan_read(path, plan, why);
}

#endif
