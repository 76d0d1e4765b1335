/* A mesh a frame: its vertices, count and faces are those of the first. */
#include "bench/frames/frames_folder.h"
#include "bench/frames/frames_parts.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct sequence {
    int count, taken;
    char **path; /* [count] owned */
    unsigned long long corner;
    int triangles;
};

static void close_sequence(void *state)
{
    struct sequence *s = state;

    for (int n = 0; s->path && n < s->count; n++)
        free(s->path[n]);
    free(s->path);
    free(s);
}

static int compare(const void *a, const void *b)
{
    char *const *left = a, *const *right = b;

    return frames_folder_compare(*left, *right);
}

static enum status check_same(const struct frames *f, const struct sequence *s,
                              const struct frames_mesh *mesh, struct message *why)
{
    const char *path = s->path[s->taken];

    if (mesh->vertices != f->net.vertices)
        return status_fail(why, STATUS_INPUT,
                           "%s: frame %d has %d vertices, the first frame %d; the same "
                           "would be right",
                           path, s->taken + 1, mesh->vertices, f->net.vertices);
    if (mesh->triangles != s->triangles || mesh->corner != s->corner)
        return status_fail(why, STATUS_INPUT,
                           "%s: frame %d has other faces than the first frame: vertices "
                           "were renumbered or the net was remeshed; the same faces in "
                           "every frame would be right",
                           path, s->taken + 1);
    return STATUS_OK;
}

static enum status next_mesh(struct frames *f, double *t, bool *more, struct message *why)
{
    struct sequence *s = f->state;
    struct frames_mesh mesh;
    enum status st;

    *more = s->taken < s->count;
    if (!*more)
        return STATUS_OK;
    TRY(frames_mesh_read(s->path[s->taken], &mesh, why));
    st = check_same(f, s, &mesh, why);
    if (st == STATUS_OK) {
        memcpy(f->xyz, mesh.xyz, (size_t)mesh.vertices * 3 * sizeof *f->xyz);
        *t = s->taken++;
    }
    frames_mesh_clear(&mesh);
out:
    return st;
}

static enum status take_first(struct frames *f, struct sequence *s, struct message *why)
{
    struct frames_mesh mesh;
    enum status st;

    TRY(frames_mesh_read(s->path[0], &mesh, why));
    TRY(frames_room(f, mesh.vertices, why));
    s->corner = mesh.corner;
    s->triangles = mesh.triangles;
    f->net.uv = mesh.uv, mesh.uv = NULL;
    f->net.triangle = mesh.triangle, mesh.triangle = NULL;
    f->net.triangles = mesh.triangles;
out:
    frames_mesh_clear(&mesh);
    return st;
}

enum status frames_sequence_open(struct frames *f, int count, const char *const *paths,
                                 struct message *why)
{
    static const struct frames_reader reader = {next_mesh, close_sequence};
    struct sequence *s = calloc(1, sizeof *s);
    enum status st = STATUS_OK;

    if (!s)
        return STATUS_MEMORY;
    f->state = s;
    f->reader = &reader;
    s->path = calloc((size_t)count, sizeof *s->path);
    TRY(s->path ? STATUS_OK : STATUS_MEMORY);
    for (s->count = 0; s->count < count; s->count++) {
        s->path[s->count] = strdup(paths[s->count]);
        TRY(s->path[s->count] ? STATUS_OK : STATUS_MEMORY);
    }
    qsort(s->path, (size_t)count, sizeof *s->path, compare);
    TRY(take_first(f, s, why));
out:
    return st;
}
