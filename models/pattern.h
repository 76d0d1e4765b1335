/* pattern.h - the flat pattern of a sheet that is no rectangle: an outline with holes, or
 * the triangles of a mesh, in a box of the sheet's length and width whose corner is 0.
 *
 * Lines go round with the sheet to their left: outlines counter-clockwise, holes clockwise.
 *
 * The panels of a garment lie beside each other in the plane, and it starts in space, where
 * points of triangles that are sewn together are one node.
 */
#ifndef PATTERN_H
#define PATTERN_H

#include <stdbool.h>

#include "models/grid.h"
#include "models/mesh_flat.h"
#include "models/status.h"

enum {
    PATTERN_MOST = 10000 /* points of all lines that a scene writes down                 */
};

struct pattern {
    int points, lines;
    double (*at)[2];       /* [points]                                       [m]  owned */
    int *line;             /* [lines + 1] first points of lines                   owned */
    int *next;             /* [points] the other ends of their sides              owned */
    double corner[2];      /* of the box, where the scene has it              [m]       */
    double size[2];        /* of the box                                      [m]       */
    double area;           /*                                                [m^2]      */
    double near;           /* so far from the border a place is still on it   [m]       */
    struct mesh_flat mesh; /* the scene's own; none: of an outline                owned */
    int nodes, *node;      /* [mesh.nodes] of what is sewn; NULL: points are nodes owned */
    double (*start)[3];    /* [nodes] where they begin, from the box's corner along u and
                              v, along the normal; NULL: in the plane         [m]  owned */
    int *vertex;           /* [mesh.nodes] numbers of points in the scene's file, from 0;
                              several may have one                                owned */
    int groups, *in;       /* [mesh.triangles] groups of triangles, -1: none      owned */
    char **group;          /* [groups] their names                                owned */
    int *nearest; /* [GRID_V][GRID_U] triangles nearest to the material grid's points where
                     it starts in space; -1: not known                              owned */
    bool on[GRID_V][GRID_U]; /* points of the material grid that are on the sheet         */
};

struct pattern *pattern_make(void);   /* empty; NULL: no memory */
void pattern_free(struct pattern *p); /* NULL is allowed */

/* Tells whether it starts elsewhere than in its plane. */
static inline bool pattern_starts_in_space(const struct pattern *p)
{
    return p && p->start;
}

/* Returns the node at one of the mesh's places. */
static inline int pattern_node(const struct pattern *p, int place)
{
    return p->node ? p->node[place] : place;
}

/* Adds a closed line through at[count], whose last point is not the first again. */
enum status pattern_add_line(struct pattern *p, int count, const double (*at)[2]);

/* Takes over the triangles of a mesh, which is then empty, and adds the lines around them.
 * STATUS_INPUT with *triangle where the pieces meet in a point only: one that has it. */
enum status pattern_add_mesh(struct pattern *p, struct mesh_flat *mesh, int *triangle);

/* Names what is wrong with a pattern's lines. */
enum pattern_fault {
    PATTERN_SOUND,
    PATTERN_FEW,      /* a line has less than three points                               */
    PATTERN_DOUBLE,   /* two points are one                                              */
    PATTERN_CROSSING, /* two sides cross or touch                                        */
    PATTERN_PIECES,   /* there are two outlines, and no panels                           */
    PATTERN_OUTSIDE,  /* a hole is not in the outline, or lies in another                */
};

struct pattern_blame {
    enum pattern_fault fault;
    int line, point; /* of the line */
};

/* Ends a pattern: turns lines round where they go the wrong way (without a mesh the first
 * is the outline, others are holes), moves it so that its box begins at 0, and fills the
 * rest in; the box's size goes to size[2] [m]. STATUS_INPUT with *blame where lines are
 * wrong. */
enum status pattern_finish(struct pattern *p, double size[2], struct pattern_blame *blame);

/* Tells whether a place [m] is on the sheet or on its border. */
bool pattern_has(const struct pattern *p, double x, double y);

/* Computes where the place x, y, or the nearest of the sheet, begins in space, and its
 * normal there: along u, v and the plane's normal. */
void pattern_begin(const struct pattern *p, double x, double y, double begin[3],
                   double normal[3]);

/* Makes the triangles of the sheet as it is sewn together, of a pattern that has some. */
enum status pattern_sewn(const struct pattern *p, struct mesh_flat *flat);

/* Returns a number made from the pattern's triangles; two meshes have different ones. */
unsigned long long pattern_sum(const struct pattern *p);

#endif
