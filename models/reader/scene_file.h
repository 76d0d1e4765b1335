/* scene_file.h - scenes from YAML files, with the command line's settings on top.
 *
 * Settings are strings `key=value`: `material.young=5e4`, `supports[0].fix=xy`,
 * `damping={kind: none}`, `discretization.points=[10,10,2]`. The value is YAML; later
 * settings win; a discretization is reached by settings only. scene_schema.c says what a
 * setting does to values of the file that it makes meaningless.
 *
 * What is wrong is said in one sentence without a line break, `file:line: ...` or
 * `--set KEY=VALUE: ...` (STATUS_INPUT), or `file: ...` where there is no line because the
 * file cannot be read (STATUS_FILE). Files that a scene names are sought from its folder,
 * also those that a setting names.
 */
#ifndef SCENE_FILE_H
#define SCENE_FILE_H

#include <stddef.h>

#include "models/discretization.h"
#include "models/reader/named_file.h"
#include "models/scene.h"

/* Reads a scene. *scene is overwritten, not freed; free with scene_clear. *d holds a
 * model's defaults on entry and is overridden key by key. On failure *scene is all-zero and
 * *d as it was. */
enum status scene_file_read(const char *path, int setting_count,
                            const char *const *settings, struct scene *scene,
                            struct discretization *d, struct message *why);

/* Reads likewise text[size] in memory (any bytes), called `name` in sentences. No other
 * file is read: meshes that it names are missing, and nothing meets them. */
enum status scene_file_parse(const char *name, const char *text, size_t size,
                             int setting_count, const char *const *settings,
                             struct scene *scene, struct discretization *d,
                             struct message *why);

/* The places of scenes with names (named_file.h): $CLOTHBENCH_SCENES first. */
extern const struct named_file_kind scene_file_kind;

/* Calls named_file_find for a SCENE argument. */
enum status scene_file_find(const char *argument, char **path, struct message *why);

#endif
