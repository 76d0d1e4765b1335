/* export_held.h - which vertices of a net a scene's supports hold, and the vertices outside
 * the sheet that make a clamp of an edge: where bending is an angle between elements, a
 * held row alone is a hinge.
 *
 * A support through the whole thickness that holds the direction from an edge into the
 * sheet keeps the edge from turning. A vertex whose neighbour inside is free and that has
 * none on the other side gets one there, where the mid-surface would go on, held as it is.
 * A patch of several rows needs none.
 */
#ifndef EXPORT_HELD_H
#define EXPORT_HELD_H

#include "bench/export/export_sheet.h"

struct export_held_vertex {
    int vertex, i, j; /* its number, from n m on for those outside; its place           */
    unsigned fix;     /* FIX_X...                                                       */
    int path;         /* the support whose path it follows; -1: it does not move        */
    int beside;       /* outside: the held vertex that it stands beside; else -1        */
};

struct export_held {
    int count, outside;
    struct export_held_vertex *vertex; /* [count], those of the sheet first      owned */
    struct message doubt; /* where the net holds too little; empty: nowhere            */
};

/* Finds the held vertices. STATUS_UNSUPPORTED with a sentence: vertices cannot express how
 * the scene holds the sheet, STATUS_INPUT: a support holds none of them. Free with
 * export_held_clear. */
enum status export_held_find(const struct export_sheet *s, struct export_held *held,
                             struct message *why);
void export_held_clear(struct export_held *held); /* all-zero is allowed */

#endif
