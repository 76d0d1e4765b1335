#include "shell_ref/shell_element.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* This file is compiled with -ffp-contract=fast (see CMakeLists.txt): its loops are nothing
 * but multiply-adds, and fused ones are twice as fast. */

typedef double lanes __attribute__((vector_size(SHELL_LANES * sizeof(double))));

/* Rows over the functions b, one set per Gauss point. */
enum {
    RIGHT_SLOPE = 0,    /* N_u, N_v                                                   */
    RIGHT_MEMBRANE = 2, /* [3][3] variation of the membrane strains                   */
    RIGHT_BENDING = 11, /* phi_11, phi_22, 2 phi_12                                   */
    RIGHT_MOMENT = 14,  /* M^ab phi_ab                                                */
    RIGHT_SURFACE = 15, /* [3] a^c N_c                                                */
    RIGHT_ROWS = 18
};
/* Rows over the functions a, factors and areas included. */
enum {
    LEFT_MEMBRANE = 0, /* [3][3] h C times variation of the membrane strains          */
    LEFT_BENDING = 9,  /* [3] h^3/12 C phi                                            */
    LEFT_CURVED = 12,  /* [2] M^ab b_ab a^cd N_c                                      */
    LEFT_TENSION = 14, /* [2] N^cd N_c                                                */
    LEFT_SURFACE = 16, /* [3] a^c N_c                                                 */
    LEFT_MOMENT = 19,  /* [3] M^ab phi_ab n                                           */
    LEFT_ROWS = 22
};

/* The surface at four Gauss points. */
struct surface {
    lanes a[2][3], second[3][3], n[3], stretch; /* second: x_uu, x_vv, x_uv            */
};

static lanes dot(const lanes a[3], const lanes b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

enum status shell_element_init(struct shell_element *e, const struct shell_space *space)
{
    size_t local = (size_t)space->local, row = SHELL_PADDED(local);
    size_t points = (size_t)space->padded, gauss = (size_t)space->gauss;
    const struct {
        double **part;
        size_t count;
    } room[] = {
        {&e->T, SHELL_DERIVATIVES * local * points},
        {&e->strain, SHELL_STRAINS * points},
        {&e->X[0], SHELL_PADDED(3 * local)},
        {&e->X[1], SHELL_PADDED(3 * local)},
        {&e->X[2], SHELL_PADDED(3 * local)},
        {&e->f, SHELL_PADDED(3 * local)},
        {&e->left, gauss * LEFT_ROWS * row},
        {&e->right, gauss * RIGHT_ROWS * row},
        {&e->K, local * 9 * row},
    };
    size_t total = 0, parts = sizeof room / sizeof *room;

    memset(e, 0, sizeof *e);
    for (size_t t = 0; t < parts; t++)
        total += room[t].count;
    total = (total + 7) / 8 * 8;
    e->memory = aligned_alloc(64, total * sizeof(double));
    if (!e->memory)
        return STATUS_MEMORY;
    memset(e->memory, 0, total * sizeof(double));
    double *next = e->memory;
    for (size_t t = 0; t < parts; next += room[t++].count)
        *room[t].part = next;
    e->local = space->local;
    e->row = (int)row;
    e->padded = space->padded;
    e->gauss = space->gauss;
    return STATUS_OK;
}

void shell_element_clear(struct shell_element *e)
{
    if (!e)
        return;
    free(e->memory);
    memset(e, 0, sizeof *e);
}

void shell_element_load(struct shell_element *e, const struct shell_space *space,
                        int element)
{
    shell_space_functions(space, element, e->T);
}

/* Derivatives of the surface with control points X at Gauss points 4 c .. 4 c + 3; in the
 * padding everything is zero. */
static void derive(const struct shell_element *e, const double *X, int c, int rows,
                   lanes out[][3])
{
    size_t stride = (size_t)(e->local * e->padded);

    for (int k = 0; k < rows; k++) {
        const double *T = e->T + (size_t)(k + 1) * stride + c * SHELL_LANES;
        lanes x = {0}, y = {0}, z = {0};
        for (int a = 0; a < e->local; a++, T += e->padded) {
            lanes N = *(const lanes *)T;
            x += N * X[3 * a];
            y += N * X[3 * a + 1];
            z += N * X[3 * a + 2];
        }
        out[k][0] = x, out[k][1] = y, out[k][2] = z;
    }
}

static void surface_at(const struct shell_element *e, const double *X, int c,
                       struct surface *s)
{
    lanes d[5][3], square;

    derive(e, X, c, 5, d);
    memcpy(s->a, d, sizeof s->a);
    memcpy(s->second, d + 2, sizeof s->second);
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        s->n[i] = d[0][j] * d[1][k] - d[0][k] * d[1][j];
    }
    square = dot(s->n, s->n);
    for (int t = 0; t < SHELL_LANES; t++)
        s->stretch[t] = sqrt(square[t]);
    for (int t = 0; t < SHELL_LANES; t++) /* padding: no normal, and no division by zero */
        square[t] = c * SHELL_LANES + t < e->gauss ? 1 / s->stretch[t] : 0;
    for (int i = 0; i < 3; i++)
        s->n[i] *= square;
}

