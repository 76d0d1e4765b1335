/* spring_net.h - a net of n x m point masses over the mid-surface of each sheet, node i m +
 * j of the first at (u,v) = (i/(n-1), j/(m-1)), with its springs and hinges (spring_law.h).
 * The rows of several sheets follow each other, and nothing connects the last row of one
 * with the first of the next.
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

#include "models/net/spring_law.h"
#include "models/linalg/blocks.h"

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
    int points[2]; /* rows of all sheets, points of a row                   */
    int rows;      /* of one sheet                                          */
    int nodes;
    double cell[2]; /* a_u, a_v                                    [m]   */
    struct spring_law law;
    void *room;       /* memory of the arrays                        owned   */
    double (*uvw)[3]; /* [nodes] material parameters, w = 1/2              */
    double *rest;     /* [nodes][3]                          [m]           */
    double *area;     /* [nodes] of the sheet that is theirs [m^2]         */
    bool *clamped;    /* [nodes] of held columns that cannot turn          */
    int spring_count, hinge_count, clamp_count;
    struct spring *springs;
    struct hinge *hinges;
    struct clamp *clamps; /*                                                   owned   */
    struct blocks graph;
};

/* Makes a net; points: n, m >= 2 of a sheet. whole: the graph has all couplings of
 * spring_stencil.h, also where long cells have no spring. */
enum status spring_net_init(struct spring_net *net, const struct scene *scene,
                            const int points[2], enum parameters parameters, bool whole);
void spring_net_clear(struct spring_net *net);

/* Returns the node di rows and dj places from (i, j), or -1 beyond the rim of its sheet. */
int spring_net_beside(const struct spring_net *net, int i, int j, int di, int dj);

/* Tells whether the node (i, j) lies on a rim of its sheet along u (0) or v (1). */
bool spring_net_on_rim(const struct spring_net *net, int i, int j, int along);

#endif
