/* plate_model.h - the IGA thick plate: a trivariate B-spline solid of linear elasticity
 * (Ren, Dai, Lin 2024). Key `iga`.
 */
#ifndef PLATE_MODEL_H
#define PLATE_MODEL_H

#include "models/model.h"

extern const struct model plate_model;

#endif
