/* projective_dynamics_model.h - projective dynamics (Bouaziz et al. 2014) on a net over the
 * mid-surface; see pd_energy.h for what it takes for the sheet's energy, pd_motion.h for
 * the steps. */
#ifndef PROJECTIVE_DYNAMICS_MODEL_H
#define PROJECTIVE_DYNAMICS_MODEL_H

#include "models/model.h"

extern const struct model projective_dynamics_model;

#endif
