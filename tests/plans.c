/* The plans that are sweeps, against a second transcription: thresholds, and which way
 * round; axes; the 18 rows of the paper's Table 4, as cases of one and as marks of the
 * other. */
#include "bench/claims/paper.h"
#include "bench/experiment/plan.h"
#include "tests/check.h"

static void read_plan(const char *name, struct plan *plan)
{
    char path[1024];
    struct message why = {""};

    snprintf(path, sizeof path, "%s/bench/plans/%s.yaml", SOURCE_DIR, name);
    if (!CHECK(plan_read(path, plan, &why) == STATUS_OK)) {
        printf("%s\n", why.text);
        exit(1);
    }
}

/* Provot's 10 %; matter; 10 degrees off the vertical; death; sqrt(g L) and a little; the
 * bending length of fabrics. */
static void check_rules(const struct verdict_rules *rules)
{
    static const struct {
        const char *label;
        enum measure measure;
        bool above;
        double bound;
    } want[] = {
        {"over-stretched", MEASURE_STRETCH_MAX, true, 1.1},
        {"penetration", MEASURE_INTERSECTIONS_MAX, true, 0},
        {"too light", MEASURE_ANGLE_MAX, false, 80},
        {"chaotic", MEASURE_BLOWUP_TIME, false, 1e6},
        {"chaotic", MEASURE_SPEED_MAX, true, 3.2},
        {"wrinkles too fine", MEASURE_ROUGHNESS_MAX, true, 60},
    };
    enum { RULES = sizeof want / sizeof *want };

    REQUIRE(rules->count == RULES);
    for (int n = 0; n < RULES; n++) {
        const struct verdict_rule *r = &rules->rule[n];
        if (!CHECK(!strcmp(r->label, want[n].label) && r->measure == (int)want[n].measure &&
                   r->above == want[n].above && r->bound == want[n].bound && *r->why))
            printf("  rule %d: %s, %s %s %g\n", n, r->label, measure_name(r->measure),
                   r->above ? "above" : "below", r->bound);
    }
}

static double number_of(const struct plan_settings *settings, const char *key)
{
    const struct plan_setting *s = plan_settings_find(settings, key);

    return s ? strtod(s->value, NULL) : NAN;
}

static bool is_row(const struct plan_settings *settings, int row)
{
    return number_of(settings, "material.young") == paper_table4[row].young &&
           number_of(settings, "material.density") == paper_table4[row].density &&
           number_of(settings, "damping.value") == paper_table4[row].damping;
}

static void check_setting(const struct plan *plan, const char *key, const char *want)
{
    const struct plan_setting *s = plan_settings_find(&plan->settings, key);

    if (!CHECK(s && !strcmp(s->value, want)))
        printf("  %s: %s is %s, want %s\n", plan->name, key, s ? s->value : "missing",
               want);
}

static void check_table4(void)
{
    struct plan plan;

    read_plan("table4", &plan);
    check_rules(&plan.verdicts);
    check_setting(&plan, "model", "iga_paper");
    check_setting(&plan, "time.end", "3");
    CHECK(plan.look == 10 && plan.intersections == 1 && plan.keep == PLAN_KEEP_NONE);
    REQUIRE(plan.listed_count == PAPER_TABLE4_ROWS && plan.axis_count == 1);
    CHECK(plan.axes[0].values.count == 2 && !strcmp(plan.axes[0].key, "scene"));
    CHECK(!strcmp(plan.axes[0].values.list[0].value, "flag"));
    CHECK(!strcmp(plan.axes[0].values.list[1].value, "edge_drop"));
    for (int row = 0; row < PAPER_TABLE4_ROWS; row++) {
        char name[16];
        snprintf(name, sizeof name, "row %d", row + 1);
        if (!CHECK(is_row(&plan.listed[row].settings, row) &&
                   !strcmp(plan.listed[row].name, name)))
            printf("  table4: %s\n", name);
    }
    plan_clear(&plan);
}

