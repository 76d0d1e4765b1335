#include "models/solid/solid_green_layer.h"

#include <string.h>

#include "models/solid/solid_outer.h"
#include "models/vector.h"

typedef solid_lanes lanes;

enum { VECTORS = SOLID_LAYER_VECTORS };

static int points_of(const struct solid_layer_rest *rest)
{
    return solid_layer_points(rest->points);
}

static const double *rows_at(const struct solid_green_element *e,
                             const struct solid_layer_rest *rest, int n)
{
    return rest->q + (size_t)n * VECTORS * (size_t)e->row;
}

/* Computes d_k = sum_a U_a q_k[a] of one point. */
static void vectors(const struct solid_green_element *e, const double *U, const double *q,
                    double d[VECTORS][3])
{
    lanes sum[VECTORS] = {{0}};

    for (int a = 0; a < e->local; a++) {
        lanes u = *(const lanes *)(U + SOLID_LANES * a);
        for (int k = 0; k < VECTORS; k++)
            sum[k] += q[k * e->row + a] * u;
    }
    for (int k = 0; k < VECTORS; k++)
        for (int i = 0; i < 3; i++)
            d[k][i] = sum[k][i];
}

/* Computes c_k of the geometry e->U[1]. */
static void moved(const struct solid_green_element *e, const struct solid_layer_rest *rest,
                  int n, double c[VECTORS][3])
{
    const double *t = rest->t + (size_t)n * VECTORS * 3;

    vectors(e, e->U[1], rows_at(e, rest, n), c);
    for (int k = 0; k < VECTORS; k++)
        for (int i = 0; i < 3; i++)
            c[k][i] += t[3 * k + i];
}

static double volume(const double *t, double d[VECTORS][3])
{
    double c[3][3];

    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++)
            c[k][i] = t[3 * k + i] + d[k][i];
    return c[0][0] * (c[1][1] * c[2][2] - c[1][2] * c[2][1]) +
           c[0][1] * (c[1][2] * c[2][0] - c[1][0] * c[2][2]) +
           c[0][2] * (c[1][0] * c[2][1] - c[1][1] * c[2][0]);
}

bool solid_green_layer_strain(struct solid_green_element *e,
                              const struct solid_layer_rest *rest, bool change)
{
    double *strain = e->strain;

    for (int n = 0; n < points_of(rest); n++) {
        const enum solid_strains kind = solid_layer_kind(rest->points, n);
        const struct solid_layer_form *form = &solid_layer_form[kind];
        const struct solid_layer_term *term = form->term;
        const double *t = rest->t + (size_t)n * VECTORS * 3;
        double d[VECTORS][3], last[VECTORS][3], beside[VECTORS][3];

        vectors(e, e->U[0], rows_at(e, rest, n), d);
        if (kind == SOLID_ACROSS && !(volume(t, d) > 0))
            return false;
        if (change) {
            vectors(e, e->U[1], rows_at(e, rest, n), beside);
            vectors(e, e->U[2], rows_at(e, rest, n), last);
        }
        memset(strain, 0, (size_t)form->strains * sizeof *strain);
        for (int m = 0; m < form->terms; m++) {
            int k = term[m].k, l = term[m].l;
            double part = vector_dot(t + 3 * k, d[l]) + vector_dot(t + 3 * l, d[k]) +
                          vector_dot(d[k], d[l]);
            if (change)
                part -=
                    (vector_dot(beside[k], last[l]) + vector_dot(last[k], beside[l])) / 2;
            strain[term[m].strain] += term[m].factor * part;
        }
        strain += form->strains;
    }
    return true;
}

double solid_green_layer_energy(const struct solid_green_element *e,
                                const struct solid_material *material,
                                const struct solid_layer_rest *rest)
{
    const double *strain = e->strain;
    double energy = 0, stress[SOLID_LAYER_STRAINS];

    for (int n = 0; n < points_of(rest); n++) {
        const enum solid_strains kind = solid_layer_kind(rest->points, n);
        solid_layer_stress(material, kind, rest->dV[n], strain, stress);
        for (int r = 0; r < solid_layer_form[kind].strains; r++)
            energy += stress[r] * strain[r] / 2;
        strain += solid_layer_form[kind].strains;
    }
    return energy;
}

