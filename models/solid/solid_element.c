#include "models/solid/solid_element.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/room.h"
#include "models/solid/solid_hinge.h"
#include "models/solid/solid_outer.h"
#include "models/vector.h"

/* This file is compiled with -ffp-contract=fast (see CMakeLists.txt): its loops are nothing
 * but multiply-adds, and fused ones are twice as fast. */

typedef solid_lanes lanes;
_Static_assert(SOLID_LANES == 4, "a gathered position is one vector: x, y, z, 0");

static struct solid_material fabric(const struct law *law, double density)
{
    static const double flat[] = {1, 1, 0};
    const double *A = law->matrix[LAW_MEMBRANE];
    struct solid_material m = {.density = density, .is_fabric = true};

    m.mu = sqrt(A[LAW_11] * A[LAW_22]) / law->thickness / 2;
    for (int part = 0; part < LAW_PARTS; part++)
        law_on_surface(law, (enum law_part)part, flat, 1, m.fabric[part]);
    law_shares(law, flat, m.fabric[LAW_MEMBRANE], m.share);
    return m;
}

struct solid_material solid_element_material(const struct law *law, double density)
{
    double young = law->young, poisson = law->poisson;

    if (!law->isotropic)
        return fabric(law, density);
    return (struct solid_material){
        .lambda = young * poisson / ((1 + poisson) * (1 - 2 * poisson)),
        .mu = young / (2 * (1 + poisson)),
        .plane = young * poisson / (1 - poisson * poisson),
        .across = young - young / (1 + poisson),
        .density = density,
    };
}

void solid_element_clear(struct solid_element *e)
{
    solid_green_element_clear(&e->green);
    free(e->memory);
    memset(e, 0, sizeof *e);
}

enum status solid_element_init(struct solid_element *e, const struct solid_space *space)
{
    enum status st;
    size_t local = (size_t)space->local, gauss = (size_t)space->gauss;
    size_t modes = (size_t)space->modes, row = SOLID_PADDED(local);
    size_t internal = modes ? SOLID_GREEN_INTERNAL * SOLID_GREEN_INTERNAL : 0;

    memset(e, 0, sizeof *e);
    TRY(room_cut(&e->memory, ROOM(e->shape.N, gauss * row),
                 ROOM(e->shape.G, gauss * 3 * row),
                 ROOM(e->shape.weight, SOLID_PADDED(gauss)), ROOM(e->X, 4 * local),
                 ROOM(e->centre, modes ? 3 * row : 0), ROOM(e->g, gauss * 3 * row),
                 ROOM(e->mode, gauss * modes * 3), ROOM(e->dV, SOLID_PADDED(gauss)),
                 ROOM(e->A, internal), ROOM(e->wN, gauss * row), ROOM(e->M, local * row),
                 ROOM(e->volume, row)));
    e->local = space->local;
    e->row = (int)row;
    e->gauss = space->gauss;
    e->modes = space->modes;
    e->rest = (struct solid_green_rest){e->g, e->mode, e->dV, e->A};
    TRY(solid_green_element_init(&e->green, space));
out:
    return st;
}

/* Computes J[j] = sum_a X_a N_a,j, its cofactors and det J; G's rows are `row` apart. */
static double jacobian(int local, int row, const double *X, const double *G,
                       double cofactor[3][3])
{
    lanes column[3] = {{0}};
    double J[3][SOLID_LANES];

    for (int a = 0; a < local; a++) {
        lanes x = *(const lanes *)(X + SOLID_LANES * a);
        column[0] += G[a] * x;
        column[1] += G[row + a] * x;
        column[2] += G[2 * row + a] * x;
    }
    memcpy(J, column, sizeof J);
    for (int j = 0; j < 3; j++)
        vector_cross(J[(j + 1) % 3], J[(j + 2) % 3], cofactor[j]);
    return J[0][0] * cofactor[0][0] + J[0][1] * cofactor[0][1] + J[0][2] * cofactor[0][2];
}

/* Computes T = J^-T. Returns det J. */
static double inverse_jacobian(int local, int row, const double *X, const double *G,
                               double T[3][3])
{
    double cofactor[3][3], det = jacobian(local, row, X, G, cofactor);

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            T[i][j] = cofactor[j][i] / det;
    return det;
}

/* Computes g_i = sum_j T_ij G_j of the functions. */
static void push_forward(int row, double T[3][3], const double *G, double *restrict g)
{
    for (int i = 0; i < 3; i++)
        for (int a = 0; a < row; a++)
            g[i * row + a] =
                T[i][0] * G[a] + T[i][1] * G[row + a] + T[i][2] * G[2 * row + a];
}

