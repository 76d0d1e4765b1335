#define _DEFAULT_SOURCE /* madvise */
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

#include "models/linalg/factor_part.h"
#include "models/linalg/tile.h"

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

/* Rounds a float's bits to the upper half, ties to even. */
static uint32_t upper(uint32_t bits)
{
    return (bits + 0x7fff + (bits >> 16 & 1)) & 0xffff0000u;
}

void factor_numbers_halve(ptrdiff_t count, float *x)
{
    uint32_t whole[TILE_SIZE], both[TILE_SIZE / 2];
    for (ptrdiff_t from = 0; from + TILE_SIZE <= count; from += TILE_SIZE) {
        memcpy(whole, x + from, sizeof whole);
        for (int j = 0; j < TILE; j += 2)
            for (int i = 0; i < TILE; i++)
                both[j / 2 * TILE + i] =
                    upper(whole[j * TILE + i]) >> 16 | upper(whole[(j + 1) * TILE + i]);
        memcpy((uint16_t *)x + from, both, sizeof both);
    }
}
