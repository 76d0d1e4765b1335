#include "models/solid/solid_layer.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/room.h"
#include "models/solid/solid_hinge.h"
#include "models/solid/solid_outer.h"
#include "models/vector.h"

enum { VECTORS = SOLID_LAYER_VECTORS };

void solid_layer_destroy(struct solid_layer *s)
{
    if (s)
        free(s->memory);
    free(s);
}

enum status solid_layer_create(const struct solid_space *space, struct solid_layer **layer)
{
    enum status st;
    size_t row = SOLID_PADDED((size_t)space->local);
    size_t points = (size_t)solid_layer_points(space->layer_points);
    size_t strains = (size_t)solid_layer_strains(space->layer_points);
    struct solid_layer *s = *layer = calloc(1, sizeof *s);
    if (!s)
        return STATUS_MEMORY;
    TRY(room_cut(&s->memory, ROOM(s->G, points * 6 * row), ROOM(s->normal, row),
                 ROOM(s->q, points * VECTORS * row), ROOM(s->b, strains * 3 * row),
                 ROOM(s->wb, strains * 3 * row), ROOM(s->t, points * VECTORS * 3),
                 ROOM(s->dV, SOLID_PADDED(points)), ROOM(s->weight, SOLID_PADDED(points))));
    s->local = space->local;
    s->row = (int)row;
out:
    return st;
}

int solid_layer_points(const int points[SOLID_KINDS])
{
    int sum = 0;

    for (int k = 0; k < SOLID_KINDS; k++)
        sum += points[k];
    return sum;
}

int solid_layer_strains(const int points[SOLID_KINDS])
{
    int sum = 0;

    for (int k = 0; k < SOLID_KINDS; k++)
        sum += solid_layer_form[k].strains * points[k];
    return sum;
}

enum solid_strains solid_layer_kind(const int points[SOLID_KINDS], int n)
{
    enum solid_strains kind = SOLID_ALONG_U;

    while (n >= points[kind])
        n -= points[kind++];
    return kind;
}

const struct solid_layer_form solid_layer_form[SOLID_KINDS] = {
    [SOLID_ALONG_U] = {1, 1, {{0, 0, 0, 0.5}}},
    [SOLID_ALONG_V] = {1, 1, {{0, 1, 1, 0.5}}},
    [SOLID_PLANE] = {3, 3, {{0, 0, 0, 0.5}, {1, 1, 1, 0.5}, {2, 0, 1, 1}}},
    [SOLID_ACROSS] = {3, 3, {{0, 0, 2, 1}, {1, 1, 2, 1}, {2, 2, 2, 0.5}}},
    [SOLID_BENDING] = {3, 4, {{0, 0, 2, 1}, {1, 1, 3, 1}, {2, 0, 3, 1}, {2, 1, 2, 1}}},
};

/* Computes stretches 11, 22, 12 or bends of a fabric, less what its own points have. */
static void fabric_stress(const struct solid_material *m, enum solid_strains kind,
                          double dV, const double *strain, double *stress)
{
    if (kind == SOLID_ALONG_U || kind == SOLID_ALONG_V) {
        stress[0] = dV * m->share[kind == SOLID_ALONG_V] * strain[0];
        return;
    }
    law_stress(m->fabric[kind == SOLID_BENDING ? LAW_BENDING : LAW_MEMBRANE], strain,
               stress);
    for (int i = 0; i < 3; i++) {
        if (i < 2 && kind != SOLID_BENDING)
            stress[i] -= m->share[i] * strain[i];
        stress[i] *= dV;
    }
}

void solid_layer_stress(const struct solid_material *m, enum solid_strains kind, double dV,
                        const double *strain, double *stress)
{
    const double along = m->plane + 2 * m->mu, shared = fabs(m->plane);
    const double own = kind == SOLID_BENDING ? along : shared;

    if (kind == SOLID_ACROSS) {
        stress[0] = dV * (5. / 6) * m->mu * strain[0];
        stress[1] = dV * (5. / 6) * m->mu * strain[1];
        stress[2] = dV * (m->across + 2 * m->mu) * strain[2];
    } else if (m->is_fabric) {
        fabric_stress(m, kind, dV, strain, stress);
    } else if (kind == SOLID_ALONG_U || kind == SOLID_ALONG_V) {
        stress[0] = dV * (along - shared) * strain[0];
    } else {
        stress[0] = dV * (own * strain[0] + m->plane * strain[1]);
        stress[1] = dV * (own * strain[1] + m->plane * strain[0]);
        stress[2] = dV * m->mu * strain[2];
    }
}

