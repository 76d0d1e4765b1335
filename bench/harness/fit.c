#include "bench/harness/fit.h"

#include <math.h>

double fit_exponent(int count, const double *x, const double *y)
{
    double middle_x = 0, middle_y = 0, xx = 0, xy = 0;

    for (int n = 0; n < count; n++) {
        middle_x += log(x[n]) / count;
        middle_y += log(y[n]) / count;
    }
    for (int n = 0; n < count; n++) {
        xx += (log(x[n]) - middle_x) * (log(x[n]) - middle_x);
        xy += (log(x[n]) - middle_x) * (log(y[n]) - middle_y);
    }
    return xy / xx;
}
