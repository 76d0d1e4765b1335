/* store_scene.h - the scene of a run that is being read: its text, and of a sheet with a
 * mesh the pattern that stands in the file, since no other file is read again.
 */
#ifndef STORE_SCENE_H
#define STORE_SCENE_H

#include "bench/files/store.h"

/* Reads the scene of a result file as it was run: the file keeps its text with its settings
 * below as lines `# --set KEY=VALUE`; they are applied again. *scene is overwritten, and
 * freed with scene_clear. */
enum status store_scene(struct store_read *file, const char *path, struct scene *scene,
                        struct message *why);

#endif
