#define _GNU_SOURCE /* posix_spawn_file_actions_addchdir_np */
#include "fem_ref/program.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

/* Threads spin over each other on small systems; numbers have a decimal point. */
static const char *const always[] = {"OMP_NUM_THREADS=1", "OPENBLAS_NUM_THREADS=1",
                                     "LC_ALL=C", NULL};

void program_close(struct program_folder *folder)
{
    DIR *files = *folder->path ? opendir(folder->path) : NULL;
    const struct dirent *file;

    while (files && (file = readdir(files)))
        if (strcmp(file->d_name, ".") != 0 && strcmp(file->d_name, "..") != 0)
            unlinkat(dirfd(files), file->d_name, 0);
    if (files)
        closedir(files);
    if (*folder->path)
        rmdir(folder->path);
    *folder = (struct program_folder){0};
}

enum status program_open(struct program_folder *folder, struct message *why)
{
    struct program_folder f;
    const char *parent = getenv("TMPDIR");
    int length = snprintf(f.path, sizeof f.path, "%s/clothbench_XXXXXX",
                          parent && *parent ? parent : "/tmp");

    if (length >= (int)sizeof f.path || !mkdtemp(f.path))
        return status_fail(why, STATUS_FILE, "no temporary folder in %s: %s",
                           parent && *parent ? parent : "/tmp", strerror(errno));
    snprintf(f.log, sizeof f.log, "%s/log", f.path);
    *folder = f;
    return STATUS_OK;
}

static int count(const char *const *list)
{
    int n = 0;
    while (list[n])
        n++;
    return n;
}

static bool sets(const char *const *list, const char *variable)
{
    for (; *list; list++)
        if (!strncmp(variable, *list, strchr(*list, '=') - *list + 1))
            return true;
    return false;
}

/* Our environment with the settings in place of variables of the same name. The strings
 * are borrowed; free the list only. */
static const char **make_environment(const char *const *setting)
{
    const char *const *ours = (const char *const *)environ;
    int used = 0;
    const char **list =
        calloc(count(ours) + count(setting) + count(always) + 1, sizeof *list);

    for (; list && *ours; ours++)
        if (!sets(setting, *ours) && !sets(always, *ours))
            list[used++] = *ours;
    for (; list && *setting; setting++)
        list[used++] = *setting;
    for (int k = 0; list && always[k]; k++)
        list[used++] = always[k];
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
static int spawn(const struct program_folder *folder, const struct program *program,
                 pid_t *child)
{
    const int create = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_t files;
    const char **environment = make_environment(program->setting);
    int error = environment ? posix_spawn_file_actions_init(&files) : ENOMEM;

    if (!error) {
        error = posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
        if (!error)
            error = posix_spawn_file_actions_addopen(&files, 1, folder->log, create, 0600);
        if (!error)
            error = posix_spawn_file_actions_adddup2(&files, 1, 2);
        if (!error)
            error = posix_spawn_file_actions_addchdir_np(&files, folder->path);
        if (!error)
            error =
                posix_spawnp(child, program->argument[0], &files, NULL,
                             (char *const *)program->argument, (char *const *)environment);
        posix_spawn_file_actions_destroy(&files);
    }
    free(environment);
    return error;
}

enum status program_run(const struct program_folder *folder, const struct program *program,
                        struct message *why)
{
    const char *name = program->argument[0];
    pid_t child = 0;
    int end = 0, error = spawn(folder, program, &child);
    char line[512];

    if (error == ENOENT)
        return status_fail(why, STATUS_UNSUPPORTED, "%s is not installed (Debian: %s)",
                           name, program->packages);
    if (error)
        return status_fail(why, STATUS_LIBRARY, "%s does not start: %s", name,
                           strerror(error));
    while (waitpid(child, &end, 0) < 0)
        if (errno != EINTR)
            return status_fail(why, STATUS_LIBRARY, "%s was lost: %s", name,
                               strerror(errno));
    if (WIFEXITED(end) && WEXITSTATUS(end) == 0)
        return STATUS_OK;
    last_line(folder->log, line, sizeof line);
    if (WIFSIGNALED(end))
        return status_fail(why, STATUS_LIBRARY, "%s was killed by signal %d: %s", name,
                           WTERMSIG(end), line);
    return status_fail(why, STATUS_LIBRARY, "%s ended with exit code %d: %s", name,
                       WEXITSTATUS(end), line);
}
