/* table.c - holds a table, and prints it for machines (CSV after RFC 4180, JSON) and for
 * people (text, Markdown, LaTeX). */
#include "bench/ui/table.h"

#include <assert.h>
#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/arena.h"
#include "bench/files/output.h"

/* The most columns of the screen for a sentence, for any line, and for a wrapped cell. */
enum { TEXT_WIDTH = 96, LINE_WIDTH = 120, CELL_WIDTH = 40 };

struct table_cell {
    char *text; /* as people see it, or why it is missing; NULL: left out              */
    enum { TABLE_CELL_MISSING, TABLE_CELL_TEXT, TABLE_CELL_NUMBER } kind;
    double value; /* of a number, as machines get it                                   */
};

struct table_row {
    bool ruled; /* a rule above it */
    struct table_cell cell[];
};

struct table {
    int column_count, row_count, note_count;
    int filled;                   /* cells of the last row                             */
    bool rule_next;               /* above the row to come                             */
    struct table_column *columns; /* [column_count], each with a key                   */
    int *width;                   /* [column_count] of the widest text so far          */
    struct table_row **rows;      /* [row_count]                                       */
    char *caption;                /* NULL: none                                        */
    char **notes;                 /* [note_count]                                      */
    struct arena arena;           /*                                             owned */
};

/* The names of the values of enum table_format, in its order. */
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

enum { KEY = 128, NAME = 256 };

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
static char *key_of(struct arena *arena, const struct table_column *columns, int n)
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
static void copy_columns(struct table *t, const struct table_column *columns)
{
    t->columns = arena_take(&t->arena, (size_t)t->column_count, sizeof *t->columns);
    t->width = arena_take(&t->arena, (size_t)t->column_count, sizeof *t->width);
    for (int n = 0; n < t->column_count; n++) {
        const struct table_column *from = &columns[n];
        const int header = table_width(from->header), unit = table_width(from->unit);
        t->width[n] = header > unit ? header : unit;
        t->columns[n] = *from;
        t->columns[n].key = from->key ? arena_print(&t->arena, "%s", from->key)
                                      : key_of(&t->arena, t->columns, n);
        for (int k = 0; k < n; k++)
            assert(strcmp(t->columns[k].key, t->columns[n].key) != 0);
    }
}

struct table *table_create(int column_count, const struct table_column *columns,
                           const char *caption)
{
    struct arena arena = {0};
    struct table *t = arena_take(&arena, 1, sizeof *t);

    assert(column_count > 0);
    *t = (struct table){.column_count = column_count, .arena = arena};
    t->caption = caption ? arena_print(&t->arena, "%s", caption) : NULL;
    copy_columns(t, columns);
    return t;
}

void table_destroy(struct table *t)
{
    if (!t)
        return;
    struct arena arena = t->arena;
    arena_clear(&arena);
}

void table_row(struct table *t)
{
    const size_t size =
        sizeof **t->rows + (size_t)t->column_count * sizeof *t->rows[0]->cell;

    t->rows = arena_more(&t->arena, t->rows, (size_t)t->row_count, sizeof *t->rows);
    t->rows[t->row_count] = arena_take(&t->arena, 1, size);
    t->rows[t->row_count++]->ruled = t->rule_next;
    t->rule_next = false;
    t->filled = 0;
}

void table_rule(struct table *t)
{
    t->rule_next = true;
}

static void fill_cell(struct table *t, int kind, double value, const char *format,
                      va_list arguments)
{
    char *text = arena_vprint(&t->arena, format, arguments);

    assert(t->row_count > 0 && t->filled < t->column_count);
    const size_t length = strlen(text);
    if (kind == TABLE_CELL_NUMBER && text[length - 1] == '.')
        text[length - 1] = '\0'; /* # keeps zeros, and with them a bare point */
    int *width = &t->width[t->filled];
    *width = table_width(text) > *width ? table_width(text) : *width;
    t->rows[t->row_count - 1]->cell[t->filled++] = (struct table_cell){text, kind, value};
}

