/* What a sweep tells: its tables, cell by cell and row by row; its summary, each sentence
 * each way; the sentences that it keeps, of which no damaged one is believed. */
#include "bench/sweep/sweep.h"

#include <unistd.h>

#include "bench/files/seal.h"
#include "tests/sweep_fixture.h"

static const char plan_text[] =
    "name: told\nsource: a test\nscene: edge_drop\n"
    "settings: {time.end: 0.01, discretization.points: [4,4,2]}\n"
    "axes: [{key: damping.value, values: [0.1, 0.5]}]\n"
    "cases: [{name: \"light, so\"}, {material.density: 2}]\n"
    "verdicts:\n"
    "  - {label: big, measure: drop_max, above: 0.5, why: a test}\n"
    "  - {label: odd, measure: speed_max, below: 0.1, why: a test}\n"
    "  - {label: big, measure: stretch_max, above: 2, why: a test}\n";

/* --- The table. */

static const char header[] =
    "case,name,scene,time.end,discretization.points,model,material.density,damping.value,"
    "stretch_max,stretch_end,drop_max,drop_end,angle_max,angle_end,roughness_max,"
    "roughness_end,penetration_max,intersections_max,intersections_end,intersection_time,"
    "speed_max,speed_end,energy_drift_max,energy_drift_end,load_max,load_end,blowup_time,"
    "end_time,"
    "gamma_measured,young_over_density_measured,hanging_strain,truth_error_max,"
    "truth_error_end,truth_bar_end,verdict,labels,outcome\n";

/* A value that all measures have, and with it every one of them in the table. */
#define ALL(x)                                                                             \
    x "," x "," x "," x "," x "," x "," x "," x "," x "," x "," x "," x "," x "," x "," x  \
      "," x "," x "," x "," x "," x "," x "," x "," x "," x "," x "," x ","

static const struct told {
    struct sweep_row row; /* `value`: of all measures                                  */
    double value;
    enum status outcome;
    const char *line; /* in table.csv, but for the case's number                       */
    bool timed;       /* a line in seconds.csv                                         */
} told[] = {
    {{.state = SWEEP_ROW_RAN, .why = {"done"}},
     0.25,
     STATUS_OK,
     "\"light, so\",edge_drop,0.01,\"[4,4,2]\",iga,,0.1," ALL(
         "0.25") "feasible,feasible,done",
     true},
    {{.state = SWEEP_ROW_RAN, .why = {"died at t = 1 s: of \"x\""}},
     0.75,
     STATUS_NAN,
     "\"light, so\",edge_drop,0.01,\"[4,4,2]\",iga,,0.5," ALL(
         "0.75") "infeasible,big,\"died at t = 1 s: of \"\"x\"\"\"",
     true},
    {{.state = SWEEP_ROW_RAN, .why = {"no contact"}},
     NAN,
     STATUS_UNSUPPORTED,
     ",edge_drop,0.01,\"[4,4,2]\",iga,2,0.1," ALL("") "none,unsupported,no contact",
     true},
    {{.state = SWEEP_ROW_FAILED, .why = {"timed out after 1 s"}},
     7,
     STATUS_OK,
     ",edge_drop,0.01,\"[4,4,2]\",iga,2,0.5," ALL("") "none,no result,timed out after 1 s",
     false},
    {{.state = SWEEP_ROW_CUT, .why = {"killed"}},
     7,
     STATUS_OK,
     "\"light, so\",edge_drop,0.01,\"[4,4,2]\",iga,,0.1," ALL("") "none,run again,killed",
     false},
    {{.state = SWEEP_ROW_DAMAGED, .why = {"its file is damaged"}},
     7,
     STATUS_OK,
     "\"light, so\",edge_drop,0.01,\"[4,4,2]\",iga,,0.5," ALL(
         "") "none,run again,its file is damaged",
     false},
    {{.state = SWEEP_ROW_GONE, .why = {"its file is gone"}},
     7,
     STATUS_OK,
     ",edge_drop,0.01,\"[4,4,2]\",iga,2,0.1," ALL("") "none,run again,its file is gone",
     false},
    {{.state = SWEEP_ROW_RAN, .why = {"done"}},
     NAN,
     STATUS_OK,
     ",edge_drop,0.01,\"[4,4,2]\",iga,2,0.5," ALL(
         "") "not judged,\"not judged: big, odd\",done",
     true},
};
enum { TOLD = sizeof told / sizeof *told };

