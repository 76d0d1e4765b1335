#include "bench/verify/verify_print.h"

#include <string.h>

#include "bench/verify/verify_file.h"

/* Whether an earlier row of the sheet has the same remark: one note does for all. */
static bool told(const struct verify_sheet *sheet, int row)
{
    for (int n = 0; n < row; n++)
        if (!strcmp(sheet->rows[n].note, sheet->rows[row].note) &&
            !strcmp(sheet->rows[n].subject, sheet->rows[row].subject))
            return true;
    return false;
}

static enum status print_sheet(const struct verify_check *check,
                               const struct verify_sheet *sheet, enum table_format format,
                               FILE *file)
{
    const struct verify_row *row = sheet->rows;
    char caption[512];

    snprintf(caption, sizeof caption, "%s: %s", check->item.name, check->item.text);
    struct table *t = verify_file_table(caption);
    for (int n = 0; n < sheet->count; n++) {
        if (n && strcmp(row[n].quantity, row[n - 1].quantity) &&
            !strcmp(row[n].subject, row[0].subject))
            table_rule(t);
        verify_file_row(t, check, &row[n]);
    }
    table_note(t, "Truth: %s", check->source);
    for (int n = 0; n < sheet->count; n++)
        if (*row[n].note && !told(sheet, n))
            table_note(t, "%s: %s.", row[n].subject, row[n].note);
    return table_finish(t, format, file);
}

/* For machines: all rows in one table. */
static enum status print_flat(int count, const struct verify_check *const *checks,
                              const struct verify_sheet *sheets, enum table_format format,
                              FILE *file)
{
    struct table *t = verify_file_table(NULL);

    for (int s = 0; s < count; s++)
        for (int n = 0; n < sheets[s].count; n++)
            verify_file_row(t, checks[s], &sheets[s].rows[n]);
    return table_finish(t, format, file);
}

/* How many rows end how, and their seconds. */
struct tally {
    long rows[VERIFY_VERDICTS], all;
    double seconds;
};

static void add(struct tally *to, const struct tally *more)
{
    for (int v = 0; v < VERIFY_VERDICTS; v++)
        to->rows[v] += more->rows[v];
    to->all += more->all;
    to->seconds += more->seconds;
}

static struct tally count_rows(const struct verify_sheet *sheet)
{
    struct tally tally = {.all = sheet->count};

    for (int n = 0; n < sheet->count; n++) {
        tally.rows[sheet->rows[n].verdict]++;
        tally.seconds += sheet->rows[n].seconds;
    }
    return tally;
}

static void add_tally(struct table *t, const char *name, const struct tally *tally)
{
    table_row(t);
    table_text(t, "%s", name);
    for (int v = 0; v < VERIFY_VERDICTS; v++)
        table_integer(t, tally->rows[v]);
    table_integer(t, tally->all);
    table_number(t, tally->seconds, 2);
}

static enum status print_summary(int count, const struct verify_check *const *checks,
                                 const struct verify_sheet *sheets,
                                 enum table_format format, FILE *file)
{
    struct table_column heads[VERIFY_VERDICTS + 3] = {{"check", NULL, TABLE_LEFT}};
    struct tally sum = {.all = 0};

    for (int v = 0; v < VERIFY_VERDICTS; v++)
        heads[v + 1] = (struct table_column){verify_verdict_name(v)};
    heads[VERIFY_VERDICTS + 1] = (struct table_column){"rows"};
    heads[VERIFY_VERDICTS + 2] = (struct table_column){"time", "s"};
    struct table *t = table_create(VERIFY_VERDICTS + 3, heads, "How many rows end how");
    for (int s = 0; s < count; s++) {
        const struct tally of_check = count_rows(&sheets[s]);
        add_tally(t, checks[s]->item.name, &of_check);
        add(&sum, &of_check);
    }
    table_rule(t);
    add_tally(t, "all", &sum);
    table_note(t, "met: error <= tolerance + error bar. A tolerance is a claim, fixed with "
                  "its reason before the first result; where nothing is claimed, the error "
                  "is measured all the same. The command fails if a claim is missed, or "
                  "dies.");
    enum status st = table_print(t, format, file);
    table_destroy(t);
    return st;
}

enum status verify_print(int count, const struct verify_check *const *checks,
                         const struct verify_sheet *sheets, enum table_format format,
                         FILE *file)
{
    enum status st = STATUS_OK;

    if (!table_format_is_prose(format))
        return print_flat(count, checks, sheets, format, file);
    for (int s = 0; s < count; s++)
        TRY(print_sheet(checks[s], &sheets[s], format, file));
    TRY(print_summary(count, checks, sheets, format, file));
out:
    return st;
}
