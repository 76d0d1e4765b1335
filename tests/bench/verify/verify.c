/* The command verify on checks that are made up: what it prints, counts and ends with for
 * every verdict; rows, subjects and their files. Nothing is computed. */
#include "bench/commands.h"
#include "bench/files/folder.h"
#include "bench/verify/verify.h"
#include "bench/verify/verify_check.h"
#include "tests/known_misses.h"
#include "tests/said.h"

static char folder[4096];

/* --- A check that adds rows as it is told. */

static const struct verify_subject entries[] = {
    {"iga_selective", 0.01, "asked", {6, 10}, {3}, .changed = "2 % before"},
    {"shell_3", 0.01, "asked", {7, 10}, {4}},
    {"mass_spring", 0, "nobody asks", {5}, .changed = "never claimed"},
    {NULL}};
static const struct verify_field field = {.subject = entries};

/* The script of the rows of `first`. */
static struct {
    double value, truth, bar;
    enum verdict end;   /* VERDICTS: it is judged                            */
    enum status status; /* of the check                                             */
} script;

static void add_first(struct verify_subject *s)
{
    struct verify_row *row = verify_sheet_add(s, "tip");

    row->seconds = 2;
    if (script.end == VERDICTS)
        verify_row_judge(row, script.value, script.truth, script.bar);
    else
        verify_row_end(row, script.end, "so it is");
    verify_sheet_holds(s->sheet, status_fail(&s->sheet->why, script.status, "first: torn"));
}

static void add_second(struct verify_subject *s)
{
    verify_row_judge_error(verify_sheet_add(s, "quantity %d", s->at), 0.001, 0);
}

static const struct verify_check first = {
    .item = {"first", "as told"}, .source = "made up", .parts = {{&field, add_first, 1}}};
static const struct verify_check second = {.item = {"second", "always met"},
                                           .source = "made up",
                                           .slow = true,
                                           .parts = {{&field, add_second, 2, .every = 2}}};
static const struct verify_check *const checks[] = {&first, &second, NULL};
static const struct verify_set made_up = {"verify", "check", checks, "results/verify",
                                          "met"};

/* --- The command. */

struct outcome {
    enum status status;
    struct message why;
    char *text; /* freed by the next call                                                */
};

/* Words and options, ended by NULL. */
static struct outcome command(const char *const *words)
{
    static struct said said;
    struct outcome o = {.why = {""}};
    struct command_line line;
    char *argv[16];
    int argc = 0;

    said_clear(&said);
    for (; words[argc]; argc++)
        argv[argc] = (char *)words[argc];
    REQUIRE(command_parse(&verify_command, argc, argv, &line, &o.why) == STATUS_OK);
    line.printer.file = said_open(&said);
    o.status = verify_run(&made_up, &line, &o.why);
    printer_close(&line.printer);
    o.text = said_text(&said);
    command_line_clear(&line);
    return o;
}
#define COMMAND(...) command((const char *const[]){__VA_ARGS__, NULL})

static struct outcome judge(double value, double truth, double bar)
{
    script.value = value, script.truth = truth, script.bar = bar;
    script.end = VERDICTS;
    return COMMAND("first", "--out", folder);
}

/* The numbers of a row of the last table: met, MISSED, no claim, out of range, not
 * applicable, died, rows. */
static bool counts(const struct outcome *o, const char *name, const char *want)
{
    char got[128] = "", line[32];
    const char *at = strstr(o->text, "How many rows end how");

    snprintf(line, sizeof line, "\n%s ", name);
    at = at ? strstr(at, line) : NULL;
    for (int n = 0, used = 1 + (int)strlen(name); at && n < 7; n++) {
        int value = -1, more = 0;
        sscanf(at + used, "%d%n", &value, &more);
        used += more;
        snprintf(got + strlen(got), sizeof got - strlen(got), "%s%d", n ? " " : "", value);
    }
    if (strcmp(got, want))
        printf("%s: %s, not %s\n", name, got, want);
    return !strcmp(got, want);
}

