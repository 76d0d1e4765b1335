#include "shell_ref/shell_tangent.h"

#include "shell_ref/shell_frame.h"

/* Rows over the functions b, one set per Gauss point. */
enum {
    RIGHT_SLOPE = 0,    /* N_u, N_v                                                   */
    RIGHT_MEMBRANE = 2, /* [3][3] variation of the membrane strains                   */
    RIGHT_BENDING = 11, /* phi_11, phi_22, 2 phi_12                                   */
    RIGHT_MOMENT = 14,  /* M^ab phi_ab                                                */
    RIGHT_SURFACE = 15, /* [3] a^c N_c                                                */
};
/* Rows over the functions a, factors and areas included. */
enum {
    LEFT_MEMBRANE = 0, /* [3][3] h C times variation of the membrane strains          */
    LEFT_BENDING = 9,  /* [3] h^3/12 C phi                                            */
    LEFT_CURVED = 12,  /* [2] M^ab b_ab a^cd N_c                                      */
    LEFT_TENSION = 14, /* [2] N^cd N_c                                                */
    LEFT_SURFACE = 16, /* [3] a^c N_c                                                 */
    LEFT_MOMENT = 19,  /* [3] M^ab phi_ab n                                           */
};

/* One Gauss point taken out of four. */
struct point {
    double a[2][3], n[3], dual[2][3], gamma[2][3], inverse[3];
    double C[3][3], stress[SHELL_STRAINS], curved;
};

static void pick(const struct shell_frame *f, shell_lanes C[3][3],
                 const shell_lanes *stress, int t, struct point *p)
{
    for (int i = 0; i < 3; i++) {
        p->n[i] = f->s.n[i][t];
        p->inverse[i] = f->inverse[i][t];
        for (int d = 0; d < 2; d++) {
            p->a[d][i] = f->s.a[d][i][t];
            p->dual[d][i] = f->dual[d][i][t];
            p->gamma[d][i] = f->gamma[d][i][t];
        }
        for (int j = 0; j < 3; j++)
            p->C[i][j] = C[i][j][t];
    }
    for (int k = 0; k < SHELL_STRAINS; k++)
        p->stress[k] = stress[k][t];
    p->curved = p->stress[3] * f->curvature[0][t] + p->stress[4] * f->curvature[1][t] +
                2 * p->stress[5] * f->curvature[2][t];
}

/* Rows over the functions of one Gauss point; the derivatives N_u .. N_uv in D[5][row]. */
static void fill_right(const struct point *p, int row, const double *restrict D,
                       double *restrict R)
{
    const double *u = D, *v = D + row, *uu = D + 2 * row, *vv = D + 3 * row,
                 *uv = D + 4 * row;

    memcpy(R + RIGHT_SLOPE * row, D, 2 * (size_t)row * sizeof *R);
    for (int j = 0; j < 3; j++)
        for (int b = 0; b < row; b++) {
            R[(RIGHT_MEMBRANE + j) * row + b] = u[b] * p->a[0][j];
            R[(RIGHT_MEMBRANE + 3 + j) * row + b] = v[b] * p->a[1][j];
            R[(RIGHT_MEMBRANE + 6 + j) * row + b] = u[b] * p->a[1][j] + v[b] * p->a[0][j];
            R[(RIGHT_SURFACE + j) * row + b] = u[b] * p->dual[0][j] + v[b] * p->dual[1][j];
        }
    for (int b = 0; b < row; b++) {
        double f0 = uu[b] - p->gamma[0][0] * u[b] - p->gamma[1][0] * v[b];
        double f1 = vv[b] - p->gamma[0][1] * u[b] - p->gamma[1][1] * v[b];
        double f2 = 2 * (uv[b] - p->gamma[0][2] * u[b] - p->gamma[1][2] * v[b]);
        R[RIGHT_BENDING * row + b] = f0;
        R[(RIGHT_BENDING + 1) * row + b] = f1;
        R[(RIGHT_BENDING + 2) * row + b] = f2;
        R[RIGHT_MOMENT * row + b] =
            p->stress[3] * f0 + p->stress[4] * f1 + p->stress[5] * f2;
    }
}

static void fill_left(const struct point *p, double membrane, double bending,
                      double geometric, int row, const double *restrict R,
                      double *restrict L)
{
    const double *u = R, *v = R + row, *s = p->stress, *in = p->inverse;

    for (int k = 0; k < 3; k++) {
        double c0 = membrane * p->C[k][0], c1 = membrane * p->C[k][1],
               c2 = membrane * p->C[k][2];
        const double *B = R + RIGHT_MEMBRANE * row, *phi = R + RIGHT_BENDING * row;
        for (int t = 0; t < 3 * row; t++) /* three components at once */
            L[(LEFT_MEMBRANE + 3 * k) * row + t] =
                c0 * B[t] + c1 * B[3 * row + t] + c2 * B[6 * row + t];
        for (int b = 0; b < row; b++) {
            L[(LEFT_BENDING + k) * row + b] =
                bending * (p->C[k][0] * phi[b] + p->C[k][1] * phi[row + b] +
                           p->C[k][2] * phi[2 * row + b]);
            L[(LEFT_SURFACE + k) * row + b] = geometric * R[(RIGHT_SURFACE + k) * row + b];
            L[(LEFT_MOMENT + k) * row + b] =
                geometric * p->n[k] * R[RIGHT_MOMENT * row + b];
        }
    }
    for (int b = 0; b < row; b++) {
        double curved = geometric * p->curved;
        L[LEFT_CURVED * row + b] = curved * (in[0] * u[b] + in[2] * v[b]);
        L[(LEFT_CURVED + 1) * row + b] = curved * (in[2] * u[b] + in[1] * v[b]);
        L[LEFT_TENSION * row + b] = geometric * (s[0] * u[b] + s[2] * v[b]);
        L[(LEFT_TENSION + 1) * row + b] = geometric * (s[2] * u[b] + s[1] * v[b]);
    }
}

