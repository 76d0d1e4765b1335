/* grid.h - the material grid on which every model is sampled: 100 x 100 x 2 points
 * (u,v,w) = (i/99, j/99, k). Fields are double xyz[GRID_W][GRID_V][GRID_U][3] in metres:
 * u fastest, then v, then w. */
#ifndef GRID_H
#define GRID_H

#include <stdbool.h>

enum { GRID_U = 100, GRID_V = 100, GRID_W = 2, GRID_POINTS = GRID_U * GRID_V * GRID_W };

/* Returns the parameters of grid point n = (k GRID_V + j) GRID_U + i. */
void grid_point(int n, double uvw[3]);

/* Several sheets (scene.h) share the columns i: sheet k of K has those from k GRID_U / K to
 * the last before (k + 1) GRID_U / K, both included, column[2]. */
void grid_columns(int sheets, int sheet, int column[2]);

/* Returns the sheet that has column i. */
int grid_sheet(int sheets, int i);

/* Tells whether the columns i and i + 1 belong to two sheets: nothing connects them. */
bool grid_cut(int sheets, int i);

/* Fills middle[n][n][3] with the mean of the layers at every `step`-th point, n = 99 / step
 * + 1, step a divisor of 99. */
void grid_middle(const double *xyz, int step, double *middle);

/* Fills xyz[GRID_POINTS][3], calling `probe` (struct model) for each point by itself. */
void grid_sample(void (*probe)(const void *state, int n, const double *uvw, double *xyz),
                 const void *state, double *xyz);

/* Returns the cell of x among `points` nodes evenly on [0,1], and its ends' weights. */
int grid_cell(int points, double x, double weight[2]);

#endif
