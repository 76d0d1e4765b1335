#include "bench/files/seal.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <zlib.h>

#include "bench/files/output.h"

/* The seal holds length and CRC-32 (ISO 3309) of what follows; the block's rest is zero. */
#define SEAL      "clothbench result file, sealed: %ld bytes, crc32 %08lx\n"
#define SEAL_MARK "clothbench result file, sealed: "

static enum status fail(const char *path, const char *doing, struct message *why)
{
    return status_fail(why, STATUS_FILE, "%s: cannot be %s: %s", path, doing,
                       strerror(errno));
}

/* Computes length and checksum of the file behind the block. */
static enum status sum(FILE *file, long *length, unsigned long *crc)
{
    static unsigned char part[1 << 16];
    size_t got;

    *length = 0;
    *crc = crc32(0, NULL, 0);
    if (fseek(file, SEAL_BLOCK, SEEK_SET) != 0)
        return STATUS_FILE;
    while ((got = fread(part, 1, sizeof part, file)) > 0) {
        *crc = crc32(*crc, part, (unsigned)got);
        *length += (long)got;
    }
    return ferror(file) ? STATUS_FILE : STATUS_OK;
}

enum status seal_write(const char *path, struct message *why)
{
    FILE *file = fopen(path, "r+b");
    char block[SEAL_BLOCK] = "";
    enum status st = STATUS_OK;
    unsigned long crc;
    long length;

    if (!file)
        return fail(path, "written", why);
    if (sum(file, &length, &crc) != STATUS_OK)
        TRY(fail(path, "read", why));
    snprintf(block, sizeof block, SEAL, length, crc);
    if (fseek(file, 0, SEEK_SET) != 0 || fwrite(block, sizeof block, 1, file) != 1)
        st = fail(path, "written", why);
out:
    if (fclose(file) != 0 && st == STATUS_OK)
        st = fail(path, "written", why);
    return st;
}

static enum status compare(const char *path, FILE *file, long *size, struct message *why)
{
    char block[SEAL_BLOCK], wanted[SEAL_BLOCK] = "";
    unsigned long crc;
    long length;

    if (fread(block, sizeof block, 1, file) != 1 ||
        strncmp(block, SEAL_MARK, strlen(SEAL_MARK)) != 0)
        return status_fail(
            why, STATUS_INPUT,
            "%s: is not a result file of this program (its first line has no "
            "seal); run again what made it",
            path);
    if (sum(file, &length, &crc) != STATUS_OK)
        return fail(path, "read", why);
    snprintf(wanted, sizeof wanted, SEAL, length, crc);
    *size = length + SEAL_BLOCK;
    return memcmp(block, wanted, sizeof block) == 0
               ? STATUS_OK
               : status_fail(why, STATUS_INPUT,
                             "%s: is damaged: it is no longer what its first line says it "
                             "was; run again what made it",
                             path);
}

enum status seal_check(const char *path, long *size, struct message *why)
{
    struct stat info;
    FILE *file = NULL;
    enum status st;

    if (stat(path, &info) != 0)
        return fail(path, "read", why);
    if (!S_ISREG(info.st_mode)) /* opening a pipe would wait for its writer */
        return status_fail(why, STATUS_INPUT, "%s: is not a result file, not even a file",
                           path);
    file = fopen(path, "rb");
    if (!file)
        return fail(path, "read", why);
    st = compare(path, file, size, why);
    fclose(file);
    return st;
}

/* --- texts ---------------------------------------------------------------------------- */

#define TEXT_SEAL "sealed: %zu bytes, crc32 %08lx\n"
enum { SEAL_MOST = 64, SIZE_MOST = 1 << 16 };

unsigned long seal_text_sum(unsigned long before, const void *bytes, size_t size)
{
    return crc32(before, bytes, (unsigned)size);
}

enum status seal_text_program(unsigned long *sum, struct message *why)
{
    static const char path[] = "/proc/self/exe";
    char part[1 << 14];
    size_t got;
    FILE *file = fopen(path, "r");

    if (!file)
        return fail(path, "read", why);
    *sum = 0;
    while ((got = fread(part, 1, sizeof part, file)) > 0)
        *sum = seal_text_sum(*sum, part, got);
    fclose(file);
    return STATUS_OK;
}

static void seal_of(const char *text, size_t size, char seal[SEAL_MOST])
{
    snprintf(seal, SEAL_MOST, TEXT_SEAL, size, seal_text_sum(0, text, size));
}

enum status seal_text_write(const char *path, const char *text, struct message *why)
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

/* Whether text[size] ends in its seal, which is then cut off. */
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

enum status seal_text_read(const char *path, char **text, struct message *why)
{
    struct stat info;
    FILE *file = NULL;
    char *bytes = NULL;
    size_t size = 0;
    enum status st = STATUS_OK;

    if (stat(path, &info) != 0)
        return fail(path, "read", why);
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