void table_text(struct table *t, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    fill_cell(t, TABLE_CELL_TEXT, NAN, format, arguments);
    va_end(arguments);
}

void table_missing(struct table *t, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    fill_cell(t, TABLE_CELL_MISSING, NAN, format, arguments);
    va_end(arguments);
}

/* Fills a cell with a number, printed by `format` for people. */
static void fill_number(struct table *t, double value, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    fill_cell(t, TABLE_CELL_NUMBER, value, isnan(value) ? "-" : format, arguments);
    va_end(arguments);
}

/* Returns the value as people see it in the next cell. */
static double scaled(const struct table *t, double value)
{
    const double scale = t->filled < t->column_count ? t->columns[t->filled].scale : 0;

    return scale != 0 ? value * scale : value;
}

/* Fills a cell with the number that `piece` of a format is the conversion of, "%.3g". */
static void add_number(struct table *t, const char *piece, char kind, va_list *arguments)
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
static void add_text(struct table *t, const char *piece, size_t size, va_list *arguments)
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
    table_text(t, "%s", text);
    free(text);
}

void table_add(struct table *t, const char *cells, ...)
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
            table_missing(t, "-");
        else
            add_text(t, c, size, &arguments);
        if (!c[size])
            break;
    }
    va_end(arguments);
}

void table_note(struct table *t, const char *format, ...)
{
    va_list arguments;

    t->notes = arena_more(&t->arena, t->notes, (size_t)t->note_count, sizeof *t->notes);
    va_start(arguments, format);
    t->notes[t->note_count++] = arena_vprint(&t->arena, format, arguments);
    va_end(arguments);
}

int table_rows(const struct table *t)
{
    return t->row_count;
}

int table_find(const struct table *t, const char *key)
{
    for (int n = 0; n < t->column_count; n++)
        if (!strcmp(t->columns[n].key, key))
            return n;
    return -1;
}

static const struct table_cell *cell_at(const struct table *t, int row, int column)
{
    return &t->rows[row]->cell[column];
}

/* --- lines of any format -------------------------------------------------------------- */

/* The form of a row for these readers, people or machines: its cells, with what stands
 * before, between and behind them. The row of headers or keys comes first. */
enum { TABLE_UNITS = -2, TABLE_HEADERS = -1 };
struct table_line {
    enum table_readers readers;
    const char *before, *between, *behind;
    void (*print)(const struct table *t, const struct table_line *line, int row, int column,
                  FILE *file);
    const char *const *escaped; /* [128] what is printed in place of a character; or NULL */
};

static bool has(const struct table *t, int column, enum table_readers readers)
{
    return t->columns[column].readers == readers || t->columns[column].readers == TABLE_ALL;
}

static void print_line(const struct table *t, const struct table_line *line, int row,
                       FILE *file)
{
    const char *before = line->before;

    for (int n = 0; n < t->column_count; n++)
        if (has(t, n, line->readers)) {
            fputs(before, file);
            line->print(t, line, row, n, file);
            before = line->between;
        }
    fputs(line->behind, file);
}

/* Prints a character; one that could rule a terminal, from the name of a file, as `?`. */
static void put(unsigned char c, FILE *file)
{
    fputc(iscntrl(c) && c != '\n' && c != '\t' ? '?' : c, file);
}

/* Prints text with characters replaced, between two strings as they are. */
static void print_escaped(const char *before, const char *text, const char *behind,
                          const char *const escaped[128], FILE *file)
{
    fputs(before, file);
    for (; *text; text++) {
        const unsigned char c = (unsigned char)*text;
        if (c < 128 && escaped[c])
            fputs(escaped[c], file);
        else
            put(c, file);
    }
    fputs(behind, file);
}

static const char *text_at(const struct table *t, int row, int column)
{
    const struct table_column *c = &t->columns[column];
    const char *text = row == TABLE_HEADERS ? c->header
                       : row == TABLE_UNITS ? c->unit
                                            : cell_at(t, row, column)->text;
    return text ? text : "";
}

static bool is_right(const struct table *t, int column)
{
    return t->columns[column].align == TABLE_RIGHT;
}

