/* vertex_block_model.h - the model `vbd`. */
#ifndef VERTEX_BLOCK_MODEL_H
#define VERTEX_BLOCK_MODEL_H

#include "models/model.h"

extern const struct model vertex_block_model;

#endif
