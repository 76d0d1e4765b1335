/* spring_model.h - the model `mass_spring`. */
#ifndef SPRING_MODEL_H
#define SPRING_MODEL_H

#include "models/model.h"

extern const struct model spring_model;

#endif
