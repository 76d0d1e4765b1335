#include "bench/frames/frames_file.h"

#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "models/reader/input_file.h"

static enum status fail(const char *path, struct message *why)
{
    return status_fail(why, STATUS_FILE, "%s: %s", path, strerror(errno));
}

enum status frames_file_open(const char *path, struct frames_file *f, struct message *why)
{
    struct stat about;
    const char *reason;
    enum status st = STATUS_OK;

    *f = (struct frames_file){.path = strdup(path)};
    TRY(f->path ? STATUS_OK : STATUS_MEMORY);
    f->file = input_file_open(path, &reason);
    if (!f->file)
        TRY(status_fail(why, STATUS_FILE, "%s: %s", path, reason));
    if (fstat(fileno(f->file), &about))
        TRY(fail(path, why));
    if (about.st_size == 0)
        TRY(status_fail(why, STATUS_INPUT, "%s: is empty", path));
    f->size = about.st_size;
out:
    if (st != STATUS_OK)
        frames_file_close(f);
    return st;
}

void frames_file_close(struct frames_file *f)
{
    if (f->file)
        fclose(f->file);
    free(f->path);
    free(f->text);
    *f = (struct frames_file){0};
}

enum status frames_file_line(struct frames_file *f, bool *more, struct message *why)
{
    f->at = f->next;
    ssize_t length = getline(&f->text, &f->room, f->file);
    *more = length >= 0;
    if (!*more)
        return feof(f->file)     ? STATUS_OK
               : errno == ENOMEM ? STATUS_MEMORY
                                 : fail(f->path, why);
    f->line++;
    f->next += length;
    length -= f->text[length - 1] == '\n';
    length -= length > 0 && f->text[length - 1] == '\r';
    f->text[length] = '\0';
    if (f->line == 1 && length >= 3 && !memcmp(f->text, "\xEF\xBB\xBF", 3))
        memmove(f->text, f->text + 3, (size_t)(length -= 3) + 1); /* a byte-order mark */
    for (char *zero = f->text;
         (zero = memchr(zero, '\0', (size_t)(f->text + length - zero)));)
        *zero = '?';
    return STATUS_OK;
}

void frames_file_go(struct frames_file *f, long long at, long line)
{
    if (f->next != at)
        fseeko(f->file, at, SEEK_SET);
    f->next = at;
    f->line = line - 1;
}

bool frames_file_read(struct frames_file *f, void *bytes, size_t size)
{
    const size_t read = fread(bytes, 1, size, f->file);

    f->next += (long long)read;
    return read == size;
}

bool frames_file_number(char **p, double *x)
{
    char *end;

    *x = strtod(*p, &end);
    const bool is = end != *p;
    *p = end;
    return is;
}

unsigned long frames_file_whole(const unsigned char *p, int size, bool big)
{
    unsigned long x = 0;

    for (int n = 0; n < size; n++)
        x = x << 8 | p[big ? n : size - 1 - n];
    return x;
}

/* Returns the number of IEEE 754's 16 bits: sign, 5 bits of exponent, 10 of fraction. */
static double half_float(unsigned long bits)
{
    const int exponent = (int)(bits >> 10 & 31), fraction = (int)(bits & 1023);
    const double size = exponent == 31 ? (fraction ? NAN : INFINITY)
                        : exponent     ? ldexp(1024 + fraction, exponent - 25)
                                       : ldexp(fraction, -24);

    return bits >> 15 ? -size : size;
}

double frames_file_float(const unsigned char *p, int size, bool big)
{
    const uint64_t bits = frames_file_whole(p, size, big);
    const uint32_t half = (uint32_t)bits;
    float single;
    double x;

    memcpy(&x, &bits, sizeof x);
    memcpy(&single, &half, sizeof single);
    return size == 8 ? x : size == 4 ? (double)single : half_float(bits);
}
