/* Verdicts: rules are read, and applied the same to every case. (What is refused:
 * commands/sweep.cases.) */
#include "bench/experiment/rules.h"

#include "bench/experiment/judge.h"
#include "bench/harness/run_result.h"
#include "tests/check.h"

static const char good[] =
    "- {label: over-stretched, measure: stretch_max, above: 1.1, why: Provot 1995}\n"
    "- {label: penetration, measure: intersection_time, below: 1000, why: matter}\n"
    "- {label: chaotic, measure: blowup_time, below: 1000, why: it died}\n"
    "- {label: over-stretched, measure: drop_end, above: 1.2, why: the same}\n"
    "- {label: won energy, measure: energy_drift_max, above: 0.1, why: no motor}\n";

static struct arena arena; /* of all rules */

static enum status read_rules(const char *text, struct rules *rules, struct message *why)
{
    struct yaml_tree *tree = NULL;

    REQUIRE(yaml_tree_parse("rules.yaml", false, text, strlen(text), &tree, why) ==
            STATUS_OK);
    enum status st = rules_read(tree, &arena, rules, why);
    yaml_tree_free(tree);
    return st;
}

/* A run that came well to its end. */
static struct run_result sound(void)
{
    struct run_result r = {.outcome = STATUS_OK};

    r.value[MEASURE_STRETCH_MAX] = 1.1; /* on the bound: not above it */
    r.value[MEASURE_DROP_END] = 1;
    r.value[MEASURE_INTERSECTION_TIME] = r.value[MEASURE_BLOWUP_TIME] = INFINITY;
    return r;
}

/* The sound run with up to three other measures, and how it is then called. */
static const struct judged {
    enum status outcome;
    bool quick;
    struct {
        enum measure measure;
        double value;
    } with[3];
    enum verdict kind;
    const char *text, *has, *lacks; /* labels it has; labels that nobody can say         */
} judged[] = {
    /* clang-format off */
    {STATUS_OK, false, {{0}}, VERDICT_FEASIBLE, "feasible", "", ""},
    {STATUS_OK, false, {{MEASURE_STRETCH_MAX, 1.2}}, VERDICT_INFEASIBLE, "over-stretched",
     "over-stretched", ""},
    /* by two rules, said once */
    {STATUS_OK, false, {{MEASURE_STRETCH_MAX, 1.2}, {MEASURE_DROP_END, 1.3}},
     VERDICT_INFEASIBLE, "over-stretched", "over-stretched", ""},
    {STATUS_OK, false, {{MEASURE_DROP_END, 1.3}, {MEASURE_INTERSECTION_TIME, 0.5}},
     VERDICT_INFEASIBLE, "penetration, over-stretched", "penetration, over-stretched", ""},
    {STATUS_OK, false, {{MEASURE_INTERSECTION_TIME, 1000}}, VERDICT_FEASIBLE, "feasible",
     "", ""}, /* on the bound: not below it */
    /* what was not measured is neither */
    {STATUS_OK, false, {{MEASURE_INTERSECTION_TIME, NAN}}, VERDICT_UNJUDGED,
     "not judged: penetration", "", "penetration"},
    {STATUS_OK, false, {{MEASURE_INTERSECTION_TIME, NAN}, {MEASURE_ENERGY_DRIFT_MAX, NAN}},
     VERDICT_UNJUDGED, "not judged: penetration, won energy", "",
     "penetration, won energy"},
    {STATUS_OK, false, {{MEASURE_INTERSECTION_TIME, NAN}, {MEASURE_DROP_END, 2}},
     VERDICT_INFEASIBLE, "over-stretched; not judged: penetration", "over-stretched",
     "penetration"},
    /* one rule of a label lacks its measure, the other gives it, or does not */
    {STATUS_OK, false, {{MEASURE_STRETCH_MAX, NAN}, {MEASURE_DROP_END, 2}},
     VERDICT_INFEASIBLE, "over-stretched", "over-stretched", ""},
    {STATUS_OK, false, {{MEASURE_STRETCH_MAX, NAN}, {MEASURE_DROP_END, 1.2}},
     VERDICT_UNJUDGED, "not judged: over-stretched", "", "over-stretched"},
    /* a death is infeasible, whatever the rules say */
    {STATUS_ESCAPED, false, {{0}}, VERDICT_INFEASIBLE, "died", "", ""},
    {STATUS_ESCAPED, false, {{MEASURE_INTERSECTION_TIME, NAN}}, VERDICT_INFEASIBLE,
     "died; not judged: penetration", "", "penetration"},
    {STATUS_NAN, false, {{MEASURE_BLOWUP_TIME, 0.3}}, VERDICT_INFEASIBLE, "chaotic",
     "chaotic", ""},
    {STATUS_UNSUPPORTED, false, {{MEASURE_STRETCH_MAX, 2}}, VERDICT_NONE, "unsupported", "",
     ""},
    {STATUS_INPUT, false, {{MEASURE_STRETCH_MAX, NAN}}, VERDICT_NONE, "unsupported", "",
     ""},
    {STATUS_OK, true, {{0}}, VERDICT_UNJUDGED, "not judged: quick", "", ""},
    {STATUS_NAN, true, {{MEASURE_STRETCH_MAX, 2}}, VERDICT_UNJUDGED, "not judged: quick",
     "", ""},
    /* clang-format on */
};

