/* grid.h - the material grid on which every model is sampled: 100 x 100 x 2 points
 * (u,v,w) = (i/99, j/99, k). Fields are double xyz[GRID_W][GRID_V][GRID_U][3] in metres:
 * u fastest, then v, then w. */
#ifndef GRID_H
#define GRID_H

enum { GRID_U = 100, GRID_V = 100, GRID_W = 2, GRID_POINTS = GRID_U * GRID_V * GRID_W };

/* Returns the parameters of grid point n = (k GRID_V + j) GRID_U + i. */
void grid_point(int n, double uvw[3]);

/* Fills xyz[GRID_POINTS][3], calling `probe` (struct model) for each point by itself. */
void grid_sample(void (*probe)(const void *state, int n, const double *uvw, double *xyz),
                 const void *state, double *xyz);

/* Returns the cell of x among `points` nodes evenly on [0,1], and its ends' weights. */
int grid_cell(int points, double x, double weight[2]);

#endif
