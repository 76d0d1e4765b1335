/* site_manual.h - the manual's pages, doc/NAME.md, as pages of a site. */
#ifndef SITE_MANUAL_H
#define SITE_MANUAL_H

#include <stdio.h>

#include "models/reader/named_file.h"

/* The places of the pages: $CLOTHBENCH_MANUAL first. */
extern const struct named_file_kind site_manual_kind;

/* Writes FOLDER/manual_NAME.html for each page, and the pictures that they show beside
 * them; and an item of a list with a link to each, into `list`. Links to other pages stay
 * links, and those to files that are no page become plain text. STATUS_INPUT or STATUS_FILE
 * with a sentence: a page cannot be read, or none is there; STATUS_MEMORY. */
enum status site_manual_write(const char *folder, FILE *list, struct message *why);

#endif
