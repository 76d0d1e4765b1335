/* Reads PLY (Turk, Stanford 1994): ascii, binary_little_endian, binary_big_endian. */
#include "bench/frames/frames_parts.h"

#include <stdlib.h>
#include <string.h>

enum { ELEMENTS = 8, PROPERTIES = 32, CORNERS = 64 };
enum use { USE_NONE, USE_X, USE_Y, USE_Z, USE_U, USE_V, USE_FACE };

struct property {
    enum use use;
    int size, count_size; /* bytes; count_size: 0, or of a list's length                */
    bool is_float;
};

struct element {
    char name[16];
    double count;
    int properties;
    struct property property[PROPERTIES];
};

struct ply {
    const struct frames_bytes *b;
    struct frames_text text; /* the rows, after the header                             */
    bool ascii, big;
    int elements;
    struct element element[ELEMENTS];
    const char *at; /* ascii: within a line                                            */
    const char *end;
    struct frames_mesh *mesh;
};

static enum status bad(const struct ply *p, const char *what, struct message *why)
{
    return status_fail(why, STATUS_INPUT, "%s: line %ld: %s", p->b->path, p->text.line,
                       what);
}

static bool is(const char *word, int size, const char *text)
{
    return (size_t)size == strlen(text) && !strncmp(word, text, (size_t)size);
}

static int size_of(const char *word, int size, bool *is_float)
{
    static const struct {
        const char *name;
        int size;
        bool is_float;
    } types[] = {{"char", 1},     {"int8", 1},       {"uchar", 1},     {"uint8", 1},
                 {"short", 2},    {"int16", 2},      {"ushort", 2},    {"uint16", 2},
                 {"int", 4},      {"int32", 4},      {"uint", 4},      {"uint32", 4},
                 {"float", 4, 1}, {"float32", 4, 1}, {"double", 8, 1}, {"float64", 8, 1}};

    for (size_t n = 0; n < sizeof types / sizeof *types; n++)
        if (is(word, size, types[n].name)) {
            *is_float = types[n].is_float;
            return types[n].size;
        }
    return 0;
}

static enum use use_of(const char *word, int size)
{
    static const struct {
        const char *name;
        enum use use;
    } uses[] = {{"x", USE_X},
                {"y", USE_Y},
                {"z", USE_Z},
                {"u", USE_U},
                {"v", USE_V},
                {"s", USE_U},
                {"t", USE_V},
                {"texture_u", USE_U},
                {"texture_v", USE_V},
                {"vertex_indices", USE_FACE},
                {"vertex_index", USE_FACE}};

    for (size_t n = 0; n < sizeof uses / sizeof *uses; n++)
        if (is(word, size, uses[n].name))
            return uses[n].use;
    return USE_NONE;
}

static enum status take_property(struct ply *p, const char *at, const char *end,
                                 struct message *why)
{
    struct element *e = p->elements ? &p->element[p->elements - 1] : NULL;
    const char *word;
    bool other;
    int size = frames_text_word(&at, end, &word);

    if (!e || e->properties == PROPERTIES)
        return bad(p, "is a property of no element, or one too many", why);
    struct property *q = &e->property[e->properties];
    *q = (struct property){0};
    if (is(word, size, "list")) {
        size = frames_text_word(&at, end, &word);
        q->count_size = size_of(word, size, &other);
        if (!q->count_size || other)
            return bad(p, "is a list whose length is no whole number", why);
        size = frames_text_word(&at, end, &word);
    }
    q->size = size_of(word, size, &q->is_float);
    if (!q->size)
        return bad(p, "is a property of a type that PLY has not", why);
    size = frames_text_word(&at, end, &word);
    q->use = use_of(word, size);
    if ((q->use == USE_FACE) != (q->count_size > 0))
        q->use = USE_NONE;
    e->properties++;
    return STATUS_OK;
}

static enum status take_element(struct ply *p, const char *at, const char *end,
                                struct message *why)
{
    struct element *e = &p->element[p->elements];
    const char *word;
    const int size = frames_text_word(&at, end, &word);

    if (p->elements == ELEMENTS)
        return bad(p, "is one element too many", why);
    *e = (struct element){0};
    memcpy(e->name, word, (size_t)(size < 15 ? size : 15));
    if (!frames_text_number(&at, end, &e->count) || e->count < 0 ||
        e->count > (double)p->b->size)
        return bad(p, "counts more than the file can hold", why);
    p->elements++;
    return STATUS_OK;
}

static enum status take_header(struct ply *p, struct message *why)
{
    const char *at, *end, *word;
    bool format = false;
    enum status st = STATUS_OK;

