#define _GNU_SOURCE /* strsep */
#include "bench/sweep/sweep.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <regex.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "bench/files/folder.h"
#include "bench/files/seal.h"

/* Opens the lock, and makes it if it is not there. */
static enum status open_lock(struct sweep_folder *folder, struct message *why)
{
    char path[SWEEP_FOLDER_PATH + 16];

    snprintf(path, sizeof path, "%s/lock", folder->path);
    /* a pipe without a reader would be waited for */
    folder->lock =
        open(path, O_WRONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
    return folder->lock >= 0 ? STATUS_OK
                             : status_fail(why, STATUS_FILE, "%s: cannot be opened: %s",
                                           path, strerror(errno));
}

/* Locks the folder for this process alone: the system drops the lock when the process dies,
 * however it does, and children do not have it. */
static enum status lock(const struct sweep_folder *folder, struct message *why)
{
    struct flock whole = {.l_type = F_WRLCK, .l_whence = SEEK_SET};

    if (fcntl(folder->lock, F_SETLK, &whole) == 0 || (errno != EACCES && errno != EAGAIN))
        return STATUS_OK; /* a file system without locks is forgiven */
    return status_fail(why, STATUS_FILE, "%s: another sweep is at work in this folder",
                       folder->path);
}

/* The names of files that a sweep writes, and of those that are half done,
 * `NAME.PID-N.part` (atomic_file.h), whose ending is the last group. */
static const char OWN[] = "^(case_[0-9]{6,}\\.(h5|xdmf|txt)|table\\.csv)"
                          "(\\.[0-9]+-[0-9]+\\.part)?$";
enum { PART = 3, GROUPS };

void sweep_folder_tidy(const struct sweep_folder *folder)
{
    const struct dirent *file;
    regmatch_t group[GROUPS];
    struct stat info;
    regex_t own;

    if (regcomp(&own, OWN, REG_EXTENDED) != 0)
        return;
    DIR *directory = opendir(folder->path);
    while (directory && (file = readdir(directory))) {
        char path[SWEEP_FOLDER_PATH + 257];
        snprintf(path, sizeof path, "%s/%s", folder->path, file->d_name);
        if (regexec(&own, file->d_name, GROUPS, group, 0) == 0 &&
            (group[PART].rm_so >= 0 || (lstat(path, &info) == 0 && S_ISLNK(info.st_mode))))
            unlink(path);
    }
    if (directory)
        closedir(directory);
    regfree(&own);
}

enum status sweep_folder_open(struct sweep_folder *folder, const char *path,
                              struct message *why)
{
    enum status st;

    *folder = (struct sweep_folder){.lock = -1};
    if (snprintf(folder->path, sizeof folder->path - 40, "%s", path) >=
        (int)sizeof folder->path - 40)
        return status_fail(why, STATUS_FILE, "%.60s...: the path is too long", path);
    TRY(folder_make(folder->path, why));
    TRY(open_lock(folder, why));
    TRY(lock(folder, why));
    sweep_folder_tidy(folder);
out:
    return st;
}

void sweep_folder_close(struct sweep_folder *folder)
{
    if (folder->lock >= 0)
        close(folder->lock);
    *folder = (struct sweep_folder){.lock = -1};
}

void sweep_folder_file(const struct sweep_folder *folder, long number, const char *ending,
                       char path[SWEEP_FOLDER_PATH])
{
    snprintf(path, SWEEP_FOLDER_PATH, "%.*s/case_%06ld.%s", SWEEP_FOLDER_PATH - 40,
             folder->path, number + 1, ending);
}

bool sweep_folder_has(const struct sweep_folder *folder, long number)
{
    char path[2][SWEEP_FOLDER_PATH];

    sweep_folder_file(folder, number, "h5", path[0]);
    sweep_folder_file(folder, number, "txt", path[1]);
    return access(path[0], F_OK) == 0 || access(path[1], F_OK) == 0;
}

/* Takes the file of a case without a result: its key, "cut" or "failed", the sentence. */
static void take_sentence(char *text, const char *key, enum sweep_state *state,
                          struct message *sentence)
{
    char *rest = text;
    const char *is = strsep(&rest, "\n"), *word = strsep(&rest, "\n");
    const char *words = strsep(&rest, "\n");
    const bool cut = words && !strcmp(word, "cut");

    if (!words || (!cut && strcmp(word, "failed") != 0) || (key && strcmp(is, key) != 0))
        return; /* it is damaged, or another case's */
    *state = cut ? SWEEP_OPEN : SWEEP_FAILED;
    snprintf(sentence->text, sizeof sentence->text, "%s%s", words,
             cut ? "; the next sweep runs it again" : "");
}

enum status sweep_folder_read(const struct sweep_folder *folder, long number,
                              const char *key, bool fields, enum sweep_state *state,
                              struct run_result *result, struct message *sentence)
{
    char path[SWEEP_FOLDER_PATH], *text = NULL;
    enum status st;

    *result = (struct run_result){0};
    *state = SWEEP_OPEN;
    snprintf(sentence->text, sizeof sentence->text,
             "its file is %s; the next sweep runs it again",
             sweep_folder_has(folder, number) ? "damaged" : "gone");
    sweep_folder_file(folder, number, "h5", path);
    if (access(path, F_OK) == 0) {
        st = run_result_read(path, fields, result, NULL);
        if (st == STATUS_OK && key && strcmp(result->made_for, key) != 0)
            run_result_clear(result);
        else if (st == STATUS_OK) {
            *state = result->outcome == STATUS_INPUT ? SWEEP_FAILED : SWEEP_RAN;
            *sentence = result->sentence;
        }
    } else {
        sweep_folder_file(folder, number, "txt", path);
        st = seal_text_read(path, &text, NULL);
        if (st == STATUS_OK)
            take_sentence(text, key, state, sentence);
        free(text);
    }
    return st == STATUS_MEMORY ? st : STATUS_OK;
}

enum status sweep_folder_write(const struct sweep_folder *folder, long number,
                               const char *key, bool cut, const char *sentence,
                               struct message *why)
{
    char path[SWEEP_FOLDER_PATH], text[sizeof why->text + 64];

    sweep_folder_file(folder, number, "txt", path);
    snprintf(text, sizeof text, "%s\n%s\n%s\n", key, cut ? "cut" : "failed", sentence);
    return seal_text_write(path, text, why);
}

void sweep_folder_remove(const struct sweep_folder *folder, long number)
{
    static const char *const endings[] = {"h5", "xdmf", "txt"};
    char path[SWEEP_FOLDER_PATH];

    for (size_t n = 0; n < sizeof endings / sizeof *endings; n++) {
        sweep_folder_file(folder, number, endings[n], path);
        unlink(path);
    }
}
