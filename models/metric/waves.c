#include "models/metric/waves.h"

#include <math.h>
#include <string.h>

#include "models/grid.h"

enum { U = GRID_U - 2, V = GRID_V - 2, LAYER = GRID_U * GRID_V };

static const double PI = 3.14159265358979323846;

/* Fills table[i][k]: cosine k of n points at the i-th, orthonormal. */
static void cosines(int n, double *table)
{
    for (int k = 0; k < n; k++)
        for (int i = 0; i < n; i++)
            table[i * n + k] = sqrt((k ? 2.0 : 1.0) / n) * cos(PI * k * (i + 0.5) / n);
}

/* Returns the mid-surface's component c. */
static double at(const double *xyz, int i, int j, int c)
{
    const double *below = xyz + 3 * (j * GRID_U + i) + c;

    return 0.5 * (below[0] + below[3 * LAYER]);
}

/* Bends columns: those of a sheet, n of which have neighbours, after column `first`. */
static void bend(const double *xyz, int first, int n, int c, double da, double db,
                 double f[V][U])
{
    for (int j = 0; j < V; j++)
        for (int i = first; i < first + n; i++) {
            const double x = 2 * at(xyz, i + 1, j + 1, c);
            f[j][i - first] =
                (at(xyz, i + 2, j + 1, c) - x + at(xyz, i, j + 1, c)) / (da * da) +
                (at(xyz, i + 1, j + 2, c) - x + at(xyz, i + 1, j, c)) / (db * db);
        }
}

/* Transforms along u, then along v; rows innermost, as they lie in memory. */
static void transform(int n, const double *along_u, const double *along_v, double f[V][U])
{
    double g[V][U] = {{0}};

    for (int j = 0; j < V; j++)
        for (int i = 0; i < n; i++)
            for (int k = 0; k < n; k++)
                g[j][k] += f[j][i] * along_u[i * n + k];
    memset(f, 0, sizeof g);
    for (int l = 0; l < V; l++)
        for (int j = 0; j < V; j++)
            for (int k = 0; k < n; k++)
                f[l][k] += along_v[j * V + l] * g[j][k];
}

/* Returns minus the factor of second differences of step d on cosine k of n points. */
static double symbol(int k, int n, double d)
{
    return (2 - 2 * cos(PI * k / n)) / (d * d);
}

/* Returns the band of the wave of k halves over n steps da and l over m steps db. */
static int band_of(double length, double a, double b)
{
    const double wave = 2 / sqrt(a * a + b * b);
    int band = 0;

    while (band < WAVES_BANDS - 1 && wave <= length / (1 << band))
        band++;
    return band;
}

static void add(int n, const double f[V][U], double length, double da, double db,
                double *sum)
{
    for (int l = 0; l < V; l++)
        for (int k = 0; k < n; k++) {
            if (!k && !l)
                continue;
            const double height = f[l][k] / (symbol(k, n, da) + symbol(l, V, db));
            sum[band_of(length, k / (n * da), l / (V * db))] += height * height;
        }
}

void waves_spectrum(const struct scene *scene, const double *xyz, double rms[WAVES_BANDS])
{
    const double db = scene->width / (GRID_V - 1);
    double along_u[U * U], along_v[V * V], f[V][U], sum[WAVES_BANDS] = {0};
    int column[2], points = 0;
    bool nan = false;

    cosines(V, along_v);
    for (int k = 0; k < scene_sheets(scene); k++) {
        grid_columns(scene_sheets(scene), k, column);
        const int n = column[1] - column[0] - 1;
        const double da = scene->length / (n + 1);
        cosines(n, along_u);
        for (int c = 0; c < 3; c++) {
            bend(xyz, column[0], n, c, da, db, f);
            transform(n, along_u, along_v, f);
            add(n, f, scene->length, da, db, sum);
            nan |= isnan(f[0][0]);
        }
        points += n * V;
    }
    for (int n = 0; n < WAVES_BANDS; n++)
        rms[n] = nan ? NAN : sqrt(sum[n] / points) / scene->length;
}
