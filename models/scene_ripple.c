/* scene_ripple.c - the ripple that a scene may start with (models/scene.h). */
#include "models/scene.h"

#include <math.h>
#include <stdint.h>

static const double PI = 3.14159265358979323846;

enum { WAVES = 32 };

/* Returns the next number of a sequence, evenly from 0 to 1 (splitmix64: Steele, Lea,
 * Flood 2014). */
static double next(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;

    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return ldexp((double)((z ^ z >> 31) >> 11), -53);
}

bool scene_ripples(const struct scene *scene)
{
    return scene->ripple[0] != 0 || scene->ripple[1] != 0 || scene->ripple[2] != 0;
}

double scene_ripple(const struct scene *scene, const double xyz[3])
{
    uint64_t state = (uint64_t)scene->seed;
    double sum = 0;

    for (int n = 0; n < WAVES; n++) {
        const double z = 2 * next(&state) - 1, angle = 2 * PI * next(&state);
        const double side = sqrt(1 - z * z), phase = 2 * PI * next(&state);
        const double way =
            side * cos(angle) * xyz[0] + side * sin(angle) * xyz[1] + z * xyz[2];
        sum += sin(2 * PI * way / scene->wave + phase);
    }
    return sum * sqrt(2. / WAVES);
}
