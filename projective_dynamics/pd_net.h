/* pd_net.h - the layout of a grid's nodes (mesh.h) in memory, and its edges. A field of
 * numbers per node has zeros before node 0 and behind the last, so that k + m + 1 and
 * k - m - 1 may always be read: loops run over k without looking at the rims of the net;
 * what would cross them has weight zero. Of a mesh that is no grid it is the fields alone.
 */
#ifndef PD_NET_H
#define PD_NET_H

#include <stdbool.h>
#include <stddef.h>

#include "models/mesh/mesh.h"

struct pd_net {
    int n, m, nodes;
    int rows;      /* of a sheet; n: there is one; 0, as m: no grid                    */
    double du, dv; /* rest lengths of edges along u, v [m]                            */
    ptrdiff_t pad; /* zeros before and behind, m + 1 or more                          */
};

/* The edges, by their node k: along u k -> k+m, along v k -> k+1, and the diagonals k ->
 * k+m+1 and k+1 -> k+m of the cell at k. */
enum pd_edge { PD_EDGE_U, PD_EDGE_V, PD_EDGE_FALLING, PD_EDGE_RISING, PD_EDGES };

/* Makes the layout of a grid. */
void pd_net_init(struct pd_net *net, const struct mesh *mesh);

/* Returns the distance from a field to the next one of the same array. */
ptrdiff_t pd_net_stride(const struct pd_net *net);

/* Allocates `count` fields of zeros; field c starts at the returned pointer + c
 * pd_net_stride. Owned by the caller, freed with pd_net_free_fields; NULL if there is no
 * memory. */
double *pd_net_fields(const struct pd_net *net, int count);
void pd_net_free_fields(const struct pd_net *net, double *fields); /* NULL is allowed */

/* Returns the ends k + to[0] -> k + to[1] of the edge at k. */
void pd_net_ends(const struct pd_net *net, enum pd_edge edge, int to[2]);

/* Tells whether there is such an edge at k; for a diagonal: a cell at k. */
bool pd_net_has(const struct pd_net *net, enum pd_edge edge, int k);

/* Returns its rest length [m]. */
double pd_net_length(const struct pd_net *net, enum pd_edge edge);

#endif
