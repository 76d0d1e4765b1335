/* What bounds can do at their best, and what those that were learnt from all answers but
 * one say of that one. */
#include "bench/experiment/learn.h"

#include "tests/check.h"

enum { COUNT = 6 };

static void expect(const double *value, const bool *yes, enum learn_shape shape, double low,
                   double high, int agree)
{
    const struct learnt w = learn(COUNT, value, yes, shape);
    int right = 0;

    for (int n = 0; n < COUNT; n++)
        right += w.fitted[n] == yes[n];
    CHECK(right == agree);
    CHECK(w.low == low && w.high == high);
}

/* Bounds half way between values. NaN lies in none. */
static void fits(void)
{
    const double value[] = {2.5, 1, 2, 5, 4, 6};
    const bool middle[] = {true, false, true, false, true, false}; /* 2, 3, 4 */
    const bool top[] = {false, false, false, true, true, true};    /* 4, 5, 6 */
    const bool none[] = {false, false, false, false, false, false};
    const double odd[] = {3, NAN, 2, INFINITY, 4, NAN};

    expect(value, middle, LEARN_ANY, 1.5, 4.5, 6);
    expect(value, middle, LEARN_ABOVE, 1.5, INFINITY, 4);
    expect(value, middle, LEARN_BELOW, -INFINITY, 4.5, 5);
    expect(value, top, LEARN_ABOVE, 3.25, INFINITY, 6);
    expect(value, top, LEARN_ANY, 3.25, INFINITY, 6);
    expect(value, top, LEARN_BELOW, INFINITY, -INFINITY, 3); /* never */
    expect(value, none, LEARN_ANY, INFINITY, -INFINITY, 6);
    expect(odd, middle, LEARN_ANY, -INFINITY, 4, 6);
    expect(odd, top, LEARN_ABOVE, 3.5, INFINITY, 5);
}

/* What a lone one alone taught is not known without it. */
static void leaves_out(void)
{
    const double value[] = {2.5, 1, 2, 5, 4, 6};
    const bool top[] = {false, false, false, true, true, true};
    const bool lone[] = {false, false, false, false, false, true};
    const bool odd[] = {false, true, false, true, true, true}; /* 1 among those above 2.5 */
    const double missing[] = {2.5, 1, NAN, 5, 4, 6};
    const double never[] = {INFINITY, INFINITY, INFINITY, /* times that did not come */
                            0.3,      0.5,      0.4};
    struct learnt l = learn(COUNT, value, top, LEARN_ABOVE);

    for (int n = 0; n < COUNT; n++)
        CHECK(l.fitted[n] == top[n] && l.left_out[n] == top[n]);
    l = learn(COUNT, value, lone, LEARN_ANY);
    CHECK(l.low == 5.5 && l.fitted[5] && !l.left_out[5]);
    l = learn(COUNT, value, odd, LEARN_ABOVE);
    CHECK(!l.fitted[1] && !l.left_out[1] && l.fitted[4]);
    l = learn(COUNT, missing, top, LEARN_ABOVE);
    CHECK(!l.fitted[2] && !l.left_out[2] && l.left_out[4]);
    l = learn(COUNT, never, top, LEARN_BELOW);
    CHECK(l.high == 0.5 && !l.fitted[0] && !l.left_out[0] && l.left_out[5]);
}

int main(void)
{
    fits();
    leaves_out();
    return check_result();
}
