/* Reads NumPy's files: xyz [frames][n][3] (or [frames][rows][columns][3]), uv and t. */
#include "bench/frames/frames_npz.h"

#include <stdlib.h>
#include <string.h>

#include "bench/frames/frames_parts.h"

/* The bytes of one array, read from front to end; all-zero before. */
struct stream {
    zip_file_t *member; /* NULL: the file is the array                           owned */
    const unsigned char *at; /* next byte of a bare array */
    unsigned long long size; /* of all bytes, as the directory announces them */
    struct npz_array array;
};

enum status npz_open(const char *path, struct npz *npz, struct message *why)
{
    zip_source_t *source = NULL;
    zip_error_t error;
    enum status st;

    *npz = (struct npz){0};
    zip_error_init(&error);
    TRY(frames_bytes_open(path, &npz->bytes, why));
    if (!strcmp(path + strlen(path) - 4, ".npy"))
        goto out;
    source = zip_source_buffer_create(npz->bytes.byte, npz->bytes.size, 0, &error);
    npz->archive = source ? zip_open_from_source(source, ZIP_RDONLY, &error) : NULL;
    if (!npz->archive)
        TRY(status_fail(why, STATUS_INPUT,
                        "%s: is cut off or no ZIP file (%s): a whole one, as numpy.savez "
                        "writes it, would be right",
                        path, zip_error_strerror(&error)));
out:
    zip_error_fini(&error);
    if (st != STATUS_OK) {
        zip_source_free(source);
        npz_close(npz);
    }
    return st;
}

void npz_close(struct npz *npz)
{
    if (npz->archive)
        zip_discard(npz->archive);
    frames_bytes_close(&npz->bytes);
    *npz = (struct npz){0};
}

static void stream_close(struct stream *s)
{
    if (s->member)
        zip_fclose(s->member);
    *s = (struct stream){0};
}

/* Reads `size` bytes; false: the array ends before, or is damaged. */
static bool stream_read(struct stream *s, const struct npz *npz, void *room, size_t size)
{
    if (s->member)
        return zip_fread(s->member, room, size) == (zip_int64_t)size;
    if ((size_t)(npz->bytes.byte + npz->bytes.size - s->at) < size)
        return false;
    memcpy(room, s->at, size);
    s->at += size;
    return true;
}

/* Finds an array of the archive. STATUS_UNSUPPORTED: there is no such member. */
static enum status find_member(const struct npz *npz, const char *name, struct stream *s,
                               struct message *why)
{
    struct zip_stat about;

    s->at = npz->bytes.byte;
    s->size = npz->bytes.size;
    if (!npz->archive)
        return STATUS_OK;
    if (zip_stat(npz->archive, name, 0, &about))
        return STATUS_UNSUPPORTED;
    s->size = about.size;
    s->member = zip_fopen(npz->archive, name, 0);
    if (!s->member)
        return status_fail(why, STATUS_INPUT, "%s: %s: cannot be unpacked: %s",
                           npz->bytes.path, name, zip_strerror(npz->archive));
    if (about.size / 1040 > about.comp_size) /* deflate packs a thousandfold at most */
        return status_fail(why, STATUS_INPUT, "%s: %s: announces an impossible size",
                           npz->bytes.path, name);
    return STATUS_OK;
}

/* Reads the text of 'shape', such as (3, 4, 5). */
static bool take_shape(const char *text, struct npz_array *a)
{
    const char *p = strstr(text, "'shape':"), *end = text + strlen(text);
    double x;

    p = p ? strchr(p, '(') : NULL;
    if (!p)
        return false;
    for (p++, a->rank = 0; *p != ')'; a->rank++) {
        if (a->rank == 5 || !frames_text_number(&p, end, &x) || !(x >= 0 && x <= 1e15))
            return false;
        a->size[a->rank] = (unsigned long long)x;
        while (*p == ' ' || *p == ',')
            p++;
    }
    return true;
}

static int take_type(const char *text)
{
    const char *p = strstr(text, "'descr':");

    p = p ? strchr(p + 8, '\'') : NULL;
    return p && !strncmp(p, "'<f4'", 5) ? 4 : p && !strncmp(p, "'<f8'", 5) ? 8 : 0;
}

size_t npz_count(const struct npz_array *a)
{
    size_t count = 1;

    for (int n = 0; n < a->rank; n++)
        count *= (size_t)a->size[n];
    return count;
}

/* Whether `left` bytes hold as many numbers as the shape has; the product may not wrap. */
static bool holds(const struct npz_array *a, unsigned long long left)
{
    unsigned long long total = (unsigned)a->bytes;

    for (int n = 0; n < a->rank; n++)
        if (a->size[n] && total > left / a->size[n] + 1)
            total = left + 1;
        else
            total *= a->size[n];
    return total <= left;
}

/* Reads the header of an array: little-endian floats in C order, of which there are as many
 * as its shape says. */
static enum status stream_open(const struct npz *npz, const char *name, struct stream *s,
                               struct message *why)
{
    struct npz_array *a = &s->array;
    unsigned char start[12];
    char text[4097];
    enum status st;

