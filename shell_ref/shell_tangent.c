#include "shell_ref/shell_tangent.h"

#include "shell_ref/shell_frame.h"

/* Rows over the functions at each point of the membrane: b, and a with factors and areas.
 */
enum { FLAT_RIGHT = 2 /* N_u, N_v */, FLAT_LEFT = 18 /* [2][3][3] P_d = N_c Q_cd */ };

/* Rows over the functions b at each point of bending. */
enum {
    RIGHT_SLOPE = 0,   /* N_u, N_v                                                    */
    RIGHT_BENDING = 2, /* phi_11, phi_22, 2 phi_12                                    */
    RIGHT_MOMENT = 5,  /* M^ab phi_ab                                                 */
    RIGHT_SURFACE = 6, /* [3] a^c N_c                                                 */
    RIGHT = 9
};
/* Rows over the functions a there, factors and areas included. */
enum {
    LEFT_BENDING = 0, /* [3] h^3/12 C phi                                             */
    LEFT_CURVED = 3,  /* [2] M^ab b_ab a^cd N_c                                       */
    LEFT_SURFACE = 5, /* [3] a^c N_c                                                  */
    LEFT_MOMENT = 8,  /* [3] M^ab phi_ab n                                            */
    LEFT = 11
};

size_t shell_tangent_left(const struct shell_space *space)
{
    return (size_t)(FLAT_LEFT * space->rule[SHELL_MEMBRANE].padded +
                    LEFT * space->rule[SHELL_BENDING].padded);
}

size_t shell_tangent_right(const struct shell_space *space)
{
    return (size_t)(FLAT_RIGHT * space->rule[SHELL_MEMBRANE].padded +
                    RIGHT * space->rule[SHELL_BENDING].padded);
}

/* N_u, N_v, ... of one point, functions running fastest: D[rows][row]. */
static void turn(const struct shell_element *e, const struct shell_points *p, int q,
                 int rows, double *D)
{
    size_t stride = (size_t)(e->local * p->padded);

    for (int k = 0; k < rows; k++)
        for (int a = 0; a < e->local; a++)
            D[k * e->row + a] =
                p->T[(size_t)(k + 1) * stride + (size_t)(a * p->padded + q)];
}

/* --- membrane ----------------------------------------------------------------------------
 *
 * The block of functions a and b is N_c,a N_d,b Q_cd,
 *   Q_cd = material C^{c e d f} a_e a_f^T + geometric N^{cd} I. */

/* Q[2][2][3][3] at four points; the law times the area in C, resultants in N. */
static void membrane_blocks(shell_lanes a[2][3], shell_lanes C[3][3], shell_lanes N[3],
                            double material, double geometric, shell_lanes Q[4][9])
{
    static const int form[2][2] = {{0, 2}, {2, 1}};

    for (int c = 0; c < 2; c++)
        for (int d = 0; d < 2; d++) {
            shell_lanes *block = Q[2 * c + d];
            for (int j = 0; j < 3; j++) {
                shell_lanes to[2];
                for (int e = 0; e < 2; e++)
                    to[e] = C[form[c][e]][form[d][0]] * (material * a[0][j]) +
                            C[form[c][e]][form[d][1]] * (material * a[1][j]);
                for (int i = 0; i < 3; i++)
                    block[3 * i + j] = a[0][i] * to[0] + a[1][i] * to[1];
            }
            for (int i = 0; i < 3; i++)
                block[4 * i] += geometric * N[form[c][d]];
        }
}

static void fill_membrane(struct shell_element *e, const struct shell_material *material,
                          const double *rest, const struct large_path *path)
{
    const struct shell_points *p = &e->at[SHELL_MEMBRANE];
    double h = shell_frame_stiffness(material, SHELL_MEMBRANE);
    shell_lanes C[3][3], N[3], a[2][3], Q[4][9];
    int row = e->row;

    for (int q = 0; q < p->count; q++) {
        int t = q % SHELL_LANES;
        double *R = e->right + q * FLAT_RIGHT * row, *L = e->left + q * FLAT_LEFT * row;
        if (t == 0) {
            shell_frame_law(rest, p->padded, q, C);
            shell_frame_resultants(p, h, C, q, N);
            shell_frame_derive(p, e->local, e->X[1], q, 2, a);
            membrane_blocks(a, C, N, (path->s1 + path->lag) * h, path->g1, Q);
        }
        turn(e, p, q, 2, R);
        for (int d = 0; d < 2; d++)
            for (int k = 0; k < 9; k++) {
                double u = Q[d][k][t], v = Q[2 + d][k][t];
                for (int b = 0; b < row; b++)
                    L[(9 * d + k) * row + b] = u * R[b] + v * R[row + b];
            }
    }
}

