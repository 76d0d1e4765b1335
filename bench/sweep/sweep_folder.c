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
#include "bench/truth/truth.h"
#include "models/contact/contact_mesh.h"
#include "models/reader/input_file.h"
#include "models/reader/scene_file.h"

/* Adds the sum of the truth, if one is stored, that cases of a scene tell their distance
 * from: of its beginning, where it is sealed. */
static void add_truth(const char *path, FILE *text)
{
    struct discretization unused = {0};
    struct scene scene;
    char *truth = NULL, *bytes = NULL;
    size_t size;

    if (scene_file_read(path, 0, NULL, &scene, &unused, NULL) == STATUS_OK &&
        named_file_find(&truth_file_kind, scene.name, &truth, NULL) == STATUS_OK &&
        named_file_read(&truth_file_kind, truth, &bytes, &size, NULL) == STATUS_OK)
        fprintf(text, "--- its truth, file with the sum %08lx\n",
                seal_text_sum(0, bytes, size));
    scene_clear(&scene);
    free(truth);
    free(bytes);
}

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
        add_truth(path, text);
    }
out:
    free(path);
    free(bytes);
    return st;
}

/* Adds the sum of all meshes that scenes and settings of the cases name. A case that cannot
 * be opened has none: its own run says why. */
static enum status add_meshes(const struct plan *plan, FILE *text)
{
    const long count = plan_case_count(plan);
    unsigned long sum = 0;

    for (long n = 0; n < count; n++) {
        struct plan_case c = {0};
        struct scene scene = {0};
        enum status st = plan_case_open(plan, n, &c, NULL);

        if (st == STATUS_OK)
            st = plan_case_scene(&c, &scene, NULL);
        for (int k = 0; st == STATUS_OK && k < scene.obstacle_count; k++)
            if (scene.obstacles[k].mesh) {
                const struct contact_mesh_view mesh =
                    contact_mesh_view(scene.obstacles[k].mesh);
                sum = seal_text_sum(sum, &mesh.mark, sizeof mesh.mark);
            }
        scene_clear(&scene);
        plan_case_clear(&c);
        if (st == STATUS_MEMORY)
            return st;
    }
    fprintf(text, "\n--- meshes with the sum %08lx\n", sum);
    return STATUS_OK;
}

/* Writes the plan and its scenes, on which all results depend. */
static enum status write_plan(const struct plan *plan, FILE *text, struct message *why)
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

enum status sweep_folder_identify(struct sweep_folder *folder, const struct plan *plan,
                                  struct message *why)
{
    size_t size;
    FILE *memory = open_memstream(&folder->manifest, &size);
    struct provenance here;
    enum status st;

    if (!memory)
        return STATUS_MEMORY;
    TRY(write_plan(plan, memory, why));
    TRY(fflush(memory) == 0 ? STATUS_OK : STATUS_MEMORY);
    if (strstr(folder->manifest, ".obj")) /* else no case is read here */
        TRY(add_meshes(plan, memory));
    TRY(fflush(memory) == 0 ? STATUS_OK : STATUS_MEMORY);
    folder->plan = seal_text_sum(0, folder->manifest, size);
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

/* Compares the manifest in the folder line by line with that of this plan, its scenes and
 * this program. */
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

/* Writes the manifest of a new sweep; compares that of one that goes on. */
static enum status settle_manifest(const struct sweep_folder *folder, bool resume,
                                   struct message *why)
{
    char path[SWEEP_FOLDER_PATH + 16];
    struct output *out = NULL;
    enum status st;

    snprintf(path, sizeof path, "%s/manifest.txt", folder->path);
    const char *reason;
    FILE *file = input_file_open(path, &reason);
    if (!file && errno != ENOENT)
        return status_fail(why, STATUS_FILE, "%s: %s", path, reason);
    if (!file) {
        TRY(output_create(path, &out, why));
        output_print(out, "%s", folder->manifest);
        return output_close(&out, why);
    }
    st = resume ? compare_manifest(path, file, folder->manifest, why)
                : status_fail(why, STATUS_INPUT,
                              "%s has a sweep already; --resume goes on with it, --out DIR "
                              "begins another",
                              folder->path);
    fclose(file);
out:
    return st;
}

/* Opens NAME in the folder for appending, and makes it if it is not there. */
static enum status open_file(const struct sweep_folder *folder, const char *name, int *file,
                             struct message *why)
{
    char path[SWEEP_FOLDER_PATH + 16];

