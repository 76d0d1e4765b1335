/* Reads Wavefront OBJ (1995): lines `v x y z`, `vt u v`, `f v/vt/vn ...`; skips others. */
#include "bench/frames/frames_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CORNERS = 64 };

struct obj {
    const char *path;
    struct frames_mesh *mesh;
    int vt_count, vt_room;
    double *vt; /* [vt_count][2] owned */
};

static enum status bad(const struct obj *o, long line, const char *what,
                       struct message *why)
{
    return status_fail(why, STATUS_INPUT, "%s: line %ld: %s", o->path, line, what);
}

static enum status take_point(struct obj *o, const char *at, const char *end, int count,
                              long line, struct message *why)
{
    struct frames_mesh *m = o->mesh;
    double *more =
        count == 3 ? frames_bytes_grow(m->xyz, &m->room, m->vertices, 3 * sizeof *more)
                   : frames_bytes_grow(o->vt, &o->vt_room, o->vt_count, 2 * sizeof *more);

    if (!more)
        return STATUS_MEMORY;
    if (count == 3)
        m->xyz = more, more += 3 * m->vertices;
    else
        o->vt = more, more += 2 * o->vt_count;
    for (int n = 0; n < count; n++)
        if (!frames_text_number(&at, end, &more[n]))
            return bad(o, line,
                       count == 3 ? "is no vertex; `v x y z` would be right"
                                  : "is no texture point; `vt u v` would be right",
                       why);
    if (count == 3 && m->vertices == FRAMES_MOST_VERTICES)
        return bad(o, line, "is one vertex too many", why);
    if (count == 3)
        m->vertices++;
    else
        o->vt_count++;
    return STATUS_OK;
}

/* Turns a number of a face into an index: numbers count from 1, negative ones back from the
 * last. -1: there is none. */
static long index_of(double number, int count)
{
    const double n = number < 0 ? count + number : number - 1;

    return n >= 0 && n < count && n == floor(n) ? (long)n : -1;
}

/* Takes uv of a vertex from its vt, and refuses a seam, which gives one vertex two. */
static enum status take_uv(struct obj *o, long vertex, long vt, long line,
                           struct message *why)
{
    struct frames_mesh *m = o->mesh;

    if (!m->uv) {
        m->uv = malloc((size_t)m->vertices * 2 * sizeof *m->uv);
        if (!m->uv)
            return STATUS_MEMORY;
        for (int n = 0; n < 2 * m->vertices; n++)
            m->uv[n] = NAN;
    }
    for (int n = 0; n < 2; n++) {
        double *uv = &m->uv[2 * vertex + n];
        if (!isnan(*uv) && fabs(*uv - o->vt[2 * vt + n]) > 1e-6)
            return bad(o, line,
                       "gives a vertex a second vt; one material point a vertex, without "
                       "seams, would be right",
                       why);
        *uv = o->vt[2 * vt + n];
    }
    return STATUS_OK;
}

static enum status take_face(struct obj *o, const char *at, const char *end, long line,
                             struct message *why)
{
    const int vertices = o->mesh->vertices;
    const char *word;
    long vertex[CORNERS];
    int count = 0, size;
    double x;
    enum status st;

    for (; (size = frames_text_word(&at, end, &word)) > 0; count++) {
        const char *p = word, *stop = word + size;
        if (count == CORNERS || !frames_text_number(&p, stop, &x) ||
            (vertex[count] = index_of(x, vertices)) < 0)
            return bad(o, line, "is a face of vertices that are not there", why);
        if (p + 1 >= stop || p[0] != '/' || p[1] == '/')
            continue;
        p++;
        const long vt = frames_text_number(&p, stop, &x) ? index_of(x, o->vt_count) : -1;
        if (vt < 0)
            return bad(o, line, "is a face of texture points that are not there", why);
        TRY(take_uv(o, vertex[count], vt, line, why));
    }
    if (count < 3)
        return bad(o, line, "is a face of fewer than three vertices", why);
    st = frames_mesh_face(o->mesh, count, vertex);
out:
    return st;
}

static enum status take_lines(struct obj *o, struct frames_text text, bool faces,
                              struct message *why)
{
    const char *at, *end, *word;
    enum status st = STATUS_OK;

    while (st == STATUS_OK && frames_text_line(&text, &at, &end)) {
        const int size = frames_text_word(&at, end, &word);
        const char a = size ? word[0] : '\0', b = size > 1 ? word[1] : '\0';
        if (!faces && size == 1 && a == 'v')
            st = take_point(o, at, end, 3, text.line, why);
        else if (!faces && size == 2 && a == 'v' && b == 't')
            st = take_point(o, at, end, 2, text.line, why);
        else if (faces && size == 1 && a == 'f')
            st = take_face(o, at, end, text.line, why);
    }
    return st;
}

/* Reads the faces after all points, since they may come first. */
enum status frames_mesh_obj(const struct frames_bytes *b, struct frames_mesh *mesh,
                            struct message *why)
{
    struct obj o = {.path = b->path, .mesh = mesh};
    enum status st;

    TRY(take_lines(&o, frames_text_of(b), false, why));
    TRY(take_lines(&o, frames_text_of(b), true, why));
    /* If no faces pair them, and there are as many vt as v, they belong together in
     * order. */
    if (!mesh->triangles && o.vt_count == mesh->vertices)
        mesh->uv = o.vt, o.vt = NULL;
    for (int n = 0; mesh->uv && n < 2 * mesh->vertices; n++)
        if (isnan(mesh->uv[n])) { /* a vertex of no face */
            free(mesh->uv);
            mesh->uv = NULL;
        }
out:
    free(o.vt);
    return st;
}
