/* Tables of results: formats for machines against text written out here, those for people
 * by their cells and what they escape. */
#include "bench/data/printer.h"

#include <sys/stat.h>

#include "tests/fresh.h"
#include "tests/said.h"
#include "tests/scratch.h"
#include "tests/text.h"

/* One set of columns for people and for machines. */
static const struct dataset_column columns[] = {
    {"case_1"},
    {"a frame", "ms", .key = "frame_s", .key_unit = "s", .scale = 1e3},
    {"net", .readers = DATASET_PEOPLE},
    {"to next", "% L", .scale = 100, .key = "to_next_over_length", .key_unit = "1"},
    {"p", .readers = DATASET_MACHINES},
    {"unknowns"}};

/* Makes a table whose headers, cells and captions have characters that formats use. */
static struct dataset *make(void)
{
    struct dataset *t = dataset_create(6, columns, "50 % & #1");
    dataset_line(t, "%s|%.3g|10x10|%.1f|%d|%.0f", "a|b, \"c\"\\\n\x01", 0.0125, 0.125, 2,
                 540.0);
    dataset_rule(t);
    dataset_line(t, "# no comment|%.3g|-", NAN);
    dataset_missing(t, "not reached");
    dataset_add(t, "%.2g|%.0f", -INFINITY, -NAN);
    dataset_line(t, "*_$#{}<>~^&|%.3g", 1.5e-12);
    dataset_text(t, "50%%");
    dataset_add(t, "%.2f", 0.01 / 3);
    dataset_row(t);
    dataset_note(t, "A \"note\" of %d.", 9);
    return t;
}

/* Prints it, and looks for parts, until NULL, or for all of it if there is but one. */
static void print(const struct dataset *t, enum table_format format,
                  const char *const *want)
{
    struct said s;

    said_open(&s);
    CHECK(table_print(t, format, s.file) == STATUS_OK);
    said_close(&s, true);
    for (int n = 0; want[n]; n++)
        said_has(&s, "table", want[n]);
    if (!want[1])
        CHECK(strlen(s.text) == strlen(want[0]));
    said_clear(&s);
}
#define PRINT(t, format, ...) print(t, format, (const char *const[]){__VA_ARGS__, NULL})

static void check_formats(void)
{
    struct dataset *t = make();

    PRINT(t, TABLE_TEXT, "case_1         a frame  net        to next  unknowns\n",
          "?       12.5  10x10         12.5       540\n",
          "# no comment         -  -      not reached         -\n",
          "*_$#{}<>~^&   1.50e-09  50%           0.33\n");
    PRINT(t, TABLE_CSV,
          "# 50 % & #1\ncase_1,frame_s,to_next_over_length,p,unknowns\n"
          "\"a|b, \"\"c\"\"\\\n?\",0.012500000000000001,0.125,2,540\n"
          "\"# no comment\",,,-inf,\n"
          "*_$#{}<>~^&,1.5000000000000001e-12,0.0033333333333333335,,\n,,,,\n"
          "# A \"note\" of 9.\n");
    PRINT(t, TABLE_MARKDOWN,
          "| case\\_1 | a frame [ms] | net | to next [% L] | unknowns |\n",
          "| a\\|b, \"c\"\\ ? | 12.5 | 10x10 | 12.5 | 540 |\n",
          "| \\*\\_$#{}<>~^& | 1.50e-09 | 50% | 0.33 |  |\n");
    PRINT(t, TABLE_LATEX, "case\\_1 & a frame [ms] & net & to next [\\% L] & unknowns",
          "a$|$b, \"c\"\\textbackslash{}\n? & 12.5 & 10x10 & 12.5 & 540 ",
          "*\\_\\$\\#\\{\\}$<$$>$\\~{}\\^{}\\& & 1.50e-09 & 50\\% & 0.33 &  ");
    PRINT(t, TABLE_JSON,
          "{\"caption\": \"50 % & #1\", \"units\": {\"frame_s\": \"s\", \"to_next_o"
          "ver_length\": \"1\"}, \"rows\": [{\"case_1\": \"a|b, \\\"c\\\"\\\\\\u000"
          "a\\u0001\", \"frame_s\": 0.012500000000000001, \"to_next_over_length\": "
          "0.125, \"p\": 2, \"unknowns\": 540}, {\"case_1\": \"# no comment\", \"fr"
          "ame_s\": null, \"to_next_over_length\": null, \"p\": \"-inf\", \"unknown"
          "s\": null}, {\"case_1\": \"*_$#{}<>~^&\", \"frame_s\": 1.500000000000000"
          "1e-12, \"to_next_over_length\": 0.0033333333333333335, \"p\": null, \"un"
          "knowns\": null}, {\"case_1\": null, \"frame_s\": null, \"to_next_over_le"
          "ngth\": null, \"p\": null, \"unknowns\": null}], \"notes\": [\"A \\\"not"
          "e\\\" of 9.\"]}\n");
    CHECK(dataset_count(t) == 4 && dataset_find(t, "p") == 4);
    CHECK(dataset_find(t, "case_1") == 0 && dataset_find(t, "unknowns") == 5);
    CHECK(dataset_find(t, "a frame") == -1);
    dataset_destroy(t);
    for (int f = TABLE_TEXT; f <= TABLE_JSON; f++) {
        const struct printer p = {f};
        CHECK(printer_is_prose(&p) == (f == TABLE_TEXT || f == TABLE_MARKDOWN));
        CHECK(printer_is_data(&p) == (f == TABLE_CSV || f == TABLE_JSON));
    }
}