/* Errors are of the truth, whatever its size and sign; the bar is added to the claim. */
static void check_judged(void)
{
    static const struct {
        double value, truth, bar;
        bool met;
    } cases[] = {{40.3, 40, 0, true},      {40.5, 40, 0, false}, {-40.3, -40, 0, true},
                 {-40.5, -40, 0, false},   {40, -40, 0, false},  {0.005, 0.004, 0, false},
                 {40.5, 40, 0.004, true},  {39.5, 40, 0, false}, {39.5, 40, 0.004, true},
                 {40.5, 40, 0.002, false}, {NAN, 40, 0, false},  {40, NAN, 0, false},
                 {40, 40, NAN, false},     {1, 0, 0, false},     {40, 40, 0, true}};

    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        struct outcome o = judge(cases[n].value, cases[n].truth, cases[n].bar);
        const bool met = cases[n].met;
        CHECK(o.status == (met ? STATUS_OK : STATUS_FAILED));
        CHECK_SAY(counts(&o, "first", met ? "2 0 1 0 0 0 3" : "0 2 1 0 0 0 3"), "%g for %g",
                  cases[n].value, cases[n].truth);
    }
}

/* Rows that are not judged: a death fails what was claimed, the rest fails nothing. */
static void check_ended(void)
{
    static const struct {
        const char *counts;
        enum verdict end;
    } ends[] = {{"0 0 0 0 0 3 3", VERDICT_DIED},
                {"0 0 0 3 0 0 3", VERDICT_OUT_OF_RANGE},
                {"0 0 0 0 3 0 3", VERDICT_NOT_APPLICABLE},
                {"0 0 3 0 0 0 3", VERDICT_NO_CLAIM}};

    for (size_t n = 0; n < sizeof ends / sizeof *ends; n++) {
        script.end = ends[n].end;
        struct outcome o = COMMAND("first", "--out", folder);
        CHECK(counts(&o, "first", ends[n].counts));
        CHECK(o.status == (n == 0 ? STATUS_FAILED : STATUS_OK));
        CHECK(strstr(o.text, n == 0 ? "result: 1 of 2 claims" : "result: 0 of 0 claims"));
    }
}

/* Sums over several checks, one failure among them, and who is run at all. */
static void check_several(void)
{
    script.end = VERDICTS, script.value = 1.1, script.truth = 1;
    struct outcome o = COMMAND("first", "second", "first", "--out", folder);

    CHECK(o.status == STATUS_FAILED && counts(&o, "all", "4 2 3 0 0 0 9"));
    CHECK(counts(&o, "first", "0 2 1 0 0 0 3") && counts(&o, "second", "4 0 2 0 0 0 6"));
    CHECK(strstr(o.text, "3 of 6 claims;"));
    o = COMMAND("--out", folder);
    CHECK(counts(&o, "all", "4 2 3 0 0 0 9"));
    o = COMMAND("--out", folder, "--quick"); /* not the slow one, nor who claims nothing */
    CHECK(counts(&o, "all", "0 2 0 0 0 0 2"));
    o = COMMAND("second", "--out", folder, "--quick"); /* but if it is named */
    CHECK(o.status == STATUS_OK && counts(&o, "all", "2 0 0 0 0 0 2")); /* one of two */
    o = COMMAND("first", "--models", "shell", "--out", folder);
    CHECK(counts(&o, "all", "0 1 0 0 0 0 1"));
    o = COMMAND("fourth", "--out", folder);
    CHECK(o.status == STATUS_INPUT);
}

/* The numbers of a row; and again, the same, from the file, without a run. */
static void check_printed(void)
{
    script.end = VERDICTS, script.value = 1.25, script.truth = 1, script.bar = 0.125;
    struct outcome o = COMMAND("first", "--out", folder);
    char *printed = strdup(o.text);

    REQUIRE(printed);
    CHECK(strstr(o.text, "1.25000") && strstr(o.text, "0.25 ") && strstr(o.text, "6.0"));
    CHECK(strstr(o.text, "claimed before a first result: 2 % before."));
    script.value = 1; /* it is not run again */
    o = COMMAND("first", "--from", folder);
    CHECK(o.status == STATUS_FAILED && !strcmp(o.text, printed));
    free(printed);
}

