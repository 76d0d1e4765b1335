/* What a threshold can do at its best. */
#include "bench/tables/table4.h"

#include "tests/check.h"

static void expect(const double *value, const bool *yes, enum table4_bounds shape,
                   double low, double high, int agree)
{
    struct table4_interval best = table4_best(6, value, yes, shape);

    CHECK(best.agree == agree);
    CHECK(best.low == low && best.high == high);
}

int main(void)
{
    const double value[] = {3, 1, 2, 5, 4, 6};
    const bool middle[] = {true, false, true, false, true, false}; /* 2, 3, 4 */
    const bool top[] = {false, false, false, true, true, true};    /* 4, 5, 6 */
    const bool none[] = {false, false, false, false, false, false};
    const double odd[] = {3, NAN, 2, INFINITY, 4, NAN};

    expect(value, middle, TABLE4_ANY, 2, 4, 6);
    expect(value, middle, TABLE4_ABOVE, 2, INFINITY, 4);
    expect(value, middle, TABLE4_BELOW, -INFINITY, 4, 5);
    expect(value, top, TABLE4_ABOVE, 4, INFINITY, 6);
    expect(value, top, TABLE4_ANY, 4, 6, 6);
    expect(value, none, TABLE4_ANY, INFINITY, -INFINITY, 6); /* always no */
    expect(odd, middle, TABLE4_ANY, 2, 4, 6);
    expect(odd, top, TABLE4_ABOVE, 4, INFINITY, 5); /* NaN lies in no interval */
    return check_result();
}
