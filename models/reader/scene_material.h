/* scene_material.h - the section `material` of a scene: E, nu and rho; or a fabric by name;
 * or by its moduli (models/law/law.h). */
#ifndef SCENE_MATERIAL_H
#define SCENE_MATERIAL_H

#include "models/reader/schema.h"
#include "models/scene.h"

/* The sentence about a sheet's own material where one of the two is a fabric. */
#define SCENE_MATERIAL_OWN                                                                 \
    "sheets share their thickness, which a fabric has of its own: a sheet can have a "     \
    "material of its own where both this and the scene's are isotropic, of young, "        \
    "poisson "                                                                             \
    "and density"

extern const struct schema_key scene_material_keys[];

/* Checks a section just read (schema_key.h): its keys are of one kind, and all are there. A
 * setting outranks the file: keys of the file that are of another kind than those of
 * settings are ignored. Puts a named fabric into scene->fabric, and sets scene->is_fabric.
 */
enum status scene_material_check(const struct schema_key *key, const struct yaml_tree *node,
                                 void *scene, struct message *why);

/* Checks that an isotropic sheet has a thickness, and a fabric none but its own, h_eff,
 * which it gets with the rest that follows from it. A setting of material outranks the
 * thickness of the file. */
enum status scene_material_thickness(const struct yaml_tree *root, struct scene *scene,
                                     struct message *why);

#endif
