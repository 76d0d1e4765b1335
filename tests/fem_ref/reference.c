/* The reader of reference tables: reads them, refuses what is not one, and says where. */
#include "fem_ref/reference.h"

#include "tests/scratch.h"
#include "tests/text.h"

static const char *path;

static enum status open_text(const char *text, size_t size, struct reference **t,
                             struct message *why)
{
    text_put(path, text, size);
    if (why)
        why->text[0] = 0;
    return reference_open(path, t, why);
}

/* The sentence begins with the file. */
static void check_said(const struct message *why, const char *said)
{
    const size_t length = strlen(path);

    CHECK_SAY(!strncmp(why->text, path, length) && !strcmp(why->text + length, said),
              "got  %s\n  want %s%s", why->text, path, said);
}

static void check_reads(void)
{
    static const char text[] = "# by hand\n# date:  2026-01-02\nname,x,y\nfirst,1.5,\r\n"
                               "# between\nsecond,-2e-3,nan\nsecond,0x10,1e999\n,7,8 9\n";
    struct reference *t = NULL;

    REQUIRE(open_text(text, sizeof text - 1, &t, NULL) == STATUS_OK);
    CHECK(reference_rows(t) == 4);
    CHECK(reference_column(t, "y") == 2 && reference_column(t, "z") == -1);
    CHECK(!strcmp(reference_text(t, 0, "name"), "first"));
    CHECK(reference_number(t, 0, "x") == 1.5 && reference_number(t, 1, "x") == -2e-3);
    CHECK(isnan(reference_number(t, 0, "y")));    /* empty                */
    CHECK(reference_fault(t, NULL) == STATUS_OK); /* ... which may be     */
    CHECK(isnan(reference_number(t, 0, "name"))); /* text                 */
    CHECK(isnan(reference_number(t, 1, "y")));    /* nan is not a value   */
    CHECK(isnan(reference_number(t, 2, "x")));    /* hexadecimal          */
    CHECK(isnan(reference_number(t, 2, "y")));    /* overflow             */
    CHECK(isnan(reference_number(t, 3, "y")));    /* two numbers          */
    CHECK(reference_find(t, 0, "name", "second") == 1);
    CHECK(reference_find(t, 2, "name", "second") == 2);
    CHECK(reference_find(t, 3, "name", "second") == -1);
    CHECK(!strcmp(reference_note(t, "date"), "2026-01-02"));
    CHECK(reference_note(t, "dat") == NULL);
    reference_close(t);
    reference_close(NULL);
}

static void check_refusals(void)
{
#define TEXT(text) text, sizeof text - 1
    static const struct {
        const char *text;
        size_t size;
        const char *said;
    } cases[] = {
        {TEXT(""), ": no rows"},
        {TEXT("# only words\n"), ": no rows"},
        {TEXT("a,b\n"), ": no rows"},
        {TEXT("a,b\n1,2\n3\n"), ":3: 1 cells below 2 keys"},
        {TEXT("a,b\n1,2,3\n"), ":2: 3 cells below 2 keys"},
        {TEXT("a,b\n1,2\n\n1,2\n"), ":3: a blank line"},
        {TEXT("a,a\n1,2\n"), ":1: two columns of one name"},
        {TEXT("a,\n1,2\n"), ":1: a column without a name"},
        {TEXT("a,b\n\"1,2\n"), ":2: a quote has no end, or words behind it"},
        {TEXT("a,b\n1, 2\n"), ":2: blanks around a cell"},
        {TEXT("a,b\n1,2"), ": the last line has no end: cut short?"},
        {TEXT("a,b\n1,\0002\n"), ": has a byte 0 and is no text"},
    };
    struct reference *t = NULL;
    struct message why;

    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        CHECK(open_text(cases[n].text, cases[n].size, &t, &why) == STATUS_INPUT && !t);
        check_said(&why, cases[n].said);
    }
    unlink(path);
    CHECK(reference_open(path, &t, &why) == STATUS_FILE && strstr(why.text, path));
    CHECK(reference_open("/", &t, NULL) == STATUS_FILE); /* a folder */
    CHECK(t == NULL);
}

/* A query of what is not there gets an answer all the same, and the first one is told. */
static void check_faults(void)
{
    static const char text[] = "# a note\nname,x\nfirst,1.5\nsecond,nan\n";
    static const struct {
        int row;
        const char *column, *said;
    } cases[] = {
        {0, "z", ":2: there is no column 'z'"},
        {1, "x", ":4: x is 'nan', but must be a number"},
        {0, "name", ":3: name is 'first', but must be a number"},
        {2, "x", ":4: the last of 2 rows, but there should be a row 3"},
    };

    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        struct reference *t = NULL;
        struct message why;

        REQUIRE(open_text(text, sizeof text - 1, &t, &why) == STATUS_OK);
        CHECK(reference_number(t, 0, "x") == 1.5);
        CHECK(reference_fault(t, &why) == STATUS_OK);
        CHECK(isnan(reference_number(t, cases[n].row, cases[n].column)));
        CHECK(!*reference_text(t, 7, "no such column either"));
        CHECK(reference_fault(t, &why) == STATUS_INPUT);
        check_said(&why, cases[n].said);
        reference_close(t);
    }
}

int main(void)
{
    scratch_open();
    path = scratch_path("table.csv");
    check_reads();
    check_faults();
    check_refusals();
    return check_result();
}