/* Keys made of header and unit; none twice. */
static void check_keys(void)
{
    static const struct dataset_column some[] = {
        {"a frame", "ms"}, {"to next", "L"},  {"lowest", "% L"},      {"fall", "m/s^2"},
        {"10 %", "s"},     {"stretch", NULL}, {"stretch", NULL},      {"stretch", "1"},
        {"", NULL},        {"E dt", "Pa m"},  {"nu (1+mu)/2", "Pa/s"}};
    struct dataset *t = dataset_create(11, some, NULL);

    PRINT(t, TABLE_CSV,
          "a_frame_ms,to_next_over_length,lowest_over_length_percent,fall_m_per_s2,"
          "10_percent_s,stretch,stretch_2,stretch_3,column,e_dt_pa_m,nu_1_mu_per_2_pa_per_"
          "s\n");
    dataset_destroy(t);
}

static void check_file(const char *want)
{
    char *text = fresh_text(".", "table.csv");

    if (!CHECK(!strcmp(text, want)))
        printf("--- is\n%s--- want\n%s", text, want);
    free(text);
}

/* Files have keys and rows only. */
static void check_files(void)
{
    static const char want[] =
        "case_1,frame_s,to_next_over_length,p,unknowns\n\"a|b, \"\"c\"\"\\\n"
        "?\",0.012500000000000001,0.125,2,540\n\"# no comment\",,,-inf,\n"
        "*_$#{}<>~^&,1.5000000000000001e-12,0.0033333333333333335,,\n,,,,\n";
    struct message why;
    struct dataset *t = make();

    CHECK(printer_save(&(struct printer){.folder = "."}, t, "table", &why) == STATUS_OK);
    check_file(want);
    CHECK(printer_save(&(struct printer){.folder = "/proc/nowhere"}, t, "table", &why) ==
          STATUS_FILE);
    REQUIRE(mkdir("full.csv", 0700) == 0);
    CHECK(printer_save(&(struct printer){.folder = "."}, t, "full", &why) == STATUS_FILE);
    CHECK(printer_table(&(struct printer){TABLE_LATEX, stdout}, t, NULL, NULL) ==
          STATUS_OK);
}

static void check_failures_told(void)
{
    struct message why;
    enum table_format format;
    struct dataset *t = make();
    FILE *full = fopen("/dev/full", "w");

    CHECK(printer_format("latex", &format, &why) == STATUS_OK && format == TABLE_LATEX);
    CHECK(printer_format("html", &format, &why) == STATUS_INPUT);
    if (full) {
        setvbuf(full, NULL, _IONBF, 0);
        CHECK(table_print(t, TABLE_CSV, full) == STATUS_FILE);
        CHECK(table_print(t, TABLE_JSON, full) == STATUS_FILE);
        fclose(full);
    }
    dataset_destroy(t);
}

