#include "shell_ref/shell_tangent.h"

#include "shell_ref/shell_frame.h"

/* Functions go four at a time. The numbers of a point are ordered [group of four][number],
 * so that all of them are at fixed distances: with strides that are not known to the
 * compiler, the kernel spends twice its time on addresses. */

/* Numbers of each point of the membrane for a function b; for a, with factors and areas. */
enum { FLAT_RIGHT = 2 /* N_u, N_v */, FLAT_LEFT = 18 /* [2][3][3] P_d = N_c Q_cd */ };

/* Numbers for bending: of b, phi_11, phi_22, 2 phi_12; of a, h^3/12 C phi. */
enum { BENT = 3 };

/* Numbers for bending moments: of b, and of a, with factors and areas. */
enum {
    RIGHT_SLOPE = 0,   /* N_u, N_v                                                    */
    RIGHT_MOMENT = 2,  /* M^ab phi_ab                                                 */
    RIGHT_SURFACE = 3, /* [3] a^c N_c                                                 */
    RIGHT = 6
};
enum {
    LEFT_CURVED = 0,  /* [2] M^ab b_ab a^cd N_c                                       */
    LEFT_SURFACE = 2, /* [3] a^c N_c                                                  */
    LEFT_MOMENT = 5,  /* [3] M^ab phi_ab n                                            */
    LEFT = 8
};

size_t shell_tangent_left(const struct shell_space *space)
{
    return (size_t)(FLAT_LEFT * space->rule[SHELL_MEMBRANE].padded +
                    (BENT + LEFT) * space->rule[SHELL_BENDING].padded);
}

size_t shell_tangent_right(const struct shell_space *space)
{
    return (size_t)(FLAT_RIGHT * space->rule[SHELL_MEMBRANE].padded +
                    (BENT + RIGHT) * space->rule[SHELL_BENDING].padded);
}

/* The arrays by their content, [points][groups][number] each. */
struct kernel {
    int row, groups;
    bool moments; /* whether the tangent has their part                                */
    shell_lanes *flat[2], *bent[2], *moment[2]; /* of a, of b                          */
    double (*normal)[3];                        /* [points of bending]                 */
};

static struct kernel kernel_of(struct shell_element *e, const struct large_path *path,
                               double (*normal)[3])
{
    const int flat = e->at[SHELL_MEMBRANE].count * e->row / SHELL_LANES,
              bent = e->at[SHELL_BENDING].count * e->row / SHELL_LANES;
    struct kernel k = {.row = e->row,
                       .groups = e->row / SHELL_LANES,
                       .moments = path->g1 == 1,
                       .flat = {(shell_lanes *)e->left, (shell_lanes *)e->right},
                       .normal = normal};

    k.bent[0] = k.flat[0] + FLAT_LEFT * flat, k.bent[1] = k.flat[1] + FLAT_RIGHT * flat;
    for (int side = 0; side < 2; side++)
        k.moment[side] = k.bent[side] + BENT * bent;
    return k;
}

/* Reorders N_u, N_v, ... of one point: D[groups][SLOT]. */
static void turn(const struct shell_element *e, const struct shell_points *p, int q,
                 int rows, int slot, shell_lanes *D)
{
    size_t stride = (size_t)(e->local * p->padded);

    for (int a = 0; a < e->local; a++) {
        const double *T = p->T + stride + (size_t)(a * p->padded + q);
        double *to = (double *)(D + a / SHELL_LANES * slot) + a % SHELL_LANES;
        for (int k = 0; k < rows; k++)
            to[k * SHELL_LANES] = T[(size_t)k * stride];
    }
}

/* --- membrane ----------------------------------------------------------------------------
 *
 * The block of functions a and b is N_c,a N_d,b Q_cd,
 *   Q_cd = material C^{c e d f} a_e a_f^T + geometric N^{cd} I. */

/* Computes Q[2][2][3][3] at four points; the law times the area in C, resultants in N. */
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

