/* table.c - what a table holds; table_print.c says how it looks to people, table_machine.c
 * to machines. */
#include "bench/ui/table_parts.h"

#include <assert.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

/* One name a value of enum table_format, in its order. */
static const char *const format_names[] = {"text", "csv", "markdown", "latex", "json"};
enum { FORMATS = sizeof format_names / sizeof *format_names };

enum status table_format_parse(const char *word, enum table_format *format,
                               struct message *why)
{
    for (int n = 0; n < FORMATS; n++)
        if (!strcmp(word, format_names[n])) {
            *format = (enum table_format)n;
            return STATUS_OK;
        }
    return status_fail(why, STATUS_INPUT,
                       "--format %s: a format is text, csv, markdown, latex or json", word);
}

bool table_format_is_prose(enum table_format format)
{
    return format != TABLE_CSV && format != TABLE_JSON;
}

/* Columns of the table's own, each with a key of its own. */
static bool copy_columns(struct table *t, const struct table_column *columns)
{
    t->columns = malloc((size_t)t->column_count * sizeof *t->columns);
    if (!t->columns)
        return false;
    memcpy(t->columns, columns, (size_t)t->column_count * sizeof *columns);
    for (int n = 0; n < t->column_count; n++) {
        const char *key = columns[n].key;
        t->columns[n].key = key ? strdup(key) : table_machine_key(t->columns, n);
        if (!t->columns[n].key) {
            t->column_count = n; /* what there is to free */
            return false;
        }
        for (int k = 0; k < n; k++)
            assert(strcmp(t->columns[k].key, t->columns[n].key) != 0);
    }
    return true;
}

struct table *table_create(int column_count, const struct table_column *columns,
                           const char *caption)
{
    struct table *t = calloc(1, sizeof *t);

    assert(column_count > 0);
    if (!t)
        return NULL;
    t->column_count = column_count;
    t->caption = caption ? strdup(caption) : NULL;
    if (!copy_columns(t, columns) || (caption && !t->caption)) {
        table_destroy(t);
        return NULL;
    }
    return t;
}

void table_destroy(struct table *t)
{
    if (!t)
        return;
    for (long n = 0; t->cells && n < (long)t->row_count * t->column_count; n++)
        free(t->cells[n].text);
    for (int n = 0; n < t->note_count; n++)
        free(t->notes[n]);
    for (int n = 0; t->columns && n < t->column_count; n++)
        free((char *)t->columns[n].key);
    free(t->cells);
    free(t->ruled);
    free(t->notes);
    free(t->columns);
    free(t->caption);
    free(t);
}

/* *array grown to `count` elements of `size` bytes, the new ones zero. */
static bool grow(void *array, size_t old, size_t count, size_t size)
{
    char **at = array, *grown = realloc(*at, count * size);

    if (!grown)
        return false;
    memset(grown + old * size, 0, (count - old) * size);
    *at = grown;
    return true;
}

/* Room for one more row, which is started by table_row; `ruled` has room for the rule below
 * the last one. */
static bool room(struct table *t)
{
    const size_t rows = (size_t)t->room, more = rows ? 2 * rows : 4;
    const size_t columns = (size_t)t->column_count;

    if (t->failed || t->room > t->row_count)
        return !t->failed;
    t->failed = !grow(&t->cells, rows * columns, more * columns, sizeof *t->cells) ||
                !grow(&t->ruled, rows, more, sizeof *t->ruled);
    t->room = t->failed ? t->room : (int)more;
    return !t->failed;
}

void table_row(struct table *t)
{
    if (!t || !room(t))
        return;
    t->row_count++;
    t->filled = 0;
}

void table_rule(struct table *t)
{
    if (t && room(t))
        t->ruled[t->row_count] = true;
}

static char *format_text(const char *format, va_list arguments)
{
    char *text = NULL;
    va_list again;

    va_copy(again, arguments);
    int size = vsnprintf(NULL, 0, format, again);
    va_end(again);
    if (size >= 0 && (text = malloc((size_t)size + 1)))
        vsnprintf(text, (size_t)size + 1, format, arguments);
    return text;
}

