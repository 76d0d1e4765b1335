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
    r.value[MEASURE_ENERGY_DRIFT_MAX] = NAN; /* does not exist: matches nothing */
    return r;
}

static void expect(const struct verdict_rules *rules, const struct run_result *r,
                   enum verdict_kind kind, const char *want)
{
    struct verdict v = verdict_apply(rules, r->outcome, r->value);
    char text[128];

    printf("  %s\n", verdict_text(rules, v, text, sizeof text));
    CHECK(v.kind == kind);
    CHECK(!strcmp(text, want));
}

static void test_rules(void)
{
    struct verdict_rules rules;
    struct message why = {""};
    struct run_result r = sound();

    REQUIRE(read_rules(good, &rules, &why) == STATUS_OK && rules.count == 5);
    CHECK(rules.rule[0].measure == MEASURE_STRETCH_MAX && rules.rule[0].above);
    CHECK(rules.rule[1].bound == 1000 && !rules.rule[1].above);
    CHECK(!strcmp(rules.rule[2].why, "it died"));
    expect(&rules, &r, VERDICT_FEASIBLE, "feasible");
    r.value[MEASURE_STRETCH_MAX] = 1.2;
    r.value[MEASURE_DROP_END] = 1.3;
    expect(&rules, &r, VERDICT_INFEASIBLE, "over-stretched"); /* by two rules, said once */
    r.value[MEASURE_INTERSECTION_TIME] = 0.5;
    expect(&rules, &r, VERDICT_INFEASIBLE, "over-stretched, penetration");
    CHECK(verdict_has(&rules, verdict_apply(&rules, r.outcome, r.value), "penetration"));
    CHECK(!verdict_has(&rules, verdict_apply(&rules, r.outcome, r.value), "chaotic"));
    r = sound();
    r.outcome = STATUS_ESCAPED;
    expect(&rules, &r, VERDICT_INFEASIBLE, "died"); /* whatever the rules say */
    r.value[MEASURE_BLOWUP_TIME] = 0.3;
    expect(&rules, &r, VERDICT_INFEASIBLE, "chaotic");
    r.outcome = STATUS_UNSUPPORTED;
    expect(&rules, &r, VERDICT_NONE, "unsupported");
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
    test_rules();
    test_short_text();
    test_refusals();
    return check_result();
}
