/* Table 4 on a quick run of all its cases: what its columns and sentences rest on. */
#include "bench/tables/table4.h"

#include "bench/files/store.h"
#include "bench/experiment/plan.h"
#include "bench/experiment/plan_read.h"
#include "tests/fresh.h"
#include "tests/said.h"

static const char *folder;

/* The paper's words as printed, and that its yes or no is a function of E/rho. */
static void test_paper(void)
{
    static const int want[PAPER_LABELS] = {8, 7, 3, 1, 1};
    bool yes[PAPER_TABLE4_ROWS];
    double ratio[PAPER_TABLE4_ROWS];

    for (int label = 0; label < PAPER_LABELS; label++)
        CHECK(table4_paper(label, yes) == want[label]);
    CHECK(table4_paper(-1, yes) == 2 && yes[13] && yes[14]);
    for (int row = 0; row < PAPER_TABLE4_ROWS; row++)
        ratio[row] = paper_table4[row].young / paper_table4[row].density;
    CHECK(table4_best(PAPER_TABLE4_ROWS, ratio, yes, TABLE4_ANY).agree == 18);
}

/* Undamped runs are shared by rows of the same E/rho: 8 of them; others are not. */
static void test_shared_runs(void)
{
    int runs[TABLE4_READINGS] = {0};

    for (int r = 0; r < TABLE4_READINGS; r++)
        for (int row = 0; row < PAPER_TABLE4_ROWS; row++)
            runs[r] += table4_run_of(r, row) == row;
    for (int r = 0; r < TABLE4_READINGS; r++)
        CHECK(runs[r] == (table4_reading[r].damping == TABLE4_UNDAMPED ? 8 : 18));
    CHECK(table4_run_of(TABLE4_SHELL, 8) == 7 && table4_run_of(TABLE4_SOLID, 14) == 13);
}

static void test_runs(const struct table4_data *d)
{
    const struct run_result *row7 = &d->run[TABLE4_PRINTED][TABLE4_DROP][6].result;

    /* the one row that the paper calls chaotic dies on the horizontal drop, and alone */
    CHECK(status_is_death(row7->outcome));
    CHECK(row7->value[MEASURE_BLOWUP_TIME] > 0.25 &&
          row7->value[MEASURE_BLOWUP_TIME] < 0.3);
    CHECK(row7->death_time == 53 * 0.005); /* as `run` and a sweep have it: one_death.sh */
    for (int row = 0; row < PAPER_TABLE4_ROWS; row++) {
        CHECK(d->run[TABLE4_PRINTED][TABLE4_FLAG][row].result.outcome == STATUS_OK);
        CHECK(row == 6 ||
              d->run[TABLE4_PRINTED][TABLE4_DROP][row].result.outcome == STATUS_OK);
    }
    for (int n = 0; n < TABLE4_SCALED; n++)
        CHECK(!memcmp(d->scaled[n].value,
                      d->run[TABLE4_PRINTED][TABLE4_FLAG][table4_scaled[n]].result.value,
                      sizeof d->scaled[n].value));
    for (int r = 0; r < TABLE4_READINGS; r++)
        for (int row = 0; row < PAPER_TABLE4_ROWS; row++) {
            const double *value = d->run[r][TABLE4_FLAG][row].result.value;
            const struct paper_table4_row *p = &paper_table4[row];
            CHECK(!run_result_refused(&d->run[r][TABLE4_FLAG][row].result));
            CHECK_RELATIVE(value[MEASURE_YOUNG_OVER_DENSITY], p->young / p->density, 1e-15);
        }
    /* the slower the shell is made, the later it is where it will be */
    const struct table4_run *rate = d->run[TABLE4_SHELL_RATE][TABLE4_DROP];
    CHECK(rate[15].result.value[MEASURE_DROP_MAX] <
          rate[16].result.value[MEASURE_DROP_MAX]);
    CHECK(rate[16].result.value[MEASURE_DROP_MAX] <
          rate[17].result.value[MEASURE_DROP_MAX]);
    CHECK(rate[17].result.value[MEASURE_DROP_MAX] <
          d->run[TABLE4_SHELL][TABLE4_DROP][17].result.value[MEASURE_DROP_MAX]);
    /* the same sheet with an elastic law does not stretch as the printed one does */
    CHECK(row7->value[MEASURE_STRETCH_MAX] > 1.1);
    for (int row = 0; row < PAPER_TABLE4_ROWS; row++) {
        CHECK(d->run[TABLE4_SHELL][TABLE4_DROP][row].result.value[MEASURE_STRETCH_MAX] <
              1.1);
        CHECK(d->run[TABLE4_SOLID][TABLE4_DROP][row].result.value[MEASURE_STRETCH_MAX] <
              1.1);
    }
}

