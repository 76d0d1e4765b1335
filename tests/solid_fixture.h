/* solid_fixture.h - solids for tests: B-splines or hexahedra on nets of any shape, which
 * scenes cannot express, with fields interpolated in them. */
#ifndef SOLID_FIXTURE_H
#define SOLID_FIXTURE_H

#include <lapacke.h>

#include "fem_ref/hex_model.h"
#include "iga/plate_model.h"
#include "models/solid/solid_assembly.h"
#include "tests/check.h"
#include "tests/spline_fixture.h"

enum solid_kind { SOLID_IGA, SOLID_SELECTIVE, SOLID_HEX, SOLID_INCOMPATIBLE };

/* Not to be copied once made: the space points into it. */
struct solid {
    enum solid_kind kind;
    struct patch patch; /* hexahedra: the same net as a patch of degree 1              */
    struct solid_space space;
    struct plate_tables tables;
    struct hex_tables hex;
    struct solid_assembly assembly;
};

/* A test case. Degrees are 1 for hexahedra. */
struct solid_case {
    enum solid_kind kind;
    int degree[3], points[3];
    double size[3]; /* of the box, centred at the origin                         [m]   */
};

static inline enum solid_kind solid_kind(const char *word)
{
    if (!strcmp(word, "selective"))
        return SOLID_SELECTIVE;
    if (!strcmp(word, "hex"))
        return SOLID_HEX;
    if (!strcmp(word, "incompatible"))
        return SOLID_INCOMPATIBLE;
    REQUIRE(!strcmp(word, "iga"));
    return SOLID_IGA;
}

/* A box with uniform knots around the origin. */
static inline void solid_box(const struct solid_case *c, struct patch *patch)
{
    struct bspline basis[3];
    double origin[3], edge[3][3] = {{0}};

    for (int i = 0; i < 3; i++) {
        REQUIRE(bspline_init_uniform(&basis[i], c->degree[i], c->points[i], NULL) ==
                STATUS_OK);
        origin[i] = -c->size[i] / 2;
        edge[i][i] = c->size[i];
    }
    REQUIRE(patch_init(patch, basis) == STATUS_OK);
    patch_set_box(patch, origin, edge[0], edge[1], edge[2]);
    for (int i = 0; i < 3; i++)
        bspline_clear(&basis[i]);
}

/* x <- A x with a fixed A of determinant 1.1: no angle stays right. */
static inline void solid_skew(struct patch *patch)
{
    static const double A[3][3] = {{1, 0.3, 0.1}, {-0.2, 1, 0.4}, {0.1, 0.2, 1.1}};

    for (int a = 0; a < patch_nodes(patch); a++) {
        double *x = patch->point + 3 * a, y[3] = {0};
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                y[i] += A[i][j] * x[j];
        memcpy(x, y, sizeof y);
    }
}

/* Moves every control point by up to `part` of half the mean distance to its neighbour. */
static inline void solid_shake(struct patch *patch, const double size[3], double part,
                               uint64_t *state)
{
    for (int t = 0; t < 3 * patch_nodes(patch); t++)
        patch->point[t] +=
            part * (random_unit(state) - 0.5) * size[t % 3] / (patch->basis[t % 3].n - 1);
}

/* Takes the patch over. gauss[3] as plate_model_space has it; hexahedra have their own. */
static inline void solid_make(struct solid *s, enum solid_kind kind, struct patch *patch,
                              const int gauss[3], bool thickness,
                              const struct solid_material *material)
{
    const struct bspline *b = patch->basis;

    memset(s, 0, sizeof *s);
    s->kind = kind;
    s->patch = *patch;
    memset(patch, 0, sizeof *patch);
    b = s->patch.basis;
    if (kind <= SOLID_SELECTIVE)
        REQUIRE(plate_model_space(&s->space, &s->tables, &s->patch, gauss, thickness) ==
                STATUS_OK);
    else
        REQUIRE(hex_model_space(&s->space, &s->hex, 1, (int[]){b[0].n, b[1].n, b[2].n},
                                s->patch.point, thickness,
                                kind == SOLID_INCOMPATIBLE) == STATUS_OK);
    if (kind == SOLID_SELECTIVE)
        REQUIRE(plate_model_select(&s->space, &s->tables, &s->patch) == STATUS_OK);
    REQUIRE(solid_assembly_init(&s->assembly, &s->space, material) == STATUS_OK);
    REQUIRE(solid_assembly_compute(&s->assembly, s->space.rest) == STATUS_OK);
}

