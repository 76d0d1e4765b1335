#include "bench/verify/verify_print.h"

#include <math.h>
#include <string.h>

enum { DIGITS = 6 };

static const struct table_column columns[] = {
    {"quantity", NULL, TABLE_LEFT},       {"model", NULL, TABLE_LEFT},
    {"value", NULL, TABLE_RIGHT},         {"truth", NULL, TABLE_RIGHT},
    {"error bar", NULL, TABLE_RIGHT},     {"error", NULL, TABLE_RIGHT},
    {"tolerance", NULL, TABLE_RIGHT},     {"order", NULL, TABLE_RIGHT},
    {"verdict", NULL, TABLE_LEFT},        {"time", "s", TABLE_RIGHT},
    {"remark", NULL, TABLE_LEFT},         {"check", NULL, TABLE_LEFT},
    {"truth's source", NULL, TABLE_LEFT},
};
/* The last two are the caption's, but in CSV. A remark is a note, but in CSV. */
enum { COLUMNS = sizeof columns / sizeof *columns, PEOPLES = COLUMNS - 3 };

static void add_number(struct table *t, double x, int digits)
{
    if (isnan(x))
        table_dash(t);
    else
        table_number(t, x, digits);
}

static void add_row(struct table *t, const struct verify_row *row)
{
    table_row(t);
    table_text(t, "%s", row->quantity);
    table_text(t, "%s", row->subject);
    add_number(t, row->value, DIGITS);
    add_number(t, row->truth, DIGITS);
    add_number(t, row->bar, 1);
    add_number(t, row->error, 2);
    add_number(t, row->tolerance, 2);
    if (isnan(row->order))
        table_dash(t);
    else
        table_fixed(t, row->order, 2);
    table_text(t, "%s", verify_verdict_name((int)row->verdict));
    table_number(t, row->seconds, 2);
}

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
    char caption[512];

    snprintf(caption, sizeof caption, "%s: %s", check->item.name, check->item.text);
    struct table *t = table_create(PEOPLES, columns, caption);
    for (int n = 0; n < sheet->count; n++) {
        if (n && strcmp(sheet->rows[n].quantity, sheet->rows[n - 1].quantity) &&
            !strcmp(sheet->rows[n].subject, sheet->rows[0].subject))
            table_rule(t);
        add_row(t, &sheet->rows[n]);
    }
    table_note(t, "Truth: %s", check->source);
    for (int n = 0; n < sheet->count; n++)
        if (*sheet->rows[n].note && !told(sheet, n))
            table_note(t, "%s: %s.", sheet->rows[n].subject, sheet->rows[n].note);
    enum status st = table_print(t, format, file);
    table_destroy(t);
    return st;
}

static enum status print_flat(int count, const struct verify_check *const *checks,
                              const struct verify_sheet *sheets, FILE *file)
{
    struct table *t = table_create(COLUMNS, columns, NULL);

    for (int s = 0; s < count; s++)
        for (int n = 0; n < sheets[s].count; n++) {
            add_row(t, &sheets[s].rows[n]);
            table_text(t, "%s", sheets[s].rows[n].note);
            table_text(t, "%s", checks[s]->item.name);
            table_text(t, "%s", checks[s]->source);
        }
    enum status st = table_print(t, TABLE_CSV, file);
    table_destroy(t);
    return st;
}

static enum status print_summary(int count, const struct verify_check *const *checks,
                                 const struct verify_sheet *sheets,
                                 enum table_format format, FILE *file)
{
    struct table_column heads[VERIFY_VERDICTS + 3] = {{"check", NULL, TABLE_LEFT}};
    long sum[VERIFY_VERDICTS + 1] = {0};
    double seconds = 0;

    for (int v = 0; v < VERIFY_VERDICTS; v++)
        heads[v + 1] = (struct table_column){verify_verdict_name(v), NULL, TABLE_RIGHT};
    heads[VERIFY_VERDICTS + 1] = (struct table_column){"rows", NULL, TABLE_RIGHT};
    heads[VERIFY_VERDICTS + 2] = (struct table_column){"time", "s", TABLE_RIGHT};
    struct table *t = table_create(VERIFY_VERDICTS + 3, heads, "How many rows end how");
    for (int s = 0; s < count; s++) {
        long rows[VERIFY_VERDICTS] = {0};
        double spent = 0;
        for (int n = 0; n < sheets[s].count; n++) {
            rows[sheets[s].rows[n].verdict]++;
            spent += sheets[s].rows[n].seconds;
        }
        table_row(t);
        table_text(t, "%s", checks[s]->item.name);
        for (int v = 0; v < VERIFY_VERDICTS; v++) {
            table_integer(t, rows[v]);
            sum[v] += rows[v];
        }
        table_integer(t, sheets[s].count);
        table_number(t, spent, 2);
        sum[VERIFY_VERDICTS] += sheets[s].count;
        seconds += spent;
    }
    table_rule(t);
    table_row(t);
    table_text(t, "all");
    for (int v = 0; v <= VERIFY_VERDICTS; v++)
        table_integer(t, sum[v]);
    table_number(t, seconds, 2);
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

    if (format == TABLE_CSV)
        return print_flat(count, checks, sheets, file);
    for (int s = 0; s < count; s++) {
        TRY(print_sheet(checks[s], &sheets[s], format, file));
        fputc('\n', file);
    }
    TRY(print_summary(count, checks, sheets, format, file));
out:
    return st;
}
