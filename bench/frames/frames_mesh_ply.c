/* Reads PLY (Turk, Stanford 1994): ascii, binary_little_endian, binary_big_endian. */
#include "bench/frames/frames_reader.h"

#include <stdlib.h>
#include <string.h>

enum { ELEMENTS = 8, PROPERTIES = 32, CORNERS = 64, WORD = 256 };
enum use { USE_NONE, USE_X, USE_Y, USE_Z, USE_U, USE_V, USE_FACE };

struct property {
    enum use use;
    int size, count_size; /* bytes; count_size: of a list's length, or 0                 */
    bool is_float;
};

struct element {
    bool vertices;
    long count;
    int properties;
    struct property property[PROPERTIES];
};

struct ply {
    struct frames_file *file;
    bool ascii, big;
    int elements;
    struct element element[ELEMENTS];
    char *at; /* ascii: within a line                                                   */
    struct frames_mesh *mesh;
};

static enum status bad(const struct ply *p, const char *what, struct message *why)
{
    return status_fail(why, STATUS_INPUT, "%s: line %ld: %s", p->file->path, p->file->line,
                       what);
}

/* Returns the bytes of a type, 0: PLY has none of that name. */
static int size_of(const char *name, bool *is_float)
{
    static const char *const names[] = {
        "char",  "int8", "uchar",  "uint8", "short",   "int16",  "ushort",  "uint16", "int",
        "int32", "uint", "uint32", "float", "float32", "double", "float64", NULL};
    int n = 0;

    while (names[n] && strcmp(name, names[n]) != 0)
        n++;
    *is_float = n >= 12;
    return !names[n] ? 0 : n < 4 ? 1 : n < 8 ? 2 : n < 14 ? 4 : 8;
}

static enum use use_of(const char *name)
{
    static const char letters[] = "xyzuvst";
    static const enum use uses[] = {USE_X, USE_Y, USE_Z, USE_U, USE_V, USE_U, USE_V};

    if (!strcmp(name, "vertex_indices") || !strcmp(name, "vertex_index"))
        return USE_FACE;
    if (!strcmp(name, "texture_u") || !strcmp(name, "texture_v"))
        name += strlen("texture_");
    const char *letter = strlen(name) == 1 ? strchr(letters, *name) : NULL;
    return letter ? uses[letter - letters] : USE_NONE;
}

/* Takes a line `property TYPE NAME` or `property list TYPE TYPE NAME`. */
static enum status take_property(struct ply *p, struct message *why)
{
    struct element *e = p->elements ? &p->element[p->elements - 1] : NULL;
    char type[WORD] = "", count[WORD] = "", name[WORD] = "";
    const char *line = p->file->text;
    bool is_float;

    if (!e || e->properties == PROPERTIES)
        return bad(p, "is a property of no element, or one too many", why);
    struct property *q = &e->property[e->properties++];
    *q = (struct property){USE_NONE};
    if (sscanf(line, " property list %255s %255s %255s", count, type, name) > 0) {
        q->count_size = size_of(count, &is_float);
        if (!q->count_size || is_float)
            return bad(p, "is a list whose length is no whole number", why);
    } else {
        sscanf(line, " property %255s %255s", type, name);
    }
    q->size = size_of(type, &q->is_float);
    if (!q->size)
        return bad(p, "is a property of a type that PLY has not", why);
    q->use = use_of(name);
    if ((q->use == USE_FACE) != (q->count_size > 0))
        q->use = USE_NONE;
    return STATUS_OK;
}

/* Takes a line `element NAME COUNT`. */
static enum status take_element(struct ply *p, struct message *why)
{
    char name[WORD] = "";
    double count = -1;

    if (p->elements == ELEMENTS)
        return bad(p, "is one element too many", why);
    sscanf(p->file->text, " element %255s %lf", name, &count);
    if (!(count >= 0 && count <= (double)p->file->size))
        return bad(p, "counts more than the file can hold", why);
    p->element[p->elements++] =
        (struct element){.vertices = !strcmp(name, "vertex"), .count = (long)count};
    return STATUS_OK;
}

static enum status take_header(struct ply *p, struct message *why)
{
    bool more, known = false;

