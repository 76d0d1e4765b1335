/* truth_physics.h - what of a scene its motion depends on, as text: a truth holds for every
 * scene and all settings with the same text, whatever their names, times and numerics. */
#ifndef TRUTH_PHYSICS_H
#define TRUTH_PHYSICS_H

#include "models/scene.h"

/* Lines `key value...` with 17 digits: sheet, pose, material, loads, damping, supports and
 * obstacles. *text is freed by the receiver. STATUS_MEMORY. */
enum status truth_physics(const struct scene *scene, char **text);

/* Whether a text is this scene's. STATUS_UNSUPPORTED: it is of other physics, and the
 * sentence says of which; STATUS_MEMORY. */
enum status truth_physics_check(const char *text, const struct scene *scene,
                                struct message *why);

#endif
