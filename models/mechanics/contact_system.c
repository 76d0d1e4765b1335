#include "models/mechanics/contact_system.h"

static void add_touch(const struct contact *c, const struct contact_touch *t,
                      const struct blocks *graph, double (*K)[9])
{
    double B[9];

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            B[3 * i + j] =
                (t->stiffness - t->drag) * t->normal[i] * t->normal[j] + t->drag * (i == j);
    for (int a = t->first; a < t->first + t->count; a++)
        for (int b = t->first; b < t->first + t->count; b++) {
            if (c->node[b] < c->node[a])
                continue;
            const double weight = c->weight[a] * c->weight[b];
            double *block = K[blocks_find(graph, c->node[a], c->node[b])];
            for (int k = 0; k < 9; k++)
                block[k] += weight * B[k];
        }
}

void contact_system_tangent(const struct contact *c, const struct blocks *graph,
                            double (*K)[9])
{
    for (const struct contact_touch *t = c->touch; t < c->touch + c->count; t++)
        add_touch(c, t, graph, K);
}
