/* Gauss-Legendre rules: exact on polynomials of degree 2n - 1, and not beyond. */
#include <float.h>

#include "models/linalg/gauss.h"
#include "tests/check.h"

/* n <= 16 positive terms below 1, each good to a few ulp. */
#define TOL_RULE (32 * DBL_EPSILON)
/* Halving the difference of 1 and the root rounds once. */
#define TOL_MIRROR DBL_EPSILON

static double integral_of_power(int n, const double *x, const double *w, int power)
{
    double sum = 0.0;
    for (int i = 0; i < n; i++)
        sum += w[i] * pow(x[i], power);
    return sum;
}

/* The n-point rule misses x^2n by (n!)^4 / ((2n)!^2 (2n + 1)): the remainder formula on
 * [0,1] with the 2n-th derivative (2n)!. */
static double miss(int n)
{
    double log_miss = 4 * lgamma(n + 1.0) - 2 * lgamma(2 * n + 1.0) - log(2 * n + 1.0);
    return exp(log_miss);
}

/* lgamma is good to a few ulp of arguments near 80; the difference of two sums to TOL_RULE.
 */
#define TOL_MISS(n) (1e-12 * miss(n) + TOL_RULE)

int main(void)
{
    double x[GAUSS_MAX], w[GAUSS_MAX];

    for (int n = 1; n <= GAUSS_MAX; n++) {
        gauss_rule(n, x, w);
        for (int power = 0; power < 2 * n; power++)
            CHECK_NEAR(integral_of_power(n, x, w, power), 1.0 / (power + 1), TOL_RULE);
        CHECK_NEAR(1.0 / (2 * n + 1) - integral_of_power(n, x, w, 2 * n), miss(n),
                   TOL_MISS(n));
        for (int i = 0; i < n; i++) {
            CHECK(0.0 < x[i] && x[i] < 1.0 && w[i] > 0.0);
            CHECK(i == 0 || x[i] > x[i - 1]);
            CHECK(w[i] == w[n - 1 - i]);
            CHECK_NEAR(x[i], 1.0 - x[n - 1 - i], TOL_MIRROR);
        }
    }
    return check_result();
}
