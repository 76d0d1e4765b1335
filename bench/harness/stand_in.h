/* stand_in.h - keys of a plan that are no keys of a scene but stand for one: Gamma and
 * E/rho, which decide the motion where a single value does not. */
#ifndef STAND_IN_H
#define STAND_IN_H

#include <stdbool.h>

#include "models/scene.h"

/* Whether a key is one: "gamma" (scene_gamma), "young_over_density" [m^2/s^2]. */
bool stand_in_is(const char *key);

/* Its number in a scene. */
double stand_in_number(const char *key, const struct scene *scene);

/* What the scene's key `by` must be for the number to be `want` > 0, all else as it is; NaN
 * if the number does not depend on that key, or is 0 whatever it is. */
double stand_in_solve(const char *key, const char *by, double want,
                      const struct scene *scene);

#endif