static void normalise(const double a[3], double out[3])
{
    double length = vector_length(a);
    for (int i = 0; i < 3; i++)
        out[i] = a[i] / length;
}

static solid_lanes at(const double *row)
{
    return *(const solid_lanes *)row;
}

/* Computes out[a] = sum_j m_j G_j[a]. */
static void combine(int row, const double m[3], const double *G, double *out)
{
    for (int a = 0; a < row; a += SOLID_LANES)
        *(solid_lanes *)(out + a) =
            m[0] * at(G + a) + m[1] * at(G + row + a) + m[2] * at(G + 2 * row + a);
}

/* Computes J[j] = sum_a X_a G_j[a] for six rows: derivatives of the position by u, v, w,
 * and the derivatives of these by w. */
static void tangents(const struct solid_layer *s, const double *X, const double *G,
                     double J[6][3])
{
    solid_lanes sum[6] = {{0}};

    for (int a = 0; a < s->local; a++) {
        solid_lanes x = *(const solid_lanes *)(X + SOLID_LANES * a);
        for (int j = 0; j < 6; j++)
            sum[j] += G[j * s->row + a] * x;
    }
    for (int j = 0; j < 6; j++)
        for (int i = 0; i < 3; i++)
            J[j][i] = sum[j][i];
}

/* Computes the frame t and m_k = J^-1 t_k; returns det J. */
static double frame(double J[6][3], double t[3][3], double m[3][3])
{
    double cofactor[3][3], det;

    for (int j = 0; j < 3; j++)
        vector_cross(J[(j + 1) % 3], J[(j + 2) % 3], cofactor[j]);
    det = vector_dot(J[0], cofactor[0]);
    normalise(J[0], t[0]);
    normalise(cofactor[2], t[2]);
    vector_cross(t[2], t[0], t[1]);
    for (int k = 0; k < 3; k++)
        for (int j = 0; j < 3; j++)
            m[k][j] = vector_dot(cofactor[j], t[k]) / det;
    return det;
}

/* Computes rows of F' t_k: G' less J's part by the gradients along the frame, q[3]. */
static void slopes(const struct solid_layer *s, double J[6][3], double t[3][3],
                   const double m[3], const double *G, const double *const q[3],
                   double *out)
{
    double share[3];

    for (int n = 0; n < 3; n++)
        share[n] = m[0] * vector_dot(J[3], t[n]) + m[1] * vector_dot(J[4], t[n]) +
                   m[2] * vector_dot(J[5], t[n]);
    combine(s->row, m, G + 3 * s->row, out);
    for (int a = 0; a < s->row; a += SOLID_LANES)
        *(solid_lanes *)(out + a) -=
            share[0] * at(q[0] + a) + share[1] * at(q[1] + a) + share[2] * at(q[2] + a);
}

enum status solid_layer_place(struct solid_layer *s, const struct solid_space *space,
                              int element, const double *X)
{
    size_t row = (size_t)s->row;
    int count = 0;

    for (int k = 0; k < SOLID_KINDS; k++) {
        s->points[k] = space->layer(space, element, k, s->G + 6 * row * (size_t)count,
                                    s->weight + count);
        count += s->points[k];
    }
    solid_hinge_functions(space, element, 6 * count, s->row, s->G);
    for (int n = 0; n < count; n++) {
        const double *G = s->G + (size_t)n * 6 * row;
        double *q = s->q + (size_t)n * VECTORS * row, *kept = s->t + n * VECTORS * 3;
        double J[6][3], t[3][3], m[3][3];
        bool bend = solid_layer_kind(s->points, n) == SOLID_BENDING;

        tangents(s, X, G, J);
        double det = frame(J, t, m);
        if (!(det > 0))
            return isnan(det) ? STATUS_NAN : STATUS_INVERTED;
        memset(kept, 0, VECTORS * 3 * sizeof *kept);
        memcpy(kept, t, (bend ? 6 : 9) * sizeof *kept);
        s->dV[n] = s->weight[n] * det / (bend ? 12 : 1);
        for (int k = 0; k < 3; k++)
            combine(s->row, m[k], G, k == 2 && bend ? s->normal : q + (size_t)k * row);
        for (int k = 0; bend && k < 2; k++)
            slopes(s, J, t, m[k], G, (const double *const[3]){q, q + row, s->normal},
                   q + (size_t)(2 + k) * row);
    }
    return STATUS_OK;
}

