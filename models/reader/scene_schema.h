/* scene_schema.h - the keys of a scene file and of a discretization, and the checks that
 * look at more than one value. */
#ifndef SCENE_SCHEMA_H
#define SCENE_SCHEMA_H

#include "models/discretization.h"
#include "models/scene.h"
#include "models/reader/schema.h"

/* The keys of an obstacle: first its kinds, by enum obstacle_kind; targets are obstacles.
 */
extern const struct schema_key scene_schema_obstacles[];

/* Reads a scene's tree into *scene, which comes from scene_init. Files that it names are
 * sought from the folder of the root's origin; without `files` they are not read, and
 * meshes are missing. Errors as schema_read. */
enum status scene_schema_read(const struct yaml_tree *root, bool files, struct scene *scene,
                              struct message *why);

/* Reads the section `discretization` of a tree made of settings, if it is there, into *d.
 * Errors as schema_read. */
enum status scene_schema_read_numerics(const struct yaml_tree *root,
                                       struct discretization *d, struct message *why);

/* Prints a discretization the way --set takes it: lines `discretization.key=value`, every
 * key that models share and the model's own, 17 digits; *text is freed by the receiver. */
enum status scene_schema_print(const struct discretization *d, char **text);

/* Calls line() for every key that a scene or a setting of any model may have, with what it
 * may be. */
void scene_schema_list(void (*line)(void *context, const char *key, const char *text),
                       void *context);

#endif
