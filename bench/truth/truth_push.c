#include "bench/truth/truth_push.h"

#include <math.h>
#include <stdint.h>

static const double EARTH = 9.81; /* [m/s^2] */

/* SplitMix64, the output of a counter. */
static uint64_t hash(uint64_t counter)
{
    uint64_t z = counter * UINT64_C(0x9e3779b97f4a7c15);

    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

/* From -1 to 1, exactly. */
static double uniform(uint64_t counter)
{
    return (double)(hash(counter) >> 11) * 0x1p-52 - 1;
}

void truth_push_direction(int number, double direction[3])
{
    /* A point of the cube lies in the ball with pi/6: of 64 tries one does. */
    enum { TRIES = 64 };
    static const double LEAST = 0.01; /* nearer to the middle, digits are lost         */
    double *d = direction, size = 3;

    d[0] = d[1] = d[2] = 1;
    for (uint64_t t = 0; number && t < TRIES; t++) {
        for (uint64_t i = 0; i < 3; i++)
            d[i] = uniform(((uint64_t)number * TRIES + t) * 3 + i);
        size = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
        if (size <= 1 && size > LEAST)
            break;
    }
    const double scale = sqrt(3 / size);
    for (int i = 0; i < 3; i++)
        d[i] *= scale;
}

enum status truth_push(const char *path, const struct settings *given, int number,
                       struct settings *settings, struct message *why)
{
    struct scene scene = {0};
    double direction[3];
    enum status st;

    TRY(settings_read_scene(given, path, &scene, why));
    double *g = scene.gravity;
    const double mean = (g[0] * g[0] + g[1] * g[1] + g[2] * g[2]) / 3;
    const double by = TRUTH_PERTURBATION * sqrt(mean > 0 ? mean : EARTH * EARTH / 3);
    truth_push_direction(number, direction);
    for (int i = 0; i < 3; i++)
        g[i] += by * direction[i];
    settings_numbers(settings, "gravity", 3, g);
    scene_clear(&scene);
out:
    return st;
}
