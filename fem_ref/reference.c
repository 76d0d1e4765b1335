#include "fem_ref/reference.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "models/reader/input_file.h"
#include "models/reader/named_file.h"

/* A line of cells, each with a NUL at its end, one behind the other. */
struct line {
    char *cells;
    int number; /* in the file                                                          */
};

/* Lines and comments point into the text of the whole file, and have room for all of it. */
struct reference {
    char *path, *text;
    char **comment; /* [comments] without the #                                         */
    struct line names, *row; /* [rows]                                                  */
    int comments, columns, rows;
    struct message *fault; /* of the first wrong query; ""                              */
};

/* Reads up to the first byte 0, which no table has. */
static enum status slurp(const char *path, char **text, struct message *why)
{
    const char *reason;
    FILE *file = input_file_open(path, &reason);
    size_t room = 0;
    enum status st = STATUS_OK;

    if (!file)
        return status_fail(why, STATUS_FILE, "%s: %s", path, reason);
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

static const char *next_cell(const char *cell)
{
    return cell + strlen(cell) + 1;
}

/* Cuts a line at its commas in place; returns how many cells it has. */
static int split(char *line)
{
    int count = 1;

    for (; (line = strchr(line, ',')); count++)
        *line++ = '\0';
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

static const char *names_fault(const struct reference *t)
{
    const char *name = t->names.cells;

    for (int i = 0; i < t->columns; i++, name = next_cell(name)) {
        if (!*name)
            return "a column without a name";
        if (reference_column(t, name) < i)
            return "two columns of one name";
    }
    return NULL;
}

/* Takes a line; returns NULL, or what is wrong with it. */
static const char *take_line(struct reference *t, char *text, int number)
{
    const struct line line = {text, number};
    const char *fault = NULL, *cell = text;
    const bool names = !t->columns;

    if (!*text)
        return "a blank line";
    if (*text == '#') {
        t->comment[t->comments++] = text + 1;
        return NULL;
    }
    const int count = split(text);
    if (names)
        t->names = line, t->columns = count;
    else
        t->row[t->rows++] = line;
    if (count != t->columns)
        return count < t->columns ? "too few cells" : "too many cells";
    for (int i = 0; i < count && !fault; i++, cell = next_cell(cell))
        fault = cell_fault(cell);
    return fault || !names ? fault : names_fault(t);
}

static enum status parse(struct reference *t, const char *path, struct message *why)
{
    char *next = t->text;
    size_t lines = 1;
    int line = 1;

    for (const char *at = t->text; (at = strchr(at, '\n')); at++)
        lines++;
    t->comment = calloc(lines, sizeof *t->comment);
    t->row = calloc(lines, sizeof *t->row);
    if (!t->comment || !t->row)
        return STATUS_MEMORY;
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
            return status_fail(why, STATUS_INPUT, "%s:%d: %s", path, line, fault);
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
    free(t->text);
    free(t->comment);
    free(t->row);
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
    const char *own = t->names.cells;

    for (int i = 0; i < t->columns; i++, own = next_cell(own))
        if (!strcmp(own, name))
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
    const char *cell;

    if (c < 0) {
        blame(t, t->names.number, "there is no column '%s'", column);
        return "";
    }
    if (row < 0 || row >= t->rows) {
        blame(t, t->row[t->rows - 1].number,
              "the last of %d rows, but there should be a row %d", t->rows, row + 1);
        return "";
    }
    cell = t->row[row].cells;
    for (int i = 0; i < c; i++)
        cell = next_cell(cell);
    return cell;
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
    blame(t, t->row[row].number, "%s is '%.40s', but must be a number", column, text);
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