/* A failure of another kind is no verdict. */
static void check_torn(void)
{
    script.status = STATUS_LIBRARY;
    struct outcome o = COMMAND("first", "--out", folder);

    CHECK(o.status == STATUS_LIBRARY && *o.why.text && !*o.text);
    script.status = STATUS_OK;
}

/* --- The list that tests of checks are held to. */

#define KNOWN "first | tip | IGA, selective, nonlinear, 10x10x2 | "
static void check_misses(void)
{
    static const struct {
        const char *list;
        int wrong, quick; /* how many are wrong; after a run with --quick */
    } cases[] = {{"# a remark\n\n" KNOWN "it is so\n", 0, 0},
                 {"", 1, 1},         /* a new one            */
                 {KNOWN "\n", 2, 2}, /* it has no reason     */
                 {KNOWN "so\nfirst | tip | shell, p = 3, 10x10 | no\n", 1, 1},  /* met  */
                 {KNOWN "so\nfirst | top | shell, p = 3, 10x10 | no\n", 1, 0}}; /* none */

    for (size_t n = 0; n < 2 * sizeof cases / sizeof *cases; n++) {
        struct verify_sheet sheet = {0};
        const bool quick = n % 2;
        FILE *list = tmpfile();

        REQUIRE(list && fputs(cases[n / 2].list, list) >= 0);
        rewind(list);
        script.end = VERDICTS, script.value = 1.02, script.truth = 1, script.bar = 0;
        verify_check_run(&first, &sheet);
        verify_row_judge(&sheet.rows[1], 1, 1, 0);
        CHECK(known_misses_wrong(&sheet, "first", list, quick) ==
              (quick ? cases[n / 2].quick : cases[n / 2].wrong));
        fclose(list);
        verify_sheet_clear(&sheet);
    }
}

/* --- Rows: who is walked, nets and orders, and the same after writing and reading. */

static const struct verify_check rows_check = {.item = {"unit_rows", "rows of a test"},
                                               .source = "made up"};

/* Two claims, one of them dear, and one contestant that only this field has. */
static const struct verify_subject pair[] = {
    {"iga_selective", 0.01, "asked", {6, 10}, {3}, .dear = true},
    {"triangles", 0.01, "asked", {6}},
    {"mass_spring_paper", 0, NULL, {5}},
    {NULL}};
static const struct verify_field of_pair = {pair, CONTESTANT_LARGE, "hex,shell_3", {8, 14}};

static void check_worse(void)
{
    CHECK(verify_row_worse(1, 2) == 2 && verify_row_worse(2, 1) == 2);
    CHECK(verify_row_worse(-1, -2) == -1 && verify_row_worse(0, 0) == 0);
    CHECK(isnan(verify_row_worse(NAN, 1)) && isnan(verify_row_worse(1, NAN)));
}

/* Lists the names of a field's subjects, "a b c". */
static const char *walk(struct verify_sheet *sheet, const struct verify_field *f)
{
    static char text[512];
    struct verify_subject all[VERIFY_MOST];
    const int count = verify_sheet_subjects(sheet, f, all);

    *text = '\0';
    for (int n = 0; n < count; n++)
        snprintf(text + strlen(text), sizeof text - strlen(text), "%s%s", n ? " " : "",
                 all[n].contestant->name);
    return text;
}

/* The table's first, then the others that enter, each as --models has it. */
static void check_walk(void)
{
    static const struct verify_subject wrong[] = {{"nobody"}, {NULL}};
    struct verify_sheet sheet = {0};
    char want[512];

    snprintf(want, sizeof want, "iga_selective triangles mass_spring_paper");
    for (const struct contestant *c = contestant_table; c->name; c++)
        if (c->enters & CONTESTANT_LARGE && strcmp(c->name, "iga_selective") &&
            strcmp(c->name, "triangles") && strcmp(c->name, "shell_3") &&
            strcmp(c->model->name, "hex"))
            snprintf(want + strlen(want), sizeof want - strlen(want), " %s", c->name);
    CHECK(!strcmp(walk(&sheet, &of_pair), want) && strstr(want, " iga_nonlinear "));
    sheet.models = "hex,mass_spring";
    CHECK(!strcmp(walk(&sheet, &of_pair), "mass_spring_paper mass_spring "
                                          "mass_spring_momentum mass_spring_leapfrog"));
    sheet.models = "shell_3,iga_selective"; /* by name, one that is left out, too */
    CHECK(!strcmp(walk(&sheet, &of_pair), "iga_selective shell_3"));
    sheet.quick =
        true; /* iga_selective is dear; of shell_3 nothing is claimed, but asked */
    CHECK(!strcmp(walk(&sheet, &of_pair), "shell_3"));
    sheet.models = NULL;
    CHECK(!strcmp(walk(&sheet, &of_pair), "triangles"));
    CHECK(sheet.status == STATUS_OK);
    CHECK(!*walk(&sheet, &(struct verify_field){.subject = wrong}));
    CHECK(sheet.status == STATUS_INPUT);
    sheet.status = STATUS_OK;
    walk(&sheet, &(struct verify_field){.without = "nobody"});
    CHECK(sheet.status == STATUS_INPUT);
}

