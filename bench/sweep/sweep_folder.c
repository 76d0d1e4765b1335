#define _GNU_SOURCE /* open_memstream */
#include "bench/sweep/sweep_folder.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "bench/files/folder.h"
#include "bench/files/output.h"
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

/* The sweep in the folder is to be of the same plan and scenes, line by line. */
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
                        "%s: the sweep was begun with another plan or scene: line %d was "
                        "'%.*s' and is now '%.*s'; give another folder with --out",
                        path, number, (int)strcspn(was + line, "\n"), was + line,
                        (int)strcspn(is + line, "\n"), is + line));
out:
    free(was);
    return st;
}

/* A text file of one text. */
static enum status write_file(const char *path, const char *text, const char *end,
                              struct message *why)
{
    struct output *out = NULL;
    enum status st = output_create(path, &out, why);

    if (st != STATUS_OK)
        return st;
    output_print(out, "%s%s", text, end);
    return output_close(out, why);
}

static enum status settle_manifest(const struct sweep_folder *folder,
                                   const struct plan *plan, bool resume,
                                   struct message *why)
{
    enum status st = STATUS_OK;
    char path[SWEEP_FOLDER_PATH + 16], *text = NULL;
    size_t size;
    FILE *memory = open_memstream(&text, &size), *file = NULL;

    if (!memory)
        return STATUS_MEMORY;
    st = write_manifest(plan, memory, why);
    if (fclose(memory) != 0 && st == STATUS_OK)
        st = STATUS_MEMORY;
    TRY(st);
    snprintf(path, sizeof path, "%s/manifest.txt", folder->path);
    file = fopen(path, "r");
    if (!file)
        TRY(write_file(path, text, "", why));
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
    *file = open(path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
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

static bool ends_with(const char *name, const char *ending)
{
    const size_t length = strlen(name), end = strlen(ending);

    return length >= end && !strcmp(name + length - end, ending);
}

/* Files that a killed process was writing; or all cases, and what they were of. */
static void remove_files(const struct sweep_folder *folder, bool all)
{
    DIR *directory = opendir(folder->path);
    const struct dirent *file;

    while (directory && (file = readdir(directory))) {
        char path[SWEEP_FOLDER_PATH + 257];
        const char *name = file->d_name;
        const bool ours = !strncmp(name, "case_", 5) || !strcmp(name, "manifest.txt");

        if (!ends_with(name, ".part") && !(all && ours))
            continue;
        snprintf(path, sizeof path, "%s/%s", folder->path, name);
        unlink(path);
    }
    if (directory)
        closedir(directory);
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

/* The sentence of a case without result; false if there is none. */
static bool read_sentence(const char *path, struct message *sentence)
{
    FILE *file = fopen(path, "r");
    bool there = file && fgets(sentence->text, sizeof sentence->text, file);

    if (there)
        sentence->text[strcspn(sentence->text, "\n")] = '\0';
    if (file)
        fclose(file);
    return there;
}

void sweep_folder_read(const struct sweep_folder *folder, long number, bool repair,
                       struct sweep_row *row)
{
    char path[SWEEP_FOLDER_PATH];

    *row = (struct sweep_row){0};
    sweep_folder_file(folder, number, "h5", path);
    if (access(path, F_OK) == 0) {
        row->there = run_result_read(path, false, &row->result, &row->why) == STATUS_OK;
        row->ran = row->there && row->result.outcome != STATUS_INPUT;
        if (row->there) {
            row->why = row->result.sentence;
            return;
        }
        if (repair)
            unlink(path);
    }
    sweep_folder_file(folder, number, "txt", path);
    row->there = read_sentence(path, &row->why);
}

enum status sweep_folder_fail(const struct sweep_folder *folder, long number,
                              const char *sentence, struct message *why)
{
    char path[SWEEP_FOLDER_PATH];

    sweep_folder_file(folder, number, "txt", path);
    return write_file(path, sentence, "\n", why);
}

enum status sweep_folder_log(const struct sweep_folder *folder, const char *event,
                             long number, struct message *why)
{
    if (dprintf(folder->log, "%s %ld\n", event, number + 1) > 0)
        return STATUS_OK;
    return status_fail(why, STATUS_FILE, "%s/log.txt: cannot be written: %s", folder->path,
                       strerror(errno));
}
