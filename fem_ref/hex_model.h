/* hex_model.h - trilinear hexahedra, the textbook finite element solid. Key `hex`;
 * remedy=incompatible adds Wilson-Taylor incompatible modes.
 */
#ifndef HEX_MODEL_H
#define HEX_MODEL_H

#include "models/model.h"

extern const struct model hex_model;

#endif
