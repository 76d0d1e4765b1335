/* report.h - the command `report`: one page of HTML from what other commands left. */
#ifndef REPORT_H
#define REPORT_H

#include "bench/ui/command.h"

/* The page is smaller [bytes]. */
#define REPORT_MOST 10000000

extern const struct command report_command;

/* The page about `folder` at `path`. STATUS_INPUT: no such folder; no page of ours to fill
 * in; more than fits. STATUS_FILE, STATUS_MEMORY; with a sentence. */
enum status report_write(const char *folder, const char *path, struct message *why);

#endif
