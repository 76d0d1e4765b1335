#include "bench/harness/deadline.h"

#include <math.h>

#include "models/clock.h"

static double end = INFINITY;

void deadline_set(double seconds)
{
    end = clock_now() + seconds;
}

double deadline_left(void)
{
    return end - clock_now();
}