static void add_cell(struct table *t, struct table_cell cell)
{
    if (!t || t->failed || !cell.text) {
        free(cell.text);
        if (t && !cell.text)
            t->failed = true;
        return;
    }
    assert(t->row_count > 0 && t->filled < t->column_count);
    t->cells[(long)(t->row_count - 1) * t->column_count + t->filled++] = cell;
}

static char *print_text(const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    char *text = format_text(format, arguments);
    va_end(arguments);
    return text;
}

void table_text(struct table *t, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    add_cell(t, (struct table_cell){format_text(format, arguments), TABLE_CELL_TEXT, NAN});
    va_end(arguments);
}

/* What people see of a value in the next cell. */
static double shown(const struct table *t, double value)
{
    const bool there = t && !t->failed && t->filled < t->column_count;
    const double scale = there ? t->columns[t->filled].scale : 0;

    return scale != 0 ? value * scale : value;
}

void table_number(struct table *t, double value, int digits)
{
    char *text;

    assert(digits > 0 && digits <= 17);
    text = isnan(value) ? print_text("-") : print_text("%#.*g", digits, shown(t, value));
    if (text && *text && text[strlen(text) - 1] == '.')
        text[strlen(text) - 1] = '\0'; /* # keeps zeros, and with them a bare point */
    add_cell(t, (struct table_cell){text, TABLE_CELL_NUMBER, value});
}

void table_fixed(struct table *t, double value, int decimals)
{
    char *text =
        isnan(value) ? print_text("-") : print_text("%.*f", decimals, shown(t, value));

    add_cell(t, (struct table_cell){text, TABLE_CELL_NUMBER, value});
}

void table_integer(struct table *t, long value)
{
    add_cell(
        t, (struct table_cell){print_text("%ld", value), TABLE_CELL_NUMBER, (double)value});
}

void table_dash(struct table *t)
{
    table_missing(t, "-");
}

void table_missing(struct table *t, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    add_cell(t,
             (struct table_cell){format_text(format, arguments), TABLE_CELL_MISSING, NAN});
    va_end(arguments);
}

void table_note(struct table *t, const char *format, ...)
{
    va_list arguments;

    if (!t || t->failed)
        return;
    va_start(arguments, format);
    char *text = format_text(format, arguments);
    va_end(arguments);
    if (!text || !grow(&t->notes, (size_t)t->note_count, (size_t)t->note_count + 1,
                       sizeof *t->notes)) {
        free(text);
        t->failed = true;
        return;
    }
    t->notes[t->note_count++] = text;
}

bool table_has(const struct table *t, int column, enum table_readers readers)
{
    return t->columns[column].readers == readers || t->columns[column].readers == TABLE_ALL;
}

int table_rows(const struct table *t)
{
    return t && !t->failed ? t->row_count : 0;
}

int table_find(const struct table *t, const char *key)
{
    int column = 0;

    while (column < t->column_count && strcmp(t->columns[column].key, key) != 0)
        column++;
    assert(column < t->column_count);
    return column;
}

const struct table_column *table_column(const struct table *t, int column)
{
    return &t->columns[column];
}

static const struct table_cell *cell_at(const struct table *t, int row, int column)
{
    return &t->cells[(long)row * t->column_count + column];
}

double table_value(const struct table *t, int row, int column)
{
    const struct table_cell *cell = cell_at(t, row, column);

    return cell->kind == TABLE_CELL_NUMBER ? cell->value : NAN;
}

double table_shown(const struct table *t, int row, int column)
{
    const double scale = t->columns[column].scale;

    return table_value(t, row, column) * (scale != 0 ? scale : 1);
}

const char *table_words(const struct table *t, int row, int column)
{
    const struct table_cell *cell = cell_at(t, row, column);

    return cell->kind == TABLE_CELL_TEXT ? cell->text : "";
}
