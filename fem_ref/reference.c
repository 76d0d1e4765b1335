#include "fem_ref/reference.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "models/reader/named_file.h"

/* Cells and comments point into the text of the whole file. */
struct reference {
    char *path, *text;
    char **comment; /* [comments] without the #          */
    char **name;    /* [columns]                         */
    char **cell;    /* [rows][columns]                   */
    int *line;      /* [rows] in the file                */
    int comments, columns, rows, head;
    struct message *fault; /* of the first wrong query; "" */
};

static const char NO_MEMORY[] = "out of memory";

/* Reads up to the first byte 0, which no table has. */
static enum status slurp(const char *path, char **text, struct message *why)
{
    FILE *file = fopen(path, "rb");
    size_t room = 0;
    enum status st = STATUS_OK;

    if (!file)
        return status_fail(why, STATUS_FILE, "%s: %s", path, strerror(errno));
    const ssize_t size = getdelim(text, &room, '\0', file);
    if (size < 0 && !feof(file))
        st = status_fail(why, STATUS_FILE, "%s: cannot be read", path);
    else if (size < 0)
        st = status_fail(why, STATUS_INPUT, "%s: no rows", path);
    else if (strlen(*text) != (size_t)size)
        st = status_fail(why, STATUS_INPUT, "%s: not a text file", path);
    fclose(file);
    return st;
}

/* Cuts a line at its commas in place; cells beyond `room` are counted, not stored. */
static int split(char *line, char **cell, int room)
{
    int count = 0;
    for (char *at = line; at; count++) {
        char *comma = strchr(at, ',');
        if (comma)
            *comma = 0;
        if (count < room)
            cell[count] = at;
        at = comma ? comma + 1 : NULL;
    }
    return count;
}

static const char *cell_fault(const char *cell)
{
    size_t n = strlen(cell);
    if (strchr(cell, '"'))
        return "quotes are not part of the format";
    if (n && (strchr(" \t", cell[0]) || strchr(" \t", cell[n - 1])))
        return "blanks around a cell";
    return NULL;
}

static const char *names_fault(char **name, int columns)
{
    for (int i = 0; i < columns; i++) {
        if (!*name[i])
            return "a column without a name";
        for (int j = 0; j < i; j++)
            if (!strcmp(name[i], name[j]))
                return "two columns of one name";
    }
    return NULL;
}

/* Adds a row, which stands in this line of the file. NULL without memory. */
static char **add_row(struct reference *t, int line)
{
    const size_t rows = (size_t)t->rows + 1;
    int *lines = realloc(t->line, rows * sizeof *lines);

    if (!lines)
        return NULL;
    t->line = lines, lines[t->rows] = line;
    char **cells = realloc(t->cell, rows * (size_t)t->columns * sizeof *cells);
    if (!cells)
        return NULL;
    t->cell = cells;
    return cells + (size_t)t->rows++ * (size_t)t->columns;
}

/* Takes a line; returns NULL, or what is wrong with it. */
static const char *take_line(struct reference *t, char *line, int number)
{
    char **cell = NULL;
    const char *fault = NULL;
    int count;

    if (!*line)
        return "a blank line";
    if (*line == '#') {
        t->comment[t->comments++] = line + 1;
        return NULL;
    }
    if (!t->columns) {
        t->columns = 1, t->head = number;
        for (const char *at = line; (at = strchr(at, ',')); at++)
            t->columns++;
        t->name = cell = calloc(t->columns, sizeof *cell);
    } else {
        cell = add_row(t, number);
    }
    if (!cell)
        return NO_MEMORY;
    count = split(line, cell, t->columns);
    if (count != t->columns)
        return count < t->columns ? "too few cells" : "too many cells";
    for (int i = 0; i < count && !fault; i++)
        fault = cell_fault(cell[i]);
    return fault || cell != t->name ? fault : names_fault(t->name, t->columns);
}

static enum status parse(struct reference *t, const char *path, struct message *why)
{
    char *next = t->text;
    int line = 1;

    for (const char *at = t->text; (at = strchr(at, '\n')); at++)
        t->comments++;
    t->comment = calloc(t->comments + 1, sizeof *t->comment);
    if (!t->comment)
        return STATUS_MEMORY;
    t->comments = 0;
    for (; *next; line++) {
        char *end = strchr(next, '\n');
        const char *fault = end ? NULL : "the last line has no end: cut short?";
        if (end) {
            *end = 0;
            if (end > next && end[-1] == '\r')
                end[-1] = 0;
            fault = take_line(t, next, line);
        }
        if (fault)
            return status_fail(why, fault == NO_MEMORY ? STATUS_MEMORY : STATUS_INPUT,
                               "%s:%d: %s", path, line, fault);
        next = end + 1;
    }
    if (!t->rows)
        return status_fail(why, STATUS_INPUT, "%s: no rows", path);
    return STATUS_OK;
}

