#include "fem_ref/reference.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "models/reader/csv.h"
#include "models/reader/named_file.h"

struct reference {
    char *path;
    struct csv csv; /* of one table */
    const struct csv_table *table;
    size_t size[2]; /* of its caption and its notes, whose lines end with a NUL each    */
    struct message *fault; /* of the first wrong query; ""                              */
};

static const char *names_fault(const struct csv_table *t)
{
    for (int i = 0; i < t->columns; i++) {
        if (!*t->cell[i])
            return "a column without a name";
        if (csv_column(t, t->cell[i]) < i)
            return "two columns of one name";
    }
    return NULL;
}

/* Refuses what is no reference table: they were made by a program, and are whole. */
static enum status check(const struct csv *csv, const char *path, struct message *why)
{
    const struct csv_table *t = csv->table;

    if (!csv->count || !t->rows)
        return status_fail(why, STATUS_INPUT, "%s: no rows", path);
    if (csv->count > 1)
        return status_fail(why, STATUS_INPUT, "%s:%d: a blank line", path,
                           t[1].line[0] - 1);
    if (!csv->whole)
        return status_fail(why, STATUS_INPUT, "%s: the last line has no end: cut short?",
                           path);
    const char *fault = names_fault(t);
    if (fault)
        return status_fail(why, STATUS_INPUT, "%s:%d: %s", path, t->line[0], fault);
    for (int n = 0; n < (t->rows + 1) * t->columns; n++) {
        const size_t size = strlen(t->cell[n]);
        if (size && (strchr(" \t", t->cell[n][0]) || strchr(" \t", t->cell[n][size - 1])))
            return status_fail(why, STATUS_INPUT, "%s:%d: blanks around a cell", path,
                               t->line[n / t->columns]);
    }
    return STATUS_OK;
}

/* Ends each line with a NUL; returns the size of all. */
static size_t cut_lines(char *text)
{
    const size_t size = strlen(text);

    while ((text = strchr(text, '\n')))
        *text++ = '\0';
    return size;
}

void reference_close(struct reference *t)
{
    if (!t)
        return;
    csv_clear(&t->csv);
    free(t->path);
    free(t->fault);
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
    TRY(csv_read(path, &t->csv, why));
    TRY(check(&t->csv, path, why));
    t->table = t->csv.table;
    t->size[0] = cut_lines(t->table->caption);
    t->size[1] = cut_lines(t->table->notes);
    *table = t, t = NULL;
out:
    reference_close(t);
    return st;
}

int reference_rows(const struct reference *t)
{
    return t->table->rows;
}

int reference_column(const struct reference *t, const char *name)
{
    return csv_column(t->table, name);
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
    const int c = reference_column(t, column), rows = t->table->rows;

    if (c < 0)
        blame(t, t->table->line[0], "there is no column '%s'", column);
    else if (row < 0 || row >= rows)
        blame(t, t->table->line[rows], "the last of %d rows, but there should be a row %d",
              rows, row + 1);
    return csv_words(t->table, row, c);
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
    blame(t, t->table->line[row + 1], "%s is '%.40s', but must be a number", column, text);
    return NAN;
}

int reference_find(const struct reference *t, int from, const char *column,
                   const char *text)
{
    for (int row = from < 0 ? 0 : from; row < t->table->rows; row++)
        if (!strcmp(reference_text(t, row, column), text))
            return row;
    return -1;
}

const char *reference_note(const struct reference *t, const char *key)
{
    const char *const lines[] = {t->table->caption, t->table->notes};
    const size_t n = strlen(key);

    for (int i = 0; i < 2; i++)
        for (const char *at = lines[i]; at <= lines[i] + t->size[i]; at += strlen(at) + 1) {
            const char *word = at + strspn(at, " \t");
            if (!strncmp(word, key, n) && word[n] == ':')
                return word + n + 1 + strspn(word + n + 1, " \t");
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
