/* distrust.h - results that cannot be right, whatever model they are of: one rule for all
 * commands.
 *
 * A net that is too coarse for its load need not die: it stretches like rubber, bends
 * within a cell, lets an obstacle stand out of it, or passes through itself, and its
 * numbers look as usual. So do those of a step whose iterations have not arrived
 * (models/mechanics/arrival.h), and of a net that locks (warnings.h).
 *
 * The bounds were chosen on drawn runs whose error is known, and counted on others
 * (tests/bench/harness/distrust_trial.c, doc/results.md).
 */
#ifndef DISTRUST_H
#define DISTRUST_H

#include <stdbool.h>

#include "bench/harness/measures.h"
#include "bench/harness/run.h"

/* The largest plausible depth of an obstacle in the sheet, in thicknesses: contact keeps
 * points of a net half a thickness off, and chords of 2 (10 h R)^(1/2) on a ball of radius
 * R sag by five. */
#define DISTRUST_DEPTH 5.0

/* Returns the strain that a scene prescribes [1], besides that by which its supports pull:
 * by weight, loads and pressure at rest, and by the wave that a sheet sends along itself
 * where it is stopped at the speed that weight, supports and bodies give it. */
double distrust_strain(const struct scene *scene);

/* Returns true if a run's numbers say so, with the sentence "Do not trust this result:
 * ...", what is wrong and what to try. What was not measured (NaN) is no reason; without a
 * contestant (NULL) nothing is known of a net. */
bool distrust(const struct run *run, const double value[MEASURES],
              struct message *sentence);

/* Judges fields (grid.h) at their times; an empty sentence: no reason. */
void distrust_fields(const struct scene *scene, int count, const double *time,
                     double *const *xyz, struct message *sentence);

#endif
