/* Tables that are read back: what is in them, and that what is kept of a command comes back
 * as it was printed. (tests/pages/test_hostile.py: what is refused, and with which
 * sentence.) */
#include "models/reader/csv.h"

#include "bench/experiment/judge.h"
#include "bench/experiment/kept.h"
#include "bench/data/printer.h"
#include "tests/scratch.h"
#include "tests/text.h"

static const char path[] = "table.csv";

static void check_tables(void)
{
    static const char text[] = "# made by\n\n# first\n# table\na,b\n1,\"x, \"\"y\"\"\nz\"\n"
                               "nan,\n# a note\n#another\n\nc\n-2.5e3\n3x";
    struct csv csv = {0};
    struct message why = {""};

    text_write(path, text);
    REQUIRE(csv_read(path, &csv, &why) == STATUS_OK && csv.count == 2);
    const struct csv_table *t = &csv.table[0], *u = &csv.table[1];
    CHECK(t->columns == 2 && t->rows == 2 && u->columns == 1 && u->rows == 2);
    CHECK(!strcmp(t->caption, "made by\nfirst\ntable"));
    CHECK(!strcmp(t->notes, "a note\nanother"));
    CHECK(!*u->caption && !*u->notes);
    CHECK(!strcmp(csv_words(t, 0, 1), "x, \"y\"\nz"));
    CHECK(!strcmp(csv_words(t, 1, 1), ""));
    CHECK(csv_number(t, 0, 0) == 1 && isnan(csv_number(t, 1, 0)));
    CHECK(csv_number(u, 0, 0) == -2500 && isnan(csv_number(u, 1, 0)));
    CHECK(csv_column(t, "b") == 1 && csv_column(t, "c") == -1);
    CHECK(!*csv_words(t, 2, 0) && !*csv_words(t, -1, 0) && !*csv_words(t, 0, -1));
    csv_clear(&csv);
}

/* A table and a sentence, neither of them printed, as the report finds them. */
static void check_kept(void)
{
    static const struct dataset_column columns[] = {{"what"}, {"x", "m"}};
    struct printer p = {TABLE_TEXT};
    struct kept *kept = NULL;
    struct csv csv = {0};
    struct dataset *t = dataset_create(2, columns, "A, \"B\"");

    kept_open(".", "table", "1", &p, &kept);
    REQUIRE(kept);
    dataset_line(t, "a \"b\",\nc|%.3g", 0.1);
    dataset_note(t, "one\ntwo");
    CHECK(printer_table(&p, t, NULL, NULL) == STATUS_OK);
    kept_told(&p, kept,
              &(struct judge_told){"4.1", "up, always", VERDICT_HOLDS, "at 1 s", "By 2.",
                                   "It turns.", "Ours: 3."});
    CHECK(kept_close(&kept, NULL) == STATUS_OK && !kept);
    REQUIRE(csv_read(KEPT_NAME, &csv, NULL) == STATUS_OK && csv.count == 2);
    CHECK(strstr(csv.table[0].caption, "clothbench table 1 | commit "));
    CHECK(strstr(csv.table[0].caption, "\nA, \"B\""));
    CHECK(!strcmp(csv.table[0].notes, "one\ntwo"));
    CHECK(!strcmp(csv_words(&csv.table[0], 0, 0), "a \"b\",\nc"));
    CHECK(csv_number(&csv.table[0], 0, 1) == 0.1);
    CHECK(!strcmp(csv.table[1].caption, KEPT_SENTENCES) && csv.table[1].rows == 1);
    CHECK(!strcmp(csv_words_of(&csv.table[1], 0, "source"), "4.1"));
    CHECK(!strcmp(csv_words_of(&csv.table[1], 0, "claim"), "up, always"));
    CHECK(!strcmp(csv_words_of(&csv.table[1], 0, "reading"), "at 1 s"));
    CHECK(!strcmp(csv_words_of(&csv.table[1], 0, "verdict"), "holds"));
    CHECK(!strcmp(csv_words_of(&csv.table[1], 0, "sentence"), "By 2."));
    CHECK(!strcmp(csv_words_of(&csv.table[1], 0, "turns"), "It turns."));
    CHECK(!strcmp(csv_words_of(&csv.table[1], 0, "ours"), "Ours: 3."));
    csv_clear(&csv);
    kept_open("/proc/nowhere", "table", "1", &p, &kept);
    CHECK(!kept && kept_close(&kept, NULL) == STATUS_OK);
}

int main(void)
{
    scratch_open();
    REQUIRE(chdir(scratch) == 0);
    check_tables();
    check_kept();
    return check_result();
}
