/* site_sheet.h - pictures of a scene for pages: its sheets and bodies at several times, as
 * drawings in the page itself. */
#ifndef SITE_SHEET_H
#define SITE_SHEET_H

#include <stdio.h>

#include "models/scene.h"

/* Writes a drawing for each of `count` fields (grid.h) [m] at time[count] [s], all from one
 * side and in one scale, with the balls and capsules of the scene where they are then.
 * STATUS_MEMORY. */
enum status site_sheet_write(FILE *file, const struct scene *scene, int count,
                             const double *const *xyz, const double *time);

#endif
