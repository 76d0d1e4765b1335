/* Rows of a verification: judged as verify.h says, and the same after writing and reading.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/folder.h"
#include "bench/verify/verify.h"
#include "tests/check.h"

static const struct verify_check check = {.item = {"unit_rows", "rows of a test"},
                                          .source = "made up"};

/* One claim, and one contestant that only this field has. */
static const struct verify_entry entries[] = {
    {"iga_reduced", 0.01, "asked", {6, 10}, {3}, .dear = true},
    {"mass_spring_paper", 0, NULL, {5}},
    {NULL}};
static const struct verify_field field = {
    entries, CONTESTANT_LARGE, "hex,shell_3", {8, 14}};

static void check_verdicts(void)
{
    struct verify_sheet sheet = {0};
    struct verify_subject claimed, unclaimed;
    int n = 0;

    CHECK(verify_sheet_next(&sheet, &field, &n, &claimed));
    CHECK(verify_sheet_next(&sheet, &field, &n, &unclaimed));
    struct verify_row *row = verify_sheet_add(&claimed, "tip %d", 1);

    CHECK(row->verdict == VERIFY_NOT_APPLICABLE && !verify_row_failed(row));
    verify_row_judge(row, 1.011, 1, 0.002);
    CHECK(row->verdict == VERIFY_MET); /* within tolerance and bar together */
    verify_row_judge(row, 1.011, 1, 0);
    CHECK(row->verdict == VERIFY_MISSED && verify_row_failed(row));
    verify_row_judge(row, -1, 1, 0);
    CHECK(row->verdict == VERIFY_MISSED); /* a wrong sign is an error of 2 */
    CHECK_NEAR(row->error, 2, 0);
    verify_row_judge_error(row, NAN, 0);
    CHECK(row->verdict == VERIFY_MISSED); /* what is no number meets nothing */
    verify_row_end(row, VERIFY_OUT_OF_RANGE, "beyond");
    CHECK(row->verdict == VERIFY_OUT_OF_RANGE && !verify_row_failed(row));
    verify_row_end(row, VERIFY_DIED, "at 1 s");
    CHECK(verify_row_failed(row));
    CHECK(!strcmp(row->note, "asked; beyond; at 1 s"));

    row = verify_sheet_add(&unclaimed, "tip");
    verify_row_judge(row, 5, 1, 0);
    CHECK(row->verdict == VERIFY_NO_CLAIM && !verify_row_failed(row));
    verify_row_end(row, VERIFY_DIED, "%s", "");
    CHECK(!verify_row_failed(row)); /* a death nobody claimed against */
    verify_sheet_clear(&sheet);
}

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
    static const struct verify_entry wrong[] = {{"nobody"}, {NULL}},
                                     several[] = {{"shell_linear,hex_linear"},
                                                  {"mass_spring_paper"},
                                                  {NULL}};
    struct verify_sheet sheet = {0};
    char text[512], want[512];

    snprintf(want, sizeof want, "iga_reduced mass_spring_paper");
    for (const struct contestant *c = contestant_table; c->name; c++)
        if (c->enters & CONTESTANT_LARGE && strcmp(c->name, "iga_reduced") &&
            strcmp(c->name, "shell_3") && strcmp(c->model->name, "hex"))
            snprintf(want + strlen(want), sizeof want - strlen(want), " %s", c->name);
    walk(&sheet, &field, text);
    CHECK(!strcmp(text, want) && strstr(text, " iga_nonlinear "));
    sheet.models = "hex,mass_spring";
    walk(&sheet, &field, text);
    CHECK(!strcmp(
        text, "mass_spring_paper mass_spring mass_spring_momentum mass_spring_leapfrog"));
    sheet.models = "shell_3,iga_reduced"; /* by name, one that is left out, too */
    walk(&sheet, &field, text);
    CHECK(!strcmp(text, "iga_reduced shell_3"));
    sheet.quick = true; /* it is dear */
    walk(&sheet, &field, text);
    CHECK(!strcmp(text, "shell_3"));
    CHECK(sheet.status == STATUS_OK);
    walk(&sheet, &(struct verify_field){.entry = wrong}, text);
    CHECK(sheet.status == STATUS_INPUT && strstr(sheet.why.text, "nobody"));
    sheet = (struct verify_sheet){0}; /* an entry of several, whom nobody names twice */
    walk(&sheet, &(struct verify_field){.entry = several, .enters = CONTESTANT_SMALL},
         text);
    CHECK(!strncmp(text, "shell_linear hex_linear mass_spring_paper ", 42));
    CHECK(!strstr(text + 42, "shell_linear ") && !strstr(text + 42, "hex_linear "));
    walk(&sheet, &(struct verify_field){.without = "nobody"}, text);
    CHECK(sheet.status == STATUS_INPUT);
}

