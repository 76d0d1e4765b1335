/* spring_net.h - the springs and hinges of a grid (mesh.h, spring_law.h).
 *
 * A hinge is three nodes in line with a strut from the first to the last. A point has no
 * rotation, so that holding it does not clamp the sheet there; but a solid's column, held
 * through the whole thickness in x, y and z, cannot turn. For such nodes the hinges centred
 * at them are replaced by clamps, one for each free neighbour: hinges whose other edge is
 * the rest position of the neighbour mirrored at the node, of twice the strength, because
 * they stand for half the length. Nets without hinges (`paper`) turn freely about what is
 * held, and so does a support that takes the mid-surface alone.
 */
#ifndef SPRING_NET_H
#define SPRING_NET_H

#include "models/linalg/blocks.h"
#include "models/mesh/mesh.h"
#include "models/net/spring_law.h"

struct spring {
    int a, b;         /* a < b                                             */
    double stiffness; /* k                                         [N/m]   */
    double length;    /* at rest                                     [m]   */
    long aa, bb, ab;  /* pairs of the graph                                */
};

struct hinge {
    int a, b, c;  /* a < b < c, b the centre                           */
    double strut; /* P                                           [N]   */
    long aa, bb, cc, ab, bc, ac;
};

struct clamp {
    int a, b;       /* a held, b free                                    */
    double edge[3]; /* towards a, does not turn                    [m]   */
    double strut;   /*                                             [N]   */
    long bb;
};

struct spring_net {
    const struct mesh *mesh; /*                                               borrowed */
    struct spring_law law;
    void *room; /* memory of springs and hinges                               owned   */
    int spring_count, hinge_count, clamp_count;
    struct spring *springs;
    struct hinge *hinges;
    struct clamp *clamps; /*                                                   owned   */
    struct blocks graph;
};

/* Makes the springs of a mesh, which must stay where it is. whole: the graph has all
 * couplings of spring_stencil.h, also where long cells have no spring. */
enum status spring_net_init(struct spring_net *net, const struct scene *scene,
                            const struct mesh *mesh, enum parameters parameters,
                            bool whole);
void spring_net_clear(struct spring_net *net);

/* Returns the elastic energy of the springs, without hinges and clamps [J]. */
double spring_net_energy(const struct spring_net *net, const double *x);

#endif
