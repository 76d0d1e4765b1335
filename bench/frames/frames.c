#define _GNU_SOURCE /* strverscmp, versionsort */
#include "bench/frames/frames.h"

#include <dirent.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/folder.h"
#include "bench/frames/frames_reader.h"

enum status frames_room(struct frames *f, long vertices, struct message *why)
{
    if (vertices < 1 || vertices > FRAMES_MOST_VERTICES)
        return status_fail(why, STATUS_INPUT,
                           "%s: has %ld vertices; 4 to %d would be right", f->path,
                           vertices, FRAMES_MOST_VERTICES);
    f->net.vertices = (int)vertices;
    f->xyz = arena_take(&f->arena, (size_t)vertices, 3 * sizeof *f->xyz);
    return STATUS_OK;
}

static bool ends(const char *name, const char *ending)
{
    const size_t length = strlen(name), tail = strlen(ending);

    return length > tail && !strcmp(name + length - tail, ending);
}

/* The endings of names, and their readers, each in a file of its own. */
#define READERS(X)                                                                         \
    X(csv, csv)                                                                            \
    X(npz, moving)                                                                         \
    X(npy, moving)                                                                         \
    X(h5, moving)                                                                          \
    X(hdf5, moving) X(mdd, cache) X(pc2, cache) X(obj, sequence) X(ply, sequence)
#define READER(ending, name) extern const struct frames_reader frames_##name;
READERS(READER)

#define KIND(ending, name) {"." #ending, &frames_##name},
static const struct {
    const char *ending;
    const struct frames_reader *reader;
} kinds[] = {READERS(KIND)};
enum { KINDS = sizeof kinds / sizeof *kinds };

static int kind_of(const char *name)
{
    for (int n = 0; n < KINDS; n++)
        if (ends(name, kinds[n].ending))
            return n;
    return -1;
}

bool frames_is_name(const char *name)
{
    return kind_of(name) >= 0;
}

static int is_seen(const struct dirent *entry)
{
    return entry->d_name[0] != '.';
}

enum status frames_folder_read(const char *path, struct frames_folder *folder,
                               struct message *why)
{
    struct dirent **entry = NULL;
    const int count = scandir(path, &entry, is_seen, versionsort);

    *folder = (struct frames_folder){.count = count};
    if (count < 0)
        return errno == ENOMEM
                   ? STATUS_MEMORY
                   : status_fail(why, STATUS_FILE, "%s: %s", path, strerror(errno));
    folder->path = arena_take(&folder->arena, (size_t)count, sizeof *folder->path);
    for (int n = 0; n < count; n++) {
        folder->path[n] = arena_print(&folder->arena, "%s/%s", path, entry[n]->d_name);
        free(entry[n]);
    }
    free(entry);
    return STATUS_OK;
}

void frames_folder_clear(struct frames_folder *folder)
{
    arena_clear(&folder->arena);
    *folder = (struct frames_folder){0};
}

void frames_folder_keep(struct frames_folder *folder, bool (*keep)(const char *path))
{
    int kept = 0;

    for (int n = 0; n < folder->count; n++)
        if (keep(folder->path[n]))
            folder->path[kept++] = folder->path[n];
    folder->count = kept;
}

static int compare_paths(const void *a, const void *b)
{
    char *const *left = a, *const *right = b;

    return strverscmp(*left, *right);
}

/* Lists the files: those of a folder that may have frames, or those that are named. */
static enum status list_files(struct frames *f, int count, const char *const *paths,
                              struct message *why)
{
    enum status st = STATUS_OK;

    if (count == 1 && folder_is(paths[0])) {
        CALL(frames_folder_read(paths[0], &f->files, why));
        frames_folder_keep(&f->files, frames_is_name);
        if (!f->files.count)
            st = status_fail(why, STATUS_INPUT,
                             "%s: has no frames in it; files that end in .obj, .ply, .csv, "
                             ".npz or .h5 would be right",
                             paths[0]);
        return st;
    }
    f->files.path = arena_take(&f->arena, (size_t)count, sizeof *f->files.path);
    for (int n = 0; n < count; n++)
        f->files.path[f->files.count++] = arena_print(&f->arena, "%s", paths[n]);
    return st;
}

/* Finds the reader of the files, and opens them. */
static enum status open_files(struct frames *f, struct message *why)
{
    char **path = f->files.path;
    const int count = f->files.count, kind = kind_of(path[0]);

    if (kind < 0)
        return status_fail(why, STATUS_INPUT,
                           "%s: is of no kind that is read: .csv, .npz, .npy, .h5, .hdf5, "
                           ".obj, .ply, .mdd, .pc2",
                           path[0]);
    for (int n = 1; n < count; n++)
        if (kind_of(path[n]) != kind)
            return status_fail(
                why, STATUS_INPUT,
                "%s: is of another kind than %s; files of one kind would be right", path[n],
                path[0]);
    if (kinds[kind].reader != &frames_sequence) {
        if (count > 1)
            return status_fail(
                why, STATUS_INPUT,
                "%s: is one of %d files, and each %s has all frames; name one", path[0],
                count, kinds[kind].ending);
        f->path = path[0]; /* one of a folder */
    }
    qsort(path, (size_t)count, sizeof *path, compare_paths);
    f->state = arena_take(&f->arena, 1, kinds[kind].reader->state);
    f->reader = kinds[kind].reader;
    return f->reader->open(f, why);
}

static int compare_corners(const void *a, const void *b)
{
    const int *left = a, *right = b;

    return (*left > *right) - (*left < *right);
}

