/* truth_frames.h - a truth as other programs' frames: positions of a net of points. */
#ifndef TRUTH_FRAMES_H
#define TRUTH_FRAMES_H

#include <stdio.h>

#include "bench/truth/truth_made.h"

enum { TRUTH_FRAMES_MOST = 1000 }; /* points a direction */

/* Lines t,u,v,x,y,z of points[0] x points[1] points (u, v) = (i/(n-1), j/(m-1)) of the
 * mid-surface, u fastest, at every time that is claimed: bilinear in the material grid, and
 * with 100 x 100 the grid itself, 17 digits. Before them comment lines `# source: ...` and
 * `# bar: t, error bar [m]` a time. STATUS_FILE: the stream does not take it. */
enum status truth_frames_print(const struct truth_made *made, const int points[2],
                               FILE *file);

#endif
