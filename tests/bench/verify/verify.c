/* The command verify on checks that are made up: what it prints, counts and ends with, for
 * every verdict each way; rows, subjects and their files. Nothing is computed. */
#include "bench/files/folder.h"
#include "bench/verify/verify.h"
#include "bench/verify/verify_check.h"
#include "tests/known_misses.h"

static char folder[4096];

/* --- A check that adds rows as it is told. */

static const struct verify_entry entries[] = {
    {"iga_reduced", 0.01, "asked", {6, 10}, {3}, .changed = "2 % before"},
    {"shell_3", 0.01, "asked", {7, 10}, {4}},
    {"mass_spring", 0, "nobody asks", {5}, .changed = "never claimed"},
    {NULL}};
static const struct verify_field field = {.entry = entries};

/* What all three rows of `first` do. */
static struct {
    double value, truth, bar;
    enum verify_verdict end; /* VERIFY_VERDICTS: it is judged                            */
    enum status status;
} script;

static void run_first(struct verify_sheet *sheet)
{
    struct verify_subject s;

    for (int n = 0; verify_sheet_next(sheet, &field, &n, &s);) {
        struct verify_row *row = verify_sheet_add(&s, "tip");
        row->seconds = 2;
        if (script.end == VERIFY_VERDICTS)
            verify_row_judge(row, script.value, script.truth, script.bar);
        else
            verify_row_end(row, script.end, "so it is");
    }
    verify_sheet_holds(sheet, status_fail(&sheet->why, script.status, "first: torn"));
}

static void run_second(struct verify_sheet *sheet)
{
    struct verify_subject s;

    for (int n = 0; verify_sheet_next(sheet, &field, &n, &s);)
        verify_row_judge_error(verify_sheet_add(&s, "field"), 0.001, 0);
}

static const struct verify_check first = {
    .item = {"first", "as told"}, .source = "made up", .run = run_first};
static const struct verify_check second = {
    .item = {"second", "always met"}, .source = "made up", .slow = true, .run = run_second};

/* Two quantities of all three, each remark twice, one of them of two. */
static void run_third(struct verify_sheet *sheet)
{
    struct verify_subject s;

    for (int q = 0; q < 2; q++)
        for (int n = 0; verify_sheet_next(sheet, &field, &n, &s);) {
            struct verify_row *row = verify_sheet_add(&s, "quantity %d", q);
            verify_row_judge(row, 0.125, 0.125, 0.25);
            row->order = 1.5;
            row->seconds = 0.25;
        }
}
static const struct verify_check third = {
    .item = {"third", "in two parts"}, .source = "made up", .slow = true, .run = run_third};

static const struct verify_check *const checks[] = {&first, &second, &third, NULL};

/* --- The command. */

struct outcome {
    enum status status;
    struct message why;
    char *text; /* freed by the next call                                                */
};

/* Words and options, ended by NULL. */
static struct outcome command(const char *const *words)
{
    static char *text;
    struct outcome o = {.why = {""}};
    struct command_line line;
    char *argv[16];
    size_t size;
    int argc = 0;

    free(text);
    for (; words[argc]; argc++)
        argv[argc] = (char *)words[argc];
    REQUIRE(command_parse(&verify_command, argc, argv, &line, &o.why) == STATUS_OK);
    FILE *out = open_memstream(&text, &size);
    REQUIRE(out);
    o.status = verify_run(checks, &line, out, &o.why);
    fclose(out);
    command_line_clear(&line);
    o.text = text;
    return o;
}
#define COMMAND(...) command((const char *const[]){__VA_ARGS__, NULL})

static struct outcome judge(double value, double truth, double bar)
{
    script.value = value, script.truth = truth, script.bar = bar;
    script.end = VERIFY_VERDICTS;
    return COMMAND("first", "--out", folder);
}

static struct outcome end(enum verify_verdict verdict)
{
    script.end = verdict;
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
        if (!CHECK(counts(&o, "first", met ? "2 0 1 0 0 0 3" : "0 2 1 0 0 0 3")))
            printf("%g for %g\n", cases[n].value, cases[n].truth);
        CHECK(met || !strcmp(o.why.text, "2 claims are not met, in: first"));
        CHECK(strstr(o.text, "Changed after a first result: 1 of 2 claims; the notes say"));
    }
}

