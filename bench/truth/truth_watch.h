/* truth_watch.h - until when a scene's motion is predictable at all: gravity is changed a
 * little, and the change watched for as long as the scene lasts. */
#ifndef TRUTH_WATCH_H
#define TRUTH_WATCH_H

#include "bench/truth/truth_level.h"
#include "bench/truth/truth_plan.h"

enum { TRUTH_WATCH_TEXT = 256 };

/* Where TRUTH_PERTURBATION has grown so many times (rms over the length), a net's own 1e-3
 * has grown to the size of the sheet: nothing can be claimed. */
#define TRUTH_MOST_GROWTH 1e3

/* The coarse solid of the plan (with obstacles, the middle one), with twice its step, every
 * tenth of a second up to the scene's end or the plan's; a sentence on the growth into
 * text. A death is one, too. */
enum status truth_watch(const struct truth_plan *plan, const struct truth_runs *runs,
                        const struct scene *scene, char text[TRUTH_WATCH_TEXT],
                        struct message *why);

#endif