/* Metric and curvature, in the order 11, 22, 12. */
static void forms(const struct surface *s, lanes metric[3], lanes curvature[3])
{
    metric[0] = dot(s->a[0], s->a[0]);
    metric[1] = dot(s->a[1], s->a[1]);
    metric[2] = dot(s->a[0], s->a[1]);
    for (int c = 0; c < 3; c++)
        curvature[c] = dot(s->second[c], s->n);
}

enum status shell_element_rest(struct shell_element *e,
                               const struct shell_material *material,
                               const double *parametric, double *rest)
{
    double nu = material->poisson, factor = material->young / (1 - nu * nu);
    int row = e->padded;

    memset(rest, 0, SHELL_REST_ROWS * (size_t)row * sizeof *rest);
    for (int q = 0; q < e->gauss; q++) {
        struct surface s;
        lanes metric[3], curvature[3];
        int t = q % SHELL_LANES;
        double *r = rest + q;
        surface_at(e, e->X[0], q / SHELL_LANES, &s);
        forms(&s, metric, curvature);
        if (!(s.stretch[t] > 0 && isfinite(s.stretch[t])))
            return STATUS_INPUT;
        double det = s.stretch[t] * s.stretch[t];
        double a = metric[1][t] / det, b = metric[0][t] / det, c = -metric[2][t] / det;
        r[REST_AREA * row] = parametric[q] * s.stretch[t];
        for (int k = 0; k < 3; k++) {
            r[(REST_METRIC + k) * row] = metric[k][t];
            r[(REST_CURVATURE + k) * row] = curvature[k][t];
        }
        r[REST_LAW * row] = factor * a * a;
        r[(REST_LAW + 1) * row] = factor * (nu * a * b + (1 - nu) * c * c);
        r[(REST_LAW + 2) * row] = factor * a * c;
        r[(REST_LAW + 3) * row] = factor * b * b;
        r[(REST_LAW + 4) * row] = factor * b * c;
        r[(REST_LAW + 5) * row] = factor * ((1 - nu) * a * b + (1 + nu) * c * c) / 2;
    }
    return STATUS_OK;
}

bool shell_element_strain(struct shell_element *e, const double *rest)
{
    int row = e->padded;
    bool sound = true;

    for (int c = 0; c < row / SHELL_LANES; c++) {
        struct surface s;
        lanes metric[3], curvature[3];
        surface_at(e, e->X[0], c, &s);
        forms(&s, metric, curvature);
        for (int t = 0; t < SHELL_LANES && c * SHELL_LANES + t < e->gauss; t++)
            sound = sound && s.stretch[t] > 0 && isfinite(s.stretch[t]);
        for (int k = 0; k < 3; k++) {
            int at = c * SHELL_LANES;
            const lanes *A = (const lanes *)(rest + (REST_METRIC + k) * row + at);
            const lanes *B = (const lanes *)(rest + (REST_CURVATURE + k) * row + at);
            *(lanes *)(e->strain + k * row + at) = (k < 2 ? 0.5 : 1.0) * (metric[k] - *A);
            *(lanes *)(e->strain + (3 + k) * row + at) =
                (k < 2 ? 1.0 : 2.0) * (*B - curvature[k]);
        }
    }
    return sound;
}

void shell_element_foresee(struct shell_element *e)
{
    int row = e->padded;

    for (int c = 0; c < row / SHELL_LANES; c++) {
        lanes d[2][3];
        derive(e, e->X[2], c, 2, d);
        lanes *strain = (lanes *)(e->strain + c * SHELL_LANES);
        strain[0] -= 0.5 * dot(d[0], d[0]);
        strain[row / SHELL_LANES] -= 0.5 * dot(d[1], d[1]);
        strain[2 * row / SHELL_LANES] -= dot(d[0], d[1]);
    }
}

