/* Loads: their sum and first moment on any net and any place. (Sheets that loads pull:
 * carried.c, sheets.c; `clothbench verify fabrics`.) */
#include "models/mechanics/dead_load.h"
#include "iga/bspline.h"
#include "tests/check.h"

/* Sums of up to 10^3 products. */
static const double ROUND_OFF = 1e-12;

/* Coefficients that make a displacement equal to the parameter: Greville abscissae. */
static double abscissa(const struct bspline *b, int i, int n)
{
    return b ? bspline_greville(b, i) : n > 1 ? (double)i / (n - 1) : 0;
}

/* Total force, and its moments about u = 0 and v = 0. */
static void check_sums(const struct scene_load *load, const struct bspline *const basis[2])
{
    struct dead_load_line line[3] = {
        {.n = 6, .degree = 1}, {.n = 4, .degree = 1}, {.n = 2, .degree = 1}};
    struct scene scene;
    double sum[3] = {0}, moment[2] = {0};

    for (int i = 0; i < 2; i++)
        if (basis[i])
            line[i] = (struct dead_load_line){basis[i]->n,
                                              basis[i]->p,
                                              basis[i]->n - basis[i]->p + 1,
                                              basis[i]->U + basis[i]->p,
                                              bspline_values,
                                              basis[i]};
    REQUIRE(scene_init(&scene) == STATUS_OK);
    REQUIRE(scene_add_load(&scene, load) == STATUS_OK);
    int n = line[0].n, m = line[1].n, l = line[2].n;
    double *f = calloc(3 * (size_t)(n * m * l), sizeof *f);
    REQUIRE(f && dead_load_add(&scene, line, f) == STATUS_OK);
    for (int a = 0; a < n * m * l; a++) {
        for (int i = 0; i < 3; i++)
            sum[i] += f[3 * a + i];
        moment[0] += f[3 * a] * abscissa(basis[0], a / (m * l), n);
        moment[1] += f[3 * a] * abscissa(basis[1], a / l % m, m);
    }
    for (int i = 0; i < 3; i++)
        CHECK_NEAR(sum[i], load->force[i], ROUND_OFF);
    for (int i = 0; i < 2; i++)
        CHECK_NEAR(moment[i], load->force[0] * (load->lo[i] + load->hi[i]) / 2, ROUND_OFF);
    free(f);
    scene_clear(&scene);
}

static void check_places(void)
{
    static const struct scene_load loads[] = {
        {{1, 0, 0}, {1, 1, 1}, {3, -2, 1}}, /* an end face                       */
        {{0, 0, 0}, {1, 1, 1}, {1, 2, 3}},  /* all of it                         */
        {{0.3, 0.2, 0.5}, {0.3, 0.2, 0.5}, {1, 0, -1}}, /* a point                       */
        {{0.13, 0, 0}, {0.71, 0, 1}, {-1, 4, 2}},    /* part of an edge                   */
        {{0.5, 0.25, 1}, {0.55, 0.9, 1}, {2, 1, 5}}, /* a patch of the upper face         */
    };
    static const double uneven[] = {0, 0, 0, 0, 0.04, 0.3, 0.3, 1, 1, 1, 1};
    struct bspline graded, square;

    REQUIRE(bspline_init(&graded, 3, 11, uneven, NULL) == STATUS_OK);
    REQUIRE(bspline_init_uniform(&square, 2, 5, NULL) == STATUS_OK);
    for (size_t n = 0; n < sizeof loads / sizeof *loads; n++) {
        check_sums(&loads[n], (const struct bspline *const[2]){NULL, NULL});
        check_sums(&loads[n], (const struct bspline *const[2]){&graded, &square});
        check_sums(&loads[n], (const struct bspline *const[2]){&square, NULL});
    }
    bspline_clear(&graded);
    bspline_clear(&square);
}

int main(void)
{
    check_places();
    return check_result();
}