/* Computes the same of internal modes, times `scale`, in g[modes][3]. */
static void push_modes(int modes, double T[3][3], double scale, const double *G, double *g)
{
    for (int m = 0; m < modes; m++, G++)
        for (int i = 0; i < 3; i++)
            *g++ = scale * (T[i][0] * G[0] + T[i][1] * G[modes] + T[i][2] * G[2 * modes]);
}

static enum status bad_jacobian(double det)
{
    return isnan(det) ? STATUS_NAN : STATUS_INVERTED;
}

/* Computes gradients at every Gauss point. */
static enum status physical_gradients(struct solid_element *e,
                                      const struct solid_space *space, int element)
{
    double centre[3][3], centre_det = 0;

    if (e->modes) {
        memcpy(e->centre, space->centre_gradient, 3 * (size_t)e->row * sizeof *e->centre);
        solid_hinge_functions(space, element, 3, e->row, e->centre);
        centre_det = inverse_jacobian(e->local, e->row, e->X, e->centre, centre);
        if (!(centre_det > 0))
            return bad_jacobian(centre_det);
    }
    for (int q = 0; q < e->gauss; q++) {
        const double *G = e->shape.G + (size_t)q * 3 * (size_t)e->row;
        double T[3][3], det = inverse_jacobian(e->local, e->row, e->X, G, T);

        if (!(det > 0))
            return bad_jacobian(det);
        e->dV[q] = e->shape.weight[q] * det;
        push_forward(e->row, T, G, e->g + (size_t)q * 3 * (size_t)e->row);
        /* scaled so that their gradients integrate to zero: patch test */
        push_modes(e->modes, centre, centre_det / det,
                   space->mode_gradient + (size_t)q * 3 * (size_t)e->modes,
                   e->mode + (size_t)q * 3 * (size_t)e->modes);
    }
    return STATUS_OK;
}

/* Computes dV alone. */
static enum status volumes(struct solid_element *e)
{
    for (int q = 0; q < e->gauss; q++) {
        double cofactor[3][3],
            det = jacobian(e->local, e->row, e->X, e->shape.G + q * 3 * e->row, cofactor);
        if (!(det > 0))
            return bad_jacobian(det);
        e->dV[q] = e->shape.weight[q] * det;
    }
    return STATUS_OK;
}

static void mass(struct solid_element *e, double density)
{
    int chunks = e->row / SOLID_LANES;

    for (int q = 0; q < e->gauss; q++)
        for (int a = 0; a < e->row; a++)
            e->wN[q * e->row + a] = density * e->dV[q] * e->shape.N[q * e->row + a];
    for (int a = 0; a < e->local; a++)
        for (int c = a / SOLID_LANES; c < chunks; c++) {
            const double *N = e->shape.N + c * SOLID_LANES, *wN = e->wN + a;
            lanes s = {0};
            for (int q = 0; q < e->gauss; q++, N += e->row, wN += e->row)
                s += *wN * *(const lanes *)N;
            *(lanes *)(e->M + (size_t)a * (size_t)e->row + c * SOLID_LANES) = s;
        }
    for (int c = 0; c < chunks; c++) {
        const double *N = e->shape.N + c * SOLID_LANES;
        lanes s = {0};
        for (int q = 0; q < e->gauss; q++, N += e->row)
            s += e->dV[q] * *(const lanes *)N;
        *(lanes *)(e->volume + c * SOLID_LANES) = s;
    }
}

static void hinge(struct solid_element *e, const struct solid_space *space, int element,
                  int points)
{
    solid_hinge_functions(space, element, points, e->row, e->shape.N);
    solid_hinge_functions(space, element, 3 * points, e->row, e->shape.G);
}

enum status solid_element_compute(struct solid_element *e, const struct solid_space *space,
                                  int element, const struct solid_material *material,
                                  const double *x)
{
    const int *node = space->ien + (size_t)element * (size_t)space->local;
    enum status st;

    space->functions(space, element, &e->shape);
    hinge(e, space, element, e->gauss);
    for (int a = 0; a < e->local; a++)
        for (int i = 0; i < 3; i++)
            e->X[SOLID_LANES * a + i] = x[3 * (size_t)node[a] + (size_t)i];
    st = space->layer ? volumes(e) : physical_gradients(e, space, element);
    if (st != STATUS_OK)
        return st;
    mass(e, material->density);
    if (space->layer) {
        st = solid_layer_place(e->green.layer, space, element, e->X);
        e->rest.layer = solid_layer_placed(e->green.layer);
    }
    return e->modes ? solid_green_element_modes(&e->green, material, &e->rest, e->A) : st;
}
