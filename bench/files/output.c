#include "bench/files/output.h"

#include <errno.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/atomic_file.h"

struct output {
    struct atomic_file target;
    FILE *file;
};

enum status output_create(const char *path, struct output **out, struct message *why)
{
    struct output *o SCOPED(output_discard_scope) = calloc(1, sizeof *o);

    if (!o)
        return STATUS_MEMORY;
    CALL(atomic_file_open(path, &o->target, why));
    o->file = fopen(o->target.temporary, "w");
    if (!o->file)
        return status_fail(why, STATUS_FILE, "%s: cannot be opened: %s", path,
                           strerror(errno));
    *out = o, o = NULL;
    return STATUS_OK;
}

enum status output_create_in(const char *folder, const char *name, struct output **out,
                             struct message *why)
{
    char path[4096];

    snprintf(path, sizeof path, "%s%s%s", folder ? folder : "", folder ? "/" : "", name);
    atomic_file_claim(path);
    return output_create(path, out, why);
}

void output_print(struct output *out, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    vfprintf(out->file, format, args);
    va_end(args);
}

int output_digits(double value)
{
    char text[32];

    for (int digits = 15; digits < 17; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, value);
        if (strtod(text, NULL) == value)
            return digits;
    }
    return 17;
}

FILE *output_stream(struct output *out)
{
    return out->file;
}

/* Closes a stream. Returns false if a write to it failed; *reason is then errno, or 0 if it
 * is not known any more. */
static bool close_checked(FILE *file, int *reason)
{
    bool failed = ferror(file);

    /* glibc keeps what it could not write, so that flushing again fails for the same
     * reason; should it have dropped that, writing a blank fails for it */
    errno = 0;
    if (failed)
        fputc(' ', file);
    failed = fflush(file) != 0 || failed;
    *reason = errno;
    if (fclose(file) != 0 && errno != EBADF && !failed) {
        failed = true;
        *reason = errno;
    }
    return !failed;
}

enum status output_close(struct output **created, struct message *why)
{
    struct output *out SCOPED(output_discard_scope) = *created;
    FILE *file = out->file;
    int reason;

    *created = NULL;
    out->file = NULL;
    if (!close_checked(file, &reason))
        return status_fail(why, STATUS_FILE, "%s: cannot be written: %s", out->target.path,
                           strerror(reason ? reason : EIO));
    return atomic_file_commit(&out->target, why);
}

void output_discard(struct output *out)
{
    if (!out)
        return;
    if (out->file)
        fclose(out->file);
    atomic_file_discard(&out->target);
    free(out);
}

void output_keep_after_closed_pipe(void)
{
    signal(SIGPIPE, SIG_IGN);
    signal(SIGXFSZ, SIG_IGN);
}

enum status output_close_standard(struct message *why)
{
    int reason;

    if (close_checked(stdout, &reason))
        return STATUS_OK;
    if (reason == EPIPE)
        return status_fail(why, STATUS_FILE,
                           "standard output: its reader closed the pipe before the end");
    return status_fail(why, STATUS_FILE, "standard output: cannot be written: %s",
                       reason ? strerror(reason) : "an earlier write failed");
}
