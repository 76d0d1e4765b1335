/* truth_sharp.h - a truth just as sharp as is asked for: the selective solid and the
 * cured shell (p = 3) on nets and with steps that shrink alike, one run after another,
 * until the bar (truth_bar.h) is small enough or the
 * wish cannot be met (truth_wish.h). Each run is a file: a command that was killed goes on
 * with what it left.
 */
#ifndef TRUTH_SHARP_H
#define TRUTH_SHARP_H

#include <stdio.h>

#include "bench/truth/truth_bar.h"
#include "bench/truth/truth_wish.h"

struct truth_sharp {
    double frame; /* of which the times are multiples: what all steps divide [s]        */
    FILE *say;    /* what is foreseen, a line a run; NULL: nothing                      */
};

/* Fields, bars, claims at the times of `runs`, and why it ended, in a sentence. At least
 * two runs of each model are made, and a push of the finest; at the end the third of the
 * finest is pushed, too, if it is finer than that and the wish has time for it: its growth
 * is what is told.
 * STATUS_DIVERGED: a run died; STATUS_UNSUPPORTED: a model will not serve the scene (where
 * the wish leaves one alone: neither will). Free with truth_made_clear. */
enum status truth_sharp_make(const struct truth_runs *runs, const struct scene *scene,
                             const struct truth_sharp *how, const struct truth_wish *wish,
                             struct truth_made *made, struct truth_verdict *verdict,
                             char text[TRUTH_WISH_TEXT], struct message *why);

/* What joint families of two runs at least (or none), and a push of one of their runs,
 * show, with the error wished for over the length; `spent` is left 0. */
struct truth_outlook truth_sharp_look(const struct truth_family family[TRUTH_MODELS],
                                      const struct truth_push *push,
                                      const struct scene *scene, double frame,
                                      const struct truth_made *made, double error);

#endif
