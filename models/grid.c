#include "models/grid.h"

#include <assert.h>

void grid_point(int n, double uvw[3])
{
    assert(0 <= n && n < GRID_POINTS);
    uvw[0] = n % GRID_U / (GRID_U - 1.0);
    uvw[1] = n / GRID_U % GRID_V / (GRID_V - 1.0);
    uvw[2] = n / (GRID_U * GRID_V) / (GRID_W - 1.0);
}

void grid_columns(int sheets, int sheet, int column[2])
{
    column[0] = sheet * GRID_U / sheets;
    column[1] = (sheet + 1) * GRID_U / sheets - 1;
}

int grid_sheet(int sheets, int i)
{
    return ((i + 1) * sheets - 1) / GRID_U;
}

bool grid_cut(int sheets, int i)
{
    return sheets > 1 && i + 1 < GRID_U &&
           grid_sheet(sheets, i) < grid_sheet(sheets, i + 1);
}

void grid_middle(const double *xyz, int step, double *middle)
{
    for (int j = 0; j < GRID_V; j += step)
        for (int i = 0; i < GRID_U; i += step, middle += 3) {
            const double *below = xyz + 3 * (j * GRID_U + i);
            for (int c = 0; c < 3; c++)
                middle[c] = 0.5 * (below[c] + below[3 * GRID_U * GRID_V + c]);
        }
}

void grid_sample(void (*probe)(const void *state, int n, const double *uvw, double *xyz),
                 const void *state, double *xyz)
{
    for (int n = 0; n < GRID_POINTS; n++) {
        double uvw[3];
        grid_point(n, uvw);
        probe(state, 1, uvw, xyz + 3 * n);
    }
}

int grid_cell(int points, double x, double weight[2])
{
    double s = x * (points - 1);
    int i = s < 0 ? 0 : (int)s;

    if (i > points - 2)
        i = points - 2;
    weight[1] = s - i;
    weight[0] = 1 - weight[1];
    return i;
}
