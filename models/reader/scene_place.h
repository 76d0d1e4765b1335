/* scene_place.h - the keys of supports and loads, for the table of a scene's keys.
 */
#ifndef SCENE_PLACE_H
#define SCENE_PLACE_H

#include "models/reader/schema.h"
#include "models/scene.h"

/* The most of each; SCENE_MAX_PATH is the most rows of one support's path. */
enum { SCENE_MAX_SUPPORTS = 100, SCENE_MAX_LOADS = 100, SCENE_MAX_PATH = 1000 };

/* The keys of one support, of one load. */
extern const struct schema_key scene_place_support[], scene_place_load[];

/* Read the lists into a struct scene; errors as schema_read. */
enum status scene_place_supports(const struct schema_key *key, const struct yaml_tree *node,
                                 void *target, struct message *why);
enum status scene_place_loads(const struct schema_key *key, const struct yaml_tree *node,
                              void *target, struct message *why);

#endif