static void fill_membrane(const struct kernel *k, struct shell_element *e,
                          const struct shell_material *material, const double *rest,
                          const struct large_path *path)
{
    const struct shell_points *p = &e->at[SHELL_MEMBRANE];
    double h = shell_frame_stiffness(material, SHELL_MEMBRANE);
    shell_lanes C[3][3], N[3], a[2][3], Q[4][9], *L = k->flat[0], *R = k->flat[1];

    for (int q = 0; q < p->count; q++) {
        int t = q % SHELL_LANES;
        if (t == 0) {
            shell_frame_law(rest, p->padded, q, C);
            shell_frame_resultants(p, h, C, q, N);
            shell_frame_derive(p, e->local, e->X[1], q, 2, a);
            membrane_blocks(a, C, N, (path->s1 + path->lag) * h, path->g1, Q);
        }
        turn(e, p, q, 2, FLAT_RIGHT, R);
        for (int g = 0; g < k->groups; g++, R += FLAT_RIGHT, L += FLAT_LEFT)
            for (int d = 0; d < 2; d++)
                for (int i = 0; i < 9; i++)
                    L[9 * d + i] = Q[d][i][t] * R[0] + Q[2 + d][i][t] * R[1];
    }
}

/* Adds the 3 x 3 blocks of one function a and four b at one point to s. */
static inline void add_membrane(const double *restrict l, const shell_lanes *restrict r,
                                shell_lanes s[9])
{
    for (int i = 0; i < 9; i++)
        s[i] += l[i * SHELL_LANES] * r[0] + l[(9 + i) * SHELL_LANES] * r[1];
}

/* --- bending ----------------------------------------------------------------------------
 */

/* The numbers of one of four points. */
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

/* Fills bending of four functions; their derivatives N_u .. N_uv in D. */
static void fill_bent(const struct point *p, double bending, const shell_lanes D[5],
                      shell_lanes *L, shell_lanes *R)
{
    for (int i = 0; i < BENT; i++)
        R[i] = (i < 2 ? 1.0 : 2.0) *
               (D[2 + i] - p->gamma[0][i] * D[0] - p->gamma[1][i] * D[1]);
    for (int i = 0; i < BENT; i++)
        L[i] = bending * (p->C[i][0] * R[0] + p->C[i][1] * R[1] + p->C[i][2] * R[2]);
}

/* Fills moments of the same functions, with phi of fill_bent. */
static void fill_moment(const struct point *p, double geometric, const shell_lanes D[5],
                        const shell_lanes *phi, shell_lanes *L, shell_lanes *R)
{
    const shell_lanes u = D[0], v = D[1];
    const double *in = p->inverse, curved = geometric * p->curved;

    R[RIGHT_SLOPE] = u, R[RIGHT_SLOPE + 1] = v;
    R[RIGHT_MOMENT] = p->m[0] * phi[0] + p->m[1] * phi[1] + p->m[2] * phi[2];
    L[LEFT_CURVED] = curved * (in[0] * u + in[2] * v);
    L[LEFT_CURVED + 1] = curved * (in[2] * u + in[1] * v);
    for (int i = 0; i < 3; i++) {
        R[RIGHT_SURFACE + i] = u * p->dual[0][i] + v * p->dual[1][i];
        L[LEFT_SURFACE + i] = geometric * R[RIGHT_SURFACE + i];
        L[LEFT_MOMENT + i] = geometric * p->n[i] * R[RIGHT_MOMENT];
    }
}

static void fill_bending(const struct kernel *k, struct shell_element *e,
                         const struct shell_material *material, const double *rest,
                         const struct large_path *path)
{
    const struct shell_points *p = &e->at[SHELL_BENDING];
    shell_lanes D[5 * SHELL_PADDED(SHELL_MAX_LOCAL) / SHELL_LANES] = {{0}};
    double stiffness = shell_frame_stiffness(material, SHELL_BENDING);
    struct shell_frame f;
    shell_lanes C[3][3], m[3];

    for (int q = 0, n = 0; q < p->count; q++) {
        int t = q % SHELL_LANES;
        struct point at;
        if (t == 0) {
            shell_frame_law(rest, p->padded, q, C);
            shell_frame_resultants(p, stiffness, C, q, m);
            shell_frame_soften(p, material, rest, q, C, m);
            shell_frame_frame(e, p, q, &f);
        }
        pick(&f, C, m, t, &at);
        turn(e, p, q, 5, 5, D);
        memcpy(k->normal[q], at.n, sizeof at.n);
        for (int g = 0; g < k->groups; g++, n++) {
            shell_lanes *phi = k->bent[1] + BENT * n;
            fill_bent(&at, path->s1 * stiffness, D + 5 * g, k->bent[0] + BENT * n, phi);
            if (k->moments)
                fill_moment(&at, path->g1, D + 5 * g, phi, k->moment[0] + LEFT * n,
                            k->moment[1] + RIGHT * n);
        }
    }
}

