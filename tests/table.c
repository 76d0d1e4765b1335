/* Tables of results in their four formats, against text written out here. */
#include "bench/ui/table.h"

#include <math.h>

#include "tests/check.h"

static const struct table_column columns[] = {
    {"model", NULL, TABLE_LEFT}, {"time", "ms", TABLE_RIGHT}, {"n", NULL, TABLE_RIGHT}};

static struct table *make(void)
{
    struct table *t = table_create(3, columns, "Cost");
    table_row(t);
    table_text(t, "%s", "a|b, \"c\"");
    table_number(t, 0.1, 3);
    table_integer(t, 12345);
    table_rule(t);
    table_row(t);
    table_text(t, "50%%_x");
    table_dash(t);
    table_row(t);
    table_note(t, "Of %d repeats.", 9);
    return t;
}

static void print(const struct table *t, enum table_format format, const char *want)
{
    char *text = NULL;
    size_t size = 0;
    FILE *file = open_memstream(&text, &size);

    REQUIRE(file);
    CHECK(table_print(t, format, file) == STATUS_OK);
    fclose(file);
    if (!CHECK(!strcmp(text, want)))
        printf("--- is\n%s--- want\n%s", text, want);
    free(text);
}

static void check_formats(void)
{
    struct table *t = make();

    print(t, TABLE_TEXT,
          "Cost\n\n"
          "model      time      n\n"
          "             ms\n"
          "----------------------\n"
          "a|b, \"c\"  0.100  12345\n"
          "----------------------\n"
          "50%_x         -\n"
          "\n"
          "\nOf 9 repeats.\n");
    print(t, TABLE_CSV,
          "# Cost\nmodel,time [ms],n\n\"a|b, \"\"c\"\"\",0.10000000000000001,12345\n"
          "50%_x,,\n,,\n# Of 9 repeats.\n");
    print(t, TABLE_MARKDOWN,
          "**Cost**\n\n| model | time [ms] | n |\n|:---|---:|---:|\n"
          "| a\\|b, \"c\" | 0.100 | 12345 |\n| 50%\\_x | - |  |\n|  |  |  |\n"
          "\nOf 9 repeats.\n");
    print(t, TABLE_LATEX,
          "\\begin{table}\n\\centering\n\\caption{Cost}\n\\begin{tabular}{lrr}\n\\hline\n"
          "model & time [ms] & n \\\\\n\\hline\n"
          "a$|$b, \"c\" & 0.100 & 12345 \\\\\n\\hline\n"
          "50\\%\\_x & - &  \\\\\n &  &  \\\\\n\\hline\n\\end{tabular}\n"
          "\n\\smallskip\\footnotesize Of 9 repeats.\n\\end{table}\n");
    table_destroy(t);
}

static void check_numbers(void)
{
    static const struct table_column one[] = {{"x", NULL, TABLE_RIGHT}};
    struct table *t = table_create(1, one, NULL);

    table_row(t);
    table_number(t, 123, 3);
    table_row(t);
    table_number(t, 2.0, 2);
    table_row(t);
    table_number(t, NAN, 2);
    table_row(t);
    table_fixed(t, 1.0 / 3, 2);
    table_row(t);
    table_number(t, 1.5e-9, 3);
    print(t, TABLE_TEXT,
          "       x\n--------\n     123\n     2.0\n     nan\n    0.33\n1.50e-09\n");
    table_destroy(t);
}

static void check_failures_told(void)
{
    struct message why;
    enum table_format format;
    struct table *t = make();
    FILE *full = fopen("/dev/full", "w");

    CHECK(table_print(NULL, TABLE_TEXT, stdout) == STATUS_MEMORY);
    CHECK(table_format_parse("latex", &format, &why) == STATUS_OK && format == TABLE_LATEX);
    CHECK(table_format_parse("html", &format, &why) == STATUS_INPUT);
    CHECK(strstr(why.text, "markdown"));
    if (full) {
        setvbuf(full, NULL, _IONBF, 0);
        CHECK(table_print(t, TABLE_CSV, full) == STATUS_FILE);
        fclose(full);
    }
    table_destroy(t);
}

/* A long note is cut at blanks, never inside a word. */
static void check_wrapping(void)
{
    static const struct table_column one[] = {{"x", NULL, TABLE_RIGHT}};
    struct table *t = table_create(1, one, NULL);
    char *text = NULL;
    size_t size = 0;
    FILE *file = open_memstream(&text, &size);

    for (int n = 0; n < 1; n++)
        table_note(t, "%0150d %090d end", 0, 0);
    REQUIRE(file && table_print(t, TABLE_TEXT, file) == STATUS_OK);
    fclose(file);
    CHECK(size == 4 + 1 + 151 + 90 + 1 + 3 + 1);
    free(text);
    table_destroy(t);
}

int main(void)
{
    check_formats();
    check_numbers();
    check_failures_told();
    check_wrapping();
    return check_result();
}
