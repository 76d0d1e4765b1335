/* site_parts.h - the pages of a site, and what is drawn in them. All functions that write a
 * file put it into the folder `out`; a damaged truth or table is told in the page.
 * Statuses, with a sentence where there is a `why`: of reading what they read, STATUS_FILE,
 * STATUS_MEMORY. */
#ifndef SITE_PARTS_H
#define SITE_PARTS_H

#include <stdbool.h>
#include <stdio.h>

#include "bench/harness/contestant.h"
#include "bench/report/report_part.h"

/* Writes the page scene_NAME.html - pictures of its truth, speed against error, the truth's
 * error bars, its file -, and a row of the index's table of scenes into `rows`. `folder`
 * has the results. */
enum status site_scene_write(const char *out, const char *folder,
                             const struct report_found *found, const char *name, FILE *rows,
                             struct message *why);

/* Writes a scene's chart alone, without links; nothing where it was not measured. */
enum status site_scene_chart(FILE *file, const char *folder,
                             const struct report_found *found, const char *name);

/* Writes the page contestant_NAME.html - its rows over scenes and hard cases, its settings
 * and options -, and a row of the index's table of contestants into `rows`. */
enum status site_contestant_write(const char *out, const struct report_found *found,
                                  const struct contestant *c, FILE *rows,
                                  struct message *why);

/* Writes manual_NAME.html for each page of the manual, the pictures that they show beside
 * them, and an item of a list with a link to each into `list`. Links between pages stay
 * links; those to files that are no page become plain text. */
enum status site_manual_write(const char *out, FILE *list, struct message *why);

/* Writes the chart of a table of runs, error against seconds: the best contestant of each
 * model, and a legend in which contestants have `links` to their pages. Nothing is written
 * where no run has both numbers > 0. `bar` is the truth's error bar over the length. */
enum status site_chart_write(FILE *file, const struct csv_table *runs, double bar,
                             bool links);

/* Writes a drawing for each of `count` fields (grid.h) [m] at time[count] [s], all from one
 * side and in one scale. */
enum status site_sheet_write(FILE *file, const struct scene *scene, int count,
                             const double *const *xyz, const double *time);

#endif
