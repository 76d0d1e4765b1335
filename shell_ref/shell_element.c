#include "shell_ref/shell_element.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/mechanics/large_body.h"
#include "models/room.h"

/* The surface, its base vectors and its resultants, at four points at a time. This file is
 * compiled with -ffp-contract=fast (see CMakeLists.txt): its loops are nothing but
 * multiply-adds, and fused ones are twice as fast. */

typedef double shell_lanes __attribute__((vector_size(SHELL_LANES * sizeof(double))));

/* The surface at four points. */
struct shell_surface {
    shell_lanes a[2][3], second[3][3], n[3], stretch; /* second: x_uu, x_vv, x_uv */
};

static inline shell_lanes shell_frame_dot(const shell_lanes a[3], const shell_lanes b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Computes `rows` derivatives, from N_u on, of the surface with control points X at points
 * at .. at + 3; in the padding everything is zero. */
static inline void shell_frame_derive(const struct shell_points *p, int local,
                                      const double *X, int at, int rows,
                                      shell_lanes out[][3])
{
    size_t stride = (size_t)(local * p->padded);
    const double *T = p->T + stride + at;
    shell_lanes sum[5][3] = {{{0}}};

    /* computes all sums at once: one alone would wait for its last addition */
    for (int a = 0; a < local; a++, T += p->padded)
#pragma GCC unroll 5
        for (int k = 0; k < rows; k++) {
            shell_lanes N = *(const shell_lanes *)(T + (size_t)k * stride);
            sum[k][0] += N * X[3 * a];
            sum[k][1] += N * X[3 * a + 1];
            sum[k][2] += N * X[3 * a + 2];
        }
    for (int k = 0; k < rows; k++)
        memcpy(out[k], sum[k], sizeof sum[k]);
}

/* Computes the surface; second derivatives only if the rule has them: zero elsewhere. */
static inline void shell_frame_surface(const struct shell_points *p, int local,
                                       const double *X, int at, bool second,
                                       struct shell_surface *s)
{
    shell_lanes d[5][3] = {{{0}}}, square;

    shell_frame_derive(p, local, X, at, second ? 5 : 2, d);
    memcpy(s->a, d, sizeof s->a);
    memcpy(s->second, d + 2, sizeof s->second);
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        s->n[i] = d[0][j] * d[1][k] - d[0][k] * d[1][j];
    }
    square = shell_frame_dot(s->n, s->n);
    for (int t = 0; t < SHELL_LANES; t++)
        s->stretch[t] = sqrt(square[t]);
    for (int t = 0; t < SHELL_LANES; t++) /* padding: no normal, and no division by zero */
        square[t] = at + t < p->count ? 1 / s->stretch[t] : 0;
    for (int i = 0; i < 3; i++)
        s->n[i] *= square;
}

/* Computes the metric in the order 11, 22, 12. */
static inline void shell_frame_metric(shell_lanes a[2][3], shell_lanes metric[3])
{
    metric[0] = shell_frame_dot(a[0], a[0]);
    metric[1] = shell_frame_dot(a[1], a[1]);
    metric[2] = shell_frame_dot(a[0], a[1]);
}

static inline void shell_frame_curvature(const struct shell_surface *s,
                                         shell_lanes curvature[3])
{
    for (int c = 0; c < 3; c++)
        curvature[c] = shell_frame_dot(s->second[c], s->n);
}

/* Computes law C times area at four points. */
static inline void shell_frame_law(const double *rest, int row, int at, shell_lanes C[3][3])
{
    shell_lanes area = *(const shell_lanes *)(rest + REST_AREA * row + at);
    const double *law = rest + REST_LAW * row + at;

    for (int i = 0, k = 0; i < 3; i++)
        for (int j = i; j < 3; j++, k++)
            C[i][j] = C[j][i] = area * *(const shell_lanes *)(law + k * row);
}

static inline double shell_frame_stiffness(const struct shell_material *material, int part)
{
    double h = material->law.thickness;

    return part == SHELL_BENDING ? h * h * h / 12 : h;
}