    for (;;) {
        char word[WORD] = "", format[WORD] = "";
        CALL(frames_file_line(p->file, &more, why));
        if (!more)
            return bad(p, "ends before end_header", why);
        sscanf(p->file->text, "%255s %255s", word, format);
        if (p->file->line == 1 && strcmp(word, "ply") != 0)
            return bad(p, "is not `ply`, with which such a file begins", why);
        if (!strcmp(word, "end_header"))
            return known ? STATUS_OK : bad(p, "ends a header without a format", why);
        if (!strcmp(word, "format")) {
            p->ascii = !strcmp(format, "ascii");
            p->big = !strcmp(format, "binary_big_endian");
            known = p->ascii || p->big || !strcmp(format, "binary_little_endian");
        } else if (!strcmp(word, "element")) {
            CALL(take_element(p, why));
        } else if (!strcmp(word, "property")) {
            CALL(take_property(p, why));
        }
    }
    return STATUS_OK;
}

/* Reads the next number, from text or bytes; `what` goes into the sentence where there is
 * none. */
static enum status take_number(struct ply *p, int size, bool is_float, double *x,
                               const char *what, struct message *why)
{
    unsigned char bytes[8];
    bool more = true;

    if (p->ascii) {
        while (more && !frames_file_number(&p->at, x)) {
            more = p->at[strspn(p->at, " \t\r")] == '\0';
            if (more)
                CALL(frames_file_line(p->file, &more, why));
            p->at = p->file->text;
        }
        return more ? STATUS_OK : bad(p, what, why);
    }
    if (!frames_file_read(p->file, bytes, (size_t)size))
        return bad(p, what, why);
    *x = is_float ? frames_file_float(bytes, size, p->big)
                  : (double)frames_file_whole(bytes, size, p->big);
    return STATUS_OK;
}

static enum status take_list(struct ply *p, const struct property *q, struct message *why)
{
    static const char ends[] = "ends within a list";
    const bool face = q->use == USE_FACE;
    long vertex[CORNERS];
    double count, x;

    CALL(take_number(p, q->count_size, false, &count, ends, why));
    if (count < 0)
        return bad(p, ends, why);
    if (face && (count < 3 || count > CORNERS))
        return bad(p, "is a face of fewer than 3 or more than 64 vertices", why);
    for (long n = 0; n < count; n++) {
        CALL(take_number(p, q->size, q->is_float, &x, ends, why));
        if (!face)
            continue;
        if (!(x >= 0 && x < p->mesh->vertices))
            return bad(p, "is a face of vertices that are not there", why);
        vertex[n] = (long)x;
    }
    if (face)
        frames_mesh_face(p->mesh, (int)count, vertex);
    return STATUS_OK;
}

static void put(struct frames_mesh *m, long row, enum use use, double x)
{
    if (use >= USE_X && use <= USE_Z)
        m->xyz[3 * row + use - USE_X] = x;
    else if (m->uv && (use == USE_U || use == USE_V))
        m->uv[2 * row + use - USE_U] = x;
}

static enum status take_rows(struct ply *p, const struct element *e, struct message *why)
{
    double x;

    for (long row = 0; row < e->count; row++)
        for (int n = 0; n < e->properties; n++) {
            const struct property *q = &e->property[n];
            if (q->count_size) {
                CALL(take_list(p, q, why));
                continue;
            }
            CALL(take_number(p, q->size, q->is_float, &x,
                             "ends within its rows: fewer than its header counts", why));
            if (e->vertices)
                put(p->mesh, row, q->use, x);
        }
    return STATUS_OK;
}

static enum status make_room(struct ply *p, const struct element *e, struct message *why)
{
    const unsigned place = 1U << USE_X | 1U << USE_Y | 1U << USE_Z,
                   uv = 1U << USE_U | 1U << USE_V;
    struct frames_mesh *m = p->mesh;
    unsigned uses = 0;

    for (int n = 0; n < e->properties; n++)
        uses |= 1U << e->property[n].use;
    if (m->xyz || (uses & place) != place || e->count < 1 ||
        e->count > FRAMES_MOST_VERTICES)
        return bad(p, "ends a header without vertices that have x, y and z", why);
    m->vertices = (int)e->count;
    m->xyz = arena_take(m->arena, (size_t)m->vertices, 3 * sizeof *m->xyz);
    if ((uses & uv) == uv)
        m->uv = arena_take(m->arena, (size_t)m->vertices, 2 * sizeof *m->uv);
    return STATUS_OK;
}

enum status frames_mesh_ply(const char *path, struct frames_mesh *mesh, struct message *why)
{
    struct frames_file file SCOPED(frames_file_close) = {0};
    struct ply p = {.file = &file, .at = "", .mesh = mesh};

    CALL(frames_file_open(path, &file, why));
    CALL(take_header(&p, why));
    for (int n = 0; n < p.elements; n++) {
        if (p.element[n].vertices)
            CALL(make_room(&p, &p.element[n], why));
        CALL(take_rows(&p, &p.element[n], why));
    }
    return STATUS_OK;
}
