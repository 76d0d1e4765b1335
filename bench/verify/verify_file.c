#include "bench/verify/verify_file.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/output.h"
#include "bench/files/provenance.h"

enum { DIGITS = 6, CELL = 512, PATH = 4096 };

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

/* The next cell, cut at the room there is; returns what ended it: ',', a line end, EOF. */
static int read_cell(FILE *file, char text[CELL])
{
    size_t used = 0;
    bool quoted = false;
    int c;

    while ((c = getc(file)) != EOF && (quoted || (c != ',' && c != '\n'))) {
        if (c == '"') {
            const int after = quoted ? getc(file) : 0;
            if (after != '"') { /* a quote begins or ends, no "" */
                if (quoted)
                    ungetc(after, file);
                quoted = !quoted;
                continue;
            }
        }
        if (used + 1 < CELL)
            text[used++] = (char)c;
    }
    text[used] = '\0';
    return c;
}

/* The cells of the next line that is no comment; false if there are not as many. *end: the
 * file is. */
static bool read_line(FILE *file, char cell[COLUMNS][CELL], bool *end)
{
    int c = getc(file), count = 0;

    while (c == '#') {
        while (c != '\n' && c != EOF)
            c = getc(file);
        c = getc(file);
    }
    *end = c == EOF;
    if (*end)
        return true;
    for (ungetc(c, file), c = ','; c == ',' && count < COLUMNS; count++)
        c = read_cell(file, cell[count]);
    return count == COLUMNS && c != ',';
}

static double number_of(const char *cell)
{
    return strtod(*cell ? cell : "nan", NULL);
}

/* False for a verdict that is none. */
static bool take_row(char cell[COLUMNS][CELL], struct verify_row *row)
{
    *row = (struct verify_row){.value = number_of(cell[VALUE]),
                               .truth = number_of(cell[TRUTH]),
                               .bar = number_of(cell[BAR]),
                               .error = number_of(cell[ERROR]),
                               .tolerance = number_of(cell[TOLERANCE]),
                               .order = number_of(cell[ORDER]),
                               .seconds = number_of(cell[SECONDS])};
    snprintf(row->quantity, VERIFY_TEXT, "%.*s", VERIFY_TEXT - 1, cell[QUANTITY]);
    snprintf(row->subject, VERIFY_TEXT, "%.*s", VERIFY_TEXT - 1, cell[MODEL]);
    snprintf(row->note, VERIFY_NOTE, "%.*s", VERIFY_NOTE - 1, cell[REMARK]);
    snprintf(row->changed, VERIFY_CHANGED, "%.*s", VERIFY_CHANGED - 1, cell[CHANGED]);
    for (int n = 0; n < VERIFY_VERDICTS; n++)
        if (!strcmp(cell[VERDICT], verify_verdict_name(n))) {
            row->verdict = (enum verify_verdict)n;
            return true;
        }
    return false;
}

/* The line of keys, then the rows. */
static enum status read_rows(FILE *file, const char *path, struct verify_sheet *sheet,
                             struct message *why)
{
    static char cell[COLUMNS][CELL];
    bool end, ours = read_line(file, cell, &end) && !end;

    for (int n = 0; ours && n < COLUMNS; n++)
        ours = !strcmp(cell[n], columns[n].key);
    if (!ours)
        return status_fail(why, STATUS_INPUT, "%s: its columns are not those of verify",
                           path);
    while (read_line(file, cell, &end)) {
        if (end)
            return sheet->status;
        if (!take_row(cell, verify_sheet_grow(sheet)))
            return status_fail(why, STATUS_INPUT, "%s: '%s' is no verdict", path,
                               cell[VERDICT]);
    }
    return status_fail(why, STATUS_INPUT, "%s: row %d has not %d cells", path,
                       sheet->count + 1, COLUMNS);
}

enum status verify_file_read(const struct verify_check *check, const char *folder,
                             struct verify_sheet *sheet, struct message *why)
{
    char path[PATH];

    *sheet = (struct verify_sheet){0};
    snprintf(path, PATH, "%s/%s.csv", folder, check->item.name);
    FILE *file = fopen(path, "r");
    if (!file)
        return status_fail(why, STATUS_FILE, "%s: %s", path, strerror(errno));
    const enum status st = read_rows(file, path, sheet, why);
    fclose(file);
    if (st != STATUS_OK)
        verify_sheet_clear(sheet);
    return st;
}
