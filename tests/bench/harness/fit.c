/* Exponents of powers, exact and with a known line through scattered points. */
#include "bench/harness/fit.h"
#include "tests/check.h"

/* Sums of a few logarithms. */
static const double TOL_ROUNDING = 1e-14;

int main(void)
{
    const double x[] = {1, 2, 4, 8}, cube[] = {3, 24, 192, 1536}, bent[] = {1, 4, 4, 16};
    const double larger[] = {6, 12, 24, 48}; /* no logarithm is 0 */
    const double bad[] = {1, NAN, 1, 1};

    CHECK_NEAR(fit_exponent(4, x, cube), 3, TOL_ROUNDING);
    CHECK_NEAR(fit_exponent(2, x, bent), 2, TOL_ROUNDING);
    /* log2 y = 0, 2, 2, 4 over 0, 1, 2, 3: slope 6 / 5 */
    CHECK_NEAR(fit_exponent(4, x, bent), 1.2, TOL_ROUNDING);
    CHECK_NEAR(fit_exponent(4, larger, bent), 1.2, TOL_ROUNDING);
    CHECK(isnan(fit_exponent(4, x, bad)));
    return check_result();
}