/* Rows that are not judged: a death fails what was claimed, the rest fails nothing. */
static void check_ended(void)
{
    struct outcome o = end(VERIFY_DIED);

    CHECK(o.status == STATUS_FAILED && counts(&o, "first", "0 0 0 0 0 3 3"));
    CHECK(!strcmp(o.why.text, "2 claims are not met, in: first"));
    CHECK(strstr(o.text, "Changed after a first result: 1 of 2 claims;"));
    o = end(VERIFY_OUT_OF_RANGE);
    CHECK(o.status == STATUS_OK && counts(&o, "first", "0 0 0 3 0 0 3"));
    CHECK(strstr(o.text, "Changed after a first result: 0 of 0 claims."));
    o = end(VERIFY_NOT_APPLICABLE);
    CHECK(o.status == STATUS_OK && counts(&o, "first", "0 0 0 0 3 0 3"));
    o = end(VERIFY_NO_CLAIM);
    CHECK(o.status == STATUS_OK && counts(&o, "first", "0 0 3 0 0 0 3"));
}

/* Sums of several checks, one failure among them, and who is run at all. */
static void check_several(void)
{
    script.end = VERIFY_VERDICTS, script.value = 1.1, script.truth = 1;
    struct outcome o = COMMAND("first", "second", "first", "--out", folder);

    CHECK(o.status == STATUS_FAILED && counts(&o, "all", "2 2 2 0 0 0 6"));
    CHECK(counts(&o, "first", "0 2 1 0 0 0 3") && counts(&o, "second", "2 0 1 0 0 0 3"));
    CHECK(!strcmp(o.why.text, "2 claims are not met, in: first"));
    CHECK(strstr(o.text, "2 of 4 claims;"));
    o = COMMAND("--out", folder);
    CHECK(counts(&o, "all", "6 2 4 0 0 0 12") && counts(&o, "third", "4 0 2 0 0 0 6"));
    o = COMMAND("--out", folder, "--quick"); /* not the slow one */
    CHECK(counts(&o, "all", "0 2 1 0 0 0 3"));
    o = COMMAND("second", "--out", folder, "--quick"); /* but if it is named */
    CHECK(o.status == STATUS_OK && counts(&o, "all", "2 0 1 0 0 0 3"));
    o = COMMAND("first", "--models", "shell", "--out", folder);
    CHECK(!strcmp(o.why.text, "1 claim is not met, in: first"));
    CHECK(counts(&o, "all", "0 1 0 0 0 0 1"));
    o = COMMAND("fourth", "--out", folder);
    CHECK(o.status == STATUS_INPUT);
    CHECK(!strcmp(o.why.text,
                  "verify: there is no check 'fourth'; there are first, second, "
                  "third"));
}

/* What is printed: each remark once, the truth, what was claimed before; and again, the
 * same, from the file. */
static void check_printed(void)
{
    script.end = VERIFY_VERDICTS, script.value = 1.25, script.truth = 1, script.bar = 0.125;
    char *printed = NULL;
    struct outcome o = COMMAND("first", "--out", folder);

    CHECK(strstr(o.text, "first: as told") && strstr(o.text, "Truth: made up"));
    CHECK(strstr(o.text, "IGA, reduced, nonlinear, 10x10x2: asked."));
    CHECK(strstr(o.text, "claimed before a first result: 2 % before."));
    CHECK(strstr(o.text, "1.25000") && strstr(o.text, "0.25 ") && strstr(o.text, "6.0"));
    printed = strdup(o.text);
    REQUIRE(printed);
    script.value = 1; /* it is not run again */
    o = COMMAND("first", "--from", folder);
    CHECK(o.status == STATUS_FAILED && !strcmp(o.text, printed));
    free(printed);
    o = COMMAND("first", "second", "--out", folder, "--format", "csv");
    const char *head = strstr(o.text, "quantity,model,value,truth,error_bar,error,");
    CHECK(head == o.text && !strstr(head + 1, "\nquantity") && !strstr(o.text, "How many"));
    CHECK(strstr(o.text, "\ntip,") && strstr(o.text, "\nfield,"));
    CHECK(strstr(o.text, "2 % before"));
}

/* What is no judgement is no verdict: the sentence of what failed. */
static void check_torn(void)
{
    script.status = STATUS_LIBRARY;
    struct outcome o = COMMAND("first", "--out", folder);

    CHECK(o.status == STATUS_LIBRARY && !strcmp(o.why.text, "first: torn") && !*o.text);
    script.status = STATUS_OK;
}

