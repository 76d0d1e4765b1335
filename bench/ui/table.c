/* table.c - what a table holds; table_print.c says how it looks. */
#include "bench/ui/table_cells.h"

#include <assert.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

/* One name a value of enum table_format, in its order. */
static const char *const format_names[] = {"text", "csv", "markdown", "latex"};

enum status table_format_parse(const char *word, enum table_format *format,
                               struct message *why)
{
    for (int n = 0; n < 4; n++)
        if (!strcmp(word, format_names[n])) {
            *format = (enum table_format)n;
            return STATUS_OK;
        }
    return status_fail(why, STATUS_INPUT,
                       "--format %s: a format is text, csv, markdown or latex", word);
}

struct table *table_create(int column_count, const struct table_column *columns,
                           const char *caption)
{
    struct table *t = calloc(1, sizeof *t);

    assert(column_count > 0);
    if (!t)
        return NULL;
    t->column_count = column_count;
    t->columns = malloc((size_t)column_count * sizeof *t->columns);
    t->caption = caption ? strdup(caption) : NULL;
    if (!t->columns || (caption && !t->caption)) {
        table_destroy(t);
        return NULL;
    }
    memcpy(t->columns, columns, (size_t)column_count * sizeof *columns);
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
    size_t rows = (size_t)t->row_count, columns = (size_t)t->column_count;

    if (t->failed || t->room > t->row_count)
        return !t->failed;
    t->failed = !grow(&t->cells, rows * columns, (rows + 1) * columns, sizeof *t->cells) ||
                !grow(&t->ruled, rows, rows + 1, sizeof *t->ruled);
    t->room = t->row_count + !t->failed;
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
    add_cell(t, (struct table_cell){.text = format_text(format, arguments)});
    va_end(arguments);
}

void table_number(struct table *t, double value, int digits)
{
    char *text;

    assert(digits > 0 && digits <= 17);
    text = print_text("%#.*g", digits, value);
    if (text && *text && text[strlen(text) - 1] == '.')
        text[strlen(text) - 1] = '\0'; /* # keeps zeros, and with them a bare point */
    add_cell(t, (struct table_cell){text, TABLE_CELL_NUMBER, value});
}

void table_fixed(struct table *t, double value, int decimals)
{
    add_cell(t, (struct table_cell){print_text("%.*f", decimals, value), TABLE_CELL_NUMBER,
                                    value});
}

void table_integer(struct table *t, long value)
{
    add_cell(t, (struct table_cell){.text = print_text("%ld", value)});
}

void table_dash(struct table *t)
{
    add_cell(t, (struct table_cell){print_text("-"), TABLE_CELL_DASH, NAN});
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
