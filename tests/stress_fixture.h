/* stress_fixture.h - cases and contestants of `stress` by their names, for its tests. */
#ifndef STRESS_FIXTURE_H
#define STRESS_FIXTURE_H

#include "bench/stress/stress.h"
#include "tests/check.h"

static inline const struct stress_case *stress_fixture_case(const char *name)
{
    int n = 0;

    while (stress_case_at(n) && strcmp(stress_case_at(n)->item.name, name))
        n++;
    REQUIRE(stress_case_at(n));
    return stress_case_at(n);
}

static inline const struct contestant *stress_fixture_contestant(const char *name)
{
    const struct contestant *c = NULL;

    REQUIRE(contestant_find(name, &c, NULL) == STATUS_OK);
    return c;
}

#endif
