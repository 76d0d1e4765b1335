#include "bench/files/matrix_market.h"

#include <assert.h>
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/output.h"

static const char banner[] = "%%MatrixMarket matrix coordinate real symmetric";

/* Each line of the comment behind a %. */
static void print_comment(struct output *out, const char *comment)
{
    while (comment && *comment) {
        int length = (int)strcspn(comment, "\n");
        output_print(out, "%% %.*s\n", length, comment);
        comment += length + (comment[length] == '\n');
    }
}

enum status matrix_market_write(const char *path, const struct matrix *m,
                                const char *comment, struct message *why)
{
    enum status st = STATUS_OK;
    struct output *out = NULL;

    TRY(output_create(path, &out, why));
    output_print(out, "%s\n", banner);
    print_comment(out, comment);
    output_print(out, "%d %d %ld\n", m->rows, m->rows, m->entries);
    for (long n = 0; n < m->entries; n++) {
        assert(m->row[n] >= m->column[n]);
        output_print(out, "%d %d %.17g\n", m->row[n] + 1, m->column[n] + 1, m->value[n]);
    }
    st = output_close(out, why);
    out = NULL;
out:
    output_discard(out);
    return st;
}

struct source {
    const char *path;
    FILE *file;
    long line;
    char text[1100]; /* the format allows lines of 1024 characters */
};

static enum status refuse(const struct source *s, const char *what, struct message *why)
{
    return status_fail(why, STATUS_INPUT, "%s:%ld: %s", s->path, s->line, what);
}

/* Next line that is no comment and not blank, into s->text. */
static enum status next_line(struct source *s, struct message *why)
{
    do {
        s->line++;
        if (!fgets(s->text, sizeof s->text, s->file))
            return refuse(s, "the file ends too early", why);
    } while (s->text[0] == '%' || s->text[strspn(s->text, " \t\r\n")] == '\0');
    return STATUS_OK;
}

static enum status read_size(struct source *s, struct matrix *m, struct message *why)
{
    long rows, columns, entries;
    enum status st = STATUS_OK;

    s->line = 1;
    if (!fgets(s->text, sizeof s->text, s->file) ||
        strncmp(s->text, banner, sizeof banner - 1) != 0)
        return refuse(s, "does not begin with the banner of a real symmetric matrix", why);
    TRY(next_line(s, why));
    if (sscanf(s->text, "%ld %ld %ld", &rows, &columns, &entries) != 3 || rows < 1 ||
        rows > INT_MAX || rows != columns || entries < 0 || entries > rows * (rows + 1) / 2)
        return refuse(s, "is not `rows columns entries` of a symmetric matrix", why);
    m->rows = (int)rows;
    m->entries = entries;
out:
    return st;
}

static enum status read_entry(struct source *s, struct matrix *m, long n,
                              struct message *why)
{
    enum status st = STATUS_OK;
    char *rest = NULL;

    TRY(next_line(s, why));
    long row = strtol(s->text, &rest, 10), column = strtol(rest, &rest, 10);
    char *end = rest;
    m->value[n] = strtod(rest, &end);
    if (end == rest || column < 1 || row < column || row > m->rows)
        return refuse(s, "is not `row column value` of the lower triangle", why);
    m->row[n] = (int)row - 1;
    m->column[n] = (int)column - 1;
out:
    return st;
}

enum status matrix_market_read(const char *path, struct matrix *m, struct message *why)
{
    enum status st = STATUS_OK;
    struct source s = {.path = path, .file = fopen(path, "r")};

    *m = (struct matrix){0};
    if (!s.file)
        return status_fail(why, STATUS_FILE, "%s: cannot be read: %s", path,
                           strerror(errno));
    TRY(read_size(&s, m, why));
    size_t room = (size_t)m->entries + 1; /* never zero */
    m->row = malloc(room * sizeof *m->row);
    m->column = malloc(room * sizeof *m->column);
    m->value = malloc(room * sizeof *m->value);
    if (!m->row || !m->column || !m->value)
        TRY(STATUS_MEMORY);
    for (long n = 0; n < m->entries; n++)
        TRY(read_entry(&s, m, n, why));
out:
    fclose(s.file);
    if (st != STATUS_OK)
        matrix_clear(m);
    return st;
}