    snprintf(path, sizeof path, "%s/%s", folder->path, name);
    /* a pipe without a reader would be waited for */
    *file = open(path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK,
                 0666);
    return *file >= 0 ? STATUS_OK
                      : status_fail(why, STATUS_FILE, "%s: cannot be opened: %s", path,
                                    strerror(errno));
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
static const char OWN[] =
    "^(case_[0-9]{6,}\\.(h5|xdmf|txt)|(manifest|log)\\.txt|(table|seconds|falls)\\.csv|"
    "map\\.(gp|png|svg|pdf))(\\.[0-9]+-[0-9]+\\.part)?$";
enum { PART = 6, GROUPS };

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
                              const struct plan *plan, bool resume, struct message *why)
{
    enum status st;

    *folder = (struct sweep_folder){.lock = -1, .log = -1};
    if (snprintf(folder->path, sizeof folder->path - 40, "%s", path) >=
        (int)sizeof folder->path - 40)
        return status_fail(why, STATUS_FILE, "%.60s...: the path is too long", path);
    TRY(folder_make(folder->path, why));
    TRY(open_file(folder, "lock", &folder->lock, why));
    TRY(lock(folder, why));
    sweep_folder_tidy(folder);
    TRY(sweep_folder_identify(folder, plan, why));
    TRY(settle_manifest(folder, resume, why));
    TRY(open_file(folder, "log.txt", &folder->log, why));
out:
    return st;
}

void sweep_folder_close(struct sweep_folder *folder)
{
    if (folder->lock >= 0)
        close(folder->lock);
    if (folder->log >= 0)
        close(folder->log);
    free(folder->manifest);
    *folder = (struct sweep_folder){.lock = -1, .log = -1};
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

#define MADE_FOR "case %08lx plan %08lx program %08lx"

const char *sweep_folder_made_for(const struct sweep_folder *folder,
                                  const struct plan *plan, const struct plan_case *c,
                                  char text[SWEEP_FOLDER_MADE_FOR])
{
    unsigned long sum = 0;

    for (int k = 0; k < plan->key_count; k++) {
        const struct plan_setting *s = c->given[k];
        if (!s)
            continue;
        sum = seal_text_sum(sum, s->key, strlen(s->key) + 1);
        sum = seal_text_sum(sum, s->value, strlen(s->value) + 1);
    }
    snprintf(text, SWEEP_FOLDER_MADE_FOR, MADE_FOR, sum, folder->plan, folder->program);
    return text;
}

/* Refuses a file that is made for something else than it is wanted for. */
static enum status check_made_for(const char *path, const char *is, const char *want,
                                  struct message *why)
{
    unsigned long a[3] = {0}, b[3] = {0};

    if (!want || !strcmp(is, want))
        return STATUS_OK;
    sscanf(is, MADE_FOR, &a[0], &a[1], &a[2]);
    sscanf(want, MADE_FOR, &b[0], &b[1], &b[2]);
    return status_fail(
        why, STATUS_INPUT,
        "%s: is of another %s; take it away, or give another folder with --out", path,
        a[2] != b[2]   ? "build of the program"
        : a[1] != b[1] ? "plan or scene"
                       : "case");
}

/* Takes the file of a case without a result: what it is made for, "cut" or "failed", the
 * sentence. */
static enum status take_sentence(char *text, const char *path, const char *made_for,
                                 enum sweep_state *state, struct message *sentence,
                                 struct message *why)
{
    char *rest = text;
    const char *is = strsep(&rest, "\n"), *word = strsep(&rest, "\n");
    const char *words = strsep(&rest, "\n");
    const bool cut = words && !strcmp(word, "cut");

    if (!words || (!cut && strcmp(word, "failed") != 0))
        return STATUS_OK; /* it is damaged */
    *state = cut ? SWEEP_OPEN : SWEEP_FAILED;
    snprintf(sentence->text, sizeof sentence->text, "%s%s", words,
             cut ? "; --resume runs it again" : "");
    return check_made_for(path, is, made_for, why);
}

static enum status take_result(const char *path, const char *made_for,
                               enum sweep_state *state, const struct run_result *result,
                               struct message *sentence, struct message *why)
{
    *state = result->outcome == STATUS_INPUT ? SWEEP_FAILED : SWEEP_RAN;
    *sentence = result->sentence;
    return check_made_for(path, result->made_for, made_for, why);
}

enum status sweep_folder_read(const struct sweep_folder *folder, long number,
                              const char *made_for, bool fields, enum sweep_state *state,
                              struct run_result *result, struct message *sentence,
                              struct message *why)
{
    static const char again[] = "its file is %s; --resume runs it again";
    char path[SWEEP_FOLDER_PATH], *text = NULL;
    enum status st;

    *result = (struct run_result){0};
    *state = SWEEP_OPEN;
    snprintf(sentence->text, sizeof sentence->text, again, "damaged");
    sweep_folder_file(folder, number, "h5", path);
    if (access(path, F_OK) == 0) {
        st = run_result_read(path, fields, result, NULL);
        if (st == STATUS_OK)
            return take_result(path, made_for, state, result, sentence, why);
    } else {
        sweep_folder_file(folder, number, "txt", path);
        if (access(path, F_OK) != 0)
            snprintf(sentence->text, sizeof sentence->text, again, "gone");
        st = seal_text_read(path, &text, NULL);
        if (st == STATUS_OK) {
            st = take_sentence(text, path, made_for, state, sentence, why);
            free(text);
            return st;
        }
    }
    return st == STATUS_MEMORY ? st : STATUS_OK;
}

enum status sweep_folder_write(const struct sweep_folder *folder, long number,
                               const char *made_for, bool cut, const char *sentence,
                               struct message *why)
{
    char path[SWEEP_FOLDER_PATH], text[SWEEP_FOLDER_MADE_FOR + sizeof why->text + 16];

    sweep_folder_file(folder, number, "txt", path);
    snprintf(text, sizeof text, "%s\n%s\n%s\n", made_for, cut ? "cut" : "failed", sentence);
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