static void check_table(void)
{
    struct sweep_table table;
    struct plan plan;
    char want[16384], seconds[1024] = "case,create,steps,looks\n", labels[64];
    const struct sweep_folder folder = {.path = "."};

    sweep_fixture_plan(plan_text, &plan);
    REQUIRE(sweep_table_open(&table, &plan, &folder, NULL) == STATUS_OK);
    snprintf(want, sizeof want, "%s", header);
    for (int n = 0; n < TOLD; n++) {
        struct sweep_row row = told[n].row;
        struct plan_case c;
        char line[2048];

        REQUIRE(plan_case_given(&plan, n % 4, &c) == STATUS_OK);
        row.result.outcome = told[n].outcome;
        row.result.create_seconds = n + 0.5;
        row.result.step_seconds = n + 0.25;
        row.result.look_seconds = n;
        for (int i = 0; i < MEASURES; i++)
            row.result.value[i] = told[n].value;
        sweep_table_row(&table, &c, &row, labels, sizeof labels);
        if (!CHECK(strstr(told[n].line, labels)))
            printf("  row %d: label '%s'\n", n, labels);
        snprintf(line, sizeof line, "%d,%s\n", n % 4 + 1, told[n].line);
        strcat(want, line);
        snprintf(line, sizeof line, "%d,%g,%g,%d\n", n % 4 + 1, n + 0.5, n + 0.25, n);
        strcat(seconds, told[n].timed ? line : "");
        plan_case_clear(&c);
    }
    CHECK(table.feasible == 1 && table.died == 1 && table.unsupported == 1);
    CHECK(table.failed == 1 && table.open == 3 && table.unjudged == 1 && table.judged == 3);
    CHECK(table.labels[0] == 1 && table.labels[1] == 0 && table.labels[2] == 1);
    CHECK(table.lacking[0] == 1 && table.lacking[1] == 1 && table.lacking[2] == 1);
    REQUIRE(sweep_table_close(&table, NULL) == STATUS_OK);
    char *is = sweep_fixture_text("table.csv"), *took = sweep_fixture_text("seconds.csv");
    if (!CHECK(!strcmp(is, want)))
        printf("is:\n%swant:\n%s", is, want);
    if (!CHECK(!strcmp(took, seconds)))
        printf("is:\n%swant:\n%s", took, seconds);
    free(is);
    free(took);
    plan_clear(&plan);
}

/* A table that is given up leaves nothing. */
static void check_discard(void)
{
    struct sweep_table table;
    struct plan plan;

    sweep_fixture_plan(plan_text, &plan);
    unlink("table.csv");
    REQUIRE(sweep_table_open(&table, &plan, &(struct sweep_folder){.path = "."}, NULL) ==
            STATUS_OK);
    sweep_table_discard(&table);
    CHECK(access("table.csv", F_OK) != 0);
    CHECK(sweep_table_open(&table, &plan, &(struct sweep_folder){.path = "none"}, NULL) ==
          STATUS_FILE);
    plan_clear(&plan);
}

/* --- The summary. */

static const struct {
    struct sweep_table table;
    struct pool pool;
    const char *plot, *text; /* of the lines between the plan and the folder           */
} summaries[] = {
    {{.feasible = 4, .judged = 4},
     {.ran = 4, .hands = 2, .seconds = 6, .wall = 4},
     "",
     "\n  feasible                     4\n"
     "  big                          0\n"
     "  odd                          0\n"
     "\n4 cases run now, 2 at a time: 1.5 s of processor time each, 6 s in all within 4 s; "
     "efficiency 75.0 %.\n"},
    {{.feasible = 1, .judged = 3, .labels = {2, 1, 2}, .died = 1, .unsupported = 1},
     {0},
     "",
     "\n  feasible                     1\n"
     "  big                          2\n"
     "  odd                          1\n"
     "  died                         1   the numerics ended the run\n"
     "  unsupported                  1   the model leaves something out\n"
     "\nNothing was left to run.\n"},
    {{.judged = 3, .labels = {1, 0, 1}, .lacking = {1, 3, 1}, .unjudged = 2, .failed = 1},
     {0},
     "no plot: gnuplot is not installed",
     "\n  feasible                     0\n"
     "  big                          1   not judged in 1 more, where it was not measured\n"
     "  odd                      not judged: it was not measured\n"
     "  not judged                   2   no label, but not all could be asked for\n"
     "  no result                    1   timed out, crashed or refused: see table.csv\n"
     "\nNothing was left to run.\n"},
    {{.open = 4},
     {0},
     "",
     "\n  feasible                     0\n"
     "  big                          0\n"
     "  odd                          0\n"
     "  run again                    4   cut short, or damaged since: --resume does it\n"
     "\nNothing was left to run.\n"},
};

static char *print(const struct plan *plan, const struct pool *pool,
                   const struct sweep_table *table, const char *plot)
{
    char *text = NULL;
    size_t size;
    FILE *memory = open_memstream(&text, &size);

    REQUIRE(memory);
    CHECK(sweep_table_print(plan, &(struct sweep_folder){.path = "there"}, pool, table,
                            NULL, plot, memory) == STATUS_OK);
    REQUIRE(fclose(memory) == 0);
    return text;
}

