/* site_contestant.h - the page of a contestant: what it is, its settings and options, its
 * rows over scenes and hard cases. */
#ifndef SITE_CONTESTANT_H
#define SITE_CONTESTANT_H

#include <stdio.h>

#include "bench/harness/contestant.h"
#include "bench/report/report_part.h"

/* Writes OUT/contestant_NAME.html, and a row of the index's table of contestants into
 * `rows`. STATUS_FILE, STATUS_INPUT with a sentence. */
enum status site_contestant_write(const char *out, const struct report_found *found,
                                  const struct contestant *c, FILE *rows,
                                  struct message *why);

#endif