/* Computes resultants of the strain times area at four points. */
static inline void shell_frame_resultants(const struct shell_points *p, double stiffness,
                                          shell_lanes C[3][3], int at, shell_lanes out[3])
{
    for (int i = 0; i < 3; i++) {
        shell_lanes s = {0};
        for (int j = 0; j < 3; j++)
            s += C[i][j] * *(const shell_lanes *)(p->strain + j * p->padded + at);
        out[i] = stiffness * s;
    }
}

/* Adds what softening adds to resultants and law times area at four points. */
static inline void shell_frame_soften(const struct shell_points *p,
                                      const struct shell_material *material,
                                      const double *rest, int at, shell_lanes C[3][3],
                                      shell_lanes out[3])
{
    const double *area = rest + REST_AREA * p->padded + at, *strain = p->strain + at;
    const double stiffness = shell_frame_stiffness(material, SHELL_BENDING);

    for (int n = 0; n < 2 * SHELL_LANES && material->law.softens; n++) {
        const double *along = material->along[n % 2];
        const int t = n / 2;
        double bend = 0, tangent;
        for (int i = 0; i < 3; i++)
            bend += along[i] * strain[i * p->padded + t];
        const double moment = law_soft_moment(&material->law.soft[n % 2], bend, &tangent);
        for (int i = 0; i < 3; i++) {
            out[i][t] += area[t] * moment * along[i];
            for (int j = 0; j < 3; j++)
                C[i][j][t] += area[t] / stiffness * tangent * along[i] * along[j];
        }
    }
}

/* Surface, dual base and Christoffel symbols at four points; of the geometry. */
struct shell_frame {
    struct shell_surface s;
    shell_lanes inverse[3];  /* a^11, a^22, a^12  */
    shell_lanes dual[2][3];  /* a^1, a^2  */
    shell_lanes gamma[2][3]; /* Gamma^c_ab in the order 11, 22, 12 */
    shell_lanes curvature[3];
};

static inline void shell_frame_frame(const struct shell_element *e,
                                     const struct shell_points *p, int at,
                                     struct shell_frame *f)
{
    shell_lanes metric[3], over;

    if (e->same)
        f->s = p->surface[at / SHELL_LANES];
    else
        shell_frame_surface(p, e->local, e->X[1], at, true, &f->s);
    shell_frame_metric(f->s.a, metric);
    shell_frame_curvature(&f->s, f->curvature);
    for (int t = 0; t < SHELL_LANES; t++)
        over[t] = at + t < p->count ? 1 / (f->s.stretch[t] * f->s.stretch[t]) : 0;
    f->inverse[0] = metric[1] * over;
    f->inverse[1] = metric[0] * over;
    f->inverse[2] = -metric[2] * over;
    for (int i = 0; i < 3; i++) {
        f->dual[0][i] = f->inverse[0] * f->s.a[0][i] + f->inverse[2] * f->s.a[1][i];
        f->dual[1][i] = f->inverse[2] * f->s.a[0][i] + f->inverse[1] * f->s.a[1][i];
    }
    for (int d = 0; d < 2; d++)
        for (int k = 0; k < 3; k++)
            f->gamma[d][k] = shell_frame_dot(f->s.second[k], f->dual[d]);
}

static int rows_of(const struct shell_points *p)
{
    return p->rows[0] + p->rows[1];
}

/* Returns the first point of a row. */
static int row_of(const struct shell_points *p, int row)
{
    const int second = row > p->rows[0] ? row - p->rows[0] : 0;

    return p->plain + (row - second) * p->each[0] + second * p->each[1];
}

/* --- the tangent --- */

/* Functions go four at a time. The numbers of a point are ordered [group of four][number],
 * so that all of them are at fixed distances: with strides that are not known to the
 * compiler, the kernel spends twice its time on addresses. */

/* Numbers of each point of the membrane for a function b; for a, with factors and areas. */
enum { FLAT_RIGHT = 2 /* N_u, N_v */, FLAT_LEFT = 18 /* [2][3][3] P_d = N_c Q_cd */ };

/* Numbers of each row of the membrane, the variation of its strain; of each of its points,
 * the slope along it. They take the room of the points' numbers above. */
enum { ROW = 3, PULL = 1 };

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

