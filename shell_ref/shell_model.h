/* shell_model.h - the rotation-free isogeometric Kirchhoff-Love shell behind the common
 * contract, key `shell`. Defaults: points [10,10], degree [3,3], kinematics nonlinear,
 * remedy selective (shell_space.h); a third number of points or degree must be 1 or left
 * alone. The state begins with a struct shell_motion.
 */
#ifndef SHELL_MODEL_H
#define SHELL_MODEL_H

#include "models/model.h"

extern const struct model shell_model;

#endif
