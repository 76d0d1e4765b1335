#include "models/reader/obj_file.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "models/reader/named_file.h"
#include "models/reader/yaml_tree.h"

enum { MOST_BYTES = 1 << 28, MOST_POINTS = 1 << 22, MOST_CORNERS = 6 * MOST_POINTS };
enum { MOST_GROUPS = 10000 };
static const char BLANKS[] = " \t\r";

static const struct named_file_kind kind = {.what = "mesh", .most = MOST_BYTES};

struct reading {
    struct yaml_tree line; /* to blame */
    struct obj_file *o;
    int group; /* of the faces that follow */
};

/* Makes room behind list[count] for one more item of `size` bytes, if there may be that
 * many; what is there has room up to the next power of two. */
static enum status grow(const struct reading *r, void **list, int count, int most,
                        size_t size, struct message *why)
{
    void *more = *list;

    if (count == most)
        return yaml_tree_refuse(
            &r->line, why, "more than %d points or corners; fewer would be right", most);
    if (!(count & (count - 1)))
        more = realloc(more, (count ? 2 * (size_t)count : 1) * size);
    *list = more ? more : *list;
    return more ? STATUS_OK : STATUS_MEMORY;
}
#define GROW(list, count, most) grow(r, (void **)&(list), count, most, sizeof *(list), why)

static enum status take_numbers(const struct reading *r, char *text, int count, double *x,
                                struct message *why)
{
    for (int i = 0; i < count; i++) {
        char *end = text;
        x[i] = strtod(text, &end);
        if (end == text || !strchr(BLANKS, *end) || !isfinite(x[i]))
            return yaml_tree_refuse(
                &r->line, why, "%s",
                count == 3 ? "a vertex needs three numbers, as in `v .5 .25 0`"
                           : "a texture point needs two numbers, as in `vt .5 .25`");
        text = end;
    }
    return STATUS_OK;
}

static enum status take_vertex(struct reading *r, char *text, struct message *why)
{
    struct obj_file *o = r->o;
    enum status st;

    TRY(GROW(o->vertex, o->vertices, MOST_POINTS));
    o->vertex[o->vertices].line = r->line.line;
    st = take_numbers(r, text, 3, o->vertex[o->vertices++].at, why);
out:
    return st;
}

static enum status take_texture(struct reading *r, char *text, struct message *why)
{
    struct obj_file *o = r->o;
    enum status st;

    TRY(GROW(o->texture, o->textures, MOST_POINTS));
    st = take_numbers(r, text, 2, o->texture[o->textures++], why);
out:
    return st;
}

static enum status refuse_corner(const struct reading *r, const char *word,
                                 struct message *why)
{
    return yaml_tree_refuse(&r->line, why,
                            "a face names the vertex %s, but there are %d `v` and %d `vt`; "
                            "`f 1 2 3` or `f 1/1 2/2 3/3` would be right",
                            yaml_tree_quote(word).text, r->o->vertices, r->o->textures);
}

/* Reads a number that counts from 1, or back from the last of `count`; -1: it is none. */
static int take_number(int count, const char *word, char **end)
{
    const long n = strtol(word, end, 10), at = n < 0 ? count + n : n - 1;

    return *end == word || at < 0 || at >= INT_MAX ? -1 : (int)at;
}

static enum status read_corner(const struct reading *r, const char *word,
                               struct obj_file_corner *c, struct message *why)
{
    char *end;

    *c = (struct obj_file_corner){take_number(r->o->vertices, word, &end), -1, r->line.line,
                                  r->group};
    bool good = c->v >= 0 && (!*end || *end == '/');
    if (good && *end == '/' && end[1] && end[1] != '/') {
        c->vt = take_number(r->o->textures, end + 1, &end);
        good = c->vt >= 0 && (!*end || *end == '/');
    }
    return good ? STATUS_OK : refuse_corner(r, word, why);
}

static enum status take_face(struct reading *r, char *text, struct message *why)
{
    struct obj_file *o = r->o;
    struct obj_file_corner fan[3];
    int count = 0;
    char *rest;
    enum status st = STATUS_OK;