/* The first failure is kept, and nobody is judged after it. */
static void check_failure(void)
{
    struct verify_sheet sheet = {0};

    CHECK(!verify_sheet_table(&sheet, "no_such_table"));
    CHECK(sheet.status == STATUS_INPUT);
    CHECK(!verify_sheet_holds(&sheet, STATUS_MEMORY) && sheet.status == STATUS_INPUT);
    CHECK(!*walk(&sheet, &of_pair));
    verify_sheet_clear(&sheet);
}

/* A table's row takes what it leaves out from the field or the contestant; its title and
 * settings. */
static void check_subject(void)
{
    static const struct verify_subject rows[] = {{"shell_3",
                                                  0.25,
                                                  "why",
                                                  {5, 9, 17},
                                                  {4, 0, 6},
                                                  2,
                                                  "more",
                                                  {"a=b"},
                                                  3,
                                                  4,
                                                  .second = 0.75},
                                                 {"iga_selective"},
                                                 {NULL}};
    static const struct verify_field three = {rows, 0, NULL, {5, 7, 9}, {0, 6, 8}},
                                     none = {rows + 1},
                                     hard = {NULL, CONTESTANT_LARGE, NULL, {1}, {1}, 0.5};
    struct verify_sheet sheet = {0};
    struct verify_subject all[VERIFY_MOST], s;
    struct settings set = {0};
    char title[VERIFY_TEXT];

    REQUIRE(verify_sheet_subjects(&sheet, &three, all) == 2);
    s = all[0];
    CHECK(s.tolerance == 0.25 && s.second == 0.75 && s.layers == 3 && s.degree == 4);
    CHECK(s.nets == 3 && s.along[2] == 17 && s.across[0] == 4 && s.across[1] == 9 &&
          s.across[2] == 6);
    verify_subject_claim(&s, 0.5, NULL);
    CHECK(s.tolerance == 0.5 && !s.reason);
    verify_subject_last(&s, 2);
    CHECK(s.nets == 2 && s.along[0] == 9 && s.across[0] == 9 && s.along[1] == 17 &&
          s.across[1] == 6);
    verify_subject_title(&s, title);
    CHECK(!strcmp(title, "shell, p = 3, more, 17x6x3, graded"));
    verify_subject_square(&s, 6, 8);
    CHECK(s.nets == 2 && s.along[0] == 6 && s.across[1] == 8);
    verify_subject_settings(&s, 0, &set);
    const char *points = settings_value(&set, "discretization.points");
    const char *knots = settings_value(&set, "discretization.knots_u");
    CHECK(points && !strcmp(points, "[6,6,3]"));
    CHECK(knots && !strcmp(knots, "[0,0,0,0,0,0.25,1,1,1,1,1]"));
    CHECK(settings_value(&set, "a") && set.count == 3);
    settings_clear(&set);

    s = all[1];
    const struct contestant *c = s.contestant;
    CHECK(isnan(s.tolerance) && isnan(s.second) && s.sheet == &sheet);
    CHECK(s.nets == 3 && s.across[0] == contestant_least(c) && s.across[2] == 8);
    CHECK(s.layers == c->layers && s.degree == c->degree && s.grade == 0);
    verify_subject_claim(&s, 0.5, "one");
    CHECK(isnan(s.tolerance) && !s.reason); /* where nothing is claimed */
    REQUIRE(verify_sheet_subjects(&sheet, &none, &s) == 1);
    CHECK(s.nets == 2 && s.along[1] == c->points[1] && s.across[1] == c->points[1]);
    sheet.models = "shell_3", sheet.quick = true; /* a claim of everyone; one span */
    REQUIRE(verify_sheet_subjects(&sheet, &hard, &s) == 1);
    CHECK(s.tolerance == 0.5 && s.nets == 1 && s.along[0] == 4 && s.across[0] == 4);
}