    TRY(find_member(npz, name, s, why));
    if (!stream_read(s, npz, start, 10) || memcmp(start, "\x93NUMPY", 6) != 0 ||
        (start[6] > 1 && !stream_read(s, npz, start + 10, 2)))
        return status_fail(why, STATUS_INPUT, "%s: %s: is no array of NumPy's",
                           npz->bytes.path, name);
    const size_t head = frames_bytes_whole(start + 8, start[6] > 1 ? 4 : 2, false);
    if (head >= sizeof text || !stream_read(s, npz, text, head))
        return status_fail(why, STATUS_INPUT, "%s: %s: its header is damaged",
                           npz->bytes.path, name);
    text[head] = '\0';
    a->bytes = take_type(text);
    if (!a->bytes || strstr(text, "'fortran_order': True") || !take_shape(text, a))
        return status_fail(why, STATUS_INPUT,
                           "%s: %s: is %.100s; 32 or 64-bit floats, little-endian and in C "
                           "order (numpy.ascontiguousarray(x, '<f8')), would be right",
                           npz->bytes.path, name, text);
    if (s->size < 10 + head || !holds(a, s->size - 10 - head))
        return status_fail(
            why, STATUS_INPUT,
            "%s: %s: is cut off: its shape needs more numbers than there are",
            npz->bytes.path, name);
out:
    return st;
}

static bool read_numbers(struct stream *s, const struct npz *npz, size_t count,
                         double *values)
{
    const size_t bytes = (size_t)s->array.bytes;
    /* The bytes go to the array's end, so that widening from its front does not
     * overtake. */
    unsigned char *at = (unsigned char *)values + count * (8 - bytes);

    if (!stream_read(s, npz, at, count * bytes))
        return false;
    for (size_t n = 0; n < count; n++)
        values[n] = frames_bytes_float(at + n * bytes, (int)bytes, false);
    return true;
}

enum status npz_load(const struct npz *npz, const char *name, size_t most,
                     struct npz_array *array, double **values, struct message *why)
{
    struct stream stream = {0};
    double *numbers = NULL;
    enum status st;

    TRY(stream_open(npz, name, &stream, why));
    *array = stream.array;
    const size_t count = npz_count(array);
    if (count > most)
        TRY(status_fail(why, STATUS_INPUT, "%s: %s: has %zu numbers; %zu would be right",
                        npz->bytes.path, name, count, most));
    numbers = malloc((count + 1) * sizeof *numbers);
    TRY(numbers ? STATUS_OK : STATUS_MEMORY);
    if (!read_numbers(&stream, npz, count, numbers))
        TRY(status_fail(why, STATUS_INPUT, "%s: %s: is cut off or damaged", npz->bytes.path,
                        name));
    *values = numbers, numbers = NULL;
out:
    free(numbers);
    stream_close(&stream);
    return st;
}

struct moving {
    struct npz npz;
    struct stream xyz;
    double *t; /* [frames]; NULL: none owned */
};

static void close_npz(void *state)
{
    struct moving *m = state;

    stream_close(&m->xyz);
    npz_close(&m->npz);
    free(m->t);
    free(m);
}

static enum status next_npz(struct frames *f, double *t, bool *more, struct message *why)
{
    struct moving *m = f->state;
    const unsigned long long frames = m->xyz.array.size[0], number = (unsigned)f->number;

    *more = number <= frames;
    if (!*more)
        return STATUS_OK;
    *t = m->t ? m->t[number - 1] : f->number - 1;
    if (!read_numbers(&m->xyz, &m->npz, 3 * (size_t)f->net.vertices, f->xyz))
        return status_fail(why, STATUS_INPUT,
                           "%s: frame %d: xyz is cut off or damaged; %llu whole frames "
                           "would be right",
                           f->path, f->number, frames);
    /* The mapped bytes are released up to about the place read; what is needed again is
     * read from the file again. */
    frames_bytes_forget(&m->npz.bytes, m->npz.bytes.size / frames * number);
    return STATUS_OK;
}

/* Reads a small array of `rows` rows of `columns` (0: of one rank). *values stays NULL if
 * there is none. */
static enum status take_small(struct frames *f, const char *name, size_t rows,
                              unsigned columns, double **values, struct message *why)
{
    const struct moving *m = f->state;
    const size_t count = rows * (columns ? columns : 1);
    struct npz_array a;
    const enum status st = npz_load(&m->npz, name, count, &a, values, why);

    if (st != STATUS_OK)
        return st == STATUS_UNSUPPORTED ? STATUS_OK : st;
    if (npz_count(&a) == count && (!columns || a.size[a.rank - 1] == columns))
        return STATUS_OK;
    return status_fail(why, STATUS_INPUT,
                       "%s: %s: has %zu numbers; %zu, %zu rows of %u, would be right",
                       f->path, name, npz_count(&a), count, rows, columns ? columns : 1);
}

static enum status take_xyz(struct frames *f, struct message *why)
{
    struct moving *m = f->state;
    const struct npz_array *a = &m->xyz.array;
    enum status st = stream_open(&m->npz, "xyz.npy", &m->xyz, why);

    if (st == STATUS_UNSUPPORTED)
        st = status_fail(why, STATUS_INPUT,
                         "%s: has no array xyz; numpy.savez(file, xyz=, uv=, t=) would be "
                         "right",
                         f->path);
    TRY(st);
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
    struct moving *m = calloc(1, sizeof *m);
    enum status st;

    if (!m)
        return STATUS_MEMORY;
    f->state = m;
    f->reader = &reader;
    TRY(npz_open(path, &m->npz, why));
    TRY(take_xyz(f, why));
    if (m->npz.archive) {
        TRY(take_small(f, "uv.npy", (size_t)f->net.vertices, 2, &f->net.uv, why));
        TRY(take_small(f, "t.npy", (size_t)m->xyz.array.size[0], 0, &m->t, why));
    }
    f->timed = m->t != NULL;
out:
    return st;
}
