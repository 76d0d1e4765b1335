/* Verdicts: rules are read, refused with a sentence, and applied the same to every case. */
#include "bench/experiment/verdict.h"

#include "bench/harness/run_result.h"
#include "tests/check.h"

static const char good[] =
    "- {label: over-stretched, measure: stretch_max, above: 1.1, why: Provot 1995}\n"
    "- {label: penetration, measure: intersection_time, below: 1000, why: matter}\n"
    "- {label: chaotic, measure: blowup_time, below: 1000, why: it died}\n"
    "- {label: over-stretched, measure: drop_end, above: 1.2, why: the same}\n"
    "- {label: won energy, measure: energy_drift_max, above: 0.1, why: no motor}\n";

static enum status read_rules(const char *text, struct verdict_rules *rules,
                              struct message *why)
{
    struct yaml_tree *tree = NULL;

    REQUIRE(yaml_tree_parse("rules.yaml", false, text, strlen(text), &tree, why) ==
            STATUS_OK);
    enum status st = verdict_read(tree, rules, why);
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

/* The sound run with up to two other measures, and how it is then called: labels that it
 * has, then those that nobody can say. */
enum {
    STRETCH = MEASURE_STRETCH_MAX,
    DROP = MEASURE_DROP_END,
    CROSSES = MEASURE_INTERSECTION_TIME,
    ENERGY = MEASURE_ENERGY_DRIFT_MAX,
    YES = VERDICT_FEASIBLE,
    NO = VERDICT_INFEASIBLE,
    OPEN = VERDICT_UNJUDGED,
    NONE = VERDICT_NONE,
    DONE = STATUS_OK
};
static const struct judged {
    int outcome, kind;
    const char *text;
    struct {
        int measure;
        double value;
    } with[2];
    bool quick;
} judged[] = {
    {DONE, YES, "feasible", {{0}}},
    {DONE, NO, "over-stretched", {{STRETCH, 1.2}}},
    /* by two rules, said once */
    {DONE, NO, "over-stretched", {{STRETCH, 1.2}, {DROP, 1.3}}},
    {DONE, NO, "penetration, over-stretched", {{DROP, 2}, {CROSSES, .5}}},
    {DONE, YES, "feasible", {{CROSSES, 1000}}}, /* on the bound */
    /* what was not measured is neither */
    {DONE, OPEN, "not judged: penetration", {{CROSSES, NAN}}},
    {DONE, OPEN, "not judged: penetration, won energy", {{CROSSES, NAN}, {ENERGY, NAN}}},
    {DONE, NO, "over-stretched; not judged: penetration", {{CROSSES, NAN}, {DROP, 2}}},
    /* one rule of a label lacks its measure, the other gives it, or does not */
    {DONE, NO, "over-stretched", {{STRETCH, NAN}, {DROP, 2}}},
    {DONE, OPEN, "not judged: over-stretched", {{STRETCH, NAN}, {DROP, 1.2}}},
    /* a death is infeasible, whatever the rules say */
    {STATUS_ESCAPED, NO, "died", {{0}}},
    {STATUS_ESCAPED, NO, "died; not judged: penetration", {{CROSSES, NAN}}},
    {STATUS_NAN, NO, "chaotic", {{MEASURE_BLOWUP_TIME, .3}}},
    {STATUS_UNSUPPORTED, NONE, "unsupported", {{STRETCH, 2}}},
    {STATUS_INPUT, NONE, "unsupported", {{STRETCH, NAN}}},
    {DONE, OPEN, "not judged: quick", {{0}}, true},
    {STATUS_NAN, OPEN, "not judged: quick", {{STRETCH, 2}}, true},
};

static void test_verdicts(void)
{
    static const char *const labels[] = {"over-stretched", "penetration", "chaotic",
                                         "won energy"};
    struct verdict_rules rules;

    REQUIRE(read_rules(good, &rules, NULL) == STATUS_OK && rules.count == 5);
    CHECK(rules.rule[0].measure == STRETCH && rules.rule[0].above);
    CHECK(rules.rule[1].bound == 1000 && !rules.rule[1].above);
    CHECK(!strcmp(rules.rule[2].why, "it died"));
    for (size_t n = 0; n < sizeof judged / sizeof *judged; n++) {
        const struct judged *j = &judged[n];
        struct run_result r = sound();
        char text[128];

        r.outcome = (enum status)j->outcome;
        r.quick = j->quick;
        for (int i = 0; i < 2; i++)
            if (j->with[i].value != 0)
                r.value[j->with[i].measure] = j->with[i].value;
        const struct verdict v = verdict_of(&rules, &r);
        bool fine = (int)v.kind == j->kind && v.quick == j->quick;
        fine = fine && !strcmp(verdict_text(&rules, v, text, sizeof text), j->text);
        const char *unsaid = strstr(j->text, "not judged: ");
        for (int i = 0; i < 4; i++) {
            const char *said = strstr(j->text, labels[i]);
            fine = fine && verdict_has(&rules, v, labels[i]) ==
                               (said && (!unsaid || said < unsaid));
            fine = fine &&
                   verdict_lacks(&rules, v, labels[i]) == (said && unsaid && said > unsaid);
        }
        if (!CHECK(fine))
            printf("  row %zu: '%s', want '%s'\n", n, text, j->text);
    }
    verdict_clear(&rules);
    CHECK(rules.count == 0);
}

/* Words that do not fit are cut, not written past the end. */
static void test_short_text(void)
{
    struct verdict_rules rules;
    struct run_result r = sound();
    char text[8];

    REQUIRE(read_rules(good, &rules, NULL) == STATUS_OK);
    r.value[MEASURE_STRETCH_MAX] = 2;
    r.value[MEASURE_INTERSECTION_TIME] = 0;
    CHECK(!strcmp(
        verdict_text(&rules, verdict_apply(&rules, r.outcome, r.value), text, sizeof text),
        "over-st"));
    verdict_clear(&rules);
}

static void test_refusals(void)
{
    static const struct {
        const char *text, *part;
    } bad[] = {
        {"label: x", "a list of 1 to 32 rules"},
        {"[]", "a list of 1 to 32 rules"},
        {"- 5", "rules.yaml:1: "},
        {"- {label: x, measure: stretch_max, above: 1}", "lacks the key 'why'"},
        {"- {label: x, measure: stretch, above: 1, why: y}", "stretch_max, stretch_end"},
        {"- {label: x, measure: stretch_max, why: y}", "one of above and below"},
        {"- {label: x, measure: stretch_max, above: 1, below: 2, why: y}",
         "one of above and below"},
        {"- {label: x, measure: stretch_max, above: high, why: y}", "above is 'high'"},
        {"- {label: x, measure: stretch_max, above: .inf, why: y}", "above is"},
        {"- {label: x, measur: stretch_max, above: 1, why: y}", "did you mean 'measure'"},
        {"- {label: x, measure: drop_max, above: 1, why: y}\n- {label: z}",
         "rules.yaml:2: "},
    };
    struct verdict_rules rules;

    for (size_t n = 0; n < sizeof bad / sizeof *bad; n++) {
        struct message why = {""};
        CHECK(read_rules(bad[n].text, &rules, &why) == STATUS_INPUT);
        printf("  %s\n", why.text);
        CHECK(strstr(why.text, bad[n].part) && !strchr(why.text, '\n'));
        CHECK(rules.count == 0);
    }
}

int main(void)
{
    test_verdicts();
    test_short_text();
    test_refusals();
    return check_result();
}
