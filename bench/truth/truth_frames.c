#include "bench/truth/truth_frames.h"

#include "models/grid.h"

/* Mean of the two layers at (u, v). */
static void mid_surface(const double *field, double u, double v, double at[3])
{
    double across[2], along[2];
    const int i = grid_cell(GRID_U, u, along), j = grid_cell(GRID_V, v, across);

    at[0] = at[1] = at[2] = 0;
    for (int n = 0; n < 4 * GRID_W; n++) {
        const int di = n % 2, dj = n / 2 % 2, k = n / 4;
        const double *x = field + 3 * ((k * GRID_V + j + dj) * GRID_U + i + di);
        for (int c = 0; c < 3; c++)
            at[c] += along[di] * across[dj] * x[c] / GRID_W;
    }
}

enum status truth_frames_print(const struct truth_made *made, const int points[2],
                               FILE *file)
{
    fprintf(file, "# source: %s\n", made->note);
    for (int t = 0; t < made->claimed; t++)
        fprintf(file, "# bar: %.17g,%.17g\n", made->time[t], made->value[t][TRUTH_ERROR]);
    fprintf(file, "t,u,v,x,y,z\n");
    for (int t = 0; t < made->claimed; t++)
        for (int n = 0; n < points[0] * points[1]; n++) {
            const double u = n % points[0] / (points[0] - 1.0);
            const double v = n / points[0] / (points[1] - 1.0);
            double x[3];
            mid_surface(made->xyz[t], u, v, x);
            fprintf(file, "%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", made->time[t], u, v,
                    x[0], x[1], x[2]);
        }
    return ferror(file) ? STATUS_FILE : STATUS_OK;
}
