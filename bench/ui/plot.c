#include "bench/ui/plot.h"

#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

enum { NOT_FOUND = 127 };

enum status plot_run(const char *folder, const char *script, struct message *why)
{
    int code;
    pid_t child = fork();

    if (child < 0)
        return status_fail(why, STATUS_LIBRARY, "gnuplot cannot be started");
    if (child == 0) {
        if (chdir(folder) == 0)
            execlp("gnuplot", "gnuplot", script, (char *)NULL);
        _exit(NOT_FOUND);
    }
    if (waitpid(child, &code, 0) < 0 || !WIFEXITED(code))
        return status_fail(why, STATUS_LIBRARY, "gnuplot was ended by a signal");
    if (WEXITSTATUS(code) == NOT_FOUND)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "no plot: gnuplot is not installed (Debian: gnuplot-nox)");
    if (WEXITSTATUS(code))
        return status_fail(why, STATUS_LIBRARY, "gnuplot failed on %s/%s", folder, script);
    return STATUS_OK;
}
