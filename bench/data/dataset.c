#include "bench/data/dataset.h"

#include <assert.h>
#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/data/wrap.h"

enum { KEY = 128 };

/* --- keys ----------------------------------------------------------------------------- */

/* Makes a key of words: small letters, digits, and one _ for most else between them. */
static void key_of_words(const char *words, char key[KEY])
{
    size_t used = 0;

    for (; *words && used + 8 < KEY; words++) {
        const char *as = *words == '%' ? "percent" : *words == '/' ? "per_" : "";
        const bool plain = isalnum((unsigned char)*words);
        if (!plain && *words != '%' && *words != '^' && used && key[used - 1] != '_')
            key[used++] = '_';
        if (plain)
            key[used++] = (char)tolower((unsigned char)*words);
        used += (size_t)sprintf(key + used, "%s", as);
    }
    while (used && key[used - 1] == '_')
        used--;
    key[used] = '\0';
}

/* Returns the key of a column, made of its header and unit; a second one gets _2. */
static char *key_of(struct arena *arena, const struct dataset_column *columns, int n)
{
    const char *unit = columns[n].unit ? columns[n].unit : "1";
    char words[KEY], key[KEY];
    int twins = 1;

    snprintf(words, sizeof words, "%s %s", columns[n].header,
             !strcmp(unit, "1")     ? ""
             : !strcmp(unit, "L")   ? "over length"
             : !strcmp(unit, "% L") ? "over length percent"
                                    : unit);
    key_of_words(words, key);
    for (int k = 0; k < n; k++) {
        const size_t size = strlen(key);
        const char *other = columns[k].key;
        twins += !strncmp(other, key, size) && (!other[size] || other[size] == '_') &&
                 strspn(other + size, "_0123456789") == strlen(other + size);
    }
    return arena_print(arena, twins > 1 ? "%s_%d" : "%s", *key ? key : "column", twins);
}

/* --- what it holds -------------------------------------------------------------------- */

/* Copies the columns and gives each a key of its own. */
static void copy_columns(struct dataset *t, const struct dataset_column *columns)
{
    t->columns = arena_take(&t->arena, (size_t)t->column_count, sizeof *t->columns);
    t->width = arena_take(&t->arena, (size_t)t->column_count, sizeof *t->width);
    t->numeric = arena_take(&t->arena, (size_t)t->column_count, sizeof *t->numeric);
    for (int n = 0; n < t->column_count; n++) {
        const struct dataset_column *from = &columns[n];
        const int header = wrap_width(from->header), unit = wrap_width(from->unit);
        t->width[n] = header > unit ? header : unit;
        t->columns[n] = *from;
        t->columns[n].key = from->key ? arena_print(&t->arena, "%s", from->key)
                                      : key_of(&t->arena, t->columns, n);
        for (int k = 0; k < n; k++)
            assert(strcmp(t->columns[k].key, t->columns[n].key) != 0);
    }
}

struct dataset *dataset_create(int column_count, const struct dataset_column *columns,
                               const char *caption)
{
    struct arena arena = {0};
    struct dataset *t = arena_take(&arena, 1, sizeof *t);

    assert(column_count > 0);
    *t = (struct dataset){.column_count = column_count, .arena = arena};
    t->caption = caption ? arena_print(&t->arena, "%s", caption) : NULL;
    copy_columns(t, columns);
    return t;
}

void dataset_destroy(struct dataset *t)
{
    if (!t)
        return;
    struct arena arena = t->arena;
    arena_clear(&arena);
}

void dataset_row(struct dataset *t)
{
    const size_t size =
        sizeof **t->rows + (size_t)t->column_count * sizeof *t->rows[0]->cell;

    t->rows = arena_more(&t->arena, t->rows, (size_t)t->row_count, sizeof *t->rows);
    t->rows[t->row_count] = arena_take(&t->arena, 1, size);
    t->rows[t->row_count++]->ruled = t->rule_next;
    t->rule_next = false;
    t->filled = 0;
}

void dataset_rule(struct dataset *t)
{
    t->rule_next = true;
}

