/* spring_net.h - the springs and hinges of a grid (mesh.h, spring_law.h).
 *
 * A hinge is three nodes in line with a strut from the first to the last. A point has no
 * rotation, so that holding it does not clamp the sheet there; but a solid's column, held
 * through the whole thickness in x, y and z, cannot turn. For such nodes the hinges centred
 * at them are replaced by clamps, one for each free neighbour: hinges whose other edge is
 * the rest position of the neighbour mirrored at the node, of twice the strength, because
 * they stand for half the length. Nets without hinges (`paper`) turn freely about what is
 * held, and so does a support that takes the mid-surface alone.
 *
 * On a mesh that is no grid springs are its edges, and have sqrt(3)/4 E h beside each
 * triangle (Lloyd, Szekely and Harders 2007: exact for equilateral triangles and nu = 1/3);
 * there are no hinges: it bends by the forms of spring_plate.h.
 */
#ifndef SPRING_NET_H
#define SPRING_NET_H

#include "models/law/law.h"
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

/* Computes the matrix (law.h) that springs on a mesh have where strains are even [N/m]. */
void spring_net_even(const struct mesh *mesh, const struct scene *scene,
                     double even[LAW_ENTRIES]);

/* Adds for users what the springs have of the sheet's stiffness: those of any net, or, with
 * "; " before it, those of a mesh that is no grid. */
void spring_net_tell(const struct spring_net *net, const struct scene *scene,
                     struct message *line);
void spring_net_tell_mesh(const struct mesh *mesh, const struct scene *scene,
                          struct message *line);

/* Returns the elastic energy of the springs, without hinges and clamps [J]. */
double spring_net_energy(const struct spring_net *net, const double *x);

#endif