/* Return the kernel's rows over an element's functions at all points, left and right. */
static size_t shell_tangent_left(const struct shell_space *space)
{
    return (size_t)(FLAT_LEFT * space->rule[SHELL_MEMBRANE].padded +
                    (BENT + LEFT) * space->rule[SHELL_BENDING].padded);
}

static size_t shell_tangent_right(const struct shell_space *space)
{
    return (size_t)(FLAT_RIGHT * space->rule[SHELL_MEMBRANE].padded +
                    (BENT + RIGHT) * space->rule[SHELL_BENDING].padded);
}

/* The arrays by their content, [points][groups][number] each. */
struct kernel {
    int row, groups;
    bool moments; /* whether the tangent has their part                                */
    shell_lanes *flat[2], *rows[2], *pull[2]; /* of a, of b                          */
    shell_lanes *bent[2], *moment[2];         /* likewise                            */
    double (*normal)[3];                      /* [points of bending]                 */
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
    for (int side = 0; side < 2; side++) {
        const int plain = e->at[SHELL_MEMBRANE].plain * k.groups;
        k.rows[side] = k.flat[side] + (side ? FLAT_RIGHT : FLAT_LEFT) * plain;
        k.pull[side] = k.rows[side] + ROW * rows_of(&e->at[SHELL_MEMBRANE]) * k.groups;
        k.moment[side] = k.bent[side] + BENT * bent;
    }
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

