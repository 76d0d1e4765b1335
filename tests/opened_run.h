/* opened_run.h - runs that must open, for tests that look into them. */
#ifndef TESTS_OPENED_RUN_H
#define TESTS_OPENED_RUN_H

#include "bench/harness/run.h"
#include "tests/check.h"

/* A model, or contestant, by its name on a scene with settings; ends the test if it cannot.
 */
static inline void opened_run(struct run *run, const char *scene, const char *name,
                              int count, const char *const *text)
{
    struct settings settings = {0};
    struct run_plan plan = {.path = scene, .settings = &settings};
    struct message why = {""};

    REQUIRE(contestant_find(name, &plan.contestant, NULL) == STATUS_OK);
    settings_set_all(&settings, count, text);
    if (!CHECK(run_open(run, &plan, &why) == STATUS_OK)) {
        printf("%s: %s\n", name, why.text);
        exit(1);
    }
    settings_clear(&settings);
}

#endif