/* --- The list that tests of checks are held to, each way. */

static int against(const char *text, bool quick)
{
    struct verify_sheet sheet = {0};
    FILE *list = tmpfile();

    REQUIRE(list && fputs(text, list) >= 0);
    rewind(list);
    script.end = VERIFY_VERDICTS, script.value = 1.02, script.truth = 1;
    script.bar = 0;
    run_first(&sheet);
    verify_row_judge(&sheet.rows[1], 1, 1, 0);
    printf("--- %s", text);
    const int count = known_misses_wrong(&sheet, "first", list, quick);
    fclose(list);
    verify_sheet_clear(&sheet);
    return count;
}

#define IGA   "IGA, reduced, nonlinear, 10x10x2"
#define SHELL "shell, p = 3, 10x10"
static void check_misses(void)
{
    const char known[] = "# a remark\n\nfirst | tip | " IGA " | it is so\n";

    CHECK(against(known, false) == 0);
    CHECK(against("", false) == 1);                              /* a new one   */
    CHECK(against("second | tip | " IGA " | so\n", false) == 1); /* not here    */
    CHECK(against("first | tip | " IGA " |\n", false) == 2);     /* no reason   */
    CHECK(against("first | tip | " IGA " | so\nfirst | tip | " SHELL " | no\n", false) ==
          1); /* it is met */
    CHECK(against("first | tip | " IGA " | so\nfirst | top | " IGA " | no\n", false) ==
          1); /* there is none ... */
    CHECK(against("first | tip | " IGA " | so\nfirst | top | " IGA " | no\n", true) ==
          0); /* ... in a hurry */
}

/* --- Rows: who is walked, nets and orders, and the same after writing and reading. */

static const struct verify_check rows_check = {.item = {"unit_rows", "rows of a test"},
                                               .source = "made up"};

/* One claim, and one contestant that only this field has. */
static const struct verify_entry pair[] = {
    {"iga_reduced", 0.01, "asked", {6, 10}, {3}, .dear = true},
    {"mass_spring_paper", 0, NULL, {5}},
    {NULL}};
static const struct verify_field of_pair = {pair, CONTESTANT_LARGE, "hex,shell_3", {8, 14}};

static void check_worse(void)
{
    CHECK(verify_row_worse(1, 2) == 2 && verify_row_worse(2, 1) == 2);
    CHECK(verify_row_worse(-1, -2) == -1 && verify_row_worse(0, 0) == 0);
    CHECK(isnan(verify_row_worse(NAN, 1)) && isnan(verify_row_worse(1, NAN)));
}

/* Names of the walk, "a b c", into text. */
static void walk(struct verify_sheet *sheet, const struct verify_field *f, char text[512])
{
    struct verify_subject s;

    *text = '\0';
    for (int n = 0; verify_sheet_next(sheet, f, &n, &s);)
        snprintf(text + strlen(text), 512 - strlen(text), "%s%s", *text ? " " : "",
                 s.contestant->name);
}

/* Entries first, then the others that enter, each as --models has it. */
static void check_walk(void)
{
    static const struct verify_entry wrong[] = {{"nobody"}, {NULL}};
    struct verify_sheet sheet = {0};
    char text[512], want[512];

    snprintf(want, sizeof want, "iga_reduced mass_spring_paper");
    for (const struct contestant *c = contestant_table; c->name; c++)
        if (c->enters & CONTESTANT_LARGE && strcmp(c->name, "iga_reduced") &&
            strcmp(c->name, "shell_3") && strcmp(c->model->name, "hex"))
            snprintf(want + strlen(want), sizeof want - strlen(want), " %s", c->name);
    walk(&sheet, &of_pair, text);
    CHECK(!strcmp(text, want) && strstr(text, " iga_nonlinear "));
    sheet.models = "hex,mass_spring";
    walk(&sheet, &of_pair, text);
    CHECK(!strcmp(
        text, "mass_spring_paper mass_spring mass_spring_momentum mass_spring_leapfrog"));
    sheet.models = "shell_3,iga_reduced"; /* by name, one that is left out, too */
    walk(&sheet, &of_pair, text);
    CHECK(!strcmp(text, "iga_reduced shell_3"));
    sheet.quick = true; /* it is dear */
    walk(&sheet, &of_pair, text);
    CHECK(!strcmp(text, "shell_3"));
    CHECK(sheet.status == STATUS_OK);
    walk(&sheet, &(struct verify_field){.entry = wrong}, text);
    CHECK(sheet.status == STATUS_INPUT && strstr(sheet.why.text, "nobody"));
    sheet.status = STATUS_OK;
    walk(&sheet, &(struct verify_field){.without = "nobody"}, text);
    CHECK(sheet.status == STATUS_INPUT);
}

