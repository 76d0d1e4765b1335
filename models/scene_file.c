/* scene_file.c - files and settings to scenes. The keys are in scene_schema.c. */
#include "models/scene_file.h"

#include <dirent.h>
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "models/scene_schema.h"

static bool is_numerics(const char *setting)
{
    const size_t length = strlen("discretization");

    return !strncmp(setting, "discretization", length) &&
           (setting[length] == '.' || setting[length] == '=');
}

/* The text with the settings below it as comments. */
static enum status annotate(const char *text, size_t size, int setting_count,
                            const char *const *settings, char **annotated)
{
    const char *mark = "# --set ";
    size_t room = size + 2;
    char *end;

    for (int i = 0; i < setting_count; i++)
        room += strlen(mark) + strlen(settings[i]) + 1;
    *annotated = malloc(room);
    if (!*annotated)
        return STATUS_MEMORY;
    memcpy(*annotated, text, size);
    end = *annotated + size;
    if (size > 0 && end[-1] != '\n')
        *end++ = '\n';
    for (int i = 0; i < setting_count; i++) {
        end = stpcpy(stpcpy(end, mark), settings[i]);
        *end++ = '\n';
    }
    *end = '\0';
    return STATUS_OK;
}

/* Settings onto the scene's tree, or onto that of the discretization. */
static enum status apply(int setting_count, const char *const *settings,
                         struct yaml_tree *root, struct yaml_tree *numerics,
                         struct message *why)
{
    enum status st = STATUS_OK;

    for (int i = 0; i < setting_count; i++) {
        const struct yaml_tree blame = {.origin = settings[i]};

        if (strpbrk(settings[i], "\r\n"))
            return yaml_tree_refuse(&blame, why,
                                    "a line break in a setting; write one line");
        TRY(yaml_tree_set(is_numerics(settings[i]) ? numerics : root, settings[i], why));
    }
out:
    return st;
}

enum status scene_file_parse(const char *name, const char *text, size_t size,
                             int setting_count, const char *const *settings,
                             struct scene *scene, struct discretization *d,
                             struct message *why)
{
    enum status st = STATUS_OK;
    struct yaml_tree *root = NULL, numerics = {.kind = YAML_TREE_MAP, .origin = ""};
    struct discretization work = {.weights = NULL};

    memset(scene, 0, sizeof *scene);
    if (why)
        why->text[0] = '\0';
    TRY(discretization_copy(d, &work));
    TRY(scene_init(scene));
    free(scene->text), scene->text = NULL;
    TRY(yaml_tree_parse(name, false, text, size, &root, why));
    TRY(apply(setting_count, settings, root, &numerics, why));
    TRY(scene_schema_read(root, scene, why));
    TRY(scene_schema_read_numerics(&numerics, &work, why));
    TRY(annotate(text, size, setting_count, settings, &scene->text));
out:
    if (st == STATUS_OK) {
        struct discretization old = *d;

        *d = work, work = old;
    } else {
        scene_clear(scene);
        if (why && !why->text[0])
            status_fail(why, st, "a scene file: %s", status_text(st));
    }
    discretization_clear(&work);
    yaml_tree_free(numerics.first);
    yaml_tree_free(root);
    return st;
}

static enum status refuse_file(const char *path, const char *reason, struct message *why)
{
    const struct yaml_tree file = {.origin = path, .line = -1};

    yaml_tree_refuse(&file, why, "cannot be read as a scene: %s", reason);
    return STATUS_FILE;
}

/* Reads at most YAML_TREE_MAX_TEXT + 1 bytes of a file, enough to see that it is too long.
 */
static enum status read_bytes(const char *path, char **bytes, size_t *size,
                              struct message *why)
{
    const size_t most = YAML_TREE_MAX_TEXT + 1;
    enum status st = STATUS_OK;
    struct stat about;
    FILE *file = fopen(path, "rb");

    *bytes = NULL;
    if (!file)
        return refuse_file(path, strerror(errno), why);
    if (!fstat(fileno(file), &about) && S_ISDIR(about.st_mode))
        TRY(refuse_file(path, "it is a directory", why));
    *bytes = malloc(most);
    if (!*bytes)
        TRY(status_fail(why, STATUS_MEMORY, "a scene file: %s",
                        status_text(STATUS_MEMORY)));
    *size = fread(*bytes, 1, most, file);
    if (ferror(file))
        TRY(refuse_file(path, strerror(errno), why));
out:
    fclose(file);
    if (st != STATUS_OK)
        free(*bytes), *bytes = NULL;
    return st;
}

enum status scene_file_read(const char *path, int setting_count,
                            const char *const *settings, struct scene *scene,
                            struct discretization *d, struct message *why)
{
    enum status st = STATUS_OK;
    char *bytes = NULL;
    size_t size = 0;

    memset(scene, 0, sizeof *scene);
    TRY(read_bytes(path, &bytes, &size, why));
    TRY(scene_file_parse(path, bytes, size, setting_count, settings, scene, d, why));
out:
    free(bytes);
    return st;
}

/* Where scenes are, first found first: the user's folder, the one installed with the
 * running program (which may have been moved), the source tree's. */
enum { FOLDERS = 3 };
struct folders {
    char path[FOLDERS][PATH_MAX]; /* "" if there is none */
};

static struct folders find_folders(void)
{
    struct folders f = {0};
    const char *users = getenv("CLOTHBENCH_SCENES");
    char program[PATH_MAX / 2] = "";
    char *slash;

