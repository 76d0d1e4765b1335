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
    int failure; /* errno of the first failed write, 0 if none */
};

enum status output_create(const char *path, struct output **out, struct message *why)
{
    enum status st = STATUS_OK;
    struct output *o = calloc(1, sizeof *o);

    if (!o)
        return STATUS_MEMORY;
    TRY(atomic_file_open(path, &o->target, why));
    o->file = fopen(o->target.temporary, "w");
    if (!o->file)
        TRY(status_fail(why, STATUS_FILE, "%s: cannot be opened: %s", path,
                        strerror(errno)));
    *out = o, o = NULL;
out:
    output_discard(o);
    return st;
}

void output_print(struct output *out, const char *format, ...)
{
    va_list args;

    if (out->failure)
        return;
    va_start(args, format);
    errno = 0;
    if (vfprintf(out->file, format, args) < 0)
        out->failure = errno ? errno : EIO;
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

enum status output_close(struct output *out, struct message *why)
{
    enum status st = STATUS_OK;

    errno = 0;
    const bool failed = ferror(out->file);
    if ((fclose(out->file) != 0 || failed) && !out->failure)
        out->failure = errno ? errno : EIO;
    out->file = NULL;
    if (out->failure)
        TRY(status_fail(why, STATUS_FILE, "%s: cannot be written: %s", out->target.path,
                        strerror(out->failure)));
    TRY(atomic_file_commit(&out->target, why));
out:
    output_discard(out);
    return st;
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
    bool failed = ferror(stdout);

    /* glibc keeps what it could not write, so that flushing again fails for the same
     * reason; should it have dropped that, writing a blank fails for it */
    errno = 0;
    if (failed)
        fputc(' ', stdout);
    if (fflush(stdout) != 0)
        failed = true;
    int reason = errno;
    if (fclose(stdout) != 0 && errno != EBADF && !failed) {
        failed = true;
        reason = errno;
    }
    if (!failed)
        return STATUS_OK;
    if (reason == EPIPE)
        return status_fail(why, STATUS_FILE,
                           "standard output: its reader closed the pipe before the end");
    return status_fail(why, STATUS_FILE, "standard output: cannot be written: %s",
                       reason ? strerror(reason) : "an earlier write failed");
}