/* Orders are of spans, points less the degree, on the last two nets. */
static void check_orders(void)
{
    struct verify_subject s = {.nets = 3, .along = {4, 5, 11}, .degree = 2};
    const double error[3] = {7, 0.27, 0.01};

    CHECK_NEAR(verify_subject_order(&s, error, 0), 3, 1e-14); /* 3 spans to 9 */
    CHECK_NEAR(verify_subject_order(&s, error, 0.0033), 3, 1e-14);
    CHECK(isnan(verify_subject_order(&s, error, 0.0034)));
    CHECK(isnan(verify_subject_order(&s, (double[]){7, 0, 0.01}, 0)));
    CHECK(isnan(verify_subject_order(&s, (double[]){7, 0.27, 0}, 0)));
    CHECK(isnan(verify_subject_order(&s, (double[]){7, 0.27, NAN}, 0)));
    CHECK(verify_subject_order(&s, (double[]){7, 0.01, 0.27}, 0) < -2.9);
    s.nets = 1;
    CHECK(isnan(verify_subject_order(&s, error, 0)));
}

/* Fifty rows: more than fit without growing; with what a file could trip over. */
static void check_file(void)
{
    struct verify_sheet made = {0}, read;
    struct verify_subject all[VERIFY_MOST];
    struct message why = {""};

    REQUIRE(verify_sheet_subjects(&made, &of_pair, all));
    for (int n = 0; n < 50; n++) {
        struct verify_row *row = verify_sheet_add(all, "tip, Gamma = %d", n);
        verify_row_judge(row, 1 + n / 3000.0, 1, 1e-10);
        row->seconds = n / 7.0;
        row->order = n % 3 ? NAN : n / 5.0;
        row->until = n / 11.0;
        if (n % 5 == 0)
            strcpy(row->changed, "2 %, \"asked\"");
        if (n % 2)
            verify_row_note(row, "a, 5 %%2C b\n\"c\", ");
    }
    CHECK(folder_make(folder, &why) == STATUS_OK);
    CHECK(verify_file_write("verify", &rows_check, &made, folder, &why) == STATUS_OK);
    CHECK_SAY(verify_file_read(&rows_check, folder, &read, &why) == STATUS_OK, "%s",
              why.text);
    CHECK(read.count == made.count);
    for (int n = 0; n < read.count && n < made.count; n++) {
        const struct verify_row *a = &made.rows[n], *b = &read.rows[n];
        CHECK(a->value == b->value && a->truth == b->truth && a->bar == b->bar);
        CHECK(a->error == b->error && a->seconds == b->seconds);
        CHECK(a->order == b->order || (isnan(a->order) && isnan(b->order)));
        CHECK(a->tolerance == b->tolerance && !strcmp(a->changed, b->changed));
        CHECK(a->until == b->until && !strcmp(a->name, b->name));
        CHECK(a->verdict == b->verdict && !strcmp(a->subject, b->subject));
        CHECK(!strcmp(a->quantity, b->quantity) && !strcmp(a->note, b->note));
    }
    verify_sheet_clear(&made);
    verify_sheet_clear(&read);
    CHECK(verify_file_read(&rows_check, "/proc/nowhere", &read, &why) == STATUS_FILE);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    snprintf(folder, sizeof folder, "%s", argv[1]);
    REQUIRE(folder_make(folder, NULL) == STATUS_OK);
    script.status = STATUS_OK;
    check_judged();
    check_ended();
    check_several();
    check_printed();
    check_torn();
    check_misses();
    check_worse();
    check_walk();
    check_failure();
    check_subject();
    check_orders();
    check_file();
    return check_result();
}