/* The rows of a table that read so, each with its own numbers; --quick: one in three. */
static void add_period(struct verify_subject *s)
{
    const double a = verify_number(s, "a");

    verify_row_judge(verify_sheet_add(s, "%g", a), 2 * atan(a / 2) / a,
                     verify_number(s, "v1"), 0);
}

static void check_parts(void)
{
    static const struct verify_check periods = {
        .table = "beam_elastica_cable",
        .parts = {{&field, add_period, .column = "case", .text = "newmark", .every = 3}}};
    struct verify_sheet sheet = {.models = "mass_spring_paper"}, quick = sheet;

    quick.quick = true;
    verify_check_run(&periods, &sheet);
    verify_check_run(&periods, &quick);
    CHECK(sheet.status == STATUS_OK && sheet.count > 6);
    CHECK(quick.count == (sheet.count + 2) / 3);
    for (int n = 0; n < sheet.count; n++)
        CHECK(sheet.rows[n].error < 1e-11);
    for (int n = 0; n < quick.count; n++)
        CHECK(!strcmp(quick.rows[n].quantity, sheet.rows[3 * n].quantity));
    verify_sheet_clear(&sheet);
    verify_sheet_clear(&quick);
}

/* The first failure is kept, and walks end with it. */
static void check_failure(void)
{
    struct verify_sheet sheet = {0};
    char text[512];

    CHECK(!verify_sheet_table(&sheet, "no_such_table"));
    CHECK(sheet.status == STATUS_INPUT && strstr(sheet.why.text, "no_such_table"));
    CHECK(!verify_sheet_holds(&sheet, STATUS_MEMORY) && sheet.status == STATUS_INPUT);
    walk(&sheet, &field, text);
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
    struct verify_subject s = verify_subject_of(&field, &entries[0], c);
    CHECK(s.nets == 2 && s.across[0] == 3 && s.across[1] == 10 && s.tolerance == 0.01);
    s = verify_subject_of(&field, NULL, c);
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
static void check_file(const char *folder)
{
    struct verify_sheet made = {0}, read;
    struct verify_subject s = verify_subject_of(&field, &entries[0], contestant_table);
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
    CHECK(verify_file_write(&check, &made, folder, &why) == STATUS_OK);
    if (!CHECK(verify_file_read(&check, folder, &read, &why) == STATUS_OK))
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
    CHECK(verify_file_read(&check, "/proc/nowhere", &read, &why) == STATUS_FILE);
}

/* What is no such file is refused. */
static void check_refusals(const char *folder)
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
    char path[4096];

    snprintf(path, sizeof path, "%s/unit_rows.csv", folder);
    for (size_t n = 0; n < sizeof text / sizeof *text; n++) {
        FILE *file = fopen(path, "w");
        if (!CHECK(file != NULL))
            return;
        fputs(text[n], file);
        fclose(file);
        CHECK(verify_file_read(&check, folder, &read, &why) == STATUS_INPUT);
        if (!CHECK(strstr(why.text, sentence[n])))
            printf("%s\n", why.text);
    }
}

int main(int argc, char **argv)
{
    check_verdicts();
    check_worse();
    check_walk();
    check_parts();
    check_failure();
    check_nets();
    check_subject();
    check_orders();
    check_file(argc > 1 ? argv[1] : ".");
    check_refusals(argc > 1 ? argv[1] : ".");
    return check_result();
}
