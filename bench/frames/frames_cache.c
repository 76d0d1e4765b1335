/* Point caches: MDD (LightWave; big-endian: frames, points, times, positions) and PC2 (3ds
 * Max; little-endian: POINTCACHE2, version, points, start, rate, samples, positions). A
 * rate between 0 and 1 is the seconds from sample to sample; 1 counts frames, and tells no
 * time. */
#include "bench/frames/frames_reader.h"

#include <stdlib.h>
#include <string.h>

struct cache {
    struct frames_file file; /* read up to the next positions                             */
    unsigned char *times;    /* [frames][4]; NULL: none                                   */
    unsigned char *bytes;    /* [vertices][3][4] of a frame                               */
    bool big;
    double rate; /* [s] of PC2; 0: not told                                               */
};

static void close_cache(void *state)
{
    struct cache *c = state;

    frames_file_close(&c->file);
}

static enum status next_cache(struct frames *f, double *t, struct message *why)
{
    struct cache *c = f->state;
    const size_t count = 3 * (size_t)f->net.vertices;

    if (!frames_file_read(&c->file, c->bytes, 4 * count))
        return status_fail(why, STATUS_INPUT, "%s: ends within frame %d", f->path,
                           f->number);
    if (c->times)
        *t = frames_file_float(c->times + 4L * (f->number - 1), 4, c->big);
    else if (c->rate > 0)
        *t = (f->number - 1) * c->rate;
    for (size_t n = 0; n < count; n++)
        f->xyz[n] = frames_file_float(c->bytes + 4 * n, 4, c->big);
    return STATUS_OK;
}

static enum status open_cache(struct frames *f, struct message *why)
{
    struct cache *c = f->state;
    unsigned char head[32];
    enum status st = STATUS_OK;

    CALL(frames_file_open(f->path, &c->file, why));
    c->big = !frames_file_read(&c->file, head, 12) || memcmp(head, "POINTCACHE2", 12) != 0;
    if (c->big)
        frames_file_go(&c->file, 0, 1);
    if (!(c->big ? frames_file_read(&c->file, head, 8)
                 : frames_file_read(&c->file, head + 12, 20)))
        return status_fail(why, STATUS_INPUT, "%s: ends within its header", f->path);
    const unsigned long points = frames_file_whole(head + (c->big ? 4 : 16), 4, c->big),
                        frames = frames_file_whole(head + (c->big ? 0 : 28), 4, c->big);
    const unsigned long long whole =
        (c->big ? 8 + 4 * (unsigned long long)frames : 32) + 12ULL * points * frames;
    if (points > FRAMES_MOST_VERTICES || frames < 1 || frames > FRAMES_MOST_TIMES ||
        (unsigned long long)c->file.size < whole)
        return status_fail(
            why, STATUS_INPUT,
            "%s: counts %lu frames of %lu points, and has %lld bytes; as many "
            "as it counts would be right",
            f->path, frames, points, c->file.size);
    if (!c->big)
        c->rate = frames_file_float(head + 24, 4, false);
    c->rate = c->rate > 0 && c->rate < 1 ? c->rate : 0;
    f->timed = c->big || c->rate > 0;
    f->count = (int)frames;
    CALL(frames_room(f, (long)points, why));
    c->bytes = arena_take(&f->arena, (size_t)points, 12);
    c->times = c->big ? arena_take(&f->arena, (size_t)frames, 4) : NULL;
    if (c->big && !frames_file_read(&c->file, c->times, 4 * (size_t)frames))
        st = status_fail(why, STATUS_INPUT, "%s: ends within its times", f->path);
    return st;
}

const struct frames_reader frames_cache = {sizeof(struct cache), open_cache, next_cache,
                                           close_cache};