/* Computes A such that the stress (dV) at a point does the work sum_kl A_kl c_l.dc_k. */
static void couple(enum solid_strains kind, const double *stress,
                   double A[VECTORS][VECTORS])
{
    const struct solid_layer_term *term = solid_layer_form[kind].term;

    memset(A, 0, VECTORS * sizeof *A);
    for (int m = 0; m < solid_layer_form[kind].terms; m++) {
        double share = term[m].factor * stress[term[m].strain];
        A[term[m].k][term[m].l] += share;
        A[term[m].l][term[m].k] += share;
    }
}

void solid_green_layer_force(struct solid_green_element *e,
                             const struct solid_material *material,
                             const struct solid_layer_rest *rest)
{
    const double *strain = e->strain;
    lanes *f = (lanes *)e->f;

    memset(e->f, 0, SOLID_LANES * (size_t)e->row * sizeof *e->f);
    for (int n = 0; n < points_of(rest); n++) {
        const enum solid_strains kind = solid_layer_kind(rest->points, n);
        const double *q = rows_at(e, rest, n);
        double c[VECTORS][3], A[VECTORS][VECTORS], stress[SOLID_LAYER_STRAINS];
        lanes p[VECTORS] = {{0}};

        moved(e, rest, n, c);
        solid_layer_stress(material, kind, rest->dV[n], strain, stress);
        couple(kind, stress, A);
        for (int k = 0; k < VECTORS; k++)
            for (int l = 0; l < VECTORS; l++)
                for (int i = 0; i < 3; i++)
                    p[k][i] += A[k][l] * c[l][i];
        for (int a = 0; a < e->local; a++)
            for (int k = 0; k < VECTORS; k++)
                f[a] += q[k * e->row + a] * p[k];
        strain += solid_layer_form[kind].strains;
    }
}

/* Adds sum_kl q_k[a] A_kl q_l[b] to C[a][b]. */
static void add_geometric(struct solid_green_element *e, const double *q,
                          double A[VECTORS][VECTORS])
{
    int row = e->row;

    for (int a = 0; a < e->local; a++) {
        double share[VECTORS] = {0};
        for (int k = 0; k < VECTORS; k++)
            for (int l = 0; l < VECTORS; l++)
                share[l] += A[k][l] * q[k * row + a];
        for (int c = a / SOLID_LANES * SOLID_LANES; c < row; c += SOLID_LANES) {
            lanes *to = (lanes *)(e->C + a * row + c);
            for (int l = 0; l < VECTORS; l++)
                *to += share[l] * *(const lanes *)(q + l * row + c);
        }
    }
}

void solid_green_layer_stiffness(struct solid_green_element *e,
                                 const struct solid_material *material,
                                 const struct solid_layer_rest *rest, double geometry_share)
{
    const double *strain = e->strain;
    int strains = 0;

    memset(e->C, 0, (size_t)(e->row * e->row) * sizeof *e->C);
    for (int n = 0; n < points_of(rest); n++) {
        const enum solid_strains kind = solid_layer_kind(rest->points, n);
        double c[VECTORS][3], A[VECTORS][VECTORS], stress[SOLID_LAYER_STRAINS];

        if (geometry_share > 0) {
            moved(e, rest, n, c);
            solid_layer_stress(material, kind, geometry_share * rest->dV[n],
                               strain + strains, stress);
            couple(kind, stress, A);
            add_geometric(e, rows_at(e, rest, n), A);
        } else { /* at rest */
            memcpy(c, rest->t + (size_t)n * VECTORS * 3, sizeof c);
        }
        strains += solid_layer_vary(e->layer, rest, n, c, material, strains);
    }
    solid_outer(e->local, e->row, strains, e->layer->wb, e->layer->b, e->H);
}

void solid_green_layer_blocks(const struct solid_green_element *e, double stress_share,
                              int a, int first, int last, double (*K)[9])
{
    const double *H = e->H + (size_t)a * 9 * (size_t)e->row;

    for (int b = first; b < last; b++)
        for (int t = 0; t < 9; t++)
            K[b - first][t] +=
                stress_share * H[t * e->row + b] + (t % 4 == 0 ? e->C[a * e->row + b] : 0);
}
