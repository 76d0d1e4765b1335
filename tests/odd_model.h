/* odd_model.h - ends as the scene's density says: for tests of who runs models. */
#ifndef ODD_MODEL_H
#define ODD_MODEL_H

#include "models/model.h"

extern const struct model odd_model;

#endif
