/* report_page.h - the one page of all results: page.html, which comes with the program,
 * filled in. */
#ifndef REPORT_PAGE_H
#define REPORT_PAGE_H

#include "bench/report/report_summary.h"

/* Writes the page about `folder` with all data, and pictures as far as there is room for
 * them; fills `said` with what was found. STATUS_INPUT: there is no page of ours to fill
 * in, or more than fits; STATUS_MEMORY. */
enum status report_page_write(FILE *file, const char *folder,
                              const struct report_found *found,
                              char said[REPORT_SENTENCES][REPORT_SENTENCE],
                              struct message *why);

#endif
