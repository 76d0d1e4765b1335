#include "models/reader/input_file.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const char *kind_of(mode_t mode)
{
    return S_ISDIR(mode)    ? "it is a directory"
           : S_ISFIFO(mode) ? "it is a pipe, which can be read only once"
                            : "it is no regular file";
}

FILE *input_file_open(const char *path, const char **reason)
{
    struct stat about;
    FILE *file = NULL;
    const int fd = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);

    if (fd >= 0 && fstat(fd, &about) == 0 && !S_ISREG(about.st_mode)) {
        *reason = kind_of(about.st_mode);
        errno = EINVAL;
        close(fd);
        return NULL;
    }
    if (fd >= 0 && !(file = fdopen(fd, "rb")))
        close(fd);
    *reason = file ? "" : strerror(errno);
    return file;
}
