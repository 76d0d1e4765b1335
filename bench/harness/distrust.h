/* distrust.h - results that cannot be right, whatever model they are of: one rule for all
 * commands.
 *
 * A net that is too coarse for its load need not die: it stretches like rubber, lets an
 * obstacle stand out of it, or passes through itself, and its numbers look as usual. So do
 * those of a step whose iterations have not arrived (models/mechanics/arrival.h).
 */
#ifndef DISTRUST_H
#define DISTRUST_H

#include <stdbool.h>

#include "bench/harness/measures.h"
#include "models/scene.h"
#include "models/status.h"

/* The largest plausible stretch of the mid-surface: woven cloth tears before it. A softer
 * sheet may have twice the strain of its hanging weight, which it reaches when let go; that
 * of one which supports pull apart is over theirs. */
#define DISTRUST_STRETCH 1.3

/* The largest plausible depth of an obstacle in the sheet, in thicknesses: contact keeps
 * points of a net half a thickness off, and chords of 2 (10 h R)^(1/2) on a ball of radius
 * R sag by five. */
#define DISTRUST_DEPTH 5.0

/* Returns true if a run's numbers say so, with the sentence "Do not trust this result:
 * ...", what is wrong and what to try. What was not measured (NaN) is no reason. */
bool distrust(const struct scene *scene, const double value[MEASURES],
              struct message *sentence);

/* Judges fields (grid.h) at their times; an empty sentence: no reason. STATUS_MEMORY. */
enum status distrust_fields(const struct scene *scene, int count, const double *time,
                            double *const *xyz, struct message *sentence);

#endif
