/* truth_sharp.h - a truth just as sharp as is asked for: the cured shell (p = 3) on nets
 * and with steps that shrink by a third each time, until what its observed order leaves is
 * small enough, or the next one would take too long.
 */
#ifndef TRUTH_SHARP_H
#define TRUTH_SHARP_H

#include "bench/truth/truth_level.h"

struct truth_wish {
    double error;   /* the largest error bar over the length that is asked for         */
    double seconds; /* that all runs together may take, as far as it can be foreseen   */
};

enum { TRUTH_SHARP_SOURCE = 512 };

/* Fields at the times of `runs` into xyz[times], error bars into error[times] [m], a
 * sentence. `step` is the scene's, of which the times are multiples. At least two runs are
 * made. STATUS_DIVERGED, STATUS_UNSUPPORTED as truth_level_find. */
enum status truth_sharp_fields(const struct truth_runs *runs, double step, double length,
                               const struct truth_wish *wish, double *const *xyz,
                               double *error, char source[TRUTH_SHARP_SOURCE],
                               struct message *why);

#endif