static void fill_cell(struct dataset *t, int kind, double value, const char *format,
                      va_list arguments)
{
    char *text = arena_vprint(&t->arena, format, arguments);

    assert(t->row_count > 0 && t->filled < t->column_count);
    const size_t length = strlen(text);
    if (kind == DATASET_CELL_NUMBER && text[length - 1] == '.')
        text[length - 1] = '\0'; /* # keeps zeros, and with them a bare point */
    t->numeric[t->filled] |= kind == DATASET_CELL_NUMBER;
    int *width = &t->width[t->filled];
    *width = wrap_width(text) > *width ? wrap_width(text) : *width;
    t->rows[t->row_count - 1]->cell[t->filled++] = (struct dataset_cell){text, kind, value};
}

void dataset_text(struct dataset *t, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    fill_cell(t, DATASET_CELL_TEXT, NAN, format, arguments);
    va_end(arguments);
}

void dataset_missing(struct dataset *t, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    fill_cell(t, DATASET_CELL_MISSING, NAN, format, arguments);
    va_end(arguments);
}

/* Fills a cell with a number, printed by `format` for people. */
static void fill_number(struct dataset *t, double value, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    fill_cell(t, DATASET_CELL_NUMBER, value, isnan(value) ? "-" : format, arguments);
    va_end(arguments);
}

/* Returns the value as people see it in the next cell. */
static double scaled(const struct dataset *t, double value)
{
    const double scale = t->filled < t->column_count ? t->columns[t->filled].scale : 0;

    return scale != 0 ? value * scale : value;
}

/* Fills a cell with the number that `piece` of a format is the conversion of, "%.3g". */
static void add_number(struct dataset *t, const char *piece, char kind, va_list *arguments)
{
    const bool given = piece[1] == '.' && piece[2] == '*';
    const int digits =
        given ? va_arg(*arguments, int) : atoi(piece + 1 + (piece[1] == '.'));
    const double value = kind != 'd'       ? va_arg(*arguments, double)
                         : piece[1] == 'l' ? (double)va_arg(*arguments, long)
                                           : va_arg(*arguments, int);

    fill_number(t, value, kind == 'g' ? "%#.*g" : "%.*f", digits, scaled(t, value));
}

/* Fills a cell with text; its conversions are whole numbers, numbers and words. */
static void add_text(struct dataset *t, const char *piece, size_t size, va_list *arguments)
{
    char *text = NULL, one[32];
    size_t length;
    FILE *to = open_memstream(&text, &length);

    if (!to)
        arena_end();
    for (const char *c = piece; c < piece + size; c++) {
        const int used = snprintf(one, sizeof one, "%.*s", 1 + (int)strcspn(c, "sdgf"), c);
        if (*c != '%') {
            fputc(*c, to);
            continue;
        }
        assert(used < (int)sizeof one);
        c += used - 1;
        if (*c == 's')
            fprintf(to, one, va_arg(*arguments, const char *));
        else if (*c == 'd')
            fprintf(to, one, va_arg(*arguments, int));
        else
            fprintf(to, one, va_arg(*arguments, double));
    }
    if (fclose(to) != 0)
        arena_end();
    dataset_text(t, "%s", text);
    free(text);
}

void dataset_add(struct dataset *t, const char *cells, ...)
{
    va_list arguments;
    size_t size;

    va_start(arguments, cells);
    for (const char *c = cells;; c += size + 1) {
        size = strcspn(c, "|");
        const bool one = *c == '%' && strcspn(c, "sdgf") == size - 1;
        if (one && c[size - 1] != 's')
            add_number(t, c, c[size - 1], &arguments);
        else if (size == 1 && *c == '-')
            dataset_missing(t, "-");
        else
            add_text(t, c, size, &arguments);
        if (!c[size])
            break;
    }
    va_end(arguments);
}

void dataset_note(struct dataset *t, const char *format, ...)
{
    va_list arguments;

    t->notes = arena_more(&t->arena, t->notes, (size_t)t->note_count, sizeof *t->notes);
    va_start(arguments, format);
    t->notes[t->note_count++] = arena_vprint(&t->arena, format, arguments);
    va_end(arguments);
}

int dataset_count(const struct dataset *t)
{
    return t->row_count;
}

int dataset_find(const struct dataset *t, const char *key)
{
    for (int n = 0; n < t->column_count; n++)
        if (!strcmp(t->columns[n].key, key))
            return n;
    return -1;
}