/* Law C times area at four Gauss points. */
static void law_at(const double *rest, int row, int at, lanes C[3][3])
{
    lanes area = *(const lanes *)(rest + REST_AREA * row + at);
    const double *law = rest + REST_LAW * row + at;

    for (int i = 0, k = 0; i < 3; i++)
        for (int j = i; j < 3; j++, k++)
            C[i][j] = C[j][i] = area * *(const lanes *)(law + k * row);
}

/* Resultants of e->strain times area at four Gauss points. */
static void resultants(const struct shell_element *e, const struct shell_material *material,
                       lanes C[3][3], int at, lanes out[SHELL_STRAINS])
{
    double h = material->thickness;

    for (int part = 0; part < 2; part++)
        for (int i = 0; i < 3; i++) {
            const double *strain = e->strain + part * 3 * e->padded + at;
            lanes s = {0};
            for (int j = 0; j < 3; j++)
                s += C[i][j] * *(const lanes *)(strain + j * e->padded);
            out[part * 3 + i] = (part ? h * h * h / 12 : h) * s;
        }
}

double shell_element_energy(const struct shell_element *e,
                            const struct shell_material *material, const double *rest)
{
    lanes sum = {0};

    for (int at = 0; at < e->padded; at += SHELL_LANES) {
        lanes C[3][3], stress[SHELL_STRAINS];
        law_at(rest, e->padded, at, C);
        resultants(e, material, C, at, stress);
        for (int k = 0; k < SHELL_STRAINS; k++)
            sum += 0.5 * stress[k] * *(const lanes *)(e->strain + k * e->padded + at);
    }
    return (sum[0] + sum[2]) + (sum[1] + sum[3]);
}

/* Surface, dual base and Christoffel symbols at four Gauss points. */
struct frame {
    struct surface s;
    lanes inverse[3];  /* a^11, a^22, a^12                                            */
    lanes dual[2][3];  /* a^1, a^2                                                    */
    lanes gamma[2][3]; /* Gamma^c_ab in the order 11, 22, 12                          */
    lanes curvature[3];
};

static void frame_at(const struct shell_element *e, const double *X, int c, struct frame *f)
{
    lanes metric[3], over;

    surface_at(e, X, c, &f->s);
    forms(&f->s, metric, f->curvature);
    for (int t = 0; t < SHELL_LANES; t++)
        over[t] =
            c * SHELL_LANES + t < e->gauss ? 1 / (f->s.stretch[t] * f->s.stretch[t]) : 0;
    f->inverse[0] = metric[1] * over;
    f->inverse[1] = metric[0] * over;
    f->inverse[2] = -metric[2] * over;
    for (int i = 0; i < 3; i++) {
        f->dual[0][i] = f->inverse[0] * f->s.a[0][i] + f->inverse[2] * f->s.a[1][i];
        f->dual[1][i] = f->inverse[2] * f->s.a[0][i] + f->inverse[1] * f->s.a[1][i];
    }
    for (int d = 0; d < 2; d++)
        for (int k = 0; k < 3; k++)
            f->gamma[d][k] = dot(f->s.second[k], f->dual[d]);
}

/* What multiplies N_u, N_v, N_uu, N_vv, N_uv in the force at four Gauss points. */
static void densities(const struct frame *f, const lanes stress[SHELL_STRAINS],
                      lanes p[5][3])
{
    const lanes *m = stress + 3;

    for (int i = 0; i < 3; i++) {
        const lanes n = f->s.n[i];
        for (int d = 0; d < 2; d++)
            p[d][i] = stress[d] * f->s.a[d][i] + stress[2] * f->s.a[1 - d][i] +
                      n * (m[0] * f->gamma[d][0] + m[1] * f->gamma[d][1] +
                           2 * m[2] * f->gamma[d][2]);
        p[2][i] = -m[0] * n;
        p[3][i] = -m[1] * n;
        p[4][i] = -2 * m[2] * n;
    }
}

