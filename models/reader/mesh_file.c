#include "models/reader/mesh_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/reader/named_file.h"
#include "models/reader/yaml_tree.h"

enum { MOST_BYTES = 1 << 28 };
static const double FARTHEST = 1e6; /* as of a scene's places [m] */
static const char BLANKS[] = " \t\r";

static const struct named_file_kind kind = {.what = "mesh", .most = MOST_BYTES};

struct reading {
    struct yaml_tree line; /* to blame                                               */
    const double *at;
    double scale;
    int vertices, triangles, vertex_room, triangle_room;
    double (*vertex)[3];
    int (*triangle)[3]; /* both owned                                                */
};

/* Makes room behind array[count] for one more of `size` bytes; NULL without memory. */
static void *grow(void *array, int count, int *room, size_t size)
{
    if (count < *room)
        return array;
    void *more = realloc(array, (2 * (size_t)*room + 64) * size);
    if (more)
        *room = 2 * *room + 64;
    return more;
}

static enum status take_vertex(struct reading *r, char *text, struct message *why)
{
    void *more = grow(r->vertex, r->vertices, &r->vertex_room, sizeof *r->vertex);

    if (!more)
        return STATUS_MEMORY;
    r->vertex = more;
    if (r->vertices == CONTACT_MESH_MOST_VERTICES)
        return yaml_tree_refuse(&r->line, why,
                                "more than %d vertices; fewer would be right",
                                CONTACT_MESH_MOST_VERTICES);
    for (int i = 0; i < 3; i++) {
        char *end = text;
        const double x = r->at[i] + r->scale * strtod(text, &end);
        if (end == text || !(fabs(x) <= FARTHEST)) /* also NaN */
            return yaml_tree_refuse(&r->line, why,
                                    "a vertex needs three numbers `v x y z` that are at "
                                    "most %g m from 0 in the scene",
                                    FARTHEST);
        r->vertex[r->vertices][i] = x;
        text = end;
    }
    r->vertices++;
    return STATUS_OK;
}

/* Reads the vertex that a word of a face names, from 0. */
static enum status take_corner(const struct reading *r, const char *word, int *corner,
                               struct message *why)
{
    char *end;
    const long number = strtol(word, &end, 10);
    const long n = number < 0 ? r->vertices + number : number - 1;

    if (end == word || (*end && *end != '/') || n < 0 || n >= r->vertices)
        return yaml_tree_refuse(&r->line, why,
                                "a face names the vertex %s, but must name one of the %d "
                                "above it, as in `f 1 2 3`",
                                yaml_tree_quote(word).text, r->vertices);
    *corner = (int)n;
    return STATUS_OK;
}

static enum status take_face(struct reading *r, char *text, struct message *why)
{
    enum status st = STATUS_OK;
    int corner = 0, first = 0, last = 0, count = 0;
    char *rest;

    for (char *word = strtok_r(text, BLANKS, &rest); word;
         word = strtok_r(NULL, BLANKS, &rest), last = corner, count++) {
        TRY(take_corner(r, word, &corner, why));
        if (count == 0)
            first = corner;
        if (count < 2)
            continue;
        if (r->triangles == CONTACT_MESH_MOST)
            return yaml_tree_refuse(&r->line, why,
                                    "more than %d triangles; fewer would be right",
                                    CONTACT_MESH_MOST);
        void *more =
            grow(r->triangle, r->triangles, &r->triangle_room, sizeof *r->triangle);
        if (!more)
            return STATUS_MEMORY;
        r->triangle = more;
        memcpy(r->triangle[r->triangles++], (int[3]){first, last, corner},
               sizeof *r->triangle);
    }
    if (count < 3)
        return yaml_tree_refuse(
            &r->line, why, "a face has %d corners, but must have three at least", count);
out:
    return st;
}

/* Reads line by line bytes[size], after which there is room for one more. */
static enum status take_lines(struct reading *r, char *bytes, size_t size,
                              struct message *why)
{
    enum status st = STATUS_OK;
    char *const end = bytes + size, *next;

    *end = '\n';
    for (char *line = bytes; line < end; line = next) {
        char *stop = memchr(line, '\n', (size_t)(end - line) + 1), *word;
        next = stop + 1, *stop = '\0';
        r->line.line++;
        if (memchr(line, '\0', (size_t)(stop - line)))
            return yaml_tree_refuse(&r->line, why,
                                    "a NUL byte; write the mesh as OBJ text");
        word = line + strspn(line, BLANKS);
        if (word[0] == 'v' && word[1] && strchr(BLANKS, word[1]))
            TRY(take_vertex(r, word + 1, why));
        else if (word[0] == 'f' && word[1] && strchr(BLANKS, word[1]))
            TRY(take_face(r, word + 1, why));
    }
out:
    return st;
}

enum status mesh_file_read(const char *path, const double at[3], double scale,
                           struct obstacle_mesh **mesh, struct message *why)
{
    enum status st;
    struct message inner = {""};
    struct reading r = {.line = {.origin = path}, .at = at, .scale = scale};
    const struct yaml_tree whole = {.origin = path, .line = -1};
    char *bytes = NULL;
    size_t size;

    *mesh = NULL;
    st = named_file_read(&kind, path, &bytes, &size, why);
    if (st != STATUS_OK)
        return st == STATUS_FILE ? STATUS_INPUT : st;
    if (size > MOST_BYTES)
        TRY(yaml_tree_refuse(&whole, why, "longer than %d bytes, but must be %d at most",
                             MOST_BYTES, MOST_BYTES));
    TRY(take_lines(&r, bytes, size, why));
    st = contact_mesh_make(r.vertices, (const double(*)[3])r.vertex, r.triangles,
                           (const int(*)[3])r.triangle, mesh, &inner);
    if (st == STATUS_INPUT)
        yaml_tree_refuse(&whole, why, "%s", inner.text);
out:
    free(bytes);
    free(r.vertex);
    free(r.triangle);
    return st;
}
