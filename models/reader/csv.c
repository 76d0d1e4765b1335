#include "models/reader/csv.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "models/reader/input_file.h"

enum { MOST = 64 << 20 }; /* bytes of a file */

/* The state of splitting a file into tables, in place. */
struct reader {
    const char *path;
    struct csv *csv;
    struct csv_table *table; /* NULL: between two                                  */
    char *at, *end;
    char *caption; /* of the table to come                                         */
    char *joined;  /* the end of the lines that are being joined                   */
    int line;
};

static enum status read_text(const char *path, char **text, size_t *size,
                             struct message *why)
{
    const char *reason;
    struct stat about;
    size_t room = 0;
    enum status st = STATUS_OK;

    if (lstat(path, &about) == 0 && S_ISLNK(about.st_mode))
        return status_fail(why, STATUS_FILE,
                           "%s: is a symbolic link, which is not followed", path);
    FILE *file = input_file_open(path, &reason);
    if (!file)
        return status_fail(why, STATUS_FILE, "%s: %s", path, reason);
    const ssize_t read = getdelim(text, &room, '\0', file);
    *size = read < 0 ? 0 : (size_t)read;
    if (read < 0 && !feof(file))
        TRY(status_fail(why, STATUS_FILE, "%s: %s", path, strerror(errno)));
    if (*size > MOST)
        TRY(status_fail(why, STATUS_INPUT, "%s: longer than 64 MB", path));
    if (*size && !(*text)[*size - 1])
        TRY(status_fail(why, STATUS_INPUT, "%s: has a byte 0 and is no text", path));
out:
    fclose(file);
    return st;
}

/* Appends a `# ` line to `text` as one more line; both are in the bytes, the new one behind
 * the old, so that it can be moved there. */
static char *join(struct reader *r, char *text, char *line)
{
    const size_t length = strlen(line);

    if (*text) {
        *r->joined++ = '\n';
        memmove(r->joined, line, length + 1);
    } else {
        r->joined = text = line;
    }
    r->joined += length;
    return text;
}

static void take_comment(struct reader *r)
{
    char *line = r->at + 1 + (r->at[1] == ' ');
    size_t length = strcspn(r->at, "\n");
    const bool last = !r->at[length];

    r->at[length] = '\0';
    line = line > r->at + length ? r->at + length : line;
    r->at += length + !last;
    r->line++;
    if (r->table)
        r->table->notes = join(r, r->table->notes, line);
    else
        r->caption = join(r, r->caption, line);
}

/* Takes the next cell, without its quotes, in place; *after is what ended it. False: a
 * quote is not closed, or stands beside other words. */
static bool take_cell(struct reader *r, char **cell, char *after)
{
    const bool quoted = *r->at == '"';
    char *to = r->at;

    *cell = to;
    for (r->at += quoted; *r->at; *to++ = *r->at++) {
        if (quoted && *r->at == '"' && *++r->at != '"')
            break;
        if (!quoted && (strchr(",\n\"", *r->at) || !strncmp(r->at, "\r\n", 2)))
            break;
        r->line += *r->at == '\n';
    }
    r->at += *r->at == '\r';
    *after = *r->at;
    const bool closed = !quoted || r->at[-1] == '"' || r->at[-2] == '"';
    r->at += *after != '\0';
    *to = '\0';
    return closed && (!*after || strchr(",\n", *after));
}

/* Gives an array room for one more; it doubles each time. */
static enum status more(void *array, size_t count, size_t size)
{
    if (count & (count - 1)) /* no power of two, nor 0 */
        return STATUS_OK;
    void *larger = realloc(*(void **)array, (count ? 2 * count : 1) * size);

    if (!larger)
        return STATUS_MEMORY;
    *(void **)array = larger;
    return STATUS_OK;
}

static enum status start_table(struct reader *r)
{
    struct csv *c = r->csv;

    if (more(&c->table, (size_t)c->count, sizeof *c->table) != STATUS_OK)
        return STATUS_MEMORY;
    r->table = &c->table[c->count++];
    *r->table = (struct csv_table){.caption = r->caption, .notes = r->end, .rows = -1};
    r->caption = r->end;
    return STATUS_OK;
}

/* Takes a line of cells; the first one of a table has its keys. */
static enum status take_row(struct reader *r, struct message *why)
{
    const int line = r->line;
    int count = 0;
    char *cell, after;
    enum status st = STATUS_OK;

    if (!r->table)
        TRY(start_table(r));
    struct csv_table *t = r->table;
    const bool keys = t->rows < 0;
    const size_t before = (size_t)(t->rows + 1) * (size_t)t->columns;
    do {
        if (!take_cell(r, &cell, &after))
            TRY(status_fail(why, STATUS_INPUT,
                            "%s:%d: a quote has no end, or words behind it", r->path,
                            line));
        if (keys || count < t->columns) {
            const size_t at = before + (size_t)count;
            TRY(more(&t->cell, at, sizeof *t->cell));
            t->cell[at] = cell;
        }
        count++;
    } while (after == ',');
    r->line++;
    t->columns = keys ? count : t->columns;
    if (count != t->columns)
        TRY(status_fail(why, STATUS_INPUT, "%s:%d: %d cells below %d keys", r->path, line,
                        count, t->columns));
    TRY(more(&t->line, (size_t)++t->rows, sizeof *t->line));
    t->line[t->rows] = line;
out:
    return st;
}

enum status csv_read(const char *path, struct csv *csv, struct message *why)
{
    struct reader r = {.path = path, .csv = csv, .line = 1};
    size_t size = 0;
    enum status st;

    *csv = (struct csv){0};
    TRY(read_text(path, &csv->text, &size, why));
    r.at = size ? csv->text : "";
    csv->whole = size && csv->text[size - 1] == '\n';
    r.caption = r.end = r.at + size;
    while (*r.at)
        if (*r.at == '\n') {
            r.table = NULL;
            r.at++, r.line++;
        } else if (*r.at == '#') {
            take_comment(&r);
        } else {
            TRY(take_row(&r, why));
        }
out:
    if (st != STATUS_OK)
        csv_clear(csv);
    return st;
}

void csv_clear(struct csv *csv)
{
    for (int n = 0; n < csv->count; n++) {
        free(csv->table[n].cell);
        free(csv->table[n].line);
    }
    free(csv->table);
    free(csv->text);
    *csv = (struct csv){0};
}

int csv_column(const struct csv_table *t, const char *key)
{
    for (int n = 0; n < t->columns; n++)
        if (!strcmp(t->cell[n], key))
            return n;
    return -1;
}

const char *csv_words(const struct csv_table *t, int row, int column)
{
    if (row < 0 || row >= t->rows || column < 0 || column >= t->columns)
        return "";
    return t->cell[(size_t)(row + 1) * (size_t)t->columns + (size_t)column];
}

double csv_number(const struct csv_table *t, int row, int column)
{
    const char *words = csv_words(t, row, column);
    char *end;
    const double number = strtod(words, &end);

    return end == words || *end ? NAN : number;
}

const char *csv_words_of(const struct csv_table *t, int row, const char *key)
{
    return csv_words(t, row, csv_column(t, key));
}

double csv_number_of(const struct csv_table *t, int row, const char *key)
{
    return csv_number(t, row, csv_column(t, key));
}
