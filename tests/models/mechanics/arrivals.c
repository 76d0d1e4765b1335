/* Tests when the iterations of an implicit step end, and what is told of them. */
#include "models/mechanics/arrival.h"

#include "tests/check.h"

enum { LIMIT = 50 };
static const double LOADS = 8, ROUND_OFF = 1e-15;

static struct arrival start(const struct scene *s, int iterations, double loads)
{
    struct arrival a;

    arrival_init(&a, iterations, LIMIT, loads, 0.5, 100, s, 5e-3);
    return a;
}

/* Measured after 1, 2, 3, 4, 5, 7, ... iterations, and at the limit; a chosen number alone.
 */
static void check_next(const struct scene *s)
{
    static const int want[] = {1, 2, 3, 4, 5, 7, 9, 12, 15, 19, 24, 30, 38, 48, 50, 50};
    const struct arrival a = start(s, 0, LOADS), chosen = start(s, 7, LOADS);

    for (int n = 0, done = 0; n < 16; n++) {
        done = arrival_next(&a, done);
        CHECK(done == want[n]);
    }
    CHECK(arrival_next(&chosen, 0) == 7);
}

static void check_ends(const struct scene *s)
{
    const struct arrival_forces arrived = {.left = 0.0799}, far = {.left = 0.16},
                                swung = {.left = 0.16, .momentum = 16.1},
                                hangs = {.left = 0.16, .held = 16.1};
    struct counters counters = {0};
    struct arrival a = start(s, 0, LOADS);

    CHECK(!arrival_ends(&a, 12, &far, 0) && !arrival_ends(&a, 12, &hangs, 0));
    CHECK(arrival_ends(&a, 12, &arrived, 1) && arrival_next(&a, 0) == 9);
    CHECK(arrival_ends(&a, 12, &swung, 2));
    CHECK(a.missed == 0 && a.left_time == 1);
    CHECK(arrival_ends(&a, LIMIT, &far, 3) && a.missed == 1 && a.left_time == 3);
    arrival_count(&a, &counters);
    CHECK_NEAR(counters.left, 0.02, ROUND_OFF);
    CHECK(counters.missed == 1 && counters.astray == 0);
    a = start(s, 0, 0);
    CHECK(arrival_ends(&a, 12, &hangs, 0) && !arrival_ends(&a, 12, &far, 0));
}

/* A chosen number of iterations is doubted for what it leaves, and is astray if it should
 * only descend. */
static void check_chosen(const struct scene *s)
{
    const struct arrival_forces most = {.left = 1.01 * LOADS};

    for (int descends = 0; descends < 2; descends++) {
        struct arrival a = start(s, 7, LOADS);
        struct counters counters = {0};
        struct message line = {{0}};
        a.descends = descends;
        CHECK(arrival_ends(&a, 7, &most, 1) && a.missed == 0);
        arrival_count(&a, &counters);
        CHECK((counters.astray > 1) == descends);
        arrival_doubt(&a, &line);
        CHECK(strstr(line.text, "7, is fixed"));
    }
}

static void check_sum(void)
{
    const double vectors[] = {3, 4, 5, 0, 2, 0}, mass[] = {2, 10};
    const int place[] = {0, 1, -1, -1, 2, 3};

    CHECK(arrival_sum(2, place, true, NULL, vectors) == 5 + 2);
    CHECK(arrival_sum(2, place, true, mass, vectors) == 2 * 5 + 10 * 2);
    CHECK(arrival_sum(2, place, false, NULL, vectors) == 5);
}

int main(void)
{
    struct scene s;

    REQUIRE(scene_init(&s) == STATUS_OK);
    s.length = 1, s.thickness = 1e-3, s.young = 1e5;
    check_next(&s);
    check_ends(&s);
    check_chosen(&s);
    check_sum();
    scene_clear(&s);
    return check_result();
}
