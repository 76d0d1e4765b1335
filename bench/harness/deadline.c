#include "bench/harness/deadline.h"

#include <math.h>

#include "models/clock.h"

double deadline_left(double until)
{
    return until > 0 ? until - clock_now() : INFINITY;
}
