#include "models/grid.h"

#include <assert.h>

void grid_point(int n, double uvw[3])
{
    assert(0 <= n && n < GRID_POINTS);
    uvw[0] = n % GRID_U / (GRID_U - 1.0);
    uvw[1] = n / GRID_U % GRID_V / (GRID_V - 1.0);
    uvw[2] = n / (GRID_U * GRID_V) / (GRID_W - 1.0);
}
