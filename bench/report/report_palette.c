/* report_palette.c - PNG (W3C 2003): chunks; rows behind the number of their filter. */
#include "bench/report/report_palette.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

enum { COLOURS = 256, BINS = 1 << 15, SIDE_MOST = 8192, HEAD = 13, CHUNK = 12, SIGN = 8 };
static const unsigned char head_end[5] = {8, 2, 0, 0, 0}; /* 8 bits, RGB, not interlaced */

struct picture {
    size_t width, height;
    unsigned char *row; /* [height][1 + 3 width]: the filter, then r, g, b         owned */
};

static uint32_t number_at(const unsigned char *b)
{
    return (uint32_t)b[0] << 24 | (uint32_t)b[1] << 16 | (uint32_t)b[2] << 8 | b[3];
}

/* Its data, from chunks of it that follow one another; false: that is not all of it. */
static bool inflate_rows(const unsigned char *png, size_t size, struct picture *p)
{
    const size_t wanted = p->height * (1 + 3 * p->width);
    z_stream z = {.next_out = p->row, .avail_out = (uInt)wanted};
    int code = inflateInit(&z);

    for (size_t at = SIGN; code == Z_OK && at + CHUNK <= size;) {
        const size_t length = number_at(png + at);
        if (length > size - at - CHUNK)
            break;
        if (!memcmp(png + at + 4, "IDAT", 4)) {
            z.next_in = (unsigned char *)(uintptr_t)(png + at + 8);
            z.avail_in = (uInt)length;
            code = inflate(&z, Z_NO_FLUSH);
        }
        at += length + CHUNK;
    }
    inflateEnd(&z);
    return z.total_out == wanted;
}

static int paeth(int left, int up, int corner)
{
    const int to_left = abs(up - corner), to_up = abs(left - corner),
              to_corner = abs(left + up - 2 * corner);

    return to_left <= to_up && to_left <= to_corner ? left
           : to_up <= to_corner                     ? up
                                                    : corner;
}

/* Rows as they were before they were filtered; false: by a filter that there is not. */
static bool unfilter(struct picture *p)
{
    const size_t stride = 1 + 3 * p->width;

    for (size_t y = 0; y < p->height; y++) {
        unsigned char *row = p->row + y * stride + 1;
        const unsigned char *above = y ? row - stride : NULL;
        if (row[-1] > 4)
            return false;
        for (size_t k = 0; k < 3 * p->width; k++) {
            const int left = k < 3 ? 0 : row[k - 3], up = above ? above[k] : 0,
                      corner = k < 3 || !above ? 0 : above[k - 3];
            const int guess[] = {0, left, up, (left + up) / 2, paeth(left, up, corner)};
            row[k] = (unsigned char)(row[k] + guess[row[-1]]);
        }
    }
    return true;
}

static bool read_rows(const unsigned char *png, size_t size, struct picture *p)
{
    if (size < SIGN + CHUNK + HEAD || memcmp(png + SIGN + 4, "IHDR", 4) != 0 ||
        memcmp(png + SIGN + 16, head_end, sizeof head_end) != 0)
        return false;
    p->width = number_at(png + SIGN + 8);
    p->height = number_at(png + SIGN + 12);
    if (!p->width || !p->height || p->width > SIDE_MOST || p->height > SIDE_MOST)
        return false;
    p->row = malloc(p->height * (1 + 3 * p->width));
    return p->row && inflate_rows(png, size, p) && unfilter(p);
}

/* A colour's bin, five bits of each component. */
struct bin {
    long count, sum[3];
    int number; /* of the bin                                                      */
};

static long mean(const struct bin *bin, int component)
{
    return (bin->sum[component] + bin->count / 2) / bin->count;
}

static int bin_of(const unsigned char *rgb)
{
    return rgb[0] >> 3 << 10 | rgb[1] >> 3 << 5 | rgb[2] >> 3;
}

static int by_count(const void *a, const void *b)
{
    const struct bin *one = a, *other = b;

    return one->count != other->count
               ? (one->count < other->count) - (one->count > other->count)
               : one->number - other->number;
}