    for (char *word = strtok_r(text, BLANKS, &rest); word;
         word = strtok_r(NULL, BLANKS, &rest), count++) {
        if (count > 2)
            fan[1] = fan[2];
        TRY(read_corner(r, word, &fan[count < 2 ? count : 2], why));
        for (int c = 0; count >= 2 && c < 3; c++) {
            TRY(GROW(o->corner, o->corners, MOST_CORNERS));
            o->corner[o->corners++] = fan[c];
        }
    }
    if (count < 3)
        st = yaml_tree_refuse(&r->line, why,
                              "a face has %d corners, but must have three at least", count);
out:
    return st;
}

static enum status take_group(struct reading *r, char *name, struct message *why)
{
    struct obj_file *o = r->o;
    enum status st;

    name += strspn(name, BLANKS);
    for (char *end = name + strlen(name); end > name && strchr(BLANKS, end[-1]);)
        *--end = '\0';
    for (r->group = 0; r->group < o->groups; r->group++)
        if (!strcmp(o->group[r->group], name))
            return STATUS_OK;
    TRY(GROW(o->group, o->groups, MOST_GROUPS));
    TRY((o->group[o->groups] = strdup(name)) ? STATUS_OK : STATUS_MEMORY);
    o->groups++;
out:
    return st;
}

static enum status take_line(struct reading *r, char *line, struct message *why)
{
    char *rest;
    const char *word = strtok_r(line, BLANKS, &rest);

    return !word                 ? STATUS_OK
           : !strcmp(word, "v")  ? take_vertex(r, rest, why)
           : !strcmp(word, "vt") ? take_texture(r, rest, why)
           : !strcmp(word, "f")  ? take_face(r, rest, why)
           : !strcmp(word, "g")  ? take_group(r, rest, why)
                                 : STATUS_OK;
}

/* Reads bytes[size] line by line; behind them is room for one more. */
static enum status take_lines(struct reading *r, char *bytes, size_t size,
                              struct message *why)
{
    enum status st = STATUS_OK;
    char *const end = bytes + size, *next;

    *end = '\n';
    for (char *line = bytes; line < end; line = next) {
        char *stop = memchr(line, '\n', (size_t)(end - line) + 1);
        next = stop + 1, *stop = '\0';
        r->line.line++;
        if (memchr(line, '\0', (size_t)(stop - line)))
            return yaml_tree_refuse(&r->line, why,
                                    "a NUL byte; write the mesh as OBJ text");
        TRY(take_line(r, line, why));
    }
out:
    return st;
}

/* Refuses faces of points that are nowhere in the file. */
static enum status check_corners(struct reading *r, struct message *why)
{
    const struct obj_file *o = r->o;
    char word[32];

    for (int n = 0; n < o->corners; n++) {
        const struct obj_file_corner *c = &o->corner[n];
        if (c->v < o->vertices && c->vt < o->textures)
            continue;
        r->line.line = c->line;
        snprintf(word, sizeof word, c->vt < 0 ? "%d" : "%d/%d", c->v + 1, c->vt + 1);
        return refuse_corner(r, word, why);
    }
    return STATUS_OK;
}

enum status obj_file_read(const char *path, struct obj_file *o, struct message *why)
{
    struct reading r = {.line = {.origin = path}, .o = o, .group = -1};
    char *bytes = NULL;
    size_t size;
    enum status st;

    *o = (struct obj_file){0};
    st = named_file_read(&kind, path, &bytes, &size, why);
    if (st != STATUS_OK)
        return st == STATUS_FILE ? STATUS_INPUT : st;
    if (size > MOST_BYTES) {
        r.line.line = -1;
        TRY(yaml_tree_refuse(&r.line, why, "longer than %d bytes, but must be %d at most",
                             MOST_BYTES, MOST_BYTES));
    }
    const bool marked = !strncmp(bytes, "\xEF\xBB\xBF", 3); /* a byte-order mark */
    TRY(take_lines(&r, bytes + 3 * marked, size - 3 * marked, why));
    st = check_corners(&r, why);
out:
    free(bytes);
    if (st != STATUS_OK)
        obj_file_clear(o);
    return st;
}

void obj_file_clear(struct obj_file *o)
{
    free(o->vertex);
    free(o->texture);
    free(o->corner);
    for (int n = 0; n < o->groups; n++)
        free(o->group[n]);
    free(o->group);
    *o = (struct obj_file){0};
}
