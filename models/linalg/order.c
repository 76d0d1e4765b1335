#include "models/linalg/order.h"

#include <assert.h>
#include <stdlib.h>

struct net {
    int m, size, reach;
    int *order, end;
};

/* Orders the columns of the box [i0,i1) x [j0,j1), the shorter side fastest. */
static void take(struct net *net, int i0, int i1, int j0, int j1)
{
    for (int a = 0; a < (i1 - i0) * (j1 - j0); a++) {
        int i, j;
        if (i1 - i0 < j1 - j0)
            i = i0 + a % (i1 - i0), j = j0 + a / (i1 - i0);
        else
            i = i0 + a / (j1 - j0), j = j0 + a % (j1 - j0);
        for (int s = 0; s < net->size; s++)
            net->order[net->end++] = (i * net->m + j) * net->size + s;
    }
}

static void dissect(struct net *net, int i0, int i1, int j0, int j1)
{
    int u = i1 - i0, v = j1 - j0, long_side = u > v ? u : v;
    if (u <= 0 || v <= 0)
        return;
    /* Smaller boxes do not gain by a cut, as measured; the supernodes merge more anyway. */
    if (long_side < 3 * net->reach || u * v <= 8) {
        take(net, i0, i1, j0, j1);
        return;
    }
    int cut = (long_side - net->reach) / 2;
    if (u >= v) {
        dissect(net, i0, i0 + cut, j0, j1);
        dissect(net, i0 + cut + net->reach, i1, j0, j1);
        take(net, i0 + cut, i0 + cut + net->reach, j0, j1);
    } else {
        dissect(net, i0, i1, j0, j0 + cut);
        dissect(net, i0, i1, j0 + cut + net->reach, j1);
        take(net, i0, i1, j0 + cut, j0 + cut + net->reach);
    }
}

void order_nested(int n, int m, int size, int reach, int *order)
{
    struct net net = {.m = m, .size = size, .reach = reach, .order = order};
    assert(n >= 1 && m >= 1 && size >= 1 && reach >= 1);
    dissect(&net, 0, n, 0, m);
}

enum status order_wide(int n, int m, int l, int **order)
{
    int count = 0;

    *order = NULL;
    if (m <= n)
        return STATUS_OK;
    *order = malloc((size_t)n * (size_t)m * (size_t)l * sizeof **order);
    if (!*order)
        return STATUS_MEMORY;
    for (int j = 0; j < m; j++)
        for (int i = 0; i < n; i++)
            for (int k = 0; k < l; k++)
                (*order)[count++] = (i * m + j) * l + k;
    return STATUS_OK;
}
