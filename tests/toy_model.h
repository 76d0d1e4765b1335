/* toy_model.h - the smallest model that keeps the contract of models/model.h: what to copy
 * when adding one (doc/adding_a_model.md). Not registered; tests/physics/contract.c runs
 * it. */
#ifndef TOY_MODEL_H
#define TOY_MODEL_H

#include "models/model.h"

extern const struct model toy_model;

#endif