static void test_verdicts(void)
{
    static const char *const labels[] = {"over-stretched", "penetration", "chaotic",
                                         "won energy"};
    struct rules rules;

    REQUIRE(read_rules(good, &rules, NULL) == STATUS_OK && rules.count == 5);
    for (size_t n = 0; n < sizeof judged / sizeof *judged; n++) {
        const struct judged *j = &judged[n];
        struct run_result r = sound();
        char text[128];

        r.outcome = j->outcome;
        r.quick = j->quick;
        for (int i = 0; i < 3; i++)
            if (j->with[i].value != 0)
                r.value[j->with[i].measure] = j->with[i].value;
        const struct ruling v = rules_of(&rules, &r);
        bool fine = v.kind == j->kind && v.quick == j->quick;
        fine = fine && !strcmp(rules_text(&rules, v, text, sizeof text), j->text);
        for (int i = 0; i < 4; i++) {
            fine = fine && rules_has(&rules, v, labels[i]) == !!strstr(j->has, labels[i]);
            fine =
                fine && rules_lacks(&rules, v, labels[i]) == !!strstr(j->lacks, labels[i]);
        }
        CHECK_SAY(fine, "row %zu: '%s', want '%s'", n, text, j->text);
    }
}

/* A case without rules is not feasible; a death stays one. */
static void test_no_rules(void)
{
    const struct rules none = {0};
    struct run_result r = sound();
    char text[64];

    r.outcome = STATUS_OK;
    const struct ruling lived = rules_of(&none, &r);
    CHECK(lived.kind == VERDICT_UNJUDGED);
    CHECK(!strcmp(rules_text(&none, lived, text, sizeof text), "not judged: no rules"));
    r.outcome = STATUS_NAN;
    const struct ruling died = rules_of(&none, &r);
    CHECK(died.kind == VERDICT_INFEASIBLE);
    CHECK(!strcmp(rules_text(&none, died, text, sizeof text), "died"));
}

static void test_rules(void)
{
    struct rules rules;

    REQUIRE(read_rules(good, &rules, NULL) == STATUS_OK && rules.count == 5);
    CHECK(rules.rule[0].measure == MEASURE_STRETCH_MAX && rules.rule[0].above);
    CHECK(rules.rule[1].bound == 1000 && !rules.rule[1].above);
    CHECK(!strcmp(rules.rule[2].why, "it died"));
}

/* --- How sentences turn. */

