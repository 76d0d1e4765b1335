/* table.c - what a table holds; table_print.c says how it looks to people, table_machine.c
 * to machines. */
#define _GNU_SOURCE /* vasprintf */
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
    return format == TABLE_TEXT || format == TABLE_MARKDOWN;
}

bool table_format_is_data(enum table_format format)
{
    return format == TABLE_CSV || format == TABLE_JSON;
}

int table_width(const char *text)
{
    int width = 0;

    for (; text && *text; text++)
        width += (*text & 0xC0) != 0x80;
    return width;
}

/* Columns of the table's own, each with a key of its own. */
static bool copy_columns(struct table *t, const struct table_column *columns)
{
    t->columns = calloc((size_t)t->column_count, sizeof *t->columns);
    t->width = calloc((size_t)t->column_count, sizeof *t->width);
    if (!t->columns || !t->width)
        return false;
    for (int n = 0; n < t->column_count; n++) {
        const struct table_column *from = &columns[n];
        const int header = table_width(from->header), unit = table_width(from->unit);
        t->width[n] = header > unit ? header : unit;
        t->columns[n] = *from;
        t->columns[n].key =
            from->key ? strdup(from->key) : table_machine_key(t->columns, n);
        if (!t->columns[n].key)
            return false;
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
    if (copy_columns(t, columns) && (!caption || t->caption))
        return t;
    table_destroy(t);
    return NULL;
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
    free(t->width);
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

/* What printf writes, on the heap; NULL: no memory. */
static char *printed(const char *format, va_list arguments)
{
    char *text;

    return vasprintf(&text, format, arguments) < 0 ? NULL : text;
}

static void add_cell(struct table *t, int kind, double value, char *text)
{
    if (!t || t->failed || !text) {
        free(text);
        if (t && !text)
            t->failed = true;
        return;
    }
    assert(t->row_count > 0 && t->filled < t->column_count);
    int *width = &t->width[t->filled];
    *width = table_width(text) > *width ? table_width(text) : *width;
    t->cells[(long)(t->row_count - 1) * t->column_count + t->filled++] =
        (struct table_cell){text, kind, value};
}

void table_text(struct table *t, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    add_cell(t, TABLE_CELL_TEXT, NAN, printed(format, arguments));
    va_end(arguments);
}

void table_missing(struct table *t, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    add_cell(t, TABLE_CELL_MISSING, NAN, printed(format, arguments));
    va_end(arguments);
}

void table_dash(struct table *t)
{
    table_missing(t, "-");
}

/* A number, which the format shows to people with so many digits, and as they see it. */
static void add_number(struct table *t, const char *format, int digits, double value)
{
    const bool there = t && !t->failed && t->filled < t->column_count;
    const double scale = there ? t->columns[t->filled].scale : 0;
    char *text = NULL;

    if ((isnan(value)
             ? asprintf(&text, "-")
             : asprintf(&text, format, digits, scale != 0 ? value * scale : value)) < 0)
        text = NULL;
    if (text && *text && text[strlen(text) - 1] == '.')
        text[strlen(text) - 1] = '\0'; /* # keeps zeros, and with them a bare point */
    add_cell(t, TABLE_CELL_NUMBER, value, text);
}

void table_number(struct table *t, double value, int digits)
{
    assert(digits > 0 && digits <= 17);
    add_number(t, "%#.*g", digits, value);
}

void table_fixed(struct table *t, double value, int decimals)
{
    add_number(t, "%.*f", decimals, value);
}

void table_integer(struct table *t, long value)
{
    char *text;

    if (asprintf(&text, "%ld", value) < 0)
        text = NULL;
    add_cell(t, TABLE_CELL_NUMBER, (double)value, text);
}

void table_note(struct table *t, const char *format, ...)
{
    va_list arguments;

    if (!t || t->failed)
        return;
    va_start(arguments, format);
    char *text = printed(format, arguments);
    va_end(arguments);
    if (!text || !grow(&t->notes, (size_t)t->note_count, (size_t)t->note_count + 1,
                       sizeof *t->notes)) {
        free(text);
        t->failed = true;
        return;
    }
    t->notes[t->note_count++] = text;
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

const struct table_cell *table_cell(const struct table *t, int row, int column)
{
    return &t->cells[(long)row * t->column_count + column];
}

double table_value(const struct table *t, int row, int column)
{
    const struct table_cell *cell = table_cell(t, row, column);

    return cell->kind == TABLE_CELL_NUMBER ? cell->value : NAN;
}

double table_shown(const struct table *t, int row, int column)
{
    const double scale = t->columns[column].scale;

    return table_value(t, row, column) * (scale != 0 ? scale : 1);
}

const char *table_words(const struct table *t, int row, int column)
{
    const struct table_cell *cell = table_cell(t, row, column);

    return cell->kind == TABLE_CELL_TEXT ? cell->text : "";
}
