#include "models/net/net_origin.h"

#include <math.h>

/* The lengths from the point to the middle of the sheet at which it follows. At four
 * lengths it costs two of single precision's 24 bits. */
static const double FAR = 4;

/* Returns how far the middle of a net, that of its first and last node, is from the point
 * in one component. */
static double off(const struct net_origin *o, int nodes, const double *x, int component)
{
    const double *last = x + 3 * (nodes - 1);

    return x[component] / 2 + last[component] / 2 - o->at[component];
}

static double mean(int nodes, const double *v, int component)
{
    double sum = 0;

    for (int a = 0; a < nodes; a++)
        sum += v[3 * a + component];
    return sum / nodes;
}

bool net_origin_stays(const struct net_origin *o, int nodes, const double *x)
{
    for (int i = 0; i < 3 && o->length > 0; i++)
        if ((o->carried && o->at[i] != 0) || fabs(off(o, nodes, x, i)) > FAR * o->length)
            return false;
    return true;
}

bool net_origin_follow(struct net_origin *o, int nodes, const double *x, const double *v)
{
    if (net_origin_stays(o, nodes, x))
        return false;
    const double step = exp2(floor(log2(o->length)));
    for (int i = 0; i < 3; i++) {
        const double way = off(o, nodes, x, i), now = o->carried ? mean(nodes, v, i) : 0;
        if (!isfinite(way) || !isfinite(now))
            return false;
        if (fabs(way) > FAR * o->length)
            o->at[i] += step * round(way / step);
        o->velocity[i] = now;
    }
    return true;
}
