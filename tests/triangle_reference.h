/* triangle_reference.h - do two triangles have a point in common that is not in the hull of
 * their first `shared` corners? By another way than models/metric/triangle.c: linear
 * programming in integers. With weights l, m >= 0 summing to 1 each, the common points are
 * sum l_i p_i = sum m_j q_j; every vertex of that set of (l, m) is the one solution on some
 * set of independent columns. The common points are the hull of the vertices' points, so it
 * is enough to look at those. Exact for |coordinates| <= 1000.
 */
#ifndef TRIANGLE_REFERENCE_H
#define TRIANGLE_REFERENCE_H

#include <stdbool.h>
#include <string.h>

typedef __int128 wide;

enum { EQUATIONS = 5, COLUMNS = 6 };

/* Solves the columns in `set` for the weights, as weight[i] / *divisor with *divisor > 0,
 * by elimination without fractions (Bareiss). False if they depend on each other, or do not
 * solve it. */
static bool solve_columns(const int a[EQUATIONS][COLUMNS + 1], unsigned set,
                          wide weight[COLUMNS], wide *divisor)
{
    wide m[EQUATIONS][COLUMNS + 1], last = 1;
    int column[COLUMNS], n = 0;

    for (int c = 0; c < COLUMNS; c++)
        if (set >> c & 1)
            column[n++] = c;
    for (int r = 0; r < EQUATIONS; r++) {
        for (int c = 0; c < n; c++)
            m[r][c] = a[r][column[c]];
        m[r][n] = a[r][COLUMNS];
    }
    if (n > EQUATIONS)
        return false;
    for (int c = 0; c < n; c++) {
        int pivot = c;
        while (pivot < EQUATIONS && m[pivot][c] == 0)
            pivot++;
        if (pivot == EQUATIONS)
            return false;
        for (int k = 0; k <= n; k++) {
            wide swapped = m[c][k];
            m[c][k] = m[pivot][k], m[pivot][k] = swapped;
        }
        for (int r = 0; r < EQUATIONS; r++)
            for (int k = n; r != c && k >= 0; k--)
                if (k != c)
                    m[r][k] = (m[c][c] * m[r][k] - m[r][c] * m[c][k]) / last;
        for (int r = 0; r < EQUATIONS; r++)
            if (r != c)
                m[r][c] = 0;
        last = m[c][c];
    }
    for (int r = n; r < EQUATIONS; r++)
        if (m[r][n] != 0)
            return false;
    memset(weight, 0, COLUMNS * sizeof *weight);
    for (int c = 0; c < n; c++)
        weight[column[c]] = last < 0 ? -m[c][n] : m[c][n];
    *divisor = last < 0 ? -last : last;
    return true;
}

/* x / divisor in the hull of the first `shared` corners of p. */
static bool in_hull(const int p[3][3], int shared, const wide x[3], wide divisor)
{
    wide along[3], edge[3], dot = 0, square = 0;

    if (shared == 0)
        return false;
    for (int c = 0; c < 3; c++) {
        along[c] = x[c] - divisor * p[0][c];
        edge[c] = shared == 2 ? p[1][c] - p[0][c] : 0;
        dot += along[c] * edge[c];
        square += edge[c] * edge[c] * divisor;
    }
    for (int c = 0; c < 3; c++)
        if (along[c] * edge[(c + 1) % 3] != along[(c + 1) % 3] * edge[c])
            return false;
    if (square == 0)
        return along[0] == 0 && along[1] == 0 && along[2] == 0;
    return dot >= 0 && dot <= square;
}

static bool reference_meets(const int p[3][3], const int q[3][3], int shared)
{
    int a[EQUATIONS][COLUMNS + 1] = {
        [3] = {1, 1, 1, 0, 0, 0, 1},
        [4] = {0, 0, 0, 1, 1, 1, 1},
    };

    for (int c = 0; c < 3; c++)
        for (int i = 0; i < 3; i++) {
            a[c][i] = p[i][c];
            a[c][3 + i] = -q[i][c];
        }
    for (unsigned set = 1; set < 1u << COLUMNS; set++) {
        wide weight[COLUMNS], divisor, x[3] = {0, 0, 0};
        bool feasible = solve_columns(a, set, weight, &divisor);
        for (int c = 0; feasible && c < COLUMNS; c++)
            feasible = weight[c] >= 0;
        if (!feasible)
            continue;
        for (int c = 0; c < 3; c++)
            for (int i = 0; i < 3; i++)
                x[c] += weight[i] * p[i][c];
        if (!in_hull(p, shared, x, divisor))
            return true;
    }
    return false;
}

#endif