void shell_element_force(struct shell_element *e, const struct shell_material *material,
                         const double *rest)
{
    size_t stride = (size_t)(e->local * e->padded);

    memset(e->f, 0, 3 * (size_t)e->local * sizeof *e->f);
    for (int at = 0; at < e->padded; at += SHELL_LANES) {
        struct frame f;
        lanes C[3][3], stress[SHELL_STRAINS], p[5][3];
        law_at(rest, e->padded, at, C);
        resultants(e, material, C, at, stress);
        frame_at(e, e->X[1], at / SHELL_LANES, &f);
        densities(&f, stress, p);
        for (int a = 0; a < e->local; a++) {
            const double *T = e->T + stride + a * e->padded + at;
            lanes s[3] = {{0}};
            for (int k = 0; k < 5; k++)
                for (int i = 0; i < 3; i++)
                    s[i] += *(const lanes *)(T + (size_t)k * stride) * p[k][i];
            for (int i = 0; i < 3; i++)
                e->f[3 * a + i] += (s[i][0] + s[i][2]) + (s[i][1] + s[i][3]);
        }
    }
}

/* One Gauss point taken out of four. */
struct point {
    double a[2][3], n[3], dual[2][3], gamma[2][3], inverse[3];
    double C[3][3], stress[SHELL_STRAINS], curved;
};

static void pick(const struct frame *f, lanes C[3][3], const lanes *stress, int t,
                 struct point *p)
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
                              const double n[3], lanes s[9])
{
#define RIGHT(k) (*(const lanes *)(R + (k)*row))
#define LEFT(k)  (l[(k)*row])
    lanes u = RIGHT(RIGHT_SLOPE), v = RIGHT(RIGHT_SLOPE + 1), moment = RIGHT(RIGHT_MOMENT);
    lanes tension = LEFT(LEFT_TENSION) * u + LEFT(LEFT_TENSION + 1) * v;
    lanes t = LEFT(LEFT_CURVED) * u + LEFT(LEFT_CURVED + 1) * v;

    for (int k = 0; k < 3; k++)
        t += LEFT(LEFT_BENDING + k) * RIGHT(RIGHT_BENDING + k);
    for (int j = 0; j < 3; j++) {
        lanes along = n[j] * t + LEFT(LEFT_SURFACE + j) * moment;
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

/* K[a][3 i + j][b] from the lanes that hold b = a on. normal[gauss][3]. */
static void sum_blocks(struct shell_element *e, double (*normal)[3])
{
    int row = e->row;

    for (int a = 0; a < e->local; a++)
        for (int c = a / SHELL_LANES; c < row / SHELL_LANES; c++) {
            const double *l = e->left + a, *R = e->right + c * SHELL_LANES;
            double *K = e->K + (size_t)(a * 9 * row) + c * SHELL_LANES;
            lanes s[9] = {{0}};
            for (int q = 0; q < e->gauss; q++, l += LEFT_ROWS * row, R += RIGHT_ROWS * row)
                add_blocks(l, R, row, normal[q], s);
            for (int t = 0; t < 9; t++)
                *(lanes *)(K + t * row) = s[t];
        }
}

void shell_element_tangent(struct shell_element *e, const struct shell_material *material,
                           const double *rest, double stiff, double geometric)
{
    double h = material->thickness, D[5 * SHELL_PADDED(SHELL_MAX_LOCAL)] = {0};
    double normal[SHELL_MAX_POINTS][3];
    size_t stride = (size_t)(e->local * e->padded);
    struct frame f;
    lanes C[3][3], stress[SHELL_STRAINS];

    for (int q = 0; q < e->gauss; q++) {
        int at = q / SHELL_LANES * SHELL_LANES;
        struct point p;
        double *R = e->right + (size_t)(q * RIGHT_ROWS * e->row);
        double *L = e->left + (size_t)(q * LEFT_ROWS * e->row);
        if (q == at) {
            law_at(rest, e->padded, at, C);
            resultants(e, material, C, at, stress);
            frame_at(e, e->X[1], at / SHELL_LANES, &f);
        }
        pick(&f, C, stress, q - at, &p);
        for (int k = 0; k < 5; k++)
            for (int a = 0; a < e->local; a++)
                D[k * e->row + a] =
                    e->T[(size_t)(k + 1) * stride + (size_t)(a * e->padded + q)];
        fill_right(&p, e->row, D, R);
        fill_left(&p, stiff * h, stiff * h * h * h / 12, geometric, e->row, R, L);
        memcpy(normal[q], p.n, sizeof normal[q]);
    }
    sum_blocks(e, normal);
}
