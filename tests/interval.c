/* What a threshold can do at its best, and what one that was learnt from all rows but one
 * says of that one. */
#include "bench/tables/table4.h"

#include "tests/said.h"

static void expect(const double *value, const bool *yes, enum table4_bounds shape,
                   double low, double high, int agree)
{
    struct table4_interval best = table4_best(6, value, yes, shape);

    CHECK(best.agree == agree);
    CHECK(best.low == low && best.high == high);
}

/* Bounds half way between values; what a lone row alone taught is not known without it. */
static void learns(void)
{
    const double value[] = {2.5, 1, 2, 5, 4, 6};
    const bool top[] = {false, false, false, true, true, true}; /* 4, 5, 6 */
    const bool lone[] = {false, false, false, false, false, true};
    const bool odd[] = {false, true, false, true, true, true}; /* 1 among those above 2.5 */
    const double missing[] = {2.5, 1, NAN, 5, 4, 6};
    struct table4_lesson l = table4_learn(6, value, top, TABLE4_ABOVE);

    CHECK(l.bounds.low == 3.25 && l.bounds.high == INFINITY);
    for (int n = 0; n < 6; n++)
        CHECK(l.fitted[n] == top[n] && l.left_out[n] == top[n]);
    l = table4_learn(6, value, lone, TABLE4_ANY);
    CHECK(l.bounds.low == 5.5 && l.fitted[5] && !l.left_out[5]);
    l = table4_learn(6, value, odd, TABLE4_ABOVE);
    CHECK(!l.fitted[1] && !l.left_out[1] && l.fitted[4]);
    l = table4_learn(6, missing, top, TABLE4_ABOVE);
    CHECK(!l.fitted[2] && !l.left_out[2] && l.left_out[4]);
    const double never[] = {INFINITY, INFINITY, INFINITY,
                            0.3,      0.5,      0.4}; /* times that did not come */
    l = table4_learn(6, never, top, TABLE4_BELOW);
    CHECK(l.bounds.high == 0.5 && !l.fitted[0] && !l.left_out[0] && l.left_out[5]);
    l = table4_learn(6, value, top, TABLE4_BELOW); /* nothing to be learnt: always no */
    CHECK(l.bounds.agree == 3 && !l.fitted[0]);
}

/* Each label's measure sets its rows apart, on both scenes; `apart` false: nothing does. */
static void make(struct table4_data *d, bool apart)
{
    static const struct {
        int label, measure;
        double is, is_not;
    } sets[] = {{PAPER_OVER_STRETCHED, MEASURE_STRETCH_MAX, 1.6, 1.4},
                {PAPER_PENETRATION, MEASURE_INTERSECTIONS_MAX, 60, 0},
                {PAPER_TOO_LIGHT, MEASURE_ANGLE_MAX, 50, 85},
                {PAPER_CHAOTIC, MEASURE_BLOWUP_TIME, 1, INFINITY},
                {PAPER_FINE_WRINKLES, MEASURE_ROUGHNESS_MAX, 90, 8}};

    for (size_t n = 0; n < sizeof sets / sizeof *sets; n++) {
        bool yes[PAPER_TABLE4_ROWS];
        table4_paper(sets[n].label, yes);
        for (int s = 0; s < TABLE4_SCENES; s++)
            for (int row = 0; row < PAPER_TABLE4_ROWS; row++)
                d->run[TABLE4_PRINTED][s][row].result.value[sets[n].measure] =
                    apart && yes[row] ? sets[n].is : sets[n].is_not;
    }
}

static void tells(struct table4_data *d, bool apart, const char *const *has)
{
    struct said s;

    make(d, apart);
    said_open(&s);
    CHECK(table4_learn_print(d, TABLE_TEXT, s.file) == STATUS_OK);
    said_all(&s, apart ? "apart" : "alike", has);
}

int main(void)
{
    static struct table4_data d;
    struct message why = {""};

    REQUIRE(table4_rules(&d.rules, &d.learnt, &why) == STATUS_OK);
    tells(
        &d, true,
        (const char *const[]){
            "17 of 18 at best from what the runs show, 18 from E/rho alone, 16 by `no` to "
            "all: the runs teach something, the two parameters as much.",
            "over-stretched: stretch_max above 1.5 on flag, above 1.5 on edge_drop; by the "
            "rule above 1.1.",
            "they judge 9 of 18 rows as those above do; the plan's are of other runs.",
            "too light: angle_max below 67.5 on flag", "chaotic: blowup_time below 1 on",
            NULL});
    tells(
        &d, false,
        (const char *const[]){
            "2 of 18 at best from what the runs show, 18 from E/rho alone, 16 by `no` to "
            "all: the runs teach nothing about the paper's eye.",
            "penetration: intersections_max never on flag, never on edge_drop; by the rule",
            "they judge 18 of 18 rows as those above do. ", NULL});
    verdict_clear(&d.rules);
    verdict_clear(&d.learnt);
    const double value[] = {2.5, 1, 2, 5, 4, 6};
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
    learns();
    return check_result();
}
