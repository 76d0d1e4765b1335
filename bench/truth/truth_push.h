/* truth_push.h - a scene pushed a little: its gravity changed by TRUTH_PERTURBATION in one
 * of many directions, to see how fast such a change grows, and what motions it leads to. */
#ifndef TRUTH_PUSH_H
#define TRUTH_PUSH_H

#include "bench/harness/settings.h"

/* Of gravity, or of 9.81 m/s^2 where there is none; a rounding of its sixth digit. */
#define TRUTH_PERTURBATION 1e-6

/* The unit vector of a push times sqrt(3). Number 0 is (1,1,1): whatever symmetry a scene
 * has is gone. Others come from a hash of the number (Steele, Lea, Flood 2014, SplitMix64)
 * and are uniform on the sphere (von Neumann 1951, rejection); only sums, products and
 * square roots: the same bits on every machine. */
void truth_push_direction(int number, double direction[3]);

/* The gravity of the scene at `path` with settings `given`, changed by TRUTH_PERTURBATION
 * of its size, into `settings`. Those of the scene: STATUS_INPUT, STATUS_MEMORY. */
enum status truth_push(const char *path, const struct settings *given, int number,
                       struct settings *settings, struct message *why);

#endif
