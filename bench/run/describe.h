/* describe.h - describes a run to its user in words and numbers. */
#ifndef DESCRIBE_H
#define DESCRIBE_H

#include <stdio.h>

#include "bench/harness/motion.h"
#include "bench/harness/run.h"

/* Prints scene, Gamma, the full discretization, what was built, seconds, warnings. */
void describe_setup(const struct run *run, FILE *file);

/* Prints frames, seconds a frame, work done, peak memory. */
void describe_motion(const struct motion *m, FILE *file);

/* Prints metrics and energies of the present state. STATUS_MEMORY. */
enum status describe_state(const struct run *run, double t, FILE *file);

#endif
