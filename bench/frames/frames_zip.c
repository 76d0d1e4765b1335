#include "bench/frames/frames_zip.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define MAX32 0xffffffffULL

static unsigned long long number(const unsigned char *p, int size)
{
    return frames_bytes_whole(p, size, false);
}

static enum status damaged(const struct frames_bytes *b, const char *what,
                           struct message *why)
{
    return status_fail(why, STATUS_INPUT,
                       "%s: %s: a whole ZIP file, as numpy.savez writes it, would be right",
                       b->path, what);
}

struct directory {
    unsigned long long at, count;
};

/* The end of the central directory is looked for from the file's end; beyond 4 GB its
 * numbers stand in a second one before it. */
static enum status find_directory(const struct frames_bytes *b, struct directory *d,
                                  struct message *why)
{
    const unsigned char *p = b->byte, *end;
    size_t n = b->size;

    if (b->size < 22)
        return damaged(b, "is too short", why);
    for (n = b->size - 22;; n--) {
        if (!memcmp(p + n, "PK\5\6", 4))
            break;
        if (!n || b->size - n > 22 + 65535)
            return damaged(b, "has no directory at its end, it is cut off or no ZIP file",
                           why);
    }
    end = p + n;
    d->count = number(end + 10, 2);
    d->at = number(end + 16, 4);
    if (d->at == MAX32 && n >= 20 && !memcmp(end - 20, "PK\6\7", 4)) {
        const unsigned long long at = number(end - 12, 8);
        if (at > b->size - 56 || b->size < 56 || memcmp(p + at, "PK\6\6", 4) != 0)
            return damaged(b, "has a damaged directory", why);
        d->count = number(p + at + 32, 8);
        d->at = number(p + at + 48, 8);
    }
    return STATUS_OK;
}

struct member {
    unsigned long long packed, size, at;
    int method;
};

/* Numbers past 4 GB stand in a field of their own, in this order, where they are needed. */
static void take_large(const unsigned char *extra, const unsigned char *end,
                       struct member *m)
{
    unsigned long long *const wide[] = {&m->size, &m->packed, &m->at};

    while (end - extra >= 4) {
        const unsigned id = (unsigned)number(extra, 2),
                       size = (unsigned)number(extra + 2, 2);
        const unsigned char *at = extra + 4;
        if (size > end - at)
            return;
        for (int n = 0; id == 1 && n < 3; n++)
            if (*wide[n] == MAX32 && at + 8 <= extra + 4 + size)
                *wide[n] = number(at, 8), at += 8;
        extra += 4 + size;
    }
}

static enum status find_member(const struct frames_bytes *b, const char *name,
                               struct member *m, struct message *why)
{
    struct directory d = {0};
    enum status st;

    TRY(find_directory(b, &d, why));
    unsigned long long at = d.at;
    for (unsigned long long n = 0; n < d.count; n++) {
        const unsigned char *p = b->byte + at;
        if (at > b->size || b->size - at < 46 || memcmp(p, "PK\1\2", 4) != 0)
            return damaged(b, "has a damaged directory", why);
        const size_t length = number(p + 28, 2), extra = number(p + 30, 2),
                     comment = number(p + 32, 2);
        if (b->size - at - 46 < length + extra + comment)
            return damaged(b, "has a damaged directory", why);
        if (length == strlen(name) && !memcmp(p + 46, name, length)) {
            *m = (struct member){number(p + 20, 4), number(p + 24, 4), number(p + 42, 4),
                                 (int)number(p + 10, 2)};
            take_large(p + 46 + length, p + 46 + length + extra, m);
            return STATUS_OK;
        }
        at += 46 + length + extra + comment;
    }
    st = STATUS_UNSUPPORTED;
out:
    return st;
}

enum status frames_zip_open(const struct frames_bytes *b, const char *name,
                            struct frames_zip_stream *stream, struct message *why)
{
    struct member m = {0};
    enum status st;

    memset(stream, 0, sizeof *stream);
    TRY(find_member(b, name, &m, why));
    if (m.at > b->size || b->size - m.at < 30 || memcmp(b->byte + m.at, "PK\3\4", 4) != 0)
        TRY(damaged(b, "has a member that is not where its directory says", why));
    const unsigned char *head = b->byte + m.at;
    const unsigned long long from = m.at + 30 + number(head + 26, 2) + number(head + 28, 2);
    if (from > b->size || m.packed > b->size - from)
        TRY(damaged(b, "ends within a member", why));
    if ((m.method != 0 && m.method != 8) || (m.method == 0 && m.size != m.packed))
        TRY(damaged(b, "has a member packed in a way that is not read", why));
    /* Deflate packs a thousandfold at most. */
    if (m.size / 1040 > m.packed)
        TRY(damaged(b, "has a member of an impossible size", why));
    stream->at = b->byte + from;
    stream->end = stream->at + m.packed;
    stream->size = m.size;
    stream->deflated = m.method == 8;
    if (stream->deflated && inflateInit2(&stream->z, -MAX_WBITS) != Z_OK)
        st = STATUS_MEMORY, stream->deflated = false;
out:
    return st;
}

