/* site_scene.h - the page of a scene in a site. A damaged truth or table is told in it.
 * Statuses, with a sentence where there is a `why`: of reading what they read, STATUS_FILE,
 * STATUS_MEMORY. */
#ifndef SITE_SCENE_H
#define SITE_SCENE_H

#include <stdbool.h>
#include <stdio.h>

#include "bench/harness/contestant.h"
#include "bench/report/report_part.h"

/* Writes the page OUT/scene_NAME.html - pictures of its truth, speed against error, the
 * truth's error bars, its file -, and a row of the index's table of scenes into `rows`.
 * `folder` has the results. */
enum status site_scene_write(const char *out, const char *folder,
                             const struct report_found *found, const char *name, FILE *rows,
                             struct message *why);

/* Writes a scene's chart alone, without links; nothing where it was not measured. */
enum status site_scene_chart(FILE *file, const char *folder,
                             const struct report_found *found, const char *name);

#endif
