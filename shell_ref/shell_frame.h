/* shell_frame.h - inside shell_ref: the surface, its base vectors and its resultants, at
 * four points at a time. Includers are compiled with -ffp-contract=fast (see
 * CMakeLists.txt): their loops are nothing but multiply-adds, and fused ones are twice as
 * fast.
 */
#ifndef SHELL_FRAME_H
#define SHELL_FRAME_H

#include <math.h>
#include <string.h>

#include "shell_ref/shell_room.h"

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

#endif
