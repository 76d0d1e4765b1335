/* supports.h - the unknowns of a node model that a scene's supports hold, and where.
 *
 * The paper's rule: a node is held if its parameters lie in the support's region, in all
 * layers the region covers (an edge: all control points of the edge, both layers). Where it
 * covers the mid-surface w = 1/2 alone, that surface is held: the sheet may turn.
 */
#ifndef SUPPORTS_H
#define SUPPORTS_H

#include "models/scene.h"

/* Coefficients that describe a whole column have these parameters w: its mid-surface moves
 * with a support, and its differences across the thickness change by a turn alone. */
enum { SUPPORTS_MIDDLE = -1, SUPPORTS_DIFFERENCE = -2 };

/* A node that is no place has one of these: it has one unknown, its first component, or
 * none, or three. Supports do not take it, and nobody holds what is no unknown, as at rest.
 */
enum {
    SUPPORTS_ONE = -3,
    SUPPORTS_NONE = -4,
    SUPPORTS_THREE = -5,
    SUPPORTS_NOBODY = -(1 << 30)
};

/* The unknowns of some nodes are not their components along x, y, z but those in a frame:
 * beside a clamped edge the sheet's direction is held, but not how far it stretches that
 * way (a skew support). */
struct supports_frame {
    int node, owner; /* owner: the support n that it follows                             */
    int beside;      /* the edge's node, whence the way goes that is free                */
    double rest[3];  /* the node's place at rest                                   [m]   */
    double length;   /* of the way at rest                                         [m]   */
    double start[9]; /* rows at rest: along the way; two across it, which are held       */
    double axes[9];  /* the same at present, turned as the support is                    */
    double mean[3];  /* of the way's directions now and when the step began              */
    double stretch;  /* what the way is longer by at present, where frames turn    [m]   */
};

/* Unknowns are 3 node + component: along x, y, z, or in the node's frame where it has one.
 * Vectors [nodes][3] have components along x, y, z throughout: what is held of them is had
 * by supports_get and supports_set. */
struct supports {
    int nodes, free_count, held_count, frame_count;
    void *room;        /* memory of the arrays                                   owned   */
    int *free_index;   /* [3 nodes] place among the free unknowns, -1 if held            */
    int *held;         /* [held_count] unknown 3 node + component, ascending             */
    int *owner;        /* [held_count] the support n that it follows; a difference: -1 - n;
                          SUPPORTS_NOBODY                                                */
    int *carrier;      /* [3 nodes] the held unknown whose motion is the first guess of that
                          of a free one, -1: none; all -1 unless set after init           */
    bool moving;       /* any of them moves                                              */
    double (*rest)[3]; /* [held_count] the node's rest [m] if any turns, else NULL     */
    /* Of a scene with grippers, else NULL, [nodes] or [3 nodes]: parameters of the nodes;
     * the support that holds an unknown, -1: none; its coordinate at rest; and the place
     * that its support's motion moves, which was taken hold of [m]. */
    double (*uvw)[3];
    int *whose;
    double *home, (*grip)[3];
    double checked; /* the time of the last supports_change                       [s]  */
    struct supports_frame *frame; /* [frame_count]                             owned   */
    int *framed; /* [nodes] the node's frame, -1: none; NULL if frame_count == 0  owned  */
};

/* Finds the held unknowns. uvw[nodes][3] and rest[nodes][3] [m]: parameters of the nodes
 * and their places, or differences, at rest; w < 0 (above) belongs to
 * a whole column, which only a support through the full thickness may hold, or of its
 * middle alone. STATUS_INPUT with a sentence if a support holds no node, STATUS_UNSUPPORTED
 * if it takes part of a column. */
enum status supports_init(struct supports *s, const struct scene *scene, int nodes,
                          double (*uvw)[3], const double *rest, struct message *why);
void supports_clear(struct supports *s);

/* Returns how many components may ever be held: arrays of [held_count] have room for so
 * many. */
int supports_most(const struct supports *s);

/* Lets grippers take hold and let go at time t, the start of a step, of nodes at
 * x[nodes][3]. Returns whether other unknowns are held than before; those that were free
 * have the velocity of their support then. */
