/* sweep_truth.h - how far a case of a sweep is from the truth that is known of its scene,
 * look by look, stored beside the other numbers of its result file (LOOKS_TRUTH). */
#ifndef SWEEP_TRUTH_H
#define SWEEP_TRUTH_H

#include "bench/harness/looks.h"
#include "bench/harness/run_file.h"
#include "bench/truth/truth.h"

struct sweep_truth {
    struct truth made; /* nothing is claimed: no truth is known                   */
    double length;     /* of the scene [m]                                        */
    struct run_own own[LOOKS_TRUTH];
};

/* Finds what is known of the scene without a run: a closed form, or a stored truth of the
 * same physics. STATUS_INPUT: the stored one was changed; STATUS_FILE, STATUS_MEMORY. */
enum status sweep_truth_open(struct sweep_truth *truth, const struct scene *scene,
                             struct message *why);
void sweep_truth_close(struct sweep_truth *truth); /* all-zero is allowed */

/* Has the run keep the distances, if a truth is known; borrows it until the run's end. */
void sweep_truth_keep(struct sweep_truth *truth, struct run_keep *keep);

#endif
