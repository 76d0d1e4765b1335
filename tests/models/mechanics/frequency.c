/* Tests the largest frequency and what follows from it, from both sides: a chain of equal
 * masses and springs, held at one end, has 2 sqrt(k/m) sin((2n - 1) pi / (4n + 2)). */
#include "models/mechanics/frequency.h"

#include "tests/check.h"

enum { POINTS = 40 };

/* Lanczos' method ends where the frequency grows by less. */
static const double CONVERGED = 1e-3, ROUND_OFF = 1e-14;

static void check_chain(double stiffness, double mass)
{
    int ien[POINTS - 1][2];
    double uvw[POINTS][3], rest[3 * POINTS] = {0}, masses[POINTS], omega;
    struct blocks graph;
    struct supports supports;
    struct scene scene;
    const struct scene_support held = {.hi = {0, 1, 1}, .fix = FIX_XYZ};

    for (int n = 0; n < POINTS; n++) {
        uvw[n][0] = rest[3 * n] = n / (POINTS - 1.0), uvw[n][1] = uvw[n][2] = 0.5;
        masses[n] = mass;
        if (n > 0)
            ien[n - 1][0] = n - 1, ien[n - 1][1] = n;
    }
    REQUIRE(scene_init(&scene) == STATUS_OK);
    REQUIRE(scene_add_support(&scene, &held) == STATUS_OK);
    REQUIRE(supports_init(&supports, &scene, POINTS, uvw, rest, NULL) == STATUS_OK);
    REQUIRE(blocks_init(&graph, POINTS, POINTS - 1, 2, ien[0]) == STATUS_OK);
    double(*K)[9] = calloc((size_t)graph.start[POINTS], sizeof *K);
    REQUIRE(K);
    for (int a = 0; a < POINTS; a++)
        for (long n = graph.start[a]; n < graph.start[a + 1]; n++)
            for (int i = 0; i < 9; i += 4)
                K[n][i] = graph.node[n] != a    ? -stiffness
                          : a && a < POINTS - 1 ? 2 * stiffness
                                                : stiffness;
    REQUIRE(frequency_largest(&graph, &supports, masses, NULL, (const double(*)[9])K,
                              &omega) == STATUS_OK);
    const double pi = acos(-1), moving = POINTS - 1,
                 largest = 2 * sqrt(stiffness / mass) *
                           sin((2 * moving - 1) * pi / (4 * moving + 2));
    CHECK_RELATIVE(omega, largest, CONVERGED);
    CHECK(omega <= largest * (1 + ROUND_OFF)); /* from below */
    free(K);
    blocks_clear(&graph);
    supports_clear(&supports);
    scene_clear(&scene);
}

/* Leapfrog with damping of the strains' rate half a step ago is stable up to the step of
 * which dt^2 omega^2 + 2 beta dt omega^2 = 4. */
static void check_steps(void)
{
    const double omega = 50, beta = 0.01, dt = frequency_limit(omega, beta);
    struct message why = {{0}};
    int steps;

    CHECK_RELATIVE(dt * dt * omega * omega + 2 * beta * dt * omega * omega, 4.0, ROUND_OFF);
    CHECK_RELATIVE(frequency_limit(omega, 0), 2 / omega, ROUND_OFF);
    CHECK(isinf(frequency_limit(0, beta)));
    CHECK(frequency_steps(1, 0.01, 0, &steps, &why) == STATUS_OK);
    CHECK(steps * frequency_chosen * 0.01 >= 1 &&
          (steps - 1) * frequency_chosen * 0.01 < 1);
    CHECK(frequency_steps(1, 0.01, 7, &steps, &why) == STATUS_OK && steps == 7);
    CHECK(frequency_steps(1, INFINITY, 0, &steps, &why) == STATUS_OK && steps == 1);
    CHECK(frequency_steps(1, 1e-7, 0, &steps, &why) == STATUS_INPUT && *why.text);
}

int main(void)
{
    check_chain(3, 2);
    check_chain(1e6, 1e-3);
    check_steps();
    return check_result();
}
