/* picture.h - pictures of sheets by gnuplot: panels side by side, one view, one box and one
 * scale for all, shaded so that folds can be seen.
 *
 * NAME.png comes from NAME.gp and NAME.dat (every third point of the mid-surfaces), which
 * stay in the folder, so that a view or a size can be changed there and `gnuplot NAME.gp`
 * run again.
 */
#ifndef PICTURE_H
#define PICTURE_H

#include "models/status.h"

struct picture_panel {
    const char *title; /* one line, or two with \n                            borrowed */
    const double *xyz; /* field (grid.h) [m]; NULL: the panel has its title only       */
};

/* `count` panels >= 1 in rows of `columns`. STATUS_OK; STATUS_UNSUPPORTED with a sentence
 * if there is no gnuplot (script and data are there); STATUS_LIBRARY if it fails;
 * STATUS_FILE, STATUS_MEMORY. */
enum status picture_surfaces(const char *folder, const char *name, int columns, int count,
                             const struct picture_panel *panels, struct message *why);

/* The same as chart_save (chart.h) does it: a line on standard error, and no failure for
 * want of gnuplot. */
enum status picture_save(const char *folder, const char *name, int columns, int count,
                         const struct picture_panel *panels, struct message *why);

#endif
