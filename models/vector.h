/* vector.h - arithmetic on three numbers; sums go in order, so that all have the same bits.
 */
#ifndef VECTOR_H
#define VECTOR_H

#include <math.h>

static inline double vector_dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline double vector_length(const double *a)
{
    return sqrt(vector_dot(a, a));
}

/* Computes c = a x b; not aliased. */
static inline void vector_cross(const double *a, const double *b, double *c)
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

/* Computes d = b - a. */
static inline void vector_between(const double *a, const double *b, double *d)
{
    for (int i = 0; i < 3; i++)
        d[i] = b[i] - a[i];
}

static inline double vector_distance(const double *a, const double *b)
{
    const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};

    return vector_length(d);
}

#endif
