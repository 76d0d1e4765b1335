/* NumPy's files: xyz [frames][n][3] (or [frames][rows][columns][3]), uv and t. */
#include "bench/frames/frames_parts.h"
#include "bench/frames/frames_zip.h"

#include <stdlib.h>
#include <string.h>

struct npz {
    struct frames_bytes bytes;
    struct frames_zip_stream stream;
    struct frames_array xyz;
    double *t; /* [frames]; NULL: none owned */
};

static void close_npz(void *state)
{
    struct npz *n = state;

    frames_zip_close(&n->stream);
    frames_bytes_close(&n->bytes);
    free(n->t);
    free(n);
}

static enum status next_npz(struct frames *f, double *t, bool *more, struct message *why)
{
    struct npz *n = f->state;

    *more = (unsigned long long)f->number <= n->xyz.size[0];
    if (!*more)
        return STATUS_OK;
    *t = n->t ? n->t[f->number - 1] : f->number - 1;
    if (!frames_array_read(&n->stream, &n->xyz, 3 * (size_t)f->net.vertices, f->xyz))
        return status_fail(why, STATUS_INPUT,
                           "%s: frame %d: xyz is cut off or damaged; %llu whole frames "
                           "would be right",
                           f->path, f->number, n->xyz.size[0]);
    frames_bytes_forget(&n->bytes, (size_t)(n->stream.at - n->bytes.byte));
    return STATUS_OK;
}

/* A small array of `rows` rows of `columns` (0: of one rank). *values stays NULL if there
 * is none. */
static enum status take_small(struct frames *f, const char *name, size_t rows,
                              unsigned columns, double **values, struct message *why)
{
    const struct npz *n = f->state;
    const size_t count = rows * (columns ? columns : 1);
    struct frames_array a;
    const enum status st = frames_array_load(&n->bytes, name, count, &a, values, why);

    if (st != STATUS_OK)
        return st == STATUS_UNSUPPORTED ? STATUS_OK : st;
    if (frames_array_count(&a) == count && (!columns || a.size[a.rank - 1] == columns))
        return STATUS_OK;
    return status_fail(
        why, STATUS_INPUT, "%s: %s: has %zu numbers; %zu, %zu rows of %u, would be right",
        f->path, name, frames_array_count(&a), count, rows, columns ? columns : 1);
}

/* An array that is the whole file. */
static void bare_stream(struct npz *n)
{
    n->stream.at = n->bytes.byte;
    n->stream.end = n->bytes.byte + n->bytes.size;
    n->stream.size = n->bytes.size;
}

static enum status take_xyz(struct frames *f, bool bare, struct message *why)
{
    struct npz *n = f->state;
    struct frames_array *a = &n->xyz;
    enum status st = STATUS_OK;

    if (bare)
        bare_stream(n);
    else
        st = frames_zip_open(&n->bytes, "xyz.npy", &n->stream, why);
    if (st == STATUS_UNSUPPORTED)
        st = status_fail(why, STATUS_INPUT,
                         "%s: has no array xyz; numpy.savez(file, xyz=, uv=, t=) would be "
                         "right",
                         f->path);
    TRY(st);
    TRY(frames_array_open(f->path, "xyz", &n->stream, a, why));
    if (a->rank && !a->size[0])
        TRY(frames_none(f, why));
    if (a->rank < 3 || a->rank > 4 || a->size[a->rank - 1] != 3 ||
        a->size[0] > FRAMES_MOST_TIMES || a->size[1] > FRAMES_MOST_VERTICES ||
        a->size[a->rank - 2] > FRAMES_MOST_VERTICES)
        TRY(status_fail(why, STATUS_INPUT,
                        "%s: xyz: has rank %d and ends in %llu; [frames][n][3] would be "
                        "right",
                        f->path, a->rank, a->rank ? a->size[a->rank - 1] : 0));
    TRY(frames_room(f, (long)(a->size[1] * (a->rank == 4 ? a->size[2] : 1)), why));
out:
    return st;
}

enum status frames_npz_open(struct frames *f, const char *path, struct message *why)
{
    static const struct frames_reader reader = {next_npz, close_npz};
    struct npz *n = calloc(1, sizeof *n);
    enum status st;

    if (!n)
        return STATUS_MEMORY;
    f->state = n;
    f->reader = &reader;
    TRY(frames_bytes_open(path, &n->bytes, why));
    const bool bare = !strcmp(path + strlen(path) - 4, ".npy");
    TRY(take_xyz(f, bare, why));
    if (!bare) {
        TRY(take_small(f, "uv.npy", (size_t)f->net.vertices, 2, &f->net.uv, why));
        TRY(take_small(f, "t.npy", (size_t)n->xyz.size[0], 0, &n->t, why));
    }
    f->timed = n->t != NULL;
out:
    return st;
}