static inline void solid_clear(struct solid *s)
{
    solid_assembly_clear(&s->assembly);
    if (s->kind <= SOLID_SELECTIVE)
        plate_model_clear(&s->space, &s->tables);
    else
        solid_space_clear(&s->space);
    patch_clear(&s->patch);
}

/* A field of space: u(x) [m]. */
typedef void solid_field(const double x[3], double u[3]);

/* Solves the collocation of one direction in place: value[n][stride] along it. */
static inline void solid_collocate(const struct bspline *b, int rows, double *value)
{
    double *C = calloc((size_t)(b->n * b->n), sizeof *C), N[BSPLINE_MAX_ORDER];
    lapack_int *pivot = malloc((size_t)b->n * sizeof *pivot);

    REQUIRE(C && pivot);
    for (int i = 0; i < b->n; i++) {
        double u = bspline_greville(b, i);
        int span = bspline_span(b, u);
        bspline_eval(b, span, u, 0, N);
        for (int a = 0; a <= b->p; a++)
            C[i * b->n + span - b->p + a] = N[a];
    }
    REQUIRE(!LAPACKE_dgesv(LAPACK_ROW_MAJOR, b->n, rows, C, b->n, pivot, value, rows));
    free(C);
    free(pivot);
}

/* Coefficients d[nodes][3] of the spline that equals the field at the Greville points of
 * the patch; the field itself where the patch can represent it. */
static inline void solid_interpolate(const struct patch *patch, solid_field *field,
                                     double *d)
{
    const struct bspline *b = patch->basis;
    int n = b[0].n, m = b[1].n, l = b[2].n, span[3], node[PATCH_MAX_LOCAL];

    for (int a = 0; a < n * m * l; a++) { /* values, times the denominator if rational */
        double uvw[3] = {bspline_greville(&b[0], a / (m * l)),
                         bspline_greville(&b[1], a / l % m),
                         bspline_greville(&b[2], a % l)};
        double x[3], R[PATCH_MAX_LOCAL], inverse = 0;
        patch_point(patch, uvw, x, NULL);
        patch_basis(patch, uvw, span, R, NULL);
        patch_local_nodes(patch, span, node);
        for (int t = 0; t < patch_local(patch); t++)
            inverse += R[t] / (patch->weight ? patch->weight[node[t]] : 1);
        field(x, d + 3 * a);
        for (int i = 0; i < 3; i++)
            d[3 * a + i] /= inverse;
    }
    solid_collocate(&b[0], 3 * m * l, d);
    for (int i = 0; i < n; i++)
        solid_collocate(&b[1], 3 * l, d + 3 * (size_t)(i * m * l));
    for (int c = 0; c < n * m; c++)
        solid_collocate(&b[2], 3, d + 3 * (size_t)(c * l));
    for (int t = 0; patch->weight && t < 3 * n * m * l; t++)
        d[t] /= patch->weight[t / 3];
}

/* All of a symmetric block matrix, [3 nodes][3 nodes]; owned by the caller. */
static inline double *solid_dense(const struct blocks *g, double (*K)[9])
{
    size_t n = 3 * (size_t)g->nodes;
    double *full = calloc(n * n, sizeof *full);

    REQUIRE(full);
    for (int a = 0; a < g->nodes; a++)
        for (long t = g->start[a]; t < g->start[a + 1]; t++)
            for (int ij = 0; ij < 9; ij++) {
                size_t row = 3 * (size_t)a + (size_t)ij / 3;
                size_t column = 3 * (size_t)g->node[t] + (size_t)ij % 3;
                full[row * n + column] = full[column * n + row] = K[t][ij];
            }
    return full;
}

#endif
