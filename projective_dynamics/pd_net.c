#include "projective_dynamics/pd_net.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LINE = 8 }; /* numbers of a cache line */

void pd_net_init(struct pd_net *net, const struct mesh *mesh)
{
    const int m = mesh->rows ? mesh->points[1] : 0;

    *net = (struct pd_net){.n = mesh->points[0],
                           .m = m,
                           .nodes = mesh->nodes,
                           .rows = mesh->rows,
                           .du = mesh->cell[0],
                           .dv = mesh->cell[1],
                           .pad = (m + 1 + 2 * LINE) / LINE * LINE};
}

ptrdiff_t pd_net_stride(const struct pd_net *net)
{
    return 2 * net->pad + (net->nodes + LINE - 1) / LINE * LINE;
}

double *pd_net_fields(const struct pd_net *net, int count)
{
    size_t bytes = (size_t)(count * pd_net_stride(net)) * sizeof(double);
    double *field = aligned_alloc(LINE * sizeof *field, bytes);

    if (!field)
        return NULL;
    memset(field, 0, bytes);
    return field + net->pad;
}

void pd_net_free_fields(const struct pd_net *net, double *fields)
{
    if (fields)
        free(fields - net->pad);
}

void pd_net_ends(const struct pd_net *net, enum pd_edge edge, int to[2])
{
    to[0] = edge == PD_EDGE_RISING;
    to[1] = edge == PD_EDGE_V ? 1 : edge == PD_EDGE_FALLING ? net->m + 1 : net->m;
}

bool pd_net_has(const struct pd_net *net, enum pd_edge edge, int k)
{
    int i = k / net->m % net->rows, j = k % net->m;

    return (edge == PD_EDGE_V || i < net->rows - 1) &&
           (edge == PD_EDGE_U || j < net->m - 1);
}

double pd_net_length(const struct pd_net *net, enum pd_edge edge)
{
    if (edge == PD_EDGE_U)
        return net->du;
    return edge == PD_EDGE_V ? net->dv : hypot(net->du, net->dv);
}
