/* pattern.h - the flat pattern of a sheet that is no rectangle: an outline with holes, or
 * the triangles of a mesh, in a box of the sheet's length and width whose corner is 0.
 *
 * Lines go round with the sheet to their left: outlines counter-clockwise, holes clockwise.
 */
#ifndef PATTERN_H
#define PATTERN_H

#include <stdbool.h>

#include "models/grid.h"
#include "models/mesh_flat.h"
#include "models/status.h"

enum {
    PATTERN_MOST = 10000
}; /* points of all lines that a scene writes down             */

struct pattern {
    int points, lines;
    double (*at)[2];         /* [points]                                       [m]  owned */
    int *line;               /* [lines + 1] first points of lines                   owned */
    int *next;               /* [points] the other ends of their sides              owned */
    double corner[2];        /* of the box, where the scene has it              [m]       */
    double area;             /*                                                [m^2]      */
    double near;             /* so far from the border a place is still on it   [m]       */
    struct mesh_flat mesh;   /* the scene's own; none: of an outline                owned */
    bool on[GRID_V][GRID_U]; /* points of the material grid that are on the sheet         */
};

struct pattern *pattern_make(void);   /* empty; NULL: no memory */
void pattern_free(struct pattern *p); /* NULL is allowed */

/* Adds a closed line through at[count]; its last point is not the first again. */
enum status pattern_add_line(struct pattern *p, int count, const double (*at)[2]);

/* Takes over the triangles of a mesh, which is then empty, and adds the lines around them.
 * STATUS_INPUT with *triangle where the pieces meet in a point only: one that has it. */
enum status pattern_add_mesh(struct pattern *p, struct mesh_flat *mesh, int *triangle);

/* Names what is wrong with a pattern's lines. */
enum pattern_fault {
    PATTERN_SOUND,
    PATTERN_FEW,    /* a line has less than three points                                 */
    PATTERN_DOUBLE, /* two points are one                                                */
    PATTERN_CROSSING, /* two sides cross or touch */
    PATTERN_PIECES,  /* there are two outlines                                            */
    PATTERN_OUTSIDE, /* a hole is not in the outline, or lies in another                  */
};

struct pattern_blame {
    enum pattern_fault fault;
    int line, point; /* of the line */
};

/* Ends a pattern: turns lines round where they go the wrong way (without a mesh the first
 * is the outline, others are holes), moves it so that its box begins at 0, and fills the
 * rest in; size[2]: of the box [m]. STATUS_INPUT: *blame. */
enum status pattern_finish(struct pattern *p, double size[2], struct pattern_blame *blame);

/* Tells whether a place [m] is on the sheet or on its border. */
bool pattern_has(const struct pattern *p, double x, double y);

/* Returns a number made from the pattern's triangles: of two meshes they differ. */
unsigned long long pattern_sum(const struct pattern *p);

#endif