/* Prints a cell as people see it; a header with its unit. */
static void print_shown(const struct table *t, const struct table_line *line, int row,
                        int column, FILE *file)
{
    const char *unit = row == TABLE_HEADERS ? t->columns[column].unit : NULL;

    print_escaped("", text_at(t, row, column), "", line->escaped, file);
    if (unit)
        print_escaped(" [", unit, "]", line->escaped, file);
}

/* --- CSV ------------------------------------------------------------------------------ */

static void print_comment(const char *text, FILE *file)
{
    static const char *const escaped[128] = {['\n'] = "\n# "};

    print_escaped("# ", text, "\n", escaped, file);
}

/* Returns whether a spreadsheet would run a text instead of showing it: it may come from a
 * file of somebody else. */
static bool is_formula(const char *text)
{
    return strchr("=@\t\r", *text) ? *text != '\0'
                                   : strchr("+-", *text) && isalpha((unsigned char)text[1]);
}

static void print_field(const char *text, FILE *file)
{
    static const char *const escaped[128] = {['"'] = "\"\""};
    const char *quote = text[strcspn(text, ",\"\n\r")] || *text == '#' ? "\"" : "";

    fputs(quote, file);
    print_escaped(is_formula(text) ? "'" : "", text, quote, escaped, file);
}

static void print_cell(const struct table *t, const struct table_line *line, int row,
                       int column, FILE *file)
{
    const struct table_cell *cell = row == TABLE_HEADERS ? NULL : cell_at(t, row, column);

    (void)line;
    if (!cell)
        print_field(t->columns[column].key, file);
    else if (cell->kind == TABLE_CELL_TEXT)
        print_field(cell->text, file);
    else if (cell->kind == TABLE_CELL_NUMBER && !isnan(cell->value))
        fprintf(file, "%.17g", cell->value);
}

static void print_lines(const struct table *t, FILE *file)
{
    static const struct table_line line = {TABLE_MACHINES, "", ",", "\n", print_cell};

    for (int row = TABLE_HEADERS; row < t->row_count; row++)
        print_line(t, &line, row, file);
}

static void print_csv(const struct table *t, FILE *file)
{
    if (t->caption)
        print_comment(t->caption, file);
    print_lines(t, file);
    for (int n = 0; n < t->note_count; n++)
        print_comment(t->notes[n], file);
}

/* --- JSON ----------------------------------------------------------------------------- */

static struct {
    FILE *stream;
    char *text;
    size_t size;
    int count;
} held;

FILE *table_json_open(FILE *file)
{
    if (file != stdout)
        return file;
    if (!held.stream)
        held.stream = open_memstream(&held.text, &held.size);
    if (!held.stream)
        arena_end();
    if (held.count++)
        fputc(',', held.stream);
    return held.stream;
}

void table_json_close(void)
{
    if (!held.stream)
        return;
    if (ferror(held.stream) || fclose(held.stream) != 0)
        arena_end();
    printf(held.count > 1 ? "[%s]\n" : "%s", held.text);
    free(held.text);
    memset(&held, 0, sizeof held);
}

void table_json_string(const char *text, FILE *file)
{
    fputc('"', file);
    for (; *text; text++) {
        const unsigned char c = (unsigned char)*text;
        if (c == '"' || c == '\\')
            fprintf(file, "\\%c", c);
        else if (c < ' ' || c == 127)
            fprintf(file, "\\u%04x", c);
        else
            fputc(c, file);
    }
    fputc('"', file);
}

static void print_pair(const char *key, const char *text, FILE *file)
{
    table_json_string(key, file);
    fputs(": ", file);
    table_json_string(text, file);
}

static void print_value(const struct table *t, const struct table_line *line, int row,
                        int column, FILE *file)
{
    const struct table_cell *cell = cell_at(t, row, column);

    (void)line;
    table_json_string(t->columns[column].key, file);
    fputs(": ", file);
    if (cell->kind == TABLE_CELL_TEXT)
        table_json_string(cell->text, file);
    else if (cell->kind == TABLE_CELL_MISSING || isnan(cell->value))
        fputs("null", file);
    else if (isinf(cell->value))
        fputs(cell->value > 0 ? "\"inf\"" : "\"-inf\"", file);
    else
        fprintf(file, "%.17g", cell->value);
}