/* A table wider than a line is in parts, each with the columns that tell rows apart. */
static void check_wide(void)
{
    struct dataset_column wide[20] = {{"name"}, {"net"}};
    char names[18][24];
    struct said s;

    for (int n = 2; n < 20; n++) {
        snprintf(names[n - 2], sizeof names[0], "number %d", n);
        wide[n] = (struct dataset_column){names[n - 2], n % 2 ? "m" : NULL};
    }
    struct dataset *t = dataset_create(20, wide, NULL);
    for (int row = 0; row < 2; row++) {
        dataset_line(t, "same");
        for (int n = 1; n < 20; n++)
            dataset_add(t, "%d", 12345 + row);
    }
    said_open(&s);
    REQUIRE(table_print(t, TABLE_TEXT, s.file) == STATUS_OK);
    said_close(&s, true);
    CHECK(text_count(s.text, "name    net") == 2 && text_count(s.text, "same  12345") == 2);
    for (const char *line = s.text; *line; line += strcspn(line, "\n") + 1)
        CHECK(strcspn(line, "\n") <= 120);
    said_clear(&s);
    dataset_destroy(t);
}

/* Cells that a spreadsheet would run become text; numbers and lone signs stay. */
static void check_formulas(void)
{
    static const char *const text[] = {"=cmd|x", "@x", "+x", "-x",  "\tx",    "-1+cmd|x",
                                       "-",      "-1", "+1", "a=b", "-1 to 2"};
    static const struct dataset_column one[] = {{"name"}};
    struct dataset *t = dataset_create(1, one, NULL);

    for (size_t n = 0; n < sizeof text / sizeof *text; n++)
        dataset_line(t, "%s", text[n]);
    PRINT(t, TABLE_CSV,
          "name\n'=cmd|x\n'@x\n'+x\n'-x\n'\tx\n'-1+cmd|x\n-\n-1\n+1\na=b\n-1 to 2\n");
    dataset_destroy(t);
}

/* Ninety-six characters are a line, one more are not. */
static void check_sentences(void)
{
    static const struct {
        int letters;
        const char *text, *want;
    } row[] = {{90, " abcde", " abcde\n"},
               {90, " abcdef", "\nabcdef\n"},
               {0, "two\n", "two\n\n"},
               {0, "- 5 %\n- 6 %", "- 5 %\n- 6 %\n"}};
    char x[91] = "";

    memset(x, 'x', 90);
    for (int n = 0; n < 4; n++) {
        struct said s;
        said_open(&s);
        wrap_say(s.file, "%.*s%s", row[n].letters, x, row[n].text);
        said_close(&s, true);
        CHECK(!strcmp(s.text + row[n].letters, row[n].want));
        said_clear(&s);
    }
}

/* The last words of a line are wrapped: no line is longer than 120 columns. */
static void check_wrapped(void)
{
    static const struct dataset_column two[] = {{"a"}, {"words"}};
    char words[400] = "", text[2000] = "";
    struct dataset *t = dataset_create(2, two, NULL);
    FILE *file = fmemopen(text, sizeof text, "w");

    while (strlen(words) < 300)
        strcat(words, "some words ");
    dataset_line(t, "1|%s", words);
    REQUIRE(file && table_print(t, TABLE_TEXT, file) == STATUS_OK && fclose(file) == 0);
    for (const char *line = text; *line; line += strcspn(line, "\n") + 1)
        CHECK(strcspn(line, "\n") <= 120);
    dataset_destroy(t);
}

int main(void)
{
    check_wrapped();
    scratch_open();
    REQUIRE(chdir(scratch) == 0);
    check_formats();
    check_keys();
    check_files();
    check_failures_told();
    check_wide();
    check_formulas();
    check_sentences();
    return check_result();
}