void reference_close(struct reference *t)
{
    if (!t)
        return;
    free(t->path);
    free(t->fault);
    free(t->line);
    free(t->text);
    free(t->comment);
    free(t->name);
    free(t->cell);
    free(t);
}

enum status reference_open(const char *path, struct reference **table, struct message *why)
{
    enum status st;
    struct reference *t = calloc(1, sizeof *t);

    if (!t)
        return STATUS_MEMORY;
    t->path = strdup(path);
    t->fault = calloc(1, sizeof *t->fault);
    TRY(t->path && t->fault ? STATUS_OK : STATUS_MEMORY);
    TRY(slurp(path, &t->text, why));
    TRY(parse(t, path, why));
    *table = t, t = NULL;
out:
    reference_close(t);
    return st;
}

int reference_rows(const struct reference *t)
{
    return t->rows;
}

int reference_column(const struct reference *t, const char *name)
{
    for (int i = 0; i < t->columns; i++)
        if (!strcmp(t->name[i], name))
            return i;
    return -1;
}

/* Notes the first wrong query: the others mostly follow from it. */
__attribute__((format(printf, 3, 4))) static void blame(const struct reference *t, int line,
                                                        const char *format, ...)
{
    struct message what;
    va_list words;

    va_start(words, format);
    vsnprintf(what.text, sizeof what.text, format, words);
    va_end(words);
    if (!*t->fault->text)
        status_fail(t->fault, STATUS_INPUT, "%s:%d: %.200s", t->path, line, what.text);
}

enum status reference_fault(const struct reference *t, struct message *why)
{
    return *t->fault->text ? status_fail(why, STATUS_INPUT, "%s", t->fault->text)
                           : STATUS_OK;
}

const char *reference_text(const struct reference *t, int row, const char *column)
{
    const int c = reference_column(t, column);

    if (c < 0)
        blame(t, t->head, "there is no column '%s'", column);
    else if (row < 0 || row >= t->rows)
        blame(t, t->line[t->rows - 1], "the last of %d rows, but there should be a row %d",
              t->rows, row + 1);
    else
        return t->cell[(size_t)row * (size_t)t->columns + (size_t)c];
    return "";
}

double reference_number(const struct reference *t, int row, const char *column)
{
    const char *text = reference_text(t, row, column);
    char *end = NULL;
    double number = NAN;

    if (!*text)
        return NAN;
    if (!text[strspn(text, "+-.0123456789eE")])
        number = strtod(text, &end);
    if (end && !*end && isfinite(number))
        return number;
    blame(t, t->line[row], "%s is '%.40s', but must be a number", column, text);
    return NAN;
}

int reference_find(const struct reference *t, int from, const char *column,
                   const char *text)
{
    for (int row = from < 0 ? 0 : from; row < t->rows; row++)
        if (!strcmp(reference_text(t, row, column), text))
            return row;
    return -1;
}

const char *reference_note(const struct reference *t, const char *key)
{
    const size_t n = strlen(key);
    for (int i = 0; i < t->comments; i++) {
        const char *at = t->comment[i] + strspn(t->comment[i], " \t");
        if (!strncmp(at, key, n) && at[n] == ':')
            return at + n + 1 + strspn(at + n + 1, " \t");
    }
    return NULL;
}

double reference_note_number(const struct reference *t, const char *key)
{
    const char *text = reference_note(t, key);
    char *end = NULL;
    const double number = text ? strtod(text, &end) : NAN;

    return end == text ? NAN : number;
}

/* --- By name --- */

static const struct named_file_kind kind = {
    .what = "reference table",
    .ending = ".csv",
    .environment = "CLOTHBENCH_REFERENCE",
    .from_program = REFERENCE_FROM_PROGRAM,
    .in_source = REFERENCE_IN_SOURCE,
};

enum status reference_path(const char *name, char **path, struct message *why)
{
    return named_file_find(&kind, name, path, why);
}

enum status reference_open_named(const char *name, struct reference **table,
                                 struct message *why)
{
    enum status st;
    char *path = NULL;

    TRY(reference_path(name, &path, why));
    TRY(reference_open(path, table, why));
out:
    free(path);
    return st;
}
