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
}

/* Takes a point's share of the law (law_shares). */
static void share_law(const struct law *law, enum shell_share share, const double metric[3],
                      double C[LAW_ENTRIES])
{
    double along[2];

    if (share == SHELL_ALL)
        return;
    law_shares(law, metric, C, along);
    if (share != SHELL_REST)
        memset(C, 0, LAW_ENTRIES * sizeof *C);
    C[LAW_11] += share == SHELL_REST ? -along[0] : share == SHELL_ALONG_U ? along[0] : 0;
    C[LAW_22] += share == SHELL_REST ? -along[1] : share == SHELL_ALONG_V ? along[1] : 0;
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
        share_law(&material->law, place[q].share, here, law);
        for (int k = 0; k < 3; k++)
            r[(REST_FORM + k) * row] = form[k][t];
        for (int k = 0; k < 6; k++)
            r[(REST_LAW + k) * row] = law[k];
    }
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

bool shell_element_strain(struct shell_element *e, const double *const rest[])
{
    membrane_strain(&e->at[SHELL_MEMBRANE], e->local, e->X[0], rest[SHELL_MEMBRANE]);
    return bending_strain(&e->at[SHELL_BENDING], e->local, e->X[0], rest[SHELL_BENDING]);
}

void shell_element_foresee(struct shell_element *e)
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
    const double linear = (sum[0] + sum[2]) + (sum[1] + sum[3]);
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
