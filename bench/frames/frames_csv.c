/* Reads lines t,u,v,x,y,z. A first pass over the times finds whether rows of one time stand
 * together and times grow: then lines are read as they come; else in the order of an index,
 * which alone is kept in memory. */
#include "bench/frames/frames_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { T, U, V, X, Y, Z, COLUMNS, COLUMNS_MOST = 64 };
static const char names[] = "tuvxyz";

/* uv within this are the same: texts of them may be rounded. */
#define SAME_UV 1e-7

struct place { /* of a row */
    double t;
    const char *at;
    long line;
};

struct key { /* a vertex by its uv, rounded */
    long long u, v;
    int vertex;
};

struct csv {
    struct frames_bytes bytes;
    int column[COLUMNS_MOST]; /* meaning of each cell, -1: ignored                    */
    int time_cell, width;     /* the time's cell; how many are read                   */
    struct frames_text text;  /* begins at the first row                                */
    struct place *place;      /* [rows] sorted; NULL: rows are in order          owned */
    long rows, taken;         /* taken: of `place`                                       */
    struct key *key;          /* [vertices] sorted                               owned */
    char *seen;               /* [vertices] in this frame                        owned */
};

static void close_csv(void *state)
{
    struct csv *c = state;

    frames_bytes_close(&c->bytes);
    free(c->place);
    free(c->key);
    free(c->seen);
    free(c);
}

/* Whether a line is blank or a comment. */
static bool is_empty(const char *line, const char *end)
{
    while (line < end && (*line == ' ' || *line == '\t'))
        line++;
    return line == end || *line == '#';
}

/* Finds the columns in a line of names; false: it is a line of numbers. */
static bool take_names(struct csv *c, const char *line, const char *end)
{
    bool any = false;

    for (int cell = 0; cell < COLUMNS_MOST; cell++)
        c->column[cell] = -1;
    for (int cell = 0; line <= end && cell < COLUMNS_MOST; cell++) {
        const char *stop = memchr(line, ',', (size_t)(end - line)), *from = line;
        line = stop ? stop : end;
        const char *till = line;
        while (from < till && (*from == ' ' || *from == '"'))
            from++;
        while (till > from && (till[-1] == ' ' || till[-1] == '"'))
            till--;
        any = any || (from < till && strchr("abcdefghijklmnopqrstuvwxyz", *from | 32));
        const char *name = till == from + 1 ? strchr(names, *from | 32) : NULL;
        if (name)
            c->column[cell] = (int)(name - names);
        line++;
    }
    for (int n = 0; !any && n < COLUMNS; n++)
        c->column[n] = n;
    return any;
}

static enum status take_header(struct frames *f, struct csv *c, struct message *why)
{
    struct frames_text text = frames_text_of(&c->bytes);
    const char *line, *end;

    for (c->text = text; frames_text_line(&text, &line, &end); c->text = text)
        if (!is_empty(line, end)) {
            if (take_names(c, line, end))
                c->text = text;
            break;
        }
    for (int n = 0; n < COLUMNS; n++) {
        int cell = 0;
        while (cell < COLUMNS_MOST && c->column[cell] != n)
            cell++;
        if (cell == COLUMNS_MOST)
            return status_fail(why, STATUS_INPUT,
                               "%s: line %ld: names no column %c; t,u,v,x,y,z would be "
                               "right",
                               f->path, c->text.line, names[n]);
        c->time_cell = n == T ? cell : c->time_cell;
        c->width = cell >= c->width ? cell + 1 : c->width;
    }
    return STATUS_OK;
}

/* Reads the first `cells` cells of a line as numbers. */
static bool take_row(const struct csv *c, const char *line, const char *end, int cells,
                     double row[COLUMNS])
{
    for (int cell = 0; cell < cells; cell++) {
        if (line > end)
            return false;
        const char *comma = memchr(line, ',', (size_t)(end - line)),
                   *stop = comma ? comma : end;
        if (c->column[cell] >= 0) {
            if (!frames_text_number(&line, stop, &row[c->column[cell]]))
                return false;
            while (line < stop && (*line == ' ' || *line == '\t'))
                line++;
            if (line < stop)
                return false;
        }
        line = stop + 1;
    }
    return true;
}

