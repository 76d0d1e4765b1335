/* What ensembles of numbers say: errors, distances, bounds, against tables and by lot. */
#include "bench/studies/studies.h"

#include <stdint.h>

#include "tests/check.h"

/* Tables have so many digits. */
#define TOL_TABLE 1e-6
/* A few operations. */
#define TOL_ROUND 1e-14

enum { RUNS = 32, LOTS = 400 };

static double uniform(void)
{
    static uint64_t state = 7;

    state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (double)(state >> 11) * 0x1p-53;
}

static void test_numbers(void)
{
    static const double value[] = {1, 2, 3, 4, 100};
    static const double want[] = {2, 1, 0, 1, 97};
    double deviation[5];
    double error;

    CHECK_NEAR(distribution_mean(4, value, &error), 2.5, TOL_ROUND);
    CHECK_NEAR(error, sqrt(5.0 / 12), TOL_ROUND);
    CHECK(distribution_mean(1, value, &error) == 1 && isnan(error));
    CHECK(isnan(distribution_mean(0, value, &error)) && isnan(error));
    distribution_deviations(5, value, deviation);
    for (int n = 0; n < 5; n++)
        CHECK(deviation[n] == want[n]);
    distribution_deviations(4, value, deviation); /* the median of four is 2.5 */
    CHECK(deviation[0] == 1.5 && deviation[2] == 0.5);
}

/* Student's t, two-sided (Abramowitz, Stegun 1964, table 26.10, and the normal's). */
static void test_bound(void)
{
    CHECK_NEAR(distribution_bound(1, 2), 12.7062047, TOL_TABLE);
    CHECK_NEAR(distribution_bound(1, 3), 4.3026527, TOL_TABLE);
    CHECK_NEAR(distribution_bound(1, 11), 2.2281389, TOL_TABLE);
    CHECK_NEAR(distribution_bound(1, 32), 2.0395134, TOL_TABLE);
    CHECK_NEAR(distribution_bound(10, 11), 3.5814062, TOL_TABLE);
    CHECK_NEAR(distribution_bound(5, 10001), 2.5763, 1e-3);
    CHECK(isinf(distribution_bound(1, 1)));
}

static void test_apart(void)
{
    static const double a[] = {1, 2, 3, 4}, b[] = {11, 12, 13, 14}, c[] = {5, 5};
    const double error = sqrt(5.0 / 6);

    CHECK_NEAR(distribution_apart(4, a, 4, b, 0), -10 / error, TOL_ROUND);
    CHECK_NEAR(distribution_apart(4, b, 4, a, 0), 10 / error, TOL_ROUND);
    CHECK_NEAR(distribution_apart(4, a, 4, b, 3), -10 / sqrt(5.0 / 6 + 9), TOL_ROUND);
    CHECK(distribution_apart(2, c, 2, c, 0) == 0);
    CHECK(distribution_apart(2, c, 4, a, 0) > 0);
    CHECK(isnan(distribution_apart(1, a, 4, b, 0)));
}

/* How many of LOTS pairs are told apart, whose second is shifted and spread; by means, or
 * by spreads. */
static int told(double shift, double spread, bool by_spread)
{
    const double bound = distribution_bound(1, RUNS);
    double a[RUNS], b[RUNS], da[RUNS], db[RUNS];
    int count = 0;

    for (int lot = 0; lot < LOTS; lot++) {
        for (int n = 0; n < RUNS; n++) {
            a[n] = uniform();
            b[n] = shift + spread * uniform();
        }
        distribution_deviations(RUNS, a, da);
        distribution_deviations(RUNS, b, db);
        count += fabs(by_spread ? distribution_apart(RUNS, da, RUNS, db, 0)
                                : distribution_apart(RUNS, a, RUNS, b, 0)) > bound;
    }
    return count;
}

/* Of one distribution 5 of 100 are told apart, four sigma of 400 about that; a mean that is
 * one standard deviation off, and a spread that is twice as wide, nearly always. */
static void test_power(void)
{
    const double sigma = sqrt(LOTS * 0.05 * 0.95);

    for (int by_spread = 0; by_spread < 2; by_spread++)
        CHECK_NEAR(told(0, 1, by_spread), LOTS * 0.05, 4 * sigma);
    CHECK(told(sqrt(1 / 12.0), 1, false) > 0.9 * LOTS);
    CHECK(told(-0.5, 2, true) > 0.9 * LOTS);
    CHECK(told(-0.5, 2, false) < 0.15 * LOTS);
}

int main(void)
{
    test_numbers();
    test_bound();
    test_apart();
    test_power();
    return check_result();
}