static int compare_faces(const void *a, const void *b)
{
    return memcmp(a, b, 3 * sizeof(int));
}

bool frames_same_faces(int count, const int (*a)[3], int other, const int (*b)[3])
{
    struct arena own SCOPED(arena_clear) = {0};
    int(*sorted)[3] = arena_take(&own, 2 * (size_t)count, sizeof *sorted);

    if (count != other)
        return false;
    for (int n = 0; n < 2 * count; n++) {
        memcpy(sorted[n], n < count ? a[n] : b[n - count], sizeof *sorted);
        qsort(sorted[n], 3, sizeof **sorted, compare_corners);
    }
    qsort(sorted, (size_t)count, sizeof *sorted, compare_faces);
    qsort(sorted + count, (size_t)count, sizeof *sorted, compare_faces);
    return !memcmp(sorted, sorted + count, (size_t)count * sizeof *sorted);
}

/* Reads the mesh of --rest and takes uv, rest positions and faces from it. */
static enum status take_rest(struct frames *f, struct message *why)
{
    struct frames_mesh mesh;

    CALL(frames_mesh_read(f->look.rest, f->look.seams, &f->arena, &mesh, why));
    if (mesh.vertices != f->net.vertices)
        return status_fail(why, STATUS_INPUT,
                           "%s: has %d vertices, %s %d; the same is right", f->look.rest,
                           mesh.vertices, f->path, f->net.vertices);
    if (!f->net.uv)
        f->net.uv = mesh.uv;
    f->net.rest = mesh.xyz;
    if (!f->net.triangles || (mesh.corner && !f->net.corner)) {
        if (f->net.triangles &&
            !frames_same_faces(f->net.triangles, (const int(*)[3])f->net.triangle,
                               mesh.triangles, (const int(*)[3])mesh.triangle))
            return status_fail(why, STATUS_INPUT,
                               "%s: its faces are not those of %s; the same would be right",
                               f->path, f->look.rest);
        f->net.triangles = mesh.triangles, f->net.triangle = mesh.triangle;
        f->net.corner = mesh.corner;
    }
    return STATUS_OK;
}

static enum status check_uv(const struct frames *f, struct message *why)
{
    for (int n = 0; f->net.uv && n < 2 * f->net.vertices; n++)
        if (!isfinite(f->net.uv[n]))
            return status_fail(why, STATUS_INPUT,
                               "%s: %c of vertex %d is %g; a number would be right",
                               f->path, "uv"[n % 2], n / 2 + 1, f->net.uv[n]);
    const double *vt = f->net.corner ? **f->net.corner : NULL;
    for (int n = 0; vt && n < 6 * f->net.triangles; n++)
        if (!isfinite(vt[n]))
            return status_fail(why, STATUS_INPUT,
                               "%s: face %d has a vt of %g; a number would be right",
                               f->path, n / 6 + 1, vt[n]);
    return STATUS_OK;
}

enum status frames_open(int count, const char *const *paths, const struct frames_look *look,
                        struct frames **frames, struct message *why)
{
    struct arena arena = {0};
    struct frames *f SCOPED(frames_close_scope) = arena_take(&arena, 1, sizeof *f);

    f->look = *look;
    f->path = arena_print(&arena, "%s", paths[0]);
    f->arena = arena;
    CALL(list_files(f, count, paths, why));
    CALL(open_files(f, why));
    if (look->rest)
        CALL(take_rest(f, why));
    CALL(check_uv(f, why));
    if (!f->timed && !(look->dt > 0))
        return status_fail(
            why, STATUS_INPUT,
            "%s: has no times; --dt S, the seconds from frame to frame, would "
            "be right",
            f->path);
    *frames = f, f = NULL;
    return STATUS_OK;
}

void frames_close(struct frames *f)
{
    if (!f)
        return;
    if (f->reader && f->reader->close)
        f->reader->close(f->state);
    frames_folder_clear(&f->files);
    struct arena arena = f->arena;
    arena_clear(&arena);
}

const char *frames_name(const struct frames *f)
{
    return f->path;
}

const struct frames_net *frames_net(const struct frames *f)
{
    return &f->net;
}

const char *frames_scene(const struct frames *f)
{
    return f->scene;
}

/* Positions from here on are none of a sheet, and their squares may be no numbers. */
static const double FARTHEST = 1e100;

static enum status check_frame(struct frames *f, double t, struct message *why)
{
    if (!isfinite(t) || (f->number > 1 && !(t > f->time)))
        return status_fail(
            why, STATUS_INPUT,
            "%s: frame %d is at t = %g s, the one before at %g s; times that "
            "grow would be right",
            f->path, f->number, t, f->time);
    for (int n = 0; n < 3 * f->net.vertices; n++)
        if (!(fabs(f->xyz[n]) < FARTHEST))
            return status_fail(why, STATUS_INPUT,
                               "%s: frame %d (t = %g s): vertex %d has %c = %g; a number "
                               "below %g would be right",
                               f->path, f->number, t, n / 3 + 1, "xyz"[n % 3], f -> xyz[n],
                               FARTHEST);
    return STATUS_OK;
}

enum status frames_next(struct frames *f, double *t, const double **xyz,
                        struct message *why)
{
    *xyz = NULL;
    if (f->number == f->count)
        return STATUS_OK;
    *t = f->number++;
    CALL(f->reader->next(f, t, why));
    if (f->look.dt > 0)
        *t = (f->number - 1) * f->look.dt;
    CALL(check_frame(f, *t, why));
    f->time = *t;
    *xyz = f->xyz;
    return STATUS_OK;
}
