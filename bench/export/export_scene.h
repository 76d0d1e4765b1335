/* export_scene.h - a scene written as a scene file: what was set on the command line is in
 * it, and so is whatever its truth changes; comments are not. */
#ifndef EXPORT_SCENE_H
#define EXPORT_SCENE_H

#include "bench/export/export_sheet.h"

/* scene.yaml, 17 digits: read again it has the same physics (truth_physics.h) and times. */
enum status export_scene_write(const struct export_sheet *s, struct message *why);

#endif
