/* report.h - the command `report`: makes one page of HTML from other commands' results. */
#ifndef REPORT_H
#define REPORT_H

#include "bench/ui/command.h"

/* The page is smaller than this [bytes]. */
#define REPORT_MOST 10000000

extern const struct command report_command;

/* Writes the page about `folder` at `path`. STATUS_INPUT: there is no such folder, no page
 * of ours to fill in, or more than fits. STATUS_FILE, STATUS_MEMORY; with a sentence. */
enum status report_write(const char *folder, const char *path, struct message *why);

#endif
