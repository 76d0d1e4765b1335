/* plot.h - pictures by gnuplot, where it is installed. */
#ifndef PLOT_H
#define PLOT_H

#include "models/status.h"

/* Hands `script` to gnuplot, which runs in `folder`. STATUS_OK; STATUS_UNSUPPORTED with a
 * sentence if there is no gnuplot; STATUS_LIBRARY if it fails. */
enum status plot_run(const char *folder, const char *script, struct message *why);

#endif