static void print_units(const struct table *t, FILE *file)
{
    const char *comma = "";

    for (int n = 0; n < t->column_count; n++) {
        const struct table_column *c = &t->columns[n];
        const char *unit = c->key_unit ? c->key_unit : c->unit;
        if (!unit || !has(t, n, TABLE_MACHINES))
            continue;
        fputs(comma, file);
        print_pair(c->key, unit, file);
        comma = ", ";
    }
}

static void print_json(const struct table *t, FILE *to)
{
    static const struct table_line object = {TABLE_MACHINES, "{", ", ", "}", print_value};
    FILE *file = table_json_open(to);

    fputc('{', file);
    print_pair("caption", t->caption ? t->caption : "", file);
    fputs(", \"units\": {", file);
    print_units(t, file);
    fputs("}, \"rows\": [", file);
    for (int row = 0; row < t->row_count; row++) {
        fputs(row ? ", " : "", file);
        print_line(t, &object, row, file);
    }
    fputs("], \"notes\": [", file);
    for (int n = 0; n < t->note_count; n++) {
        fputs(n ? ", " : "", file);
        table_json_string(t->notes[n], file);
    }
    fputs("]}\n", file);
}

/* --- text ---------------------------------------------------------------------------- */

/* Prints words in lines up to `width`, all but the first after `indent` blanks, which must
 * already stand before the first. */
static void print_words(const char *text, int indent, int width, FILE *file)
{
    int column = indent;

    while (*text) {
        int size = (int)strcspn(text, " \n");
        if (column > indent && column + 1 + size > width)
            column = fprintf(file, "\n%*s", indent, "") - 1;
        column += size + fprintf(file, "%s", column > indent ? " " : "");
        for (; size > 0; size--)
            put((unsigned char)*text++, file);
        if (*text == '\n')
            column = fprintf(file, "\n%*s", indent, "") - 1;
        text += *text != '\0';
    }
}

void table_print_wrapped(const char *text, FILE *file)
{
    print_words(text, 0, TEXT_WIDTH, file);
    fputc('\n', file);
}

void table_print_item(const char *name, int column, const char *text, FILE *file)
{
    const int blanks = column - table_width(name);

    fprintf(file, "%s%*s", name, blanks > 0 ? blanks : 2, "");
    print_words(text, blanks > 0 ? column : column - blanks + 2, LINE_WIDTH, file);
    fputc('\n', file);
}

void table_say(FILE *file, const char *format, ...)
{
    struct arena own = {0};
    va_list words;

    va_start(words, format);
    table_print_wrapped(arena_vprint(&own, format, words), file);
    va_end(words);
    arena_clear(&own);
}

/* Columns of a table that stand side by side: the first `keys` and [from, to). A table
 * wider than a line is printed in parts, one below the other, all of which begin with the
 * keys. */
struct part {
    int keys, from, to;
};

static bool is_shown(const struct table *t, const struct part *p, int n)
{
    return has(t, n, TABLE_PEOPLE) && (n < p->keys || n >= p->from) && n < p->to;
}

/* Returns the width of a part's columns with blanks between; the last may be wrapped. */
static int part_width(const struct table *t, const struct part *p)
{
    int total = -2;

    for (int n = 0; n < p->to; n++)
        total += is_shown(t, p, n) ? t->width[n] + 2 : 0;
    return total;
}

