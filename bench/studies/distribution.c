#include "bench/studies/distribution.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double PI = 3.14159265358979323846;

/* Of all comparisons together, found by chance. */
static const double BY_CHANCE = 0.05;

struct distribution distribution_of(int n, const double *value)
{
    struct distribution d = {NAN, NAN, NAN, NAN};
    double sum = 0, squares = 0;

    for (int i = 0; i < n; i++)
        sum += value[i];
    if (n)
        d.mean = sum / n;
    if (n < 2)
        return d;
    for (int i = 0; i < n; i++)
        squares += (value[i] - d.mean) * (value[i] - d.mean);
    d.sd = sqrt(squares / (n - 1));
    d.mean_error = d.sd / sqrt(n);
    d.sd_error = d.sd / sqrt(2 * (n - 1));
    return d;
}

double distribution_apart(int n, const double *a, int m, const double *b, double bar)
{
    const struct distribution p = distribution_of(n, a), q = distribution_of(m, b);
    const double apart = p.mean - q.mean;
    const double error =
        sqrt(p.mean_error * p.mean_error + q.mean_error * q.mean_error + bar * bar);

    return apart == 0 && error == 0 ? 0 : apart / error;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

void distribution_deviations(int n, const double *value, double *deviation)
{
    double sorted[DISTRIBUTION_RUNS];

    memcpy(sorted, value, (size_t)n * sizeof *value);
    qsort(sorted, (size_t)n, sizeof *sorted, compare);
    const double median = n ? 0.5 * (sorted[(n - 1) / 2] + sorted[n / 2]) : NAN;
    for (int i = 0; i < n; i++)
        deviation[i] = fabs(value[i] - median);
}

/* The chance that |t| of `free` degrees of freedom is below x (Abramowitz, Stegun 1964,
 * 26.7.3 and 26.7.4). */
static double student(double x, int free)
{
    const double angle = atan(x / sqrt(free)), c = cos(angle), s = sin(angle);
    const int odd = free % 2;
    double term = odd ? c : 1, sum = free == 1 ? 0 : term;

    for (int k = odd ? 3 : 2; k < free; k += 2) {
        term *= c * c * (k - 1) / k;
        sum += term;
    }
    return odd ? 2 / PI * (angle + s * sum) : s * sum;
}

double distribution_bound(int comparisons, int n)
{
    double low = 0, high = 1e9;

    if (n < 2)
        return INFINITY;
    for (int i = 0; i < 200; i++) {
        const double middle = 0.5 * (low + high);
        if (student(middle, n - 1) < 1 - BY_CHANCE / comparisons)
            low = middle;
        else
            high = middle;
    }
    return high;
}