struct solid_layer_rest solid_layer_placed(const struct solid_layer *s)
{
    struct solid_layer_rest rest = {.q = s->q, .t = s->t, .dV = s->dV};

    memcpy(rest.points, s->points, sizeof rest.points);
    return rest;
}

/* Adds factor (c_k q_l + c_l q_k)_i to b_i, rows over functions; sets b if `first`. */
static void vary(int row, const struct solid_layer_term *term, const double *q,
                 double c[VECTORS][3], bool first, double *b)
{
    const double *qk = q + term->k * row, *ql = q + term->l * row;

    for (int i = 0; i < 3; i++, b += row) {
        double ck = term->factor * c[term->k][i], cl = term->factor * c[term->l][i];
        for (int a = 0; a < row; a += SOLID_LANES) {
            solid_lanes sum = ck * at(ql + a) + cl * at(qk + a);
            *(solid_lanes *)(b + a) = first ? sum : sum + at(b + a);
        }
    }
}

/* Computes wb = C b of a fabric's three strains along the sheet. */
static void weigh_fabric(const struct solid_material *m, enum solid_strains kind, double dV,
                         int row, const double *b, double *wb)
{
    double C[3][SOLID_LAYER_STRAINS];

    for (int j = 0; j < 3; j++) {
        double unit[SOLID_LAYER_STRAINS] = {0};
        unit[j] = 1;
        solid_layer_stress(m, kind, dV, unit, C[j]);
    }
    for (int i = 0; i < 3; i++)
        for (int a = 0; a < 3 * row; a += SOLID_LANES)
            *(solid_lanes *)(wb + 3 * i * row + a) = C[0][i] * at(b + a) +
                                                     C[1][i] * at(b + 3 * row + a) +
                                                     C[2][i] * at(b + 6 * row + a);
}

int solid_layer_vary(struct solid_layer *s, const struct solid_layer_rest *rest, int n,
                     double c[VECTORS][3], const struct solid_material *m, int first)
{
    const enum solid_strains kind = solid_layer_kind(rest->points, n);
    const struct solid_layer_form *form = &solid_layer_form[kind];
    const bool coupled = kind == SOLID_PLANE || kind == SOLID_BENDING;
    const int row = s->row;
    const double *q = rest->q + (size_t)n * VECTORS * (size_t)row;
    double *b = s->b + (size_t)first * 3 * (size_t)row, *wb = s->wb + (b - s->b);
    double unit[SOLID_LAYER_STRAINS] = {1, !coupled, 1};
    double modulus[SOLID_LAYER_STRAINS];

    for (int t = 0; t < form->terms; t++)
        vary(row, &form->term[t], q, c,
             !t || form->term[t].strain != form->term[t - 1].strain,
             b + form->term[t].strain * 3 * row);
    solid_layer_stress(m, kind, rest->dV[n], unit, modulus);
    if (coupled && m->is_fabric)
        weigh_fabric(m, kind, rest->dV[n], row, b, wb);
    for (int a = 0; coupled && !m->is_fabric && a < 3 * row; a += SOLID_LANES) {
        solid_lanes u = at(b + a), v = at(b + 3 * row + a);
        *(solid_lanes *)(wb + a) = modulus[0] * u + modulus[1] * v;
        *(solid_lanes *)(wb + 3 * row + a) = modulus[1] * u + modulus[0] * v;
    }
    for (int r = !coupled ? 0 : m->is_fabric ? 3 : 2; r < form->strains; r++)
        for (int a = 3 * r * row; a < 3 * (r + 1) * row; a += SOLID_LANES)
            *(solid_lanes *)(wb + a) = modulus[r] * at(b + a);
    return form->strains;
}
