/* show.h - has the Python package (python/clothbench) show what the program left in files:
 * the program computes, the package makes pages, charts and pictures. */
#ifndef SHOW_H
#define SHOW_H

#include "models/status.h"

enum { SHOW_WORDS = 6 }; /* most words of show_run                                       */

/* Runs the package with these words, which NULL ends, and waits for it. STATUS_LIBRARY
 * with a sentence: it cannot be run, or Python or a package of it is missing, whose Debian
 * packages are named; STATUS_INPUT, STATUS_FILE: it says what is wrong. */
enum status show_run(const char *const *words, struct message *why);

/* Says on standard error which command draws the results in a folder. */
void show_tell(const char *folder);

#endif