/* "paper: penetration, over-stretched": the labels that the paper gives a row. */
static void words_of(int row, char text[128])
{
    const unsigned labels = paper_table4[row].labels;
    /* the paper's order; it has short words for one */
    static const int order[] = {PAPER_PENETRATION, PAPER_FINE_WRINKLES,
                                PAPER_OVER_STRETCHED, PAPER_TOO_LIGHT, PAPER_CHAOTIC};

    snprintf(text, 128, "paper: %s", labels ? "" : "feasible");
    for (size_t n = 0; n < sizeof order / sizeof *order; n++)
        if (labels >> order[n] & 1)
            snprintf(text + strlen(text), 128 - strlen(text), "%s%s",
                     text[strlen(text) - 1] == ' ' ? "" : ", ",
                     order[n] == PAPER_FINE_WRINKLES ? "fine wrinkles"
                                                     : paper_label[order[n]]);
}

static void check_feasibility(void)
{
    static const char *const dampings[] = {"0.05", "0.1", "0.2", "0.3", "0.4",
                                           "0.5",  "0.6", "0.7", "0.8", "0.9"};
    static const char *const poissons[] = {"0", "0.15", "0.3", "0.4", "0.45"};
    struct plan plan;

    read_plan("feasibility", &plan);
    check_rules(&plan.verdicts); /* table4's */
    check_setting(&plan, "scene", "flag");
    check_setting(&plan, "time.end", "3");
    CHECK(plan.look == 20 && plan.intersections == 1 && plan.time_limit == 120);
    REQUIRE(plan.axis_count == 3 && plan_case_count(&plan) == 25 * 10 * 5);
    CHECK(plan.axes[0].scale == PLAN_AXIS_LOG && !strcmp(plan.axes[0].key, "gamma"));
    for (int n = 0; n < 25; n++)
        CHECK_RELATIVE(strtod(plan.axes[0].values.list[n].value, NULL),
                       5 * pow(1000, n / 24.), 1e-14);
    CHECK(!strcmp(plan.axes[1].key, "damping.value"));
    for (int n = 0; n < 10; n++)
        CHECK(!strcmp(plan.axes[1].values.list[n].value, dampings[n]));
    CHECK(!strcmp(plan.axes[2].key, "material.poisson"));
    for (int n = 0; n < 5; n++)
        CHECK(!strcmp(plan.axes[2].values.list[n].value, poissons[n]));
    CHECK(!strcmp(plan.map.x, "gamma") && !strcmp(plan.map.y, "damping.value"));
    CHECK(!strcmp(plan.map.panel, "material.poisson"));
    REQUIRE(plan.map.mark_count == PAPER_TABLE4_ROWS);
    for (int row = 0; row < PAPER_TABLE4_ROWS; row++) {
        const struct plan_mark *mark = &plan.map.marks[row];
        char words[128];
        words_of(row, words);
        if (!CHECK(is_row(&mark->settings, row) && atoi(mark->text) == row + 1 &&
                   number_of(&mark->settings, "material.poisson") == 0.3 &&
                   !strcmp(mark->label, words)))
            printf("  feasibility: mark %d is '%s', want '%s'\n", row + 1, mark->label,
                   words);
    }
    plan_clear(&plan);
}

/* A line for lists: what a plan is about; of studies alone; of a file that is none, why. */
static void check_lines(void)
{
    static const struct {
        const struct named_file_kind *kind;
        const char *path, *text;
    } lines[] = {
        {&plan_kind, SOURCE_DIR "/bench/plans/table4.yaml",
         "Ren et al. 2024, Table 4 (E read as 1e4, 5e4, 1e5 Pa)"},
        {&plan_study_kind, SOURCE_DIR "/bench/plans/table4.yaml", ""},
        {&plan_study_kind, SOURCE_DIR "/bench/plans/mesh.yaml", NULL},
        {&plan_kind, SOURCE_DIR "/README.md", NULL},
    };

    for (int n = 0; n < 4; n++) {
        char *text = lines[n].kind->describe(lines[n].path);
        if (!CHECK(text && (lines[n].text ? !strcmp(text, lines[n].text) : *text)))
            printf("  %s: '%s'\n", lines[n].path, text);
        CHECK(n < 3 || strstr(text, "README.md:"));
        free(text);
    }
}

int main(void)
{
    check_lines();
    check_table4();
    check_feasibility();
    return check_result();
}
