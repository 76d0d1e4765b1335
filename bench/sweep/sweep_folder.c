#define _GNU_SOURCE /* open_memstream */
#include "bench/sweep/sweep_folder.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "bench/files/folder.h"
#include "bench/files/output.h"
#include "bench/files/provenance.h"
#include "bench/files/seal.h"
#include "bench/experiment/plan_case.h"
#include "models/reader/scene_file.h"

/* Adds the texts of the scenes among these settings. */
static enum status add_scenes(const struct plan *plan, const struct plan_settings *settings,
                              FILE *text, struct message *why)
{
    enum status st = STATUS_OK;
    char *path = NULL, *bytes = NULL;
    size_t size;

    for (int n = 0; n < settings->count; n++) {
        const struct plan_setting *s = &settings->list[n];
        if (strcmp(s->key, "scene") != 0)
            continue;
        free(path), path = NULL;
        free(bytes), bytes = NULL;
        TRY(plan_case_find_scene(plan, s->value, &path, why));
        TRY(named_file_read(&scene_file_kind, path, &bytes, &size, why));
        fprintf(text, "\n--- scene %s\n", s->value);
        fwrite(bytes, 1, size, text);
    }
out:
    free(path);
    free(bytes);
    return st;
}

/* What the results of this plan depend on. */
static enum status write_manifest(const struct plan *plan, FILE *text, struct message *why)
{
    enum status st = STATUS_OK;

    fprintf(text, "--- plan %s\n%s", plan->name, plan->text);
    TRY(add_scenes(plan, &plan->settings, text, why));
    for (int n = 0; n < plan->listed_count; n++)
        TRY(add_scenes(plan, &plan->listed[n].settings, text, why));
    for (int n = 0; n < plan->axis_count; n++)
        TRY(add_scenes(plan, &plan->axes[n].values, text, why));
out:
    return st;
}

/* The sweep in the folder is to be of the same plan, scenes and program, line by line. */
static enum status compare_manifest(const char *path, FILE *file, const char *is,
                                    struct message *why)
{
    char *was = NULL;
    size_t room = 0, line = 0;
    int number = 1;
    enum status st = STATUS_OK;

    if (getdelim(&was, &room, '\0', file) < 0)
        TRY(status_fail(why, STATUS_FILE, "%s: cannot be read", path));
    for (size_t n = 0; was[n] && was[n] == is[n]; n++)
        if (was[n] == '\n')
            line = n + 1, number++;
    if (strcmp(was, is) != 0)
        TRY(status_fail(why, STATUS_INPUT,
                        "%s: the sweep was begun with another plan, scene or build of the "
                        "program: line %d was '%.*s' and is now '%.*s'; give another "
                        "folder with --out",
                        path, number, (int)strcspn(was + line, "\n"), was + line,
                        (int)strcspn(is + line, "\n"), is + line));
out:
    free(was);
    return st;
}

/* A text file of one text. */
static enum status write_file(const char *path, const char *text, struct message *why)
{
    struct output *out = NULL;
    enum status st = output_create(path, &out, why);

    if (st != STATUS_OK)
        return st;
    output_print(out, "%s", text);
    return output_close(out, why);
}

/* The manifest as it should be, freed by the receiver, and the folder's sums. */
static enum status make_manifest(struct sweep_folder *folder, const struct plan *plan,
                                 char **text, struct message *why)
{
    size_t size;
    FILE *memory = open_memstream(text, &size);
    struct provenance here;
    enum status st;

    if (!memory)
        return STATUS_MEMORY;
    TRY(write_manifest(plan, memory, why));
    TRY(fflush(memory) == 0 ? STATUS_OK : STATUS_MEMORY);
    folder->plan = seal_text_sum(0, *text, size);
    TRY(seal_text_program(&folder->program, why));
    provenance_collect(&here);
    fprintf(memory, "\n--- program %s, commit %s, file with the sum %08lx\n",
            provenance_value(&here, "program"), provenance_value(&here, "commit"),
            folder->program);
out:
    if (fclose(memory) != 0 && st == STATUS_OK)
        st = STATUS_MEMORY;
    return st;
}

enum status sweep_folder_identify(struct sweep_folder *folder, const struct plan *plan,
                                  struct message *why)
{
    char *text = NULL;
    const enum status st = make_manifest(folder, plan, &text, why);

    free(text);
    return st;
}

static enum status settle_manifest(struct sweep_folder *folder, const struct plan *plan,
                                   bool resume, struct message *why)
{
    enum status st = STATUS_OK;
    char path[SWEEP_FOLDER_PATH + 16], *text = NULL;
    FILE *file = NULL;

    TRY(make_manifest(folder, plan, &text, why));
    snprintf(path, sizeof path, "%s/manifest.txt", folder->path);
    file = fopen(path, "r");
    if (!file)
        TRY(write_file(path, text, why));
    else if (!resume)
        TRY(status_fail(why, STATUS_INPUT,
                        "%s has a sweep already; --resume goes on with it, --out DIR "
                        "begins another",
                        folder->path));
    else
        TRY(compare_manifest(path, file, text, why));
out:
    if (file)
        fclose(file);
    free(text);
    return st;
}

/* Opens NAME in the folder for appending, made if it is not there. */
static enum status open_file(const struct sweep_folder *folder, const char *name, int *file,
                             struct message *why)
{
    char path[SWEEP_FOLDER_PATH + 16];

