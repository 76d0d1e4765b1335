/* site_index.h - a static site of all that is known: an index, a page for each scene and
 * each contestant, the manual, and the page of all results. It needs no server, and but for
 * the last page no script; everything is in one folder, and links are relative. */
#ifndef SITE_INDEX_H
#define SITE_INDEX_H

#include "bench/report/report_part.h"

/* Writes the site about the results in `folder` into the folder `path`, which appears as a
 * whole. STATUS_INPUT with a sentence: there is a folder of that name which is no site, or
 * a scene or page of the manual is wrong; STATUS_FILE, STATUS_MEMORY. */
enum status site_index_write(const char *path, const char *folder,
                             const struct report_found *found, struct message *why);

#endif
