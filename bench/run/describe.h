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

/* Fills in the forces and moments of supports, then of obstacles (model.h), for people:
 * returns how many there are; 0 where they are more, or not known. */
enum { DESCRIBE_FORCES = 5 };
int describe_forces(const struct run *run, double force[DESCRIBE_FORCES][6]);

/* Prints metrics, energies and forces of the present state. STATUS_MEMORY. */
enum status describe_state(const struct run *run, double t, FILE *file);

#endif
