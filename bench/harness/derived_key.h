/* derived_key.h - keys of a plan that a scene does not have: Gamma and E/rho, numbers
 * derived from several keys, which decide the motion where a single value does not. */
#ifndef DERIVED_KEY_H
#define DERIVED_KEY_H

#include <stdbool.h>

#include "models/scene.h"

/* Returns whether a key is derived: "gamma" (scene_gamma), "young_over_density" [m^2/s^2].
 */
bool derived_key_is(const char *key);

/* Returns its number in a scene. */
double derived_key_number(const char *key, const struct scene *scene);

/* Returns the value of the scene's key `by` for which the number is `want` > 0, all else as
 * it is; NaN if the number does not depend on that key, as that of a fabric on all but
 * sheet.length, or is 0 whatever it is. */
double derived_key_solve(const char *key, const char *by, double want,
                         const struct scene *scene);

#endif
