/* scene_file.c - makes scenes from files and settings. scene_schema.c has the keys. */
#include "models/reader/scene_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "models/bodies/body_mesh.h"
#include "models/pattern.h"
#include "models/reader/input_file.h"
#include "models/reader/scene_schema.h"

static bool is_numerics(const char *setting)
{
    const size_t length = strlen("discretization");

    return !strncmp(setting, "discretization", length) &&
           (setting[length] == '.' || setting[length] == '=');
}

/* Writes the sum of a file that discretization.mesh names: a result depends on what is in
 * it. One that cannot be read is refused by who reads it. */
static void note_mesh(FILE *out, const char *setting)
{
    static const char key[] = "discretization.mesh=";
    char path[4096];
    const char *reason;
    unsigned long long sum = 14695981039346656037u; /* FNV-1a, 64 bits */

    if (strncmp(setting, key, sizeof key - 1) != 0)
        return;
    setting += sizeof key - 1;
    const bool quoted = *setting == '"' || *setting == '\'';
    snprintf(path, sizeof path, "%s", setting + quoted);
    path[strcspn(path, quoted ? "\"'" : "")] = '\0';
    FILE *file = input_file_open(path, &reason);
    if (!file)
        return;
    for (int c = getc(file); c != EOF; c = getc(file))
        sum = (sum ^ (unsigned char)c) * 1099511628211u;
    fclose(file);
    fprintf(out, "# mesh %s, sum %016llx\n", path, sum);
}

/* Writes the scene's text: the file's, below it the settings and sums of meshes as
 * comments. */
static enum status annotate(const char *text, size_t size, int setting_count,
                            const char *const *settings, struct scene *scene)
{
    FILE *out = open_memstream(&scene->text, &(size_t){0});

    if (!out)
        return STATUS_MEMORY;
    fwrite(text, 1, size, out);
    if (size > 0 && text[size - 1] != '\n')
        fputc('\n', out);
    for (int i = 0; i < setting_count; i++)
        fprintf(out, "# --set %s\n", settings[i]);
    for (int i = 0; i < setting_count; i++)
        note_mesh(out, settings[i]);
    for (int n = 0; n < scene->obstacle_count; n++)
        if (scene->obstacles[n].mesh)
            fprintf(out, "# mesh %s, sum %016llx\n", scene->obstacles[n].file,
                    (unsigned long long)body_mesh_view(scene->obstacles[n].mesh).mark);
    if (scene->pattern_file && scene->pattern)
        fprintf(out, "# mesh %s, sum %016llx\n", scene->pattern_file,
                pattern_sum(scene->pattern));
    return fclose(out) == 0 ? STATUS_OK : STATUS_MEMORY;
}

/* Applies settings to the scene's tree, or to that of the discretization. */
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

static enum status parse(const char *name, bool files, const char *text, size_t size,
                         int setting_count, const char *const *settings,
                         struct scene *scene, struct discretization *d, struct message *why)
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
    TRY(scene_schema_read(root, files, scene, why));
    TRY(scene_schema_read_numerics(&numerics, &work, why));
    TRY(annotate(text, size, setting_count, settings, scene));
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

enum status scene_file_parse(const char *name, const char *text, size_t size,
                             int setting_count, const char *const *settings,
                             struct scene *scene, struct discretization *d,
                             struct message *why)
{
    return parse(name, false, text, size, setting_count, settings, scene, d, why);
}

enum status scene_file_read(const char *path, int setting_count,
                            const char *const *settings, struct scene *scene,
                            struct discretization *d, struct message *why)
{
    enum status st = STATUS_OK;
    char *bytes = NULL;
    size_t size = 0;

    memset(scene, 0, sizeof *scene);
    TRY(named_file_read(&scene_file_kind, path, &bytes, &size, why));
    TRY(parse(path, true, bytes, size, setting_count, settings, scene, d, why));
out:
    free(bytes);
    return st;
}

/* Returns what happens in a scene or, if it does not say, its source; or what is wrong. */
static char *describe(const char *path)
{
    struct scene scene;
    struct discretization d = {.weights = NULL};
    struct message why;
    char *text;

    if (scene_file_read(path, 0, NULL, &scene, &d, &why) == STATUS_OK && scene.about)
        text = scene.about, scene.about = NULL;
    else if (scene.source)
        text = scene.source, scene.source = NULL;
    else
        text = strdup(why.text);
    scene_clear(&scene);
    return text;
}

const struct named_file_kind scene_file_kind = {
    .what = "scene",
    .ending = ".yaml",
    .environment = "CLOTHBENCH_SCENES",
    .from_program = SCENES_FROM_PROGRAM,
    .in_source = SCENES_IN_SOURCE,
    .describe = describe,
};

enum status scene_file_find(const char *argument, char **path, struct message *why)
{
    return named_file_find(&scene_file_kind, argument, path, why);
}
