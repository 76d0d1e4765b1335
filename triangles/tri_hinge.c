#include "triangles/tri_hinge.h"
#include "models/vector.h"

#include <math.h>
#include <string.h>

/* The geometry of a hinge: the three vectors from x[0], the normals as long as twice the
 * triangles' areas, and how far along the edge x[2] and x[3] stand. */
struct frame {
    double e[3], side[2][3], normal[2][3], edge, square[2], foot[2];
    double turn[2][3]; /* derivatives of the angle by the sides                        */
};

static struct frame frame_of(const double x[4][3])
{
    struct frame f;

    for (int i = 0; i < 3; i++) {
        f.e[i] = x[1][i] - x[0][i];
        f.side[0][i] = x[2][i] - x[0][i];
        f.side[1][i] = x[3][i] - x[0][i];
    }
    vector_cross(f.e, f.side[0], f.normal[0]);
    vector_cross(f.side[1], f.e, f.normal[1]);
    f.edge = sqrt(vector_dot(f.e, f.e));
    for (int s = 0; s < 2; s++) {
        f.square[s] = vector_dot(f.normal[s], f.normal[s]);
        f.foot[s] = vector_dot(f.side[s], f.e) / (f.edge * f.edge);
        for (int i = 0; i < 3; i++)
            f.turn[s][i] = -f.edge / f.square[s] * f.normal[s][i];
    }
    return f;
}

double tri_hinge_angle(const double x[4][3])
{
    struct frame f = frame_of(x);
    double c[3];

    vector_cross(f.normal[0], f.normal[1], c);
    return f.square[0] > 0 && f.square[1] > 0
               ? atan2(vector_dot(c, f.e) / f.edge, vector_dot(f.normal[0], f.normal[1]))
               : NAN;
}

/* Computes the derivative by the edge: turning all until it is back changes nothing. */
static void turn_of_edge(const struct frame *f, double g[3])
{
    for (int i = 0; i < 3; i++)
        g[i] = -f->foot[0] * f->turn[0][i] - f->foot[1] * f->turn[1][i];
}

void tri_hinge_gradient(const double x[4][3], double gradient[12])
{
    struct frame f = frame_of(x);

    turn_of_edge(&f, gradient + 3);
    memcpy(gradient + 6, f.turn, sizeof f.turn);
    for (int i = 0; i < 3; i++)
        gradient[i] = -gradient[3 + i] - gradient[6 + i] - gradient[9 + i];
}

/* Computes G = -|e| / |N|^2 (I - 2 n n') [w]x times `sign`, the change of a side's turn as
 * its normal gains `sign` w x d. */
static void turn_by_normal(const struct frame *f, int s, const double w[3], double sign,
                           double G[3][3])
{
    const double *N = f->normal[s];
    const double W[3][3] = {{0, -w[2], w[1]}, {w[2], 0, -w[0]}, {-w[1], w[0], 0}};

    for (int j = 0; j < 3; j++) {
        double along =
            2 * (N[0] * W[0][j] + N[1] * W[1][j] + N[2] * W[2][j]) / f->square[s];
        for (int i = 0; i < 3; i++)
            G[i][j] = -sign * f->edge / f->square[s] * (W[i][j] - along * N[i]);
    }
}

/* Computes second derivatives by e and both sides: [row][column][3][3], sides 1 and 2. */
static void second(const struct frame *f, double G[3][3][3][3])
{
    double e2 = f->edge * f->edge;

    memset(G, 0, 9 * sizeof G[0][0]);
    for (int s = 0; s < 2; s++) {
        double sign = s ? -1 : 1;
        turn_by_normal(f, s, f->e, sign, G[1 + s][1 + s]);
        turn_by_normal(f, s, f->side[s], -sign, G[1 + s][0]);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                G[1 + s][0][i][j] += f->turn[s][i] * f->e[j] / e2;
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) {
                double foot = (f->side[s][j] - 2 * f->foot[s] * f->e[j]) / e2;
                G[0][1 + s][j][i] = G[1 + s][0][i][j];
                G[0][0][i][j] -= f->turn[s][i] * foot + f->foot[s] * G[1 + s][0][i][j];
            }
    }
}

void tri_hinge_hessian(const double x[4][3], double H[12][12])
{
    struct frame f = frame_of(x);
    double G[3][3][3][3];

    second(&f, G);
    memset(H, 0, 12 * sizeof *H);
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++)
            for (int i = 0; i < 3; i++)
                for (int j = 0; j < 3; j++) {
                    double g = (G[a][b][i][j] + G[b][a][j][i]) / 2;
                    H[3 + 3 * a + i][3 + 3 * b + j] += g;
                    H[i][3 + 3 * b + j] -= g;
                    H[3 + 3 * a + i][j] -= g;
                    H[i][j] += g;
                }
}
