/* The command verify on checks that are made up: what it prints, counts and ends with, for
 * every verdict each way. Nothing is computed. */
#include "bench/files/folder.h"
#include "bench/verify/verify.h"
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
static void add_third(struct verify_subject *s)
{
    struct verify_row *row = verify_sheet_add(s, "quantity %d", s->at);

    verify_row_judge(row, 0.125, 0.125, 0.25);
    row->order = 1.5;
    row->seconds = 0.25;
}
static const struct verify_check third = {.item = {"third", "in two parts"},
                                          .source = "made up",
                                          .slow = true,
                                          .parts = {{&field, add_third, 2, .every = 2}}};

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
    o = COMMAND("third", "--out", folder, "--quick"); /* one case of two */
    CHECK(counts(&o, "all", "2 0 1 0 0 0 3") && !strstr(o.text, "quantity 1"));
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

static int count_of(const char *text, const char *word)
{
    int count = 0;

    for (; (text = strstr(text, word)); text += strlen(word))
        count++;
    return count;
}

/* A rule between quantities, each remark of a subject once, numbers in their columns. */
static void check_layout(void)
{
    struct outcome o = COMMAND("third", "--out", folder);
    char *end = strstr(o.text, "How many rows");

    CHECK(count_of(o.text, "Truth: made up") == 1 && end);
    if (end)
        *end = '\0'; /* not the last table, which has rules, too */
    CHECK(count_of(o.text, "\n---") == 2);
    CHECK(count_of(o.text, ": asked.") == 2 && count_of(o.text, ": nobody asks.") == 1);
    CHECK(count_of(o.text, "first result: 2 % before.") == 1);
    CHECK(count_of(o.text, "0.125000") == 12 && count_of(o.text, "0.2 ") == 6);
    CHECK(count_of(o.text, "1.50") == 6 && count_of(o.text, "0.25\n") == 6);
    CHECK(count_of(o.text, "0.010") == 4);
    o = COMMAND("first", "third", "--out", folder, "--format", "markdown");
    CHECK(count_of(o.text, "Truth: made up") == 2 && count_of(o.text, "in two parts") == 1);
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
    check_layout();
    check_torn();
    check_misses();
    return check_result();
}
