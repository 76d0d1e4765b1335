#include "models/clock.h"

#include <assert.h>
#include <malloc.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>

static double seconds(clockid_t which)
{
    struct timespec t;
    clock_gettime(which, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

double clock_now(void)
{
    return seconds(CLOCK_MONOTONIC);
}

double clock_processor(void)
{
    return seconds(CLOCK_THREAD_CPUTIME_ID);
}

/* Orders NaN last, so that a failed repeat does not scramble the order of the others. */
static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    if (isnan(x) || isnan(y))
        return isnan(x) - isnan(y);
    return (x > y) - (x < y);
}

static double quantile(const double *sorted, int count, double fraction)
{
    double place = fraction * (count - 1);
    int below = (int)place;
    if (below == count - 1)
        return sorted[below];
    return sorted[below] + (place - below) * (sorted[below + 1] - sorted[below]);
}

struct clock_summary clock_summarise(const double *seconds, int count)
{
    struct clock_summary s = {.count = count};
    assert(count >= 1);

    double *sorted = malloc((size_t)count * sizeof *sorted);
    if (!sorted) {
        return (struct clock_summary){0, NAN, NAN, NAN, NAN, NAN};
    }
    memcpy(sorted, seconds, (size_t)count * sizeof *sorted);
    qsort(sorted, (size_t)count, sizeof *sorted, ascending);
    s.min = sorted[0];
    s.lower = quantile(sorted, count, 0.25);
    s.median = quantile(sorted, count, 0.5);
    s.upper = quantile(sorted, count, 0.75);
    s.max = sorted[count - 1];
    free(sorted);
    return s;
}

long clock_peak_memory(void)
{
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss * 1024; /* Linux gives kilobytes */
}

double clock_allocated(void)
{
    const struct mallinfo2 books = mallinfo2();

    return (double)books.uordblks + (double)books.hblkhd;
}
