#define _DEFAULT_SOURCE /* madvise */
#include "bench/frames/frames_bytes.h"

#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

enum { PAGES = 1 << 22 }; /* bytes that are released at once */

static enum status map(int file, struct frames_bytes *b, struct message *why)
{
    struct stat about;
    void *at;

    if (fstat(file, &about))
        return status_fail(why, STATUS_FILE, "%s: %s", b->path, strerror(errno));
    if (!S_ISREG(about.st_mode))
        return status_fail(why, STATUS_FILE, "%s: is no regular file", b->path);
    if (about.st_size == 0)
        return status_fail(why, STATUS_INPUT, "%s: is empty", b->path);
    b->size = (size_t)about.st_size;
    at = mmap(NULL, b->size, PROT_READ, MAP_PRIVATE, file, 0);
    if (at == MAP_FAILED)
        return status_fail(why, STATUS_FILE, "%s: %s", b->path, strerror(errno));
    b->byte = at;
    return STATUS_OK;
}

enum status frames_bytes_open(const char *path, struct frames_bytes *b, struct message *why)
{
    enum status st;
    int file = -1;

    *b = (struct frames_bytes){.path = strdup(path)};
    if (!b->path)
        return STATUS_MEMORY;
    file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK); /* a pipe must not wait */
    if (file < 0)
        TRY(status_fail(why, STATUS_FILE, "%s: %s", path, strerror(errno)));
    TRY(map(file, b, why));
out:
    if (file >= 0)
        close(file);
    if (st != STATUS_OK)
        frames_bytes_close(b);
    return st;
}

void frames_bytes_close(struct frames_bytes *b)
{
    if (b->byte)
        munmap((void *)(uintptr_t)b->byte, b->size);
    free(b->path);
    *b = (struct frames_bytes){0};
}

void frames_bytes_forget(struct frames_bytes *b, size_t until)
{
    const size_t whole = until / PAGES * PAGES;

    if (whole <= b->forgotten)
        return;
    madvise((void *)(uintptr_t)(b->byte + b->forgotten), whole - b->forgotten,
            MADV_DONTNEED);
    b->forgotten = whole;
}

void *frames_bytes_grow(void *array, int *room, int count, size_t size)
{
    const int next = *room < 1024 ? 1024 : *room + *room / 2;
    void *more;

    if (count < *room)
        return array;
    more = realloc(array, (size_t)next * size);
    if (more)
        *room = next;
    return more;
}

unsigned long frames_bytes_whole(const unsigned char *p, int size, bool big)
{
    unsigned long x = 0;

    for (int n = 0; n < size; n++)
        x = x << 8 | p[big ? n : size - 1 - n];
    return x;
}

double frames_bytes_float(const unsigned char *p, int size, bool big)
{
    const uint64_t bits = frames_bytes_whole(p, size, big);
    const uint32_t half = (uint32_t)bits;
    float single;
    double x;

    if (size == 8) {
        memcpy(&x, &bits, sizeof x);
        return x;
    }
    memcpy(&single, &half, sizeof single);
    return (double)single;
}

struct frames_text frames_text_of(const struct frames_bytes *b)
{
    return (struct frames_text){(const char *)b->byte, (const char *)b->byte + b->size, 0};
}

bool frames_text_line(struct frames_text *text, const char **line, const char **end)
{
    const char *stop;

    if (text->at >= text->end)
        return false;
    stop = memchr(text->at, '\n', (size_t)(text->end - text->at));
    *line = text->at;
    *end = stop ? stop : text->end;
    text->at = stop ? stop + 1 : text->end;
    text->line++;
    if (*end > *line && (*end)[-1] == '\r')
        --*end;
    return true;
}

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

/* Copies as much as may be a number for strtod, since the text has no end of its own. 767
 * digits determine the last bit of any number. */
bool frames_text_number(const char **p, const char *end, double *x)
{
    char room[1024], *stop;
    size_t size = 0;

    while (*p < end && is_blank(**p))
        ++*p;
    for (const char *c = *p; c < end && size < sizeof room - 1; c++) {
        if (is_blank(*c) || *c == ',')
            break;
        room[size++] = *c;
    }
    room[size] = '\0';
    *x = strtod(room, &stop);
    *p += stop - room;
    return stop != room;
}

int frames_text_word(const char **p, const char *end, const char **word)
{
    while (*p < end && is_blank(**p))
        ++*p;
    *word = *p;
    while (*p < end && !is_blank(**p))
        ++*p;
    return (int)(*p - *word);
}
