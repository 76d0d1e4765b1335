#include "models/reader/named_file.h"

#include <dirent.h>
#include <errno.h>
#include <limits.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "models/reader/input_file.h"
#include "models/reader/near.h"
#include "models/reader/yaml_tree.h"

static enum status refuse_file(const struct named_file_kind *kind, const char *path,
                               const char *reason, struct message *why)
{
    const struct yaml_tree file = {.origin = path, .line = -1};

    yaml_tree_refuse(&file, why, "cannot be read as a %s: %s", kind->what, reason);
    return STATUS_FILE;
}

enum status named_file_read(const struct named_file_kind *kind, const char *path,
                            char **bytes, size_t *size, struct message *why)
{
    size_t most = kind->most ? kind->most : YAML_TREE_MAX_TEXT;
    enum status st = STATUS_OK;
    struct stat about;
    const char *reason;
    FILE *file = input_file_open(path, &reason);

    *bytes = NULL;
    if (!file)
        return refuse_file(kind, path, reason, why);
    if (fstat(fileno(file), &about) == 0 && about.st_size > 0 &&
        (size_t)about.st_size < most)
        most = (size_t)about.st_size;
    *bytes = malloc(most + 2);
    if (!*bytes)
        TRY(status_fail(why, STATUS_MEMORY, "a %s file: %s", kind->what,
                        status_text(STATUS_MEMORY)));
    *size = fread(*bytes, 1, most + 1, file);
    if (ferror(file))
        TRY(refuse_file(kind, path, strerror(errno), why));
    (*bytes)[*size] = '\0';
out:
    fclose(file);
    if (st != STATUS_OK)
        free(*bytes), *bytes = NULL;
    return st;
}

/* The folders are searched in this order. */
enum { FOLDERS = 3 };
struct folders {
    char path[FOLDERS][PATH_MAX]; /* "" if there is none */
};

static struct folders find_folders(const struct named_file_kind *kind)
{
    struct folders f = {0};
    const char *users = getenv(kind->environment);
    char program[PATH_MAX / 2] = "";
    char *slash;

    if (readlink("/proc/self/exe", program, sizeof program - 1) < 0)
        program[0] = '\0';
    slash = strrchr(program, '/');
    if (users)
        snprintf(f.path[0], sizeof f.path[0], "%s", users);
    if (slash) {
        *slash = '\0';
        snprintf(f.path[1], sizeof f.path[1], "%s/%s", program, kind->from_program);
    }
    snprintf(f.path[2], sizeof f.path[2], "%s", kind->in_source);
    return f;
}

/* Returns folder/name.yaml; NULL if memory is out. Free it. */
static char *join(const struct named_file_kind *kind, const char *folder, const char *name)
{
    const size_t room = strlen(folder) + strlen(name) + strlen(kind->ending) + 2;
    char *path = malloc(room);

    if (path)
        snprintf(path, room, "%s/%s%s", folder, name, kind->ending);
    return path;
}

static bool ends_well(const struct named_file_kind *kind, const char *text)
{
    const size_t length = strlen(text), end = strlen(kind->ending);

    return length > end && !strcmp(text + length - end, kind->ending);
}

static bool is_known(const struct named_file_entry *entries, int count, const char *name)
{
    for (int i = 0; i < count; i++)
        if (!strcmp(entries[i].name, name))
            return true;
    return false;
}

static enum status describe(const struct named_file_kind *kind, const char *folder,
                            const char *name, char **text)
{
    if (!kind->describe)
        return STATUS_OK;
    char *path = join(kind, folder, name);

    *text = path ? kind->describe(path) : NULL;
    free(path);
    return *text ? STATUS_OK : STATUS_MEMORY;
}

