/* derived_key.h - keys of a plan that a scene does not have: Gamma and E/rho, numbers
 * derived from several keys, which decide the motion where a single value does not. They
 * set E. */
#ifndef DERIVED_KEY_H
#define DERIVED_KEY_H

#include <stdbool.h>

#include "models/scene.h"

/* Returns whether a key is derived: "gamma" (scene_gamma), "young_over_density" [m^2/s^2].
 */
bool derived_key_is(const char *key);

/* Returns its number in a scene. */
double derived_key_number(const char *key, const struct scene *scene);

/* Returns E for which the number is `want` > 0, all else as it is; NaN of a fabric, whose
 * moduli are not of E, and if the number is 0 whatever E is. */
double derived_key_young(const char *key, double want, const struct scene *scene);

#endif
