/* noise.h - numbers that look random, the same on every run. */
#ifndef TESTS_NOISE_H
#define TESTS_NOISE_H

#include <math.h>
#include <stdint.h>

/* This is in (-1, 1), spread evenly: neighbours are a golden section apart. */
static inline double noise(int n)
{
    return 2 * fmod((n + 1) * 0.6180339887498949, 1) - 1;
}

/* This is in [-1, 1), and neighbours have no relation. */
static inline double noise_at(int n)
{
    const double x = sin(12.9898 * n + 1) * 43758.5453;

    return 2 * (x - floor(x)) - 1;
}

/* Returns the next number of xorshift64*. */
static inline uint64_t noise_next(void)
{
    static uint64_t state = 20261127;

    state ^= state >> 12, state ^= state << 25, state ^= state >> 27;
    return state * 2685821657736338717u;
}

/* Returns a number in [0, 1). */
static inline double noise_unit(void)
{
    return (double)(noise_next() >> 11) * 0x1p-53;
}

#endif
