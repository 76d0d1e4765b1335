/* derived_key.h - keys of a plan that are no keys of a scene but stand for one: Gamma and
 * E/rho, which decide the motion where a single value does not. */
#ifndef DERIVED_KEY_H
#define DERIVED_KEY_H

#include <stdbool.h>

#include "models/scene.h"

/* Whether a key is one: "gamma" (scene_gamma), "young_over_density" [m^2/s^2]. */
bool derived_key_is(const char *key);

/* Its number in a scene. */
double derived_key_number(const char *key, const struct scene *scene);

/* What the scene's key `by` must be for the number to be `want` > 0, all else as it is; NaN
 * if the number does not depend on that key, or is 0 whatever it is. */
double derived_key_solve(const char *key, const char *by, double want,
                         const struct scene *scene);

#endif
