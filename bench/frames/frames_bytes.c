#define _DEFAULT_SOURCE /* madvise */
#include "bench/frames/frames_bytes.h"

#include <errno.h>
#include <fcntl.h>
#include <float.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

enum { PAGES = 1 << 22 }; /* so many bytes are let go of at once */

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

/* What strtod says of as much as may be a number: the text has no end of its own. 767
 * digits tell the last bit of any. */
static bool slow_number(const char **p, const char *end, double *x)
{
    char room[1024], *stop;
    size_t size = 0;

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

/* Digits taken up, as many as fit, and how many do not. */
static int digits(const char **p, const char *end, uint64_t *mantissa, int *left)
{
    int count = 0;

    for (; *p < end && **p >= '0' && **p <= '9'; ++*p, count++)
        if (*mantissa < UINT64_C(1000000000000000000))
            *mantissa = 10 * *mantissa + (uint64_t)(**p - '0');
        else
            ++*left;
    return count;
}

/* e and a whole number, if they are there. */
static int exponent(const char **p, const char *end)
{
    const char *at = *p;
    int power = 0;

    if (at == end || (*at != 'e' && *at != 'E'))
        return 0;
    at++;
    const bool minus = at < end && *at == '-';
    at += at < end && (*at == '-' || *at == '+');
    if (at == end || *at < '0' || *at > '9')
        return 0;
    for (; at < end && *at >= '0' && *at <= '9'; at++)
        power = power < 10000 ? 10 * power + *at - '0' : power;
    *p = at;
    return minus ? -power : power;
}

enum { EXACT = 27 }; /* 10^27 = 2^27 5^27, and 5^27 has 63 bits */
#define TEN(n) 1e##n##L
static const long double tens[EXACT + 1] = {
    TEN(0),  TEN(1),  TEN(2),  TEN(3),  TEN(4),  TEN(5),  TEN(6),
    TEN(7),  TEN(8),  TEN(9),  TEN(10), TEN(11), TEN(12), TEN(13),
    TEN(14), TEN(15), TEN(16), TEN(17), TEN(18), TEN(19), TEN(20),
    TEN(21), TEN(22), TEN(23), TEN(24), TEN(25), TEN(26), TEN(27)};

/* The mantissa and such a power of ten are exact in 64 bits (Clinger, PLDI 1990): their
 * quotient or product is off by half its last place. False: rounded to a double that may
 * be the wrong one of two, or 64 bits are not to be had. */
static bool fast_number(uint64_t mantissa, int power, double *x)
{
    if (LDBL_MANT_DIG < 64 || abs(power) > EXACT)
        return false;
    const long double value = power < 0 ? (long double)mantissa / tens[-power]
                                        : (long double)mantissa * tens[power];
    const long double place = value * LDBL_EPSILON;

    *x = (double)(value - place);
    return *x == (double)(value + place);
}

bool frames_text_number(const char **p, const char *end, double *x)
{
    const char *at;
    uint64_t mantissa = 0;
    int count, power, left = 0;

    while (*p < end && is_blank(**p))
        ++*p;
    at = *p;
    const bool minus = at < end && *at == '-';
    at += at < end && (*at == '-' || *at == '+');
    count = digits(&at, end, &mantissa, &left);
    power = 0;
    if (at < end && *at == '.') {
        at++;
        power = -digits(&at, end, &mantissa, &left);
        count -= power;
    }
    power += exponent(&at, end);
    if (!count || left || (at < end && (*at == 'x' || *at == 'X')) ||
        !fast_number(mantissa, power, x))
        return slow_number(p, end, x);
    *x = minus ? -*x : *x;
    *p = at;
    return true;
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
