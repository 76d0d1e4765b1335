#define _GNU_SOURCE /* open_memstream, strsep */
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
#include "bench/files/output.h"
#include "bench/files/provenance.h"
#include "bench/files/seal.h"
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
    struct output *out = NULL;
    FILE *file = NULL;

    TRY(make_manifest(folder, plan, &text, why));
    snprintf(path, sizeof path, "%s/manifest.txt", folder->path);
    file = fopen(path, "r");
    if (!file) {
        TRY(output_create(path, &out, why));
        output_print(out, "%s", text);
        TRY(output_close(out, why));
    } else if (!resume) {
        TRY(status_fail(why, STATUS_INPUT,
                        "%s has a sweep already; --resume goes on with it, --out DIR "
                        "begins another",
                        folder->path));
    } else {
        TRY(compare_manifest(path, file, text, why));
    }
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

/* Files that a sweep writes; the second group: of a case; the last: one that is half done,
 * `NAME.PID-N.part` (atomic_file.h). */
static const char OWN[] =
    "^((case_[0-9]{6,}\\.(h5|xdmf|txt))|(manifest|log)\\.txt|(table|seconds|falls)\\.csv|"
    "map\\.(gp|png|svg|pdf))(\\.[0-9]+-[0-9]+\\.part)?$";
enum { OF_CASE = 2, PART = 7, GROUPS };

/* Whether an entry of the folder goes before a sweep begins: what a killed one was writing;
 * links where it will write; and, of `all`, the cases and what they were of. */
static bool is_to_go(const regex_t *own, const char *name, const char *path, bool all)
{
    regmatch_t group[GROUPS];
    struct stat info;

    if (regexec(own, name, GROUPS, group, 0) != 0)
        return false;
    return group[PART].rm_so >= 0 || (lstat(path, &info) == 0 && S_ISLNK(info.st_mode)) ||
           (all && (group[OF_CASE].rm_so >= 0 || !strcmp(name, "manifest.txt")));
}

static enum status remove_files(const struct sweep_folder *folder, bool all)
{
    const struct dirent *file;
    regex_t own;

    if (regcomp(&own, OWN, REG_EXTENDED) != 0)
        return STATUS_MEMORY;
    DIR *directory = opendir(folder->path);
    while (directory && (file = readdir(directory))) {
        char path[SWEEP_FOLDER_PATH + 257];
        snprintf(path, sizeof path, "%s/%s", folder->path, file->d_name);
        if (is_to_go(&own, file->d_name, path, all))
            unlink(path);
    }
    if (directory)
        closedir(directory);
    regfree(&own);
    return STATUS_OK;
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
    TRY(remove_files(folder, start == SWEEP_AGAIN));
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

bool sweep_row_is_open(const struct sweep_row *row)
{
    return row->state == SWEEP_ROW_GONE || row->state == SWEEP_ROW_DAMAGED ||
           row->state == SWEEP_ROW_CUT;
}

#define MADE_FOR "case %08lx plan %08lx program %08lx"

const char *sweep_row_made_for(const struct sweep_folder *folder, const struct plan *plan,
                               const struct plan_case *c, char text[SWEEP_ROW_MADE_FOR])
{
    unsigned long sum = 0;

    for (int k = 0; k < plan->key_count; k++) {
        const struct plan_setting *s = c->given[k];
        if (!s)
            continue;
        sum = seal_text_sum(sum, s->key, strlen(s->key) + 1);
        sum = seal_text_sum(sum, s->value, strlen(s->value) + 1);
    }
    snprintf(text, SWEEP_ROW_MADE_FOR, MADE_FOR, sum, folder->plan, folder->program);
    return text;
}

/* What a file that was made for `is` has of another, being wanted for `want`. */
static void tell_foreign(const char *path, const char *is, const char *want,
                         struct message *why)
{
    unsigned long a[3] = {0}, b[3] = {0};

