/* Reads lines t,u,v,x,y,z; also with semicolons between numbers that have decimal commas.
 * A first pass over the times finds runs of rows of one time,
 * which alone stay in memory; the runs of a frame are then read wherever they stand. */
#define _DEFAULT_SOURCE /* strsep */
#include "bench/frames/frames_reader.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { T, U, V, X, Y, Z, COLUMNS };
static const char names[] = "tuvxyz";

/* uv within this are the same: texts of them may be rounded. */
#define SAME_UV 1e-7

struct run { /* rows of one time, one after another */
    double t;
    long long at; /* where the first begins [bytes]                                      */
    long line;    /* its number                                                          */
    long rows;
};

struct key { /* a vertex by its uv, rounded */
    long long u, v;
    int vertex;
};

struct csv {
    struct frames_file file;
    bool semicolons;   /* stand between the cells, and numbers may have decimal commas   */
    int cell[COLUMNS]; /* which one of a line each is, from 0                            */
    int cells;         /* of a line at most                                             */
    int runs;
    struct run *run;     /* [runs] by time, then place                                  */
    int taken;           /* runs of the frames before                                   */
    struct key *key;     /* [vertices] sorted                                           */
    char *seen;          /* [vertices] in this frame                                    */
    struct arena *arena; /* of these                                           borrowed */
};

static void close_csv(void *state)
{
    struct csv *c = state;

    frames_file_close(&c->file);
}

/* Reads lines up to the next that is neither blank nor a comment (strchr finds the end of a
 * text, too). */
static enum status next_line(struct csv *c, bool *more, struct message *why)
{
    do {
        CALL(frames_file_line(&c->file, more, why));
        if (!*more)
            break;
    } while (strchr("#", c->file.text[strspn(c->file.text, " \t")]));
    c->semicolons = c->semicolons || (*more && !c->runs && strchr(c->file.text, ';'));
    for (char *p = c->file.text; *more && c->semicolons && *p; p++)
        *p = (char)(*p == ',' ? '.' : *p == ';' ? ',' : *p);
    return STATUS_OK;
}

/* Reads one cell of the line as a number. */
static bool take_number(const struct csv *c, int column, double *x)
{
    char *at = c->file.text;

    for (int cell = 0; cell < c->cell[column]; cell++) {
        at = strchr(at, ',');
        if (!at)
            return false;
        at++;
    }
    if (!frames_file_number(&at, x))
        return false;
    at += strspn(at, " \t");
    return *at == ',' || *at == '\0';
}

static enum status bad_row(const struct csv *c, struct message *why)
{
    return status_fail(why, STATUS_INPUT,
                       "%s: line %ld: is no row of numbers; t,u,v,x,y,z would be right",
                       c->file.path, c->file.line);
}

/* Counts the cells of the line up to the last that has anything. */
static int count_cells(const struct csv *c)
{
    int cells = 1, last = 1;

    for (const char *at = c->file.text; *at; at++)
        if (*at == ',')
            cells++;
        else if (*at != ' ' && *at != '\t')
            last = cells;
    return last;
}

/* Finds the columns in the first line; *named: it is one of names, not a row. */
static enum status take_names(struct csv *c, bool *named, struct message *why)
{
    char *text = c->file.text, *word;
    double t;

    for (int n = 0; n < COLUMNS; n++)
        c->cell[n] = n;
    *named = !take_number(c, T, &t);
    c->cells = *named ? count_cells(c) : COLUMNS;
    if (!*named)
        return STATUS_OK;
    memset(c->cell, -1, sizeof c->cell);
    for (int cell = 0; (word = strsep(&text, ",")); cell++) {
        word += strspn(word, " \"");
        const size_t size = strcspn(word, " \"");
        const char *name = size == 1 ? strchr(names, *word | 32) : NULL;
        if (name && c->cell[name - names] < 0 && !word[size + strspn(word + size, " \"")])
            c->cell[name - names] = cell;
    }
    for (int n = 0; n < COLUMNS; n++)
        if (c->cell[n] < 0)
            return status_fail(why, STATUS_INPUT,
                               "%s: line %ld: names no column %c; t,u,v,x,y,z would be "
                               "right",
                               c->file.path, c->file.line, names[n]);
    return STATUS_OK;
}

static enum status take_time(struct csv *c, struct message *why)
{
    struct run *last = c->runs ? &c->run[c->runs - 1] : NULL;
    const int cells = count_cells(c);
    double t;

    if (cells > c->cells)
        return status_fail(why, STATUS_INPUT,
                           "%s: line %ld: has %d cells in %d columns; decimals after a "
                           "point, or semicolons between the columns, would be right",
                           c->file.path, c->file.line, cells, c->cells);
    if (!take_number(c, T, &t) || !isfinite(t))
        return bad_row(c, why);
    if (last && last->t == t) {
        last->rows++;
        return STATUS_OK;
    }
    c->run = arena_more(c->arena, c->run, (size_t)c->runs, sizeof *c->run);
    c->run[c->runs++] = (struct run){t, c->file.at, c->file.line, 1};
    return STATUS_OK;
}

static int compare_runs(const void *a, const void *b)
{
    const struct run *left = a, *right = b;

    if (left->t != right->t)
        return left->t > right->t ? 1 : -1;
    return (left->at > right->at) - (left->at < right->at);
}

/* Finds all runs, and counts the frames. */
static enum status find_runs(struct frames *f, struct csv *c, struct message *why)
{
    bool more, named = false;

