/* scene_check.h - checks values of a scene that no single key can judge. */
#ifndef SCENE_CHECK_H
#define SCENE_CHECK_H

#include "models/scene.h"
#include "models/reader/yaml_tree.h"

enum { SCENE_MAX_FRAMES = 10000000 }; /* end / step */

/* Checks a scene just read from `root`, and reads the meshes that it names, if `files`,
 * from the folder of the root's origin. Refused, with one sentence at the line to blame:
 * axes that are not orthonormal (to a thousandth, and are then made so), both pose and
 * sheets, a place along a sheet that is not named or not there, a sheet that
 * begins in an obstacle or in another, a range of contact that is not less than its
 * thickness, meshes that cannot be read, numbers of a damping or pose that its kind does
 * not take or needs, a cloak that reaches its own axis, more than SCENE_MAX_FRAMES frames,
 * snapshots after the end, supports that hold the same points in the same component along
 * different paths.
 *
 * A setting outranks the file: numbers of the file that a kind given as a setting does not
 * take are set to zero, and snapshots of the file after an end given as a setting
 * are dropped. */
enum status scene_check(const struct yaml_tree *root, bool files, struct scene *scene,
                        struct message *why);

#endif
