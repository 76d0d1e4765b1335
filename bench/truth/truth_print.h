/* truth_print.h - what is known of scenes as tables and as positions. */
#ifndef TRUTH_PRINT_H
#define TRUTH_PRINT_H

#include "bench/truth/truth_made.h"
#include "bench/ui/table.h"

/* Prints orders, bars, differences and growth at its times, and until when it is claimed.
 * Of a truth with many frames the times at which tables judge (truth_plan_judges), and the
 * last that is claimed. As table_print. */
enum status truth_print(const struct truth_made *made, const struct scene *scene,
                        enum table_format format, FILE *file);

enum { TRUTH_FRAMES_MOST = 1000 }; /* points a direction */

/* Prints lines t,u,v,x,y,z of points[0] x points[1] points (u, v) = (i/(n-1), j/(m-1)) of
 * the mid-surface, u fastest, at every time that is claimed: bilinear in the material grid,
 * and with 100 x 100 the grid itself, 17 digits. Before them comment lines `# source: ...`
 * and
 * `# bar: t, error bar [m]` a time. STATUS_FILE: the stream does not take it. */
enum status truth_print_frames(const struct truth_made *made, const int points[2],
                               FILE *file);

/* Prints a row for each of the program's scenes, as its truth moves: closed form, stored or
 * none; until when it is known, the error bar there; a note on each that has none. */
enum status truth_print_all(enum table_format format, FILE *file, struct message *why);

#endif
