/* position_based_model.h - the model `position_based`: see pb_motion.h. */
#ifndef POSITION_BASED_MODEL_H
#define POSITION_BASED_MODEL_H

#include "models/model.h"

extern const struct model position_based_model;

#endif