    for (int q = 0; q < p->plain; q++) {
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

/* Fills the rows' variations and their points' slopes. */
static void fill_rows(const struct kernel *k, struct shell_element *e,
                      const struct shell_material *material, const double *rest,
                      const struct large_path *path)
{
    const struct shell_points *p = &e->at[SHELL_MEMBRANE];
    const double h = shell_frame_stiffness(material, SHELL_MEMBRANE);
    shell_lanes D[FLAT_RIGHT * SHELL_PADDED(SHELL_MAX_LOCAL) / SHELL_LANES] = {{0}};
    shell_lanes a[2][3], *pull = k->pull[0], *slope = k->pull[1];

    for (int q = p->plain, row = 0, n = 0; q < p->count; q++) {
        const int d = row >= p->rows[0], t = q % SHELL_LANES;
        const double factor = p->factor[d][n],
                     law = h * rest[(REST_LAW + (d ? LAW_22 : LAW_11)) * p->padded + q],
                     stress = law * factor * p->strain[d * p->padded + q];
        shell_lanes *left = k->rows[0] + ROW * row * k->groups,
                    *right = k->rows[1] + ROW * row * k->groups;
        if (t == 0 || q == p->plain)
            shell_frame_derive(p, e->local, e->X[1], q - t, 2, a);
        turn(e, p, q, 2, FLAT_RIGHT, D);
        for (int g = 0; g < k->groups; g++, left += ROW, right += ROW) {
            const shell_lanes N = D[FLAT_RIGHT * g + d];
            *slope++ = N, *pull++ = path->g1 * stress * N;
            for (int i = 0; i < 3; i++) {
                right[i] = (n ? right[i] : (shell_lanes){0}) + factor * a[d][i][t] * N;
                left[i] = (path->s1 + path->lag) * law * right[i];
            }
        }
        if (++n == p->each[d])
            n = 0, row++;
    }
}

/* Adds the 3 x 3 blocks of one function a and four b of one row to s. */
static inline void add_row(const double *restrict l, const shell_lanes *restrict r,
                           shell_lanes s[9])
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            s[3 * i + j] += l[i * SHELL_LANES] * r[j];
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
    const struct shell_points *flat = &e->at[SHELL_MEMBRANE];
    shell_lanes s[9] = {{0}}, bent[6] = {{0}}, pull = {0};
#define LEFT_OF(array, what)  ((const double *)((array)[0] + own * (what)) + lane)
#define RIGHT_OF(array, what) ((const double *)((array)[1] + g * (what)))
    const double *l = LEFT_OF(k->flat, FLAT_LEFT), *r = RIGHT_OF(k->flat, FLAT_RIGHT);

    for (int q = 0; q < flat->plain; q++)
        add_membrane(l + q * FLAT_LEFT * row,
                     (const shell_lanes *)(r + q * FLAT_RIGHT * row), s);
    l = LEFT_OF(k->rows, ROW), r = RIGHT_OF(k->rows, ROW);
    for (int q = 0; q < rows_of(flat); q++)
        add_row(l + q * ROW * row, (const shell_lanes *)(r + q * ROW * row), s);
    l = LEFT_OF(k->pull, PULL), r = RIGHT_OF(k->pull, PULL);
    for (int q = 0; q < flat->count - flat->plain; q++)
        pull += l[q * row] * *(const shell_lanes *)(r + q * row);
    for (int i = 0; i < 9; i += 4)
        s[i] += pull;
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

void shell_element_tangent(struct shell_element *e, const struct shell_material *material,
                           const double *const rest[], const struct large_path *path)
{
    double normal[SHELL_MAX_POINTS][3];
    const struct kernel k = kernel_of(e, path, normal);

    fill_membrane(&k, e, material, rest[SHELL_MEMBRANE], path);
    fill_rows(&k, e, material, rest[SHELL_MEMBRANE], path);
    fill_bending(&k, e, material, rest[SHELL_BENDING], path);
    sum_all(&k, e);
}

void shell_element_clear(struct shell_element *e)
{
    free(e->memory);
    memset(e, 0, sizeof *e);
}

enum status shell_element_init(struct shell_element *e, const struct shell_space *space)
{
    enum status st;
    size_t local = (size_t)space->local, row = SHELL_PADDED(local);

    memset(e, 0, sizeof *e);
    for (int r = 0; r < SHELL_RULES; r++)
        e->at[r].padded = space->rule[r].padded;
    TRY(room_cut(
        &e->memory, ROOM(e->at[0].room, shell_space_size(space, 0)),
        ROOM(e->at[1].room, shell_space_size(space, 1)),
        ROOM(e->at[2].room, shell_space_size(space, 2)),
        ROOM(e->strain, shell_room_strains(space, SHELL_PARTS)),
        ROOM(e->at[0].surface, (size_t)e->at[0].padded / SHELL_LANES),
        ROOM(e->at[1].surface, (size_t)e->at[1].padded / SHELL_LANES),
        ROOM(e->X[0], SHELL_PADDED(3 * local)), ROOM(e->X[1], SHELL_PADDED(3 * local)),
        ROOM(e->X[2], SHELL_PADDED(3 * local)), ROOM(e->f, SHELL_PADDED(3 * local)),
        ROOM(e->left, shell_tangent_left(space) * row),
        ROOM(e->right, shell_tangent_right(space) * row), ROOM(e->K, local * 9 * row)));
    e->local = space->local;
    e->row = (int)row;
    e->at[SHELL_MEMBRANE].strain = e->strain;
    e->at[SHELL_BENDING].strain = e->strain + shell_room_strains(space, SHELL_MEMBRANE);
out:
    return st;
}

void shell_element_load(struct shell_element *e, const struct shell_space *space,
                        int element, int rules)
{
    for (int r = space->alike; r < rules; r++)
        e->at[r].count =
            shell_space_functions(space, r, element, e->at[r].room, &e->at[r].T);
    if (space->alike)
        e->at[SHELL_MEMBRANE].T = e->at[SHELL_BENDING].T,
        e->at[SHELL_MEMBRANE].count = e->at[SHELL_BENDING].count;
    for (int r = 0; r < rules; r++) {
        struct shell_points *p = &e->at[r];
        const struct shell_direction *d = space->direction;
        const bool rows = space->rule[r].grids > 1;
        const int span[2] = {element / d[1].spans, element % d[1].spans};
        for (int i = 0; i < 2; i++) {
            p->rows[i] = rows ? d[i].line[SHELL_DERIVED].points[span[i]] : 0;
            p->each[i] = d[1 - i].order, p->factor[i] = d[1 - i].unseen;
        }
        p->plain = rows ? p->rows[0] * p->rows[1] : p->count;
    }
}

/* Gives the points of a row its stiffness, area times law of all, and their factors for
 * areas. */
static void tie_rest(const struct shell_points *p, double *rest)
{
    for (int n = 0; n < rows_of(p); n++) {
        const int d = n >= p->rows[0], first = row_of(p, n);
        double *area = rest + REST_AREA * p->padded + first,
               *law = rest + REST_LAW * p->padded + first, stiffness = 0;
        for (int k = 0; k < p->each[d]; k++)
            stiffness += area[k] * law[(d ? LAW_22 : LAW_11) * p->padded + k];
        for (int k = 0; k < p->each[d]; k++) {
            area[k] = p->factor[d][k];
            for (int i = 0; i < LAW_ENTRIES; i++)
                law[i * p->padded + k] = i == (d ? LAW_22 : LAW_11) ? stiffness : 0;
        }
    }
}

/* Gives all points of a row the sum of their strains by factors. */
static void tie_strain(const struct shell_points *p)
{
    for (int n = 0; n < rows_of(p); n++) {
        const int d = n >= p->rows[0];
        double *strain = p->strain + d * p->padded + row_of(p, n), sum = 0;
        for (int k = 0; k < p->each[d]; k++)
            sum += p->factor[d][k] * strain[k];
        for (int k = 0; k < p->each[d]; k++)
            strain[k] = sum;
    }
}

enum status shell_element_rest(struct shell_element *e, int rule,
                               const struct shell_material *material,
                               const struct shell_place *place, double *rest)
{
    const struct shell_points *p = &e->at[rule];
    int row = p->padded;

    memset(rest, 0, SHELL_REST_ROWS * (size_t)row * sizeof *rest);
    for (int q = 0; q < p->count; q++) {
        struct shell_surface s;
        shell_lanes metric[3], curvature[3];
        const shell_lanes *form = rule == SHELL_BENDING ? curvature : metric;
        int t = q % SHELL_LANES;
        double *r = rest + q, law[LAW_ENTRIES];
        shell_frame_surface(p, e->local, e->X[0], q - t, rule == SHELL_BENDING, &s);
        shell_frame_metric(s.a, metric);
        shell_frame_curvature(&s, curvature);
        if (!(s.stretch[t] > 0 && isfinite(s.stretch[t])))
            return STATUS_INPUT;
        double det = s.stretch[t] * s.stretch[t];
        r[REST_AREA * row] = place[q].weight * s.stretch[t];
        const double here[3] = {metric[0][t], metric[1][t], metric[2][t]};
        law_on_surface(&material->law, rule == SHELL_BENDING ? LAW_BENDING : LAW_MEMBRANE,
                       here, det, law);
        for (int k = 0; k < 3; k++)
            r[(REST_FORM + k) * row] = form[k][t];
        for (int k = 0; k < 6; k++)
            r[(REST_LAW + k) * row] = law[k];
    }
    tie_rest(p, rest);
    return STATUS_OK;
}

static const shell_lanes *form_of(const double *rest, int k, int row, int at)
{
    return (const shell_lanes *)(rest + (REST_FORM + k) * row + at);
}

static void membrane_strain(const struct shell_points *p, int local, const double *X,
                            const double *rest)
{
    for (int at = 0; at < p->count; at += SHELL_LANES) {
        struct shell_surface *s = &p->surface[at / SHELL_LANES];
        shell_lanes metric[3];
        shell_frame_derive(p, local, X, at, 2, s->a);
        shell_frame_metric(s->a, metric);
        for (int k = 0; k < 3; k++)
            *(shell_lanes *)(p->strain + k * p->padded + at) =
                (k < 2 ? 0.5 : 1.0) * (metric[k] - *form_of(rest, k, p->padded, at));
    }
}

static bool bending_strain(const struct shell_points *p, int local, const double *X,
                           const double *rest)
{
    bool sound = true;

    for (int at = 0; at < p->count; at += SHELL_LANES) {
        struct shell_surface *s = &p->surface[at / SHELL_LANES];
        shell_lanes curvature[3];
        shell_frame_surface(p, local, X, at, true, s);
        shell_frame_curvature(s, curvature);
        for (int t = 0; t < SHELL_LANES && at + t < p->count; t++)
            sound = sound && s->stretch[t] > 0 && isfinite(s->stretch[t]);
        for (int k = 0; k < 3; k++)
            *(shell_lanes *)(p->strain + k * p->padded + at) =
                (k < 2 ? 1.0 : 2.0) * (*form_of(rest, k, p->padded, at) - curvature[k]);
    }
    return sound;
}

static void foresee(struct shell_element *e)
{
    const struct shell_points *p = &e->at[SHELL_MEMBRANE];
    int row = p->padded;

    for (int at = 0; at < p->count; at += SHELL_LANES) {
        shell_lanes d[2][3], w[2][3];
        shell_frame_derive(p, e->local, e->X[2], at, 2, d);
        shell_frame_derive(p, e->local, e->X[1], at, 2, w);
        shell_lanes *strain = (shell_lanes *)(p->strain + at);
        strain[0] -= 0.5 * shell_frame_dot(d[0], w[0]);
        strain[row / SHELL_LANES] -= 0.5 * shell_frame_dot(d[1], w[1]);
        strain[2 * row / SHELL_LANES] -=
            0.5 * (shell_frame_dot(d[0], w[1]) + shell_frame_dot(d[1], w[0]));
    }
}

bool shell_element_strain(struct shell_element *e, const double *const rest[],
                          bool foreseen)
{
    const struct shell_points *p = &e->at[SHELL_MEMBRANE];

    membrane_strain(p, e->local, e->X[0], rest[SHELL_MEMBRANE]);
    if (foreseen)
        foresee(e);
    tie_strain(p);
    return bending_strain(&e->at[SHELL_BENDING], e->local, e->X[0], rest[SHELL_BENDING]);
}

/* Returns the energy of the rows: the factors of each have no sum, so that the points alone
 * have none. */
static double row_energy(const struct shell_points *p, double h, const double *rest)
{
    double sum = 0;

    for (int n = 0; n < rows_of(p); n++) {
        const int d = n >= p->rows[0], first = row_of(p, n);
        const double strain = p->strain[d * p->padded + first];
        sum += 0.5 * h * rest[(REST_LAW + (d ? LAW_22 : LAW_11)) * p->padded + first] *
               strain * strain;
    }
    return sum;
}

/* Returns what softening adds to the energy. */
static double soft_energy(const struct shell_points *p,
                          const struct shell_material *material, const double *rest)
{
    double sum = 0;

    for (int q = 0; q < p->count; q++)
        for (int n = 0; n < 2; n++) {
            double bend = 0;
            for (int i = 0; i < 3; i++)
                bend += material->along[n][i] * p->strain[i * p->padded + q];
            sum += rest[REST_AREA * p->padded + q] *
                   law_soft_energy(&material->law.soft[n], bend);
        }
    return sum;
}

double shell_element_energy(const struct shell_element *e,
                            const struct shell_material *material,
                            const double *const rest[])
{
    shell_lanes sum = {0};

    for (int part = 0; part < SHELL_PARTS; part++) {
        const struct shell_points *p = &e->at[part];
        for (int at = 0; at < p->count; at += SHELL_LANES) {
            shell_lanes C[3][3], stress[3];
            shell_frame_law(rest[part], p->padded, at, C);
            shell_frame_resultants(p, shell_frame_stiffness(material, part), C, at, stress);
            for (int k = 0; k < 3; k++)
                sum += 0.5 * stress[k] *
                       *(const shell_lanes *)(p->strain + k * p->padded + at);
        }
    }
    const double linear =
        (sum[0] + sum[2]) + (sum[1] + sum[3]) +
        row_energy(&e->at[SHELL_MEMBRANE], shell_frame_stiffness(material, SHELL_MEMBRANE),
                   rest[SHELL_MEMBRANE]);
    return material->law.softens
               ? linear + soft_energy(&e->at[SHELL_BENDING], material, rest[SHELL_BENDING])
               : linear;
}

/* Adds the sum of s[t]'s lanes, (0 + 2) + (1 + 3), to f[t], for four t at a time. */
static void add_lanes(int count, const shell_lanes *s, double *f)
{
    for (int t = 0; t < count; t += SHELL_LANES, s += SHELL_LANES, f += SHELL_LANES) {
        shell_lanes even = __builtin_shufflevector(s[0], s[1], 0, 4, 2, 6),
                    odd = __builtin_shufflevector(s[0], s[1], 1, 5, 3, 7),
                    even_2 = __builtin_shufflevector(s[2], s[3], 0, 4, 2, 6),
                    odd_2 = __builtin_shufflevector(s[2], s[3], 1, 5, 3, 7);
        *(shell_lanes *)f += (__builtin_shufflevector(even, even_2, 0, 1, 4, 5) +
                              __builtin_shufflevector(even, even_2, 2, 3, 6, 7)) +
                             (__builtin_shufflevector(odd, odd_2, 0, 1, 4, 5) +
                              __builtin_shufflevector(odd, odd_2, 2, 3, 6, 7));
    }
}

/* Adds densities d[rows] times N_u, N_v, N_uu, N_vv, N_uv at four points to e->f. */
static void add_densities(struct shell_element *e, const struct shell_points *p, int at,
                          int rows, shell_lanes d[][3])
{
    size_t stride = (size_t)(e->local * p->padded);
    shell_lanes sum[SHELL_PADDED(3 * SHELL_MAX_LOCAL)];

    for (int a = 0; a < e->local; a++) {
        const double *T = p->T + stride + a * p->padded + at;
        shell_lanes s[3] = {{0}};
        for (int k = 0; k < rows; k++)
            for (int i = 0; i < 3; i++)
                s[i] += *(const shell_lanes *)(T + (size_t)k * stride) * d[k][i];
        memcpy(sum + 3 * a, s, sizeof s);
    }
    int count = 3 * e->local;
    memset(sum + count, 0, (size_t)(SHELL_PADDED(count) - count) * sizeof *sum);
    add_lanes(count, sum, e->f);
}

static void membrane_force(struct shell_element *e, double stiffness, const double *rest)
{
    const struct shell_points *p = &e->at[SHELL_MEMBRANE];

    for (int at = 0; at < p->count; at += SHELL_LANES) {
        const struct shell_surface *s = &p->surface[at / SHELL_LANES];
        shell_lanes C[3][3], N[3], a[2][3], d[2][3];
        shell_frame_law(rest, p->padded, at, C);
        shell_frame_resultants(p, stiffness, C, at, N);
        if (e->same)
            memcpy(a, s->a, sizeof a);
        else
            shell_frame_derive(p, e->local, e->X[1], at, 2, a);
        for (int k = 0; k < 2; k++)
            for (int i = 0; i < 3; i++)
                d[k][i] = N[k] * a[k][i] + N[2] * a[1 - k][i];
        add_densities(e, p, at, 2, d);
    }
}

static void bending_force(struct shell_element *e, const struct shell_material *material,
                          const double *rest)
{
    const double stiffness = shell_frame_stiffness(material, SHELL_BENDING);
    const struct shell_points *p = &e->at[SHELL_BENDING];

    for (int at = 0; at < p->count; at += SHELL_LANES) {
        struct shell_frame f;
        shell_lanes C[3][3], m[3], d[5][3];
        shell_frame_law(rest, p->padded, at, C);
        shell_frame_resultants(p, stiffness, C, at, m);
        shell_frame_soften(p, material, rest, at, C, m);
        shell_frame_frame(e, p, at, &f);
        m[2] *= 2;
        for (int i = 0; i < 3; i++) {
            for (int k = 0; k < 2; k++)
                d[k][i] = f.s.n[i] * shell_frame_dot(m, f.gamma[k]);
            for (int k = 0; k < 3; k++)
                d[2 + k][i] = -m[k] * f.s.n[i];
        }
        add_densities(e, p, at, 5, d);
    }
}

void shell_element_force(struct shell_element *e, const struct shell_material *material,
                         const double *const rest[])
{
    memset(e->f, 0, (size_t)SHELL_PADDED(3 * e->local) * sizeof *e->f);
    membrane_force(e, shell_frame_stiffness(material, SHELL_MEMBRANE),
                   rest[SHELL_MEMBRANE]);
    bending_force(e, material, rest[SHELL_BENDING]);
}
