/* plan_fixture.h - a plan of a text, written where a test has its files. */
#ifndef TESTS_PLAN_FIXTURE_H
#define TESTS_PLAN_FIXTURE_H

#include "bench/experiment/plan.h"
#include "tests/check.h"

static inline struct plan plan_of(const char *path, const char *text)
{
    struct message why = {"of another file"};
    struct plan plan;
    FILE *file = fopen(path, "w");

    REQUIRE(file && fputs(text, file) >= 0 && fclose(file) == 0);
    if (plan_read(path, &plan, &why) != STATUS_OK)
        printf("%s\n", why.text), exit(1);
    CHECK(!*why.text); /* nothing is left of what was wrong before */
    return plan;
}

#endif
