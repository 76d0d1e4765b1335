/* score_net.h - a net of vertices with material coordinates, and how values at its vertices
 * become values at points of the sheet: bilinear where the vertices stand in rows and
 * columns (unevenly, or with a row outside of the sheet, too), else linear in triangles. Of
 * a sheet with an outline it is always triangles, and points beside the sheet are NaN.
 */
#ifndef SCORE_NET_H
#define SCORE_NET_H

#include "bench/files/arena.h"
#include "bench/frames/frames.h"
#include "models/scene.h"

/* Weights of four vertices for each of nu x nv points (u, v) = (i/(nu-1), j/(nv-1)), u
 * fastest; NaN beside a sheet with an outline, where points are the material grid's nearest
 * ones. */
struct score_map {
    int nu, nv;
    int used, *vertex; /* [used] those that have a weight                              */
    double (*uv)[2];   /* [used] of them, on so many sheets                            */
    int sheets;
    int (*place)[4];     /* [nu nv] in these lists                                       */
    double (*weight)[4]; /* [nu nv] */
};

struct score_net {
    int vertices;
    int columns, rows; /* 0: it has none; set by score_net_map                        */
    int points[2];     /* frames.h                                                    */
    double *uv;        /* [vertices][2]                                                */
    bool by_position;  /* uv were found from rest positions                            */
};

/* Completes the frames' net, of which *net is a copy, to triangles of a sheet with an
 * outline, in the arena: corners' places are of its box, from 0 to 1; where the file has no
 * triangles (of a garment: no places of corners) they are the scene's own mesh, in its
 * order. Leaves others as they are. STATUS_INPUT: it has neither. */
enum status score_net_complete(struct arena *arena, const struct scene *scene,
                               const char *name, struct frames_net *net,
                               struct message *why);

/* Returns the material grid's index of the point nearest to the n-th of nu x nv. */
int score_net_grid(int nu, int nv, int n);

/* Finds material coordinates, which lie in the arena: the net's own; else those of its rest
 * mesh; else, where each vertex lies on a flat rest shape, from the first frame, xyz
 * [vertices][3] [m]. `rest` is that mesh in the scene's axes and units, or NULL.
 * STATUS_INPUT with a sentence that begins with the name. */
enum status score_net_make(struct arena *arena, const struct frames_net *frames,
                           const struct scene *scene, const char *name, const double *rest,
                           const double *xyz, struct score_net *net, struct message *why);

/* Makes the map, in the arena, of a net made of these frames; points between two sheets are
 * taken from the nearest one. STATUS_INPUT: vertices do not cover the sheet, or neither
 * stand in rows and columns nor have faces. */
enum status score_net_map(struct arena *arena, struct score_net *net,
                          const struct frames_net *frames, const struct scene *scene,
                          const char *name, int nu, int nv, struct score_map *map,
                          struct message *why);

/* Lists the triangles of a net that has a map: its faces, else the cells between rows and
 * columns of one sheet, cut as in intersection.h. Returns corners [*count][3],
 * in the arena. */
int (*score_net_triangles(struct arena *arena, const struct score_net *net,
                          const struct frames_net *frames, const struct scene *scene,
                          int *count))[3];

/* Fills field[nu nv][3] from xyz[vertices][3]. */
void score_map_apply(const struct score_map *map, const double *xyz, double *field);

/* Fills seen[map->nu map->nv][3] from a field [nv][nu][3] between the map's vertices. */
void score_map_seen(const struct score_map *map, int nu, int nv, const double *field,
                    double *seen);

/* Returns the first of the four points, of `points` evenly on [0, 1], whose cubic is used
 * at x, and their Lagrange weights. points >= 4. */
int score_net_cubic(int points, double x, double weight[4]);

/* Interpolates a field [nv][nu][3] at (u, v), by cubics; of several sheets, where nu is the
 * material grid's, by those of the sheet that has u. */
void score_net_sample(int sheets, int nu, int nv, const double *field, const double uv[2],
                      double xyz[3]);

#endif