static enum status bad_row(const struct frames *f, long line, struct message *why)
{
    return status_fail(why, STATUS_INPUT,
                       "%s: line %ld: is no row of numbers; t,u,v,x,y,z would be right",
                       f->path, line);
}

static int compare_places(const void *a, const void *b)
{
    const struct place *left = a, *right = b;

    if (left->t != right->t)
        return left->t > right->t ? 1 : -1;
    return (left->at > right->at) - (left->at < right->at);
}

/* Counts rows; *grow: the times never fall. */
static enum status look_at_times(struct frames *f, struct csv *c, bool *grow,
                                 struct message *why)
{
    struct frames_text text = c->text;
    const char *line, *end;
    double row[COLUMNS] = {0}, last = -INFINITY;

    *grow = true;
    for (c->rows = 0; frames_text_line(&text, &line, &end);) {
        if (is_empty(line, end))
            continue;
        if (!take_row(c, line, end, c->time_cell + 1, row) || !isfinite(row[T]))
            return bad_row(f, text.line, why);
        *grow = *grow && row[T] >= last;
        last = row[T];
        c->rows++;
        frames_bytes_forget(&c->bytes, (size_t)(line - (const char *)c->bytes.byte));
    }
    c->bytes.forgotten = 0;
    return c->rows
               ? STATUS_OK
               : status_fail(why, STATUS_INPUT,
                             "%s: has no rows; lines t,u,v,x,y,z would be right", f->path);
}

static enum status make_index(struct csv *c)
{
    struct frames_text text = c->text;
    const char *line, *end;
    double row[COLUMNS] = {0};

    c->place = malloc((size_t)c->rows * sizeof *c->place);
    if (!c->place)
        return STATUS_MEMORY;
    for (long n = 0; n < c->rows && frames_text_line(&text, &line, &end);)
        if (!is_empty(line, end)) {
            take_row(c, line, end, c->time_cell + 1, row);
            c->place[n++] = (struct place){row[T], line, text.line};
        }
    qsort(c->place, (size_t)c->rows, sizeof *c->place, compare_places);
    return STATUS_OK;
}

/* Reads the next row, if it belongs to the frame's time (or begins one: NaN). */
static enum status next_row(struct frames *f, struct csv *c, double t, double row[COLUMNS],
                            bool *more, long *number, struct message *why)
{
    struct frames_text text = c->text;
    const char *line = NULL, *end;

    *more = false;
    if (c->place) {
        if (c->taken == c->rows)
            return STATUS_OK;
        text.at = c->place[c->taken].at;
        text.line = c->place[c->taken].line - 1;
    }
    do
        if (!frames_text_line(&text, &line, &end))
            return STATUS_OK;
    while (is_empty(line, end));
    if (!take_row(c, line, end, c->width, row))
        return bad_row(f, text.line, why);
    if (!isnan(t) && row[T] != t)
        return STATUS_OK;
    c->taken++;
    c->text = text;
    *more = true;
    *number = text.line;
    return STATUS_OK;
}

static struct key key_of(const double row[COLUMNS], int vertex)
{
    const double most = 1e9; /* far out of 0 to 1, and llround's range */

    return (struct key){llround(fmax(-most, fmin(most, row[U])) / SAME_UV),
                        llround(fmax(-most, fmin(most, row[V])) / SAME_UV), vertex};
}

static int compare_keys(const void *a, const void *b)
{
    const struct key *left = a, *right = b;

    if (left->u != right->u)
        return left->u > right->u ? 1 : -1;
    return (left->v > right->v) - (left->v < right->v);
}

/* Takes the vertices from the first frame, in its order. */
static enum status take_net(struct frames *f, struct csv *c, struct message *why)
{
    const struct frames_text start = c->text;
    int room = 0, rows = 0;
    long count = 0, line;
    double row[COLUMNS], t = NAN, *uv;
    bool more;
    enum status st;