    CALL(next_line(c, &more, why));
    if (more)
        CALL(take_names(c, &named, why));
    if (named)
        CALL(next_line(c, &more, why));
    while (more) {
        CALL(take_time(c, why));
        CALL(next_line(c, &more, why));
    }
    if (!c->runs)
        return status_fail(why, STATUS_INPUT,
                           "%s: has no rows; lines t,u,v,x,y,z would be right", f->path);
    qsort(c->run, (size_t)c->runs, sizeof *c->run, compare_runs);
    for (int n = 0; n < c->runs; n++)
        f->count += n == 0 || c->run[n].t != c->run[n - 1].t;
    return STATUS_OK;
}

static struct key key_of(double u, double v, int vertex)
{
    const double most = 1e9; /* far out of 0 to 1, and llround's range */

    return (struct key){llround(fmax(-most, fmin(most, u)) / SAME_UV),
                        llround(fmax(-most, fmin(most, v)) / SAME_UV), vertex};
}

static int compare_keys(const void *a, const void *b)
{
    const struct key *left = a, *right = b;

    if (left->u != right->u)
        return left->u > right->u ? 1 : -1;
    return (left->v > right->v) - (left->v < right->v);
}

/* Returns the vertex that a row belongs to, mostly the next one; -1: none. */
static int vertex_of(const struct frames *f, const struct csv *c, const double *row,
                     long next)
{
    const struct key key = key_of(row[U], row[V], 0), *found;

    if (next < f->net.vertices && f->net.uv[2 * next] == row[U] &&
        f->net.uv[2 * next + 1] == row[V])
        return (int)next;
    found = bsearch(&key, c->key, (size_t)f->net.vertices, sizeof key, compare_keys);
    return found ? found->vertex : -1;
}

/* Takes the n-th row of the first frame as a vertex of the net, or of any as its place. */
static enum status take_row(struct frames *f, bool net, long n, struct message *why)
{
    struct csv *c = f->state;
    double row[COLUMNS];

    for (int k = 0; k < COLUMNS; k++)
        if (!take_number(c, k, &row[k]))
            return bad_row(c, why);
    if (net) {
        f->net.uv[2 * n] = row[U], f->net.uv[2 * n + 1] = row[V];
        c->key[n] = key_of(row[U], row[V], (int)n);
        return STATUS_OK;
    }
    const int vertex = vertex_of(f, c, row, n);
    if (vertex < 0)
        return status_fail(why, STATUS_INPUT,
                           "%s: line %ld: frame %d (t = %g s) has a vertex at u = %.9g, "
                           "v = %.9g that the first frame has not; its %d vertices would "
                           "be right",
                           f->path, c->file.line, f->number, row[T], row[U], row[V],
                           f->net.vertices);
    if (c->seen[vertex])
        return status_fail(why, STATUS_INPUT,
                           "%s: line %ld: frame %d (t = %g s) has the vertex u = %.9g, v = "
                           "%.9g twice; once would be right",
                           f->path, c->file.line, f->number, row[T], row[U], row[V]);
    c->seen[vertex] = 1;
    memcpy(f->xyz + 3L * vertex, row + X, 3 * sizeof *row);
    return STATUS_OK;
}

/* Takes all rows of the frame whose first run is the first of `run`; *count: how many. */
static enum status take_frame(struct frames *f, const struct run *run, bool net,
                              long *count, struct message *why)
{
    struct csv *c = f->state;
    const double t = run->t;
    bool more;

    *count = 0;
    for (; run < c->run + c->runs && run->t == t; run++) {
        frames_file_go(&c->file, run->at, run->line);
        for (long n = 0; n < run->rows; n++) {
            CALL(next_line(c, &more, why));
            CALL(more ? take_row(f, net, (*count)++, why) : bad_row(c, why));
        }
    }
    return STATUS_OK;
}

static enum status next_csv(struct frames *f, double *t, struct message *why)
{
    struct csv *c = f->state;
    long count;

    *t = c->run[c->taken].t;
    memset(c->seen, 0, (size_t)f->net.vertices);
    CALL(take_frame(f, &c->run[c->taken], false, &count, why));
    if (count != f->net.vertices)
        return status_fail(why, STATUS_INPUT,
                           "%s: line %ld: frame %d (t = %g s) has %ld vertices, the first "
                           "frame %d; the same would be right",
                           f->path, c->file.line, f->number, *t, count, f->net.vertices);
    while (c->taken < c->runs && c->run[c->taken].t == *t)
        c->taken++;
    return STATUS_OK;
}

/* Takes the vertices from the first frame, in its order. */
static enum status take_net(struct frames *f, struct csv *c, struct message *why)
{
    long count = 0;

    for (int n = 0; n < c->runs && c->run[n].t == c->run->t; n++)
        count += c->run[n].rows;
    CALL(frames_room(f, count, why));
    f->net.uv = arena_take(c->arena, (size_t)count, 2 * sizeof *f->net.uv);
    c->key = arena_take(c->arena, (size_t)count, sizeof *c->key);
    c->seen = arena_take(c->arena, (size_t)count, 1);
    CALL(take_frame(f, c->run, true, &count, why));
    qsort(c->key, (size_t)count, sizeof *c->key, compare_keys);
    return STATUS_OK;
}

static enum status open_csv(struct frames *f, struct message *why)
{
    struct csv *c = f->state;

    f->timed = true;
    c->arena = &f->arena;
    CALL(frames_file_open(f->path, &c->file, why));
    CALL(find_runs(f, c, why));
    return take_net(f, c, why);
}

const struct frames_reader frames_csv = {sizeof(struct csv), open_csv, next_csv, close_csv};
