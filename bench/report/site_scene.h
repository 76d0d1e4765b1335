/* site_scene.h - the page of a scene: its pictures, its truth with the error bar, its file,
 * and the speed of contestants against their error. */
#ifndef SITE_SCENE_H
#define SITE_SCENE_H

#include <stdio.h>

#include "bench/report/report_part.h"

/* Writes OUT/scene_NAME.html from the results in `folder`, and a row of the index's table
 * of scenes into `rows`. Statuses of reading the scene, STATUS_FILE, STATUS_MEMORY, with a
 * sentence; a damaged truth or table is told in the page. */
enum status site_scene_write(const char *out, const char *folder,
                             const struct report_found *found, const char *name, FILE *rows,
                             struct message *why);

/* Writes the chart alone, without links; nothing where the scene was not measured. Statuses
 * of reading the scene. */
enum status site_scene_chart(FILE *file, const char *folder,
                             const struct report_found *found, const char *name);

#endif
