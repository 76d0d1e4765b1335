/* waves.h - the height of a sheet's wrinkles, octave by octave of their length, as read
 * off sampled fields (grid.h), as those of metric.h. Several
 * sheets are summed one by one.
 *
 * The mid-surface's x_aa + x_bb (central differences in a = u L, b = v W, inner points
 * alone) is a sum of cosines (the DCT-II of Ahmed, Natarajan, Rao 1974, along both); each
 * is divided by what the same differences make of a cosine of height 1, and heights are
 * summed in squares. So the spectrum is of what bends: carrying, turning and stretching a
 * sheet evenly leave it at 0, whichever way it hangs, and an edge at which it ends adds
 * little.
 */
#ifndef WAVES_H
#define WAVES_H

#include "models/scene.h"

/* Bands of wavelengths: longer than L; L to L/2; ... ; the last: shorter than L/16. */
enum { WAVES_BANDS = 6 };

/* Fills rms[]: root mean square over the inner points of the waves of that length, over L
 * [1]. NaN in all where a coordinate that is read is NaN. The same bits on every run. */
void waves_spectrum(const struct scene *scene, const double *xyz, double rms[WAVES_BANDS]);

#endif