/* The colours that stand for most pixels, and of every bin which is the nearest. */
static void choose(struct bin *bin, unsigned char palette[COLOURS][3],
                   unsigned char *nearest)
{
    qsort(bin, BINS, sizeof *bin, by_count);
    for (int n = 0; n < COLOURS; n++)
        for (int c = 0; c < 3; c++)
            palette[n][c] = (unsigned char)(bin[n].count ? mean(&bin[n], c) : 0);
    for (int n = 0; n < BINS && bin[n].count; n++) {
        long least = -1;
        for (int k = 0; k < COLOURS; k++) {
            long far = 0;
            for (int c = 0; c < 3; c++) {
                const long d = mean(&bin[n], c) - palette[k][c];
                far += d * d;
            }
            if (least < 0 || far < least)
                least = far, nearest[bin[n].number] = (unsigned char)k;
        }
    }
}

/* Rows of one byte a pixel, in place; false: memory is out. */
static bool index_rows(struct picture *p, unsigned char palette[COLOURS][3])
{
    struct bin *bin = calloc(BINS, sizeof *bin);
    unsigned char *nearest = calloc(BINS, 1), *to = p->row;
    const size_t stride = 1 + 3 * p->width;

    for (size_t y = 0; bin && nearest && y < p->height; y++)
        for (size_t x = 0; x < p->width; x++) {
            const unsigned char *rgb = p->row + y * stride + 1 + 3 * x;
            struct bin *of = &bin[bin_of(rgb)];
            of->count++;
            for (int c = 0; c < 3; c++)
                of->sum[c] += rgb[c];
        }
    for (int n = 0; bin && n < BINS; n++)
        bin[n].number = n;
    if (bin && nearest) {
        choose(bin, palette, nearest);
        for (size_t y = 0; y < p->height; y++) {
            const unsigned char *row = p->row + y * stride + 1;
            *to++ = 0; /* no filter: colours' numbers are no quantities */
            for (size_t x = 0; x < p->width; x++)
                *to++ = nearest[bin_of(row + 3 * x)];
        }
    }
    const bool good = bin && nearest;
    free(bin);
    free(nearest);
    return good;
}

static unsigned char *put_number(unsigned char *to, uint32_t number)
{
    for (int k = 0; k < 4; k++)
        *to++ = (unsigned char)(number >> (24 - 8 * k));
    return to;
}

/* A chunk around `size` bytes that are there already, 8 behind `to`; its end. */
static unsigned char *put_chunk(unsigned char *to, const char *kind, size_t size)
{
    put_number(to, (uint32_t)size);
    memcpy(to + 4, kind, 4);
    return put_number(to + 8 + size, (uint32_t)crc32(0, to + 4, (uInt)(4 + size)));
}

/* The picture in its palette. */
static unsigned char *write_rows(const unsigned char *png, const struct picture *p,
                                 unsigned char palette[COLOURS][3], size_t *packed)
{
    const uLong raw = (uLong)(p->height * (1 + p->width));
    uLong size = compressBound(raw);
    unsigned char *made = malloc(SIGN + 4 * CHUNK + HEAD + 3 * COLOURS + size), *to = made;

    if (!made)
        return NULL;
    memcpy(to, png, SIGN + 8 + HEAD);
    to[SIGN + 8 + 9] = 3; /* of a palette */
    to = put_chunk(to + SIGN, "IHDR", HEAD);
    memcpy(to + 8, palette, 3 * COLOURS);
    to = put_chunk(to, "PLTE", 3 * COLOURS);
    if (compress2(to + 8, &size, p->row, raw, Z_BEST_COMPRESSION) != Z_OK) {
        free(made);
        return NULL;
    }
    to = put_chunk(to, "IDAT", size);
    *packed = (size_t)(put_chunk(to, "IEND", 0) - made);
    return made;
}

unsigned char *report_palette_pack(const unsigned char *png, size_t size, size_t *packed)
{
    unsigned char palette[COLOURS][3], *made = NULL;
    struct picture p = {0};
    size_t smaller = 0;

    if (read_rows(png, size, &p) && index_rows(&p, palette))
        made = write_rows(png, &p, palette, &smaller);
    free(p.row);
    if (made && smaller < size) {
        *packed = smaller;
        return made;
    }
    free(made);
    return NULL;
}