    if (readlink("/proc/self/exe", program, sizeof program - 1) < 0)
        program[0] = '\0';
    slash = strrchr(program, '/');
    if (users)
        snprintf(f.path[0], sizeof f.path[0], "%s", users);
    if (slash) {
        *slash = '\0';
        snprintf(f.path[1], sizeof f.path[1], "%s/%s", program, SCENES_FROM_PROGRAM);
    }
    snprintf(f.path[2], sizeof f.path[2], "%s", SCENES_IN_SOURCE);
    return f;
}

/* folder/name.yaml; NULL if memory is out. Free it. */
static char *join(const char *folder, const char *name)
{
    const size_t room = strlen(folder) + strlen(name) + sizeof "/.yaml";
    char *path = malloc(room);

    if (path)
        snprintf(path, room, "%s/%s.yaml", folder, name);
    return path;
}

static bool ends_in_yaml(const char *text)
{
    const size_t length = strlen(text);

    return length > 5 && !strcmp(text + length - 5, ".yaml");
}

static bool is_known(const struct scene_file_entry *entries, int count, const char *name)
{
    for (int i = 0; i < count; i++)
        if (!strcmp(entries[i].name, name))
            return true;
    return false;
}

/* The source line of folder/name.yaml, or what is wrong with it. */
static enum status read_source(const char *folder, const char *name, char **source)
{
    struct scene scene;
    struct discretization d = {.weights = NULL};
    struct message why;
    char *path = join(folder, name);

    if (!path)
        return STATUS_MEMORY;
    if (scene_file_read(path, 0, NULL, &scene, &d, &why) == STATUS_OK)
        *source = scene.source, scene.source = NULL;
    else
        *source = strdup(why.text);
    scene_clear(&scene);
    free(path);
    return *source ? STATUS_OK : STATUS_MEMORY;
}

/* Adds the scene in `file` of a folder, unless it is none or has a known name. */
static enum status add_entry(const char *folder, const char *file,
                             struct scene_file_entry **entries, int *count)
{
    enum status st = STATUS_OK;
    struct scene_file_entry entry = {.name = NULL}, *grown;

    if (!ends_in_yaml(file))
        return STATUS_OK;
    entry.name = strdup(file);
    if (!entry.name)
        return STATUS_MEMORY;
    entry.name[strlen(file) - strlen(".yaml")] = '\0';
    if (is_known(*entries, *count, entry.name))
        goto out;
    TRY(read_source(folder, entry.name, &entry.source));
    grown = realloc(*entries, ((size_t)*count + 1) * sizeof *grown);
    if (!grown)
        TRY(STATUS_MEMORY);
    *entries = grown;
    grown[(*count)++] = entry;
    return STATUS_OK;
out:
    free(entry.name);
    free(entry.source);
    return st;
}

static int compare_names(const void *a, const void *b)
{
    const struct scene_file_entry *left = a, *right = b;

    return strcmp(left->name, right->name);
}

enum status scene_file_list(struct scene_file_entry **entries, int *count,
                            struct message *why)
{
    enum status st = STATUS_OK;
    const struct folders folders = find_folders();
    DIR *directory = NULL;

    *entries = NULL, *count = 0;
    for (int i = 0; i < FOLDERS; i++) {
        const struct dirent *file;

        directory = opendir(folders.path[i]);
        if (!directory)
            continue;
        while ((file = readdir(directory)))
            TRY(add_entry(folders.path[i], file->d_name, entries, count));
        closedir(directory), directory = NULL;
    }
    if (*count > 0)
        qsort(*entries, (size_t)*count, sizeof **entries, compare_names);
out:
    if (directory)
        closedir(directory);
    if (st != STATUS_OK) {
        scene_file_list_free(*entries, *count);
        *entries = NULL, *count = 0;
        status_fail(why, st, "the list of scenes: %s", status_text(st));
    }
    return st;
}

void scene_file_list_free(struct scene_file_entry *entries, int count)
{
    for (int i = 0; i < count; i++) {
        free(entries[i].name);
        free(entries[i].source);
    }
    free(entries);
}

/* The sentence for a name that is no scene. */
static enum status refuse_name(const char *argument, struct message *why)
{
    enum status st = STATUS_OK;
    struct scene_file_entry *entries = NULL;
    int count = 0;
    size_t used;

    TRY(scene_file_list(&entries, &count, why));
    st = status_fail(why, STATUS_INPUT, "no scene %s; give the path of a file, or one of",
                     yaml_tree_quote(argument).text);
    for (int i = 0; why && i < count; i++) {
        used = strlen(why->text);
        snprintf(why->text + used, sizeof why->text - used, "%s %s", i ? "," : "",
                 entries[i].name);
    }
out:
    scene_file_list_free(entries, count);
    return st;
}

enum status scene_file_find(const char *argument, char **path, struct message *why)
{
    const struct folders folders = find_folders();

    if (strchr(argument, '/') || ends_in_yaml(argument)) {
        *path = strdup(argument);
        return *path ? STATUS_OK : STATUS_MEMORY;
    }
    for (int i = 0; *argument && i < FOLDERS; i++) {
        char *candidate = join(folders.path[i], argument);

        if (!candidate)
            return STATUS_MEMORY;
        if (*folders.path[i] && !access(candidate, F_OK)) {
            *path = candidate;
            return STATUS_OK;
        }
        free(candidate);
    }
    return refuse_name(argument, why);
}

void scene_file_keys(void (*line)(void *context, const char *key, const char *text),
                     void *context)
{
    scene_schema_list(line, context);
}