/* Prints one line of cells. Blanks are printed only before something, none at the end. */
static void print_cells(const struct table *t, const struct part *p, int row, FILE *file)
{
    static const char *const none[128] = {NULL};
    int pending = 0, column = 0;

    for (int n = 0; n < p->to; n++) {
        if (!is_shown(t, p, n))
            continue;
        const char *cell = text_at(t, row, n);
        int blanks = t->width[n] - table_width(cell);

        pending += is_right(t, n) ? blanks : 0;
        if (*cell) {
            column += fprintf(file, "%*s", pending, "");
            if (column + table_width(cell) > LINE_WIDTH)
                print_words(cell, column, LINE_WIDTH, file);
            else
                print_escaped("", cell, "", none, file);
            column += table_width(cell);
            pending = 0;
        }
        pending += (is_right(t, n) ? 0 : blanks) + 2;
    }
    fputc('\n', file);
}

static void print_rule(const struct table *t, const struct part *p, FILE *file)
{
    const int total = part_width(t, p);

    for (int n = 0; n < total && n < LINE_WIDTH; n++)
        fputc('-', file);
    fputc('\n', file);
}

static void print_part(const struct table *t, const struct part *p, FILE *file)
{
    bool units = false;

    for (int n = 0; n < p->to; n++)
        units = units || (is_shown(t, p, n) && t->columns[n].unit);
    print_cells(t, p, TABLE_HEADERS, file);
    if (units)
        print_cells(t, p, TABLE_UNITS, file);
    print_rule(t, p, file);
    for (int row = 0; row < t->row_count; row++) {
        if (row && t->rows[row]->ruled)
            print_rule(t, p, file);
        print_cells(t, p, row, file);
    }
}

static bool same_keys(const struct table *t, int keys, int row, int other)
{
    for (int n = 0; n < keys; n++)
        if (has(t, n, TABLE_PEOPLE) &&
            strcmp(text_at(t, row, n), text_at(t, other, n)) != 0)
            return false;
    return true;
}

/* Returns how many of the first columns distinguish all rows; if none do within half a
 * line, how many hold names. */
static int key_columns(const struct table *t)
{
    struct part p = {.to = 0};

    while (++p.to < t->column_count && part_width(t, &p) <= LINE_WIDTH / 2) {
        bool distinct = true;
        for (int row = 0; row < t->row_count && distinct; row++)
            for (int other = 0; other < row && distinct; other++)
                distinct = !same_keys(t, p.to, row, other);
        if (distinct && part_width(t, &p) > 0)
            return p.to;
    }
    for (p.to = 1; p.to < t->column_count && !is_right(t, p.to);)
        p.to++;
    return part_width(t, &p) <= LINE_WIDTH / 2 ? p.to : 1;
}

/* Takes the columns that a line has room for, one at least; a long one of words, wrapped,
 * is the last. */
static void fill_part(const struct table *t, struct part *p)
{
    bool wrapped = false, begins = true;

    for (p->to = p->from; p->to < t->column_count; p->to++) {
        struct part more = {p->keys, p->from, p->to + 1};
        const int over = part_width(t, &more) - LINE_WIDTH, width = t->width[p->to];
        if (!has(t, p->to, TABLE_PEOPLE))
            continue;
        if (wrapped ||
            (over > 0 && !begins && (is_right(t, p->to) || width - over < CELL_WIDTH)))
            return;
        wrapped = over > 0;
        begins = false;
    }
}

static void print_text(const struct table *t, FILE *file)
{
    struct part p = {0, 0, t->column_count};

    if (t->caption) {
        table_print_wrapped(t->caption, file);
        fputc('\n', file);
    }
    if (part_width(t, &p) > LINE_WIDTH)
        fill_part(t, &p);
    print_part(t, &p, file);
    while (p.to < t->column_count) {
        fputc('\n', file);
        p = (struct part){p.keys ? p.keys : key_columns(t), p.to, p.to};
        fill_part(t, &p);
        print_part(t, &p, file);
    }
    for (int n = 0; n < t->note_count; n++) {
        fputc('\n', file);
        table_print_wrapped(t->notes[n], file);
    }
}

/* --- Markdown ------------------------------------------------------------------------- */

