/* projective_dynamics_model.h - projective dynamics (Bouaziz et al. 2014) on a net over the
 * mid-surface; see pd_energy.h for what it takes for the sheet's energy, pd_motion.h for
 * the steps. */
#ifndef PROJECTIVE_DYNAMICS_MODEL_H
#define PROJECTIVE_DYNAMICS_MODEL_H

#include "models/model.h"
#include "projective_dynamics/pd_energy.h"

enum acceleration {
    ACCELERATION_AUTO, /* of iterations that go on until they arrive                      */
    ACCELERATION_NONE,
    ACCELERATION_CHEBYSHEV, /* Wang 2015                                               */
    ACCELERATION_ADMM,      /* Overby et al. 2017, softly weighted                     */
};

struct pd_own { /* choices of its own (models/option.h) */
    enum constraint constraint;
    enum acceleration acceleration;
};

extern const struct model projective_dynamics_model;

#endif
