/* plan_fixture.h - a plan of a text, written where a test has its files. */
#ifndef TESTS_PLAN_FIXTURE_H
#define TESTS_PLAN_FIXTURE_H

#include "bench/experiment/plan.h"
#include "tests/text.h"

static inline struct plan plan_of(const char *path, const char *text)
{
    struct message why = {"of another file"};
    struct plan plan;

    text_write(path, text);
    REQUIRE_SAY(plan_read(path, &plan, &why) == STATUS_OK, "%s", why.text);
    CHECK(!*why.text); /* nothing is left of what was wrong before */
    return plan;
}

#endif