/* s += the 3 x 3 blocks of functions a and four b at one point. l: rows at a; r: rows at
 * the four b; both `row` apart. */
static inline void add_membrane(const double *restrict l, const double *restrict r, int row,
                                shell_lanes s[9])
{
    shell_lanes u = *(const shell_lanes *)r, v = *(const shell_lanes *)(r + row);

    for (int k = 0; k < 9; k++)
        s[k] += l[k * row] * u + l[(9 + k) * row] * v;
}

/* --- bending ----------------------------------------------------------------------------
 */

/* One point taken out of four. */
struct point {
    double n[3], dual[2][3], gamma[2][3], inverse[3];
    double C[3][3], m[3], curved;
};

static void pick(const struct shell_frame *f, shell_lanes C[3][3], const shell_lanes *m,
                 int t, struct point *p)
{
    for (int i = 0; i < 3; i++) {
        p->n[i] = f->s.n[i][t];
        p->inverse[i] = f->inverse[i][t];
        p->m[i] = m[i][t];
        for (int d = 0; d < 2; d++) {
            p->dual[d][i] = f->dual[d][i][t];
            p->gamma[d][i] = f->gamma[d][i][t];
        }
        for (int j = 0; j < 3; j++)
            p->C[i][j] = C[i][j][t];
    }
    p->curved = p->m[0] * f->curvature[0][t] + p->m[1] * f->curvature[1][t] +
                2 * p->m[2] * f->curvature[2][t];
}

/* Rows over the functions of one point; the derivatives N_u .. N_uv in D[5][row]. */
static void fill_right(const struct point *p, int row, const double *restrict D,
                       double *restrict R)
{
    const double *u = D, *v = D + row, *uu = D + 2 * row, *vv = D + 3 * row,
                 *uv = D + 4 * row;

    memcpy(R + RIGHT_SLOPE * row, D, 2 * (size_t)row * sizeof *R);
    for (int j = 0; j < 3; j++)
        for (int b = 0; b < row; b++)
            R[(RIGHT_SURFACE + j) * row + b] = u[b] * p->dual[0][j] + v[b] * p->dual[1][j];
    for (int b = 0; b < row; b++) {
        double f0 = uu[b] - p->gamma[0][0] * u[b] - p->gamma[1][0] * v[b];
        double f1 = vv[b] - p->gamma[0][1] * u[b] - p->gamma[1][1] * v[b];
        double f2 = 2 * (uv[b] - p->gamma[0][2] * u[b] - p->gamma[1][2] * v[b]);
        R[RIGHT_BENDING * row + b] = f0;
        R[(RIGHT_BENDING + 1) * row + b] = f1;
        R[(RIGHT_BENDING + 2) * row + b] = f2;
        R[RIGHT_MOMENT * row + b] = p->m[0] * f0 + p->m[1] * f1 + p->m[2] * f2;
    }
}

static void fill_left(const struct point *p, double bending, double geometric, int row,
                      const double *restrict R, double *restrict L)
{
    const double *u = R, *v = R + row, *phi = R + RIGHT_BENDING * row, *in = p->inverse;
    double curved = geometric * p->curved;

    for (int k = 0; k < 3; k++)
        for (int b = 0; b < row; b++) {
            L[(LEFT_BENDING + k) * row + b] =
                bending * (p->C[k][0] * phi[b] + p->C[k][1] * phi[row + b] +
                           p->C[k][2] * phi[2 * row + b]);
            L[(LEFT_SURFACE + k) * row + b] = geometric * R[(RIGHT_SURFACE + k) * row + b];
            L[(LEFT_MOMENT + k) * row + b] =
                geometric * p->n[k] * R[RIGHT_MOMENT * row + b];
        }
    for (int b = 0; b < row; b++) {
        L[LEFT_CURVED * row + b] = curved * (in[0] * u[b] + in[2] * v[b]);
        L[(LEFT_CURVED + 1) * row + b] = curved * (in[2] * u[b] + in[1] * v[b]);
    }
}

