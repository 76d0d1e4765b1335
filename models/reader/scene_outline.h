/* scene_outline.h - the section `sheet` of a scene: a rectangle, an outline with holes, or
 * a mesh. */
#ifndef SCENE_OUTLINE_H
#define SCENE_OUTLINE_H

#include "models/reader/yaml_tree.h"
#include "models/scene.h"
#include "models/schema_key.h"

/* Leaves to scene_outline_check what takes several keys. */
enum status scene_outline_later(const struct schema_key *key, const struct yaml_tree *node,
                                void *target, struct message *why);

/* Its keys; targets are scenes. */
extern const struct schema_key scene_outline_keys[];

/* Checks, once pose and sheets are read, that a sheet has length and width, or an outline,
 * or a mesh, which it reads if `files`, and makes the pattern of these: its box gets its
 * corner where the pose says that 0 of the pattern is. Then finds the supports that name
 * vertices and groups of it. STATUS_INPUT with a sentence. */
enum status scene_outline_check(const struct yaml_tree *root, bool files,
                                struct scene *scene, struct message *why);

#endif
