/* report_motion.h - motions of a scene that the page plays, over the ghost of its truth;
 * and the stored truths, with their error bars. */
#ifndef REPORT_MOTION_H
#define REPORT_MOTION_H

#include <stdio.h>

#include "bench/report/report_part.h"

/* Writes members of an array of JSON: the stored truth of edge_drop, all its frames; every
 * result file of FOLDER/run_edge_drop; then the nearest run of every contestant of
 * `compare` that left its file in `folder`. {"name", "truth", "side", "stride", "scale",
 * "time", "data"}: int16 [times][side][side][3] of the mid-surface, little endian, in
 * base64, times scale [m]; of a run with more frames than there is room for every
 * stride-th. A file that cannot be read gives {"name", "trouble"}. STATUS_MEMORY. */
enum status report_motion_write(FILE *file, const char *folder,
                                const struct report_found *compare);

/* Writes members of an array: {"scene", "note", "horizon", "commit", "time", "bar",
 * "claimed"} of each stored truth, or its "trouble". Bars are in metres. STATUS_MEMORY. */
enum status report_motion_truths(FILE *file);

#endif