/* What a reading makes of row 3, mu = 0.5, from the files: its scheme and its damping. */
static void test_readings(void)
{
    static const char *const scheme[TABLE4_READINGS] = {
        "printed",   "incremental", "incremental", "linear",
        "nonlinear", "nonlinear",   "nonlinear"};
    char path[4096], want[64];

    for (int r = 0; r < TABLE4_READINGS; r++) {
        const enum table4_damping damping = table4_reading[r].damping;
        struct store_read *file = NULL;
        struct scene scene;
        char *text = NULL;
        table4_path(folder, r, TABLE4_DROP, 2, path, sizeof path);
        REQUIRE(store_read_open(path, &file, NULL) == STATUS_OK);
        REQUIRE(store_scene(file, path, &scene, NULL) == STATUS_OK);
        REQUIRE(store_read_text(file, "/", "discretization", &text, NULL) == STATUS_OK);
        snprintf(want, sizeof want, "kinematics=%s", scheme[r]);
        CHECK(strstr(text, want) && !strcmp(scene.name, "edge_drop"));
        CHECK(scene.young == 1e4 && scene.density == 0.1);
        CHECK(scene.damping.kind == (damping == TABLE4_SCALE  ? DAMPING_VELOCITY_SCALE
                                     : damping == TABLE4_RATE ? DAMPING_MASS
                                                              : DAMPING_NONE));
        if (damping == TABLE4_SCALE)
            CHECK(scene.damping.value == 0.5);
        if (damping == TABLE4_RATE) /* what it leaves of a speed in a frame */
            CHECK_NEAR(exp(-scene.damping.value * scene.step), 0.5, 1e-15);
        free(text);
        scene_clear(&scene);
        store_read_close(file);
    }
}

static void test_agreement(const struct table4_data *d)
{
    bool yes[PAPER_TABLE4_ROWS];

    for (int r = 0; r < TABLE4_READINGS; r++)
        for (int s = 0; s < TABLE4_SCENES; s++)
            for (int label = -1; label < PAPER_LABELS; label++) {
                struct table4_agreement a = table4_agree(d, r, s, label);
                CHECK(a.hit + a.missed == table4_paper(label, yes));
                CHECK(a.agree == PAPER_TABLE4_ROWS - a.missed - a.extra);
            }
    struct table4_agreement chaos =
        table4_agree(d, TABLE4_PRINTED, TABLE4_DROP, PAPER_CHAOTIC);
    CHECK(chaos.hit == 1 && chaos.missed == 0);
}

/* Every label of the rules is a word of the paper's, and the other way round. */
static void test_rules(const struct table4_data *d)
{
    unsigned found = 0;

    for (int n = 0; n < d->rules.count; n++) {
        bool known = false;
        for (int label = 0; label < PAPER_LABELS; label++)
            if (!strcmp(d->rules.rule[n].label, paper_label[label]))
                known = true, found |= 1u << label;
        CHECK(known);
        CHECK(strlen(d->rules.rule[n].why) > 10);
    }
    CHECK(found == (1u << PAPER_LABELS) - 1);
}

/* The plan that can be swept has the paper's rows. */
static void test_plan(void)
{
    static const char *const key[3] = {"material.young", "material.density",
                                       "damping.value"};
    struct plan plan;
    struct message why = {""};

    REQUIRE(plan_read(SOURCE_DIR "/bench/plans/table4.yaml", &plan, &why) == STATUS_OK);
    REQUIRE(plan.listed_count == PAPER_TABLE4_ROWS);
    for (int row = 0; row < PAPER_TABLE4_ROWS; row++) {
        const double want[3] = {paper_table4[row].young, paper_table4[row].density,
                                paper_table4[row].damping};
        for (int n = 0; n < 3; n++) {
            const struct plan_setting *s =
                plan_settings_find(&plan.listed[row].settings, key[n]);
            CHECK(s && strtod(s->value, NULL) == want[n]);
        }
    }
    plan_clear(&plan);
}

static void test_words(void)
{
    char text[64];

    CHECK(!strcmp(table4_words(0, text, sizeof text), "-"));
    CHECK(!strcmp(table4_words(3, text, sizeof text), "over-stretched, penetration"));
    CHECK(!strcmp(table4_words(3, text, 6), "over-"));
}