/* left, right: rows of the first point. normal[count][3]. */
static void fill_bending(struct shell_element *e, const struct shell_material *material,
                         const double *rest, const struct large_path *path, double *left,
                         double *right, double (*normal)[3])
{
    const struct shell_points *p = &e->at[SHELL_BENDING];
    double D[5 * SHELL_PADDED(SHELL_MAX_LOCAL)] = {0};
    double stiffness = shell_frame_stiffness(material, SHELL_BENDING);
    struct shell_frame f;
    shell_lanes C[3][3], m[3];

    for (int q = 0; q < p->count; q++) {
        int t = q % SHELL_LANES;
        struct point at;
        if (t == 0) {
            shell_frame_law(rest, p->padded, q, C);
            shell_frame_resultants(p, stiffness, C, q, m);
            shell_frame_frame(e, p, q, &f);
        }
        pick(&f, C, m, t, &at);
        turn(e, p, q, 5, D);
        fill_right(&at, e->row, D, right);
        fill_left(&at, path->s1 * stiffness, path->g1, e->row, right, left);
        memcpy(normal[q], at.n, sizeof at.n);
        right += RIGHT * e->row, left += LEFT * e->row;
    }
}

static inline void add_bending(const double *restrict l, const double *restrict r, int row,
                               const double n[3], shell_lanes s[9])
{
#define AT_B(k) (*(const shell_lanes *)(r + (k)*row))
#define AT_A(k) (l[(k)*row])
    shell_lanes moment = AT_B(RIGHT_MOMENT);
    shell_lanes t = AT_A(LEFT_CURVED) * AT_B(RIGHT_SLOPE) +
                    AT_A(LEFT_CURVED + 1) * AT_B(RIGHT_SLOPE + 1);

    for (int k = 0; k < 3; k++)
        t += AT_A(LEFT_BENDING + k) * AT_B(RIGHT_BENDING + k);
    for (int j = 0; j < 3; j++) {
        shell_lanes along = n[j] * t + AT_A(LEFT_SURFACE + j) * moment;
        for (int i = 0; i < 3; i++)
            s[3 * i + j] += n[i] * along + AT_A(LEFT_MOMENT + j) * AT_B(RIGHT_SURFACE + i);
    }
#undef AT_B
#undef AT_A
}

/* K[a][3 i + j][b] from the shell_lanes that hold b = a on. left, right: of bending. */
static void sum_blocks(struct shell_element *e, const double *left, const double *right,
                       double (*normal)[3])
{
    int row = e->row;

    for (int a = 0; a < e->local; a++)
        for (int c = a / SHELL_LANES * SHELL_LANES; c < row; c += SHELL_LANES) {
            double *K = e->K + a * 9 * row + c;
            shell_lanes s[9] = {{0}};
            for (int q = 0; q < e->at[SHELL_MEMBRANE].count; q++)
                add_membrane(e->left + a + q * FLAT_LEFT * row,
                             e->right + c + q * FLAT_RIGHT * row, row, s);
            for (int q = 0; q < e->at[SHELL_BENDING].count; q++)
                add_bending(left + a + q * LEFT * row, right + c + q * RIGHT * row, row,
                            normal[q], s);
            for (int t = 0; t < 9; t++)
                *(shell_lanes *)(K + t * row) = s[t];
        }
}

void shell_tangent_compute(struct shell_element *e, const struct shell_material *material,
                           const double *const rest[], const struct large_path *path)
{
    double normal[SHELL_MAX_POINTS][3];
    int flat = e->at[SHELL_MEMBRANE].count * e->row;
    double *left = e->left + FLAT_LEFT * flat, *right = e->right + FLAT_RIGHT * flat;

    fill_membrane(e, material, rest[SHELL_MEMBRANE], path);
    fill_bending(e, material, rest[SHELL_BENDING], path, left, right, normal);
    sum_blocks(e, left, right, normal);
}