/* Adds the six entries with n n^T, its lower triangle by rows. */
static inline void add_bent(const double *restrict l, const shell_lanes *restrict r,
                            const double n[3], shell_lanes s[6])
{
    shell_lanes t = l[0] * r[0] + l[SHELL_LANES] * r[1] + l[2 * SHELL_LANES] * r[2];

    for (int i = 0, k = 0; i < 3; i++) {
        shell_lanes along = n[i] * t;
        for (int j = 0; j <= i; j++, k++)
            s[k] += n[j] * along;
    }
}

static inline void add_moment(const double *restrict l, const shell_lanes *restrict r,
                              const double n[3], shell_lanes s[9])
{
    shell_lanes t = l[LEFT_CURVED * SHELL_LANES] * r[RIGHT_SLOPE] +
                    l[(LEFT_CURVED + 1) * SHELL_LANES] * r[RIGHT_SLOPE + 1];

    for (int j = 0; j < 3; j++) {
        shell_lanes along =
            n[j] * t + l[(LEFT_SURFACE + j) * SHELL_LANES] * r[RIGHT_MOMENT];
        for (int i = 0; i < 3; i++)
            s[3 * i + j] +=
                n[i] * along + l[(LEFT_MOMENT + j) * SHELL_LANES] * r[RIGHT_SURFACE + i];
    }
}

/* Sums the blocks of function a and the g-th four b: K[3 i + j][b] of a. */
static void sum_blocks(const struct kernel *k, const struct shell_element *e, int a, int g,
                       double *K)
{
    const int own = a / SHELL_LANES, lane = a % SHELL_LANES, row = k->row;
    shell_lanes s[9] = {{0}}, bent[6] = {{0}};
#define LEFT_OF(array, what)  ((const double *)((array)[0] + own * (what)) + lane)
#define RIGHT_OF(array, what) ((const double *)((array)[1] + g * (what)))
    const double *l = LEFT_OF(k->flat, FLAT_LEFT), *r = RIGHT_OF(k->flat, FLAT_RIGHT);

    for (int q = 0; q < e->at[SHELL_MEMBRANE].count; q++)
        add_membrane(l + q * FLAT_LEFT * row,
                     (const shell_lanes *)(r + q * FLAT_RIGHT * row), s);
    l = LEFT_OF(k->bent, BENT), r = RIGHT_OF(k->bent, BENT);
    for (int q = 0; q < e->at[SHELL_BENDING].count; q++)
        add_bent(l + q * BENT * row, (const shell_lanes *)(r + q * BENT * row),
                 k->normal[q], bent);
    l = LEFT_OF(k->moment, LEFT), r = RIGHT_OF(k->moment, RIGHT);
    for (int q = 0; k->moments && q < e->at[SHELL_BENDING].count; q++)
        add_moment(l + q * LEFT * row, (const shell_lanes *)(r + q * RIGHT * row),
                   k->normal[q], s);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            *(shell_lanes *)(K + (3 * i + j) * row) =
                s[3 * i + j] + bent[i > j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i];
#undef LEFT_OF
#undef RIGHT_OF
}

/* Sums blocks b >= a. The functions behind the last whole group stand for a, not for a
 * group of b of which most is padding: of 9, 15 groups for 21. */
static void sum_all(const struct kernel *k, struct shell_element *e)
{
    const int row = k->row, whole = e->local / SHELL_LANES;

    for (int a = 0; a < e->local; a++) {
        const bool rest = a >= whole * SHELL_LANES;
        for (int g = rest ? 0 : a / SHELL_LANES; g < (rest ? k->groups : whole); g++)
            sum_blocks(k, e, a, g, e->K + a * 9 * row + g * SHELL_LANES);
        for (int b = 0; rest && b < whole * SHELL_LANES; b++)
            for (int i = 0; i < 9; i++)
                e->K[(b * 9 + i) * row + a] = e->K[(a * 9 + i % 3 * 3 + i / 3) * row + b];
    }
}

void shell_tangent_compute(struct shell_element *e, const struct shell_material *material,
                           const double *const rest[], const struct large_path *path)
{
    double normal[SHELL_MAX_POINTS][3];
    const struct kernel k = kernel_of(e, path, normal);

    fill_membrane(&k, e, material, rest[SHELL_MEMBRANE], path);
    fill_bending(&k, e, material, rest[SHELL_BENDING], path);
    sum_all(&k, e);
}
