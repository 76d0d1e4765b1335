/* describe.h - a run in words and numbers for people. */
#ifndef DESCRIBE_H
#define DESCRIBE_H

#include <stdio.h>

#include "bench/harness/motion.h"
#include "bench/harness/run.h"

/* Scene, Gamma, discretization spelled out, what was built, seconds of set-up, warnings. */
void describe_setup(const struct run *run, FILE *file);

/* Frames, seconds a frame, work done, peak memory. */
void describe_motion(const struct motion *m, FILE *file);

/* Metrics and energies of the present state. STATUS_MEMORY. */
enum status describe_state(const struct run *run, double t, FILE *file);

#endif