void frames_zip_close(struct frames_zip_stream *stream)
{
    if (stream->deflated)
        inflateEnd(&stream->z);
    memset(stream, 0, sizeof *stream);
}

bool frames_zip_read(struct frames_zip_stream *s, void *room, size_t size)
{
    if (!s->deflated) {
        if ((size_t)(s->end - s->at) < size)
            return false;
        memcpy(room, s->at, size);
        s->at += size;
        return true;
    }
    s->z.next_out = room;
    while (size) {
        const size_t in = (size_t)(s->end - s->at), part = in < 1 << 20 ? in : 1 << 20,
                     out = size < 1 << 20 ? size : 1 << 20;
        s->z.next_in = (unsigned char *)(uintptr_t)s->at;
        s->z.avail_in = (unsigned)part;
        s->z.avail_out = (unsigned)out;
        const int state = inflate(&s->z, Z_NO_FLUSH);
        s->at += part - s->z.avail_in;
        size -= out - s->z.avail_out;
        if (size && state != Z_OK)
            return false;
    }
    return true;
}

/* 'shape': (3, 4, 5), */
static bool take_shape(const char *text, struct frames_array *a)
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

enum status frames_array_open(const char *path, const char *name,
                              struct frames_zip_stream *stream, struct frames_array *a,
                              struct message *why)
{
    unsigned char start[12];
    char text[4097];

    if (!frames_zip_read(stream, start, 10) || memcmp(start, "\x93NUMPY", 6) != 0 ||
        (start[6] > 1 && !frames_zip_read(stream, start + 10, 2)))
        return status_fail(why, STATUS_INPUT, "%s: %s: is no array of NumPy's", path, name);
    const size_t head = number(start + 8, start[6] > 1 ? 4 : 2);
    if (head >= sizeof text || !frames_zip_read(stream, text, head))
        return status_fail(why, STATUS_INPUT, "%s: %s: its header is damaged", path, name);
    text[head] = '\0';
    a->bytes = take_type(text);
    if (!a->bytes || strstr(text, "'fortran_order': True") || !take_shape(text, a))
        return status_fail(why, STATUS_INPUT,
                           "%s: %s: is %.100s; 32 or 64-bit floats, little-endian and in C "
                           "order (numpy.ascontiguousarray(x, '<f8')), would be right",
                           path, name, text);
    unsigned long long left = stream->size - 10 - head, total = (unsigned)a->bytes;
    for (int n = 0; n < a->rank; n++)
        if (a->size[n] && total > left / a->size[n] + 1)
            total = left + 1;
        else
            total *= a->size[n];
    if (total > left)
        return status_fail(
            why, STATUS_INPUT,
            "%s: %s: is cut off: its shape needs more numbers than there are", path, name);
    return STATUS_OK;
}

bool frames_array_read(struct frames_zip_stream *stream, const struct frames_array *a,
                       size_t count, double *values)
{
    /* At the end of its own room, so that widening from the front does not overtake. */
    unsigned char *at = (unsigned char *)values + count * (8 - (size_t)a->bytes);

    if (!frames_zip_read(stream, at, count * (size_t)a->bytes))
        return false;
    for (size_t n = 0; n < count; n++)
        values[n] = frames_bytes_float(at + n * (size_t)a->bytes, a->bytes, false);
    return true;
}

size_t frames_array_count(const struct frames_array *a)
{
    size_t count = 1;

    for (int n = 0; n < a->rank; n++)
        count *= (size_t)a->size[n];
    return count;
}

enum status frames_array_load(const struct frames_bytes *b, const char *name, size_t most,
                              struct frames_array *a, double **values, struct message *why)
{
    struct frames_zip_stream stream;
    double *array = NULL;
    enum status st;

    TRY(frames_zip_open(b, name, &stream, why));
    TRY(frames_array_open(b->path, name, &stream, a, why));
    const size_t count = frames_array_count(a);
    if (count > most)
        TRY(status_fail(why, STATUS_INPUT, "%s: %s: has %zu numbers; %zu would be right",
                        b->path, name, count, most));
    array = malloc((count + 1) * sizeof *array);
    TRY(array ? STATUS_OK : STATUS_MEMORY);
    if (!frames_array_read(&stream, a, count, array))
        TRY(status_fail(why, STATUS_INPUT, "%s: %s: is cut off or damaged", b->path, name));
    *values = array, array = NULL;
out:
    free(array);
    frames_zip_close(&stream);
    return st;
}