bool supports_change(struct supports *s, const struct scene *scene, double t,
                     const double *x);

/* Returns whether a support's region has a node of these parameters. */
bool supports_covers(const struct scene_support *s, const double uvw[3]);

/* Gives frames to nodes that support `first` or a later one holds in all components: the
 * way from beside[node] (negative: none), of the same support, stays free. beside[nodes],
 * rest[nodes][3]. STATUS_MEMORY. */
enum status supports_release(struct supports *s, int first, const int *beside,
                             const double *rest);

/* Turns the frames to where their supports are at time t, the end of a step that began at
 * `from`, or t itself. x[nodes][3]: a shape of one of these times, or between, which tells
 * how far the ways are stretched. */
void supports_turn(struct supports *s, const struct scene *scene, double from, double t,
                   const double *x);

/* Turns them back to rest. */
void supports_turn_back(struct supports *s);

/* Return and set the h-th held component of x[nodes][3]; set all to zero. */
double supports_get(const struct supports *s, int h, const double *x);
void supports_set(const struct supports *s, int h, double *x, double value);
void supports_zero(const struct supports *s, double *x);

/* Replaces the components of f[nodes][3] along ways by those along the ways' means over the
 * step: across these do supports push, whose force then does no work as a way grows. (By
 * the ways at the end a step would be of first order.) */
void supports_lean(const struct supports *s, double *f);

/* Turn x[nodes][3] into the components that unknowns have, and back. */
void supports_to_frames(const struct supports *s, double *x);
void supports_from_frames(const struct supports *s, double *x);

/* Turns the block of a matrix that couples nodes a (rows) and b. */
void supports_turn_block(const struct supports *s, int a, int b, double block[9]);

/* Refuses, with STATUS_INPUT or STATUS_UNSUPPORTED and a sentence, where a scene has no
 * static equilibrium that the model can find: nothing is held and there are no obstacles;
 * or there are, or the sheet meets itself, and it cannot rest on `obstacles`; or supports
 * move besides them, or take hold or let go. */
enum status supports_allow_rest(const struct supports *s, const struct scene *scene,
                                bool obstacles, struct message *why);

/* Fills v[nodes][3] with initial velocities (scene_initial_velocity) [m/s]: of coefficients
 * at rest[nodes][3], with parameters uvw[nodes][3] if some of them are differences (NULL:
 * none). Zero where held; supports that move bring their own. */
void supports_initial_velocity(const struct supports *s, const struct scene *scene,
                               const double *rest, const double (*uvw)[3], double *v);

/* Supports take these parts of columns: each the full thickness; or some of them the
 * mid-surface and neither face, a hinge; or parts that columns as unknowns cannot hold. */
enum supports_columns { SUPPORTS_WHOLE, SUPPORTS_HINGED, SUPPORTS_LAYERED };
enum supports_columns supports_columns(const struct scene *scene);

/* Finds whether a support takes the middle of a column of nodes at uvw[layers][3], and at
 * most one of them. If so, its mid-surface replaces node `middle`: STATUS_UNSUPPORTED with
 * a sentence where a support takes that node with a part of the thickness. */
enum status supports_hinge(const struct scene *scene, int layers, const double (*uvw)[3],
                           int middle, bool *hinged, struct message *why);

/* Moves the free unknowns that have a carrier as far from x_old as it moved; nodes with
 * frames go along with the edge, the way from it as long as in x_old. */
void supports_carry(const struct supports *s, const double *x_old, double *x);

/* Multiplies the velocities v[nodes][3] of what is not held; held unknowns have that of
 * their support. */
void supports_damp(const struct supports *s, double factor, double *v);

/* Computes the shift of each held unknown from rest at time t, shift[held_count] [m]: in a
 * frame that of the place as far along the way as supports_turn found, by the present axes.
 */
void supports_shift(const struct supports *s, const struct scene *scene, double t,
                    double *shift);

/* Returns the time of static equilibrium: the scene's end if supports move, else 0. */
double supports_rest_time(const struct supports *s, const struct scene *scene);

#endif
