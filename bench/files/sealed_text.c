#include "bench/files/sealed_text.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <zlib.h>

#include "bench/files/output.h"

#define SEAL "sealed: %zu bytes, crc32 %08lx\n"
enum { SEAL_MOST = 64, SIZE_MOST = 1 << 16 };

unsigned long sealed_text_sum(unsigned long before, const void *bytes, size_t size)
{
    return crc32(before, bytes, (unsigned)size);
}

enum status sealed_text_program(unsigned long *sum, struct message *why)
{
    static const char path[] = "/proc/self/exe";
    char part[1 << 14];
    size_t got;
    FILE *file = fopen(path, "r");

    if (!file)
        return status_fail(why, STATUS_FILE, "%s: cannot be read: %s", path,
                           strerror(errno));
    *sum = 0;
    while ((got = fread(part, 1, sizeof part, file)) > 0)
        *sum = sealed_text_sum(*sum, part, got);
    fclose(file);
    return STATUS_OK;
}

static void seal_of(const char *text, size_t size, char seal[SEAL_MOST])
{
    snprintf(seal, SEAL_MOST, SEAL, size, sealed_text_sum(0, text, size));
}

enum status sealed_text_write(const char *path, const char *text, struct message *why)
{
    struct output *out = NULL;
    char seal[SEAL_MOST];
    enum status st = output_create(path, &out, why);

    if (st != STATUS_OK)
        return st;
    seal_of(text, strlen(text), seal);
    output_print(out, "%s%s", text, seal);
    return output_close(out, why);
}

/* Whether text[size] ends in its seal, which is cut off. */
static bool unseal(char *text, size_t size)
{
    char wanted[SEAL_MOST];
    size_t end = size ? size - 1 : 0;

    while (end && text[end - 1] != '\n')
        end--;
    seal_of(text, end, wanted);
    if (strlen(wanted) != size - end || memcmp(wanted, text + end, size - end) != 0)
        return false;
    text[end] = '\0';
    return strlen(text) == end;
}

enum status sealed_text_read(const char *path, char **text, struct message *why)
{
    struct stat info;
    FILE *file = NULL;
    char *bytes = NULL;
    size_t size = 0;
    enum status st = STATUS_OK;

    if (stat(path, &info) != 0)
        return status_fail(why, STATUS_FILE, "%s: cannot be read: %s", path,
                           strerror(errno));
    if (S_ISREG(info.st_mode)) /* opening a pipe would wait for its writer */
        file = fopen(path, "r");
    bytes = malloc(SIZE_MOST + 1);
    TRY(bytes ? STATUS_OK : STATUS_MEMORY);
    if (file)
        size = fread(bytes, 1, SIZE_MOST, file);
    if (!unseal(bytes, size))
        TRY(status_fail(why, STATUS_INPUT,
                        "%s: is damaged: it is no longer what its last line says it was",
                        path));
    *text = bytes, bytes = NULL;
out:
    if (file)
        fclose(file);
    free(bytes);
    return st;
}