    snprintf(path, sizeof path, "%s/%s", folder->path, name);
    *file = open(path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW, 0666);
    return *file >= 0 ? STATUS_OK
                      : status_fail(why, STATUS_FILE, "%s: cannot be opened: %s", path,
                                    strerror(errno));
}

/* A lock of this process alone: the system drops it when the process dies, however, and
 * children do not have it. */
static enum status lock(const struct sweep_folder *folder, struct message *why)
{
    struct flock whole = {.l_type = F_WRLCK, .l_whence = SEEK_SET};

    if (fcntl(folder->lock, F_SETLK, &whole) == 0 || (errno != EACCES && errno != EAGAIN))
        return STATUS_OK; /* a file system without locks is forgiven */
    return status_fail(why, STATUS_FILE, "%s: another sweep is at work in this folder",
                       folder->path);
}

/* What follows the number of digits that a text begins with; NULL: there are fewer. */
static const char *after_digits(const char *text, size_t least)
{
    const size_t count = strspn(text, "0123456789");

    return count >= least ? text + count : NULL;
}

static const char *after_word(const char *text, const char *word)
{
    return text && !strncmp(text, word, strlen(word)) ? text + strlen(word) : NULL;
}

/* What follows the name of a case's file that this name begins with; NULL: it does not. */
static const char *after_case(const char *name)
{
    const char *digits = after_word(name, "case_");
    const char *rest = digits ? after_digits(digits, 6) : NULL;
    const char *const ends[] = {after_word(rest, ".h5"), after_word(rest, ".xdmf"),
                                after_word(rest, ".txt")};

    return ends[0] ? ends[0] : ends[1] ? ends[1] : ends[2];
}

/* Likewise of any other file that a sweep writes. */
static const char *after_own(const char *name)
{
    static const char *const own[] = {"manifest.txt", "log.txt",   "table.csv",
                                      "seconds.csv",  "falls.csv", "map.gp",
                                      "map.png",      "map.svg",   "map.pdf"};
    const char *rest = NULL;

    for (size_t n = 0; !rest && n < sizeof own / sizeof *own; n++)
        rest = after_word(name, own[n]);
    return rest;
}

/* Whether it is `.PID-N.part` (atomic_file.h). */
static bool is_part(const char *rest)
{
    rest = *rest == '.' ? after_digits(rest + 1, 1) : NULL;
    rest = rest && *rest == '-' ? after_digits(rest + 1, 1) : NULL;
    return rest && !strcmp(rest, ".part");
}

/* Whether an entry of the folder goes before a sweep begins: what a killed one was writing;
 * links where it will write; and, of `all`, the cases and what they were of. */
static bool is_to_go(const char *name, const char *path, bool all)
{
    const char *of_case = after_case(name), *rest = of_case ? of_case : after_own(name);
    struct stat info;

    if (!rest)
        return false;
    if (*rest)
        return is_part(rest);
    return (lstat(path, &info) == 0 && S_ISLNK(info.st_mode)) ||
           (all && (of_case || !strcmp(name, "manifest.txt")));
}

static void remove_files(const struct sweep_folder *folder, bool all)
{
    DIR *directory = opendir(folder->path);
    const struct dirent *file;

    while (directory && (file = readdir(directory))) {
        char path[SWEEP_FOLDER_PATH + 257];
        snprintf(path, sizeof path, "%s/%s", folder->path, file->d_name);
        if (is_to_go(file->d_name, path, all))
            unlink(path);
    }
    if (directory)
        closedir(directory);
}

void sweep_folder_tidy(const struct sweep_folder *folder)
{
    remove_files(folder, false);
}

enum status sweep_folder_open(struct sweep_folder *folder, const char *path,
                              const struct plan *plan, enum sweep_start start,
                              struct message *why)
{
    enum status st;

    folder->lock = folder->log = -1;
    if (snprintf(folder->path, sizeof folder->path - 40, "%s", path) >=
        (int)sizeof folder->path - 40)
        return status_fail(why, STATUS_FILE, "%.60s...: the path is too long", path);
    TRY(folder_make(folder->path, why));
    TRY(open_file(folder, "lock", &folder->lock, why));
    TRY(lock(folder, why));
    remove_files(folder, start == SWEEP_AGAIN);
    TRY(settle_manifest(folder, plan, start == SWEEP_RESUME, why));
    TRY(open_file(folder, "log.txt", &folder->log, why));
out:
    if (st != STATUS_OK)
        sweep_folder_close(folder);
    return st;
}

void sweep_folder_close(struct sweep_folder *folder)
{
    if (folder->lock >= 0)
        close(folder->lock);
    if (folder->log >= 0)
        close(folder->log);
    folder->lock = folder->log = -1;
}

void sweep_folder_file(const struct sweep_folder *folder, long number, const char *ending,
                       char path[SWEEP_FOLDER_PATH])
{
    snprintf(path, SWEEP_FOLDER_PATH, "%.*s/case_%06ld.%s", SWEEP_FOLDER_PATH - 40,
             folder->path, number + 1, ending);
}

enum status sweep_folder_log(const struct sweep_folder *folder, const char *event,
                             long number, struct message *why)
{
    if (dprintf(folder->log, "%s %ld\n", event, number + 1) > 0)
        return STATUS_OK;
    return status_fail(why, STATUS_FILE, "%s/log.txt: cannot be written: %s", folder->path,
                       strerror(errno));
}