    sscanf(is, MADE_FOR, &a[0], &a[1], &a[2]);
    sscanf(want, MADE_FOR, &b[0], &b[1], &b[2]);
    status_fail(why, STATUS_INPUT,
                "%s: is of another %s; take it away, or give another folder with --out",
                path,
                a[2] != b[2]   ? "build of the program"
                : a[1] != b[1] ? "plan or scene"
                               : "case");
}

/* The parts of a sentence's file. */
static enum sweep_row_state read_sentence(char *text, const char *path,
                                          const char *made_for, struct message *why)
{
    static const char *const word[] = {
        [SWEEP_ROW_CUT] = "cut", [SWEEP_ROW_FAILED] = "failed"};
    char *rest = text;
    const char *is = strsep(&rest, "\n"), *state = strsep(&rest, "\n");
    const char *sentence = strsep(&rest, "\n");

    for (int n = SWEEP_ROW_CUT; sentence && n <= SWEEP_ROW_FAILED; n++) {
        if (strcmp(state, word[n]) != 0)
            continue;
        if (made_for && strcmp(is, made_for) != 0) {
            tell_foreign(path, is, made_for, why);
            return SWEEP_ROW_FOREIGN;
        }
        snprintf(why->text, sizeof why->text, "%s%s", sentence,
                 n == SWEEP_ROW_CUT ? "; --resume runs it again" : "");
        return (enum sweep_row_state)n;
    }
    return SWEEP_ROW_DAMAGED;
}

static enum status read_text(const char *path, const char *made_for, struct sweep_row *row)
{
    char *text = NULL;

    if (access(path, F_OK) != 0) {
        row->state = SWEEP_ROW_GONE;
        snprintf(row->why.text, sizeof row->why.text,
                 "its file is gone; --resume runs it again");
        return STATUS_OK;
    }
    const enum status st = seal_text_read(path, &text, NULL);
    if (st == STATUS_OK)
        row->state = read_sentence(text, path, made_for, &row->why);
    free(text);
    return st;
}

static enum status read_result(const char *path, const char *made_for, bool fields,
                               struct sweep_row *row)
{
    struct run_result *r = &row->result;
    const enum status st = run_result_read(path, fields, r, NULL);

    if (st != STATUS_OK)
        return st;
    row->state = r->outcome == STATUS_INPUT ? SWEEP_ROW_FAILED : SWEEP_ROW_RAN;
    row->why = r->sentence;
    if (made_for && strcmp(r->made_for, made_for) != 0) {
        row->state = SWEEP_ROW_FOREIGN;
        tell_foreign(path, r->made_for, made_for, &row->why);
        run_result_clear(r);
    }
    return STATUS_OK;
}

enum status sweep_row_read(const struct sweep_folder *folder, long number,
                           const char *made_for, bool fields, struct sweep_row *row)
{
    char path[SWEEP_FOLDER_PATH];
    enum status st;

    *row = (struct sweep_row){.state = SWEEP_ROW_DAMAGED};
    sweep_folder_file(folder, number, "h5", path);
    if (access(path, F_OK) == 0) {
        st = read_result(path, made_for, fields, row);
    } else {
        sweep_folder_file(folder, number, "txt", path);
        st = read_text(path, made_for, row);
    }
    if (st == STATUS_MEMORY) {
        *row = (struct sweep_row){0};
        return st;
    }
    if (row->state == SWEEP_ROW_DAMAGED)
        snprintf(row->why.text, sizeof row->why.text,
                 "its file is damaged; --resume runs it again");
    return STATUS_OK;
}

enum status sweep_row_write(const struct sweep_folder *folder, long number,
                            const char *made_for, enum sweep_row_state state,
                            const char *sentence, struct message *why)
{
    char path[SWEEP_FOLDER_PATH], text[SWEEP_ROW_MADE_FOR + sizeof why->text + 16];

    sweep_folder_file(folder, number, "txt", path);
    snprintf(text, sizeof text, "%s\n%s\n%s\n", made_for,
             state == SWEEP_ROW_CUT ? "cut" : "failed", sentence);
    return seal_text_write(path, text, why);
}

void sweep_row_remove(const struct sweep_folder *folder, long number)
{
    static const char *const endings[] = {"h5", "xdmf", "txt"};
    char path[SWEEP_FOLDER_PATH];

    for (size_t n = 0; n < sizeof endings / sizeof *endings; n++) {
        sweep_folder_file(folder, number, endings[n], path);
        unlink(path);
    }
}
