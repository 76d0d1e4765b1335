#include "fem_ref/hex_space.h"

#include <stdlib.h>
#include <string.h>

#include "models/linalg/gauss.h"
#include "models/mechanics/supports.h"

/* Evaluates linear functions of one direction: 1 - x, x; through the thickness, if asked,
 * their sum and difference 1, 2 x - 1. */
static void linear(double x, bool thickness, double N[2], double dN[2])
{
    N[0] = thickness ? 1 : 1 - x;
    N[1] = thickness ? 2 * x - 1 : x;
    dN[0] = thickness ? 0 : -1;
    dN[1] = thickness ? 2 : 1;
}

/* Computes values (unless NULL) and gradients at a point; local node (2 a + b) 2 + c. */
static void trilinear(const double x[3], bool thickness, double *N, double G[3][HEX_LOCAL])
{
    double f[3][2], d[3][2];

    for (int i = 0; i < 3; i++)
        linear(x[i], thickness && i == 2, f[i], d[i]);
    for (int t = 0; t < HEX_LOCAL; t++) {
        int a = t >> 2, b = t >> 1 & 1, c = t & 1;
        if (N)
            N[t] = f[0][a] * f[1][b] * f[2][c];
        G[0][t] = d[0][a] * f[1][b] * f[2][c];
        G[1][t] = f[0][a] * d[1][b] * f[2][c];
        G[2][t] = f[0][a] * f[1][b] * d[2][c];
    }
}

static void make_tables(struct hex_tables *t, bool thickness)
{
    double x[2], w[2], middle[3] = {0.5, 0.5, 0.5};

    memset(t, 0, sizeof *t);
    gauss_rule(2, x, w);
    for (int q = 0; q < HEX_GAUSS; q++) {
        double at[3] = {x[q >> 2], x[q >> 1 & 1], x[q & 1]};
        trilinear(at, thickness, t->N[q], t->G[q]);
        t->weight[q] = w[q >> 2] * w[q >> 1 & 1] * w[q & 1];
        for (int i = 0; i < 3; i++) /* mode i is 4 x_i (1 - x_i) */
            t->mode[q][i][i] = 4 * (1 - 2 * at[i]);
    }
    trilinear(middle, thickness, NULL, t->centre);
}

static void functions(const struct solid_space *space, int element,
                      struct solid_functions *out)
{
    const struct hex_tables *t = space->tables;

    (void)element;
    memcpy(out->N, t->N, sizeof t->N);
    memcpy(out->G, t->G, sizeof t->G);
    memcpy(out->weight, t->weight, sizeof t->weight);
}

static void number_elements(struct solid_space *space, int sheets, const int points[3])
{
    int m = points[1], l = points[2], *node = space->ien;

    for (int i = 0; i < sheets * points[0] - 1; i++)
        for (int j = 0; j < m - 1 && (i + 1) % points[0] != 0; j++)
            for (int k = 0; k < l - 1; k++)
                for (int t = 0; t < HEX_LOCAL; t++)
                    *node++ = ((i + (t >> 2)) * m + j + (t >> 1 & 1)) * l + k + (t & 1);
}

static void place_nodes(struct solid_space *space, int sheets, const int points[3],
                        const double *x)
{
    int node = 0;

    memcpy(space->rest, x, 3 * (size_t)space->nodes * sizeof *x);
    for (int i = 0; i < sheets * points[0]; i++)
        for (int j = 0; j < points[1]; j++)
            for (int k = 0; k < points[2]; k++, node++) {
                space->uvw[node][0] = (double)(i % points[0]) / (points[0] - 1);
                space->uvw[node][1] = (double)j / (points[1] - 1);
                space->uvw[node][2] = !space->thickness_basis ? (double)k / (points[2] - 1)
                                      : k == 0                ? SUPPORTS_MIDDLE
                                                              : SUPPORTS_DIFFERENCE;
            }
    for (int a = 0; space->thickness_basis && a < space->nodes; a += 2)
        for (int i = 0; i < 3; i++) {
            double bottom = x[3 * a + i], top = x[3 * (a + 1) + i];
            space->rest[3 * a + i] = (bottom + top) / 2;
            space->rest[3 * (a + 1) + i] = (top - bottom) / 2;
        }
}

enum status hex_space_init(struct solid_space *space, struct hex_tables *tables, int sheets,
                           const int points[3], const double *x, bool thickness,
                           bool incompatible)
{
    enum status st;
    int per_column = (points[1] - 1) * (points[2] - 1);
    struct solid_space new = {
        .nodes = sheets * points[0] * points[1] * points[2],
        .elements = sheets * (points[0] - 1) * per_column,
        .local = HEX_LOCAL,
        .gauss = HEX_GAUSS,
        .thickness_basis = thickness,
        .functions = functions,
        .tables = tables,
    };

    make_tables(tables, thickness);
    if (incompatible) {
        new.modes = HEX_MODES;
        new.mode_gradient = &tables->mode[0][0][0];
        new.centre_gradient = &tables->centre[0][0];
    }
    TRY(solid_space_allocate(&new, per_column, 1));
    number_elements(&new, sheets, points);
    place_nodes(&new, sheets, points, x);
    *space = new;
    return STATUS_OK;
out:
    solid_space_clear(&new);
    return st;
}