    while (st == STATUS_OK && frames_text_line(&p->text, &at, &end)) {
        const int size = frames_text_word(&at, end, &word);
        if (p->text.line == 1 && !is(word, size, "ply"))
            return bad(p, "is not `ply`, with which such a file begins", why);
        if (is(word, size, "end_header"))
            return format ? STATUS_OK : bad(p, "ends a header without a format", why);
        if (is(word, size, "format")) {
            const int length = frames_text_word(&at, end, &word);
            p->ascii = is(word, length, "ascii");
            p->big = is(word, length, "binary_big_endian");
            format = p->ascii || p->big || is(word, length, "binary_little_endian");
        } else if (is(word, size, "element")) {
            st = take_element(p, at, end, why);
        } else if (is(word, size, "property")) {
            st = take_property(p, at, end, why);
        }
    }
    return st == STATUS_OK ? bad(p, "ends before end_header", why) : st;
}

/* Reads the next number, from text or bytes. */
static bool take_number(struct ply *p, int size, bool is_float, double *x)
{
    if (p->ascii) {
        while (!frames_text_number(&p->at, p->end, x))
            if (p->at < p->end || !frames_text_line(&p->text, &p->at, &p->end))
                return false;
        return true;
    }
    if (p->text.end - p->text.at < size)
        return false;
    const unsigned char *at = (const unsigned char *)p->text.at;
    *x = is_float ? frames_bytes_float(at, size, p->big)
                  : (double)frames_bytes_whole(at, size, p->big);
    p->text.at += size;
    return true;
}

static enum status take_list(struct ply *p, const struct property *q, struct message *why)
{
    long vertex[CORNERS];
    double count, x;

    if (!take_number(p, q->count_size, false, &count) || count < 0)
        return bad(p, "ends within a list", why);
    if (q->use == USE_FACE && (count < 3 || count > CORNERS))
        return bad(p, "is a face of fewer than 3 or more than 64 vertices", why);
    for (int n = 0; n < count; n++) {
        if (!take_number(p, q->size, q->is_float, &x))
            return bad(p, "ends within a list", why);
        if (q->use != USE_FACE)
            continue;
        if (!(x >= 0 && x < p->mesh->vertices))
            return bad(p, "is a face of vertices that are not there", why);
        vertex[n] = (long)x;
    }
    return q->use == USE_FACE ? frames_mesh_face(p->mesh, (int)count, vertex) : STATUS_OK;
}

static void put(struct frames_mesh *m, long row, enum use use, double x)
{
    if (use >= USE_X && use <= USE_Z)
        m->xyz[3 * row + use - USE_X] = x;
    else if (m->uv && (use == USE_U || use == USE_V))
        m->uv[2 * row + use - USE_U] = x;
}

static enum status take_rows(struct ply *p, const struct element *e, bool vertices,
                             struct message *why)
{
    enum status st = STATUS_OK;
    double x;

    for (long row = 0; row < (long)e->count; row++)
        for (int n = 0; n < e->properties; n++) {
            const struct property *q = &e->property[n];
            if (q->count_size) {
                TRY(take_list(p, q, why));
            } else if (!take_number(p, q->size, q->is_float, &x)) {
                return bad(p, "ends within its rows: fewer than its header counts", why);
            } else if (vertices) {
                put(p->mesh, row, q->use, x);
            }
        }
out:
    return st;
}

static enum status make_room(struct ply *p, const struct element *e, struct message *why)
{
    struct frames_mesh *m = p->mesh;
    unsigned uses = 0;

    for (int n = 0; n < e->properties; n++)
        uses |= 1U << e->property[n].use;
    if (m->xyz || (uses & 0xe) != 0xe || e->count < 1 || e->count > FRAMES_MOST_VERTICES)
        return bad(p, "ends a header without vertices that have x, y and z", why);
    m->vertices = (int)e->count;
    m->xyz = calloc((size_t)m->vertices, 3 * sizeof *m->xyz);
    if ((uses & 0x30) == 0x30)
        m->uv = calloc((size_t)m->vertices, 2 * sizeof *m->uv);
    return m->xyz && (m->uv || (uses & 0x30) != 0x30) ? STATUS_OK : STATUS_MEMORY;
}

enum status frames_mesh_ply(const struct frames_bytes *b, struct frames_mesh *mesh,
                            struct message *why)
{
    struct ply p = {.b = b, .text = frames_text_of(b), .at = "", .mesh = mesh};
    enum status st;

    p.end = p.at;
    TRY(take_header(&p, why));
    for (int n = 0; n < p.elements; n++) {
        const bool vertices = !strcmp(p.element[n].name, "vertex");
        if (vertices)
            TRY(make_room(&p, &p.element[n], why));
        TRY(take_rows(&p, &p.element[n], vertices, why));
    }
out:
    return st;
}