/* The first failure is kept, and walks end with it. */
static void check_failure(void)
{
    struct verify_sheet sheet = {0};
    char text[512];

    CHECK(!verify_sheet_table(&sheet, "no_such_table"));
    CHECK(sheet.status == STATUS_INPUT && strstr(sheet.why.text, "no_such_table"));
    CHECK(!verify_sheet_holds(&sheet, STATUS_MEMORY) && sheet.status == STATUS_INPUT);
    walk(&sheet, &of_pair, text);
    CHECK(!*text);
    verify_sheet_clear(&sheet);
}

/* Nets of an entry, of the field, and of the contestant itself, in title and settings. */
static void check_nets(void)
{
    const struct verify_field plain = {NULL};
    const struct contestant *c = NULL;
    struct settings all = {0};
    struct message why = {""};
    char title[VERIFY_SUBJECT_TEXT];

    CHECK(contestant_find("iga_reduced", &c, &why) == STATUS_OK);
    struct verify_subject s = verify_subject_of(&of_pair, &pair[0], c);
    CHECK(s.nets == 2 && s.across[0] == 3 && s.across[1] == 10 && s.tolerance == 0.01);
    s = verify_subject_of(&of_pair, NULL, c);
    CHECK(s.nets == 2 && s.along[1] == 14 && s.across[1] == 3 && isnan(s.tolerance));
    s = verify_subject_of(&plain, NULL, c);
    CHECK(s.nets == 2 && s.along[1] == c->points[1] && s.across[1] == c->points[1]);
    s.grade = 2;
    s.more = "r = 1";
    verify_subject_title(&s, title);
    CHECK(!strcmp(title, "IGA, reduced, nonlinear, r = 1, 10x10x2, graded"));
    verify_subject_settings(&s, 0, &all);
    const char *points = settings_value(&all, "discretization.points");
    const char *knots = settings_value(&all, "discretization.knots_u");
    CHECK(points && !strcmp(points, "[6,6,2]"));
    CHECK(knots && !strcmp(knots, "[0,0,0,0.0625,0.25,0.5625,1,1,1]"));
    settings_clear(&all);
    CHECK_NEAR(verify_subject_order(&s, (double[]){4e-2, 1e-2}, 0), 2, 1e-15);
    CHECK(isnan(verify_subject_order(&s, (double[]){4e-2, 1e-2}, 0.01)));
    verify_subject_last(&s, 1);
    CHECK(s.nets == 1 && s.along[0] == 10);
    CHECK(isnan(verify_subject_order(&s, (double[]){1e-2}, 0)));
}

/* What an entry says is the subject's, and what it leaves out the contestant's or the
 * field's. */
static void check_subject(void)
{
    static const struct verify_entry full = {"shell_3", 0.25, "why",  {5, 9, 17},
                                             {4, 0, 6}, 2,    "more", {"a=b"},
                                             3,         4,    true,   true,
                                             "before"},
                                     bare = {"shell_3"};
    static const struct verify_field three = {.along = {5, 7, 9}, .across = {0, 6, 8}};
    const struct contestant *c = NULL;

    CHECK(contestant_find("shell_3", &c, NULL) == STATUS_OK);
    struct verify_subject s = verify_subject_of(&three, &full, c);
    CHECK(s.tolerance == 0.25 && !strcmp(s.reason, "why") && !strcmp(s.more, "more"));
    CHECK(s.nets == 3 && s.along[2] == 17 && s.across[0] == 4 && s.across[1] == 9 &&
          s.across[2] == 6);
    CHECK(s.grade == 2 && s.layers == 3 && s.degree == 4 && s.dear && s.mark);
    CHECK(!strcmp(s.settings[0], "a=b") && !strcmp(s.changed, "before"));
    verify_subject_claim(&s, 0.5, NULL);
    CHECK(s.tolerance == 0.5 && !s.reason);
    verify_subject_last(&s, 2);
    CHECK(s.nets == 2 && s.along[0] == 9 && s.across[0] == 9 && s.along[1] == 17 &&
          s.across[1] == 6);
    verify_subject_square(&s, 3, 8);
    CHECK(s.nets == 2 && s.along[0] == 3 && s.across[1] == 8);
    s = verify_subject_of(&three, &bare, c);
    CHECK(isnan(s.tolerance) && !s.reason && !s.changed && !s.more && !s.dear && !s.mark);
    CHECK(s.nets == 3 && s.across[0] == contestant_least(c) && s.across[2] == 8);
    CHECK(s.layers == c->layers && s.degree == c->degree && s.grade == 0);
    verify_subject_claim(&s, 0.5, "one");
    CHECK(isnan(s.tolerance) && !s.reason); /* where nothing is claimed */
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
}

