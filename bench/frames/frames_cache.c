/* Point caches: MDD (LightWave; big-endian: frames, points, times, positions) and PC2 (3ds
 * Max; little-endian: POINTCACHE2, version, points, start, rate, samples, positions). */
#include "bench/frames/frames_parts.h"

#include <stdlib.h>
#include <string.h>

struct cache {
    struct frames_bytes bytes;
    long frames;
    size_t times, positions; /* where they begin; times: 0: none */
    bool big;
};

static void close_cache(void *state)
{
    struct cache *c = state;

    frames_bytes_close(&c->bytes);
    free(c);
}

static enum status next_cache(struct frames *f, double *t, bool *more, struct message *why)
{
    struct cache *c = f->state;
    const size_t count = 3 * (size_t)f->net.vertices;
    const size_t at = c->positions + 4 * count * (size_t)(f->number - 1);

    (void)why;
    *more = f->number <= c->frames;
    if (!*more)
        return STATUS_OK;
    *t = c->times ? frames_bytes_float(
                        c->bytes.byte + c->times + 4 * (size_t)(f->number - 1), 4, c->big)
                  : f->number - 1;
    for (size_t n = 0; n < count; n++)
        f->xyz[n] = frames_bytes_float(c->bytes.byte + at + 4 * n, 4, c->big);
    frames_bytes_forget(&c->bytes, at);
    return STATUS_OK;
}

enum status frames_cache_open(struct frames *f, const char *path, struct message *why)
{
    static const struct frames_reader reader = {next_cache, close_cache};
    struct cache *c = calloc(1, sizeof *c);
    unsigned long points;
    enum status st;

    if (!c)
        return STATUS_MEMORY;
    f->state = c;
    f->reader = &reader;
    TRY(frames_bytes_open(path, &c->bytes, why));
    const unsigned char *p = c->bytes.byte;
    c->big = c->bytes.size < 12 || memcmp(p, "POINTCACHE2", 12) != 0;
    if (c->bytes.size < (c->big ? 8 : 32))
        TRY(status_fail(why, STATUS_INPUT, "%s: ends within its header", path));
    points = frames_bytes_whole(p + (c->big ? 4 : 16), 4, c->big);
    c->frames = (long)frames_bytes_whole(p + (c->big ? 0 : 28), 4, c->big);
    c->times = c->big ? 8 : 0;
    c->positions = c->big ? 8 + 4 * (size_t)c->frames : 32;
    if (points > FRAMES_MOST_VERTICES || c->frames < 1 || c->frames > FRAMES_MOST_TIMES ||
        c->bytes.size < c->positions + 12 * (size_t)points * (size_t)c->frames)
        TRY(status_fail(
            why, STATUS_INPUT,
            "%s: counts %ld frames of %lu points, and has %zu bytes; as many as "
            "it counts would be right",
            path, c->frames, points, c->bytes.size));
    f->timed = c->big;
    TRY(frames_room(f, (long)points, why));
out:
    return st;
}
