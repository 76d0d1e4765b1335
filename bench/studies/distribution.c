#include "bench/studies/studies.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double PI = 3.14159265358979323846;

/* Share of cases in which some comparison of all is passed by chance. */
static const double BY_CHANCE = 0.05;

double distribution_mean(int n, const double *value, double *error)
{
    double sum = 0, squares = 0;

    for (int i = 0; i < n; i++)
        sum += value[i];
    const double mean = n ? sum / n : NAN;
    for (int i = 0; i < n; i++)
        squares += (value[i] - mean) * (value[i] - mean);
    *error = n > 1 ? sqrt(squares / (n - 1)) / sqrt(n) : NAN;
    return mean;
}

double distribution_apart(int n, const double *a, int m, const double *b, double bar)
{
    double p, q;
    const double apart = distribution_mean(n, a, &p) - distribution_mean(m, b, &q);
    const double error = sqrt(p * p + q * q + bar * bar);

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

/* Returns the chance that |t| of `free` degrees of freedom is below x (Abramowitz, Stegun
 * 1964, 26.7.3 and 26.7.4). */
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
