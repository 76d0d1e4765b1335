/* Reads meshes, .obj or .ply, and sequences of them; count and faces are the first's. */
#include "bench/frames/frames_reader.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

void frames_mesh_face(struct frames_mesh *mesh, int count, const long *vertex)
{
    for (int n = 2; n < count; n++) {
        mesh->triangle = arena_more(mesh->arena, mesh->triangle, (size_t)mesh->triangles,
                                    sizeof *mesh->triangle);
        int *corner = mesh->triangle[mesh->triangles++];
        corner[0] = (int)vertex[0];
        corner[1] = (int)vertex[n - 1];
        corner[2] = (int)vertex[n];
    }
}

enum status frames_mesh_read(const char *path, bool seams, struct arena *arena,
                             struct frames_mesh *mesh, struct message *why)
{
    const char *ending = strrchr(path, '.');
    const bool ply = ending && !strcmp(ending, ".ply");

    *mesh = (struct frames_mesh){.arena = arena, .seams = seams};
    if (!ply && !(ending && !strcmp(ending, ".obj")))
        return status_fail(why, STATUS_INPUT,
                           "%s: is no mesh; an .obj or .ply would be right", path);
    CALL((ply ? frames_mesh_ply : frames_mesh_obj)(path, mesh, why));
    if (!mesh->vertices)
        return status_fail(why, STATUS_INPUT, "%s: has no vertices", path);
    return STATUS_OK;
}

/* A sequence; its first frame's faces are the net's, unless it has none and --rest does. */
struct sequence {
    int triangles; /* of the first frame */
};

static enum status check_same(const struct frames *f, const struct frames_mesh *mesh,
                              struct message *why)
{
    const struct sequence *s = f->state;
    const char *path = f->files.path[f->number - 1];

    if (mesh->vertices != f->net.vertices)
        return status_fail(why, STATUS_INPUT,
                           "%s: frame %d has %d vertices, the first frame %d; the same "
                           "would be right",
                           path, f->number, mesh->vertices, f->net.vertices);
    if (mesh->triangles != s->triangles ||
        (s->triangles && memcmp(mesh->triangle, f->net.triangle,
                                (size_t)s->triangles * sizeof *mesh->triangle) != 0))
        return status_fail(why, STATUS_INPUT,
                           "%s: frame %d has other faces than the first frame: vertices "
                           "were renumbered or the net was remeshed; the same faces in "
                           "every frame would be right",
                           path, f->number);
    return STATUS_OK;
}

static enum status next_mesh(struct frames *f, double *t, struct message *why)
{
    struct arena arena SCOPED(arena_clear) = {0};
    struct frames_mesh mesh;

    (void)t;
    CALL(frames_mesh_read(f->files.path[f->number - 1], f->look.seams, &arena, &mesh, why));
    CALL(check_same(f, &mesh, why));
    memcpy(f->xyz, mesh.xyz, (size_t)mesh.vertices * 3 * sizeof *f->xyz);
    return STATUS_OK;
}

/* Finds the last number in a file's name, and where it begins. */
static bool number_of(const char *path, long *number, size_t *begin)
{
    const char *base = strrchr(path, '/') ? strrchr(path, '/') + 1 : path;
    const char *end = base + strlen(base);

    while (end > base && !isdigit((unsigned char)end[-1]))
        end--;
    const char *at = end;
    while (at > base && isdigit((unsigned char)at[-1]) && end - at < 9)
        at--;
    *begin = (size_t)(at - path);
    *number = strtol(at, NULL, 10);
    return at < end;
}

/* Refuses a sequence whose numbers do not go on evenly: a file is missing, and --dt would
 * give wrong times to those behind it. Names that differ in more than a number are left. */
static enum status check_numbers(const struct frames *f, struct message *why)
{
    long before = 0, step = 0, number;
    size_t begin = 0, at;

    for (int pass = 0; pass < 2; pass++)
        for (int n = 0; n < f->count; n++, before = number) {
            const char *path = f->files.path[n];
            if (!number_of(path, &number, &at) ||
                (n && (at != begin || strncmp(path, f->files.path[0], at) != 0 ||
                       number <= before)))
                return STATUS_OK;
            begin = at;
            if (n && (!step || number - before < step))
                step = number - before;
            if (n && pass && number - before != step)
                return status_fail(
                    why, STATUS_INPUT,
                    "%s: comes after number %ld, and others are %ld apart: a "
                    "frame is missing; all of them would be right",
                    path, before, step);
        }
    return STATUS_OK;
}

static enum status open_sequence(struct frames *f, struct message *why)
{
    struct sequence *s = f->state;
    struct frames_mesh mesh;

    f->count = f->files.count;
    CALL(check_numbers(f, why));
    CALL(frames_mesh_read(f->files.path[0], f->look.seams, &f->arena, &mesh, why));
    s->triangles = f->net.triangles = mesh.triangles;
    f->net.uv = mesh.uv;
    f->net.triangle = mesh.triangle;
    f->net.corner = mesh.corner;
    return frames_room(f, mesh.vertices, why);
}

const struct frames_reader frames_sequence = {sizeof(struct sequence), open_sequence,
                                              next_mesh, NULL};