static void print_markdown(const struct table *t, FILE *file)
{
    static const char *const escaped[128] = {
        ['|'] = "\\|", ['*'] = "\\*", ['_'] = "\\_", ['\n'] = " "};
    static const struct table_line line = {TABLE_PEOPLE, "| ",        " | ",
                                           " |\n",       print_shown, escaped};

    if (t->caption)
        fprintf(file, "**%s**\n\n", t->caption);
    print_line(t, &line, TABLE_HEADERS, file);
    for (int n = 0; n < t->column_count; n++)
        if (has(t, n, TABLE_PEOPLE))
            fputs(is_right(t, n) ? "|---:" : "|:---", file);
    fputs("|\n", file);
    for (int row = 0; row < t->row_count; row++)
        print_line(t, &line, row, file);
    for (int n = 0; n < t->note_count; n++)
        fprintf(file, "\n%s\n", t->notes[n]);
}

/* --- LaTeX: plain tabular, no packages ------------------------------------------------ */

static void print_latex(const struct table *t, FILE *file)
{
    static const char *const escaped[128] = {['&'] = "\\&",
                                             ['%'] = "\\%",
                                             ['$'] = "\\$",
                                             ['#'] = "\\#",
                                             ['_'] = "\\_",
                                             ['{'] = "\\{",
                                             ['}'] = "\\}",
                                             ['<'] = "$<$",
                                             ['~'] = "\\~{}",
                                             ['>'] = "$>$",
                                             ['^'] = "\\^{}",
                                             ['|'] = "$|$",
                                             ['\\'] = "\\textbackslash{}"};
    static const struct table_line line = {TABLE_PEOPLE, "",          " & ",
                                           " \\\\\n",    print_shown, escaped};

    fputs("\\begin{table}\n\\centering\n", file);
    if (t->caption)
        print_escaped("\\caption{", t->caption, "}\n", escaped, file);
    fputs("\\begin{tabular}{", file);
    for (int n = 0; n < t->column_count; n++)
        if (has(t, n, TABLE_PEOPLE))
            fputc(is_right(t, n) ? 'r' : 'l', file);
    fputs("}\n\\hline\n", file);
    print_line(t, &line, TABLE_HEADERS, file);
    fputs("\\hline\n", file);
    for (int row = 0; row < t->row_count; row++) {
        fputs(row && t->rows[row]->ruled ? "\\hline\n" : "", file);
        print_line(t, &line, row, file);
    }
    fputs("\\hline\n\\end{tabular}\n", file);
    for (int n = 0; n < t->note_count; n++)
        print_escaped("\n\\smallskip\\footnotesize ", t->notes[n], "\n", escaped, file);
    fputs("\\end{table}\n", file);
}

enum status table_print(const struct table *t, enum table_format format, FILE *file)
{
    static void (*const print[])(const struct table *, FILE *) = {
        [TABLE_TEXT] = print_text,         [TABLE_CSV] = print_csv,
        [TABLE_MARKDOWN] = print_markdown, [TABLE_LATEX] = print_latex,
        [TABLE_JSON] = print_json,
    };

    print[format](t, file);
    return ferror(file) ? STATUS_FILE : STATUS_OK;
}

enum status table_end(struct table *t, enum table_format format, FILE *file)
{
    const enum status st = table_print(t, format, file);

    table_destroy(t);
    return st;
}

enum status table_finish(struct table *t, enum table_format format, FILE *file)
{
    const enum status st = table_end(t, format, file);

    if (st == STATUS_OK && format != TABLE_JSON)
        fputc('\n', file);
    return st;
}

enum status table_publish(struct table *t, const char *folder, const char *name,
                          enum table_format format, FILE *file, struct message *why)
{
    const enum status st = table_save(t, folder, name, why);

    if (st == STATUS_OK)
        return table_finish(t, format, file);
    table_destroy(t);
    return st;
}

enum status table_save(const struct table *t, const char *folder, const char *name,
                       struct message *why)
{
    struct output *out = NULL;
    char file[NAME];
    enum status st;

    snprintf(file, sizeof file, "%s.csv", name);
    TRY(output_create_in(folder, file, &out, why));
    print_lines(t, output_stream(out));
    st = output_close(&out, why);
out:
    return st;
}