static void check_print(void)
{
    struct plan plan;

    sweep_fixture_plan(plan_text, &plan);
    for (size_t n = 0; n < sizeof summaries / sizeof *summaries; n++) {
        const char *plot = summaries[n].plot;
        char want[2048];
        char *text = print(&plan, &summaries[n].pool, &summaries[n].table, plot);
        snprintf(want, sizeof want,
                 "told: 4 cases of edge_drop; 2 listed x 2 of damping.value\n%s"
                 "there: table.csv, seconds.csv, a file a case, 0 kB on average.\n%s%s",
                 summaries[n].text, plot, *plot ? "\n" : "");
        if (!CHECK(!strcmp(text, want)))
            printf("is:\n%swant:\n%s", text, want);
        free(text);
    }
    plan_clear(&plan);
}

/* Without rules nothing is said of feasible; with a map it is named where it was drawn; the
 * size of a file is the mean of those that are there. */
static void check_print_rest(void)
{
    struct plan plan;
    const struct pool pool = {0};
    const struct sweep_table table = {.feasible = 2};

    sweep_fixture_plan(
        "name: bare\nsource: a test\naxes: [{key: scene, values: [edge_drop]}, "
        "{key: damping.value, values: [0.1, 0.5]}]\n"
        "map: {x: damping.value, y: drop_max}\n",
        &plan);
    REQUIRE(folder_make("there", NULL) == STATUS_OK);
    FILE *file = fopen("there/case_000002.h5", "w");
    for (int n = 0; n < 2500; n++)
        fputc('x', file);
    fclose(file);
    char *text = print(&plan, &pool, &table, "");
    CHECK(!strcmp(text,
                  "bare: 2 cases; 1 of scene x 2 of damping.value\n\n\nNothing was left "
                  "to run.\nthere: table.csv, seconds.csv, map.png, a file a case, "
                  "2.5 kB on average.\n"));
    free(text);
    text = print(&plan, &pool, &table, "no plot");
    CHECK(strstr(text, "seconds.csv, a file a case") && strstr(text, "\nno plot\n"));
    free(text);
    unlink("there/case_000002.h5");
    plan_clear(&plan);
}

/* A second opinion has a column, a count, and its bounds in the summary. */
static void check_learnt(void)
{
    static const struct {
        enum sweep_row_state state;
        double value;
        const char *ends; /* its line of table.csv                                     */
    } cases[] = {{SWEEP_ROW_RAN, 0.4, ",feasible,feasible,done,feasible\n"},
                 {SWEEP_ROW_RAN, 0.6, ",infeasible,big,done,feasible\n"},
                 {SWEEP_ROW_RAN, 0.8, ",infeasible,big,done,long\n"},
                 {SWEEP_ROW_FAILED, 0.4, ",none,no result,done,\n"}};
    struct sweep_table table;
    struct plan plan;
    char text[1024], labels[64];

    snprintf(text, sizeof text, "%s%s", plan_text,
             "learnt: [{label: long, measure: drop_max, above: 0.7, why: a test}]\n");
    sweep_fixture_plan(text, &plan);
    REQUIRE(sweep_table_open(&table, &plan, &(struct sweep_folder){.path = "."}, NULL) ==
            STATUS_OK);
    for (int n = 0; n < 4; n++) {
        struct sweep_row row = sweep_fixture_ran(cases[n].value);
        struct plan_case c;

        row.state = cases[n].state;
        REQUIRE(plan_case_given(&plan, n, &c) == STATUS_OK);
        CHECK(sweep_table_row(&table, &c, &row, labels, sizeof labels) == (n < 2));
        plan_case_clear(&c);
    }
    CHECK(table.feasible == 1 && table.learnt == 2);
    char *said = print(&plan, &(struct pool){0}, &table, "");
    sweep_fixture_holds("learnt", said,
                        "\n  feasible                     2   by bounds learnt "
                        "from the paper's words:\n");
    sweep_fixture_holds("learnt", said, " no long: drop_max above 0.7\n");
    free(said);
    REQUIRE(sweep_table_close(&table, NULL) == STATUS_OK);
    char *is = sweep_fixture_text("table.csv");
    sweep_fixture_holds("learnt", is, ",outcome,learnt\n");
    for (int n = 0; n < 4; n++)
        sweep_fixture_holds("learnt", is, cases[n].ends);
    free(is);
    plan_clear(&plan);
}

/* --- Sentences of cases. */

static const struct sweep_folder here = {.path = ".", .plan = 0x12, .program = 0xabcd1234};

