#define _DEFAULT_SOURCE /* madvise */
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

#include "models/linalg/factor_part.h"

double *factor_numbers(ptrdiff_t count)
{
    /* From a few megabytes on, translating addresses of 4 kB pages limits a sweep. */
    const size_t huge = (size_t)1 << 21;
    size_t bytes = (count + 8) / 8 * 64, align = bytes < 2 * huge ? 64 : huge;
    double *x = aligned_alloc(align, (bytes + align - 1) / align * align);
    if (x && align == huge)
        madvise(x, bytes, MADV_HUGEPAGE); /* advice: no matter if refused */
    if (x)
        memset(x, 0, bytes);
    return x;
}

float *factor_numbers_narrow(ptrdiff_t count, double scale, double *x)
{
    enum { AT_ONCE = 64 };
    double wide[AT_ONCE];
    float narrow[AT_ONCE];
    for (ptrdiff_t from = 0; from < count; from += AT_ONCE) {
        ptrdiff_t n = count - from < AT_ONCE ? count - from : AT_ONCE;
        memcpy(wide, x + from, n * sizeof *wide);
        for (ptrdiff_t i = 0; i < n; i++)
            narrow[i] = (float)(scale * wide[i]);
        memcpy((float *)x + from, narrow, n * sizeof *narrow);
    }
    return (float *)x;
}
