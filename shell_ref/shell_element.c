#include "shell_ref/shell_element.h"

#include <stdlib.h>

#include "models/room.h"
#include "shell_ref/shell_frame.h"
#include "shell_ref/shell_tangent.h"

void shell_element_clear(struct shell_element *e)
{
    free(e->memory);
    memset(e, 0, sizeof *e);
}

enum status shell_element_init(struct shell_element *e, const struct shell_space *space)
{
    enum status st;
    size_t local = (size_t)space->local, row = SHELL_PADDED(local);
    size_t points = (size_t)space->padded, gauss = (size_t)space->gauss;

    memset(e, 0, sizeof *e);
    TRY(room_cut(
        &e->memory, ROOM(e->T, SHELL_DERIVATIVES * local * points),
        ROOM(e->strain, SHELL_STRAINS * points), ROOM(e->X[0], SHELL_PADDED(3 * local)),
        ROOM(e->X[1], SHELL_PADDED(3 * local)), ROOM(e->X[2], SHELL_PADDED(3 * local)),
        ROOM(e->f, SHELL_PADDED(3 * local)),
        ROOM(e->left, gauss * SHELL_TANGENT_LEFT * row),
        ROOM(e->right, gauss * SHELL_TANGENT_RIGHT * row), ROOM(e->K, local * 9 * row)));
    e->local = space->local;
    e->row = (int)row;
    e->padded = space->padded;
    e->gauss = space->gauss;
out:
    return st;
}

void shell_element_load(struct shell_element *e, const struct shell_space *space,
                        int element)
{
    shell_space_functions(space, element, e->T);
}

enum status shell_element_rest(struct shell_element *e,
                               const struct shell_material *material,
                               const double *parametric, double *rest)
{
    double nu = material->poisson, factor = material->young / (1 - nu * nu);
    int row = e->padded;

    memset(rest, 0, SHELL_REST_ROWS * (size_t)row * sizeof *rest);
    for (int q = 0; q < e->gauss; q++) {
        struct shell_surface s;
        shell_lanes metric[3], curvature[3];
        int t = q % SHELL_LANES;
        double *r = rest + q;
        shell_frame_surface(e, e->X[0], q / SHELL_LANES, &s);
        shell_frame_forms(&s, metric, curvature);
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
        struct shell_surface s;
        shell_lanes metric[3], curvature[3];
        shell_frame_surface(e, e->X[0], c, &s);
        shell_frame_forms(&s, metric, curvature);
        for (int t = 0; t < SHELL_LANES && c * SHELL_LANES + t < e->gauss; t++)
            sound = sound && s.stretch[t] > 0 && isfinite(s.stretch[t]);
        for (int k = 0; k < 3; k++) {
            int at = c * SHELL_LANES;
            const shell_lanes *A =
                (const shell_lanes *)(rest + (REST_METRIC + k) * row + at);
            const shell_lanes *B =
                (const shell_lanes *)(rest + (REST_CURVATURE + k) * row + at);
            *(shell_lanes *)(e->strain + k * row + at) =
                (k < 2 ? 0.5 : 1.0) * (metric[k] - *A);
            *(shell_lanes *)(e->strain + (3 + k) * row + at) =
                (k < 2 ? 1.0 : 2.0) * (*B - curvature[k]);
        }
    }
    return sound;
}

void shell_element_foresee(struct shell_element *e)
{
    int row = e->padded;

    for (int c = 0; c < row / SHELL_LANES; c++) {
        shell_lanes d[2][3];
        shell_frame_derive(e, e->X[2], c, 2, d);
        shell_lanes *strain = (shell_lanes *)(e->strain + c * SHELL_LANES);
        strain[0] -= 0.5 * shell_frame_dot(d[0], d[0]);
        strain[row / SHELL_LANES] -= 0.5 * shell_frame_dot(d[1], d[1]);
        strain[2 * row / SHELL_LANES] -= shell_frame_dot(d[0], d[1]);
    }
}

double shell_element_energy(const struct shell_element *e,
                            const struct shell_material *material, const double *rest)
{
    shell_lanes sum = {0};

    for (int at = 0; at < e->padded; at += SHELL_LANES) {
        shell_lanes C[3][3], stress[SHELL_STRAINS];
        shell_frame_law(rest, e->padded, at, C);
        shell_frame_resultants(e, material, C, at, stress);
        for (int k = 0; k < SHELL_STRAINS; k++)
            sum += 0.5 * stress[k] * *(const shell_lanes *)(e->strain + k * e->padded + at);
    }
    return (sum[0] + sum[2]) + (sum[1] + sum[3]);
}

/* What multiplies N_u, N_v, N_uu, N_vv, N_uv in the force at four Gauss points. */
static void densities(const struct shell_frame *f, const shell_lanes stress[SHELL_STRAINS],
                      shell_lanes p[5][3])
{
    const shell_lanes *m = stress + 3;

    for (int i = 0; i < 3; i++) {
        const shell_lanes n = f->s.n[i];
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
        struct shell_frame f;
        shell_lanes C[3][3], stress[SHELL_STRAINS], p[5][3];
        shell_frame_law(rest, e->padded, at, C);
        shell_frame_resultants(e, material, C, at, stress);
        shell_frame_frame(e, e->X[1], at / SHELL_LANES, &f);
        densities(&f, stress, p);
        for (int a = 0; a < e->local; a++) {
            const double *T = e->T + stride + a * e->padded + at;
            shell_lanes s[3] = {{0}};
            for (int k = 0; k < 5; k++)
                for (int i = 0; i < 3; i++)
                    s[i] += *(const shell_lanes *)(T + (size_t)k * stride) * p[k][i];
            for (int i = 0; i < 3; i++)
                e->f[3 * a + i] += (s[i][0] + s[i][2]) + (s[i][1] + s[i][3]);
        }
    }
}