/* What the case's file is made for when a part of it is another. */
static void made_for_of(const struct plan *plan, int n, int plan_sum, int program_sum,
                        char text[SWEEP_ROW_MADE_FOR])
{
    struct sweep_folder other = here;
    struct plan_case c;

    other.plan += (unsigned)plan_sum;
    other.program += (unsigned)program_sum;
    REQUIRE(plan_case_given(plan, n, &c) == STATUS_OK);
    sweep_row_made_for(&other, plan, &c, text);
    plan_case_clear(&c);
}

static void check_sentences(const struct plan *plan)
{
    static const struct {
        enum sweep_row_state state;
        const char *text;
    } kept[] = {
        {SWEEP_ROW_FAILED, "timed out after 1 s"},
        {SWEEP_ROW_CUT, "out of memory; --resume runs it again"},
    };
    static const struct {
        int n, plan, program;
        const char *text;
    } other[] = {
        {1, 0, 0, "./case_000001.txt: is of another case; take it away, or give another"},
        {2, 0, 0, "./case_000001.txt: is of another case;"},
        {0, 1, 0, "./case_000001.txt: is of another plan or scene; take it away"},
        {1, 1, 1, "./case_000001.txt: is of another build of the program; take it"},
    };
    char made_for[SWEEP_ROW_MADE_FOR], wanted[SWEEP_ROW_MADE_FOR];
    struct sweep_row row;

    made_for_of(plan, 0, 0, 0, made_for);
    for (int n = 0; n < 2; n++) {
        char said[64];
        snprintf(said, sizeof said, "%.*s", (int)strcspn(kept[n].text, ";"), kept[n].text);
        REQUIRE(sweep_row_write(&here, 0, made_for, kept[n].state, said, NULL) ==
                STATUS_OK);
        sweep_row_read(&here, 0, made_for, false, &row);
        CHECK(row.state == kept[n].state && !strcmp(row.why.text, kept[n].text));
        CHECK(sweep_row_is_open(&row) == (row.state == SWEEP_ROW_CUT));
        sweep_row_read(&here, 0, NULL, false, &row);
        CHECK(row.state == kept[n].state);
    }
    for (size_t n = 0; n < sizeof other / sizeof *other; n++) {
        made_for_of(plan, other[n].n, other[n].plan, other[n].program, wanted);
        sweep_row_read(&here, 0, wanted, false, &row);
        CHECK(row.state == SWEEP_ROW_FOREIGN && !sweep_row_is_open(&row));
        sweep_fixture_holds("another", row.why.text, other[n].text);
    }
    sweep_row_read(&here, 1, made_for, false, &row);
    CHECK(row.state == SWEEP_ROW_GONE && sweep_row_is_open(&row));
    CHECK(!strcmp(row.why.text, "its file is gone; --resume runs it again"));
}

/* Every byte changed, and every beginning of the file: damaged. */
static void check_damaged(const struct plan *plan)
{
    static const char path[] = "case_000001.txt";
    char made_for[SWEEP_ROW_MADE_FOR];
    char *text = sweep_fixture_text(path);
    const size_t size = strlen(text);
    struct sweep_row row;

    made_for_of(plan, 0, 0, 0, made_for);
    for (size_t n = 0; n < 2 * size; n++) {
        FILE *file = fopen(path, "w");
        const size_t count = n < size ? n : size;
        text[n % size] ^= n < size ? 0 : 1;
        REQUIRE(file && fwrite(text, 1, count, file) == count && fclose(file) == 0);
        text[n % size] ^= n < size ? 0 : 1;
        sweep_row_read(&here, 0, n % 2 ? made_for : NULL, false, &row);
        if (!CHECK(row.state == SWEEP_ROW_DAMAGED && sweep_row_is_open(&row)))
            printf("  change %zu of %zu: '%s'\n", n, size, row.why.text);
        CHECK(!strcmp(row.why.text, "its file is damaged; --resume runs it again"));
    }
    free(text);
    /* sealed, but no sentence of ours */
    static const char *const no_sentence[] = {"", "case\n", "case\nfailed\n",
                                              "case\nslept\nso it is\n"};
    for (size_t n = 0; n < sizeof no_sentence / sizeof *no_sentence; n++) {
        REQUIRE(seal_text_write(path, no_sentence[n], NULL) == STATUS_OK);
        sweep_row_read(&here, 0, NULL, false, &row);
        CHECK(row.state == (n == 2 ? SWEEP_ROW_FAILED : SWEEP_ROW_DAMAGED));
    }
    sweep_row_remove(&here, 0);
    CHECK(access(path, F_OK) != 0);
}

static void check_rows(void)
{
    struct plan plan;

    sweep_fixture_plan(plan_text, &plan);
    unlink("case_000001.h5");
    check_sentences(&plan);
    check_damaged(&plan);
    plan_clear(&plan);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    sweep_fixture_begin(argv[1]);
    check_table();
    check_discard();
    check_print();
    check_print_rest();
    check_learnt();
    check_rows();
    return check_result();
}
