#include "bench/files/seal.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <zlib.h>

#include "bench/files/output.h"
#include "models/reader/input_file.h"

/* The seal holds length and CRC-32 (ISO 3309) of what follows; the block's rest is zero. */
#define SEAL      "clothbench result file, sealed: %ld bytes, crc32 %08lx\n"
#define SEAL_MARK "clothbench result file, sealed: "

static enum status fail(const char *path, const char *doing, struct message *why)
{
    return status_fail(why, STATUS_FILE, "%s: cannot be %s: %s", path, doing,
                       strerror(errno));
}

/* Computes length and checksum of the rest of a file. */
static enum status sum_rest(const char *path, FILE *file, long *length, unsigned long *crc,
                            struct message *why)
{
    static unsigned char part[1 << 16];
    size_t got;

    *length = 0;
    *crc = crc32(0, NULL, 0);
    while ((got = fread(part, 1, sizeof part, file)) > 0) {
        *crc = crc32(*crc, part, (unsigned)got);
        *length += (long)got;
    }
    return ferror(file) ? fail(path, "read", why) : STATUS_OK;
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
    if (fseek(file, SEAL_BLOCK, SEEK_SET) != 0)
        TRY(fail(path, "read", why));
    TRY(sum_rest(path, file, &length, &crc, why));
    snprintf(block, sizeof block, SEAL, length, crc);
    if (fseek(file, 0, SEEK_SET) != 0 || fwrite(block, sizeof block, 1, file) != 1)
        st = fail(path, "written", why);
out:
    if (fclose(file) != 0 && st == STATUS_OK)
        st = fail(path, "written", why);
    return st;
}

enum status seal_check(const char *path, long *size, struct message *why)
{
    char block[SEAL_BLOCK], wanted[SEAL_BLOCK] = "";
    unsigned long crc;
    const char *reason;
    FILE *file = input_file_open(path, &reason);
    enum status st = STATUS_OK;

    if (!file)
        return status_fail(why, STATUS_FILE, "%s: cannot be read: %s", path, reason);
    if (fread(block, sizeof block, 1, file) != 1 ||
        strncmp(block, SEAL_MARK, strlen(SEAL_MARK)) != 0)
        TRY(status_fail(why, STATUS_INPUT,
                        "%s: is not a result file of this program (its first line has no "
                        "seal); run again what made it",
                        path));
    TRY(sum_rest(path, file, size, &crc, why));
    snprintf(wanted, sizeof wanted, SEAL, *size, crc);
    *size += SEAL_BLOCK;
    if (memcmp(block, wanted, sizeof block) != 0)
        TRY(status_fail(why, STATUS_INPUT,
                        "%s: is damaged: it is no longer what its first line says it was; "
                        "run again what made it",
                        path));
out:
    fclose(file);
    return st;
}

unsigned long seal_sum(unsigned long before, const void *bytes, size_t size)
{
    return size ? crc32(before, bytes, (unsigned)size) : before; /* of NULL it is 0 */
}
