/* Reads Wavefront OBJ (1995): lines `v x y z`, `vt u v`, `f v/vt/vn ...`; skips others. */
#include "bench/frames/frames_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CORNERS = 64 };
static const char BLANKS[] = " \t\r";

struct obj {
    struct frames_file *file;
    struct frames_mesh *mesh;
    int vt_count, vt_room;
    double *vt; /* [vt_count][2] owned */
};

static enum status bad(const struct obj *o, const char *what, struct message *why)
{
    return status_fail(why, STATUS_INPUT, "%s: line %ld: %s", o->file->path, o->file->line,
                       what);
}

/* Adds the `size` numbers of a line to an array of *count points. */
static enum status take_point(struct obj *o, char *at, int size, double **array, int *room,
                              int *count, struct message *why)
{
    double *more = frames_file_grow(*array, room, *count, (size_t)size * sizeof *more);

    if (!more)
        return STATUS_MEMORY;
    *array = more;
    for (int n = 0; n < size; n++)
        if (!frames_file_number(&at, &more[size * *count + n]))
            return bad(o,
                       size == 3 ? "is no vertex; `v x y z` would be right"
                                 : "is no texture point; `vt u v` would be right",
                       why);
    if (++*count > FRAMES_MOST_VERTICES)
        return bad(o, "is one vertex too many", why);
    return STATUS_OK;
}

/* Reads a number of a face and turns it into an index: numbers count from 1, negative ones
 * back from the last. -1: there is none. */
static long take_index(char **at, int count)
{
    double number;

    if (!frames_file_number(at, &number))
        return -1;
    const double n = number < 0 ? count + number : number - 1;
    return n >= 0 && n < count && n == floor(n) ? (long)n : -1;
}

/* Takes uv of a vertex from its vt, and refuses a seam, which gives one vertex two. */
static enum status take_uv(struct obj *o, long vertex, long vt, struct message *why)
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
            return bad(o,
                       "gives a vertex a second vt; one material point a vertex, without "
                       "seams, would be right",
                       why);
        *uv = o->vt[2 * vt + n];
    }
    return STATUS_OK;
}

static enum status take_face(struct obj *o, char *at, struct message *why)
{
    long vertex[CORNERS];
    int count = 0;
    enum status st;

    for (char *word; (word = strtok_r(NULL, BLANKS, &at)); count++) {
        vertex[count % CORNERS] = take_index(&word, o->mesh->vertices);
        if (count == CORNERS || vertex[count] < 0)
            return bad(o, "is a face of vertices that are not there", why);
        if (word[0] != '/' || word[1] == '/' || !word[1])
            continue;
        word++;
        const long vt = take_index(&word, o->vt_count);
        if (vt < 0)
            return bad(o, "is a face of texture points that are not there", why);
        TRY(take_uv(o, vertex[count], vt, why));
    }
    if (count < 3)
        return bad(o, "is a face of fewer than three vertices", why);
    st = frames_mesh_face(o->mesh, count, vertex);
out:
    return st;
}

/* Reads all points, or all faces. */
static enum status take_lines(struct obj *o, bool faces, struct message *why)
{
    struct frames_mesh *m = o->mesh;
    bool more;
    enum status st;

    frames_file_go(o->file, 0, 1);
    for (;;) {
        TRY(frames_file_line(o->file, &more, why));
        char *rest, *word = more ? strtok_r(o->file->text, BLANKS, &rest) : NULL;
        if (!more)
            break;
        if (!word)
            continue;
        if (!faces && !strcmp(word, "v"))
            TRY(take_point(o, rest, 3, &m->xyz, &m->room, &m->vertices, why));
        else if (!faces && !strcmp(word, "vt"))
            TRY(take_point(o, rest, 2, &o->vt, &o->vt_room, &o->vt_count, why));
        else if (faces && !strcmp(word, "f"))
            TRY(take_face(o, rest, why));
    }
out:
    return st;
}

/* Reads the faces after all points, since they may come first. */
enum status frames_mesh_obj(struct frames_file *f, struct frames_mesh *mesh,
                            struct message *why)
{
    struct obj o = {.file = f, .mesh = mesh};
    enum status st;

    TRY(take_lines(&o, false, why));
    TRY(take_lines(&o, true, why));
    /* Texture points that no face pairs with vertices belong to them in order. */
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
