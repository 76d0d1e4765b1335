/* damping.h - a scene's damping for a model with masses and stiffness: C = alpha M + beta
 * K, and a factor on the velocity after each frame. */
#ifndef DAMPING_H
#define DAMPING_H

#include "models/scene.h"

/* Returns alpha of the damping itself [1/s], without body drag: see damping_drag. */
double damping_mass(const struct scene *scene);

/* Returns body drag c as mass damping, c / rho [1/s]. */
double damping_drag(const struct scene *scene);

/* Returns beta [s]. */
double damping_stiffness(const struct scene *scene);

/* Returns the factor on v after each frame: velocity_scale, velocity_rate; 1 otherwise. */
double damping_velocity(const struct scene *scene);

/* The kinds' words, as scenes have them; NULL ends. */
extern const char *const damping_words[];

#endif
