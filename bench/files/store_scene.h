/* store_scene.h - the scene of a result file, with the settings it was run with. */
#ifndef STORE_SCENE_H
#define STORE_SCENE_H

#include "bench/files/store_read.h"
#include "models/scene.h"

/* The file keeps the scene's text with its settings below as lines `# --set KEY=VALUE`;
 * they are applied again. *scene is overwritten, and freed with scene_clear. */
enum status store_scene(const struct store_read *file, const char *path,
                        struct scene *scene, struct message *why);

#endif
