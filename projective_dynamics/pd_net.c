#include "projective_dynamics/pd_net.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LINE = 8 }; /* numbers of a cache line */

void pd_net_init(struct pd_net *net, const struct scene *scene, int n, int m)
{
    const int sheets = scene_sheets(scene);

    *net = (struct pd_net){.n = sheets * n, .m = m, .nodes = sheets * n * m, .rows = n};
    net->du = scene->length / (n - 1);
    net->dv = scene->width / (m - 1);
    net->pad = (m + 1 + 2 * LINE) / LINE * LINE;
}

void pd_net_parameters(const struct pd_net *net, const struct scene *scene, int k,
                       double uvw[3])
{
    const int i = k / net->m, n = net->rows;

    uvw[0] = scene_sheet_u(scene, i / n, (double)(i % n) / (n - 1));
    uvw[1] = (double)(k % net->m) / (net->m - 1);
    uvw[2] = 0.5;
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
