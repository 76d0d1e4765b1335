/* picture.h - pictures of sheets by gnuplot: panels side by side, one view, one box and one
 * scale for all, shaded so that folds can be seen.
 *
 * NAME.png comes from NAME.gp, which holds every third point of the mid-surfaces and stays
 * in the folder, so that a view or a size can be changed there and `gnuplot NAME.gp` run
 * again.
 */
#ifndef PICTURE_H
#define PICTURE_H

#include "models/status.h"

struct picture_panel {
    const char *title; /* one line, or two with \n                            borrowed */
    const double *xyz; /* field (grid.h) [m]; NULL: the panel has its title only       */
    int sheets;        /* that share the field's columns; 0: one                       */
};

/* Draws `count` panels >= 1 in rows of `columns`, and says on standard error that they are
 * drawn, or why not. Like chart_save (chart.h), it fails only with STATUS_FILE and
 * STATUS_MEMORY: without gnuplot the script is there. */
enum status picture_save(const char *folder, const char *name, int columns, int count,
                         const struct picture_panel *panels, struct message *why);

#endif
