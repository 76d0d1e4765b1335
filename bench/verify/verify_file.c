#include "bench/verify/verify_file.h"

#include <string.h>

#include "bench/files/csv.h"
#include "bench/files/output.h"
#include "bench/files/provenance.h"

enum { DIGITS = 6, PATH = 4096 };

enum column {
    QUANTITY,
    MODEL,
    VALUE,
    TRUTH,
    BAR,
    ERROR,
    TOLERANCE,
    ORDER,
    VERDICT,
    SECONDS,
    REMARK,
    CHECK,
    SOURCE,
    CHANGED,
    COLUMNS
};

static const struct table_column columns[COLUMNS] = {
    {"quantity", NULL, TABLE_LEFT, "quantity"},
    {"model", NULL, TABLE_LEFT, "model"},
    {"value", .key = "value"},
    {"truth", .key = "truth"},
    {"error bar", .key = "error_bar"},
    {"error", .key = "error"},
    {"tolerance", .key = "tolerance"},
    {"order", .key = "order"},
    {"verdict", NULL, TABLE_LEFT, "verdict"},
    {"time", "s", .key = "time_s"},
    {"remark", NULL, TABLE_LEFT, "remark", TABLE_MACHINES},
    {"check", NULL, TABLE_LEFT, "check", TABLE_MACHINES},
    {"source", NULL, TABLE_LEFT, "source", TABLE_MACHINES},
    {"claimed at first", NULL, TABLE_LEFT, "claimed_at_first", TABLE_MACHINES}};

struct table *verify_file_table(const char *caption)
{
    return table_create(COLUMNS, columns, caption);
}

void verify_file_row(struct table *t, const struct verify_check *check,
                     const struct verify_row *row)
{
    table_row(t);
    table_text(t, "%s", row->quantity);
    table_text(t, "%s", row->subject);
    table_number(t, row->value, DIGITS);
    table_number(t, row->truth, DIGITS);
    table_number(t, row->bar, 1);
    table_number(t, row->error, 2);
    table_number(t, row->tolerance, 2);
    table_fixed(t, row->order, 2);
    table_text(t, "%s", verify_verdict_name((int)row->verdict));
    table_number(t, row->seconds, 2);
    table_text(t, "%s", row->note);
    table_text(t, "%s", check->item.name);
    table_text(t, "%s", check->source);
    table_text(t, "%s", row->changed);
}

enum status verify_file_write(const struct verify_check *check,
                              const struct verify_sheet *sheet, const char *folder,
                              struct message *why)
{
    enum status st;
    struct output *file = NULL;
    struct provenance provenance;
    struct table *t = verify_file_table(NULL);
    char path[PATH];

    snprintf(path, PATH, "%s/%s.csv", folder, check->item.name);
    TRY(output_create(path, &file, why));
    provenance_collect(&provenance);
    output_print(file, "# clothbench verify %s\n", check->item.name);
    for (int n = 0; n < provenance.count; n++)
        output_print(file, "# %s: %s\n", provenance.entry[n].key,
                     provenance.entry[n].value);
    for (int n = 0; n < sheet->count; n++)
        verify_file_row(t, check, &sheet->rows[n]);
    table_flush(t, output_stream(file));
    st = output_close(file, why);
out:
    table_destroy(t);
    return st;
}

/* False for a verdict that is none. */
static bool take_row(const struct csv_table *t, int n, struct verify_row *row)
{
    *row = (struct verify_row){.value = csv_number(t, n, VALUE),
                               .truth = csv_number(t, n, TRUTH),
                               .bar = csv_number(t, n, BAR),
                               .error = csv_number(t, n, ERROR),
                               .tolerance = csv_number(t, n, TOLERANCE),
                               .order = csv_number(t, n, ORDER),
                               .seconds = csv_number(t, n, SECONDS)};
    snprintf(row->quantity, VERIFY_TEXT, "%.*s", VERIFY_TEXT - 1,
             csv_words(t, n, QUANTITY));
    snprintf(row->subject, VERIFY_TEXT, "%.*s", VERIFY_TEXT - 1, csv_words(t, n, MODEL));
    snprintf(row->note, VERIFY_NOTE, "%.*s", VERIFY_NOTE - 1, csv_words(t, n, REMARK));
    snprintf(row->changed, VERIFY_CHANGED, "%.*s", VERIFY_CHANGED - 1,
             csv_words(t, n, CHANGED));
    for (int v = 0; v < VERIFY_VERDICTS; v++)
        if (!strcmp(csv_words(t, n, VERDICT), verify_verdict_name(v))) {
            row->verdict = (enum verify_verdict)v;
            return true;
        }
    return false;
}

static bool is_ours(const struct csv *csv)
{
    bool ours = csv->count == 1 && csv->table->columns == COLUMNS;

    for (int n = 0; ours && n < COLUMNS; n++)
        ours = !strcmp(csv->table->cell[n], columns[n].key);
    return ours;
}

enum status verify_file_read(const struct verify_check *check, const char *folder,
                             struct verify_sheet *sheet, struct message *why)
{
    struct csv csv = {0};
    char path[PATH];
    enum status st;

    *sheet = (struct verify_sheet){0};
    snprintf(path, PATH, "%s/%s.csv", folder, check->item.name);
    TRY(csv_read(path, &csv, why));
    if (!is_ours(&csv))
        TRY(status_fail(why, STATUS_INPUT, "%s: its columns are not those of verify",
                        path));
    for (int n = 0; n < csv.table->rows; n++)
        if (!take_row(csv.table, n, verify_sheet_grow(sheet)))
            TRY(status_fail(why, STATUS_INPUT, "%s: '%s' is no verdict", path,
                            csv_words(csv.table, n, VERDICT)));
    st = sheet->status;
out:
    csv_clear(&csv);
    if (st != STATUS_OK)
        verify_sheet_clear(sheet);
    return st;
}