/* Fifty rows: more than fit without growing; with what a file could trip over. */
static void check_file(void)
{
    struct verify_sheet made = {0}, read;
    struct verify_subject s = verify_subject_of(&of_pair, &pair[0], contestant_table);
    struct message why = {""};

    s.sheet = &made;
    for (int n = 0; n < 50; n++) {
        struct verify_row *row = verify_sheet_add(&s, "tip, Gamma = %d", n);
        verify_row_judge(row, 1 + n / 3000.0, 1, 1e-10);
        row->seconds = n / 7.0;
        row->order = n % 3 ? NAN : n / 5.0;
        if (n % 5 == 0)
            strcpy(row->changed, "2 %, \"asked\"");
        if (n % 2)
            verify_row_note(row, "a, 5 %%2C b\n\"c\", ");
    }
    CHECK(folder_make(folder, &why) == STATUS_OK);
    CHECK(verify_file_write(&rows_check, &made, folder, &why) == STATUS_OK);
    if (!CHECK(verify_file_read(&rows_check, folder, &read, &why) == STATUS_OK))
        printf("%s\n", why.text);
    CHECK(read.count == made.count);
    for (int n = 0; n < read.count && n < made.count; n++) {
        const struct verify_row *a = &made.rows[n], *b = &read.rows[n];
        CHECK(a->value == b->value && a->truth == b->truth && a->bar == b->bar);
        CHECK(a->error == b->error && a->seconds == b->seconds);
        CHECK(a->order == b->order || (isnan(a->order) && isnan(b->order)));
        CHECK(a->tolerance == b->tolerance && !strcmp(a->changed, b->changed));
        CHECK(a->verdict == b->verdict && !strcmp(a->subject, b->subject));
        CHECK(!strcmp(a->quantity, b->quantity) && !strcmp(a->note, b->note));
    }
    verify_sheet_clear(&made);
    verify_sheet_clear(&read);
    CHECK(verify_file_read(&rows_check, "/proc/nowhere", &read, &why) == STATUS_FILE);
}

/* What is no such file is refused. */
static void check_refusals(void)
{
    static const char *const text[] = {
        "", "a,b\n",
        "quantity,model,value,truth,error_bar,error,tolerance,order,verdict,time_s,remark,"
        "check,source,claimed_at_first\n1,2\n",
        "quantity,model,value,truth,error_bar,error,tolerance,order,verdict,time_s,remark,"
        "check,source,claimed_at_first\na,b,1,1,0,0,0,nan,fine,0,,c,d,\n"};
    static const char *const sentence[] = {"columns", "columns", "2 cells below 14 keys",
                                           "'fine' is no verdict"};
    struct verify_sheet read;
    struct message why = {""};
    char path[4200];

    snprintf(path, sizeof path, "%s/unit_rows.csv", folder);
    for (size_t n = 0; n < sizeof text / sizeof *text; n++) {
        FILE *file = fopen(path, "w");
        if (!CHECK(file != NULL))
            return;
        fputs(text[n], file);
        fclose(file);
        CHECK(verify_file_read(&rows_check, folder, &read, &why) == STATUS_INPUT);
        if (!CHECK(strstr(why.text, sentence[n])))
            printf("%s\n", why.text);
    }
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
    check_nets();
    check_subject();
    check_orders();
    check_file();
    check_refusals();
    return check_result();
}