/* s += the 3 x 3 blocks of functions a and four b at one Gauss point. l: rows at a; R: rows
 * at the four b; both `row` apart. */
static inline void add_blocks(const double *restrict l, const double *restrict R, int row,
                              const double n[3], shell_lanes s[9])
{
#define RIGHT(k) (*(const shell_lanes *)(R + (k)*row))
#define LEFT(k)  (l[(k)*row])
    shell_lanes u = RIGHT(RIGHT_SLOPE), v = RIGHT(RIGHT_SLOPE + 1),
                moment = RIGHT(RIGHT_MOMENT);
    shell_lanes tension = LEFT(LEFT_TENSION) * u + LEFT(LEFT_TENSION + 1) * v;
    shell_lanes t = LEFT(LEFT_CURVED) * u + LEFT(LEFT_CURVED + 1) * v;

    for (int k = 0; k < 3; k++)
        t += LEFT(LEFT_BENDING + k) * RIGHT(RIGHT_BENDING + k);
    for (int j = 0; j < 3; j++) {
        shell_lanes along = n[j] * t + LEFT(LEFT_SURFACE + j) * moment;
        for (int i = 0; i < 3; i++)
            s[3 * i + j] += n[i] * along +
                            LEFT(LEFT_MOMENT + j) * RIGHT(RIGHT_SURFACE + i) +
                            LEFT(LEFT_MEMBRANE + i) * RIGHT(RIGHT_MEMBRANE + j) +
                            LEFT(LEFT_MEMBRANE + 3 + i) * RIGHT(RIGHT_MEMBRANE + 3 + j) +
                            LEFT(LEFT_MEMBRANE + 6 + i) * RIGHT(RIGHT_MEMBRANE + 6 + j);
        s[4 * j] += tension;
    }
#undef RIGHT
#undef LEFT
}

/* K[a][3 i + j][b] from the shell_lanes that hold b = a on. normal[gauss][3]. */
static void sum_blocks(struct shell_element *e, double (*normal)[3])
{
    int row = e->row;

    for (int a = 0; a < e->local; a++)
        for (int c = a / SHELL_LANES; c < row / SHELL_LANES; c++) {
            const double *l = e->left + a, *R = e->right + c * SHELL_LANES;
            double *K = e->K + (size_t)(a * 9 * row) + c * SHELL_LANES;
            shell_lanes s[9] = {{0}};
            for (int q = 0; q < e->gauss;
                 q++, l += SHELL_TANGENT_LEFT * row, R += SHELL_TANGENT_RIGHT * row)
                add_blocks(l, R, row, normal[q], s);
            for (int t = 0; t < 9; t++)
                *(shell_lanes *)(K + t * row) = s[t];
        }
}

void shell_tangent_compute(struct shell_element *e, const struct shell_material *material,
                           const double *rest, const struct large_path *path)
{
    double h = material->thickness, D[5 * SHELL_PADDED(SHELL_MAX_LOCAL)] = {0};
    double normal[SHELL_MAX_POINTS][3];
    size_t stride = (size_t)(e->local * e->padded);
    struct shell_frame f;
    shell_lanes C[3][3], stress[SHELL_STRAINS];

    for (int q = 0; q < e->gauss; q++) {
        int at = q / SHELL_LANES * SHELL_LANES;
        struct point p;
        double *R = e->right + (size_t)(q * SHELL_TANGENT_RIGHT * e->row);
        double *L = e->left + (size_t)(q * SHELL_TANGENT_LEFT * e->row);
        if (q == at) {
            shell_frame_law(rest, e->padded, at, C);
            shell_frame_resultants(e, material, C, at, stress);
            shell_frame_frame(e, e->X[1], at / SHELL_LANES, &f);
        }
        pick(&f, C, stress, q - at, &p);
        for (int k = 0; k < 5; k++)
            for (int a = 0; a < e->local; a++)
                D[k * e->row + a] =
                    e->T[(size_t)(k + 1) * stride + (size_t)(a * e->padded + q)];
        fill_right(&p, e->row, D, R);
        fill_left(&p, (path->s1 + path->lag) * h, path->s1 * h * h * h / 12, path->g1,
                  e->row, R, L);
        memcpy(normal[q], p.n, sizeof normal[q]);
    }
    sum_blocks(e, normal);
}