    for (;; count++, t = row[T]) {
        TRY(next_row(f, c, t, row, &more, &line, why));
        if (!more)
            break;
        if (count == FRAMES_MOST_VERTICES)
            break;
        uv = frames_bytes_grow(f->net.uv, &room, rows, 2 * sizeof *uv);
        TRY(uv ? STATUS_OK : STATUS_MEMORY);
        f->net.uv = uv;
        uv[2 * rows] = row[U], uv[2 * rows + 1] = row[V];
        rows++;
    }
    TRY(frames_room(f, count + (count == FRAMES_MOST_VERTICES), why));
    c->key = malloc((size_t)count * sizeof *c->key);
    c->seen = malloc((size_t)count);
    TRY(c->key && c->seen ? STATUS_OK : STATUS_MEMORY);
    for (int n = 0; n < rows; n++)
        c->key[n] =
            key_of((double[]){0, f->net.uv[2 * n], f->net.uv[2 * n + 1], 0, 0, 0}, n);
    qsort(c->key, (size_t)rows, sizeof *c->key, compare_keys);
    c->text = start;
    c->taken = 0;
out:
    return st;
}

/* Returns the vertex that a row belongs to, mostly the next one; -1: none. */
static int vertex_of(const struct frames *f, const struct csv *c, const double *row,
                     int next)
{
    const struct key key = key_of(row, 0), *found;

    if (next < f->net.vertices && f->net.uv[2 * next] == row[U] &&
        f->net.uv[2 * next + 1] == row[V])
        return next;
    found = bsearch(&key, c->key, (size_t)f->net.vertices, sizeof key, compare_keys);
    return found ? found->vertex : -1;
}

static enum status next_csv(struct frames *f, double *t, bool *more, struct message *why)
{
    struct csv *c = f->state;
    double row[COLUMNS], time = NAN;
    long line = 0;
    int count = 0;
    bool any;
    enum status st;

    memset(c->seen, 0, (size_t)f->net.vertices);
    for (;; count++, time = row[T]) {
        TRY(next_row(f, c, time, row, &any, &line, why));
        if (!any)
            break;
        const int n = vertex_of(f, c, row, count);
        if (n < 0)
            TRY(status_fail(why, STATUS_INPUT,
                            "%s: line %ld: frame %d (t = %g s) has a vertex at u = %.9g, "
                            "v = %.9g that the first frame has not; its %d vertices would "
                            "be right",
                            f->path, line, f->number, row[T], row[U], row[V],
                            f->net.vertices));
        if (c->seen[n])
            TRY(status_fail(
                why, STATUS_INPUT,
                "%s: line %ld: frame %d (t = %g s) has the vertex u = %.9g, v = "
                "%.9g twice; once would be right",
                f->path, line, f->number, row[T], row[U], row[V]));
        c->seen[n] = 1;
        memcpy(f->xyz + 3 * n, row + X, 3 * sizeof *row);
    }
    *more = count > 0;
    *t = time;
    if (count && count != f->net.vertices)
        TRY(status_fail(
            why, STATUS_INPUT,
            "%s: line %ld: frame %d (t = %g s) has %d vertices, the first frame "
            "%d; the same would be right",
            f->path, line, f->number, time, count, f->net.vertices));
    if (!c->place)
        frames_bytes_forget(&c->bytes, (size_t)(c->text.at - (const char *)c->bytes.byte));
out:
    return st;
}

enum status frames_csv_open(struct frames *f, const char *path, struct message *why)
{
    static const struct frames_reader reader = {next_csv, close_csv};
    struct csv *c = calloc(1, sizeof *c);
    bool grow;
    enum status st;

    if (!c)
        return STATUS_MEMORY;
    f->state = c;
    f->reader = &reader;
    f->timed = true;
    TRY(frames_bytes_open(path, &c->bytes, why));
    TRY(take_header(f, c, why));
    TRY(look_at_times(f, c, &grow, why));
    if (!grow)
        TRY(make_index(c));
    TRY(take_net(f, c, why));
out:
    return st;
}