/* What a quick run prints: what it measured, and no verdict. */
static void test_print(void)
{
    struct message why = {""};

    for (int format = TABLE_TEXT; format <= TABLE_JSON; format++) {
        struct said s;
        said_open(&s);
        CHECK(table4_exhibit.print(folder, format, s.file, &why) == STATUS_OK);
        said_close(&s, false);
        said_has(&s, "quick", "not judged: quick");
        said_has(&s, "quick", "in 3 of 3 runs: the motion depends on");
        said_lacks(&s, "quick", "Agreement");
        said_lacks(&s, "quick", "Physics, or");
        said_lacks(&s, "quick", "Penetration: the printed");
        said_lacks(&s, "quick", "Yes or no: ");
        said_clear(&s);
    }
    CHECK(table4_exhibit.print("/proc/nowhere", TABLE_TEXT, stdout, &why) == STATUS_FILE);
    CHECK(strstr(why.text, "/proc/nowhere/"));
}

/* Points of a panel: of each row the paper's words and ours, one for no word at all. */
static int points(const struct table4_run *run)
{
    int count = 0;

    for (int row = 0; row < PAPER_TABLE4_ROWS; row++) {
        const unsigned labels[] = {paper_table4[row].labels, run[row].labels};
        for (int who = 0; who < 2; who++)
            for (int n = labels[who] ? 0 : PAPER_LABELS - 1; n < PAPER_LABELS; n++)
                count += labels[who] ? labels[who] >> n & 1 : 1;
    }
    return count;
}

/* The chart: all labels of both panels of a reading, at their places. */
static void test_chart(const struct table4_data *d)
{
    static const int shown[] = {TABLE4_PRINTED, TABLE4_SHELL};
    char begin[48];
    struct said s;

    said_open(&s);
    CHECK(table4_print(d, folder, TABLE_TEXT, s.file, NULL) == STATUS_OK);
    said_close(&s, true);
    said_clear(&s);
    said_read(&s, folder, "table4.gp");
    CHECK(said_count(&s, "set xrange [25000:1600000]") == 12);
    CHECK(said_count(&s, "set yrange [-0.02:1.02]") == 12);
    for (int panel = 0; panel < 4; panel++) {
        int lines = 0;
        for (int series = 0; series <= PAPER_LABELS + 1; series++) {
            snprintf(begin, sizeof begin, "$p%d_%d << EOD\n", panel, series);
            const char *at = strstr(s.text, begin);
            for (at = at ? at + strlen(begin) : "EOD"; strncmp(at, "EOD", 3) != 0; lines++)
                at = strchr(at, '\n') + 1;
        }
        CHECK(lines == points(d->run[shown[panel / 2]][panel % 2]));
    }
    /* the paper's row 14, feasible, and its row 10: stretched and, beside it, wrinkles */
    said_has(&s, "chart", "$p0_0 << EOD\n");
    said_has(&s, "chart", "\n333333.333 0.215\n");
    said_has(&s, "chart", "\n166666.667 0.315\n");
    said_has(&s, "chart", "\n183333.333 0.315\n");
    said_has(&s, "chart", "wrinkles too fine");
    said_has(&s, "chart", "not named");
    said_clear(&s);
}

/* Judged as whole ones: for what their numbers say of the readings. */
static void take_for_whole(struct table4_data *d)
{
    CHECK(d->quick);
    for (int r = 0; r < TABLE4_READINGS; r++)
        for (int s = 0; s < TABLE4_SCENES; s++)
            for (int row = 0; row < PAPER_TABLE4_ROWS; row++) {
                struct table4_run *run = &d->run[r][s][row];
                CHECK(run->result.quick && !run->judged && !run->feasible && !run->labels);
                run->result.quick = false;
            }
    table4_judge(d);
    CHECK(!d->quick && d->run[TABLE4_PRINTED][TABLE4_DROP][6].judged);
    CHECK(!d->run[TABLE4_PRINTED][TABLE4_DROP][6].feasible);
}

int main(int argc, char **argv)
{
    struct message why = {""};
    struct table4_data *d = NULL;

    REQUIRE(argc == 2);
    folder = argv[1];
    struct experiment_options options = {.folder = folder, .quick = true};
    fresh_folder(folder);
    test_paper();
    test_shared_runs();
    test_words();
    test_plan();
    if (table4_exhibit.measure(&options, &why) != STATUS_OK ||
        table4_load(folder, &d, &why) != STATUS_OK) {
        printf("%s\n", why.text);
        return 1;
    }
    take_for_whole(d);
    test_runs(d);
    test_readings();
    test_agreement(d);
    test_rules(d);
    test_print();
    test_chart(d);
    table4_clear(d);
    return check_result();
}
