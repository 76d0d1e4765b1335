/* plot.h - begins and ends a script for gnuplot, writes texts in it, and runs it. All that
 * depends on gnuplot's terminals stands in plot.c. */
#ifndef PLOT_H
#define PLOT_H

#include "bench/files/output.h"
#include "models/status.h"

/* Starts FOLDER/NAME.gp, which is written through output_stream. NAME has letters, digits,
 * _, - and . only: STATUS_INPUT. Also STATUS_FILE. Data blocks of gnuplot come first. */
enum status plot_begin(const char *folder, const char *name, struct output **out,
                       struct message *why);

enum plot_kind { PLOT_PNG, PLOT_SVG, PLOT_PDF, PLOT_KINDS };

/* Draws what is written from here to the next page or plot_end into NAME.png, NAME.svg or
 * NAME.pdf, `width` x `height` points of a screen. Point sizes are multiples of the
 * variable `scale`. Loops of gnuplot would be shorter, but they would interpret quotes and
 * braces in words. */
void plot_page(FILE *script, const char *name, enum plot_kind kind, int width, int height);

/* Write any words as a string of gnuplot, which interprets no part of them; control
 * characters become blanks, line ends only in plot_line. No other function writes words
 * into a script. */
void plot_line(FILE *script, const char *text);
void plot_lines(FILE *script, const char *text);

/* Closes the script of plot_begin, whose *out is NULL then, and has gnuplot draw it.
 * STATUS_OK; STATUS_UNSUPPORTED with a sentence if there is no gnuplot; STATUS_LIBRARY if
 * it fails; STATUS_FILE. */
enum status plot_end(const char *folder, const char *name, struct output **out,
                     struct message *why);

/* Tells people on standard error which files NAME.ENDINGS there are in `folder`, or `plot`,
 * why there are none. A status that only means "no picture" becomes STATUS_OK: results are
 * worth having without; others come back with *why. */
enum status plot_tell(enum status st, const char *folder, const char *name,
                      const char *endings, const struct message *plot, struct message *why);

#endif
