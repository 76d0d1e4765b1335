/* tri_model.h - the model `triangles`. */
#ifndef TRI_MODEL_H
#define TRI_MODEL_H

#include "models/model.h"

extern const struct model tri_model;

#endif
