#include "models/mesh_cells.h"

#include <string.h>

#include "models/vector.h"

int mesh_cells_across(const struct mesh_cells *c, int triangle, int corner)
{
    const struct mesh_edge *e = &c->edge[c->side[triangle][corner]];

    return e->triangle[e->triangle[0] == triangle];
}

int mesh_cells_round(const struct mesh_cells *c, int triangle, int point, int last)
{
    for (;;) {
        const int *corner = c->corner[triangle];
        const int k = corner[0] == last ? 0 : corner[1] == last ? 1 : 2;
        const int *end = c->edge[c->side[triangle][k]].node;
        const int next = mesh_cells_across(c, triangle, k);
        if (next < 0)
            return triangle;
        last = end[end[0] == point];
        triangle = next;
    }
}

int mesh_cells_points(const struct mesh_cells *c, int triangle, int point[3])
{
    int count = 0;

    for (int k = 0; k < 3; k++) {
        const int corner = c->corner[triangle][k];
        if (c->ring[c->ring_at[corner]] == triangle)
            point[count++] = corner;
    }
    return count;
}

int mesh_cells_edges(const struct mesh_cells *c, int triangle, int edge[3][2])
{
    int count = 0;

    for (int k = 0; k < 3; k++) {
        const struct mesh_edge *e = &c->edge[c->side[triangle][k]];
        if (e->triangle[0] == triangle)
            memcpy(edge[count++], e->node, sizeof *edge);
    }
    return count;
}

int mesh_cells_rims(const struct mesh_cells *c, int triangle, int edge[3])
{
    int count = 0;

    for (int k = 0; k < 3; k++)
        if (c->edge[c->side[triangle][k]].triangle[1] < 0)
            edge[count++] = c->side[triangle][k];
    return count;
}

void mesh_cells_normal(const struct mesh_cells *c, const double *y, int point,
                       double normal[3])
{
    const double per_area = 1 / (6 * c->area[point]);

    normal[0] = normal[1] = normal[2] = 0;
    for (int n = c->ring_at[point]; n < c->ring_at[point + 1]; n++) {
        const int *corner = c->corner[c->ring[n]];
        double a[3], b[3], twice[3];
        vector_between(y + 3 * (long)corner[0], y + 3 * (long)corner[1], a);
        vector_between(y + 3 * (long)corner[0], y + 3 * (long)corner[2], b);
        vector_cross(a, b, twice);
        for (int i = 0; i < 3; i++)
            normal[i] += per_area * twice[i];
    }
}

double mesh_cells_turn(const struct mesh_cells *c, const double *y, int point, double most)
{
    double sum = 0;

    for (int n = c->ring_at[point]; n < c->ring_at[point + 1]; n++) {
        const int *corner = c->corner[c->ring[n]];
        const double *from = y + 3 * (long)corner[0];
        sum += vector_distance(from, y + 3 * (long)corner[1]) +
               vector_distance(from, y + 3 * (long)corner[2]) + most;
    }
    return sum / (6 * c->area[point]);
}

void mesh_cells_slopes(const struct mesh_cells *c, const double *y, int triangle,
                       double along_u[3], double along_v[3])
{
    const int *corner = c->corner[triangle];
    const double *p = c->at[corner[0]], *q = c->at[corner[1]], *r = c->at[corner[2]];
    const double a[2] = {q[0] - p[0], q[1] - p[1]}, b[2] = {r[0] - p[0], r[1] - p[1]};
    const double per_area = 1 / (a[0] * b[1] - a[1] * b[0]);

    for (int i = 0; i < 3; i++) {
        const double from = y[3 * (long)corner[0] + i];
        const double e = y[3 * (long)corner[1] + i] - from;
        const double f = y[3 * (long)corner[2] + i] - from;
        along_u[i] = (b[1] * e - a[1] * f) * per_area;
        along_v[i] = (a[0] * f - b[0] * e) * per_area;
    }
}
