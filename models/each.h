/* each.h - a loop whose turns do not depend on each other, shared by threads if it is worth
 * that. Where OpenMP's clause `if` says no, it begins a team of one all the same, which
 * takes as long as a step of a small net. */
#ifndef EACH_H
#define EACH_H

#include <stdbool.h>

/* Calls turn(self, n) for each n from 0 to count - 1. */
static inline void each_turn(long count, bool shared, void (*turn)(void *self, long n),
                             void *self)
{
    if (!shared) {
        for (long n = 0; n < count; n++)
            turn(self, n);
        return;
    }
#pragma omp parallel for schedule(guided)
    for (long n = 0; n < count; n++)
        turn(self, n);
}

#endif