static const struct {
    double value[4];
    int count, sign;
    double bar;
    enum verdict turn;
} orders[] = {
    /* clang-format off */
    {{1, 2, 3, 4}, 4, 1, 0, VERDICT_HOLDS}, {{4, 3, 2, 1}, 4, 1, 0, VERDICT_FAILS},
    {{4, 3, 2, 1}, 4, -1, 0, VERDICT_HOLDS}, {{1, 2, 3, 4}, 4, -1, 0, VERDICT_FAILS},
    {{1, 2, 2, 4}, 4, 1, 0, VERDICT_FAILS}, /* no more is not more */
    {{1, 2, 3, 3}, 4, 1, 0, VERDICT_FAILS}, {{1, 2, 3, 2}, 3, 1, 0, VERDICT_HOLDS},
    /* the fourth is not asked for */
    {{1, NAN, 3, 4}, 4, 1, 0, VERDICT_OPEN}, {{NAN, 2, 3, 4}, 4, 1, 0, VERDICT_OPEN},
    {{1, 2, 3, NAN}, 4, 1, 0, VERDICT_OPEN}, {{3, NAN, 1, 4}, 4, 1, 0, VERDICT_FAILS},
    /* across the one that is missing */
    {{NAN, 3, 1, 4}, 4, 1, 0, VERDICT_FAILS}, {{NAN, NAN}, 2, 1, 0, VERDICT_OPEN},
    {{1, 1.2, 1.4}, 3, 1, 0.1, VERDICT_HOLDS}, {{1, 1.2, 1.25}, 3, 1, 0.1, VERDICT_OPEN},
    /* within the bar */
    {{1, 1.2, 1.15}, 3, 1, 0.1, VERDICT_OPEN}, {{1, 1.2, 1.2}, 3, 1, 0.1, VERDICT_OPEN},
    {{1, 1.2, 1.05}, 3, 1, 0.1, VERDICT_FAILS}, {{1.05, 1, 1.3, 1.1}, 4, 1, 0.1, VERDICT_FAILS},
    /* what is settled stays so */
    {{1, 2, 3}, 3, 1, NAN, VERDICT_OPEN}, {{3, 2, 1}, 3, 1, NAN, VERDICT_OPEN},
    {{1}, 1, 1, 0, VERDICT_OPEN}, /* nothing to compare with */
    /* clang-format on */
};

static const struct {
    double value, bound;
    enum verdict turn;
} bounds[] = {{1, 2, VERDICT_HOLDS},       {2, 1, VERDICT_FAILS},  {1, 1, VERDICT_FAILS},
              {NAN, 1, VERDICT_OPEN},      {1, NAN, VERDICT_OPEN}, {-2, -1, VERDICT_HOLDS},
              {1, INFINITY, VERDICT_HOLDS}};

/* Two judgements, in either order, and the joint one. */
static const enum verdict both[][3] = {{VERDICT_HOLDS, VERDICT_HOLDS, VERDICT_HOLDS},
                                       {VERDICT_HOLDS, VERDICT_FAILS, VERDICT_FAILS},
                                       {VERDICT_HOLDS, VERDICT_OPEN, VERDICT_OPEN},
                                       {VERDICT_FAILS, VERDICT_OPEN, VERDICT_FAILS},
                                       {VERDICT_FAILS, VERDICT_FAILS, VERDICT_FAILS},
                                       {VERDICT_OPEN, VERDICT_OPEN, VERDICT_OPEN},
                                       {VERDICT_HOLDS, VERDICT_QUICK, VERDICT_QUICK},
                                       {VERDICT_FAILS, VERDICT_QUICK, VERDICT_FAILS}};

#define COUNT(array) (sizeof(array) / sizeof *(array))

static void turns(void)
{
    for (size_t n = 0; n < COUNT(orders); n++)
        CHECK_SAY(judge_order(orders[n].count, orders[n].value, orders[n].sign,
                              orders[n].bar) == orders[n].turn,
                  "order %zu", n);
    for (size_t n = 0; n < COUNT(bounds); n++)
        CHECK_SAY(judge_below(bounds[n].value, bounds[n].bound) == bounds[n].turn,
                  "bound %zu", n);
    for (size_t n = 0; n < COUNT(both); n++)
        SAY_UNLESS(CHECK(judge_both(both[n][0], both[n][1]) == both[n][2]) &&
                       CHECK(judge_both(both[n][1], both[n][0]) == both[n][2]),
                   "both %zu", n);
    CHECK(judge_most(1, 2) == 2 && judge_most(2, 1) == 2);
    CHECK(isnan(judge_most(NAN, 1)) && isnan(judge_most(1, NAN)));
}

int main(void)
{
    turns();
    test_rules();
    test_no_rules();
    test_verdicts();
    arena_clear(&arena);
    return check_result();
}