/* Adds `file` of a folder, unless it has another ending or a known name. */
static enum status add_entry(const struct named_file_kind *kind, const char *folder,
                             const char *file, struct named_file_entry **entries,
                             int *count)
{
    enum status st = STATUS_OK;
    struct named_file_entry entry = {.name = NULL}, *grown;

    if (!ends_well(kind, file))
        return STATUS_OK;
    entry.name = strdup(file);
    if (!entry.name)
        return STATUS_MEMORY;
    entry.name[strlen(file) - strlen(kind->ending)] = '\0';
    if (is_known(*entries, *count, entry.name))
        goto out;
    TRY(describe(kind, folder, entry.name, &entry.text));
    grown = realloc(*entries, ((size_t)*count + 1) * sizeof *grown);
    if (!grown)
        TRY(STATUS_MEMORY);
    *entries = grown;
    grown[(*count)++] = entry;
    return STATUS_OK;
out:
    free(entry.name);
    free(entry.text);
    return st;
}

static int compare_names(const void *a, const void *b)
{
    const struct named_file_entry *left = a, *right = b;

    return strcmp(left->name, right->name);
}

enum status named_file_list(const struct named_file_kind *kind,
                            struct named_file_entry **entries, int *count,
                            struct message *why)
{
    enum status st = STATUS_OK;
    const struct folders folders = find_folders(kind);
    DIR *directory = NULL;

    *entries = NULL, *count = 0;
    for (int i = 0; i < FOLDERS; i++) {
        const struct dirent *file;

        directory = opendir(folders.path[i]);
        if (!directory)
            continue;
        while ((file = readdir(directory)))
            TRY(add_entry(kind, folders.path[i], file->d_name, entries, count));
        closedir(directory), directory = NULL;
    }
    if (*count > 0)
        qsort(*entries, (size_t)*count, sizeof **entries, compare_names);
out:
    if (directory)
        closedir(directory);
    if (st != STATUS_OK) {
        named_file_list_free(*entries, *count);
        *entries = NULL, *count = 0;
        status_fail(why, st, "the list of %ss: %s", kind->what, status_text(st));
    }
    return st;
}

enum status named_file_names(const struct named_file_kind *kind,
                             struct named_file_entry **entries, int *count,
                             struct message *why)
{
    struct named_file_kind named = *kind;

    named.describe = NULL;
    return named_file_list(&named, entries, count, why);
}

void named_file_list_free(struct named_file_entry *entries, int count)
{
    for (int i = 0; i < count; i++) {
        free(entries[i].name);
        free(entries[i].text);
    }
    free(entries);
}

/* Fails with the sentence for an unknown name. */
static enum status refuse_name(const struct named_file_kind *kind, const char *argument,
                               struct message *why)
{
    enum status st = STATUS_OK;
    struct named_file_entry *entries = NULL;
    struct near near = near_start(argument);
    struct message names = {""};
    char meant[80];
    int count = 0;

    TRY(named_file_names(kind, &entries, &count, why));
    for (int i = 0; i < count; i++) {
        TEXT_JOIN(names.text, ", ", "%s", entries[i].name);
        near_try(&near, entries[i].name);
    }
    st = near.best ? status_fail(why, STATUS_INPUT, "no %s %s%s", kind->what,
                                 yaml_tree_quote(argument).text, near_text(&near, meant))
                   : status_fail(why, STATUS_INPUT,
                                 "no %s %s; give the path of a file, or one of %s",
                                 kind->what, yaml_tree_quote(argument).text, names.text);
out:
    named_file_list_free(entries, count);
    return st;
}

enum status named_file_find(const struct named_file_kind *kind, const char *argument,
                            char **path, struct message *why)
{
    const struct folders folders = find_folders(kind);

    if (strchr(argument, '/') || ends_well(kind, argument)) {
        *path = strdup(argument);
        return *path ? STATUS_OK : STATUS_MEMORY;
    }
    for (int i = 0; *argument && i < FOLDERS; i++) {
        char *candidate = join(kind, folders.path[i], argument);

        if (!candidate)
            return STATUS_MEMORY;
        if (*folders.path[i] && !access(candidate, F_OK)) {
            *path = candidate;
            return STATUS_OK;
        }
        free(candidate);
    }
    return refuse_name(kind, argument, why);
}
