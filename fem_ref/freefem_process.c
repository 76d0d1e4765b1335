#include "fem_ref/freefem_process.h"

#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

/* Debian's FreeFEM looks for plug-ins under another version's path: tell it. Threads spin
 * over each other on small systems. */
static const char *const setting[] = {
    "FF_LOADPATH=/usr/lib/freefem++;./",
    "FF_INCLUDEPATH=/usr/include/freefem++/idp;;",
    "OMP_NUM_THREADS=1",
    "OPENBLAS_NUM_THREADS=1",
    "LC_ALL=C",
};
enum { SETTINGS = sizeof setting / sizeof *setting };

enum status freefem_process_open(struct freefem_process_folder *folder, struct message *why)
{
    struct freefem_process_folder f;
    const char *parent = getenv("TMPDIR");
    int length = snprintf(f.path, sizeof f.path, "%s/clothbench_XXXXXX",
                          parent && *parent ? parent : "/tmp");

    if (length >= (int)sizeof f.path || !mkdtemp(f.path))
        return status_fail(why, STATUS_FILE, "no temporary folder in %s: %s",
                           parent && *parent ? parent : "/tmp", strerror(errno));
    snprintf(f.out, sizeof f.out, "%s/field.csv", f.path);
    snprintf(f.log, sizeof f.log, "%s/log", f.path);
    *folder = f;
    return STATUS_OK;
}

void freefem_process_close(struct freefem_process_folder *folder)
{
    if (*folder->path) {
        unlink(folder->out);
        unlink(folder->log);
        rmdir(folder->path);
    }
    *folder = (struct freefem_process_folder){0};
}

/* Our environment with the settings in place of variables of the same name. The strings
 * are borrowed; free the list only. */
static char **make_environment(void)
{
    int count = 0, used = 0;
    while (environ[count])
        count++;
    char **list = calloc(count + SETTINGS + 1, sizeof *list);
    for (int i = 0; list && i < count; i++) {
        bool replaced = false;
        for (int k = 0; k < SETTINGS; k++) {
            size_t name = strchr(setting[k], '=') - setting[k] + 1;
            replaced = replaced || !strncmp(environ[i], setting[k], name);
        }
        if (!replaced)
            list[used++] = environ[i];
    }
    for (int k = 0; list && k < SETTINGS; k++)
        list[used++] = (char *)setting[k];
    return list;
}

/* Last line with words in it, of the last kilobyte of the log. */
static void last_line(const char *path, char *line, size_t size)
{
    char buffer[1024];
    size_t got = 0;
    FILE *file = fopen(path, "rb");

    snprintf(line, size, "nothing was said");
    if (!file)
        return;
    if (fseek(file, -(long)sizeof buffer + 1, SEEK_END))
        rewind(file);
    got = fread(buffer, 1, sizeof buffer - 1, file);
    fclose(file);
    buffer[got] = 0;
    for (char *at = strtok(buffer, "\n"); at; at = strtok(NULL, "\n"))
        if (at[strspn(at, " \t\r")])
            snprintf(line, size, "%s", at + strspn(at, " \t\r"));
}

/* 0, or the errno of the failure to start. */
static int spawn(const struct freefem_process_folder *folder, const char *const *argument,
                 pid_t *child)
{
    const int create = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_t files;
    char **environment = make_environment();
    int error = environment ? posix_spawn_file_actions_init(&files) : ENOMEM;

    if (!error) {
        error = posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
        if (!error)
            error = posix_spawn_file_actions_addopen(&files, 1, folder->log, create, 0600);
        if (!error)
            error = posix_spawn_file_actions_adddup2(&files, 1, 2);
        if (!error)
            error = posix_spawnp(child, argument[0], &files, NULL, (char *const *)argument,
                                 environment);
        posix_spawn_file_actions_destroy(&files);
    }
    free(environment);
    return error;
}

enum status freefem_process_run(const struct freefem_process_folder *folder,
                                const char *const *argument, struct message *why)
{
    pid_t child = 0;
    int end = 0, error = spawn(folder, argument, &child);
    char line[512];

    if (error == ENOENT)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "%s is not installed (Debian: freefem++ libfreefem++ "
                           "libfreefem++-dev)",
                           argument[0]);
    if (error)
        return status_fail(why, STATUS_LIBRARY, "%s does not start: %s", argument[0],
                           strerror(error));
    while (waitpid(child, &end, 0) < 0)
        if (errno != EINTR)
            return status_fail(why, STATUS_LIBRARY, "%s was lost: %s", argument[0],
                               strerror(errno));
    if (WIFEXITED(end) && WEXITSTATUS(end) == 0)
        return STATUS_OK;
    last_line(folder->log, line, sizeof line);
    if (WIFSIGNALED(end))
        return status_fail(why, STATUS_LIBRARY, "%s was killed by signal %d: %s",
                           argument[0], WTERMSIG(end), line);
    return status_fail(why, STATUS_LIBRARY, "%s ended with exit code %d: %s", argument[0],
                       WEXITSTATUS(end), line);
}
