/* Rows of a verification: judged as verify.h says, and the same after writing and reading.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/folder.h"
#include "bench/verify/verify_sheet.h"
#include "tests/check.h"

static const struct verify_subject claimed = {"iga, reduced", "iga", NULL, 0.01, "asked"};
static const struct verify_subject unclaimed = {"shell", "shell", NULL, NAN, NULL};
static const struct verify_check check = {.item = {"unit_rows", "rows of a test"},
                                          .source = "made up"};

static void check_verdicts(void)
{
    struct verify_sheet sheet = {.check = &check};
    struct verify_row *row = verify_add(&sheet, &claimed, "tip %d", 1);

    CHECK(row->verdict == VERIFY_NOT_APPLICABLE && !verify_failed(row));
    verify_judge(row, 1.011, 1, 0.002);
    CHECK(row->verdict == VERIFY_MET); /* within tolerance and bar together */
    verify_judge(row, 1.011, 1, 0);
    CHECK(row->verdict == VERIFY_MISSED && verify_failed(row));
    verify_judge(row, -1, 1, 0);
    CHECK(row->verdict == VERIFY_MISSED); /* a wrong sign is an error of 2 */
    CHECK_NEAR(row->error, 2, 0);
    verify_judge_error(row, NAN, 0);
    CHECK(row->verdict == VERIFY_MISSED); /* what is no number meets nothing */
    verify_out_of_range(row, "beyond");
    CHECK(row->verdict == VERIFY_OUT_OF_RANGE && !verify_failed(row));
    verify_died(row, "at 1 s");
    CHECK(verify_failed(row));
    CHECK(!strcmp(row->note, "asked; beyond; at 1 s"));

    row = verify_add(&sheet, &unclaimed, "tip");
    verify_judge(row, 5, 1, 0);
    CHECK(row->verdict == VERIFY_NO_CLAIM && !verify_failed(row));
    verify_died(row, "%s", "");
    CHECK(!verify_failed(row)); /* a death nobody claimed against */
    verify_sheet_clear(&sheet);
}

static void check_wanted(void)
{
    struct verify_sheet sheet = {.models = NULL};

    CHECK(verify_wanted(&sheet, &claimed));
    sheet.models = "hex,iga";
    CHECK(verify_wanted(&sheet, &claimed) && !verify_wanted(&sheet, &unclaimed));
    sheet.models = "shells";
    CHECK(!verify_wanted(&sheet, &unclaimed));
}

/* Fifty rows: more than fit without growing; with what a file could trip over. */
static void check_file(const char *folder)
{
    struct verify_sheet made = {.check = &check}, read;
    struct message why = {""};

    for (int n = 0; n < 50; n++) {
        struct verify_row *row = verify_add(&made, &claimed, "tip, Gamma = %d", n);
        verify_judge(row, 1 + n / 3000.0, 1, 1e-10);
        row->seconds = n / 7.0;
        if (n % 2)
            verify_note(row, "a, 5 %%2C b\nc ");
    }
    CHECK(folder_make(folder, &why) == STATUS_OK);
    CHECK(verify_sheet_write(&made, folder, &why) == STATUS_OK);
    if (!CHECK(verify_sheet_read(&check, folder, &read, &why) == STATUS_OK))
        printf("%s\n", why.text);
    CHECK(read.count == made.count);
    for (int n = 0; n < read.count && n < made.count; n++) {
        const struct verify_row *a = &made.rows[n], *b = &read.rows[n];
        CHECK(a->value == b->value && a->truth == b->truth && a->bar == b->bar);
        CHECK(a->error == b->error && a->seconds == b->seconds && isnan(b->order));
        CHECK(a->verdict == b->verdict && !strcmp(a->subject, b->subject));
        CHECK(!strcmp(a->quantity, b->quantity) && !strcmp(a->note, b->note));
    }
    verify_sheet_clear(&made);
    verify_sheet_clear(&read);
    CHECK(verify_sheet_read(&check, "/nowhere", &read, &why) == STATUS_FILE);
}

int main(int argc, char **argv)
{
    check_verdicts();
    check_wanted();
    check_file(argc > 1 ? argv[1] : ".");
    return check_result();
}
