/* The large-displacement solid: forces are the derivative of its energy and the tangent
 * that of its forces, by central differences at swept steps; rigid motions cost nothing; at
 * rest the tangent is the linear stiffness. B-splines of every degree, hexahedra with and
 * without internal modes, distorted, in both bases through the thickness. Elements that are
 * computed side by side get the numbers that they get alone.
 */
#include "models/solid/solid_green.h"
#include "tests/derivative_fixture.h"
#include "tests/solid_fixture.h"

/* derivative_fixture.h */
static const double DIFFERENCE = 2e-9;
/* Energy of a turned rest shape against that of a deformed one: squares of strains that are
 * a few hundred roundings; and its forces. */
static const double RIGID_ENERGY = 1e-24, RIGID_FORCE = 1e-11;
/* Sums of a few hundred products in another order, against the largest. */
static const double REORDERED = 1e-12;

/* K of the tangent at rest against the linear stiffness. */
static void check_rest(const struct solid_green *g)
{
    const struct blocks *graph = &g->assembly->graph;
    long pairs = graph->start[graph->nodes];
    double(*K)[9] = malloc((size_t)pairs * sizeof *K), most = 0, apart = 0;

    REQUIRE(K);
    CHECK(large_body_tangent(&g->body, &large_path_statics, g->assembly->space->rest,
                             (struct large_foresight){0}, K) == STATUS_OK);
    for (long n = 0; n < pairs; n++)
        for (int t = 0; t < 9; t++) {
            most = fmax(most, fabs(g->assembly->K[n][t]));
            apart = fmax(apart, fabs(g->assembly->K[n][t] - K[n][t]));
        }
    CHECK_NEAR(apart / most, 0, REORDERED);
    free(K);
}

/* A turned body and a change d that a linearisation takes for another turn: foreseen
 * strains are none, whatever the body has there, and so is their part of the tangent. With
 * e the way of the turn before, what the change's linearisation missed is (d + 2 e) d / 2.
 */
static void check_foresight(const struct solid_green *g)
{
    const struct blocks *graph = &g->assembly->graph;
    const double *rest = g->assembly->space->rest, spin[3] = {0.2, -0.1, 0.3};
    const double turn[3][3] = {{-0.2, -0.6, 0}, {0.6, -0.2, 0}}; /* less the unit matrix */
    long pairs = graph->start[graph->nodes];
    size_t count = 3 * (size_t)graph->nodes;
    double(*K)[9] = malloc(2 * (size_t)pairs * sizeof *K), most = 0, apart = 0;
    double *x = malloc(3 * count * sizeof *x), *d = x + count, *beside = d + count;

    REQUIRE(K && x);
    for (size_t t = 0; t < count; t++) {
        size_t node = t - t % 3, j = (t % 3 + 1) % 3, k = (t % 3 + 2) % 3;
        d[t] = spin[j] * rest[node + k] - spin[k] * rest[node + j];
        double e = 0;
        for (size_t i = 0; i < 3; i++)
            e += turn[t % 3][i] * rest[node + i];
        x[t] = rest[t] + e + d[t];
        beside[t] = d[t] + 2 * e;
    }
    CHECK(large_body_tangent(&g->body, &large_path_statics, x,
                             (struct large_foresight){.change = d, .beside = beside},
                             K) == STATUS_OK);
    CHECK(large_body_tangent(&g->body, &large_path_statics, x,
                             (struct large_foresight){.none = true},
                             K + pairs) == STATUS_OK);
    for (long n = 0; n < pairs; n++)
        for (int t = 0; t < 9; t++) {
            most = fmax(most, fabs(K[n][t]));
            apart = fmax(apart, fabs(K[n][t] - K[pairs + n][t]));
        }
    CHECK_NEAR(apart / most, 0, REORDERED);
    free(x);
    free(K);
}

/* Elements side by side give the matrices that they give one by one; masses bit for bit. */
static void check_lanes(struct solid *s, const double *x)
{
    struct solid_space plain = s->space;
    struct solid_assembly one = {0};
    const size_t pairs = (size_t)s->assembly.graph.start[s->space.nodes];
    double most = 0, apart = 0;

    plain.line = NULL;
    REQUIRE(solid_assembly_init(&one, &plain, &s->assembly.material) == STATUS_OK);
    CHECK(solid_assembly_compute(&one, x) == STATUS_OK);
    CHECK(solid_assembly_compute(&s->assembly, x) == STATUS_OK);
    CHECK((s->assembly.batch[0] != NULL) == (s->kind == SOLID_IGA));
    for (size_t t = 0; t < 9 * pairs; t++) {
        most = fmax(most, fabs(one.K[t / 9][t % 9]));
        apart = fmax(apart, fabs(one.K[t / 9][t % 9] - s->assembly.K[t / 9][t % 9]));
    }
    CHECK_NEAR(apart / most, 0, REORDERED);
    CHECK(!memcmp(one.M, s->assembly.M, pairs * sizeof *one.M));
    CHECK(!memcmp(one.volume, s->assembly.volume,
                  (size_t)s->space.nodes * sizeof *one.volume));
    solid_assembly_clear(&one);
}

/* The internal modes' stiffness is told where a law makes it not positive definite. */
static void check_factors(const struct solid *s)
{
    const struct solid_material bad = {.lambda = -1, .mu = -1, .density = 1};

    CHECK(solid_element_compute(&s->assembly.work[0], &s->space, 0, &bad, s->space.rest) ==
          STATUS_INDEFINITE);
}

static void check_solid(enum solid_kind kind, int p, int q, int r, bool thickness)
{
    const struct solid_case box = {kind, {p, q, r}, {p + 2, q + 3, r + 1}, {1.0, 0.8, 0.3}};
    const struct law law = law_isotropic(3, 0.3, 1);
    const struct solid_material material = solid_element_material(&law, 2);
    struct patch patch;
    struct solid s;
    struct solid_green g = {0};
    uint64_t state = 7;

    solid_box(&box, &patch);
    solid_shake(&patch, box.size, 0.2, &state);
    solid_make(&s, kind, &patch, (int[3]){0, 0, 0}, thickness, &material);
    REQUIRE(solid_green_init(&g, &s.assembly) == STATUS_OK);
    size_t count = 3 * (size_t)s.space.nodes;
    double *x = malloc(2 * count * sizeof *x), *d = x + count;
    REQUIRE(x);
    for (size_t t = 0; t < count; t++) {
        x[t] = s.space.rest[t] + 0.03 * (random_unit(&state) - 0.5);
        d[t] = random_unit(&state) - 0.5;
    }
    check_rest(&g);
    if (kind == SOLID_INCOMPATIBLE)
        check_factors(&s);
    derivative_check(&g.body, &s.assembly.graph, x, d, DIFFERENCE);
    check_foresight(&g);
    check_lanes(&s, x);
    /* without a shift: it would move the first coefficient of a column alone in the
     * thickness basis; rotations are the same in both */
    derivative_rigid(&g.body, s.space.rest, 0, derivative_energy(&g.body, x), RIGID_ENERGY,
                     RIGID_FORCE);
    free(x);
    solid_green_clear(&g);
    solid_clear(&s);
}

/* det F <= 0 and numbers that are none are told apart. */
static void check_deaths(void)
{
    const struct solid_case box = {SOLID_IGA, {2, 2, 1}, {4, 4, 2}, {1, 1, 0.1}};
    const struct law law = law_isotropic(3, 0.3, 1);
    const struct solid_material material = solid_element_material(&law, 2);
    struct patch patch;
    struct solid s;
    struct solid_green g = {0};
    double energy;

    solid_box(&box, &patch);
    solid_make(&s, SOLID_IGA, &patch, (int[3]){0, 0, 0}, false, &material);
    REQUIRE(solid_green_init(&g, &s.assembly) == STATUS_OK);
    double x[3 * 32], *strain = malloc(large_body_strains(&g.body) * sizeof *strain);
    REQUIRE(strain && s.space.nodes == 32);
    memcpy(x, s.space.rest, sizeof x);
    x[2] += 1; /* one corner of the lower face far above the upper one */
    CHECK(large_body_strain(&g.body, x, strain) == STATUS_INVERTED);
    CHECK(solid_green_energy(&g, x, &energy) == STATUS_INVERTED);
    CHECK(solid_assembly_compute(&s.assembly, x) == STATUS_INVERTED);
    x[2] = NAN;
    CHECK(large_body_strain(&g.body, x, strain) == STATUS_NAN);
    CHECK(solid_assembly_compute(&s.assembly, x) == STATUS_NAN);
    free(strain);
    solid_green_clear(&g);
    solid_clear(&s);
}

int main(void)
{
    for (int p = 1; p <= 4; p++)
        check_solid(SOLID_IGA, p, p < 4 ? p + 1 : 2, 1 + p % 2, p % 2);
    check_solid(SOLID_IGA, 2, 2, 1, true);
    for (int p = 2; p <= 4; p++)
        for (int thickness = 0; thickness < 2; thickness++)
            check_solid(SOLID_SELECTIVE, p, 2, 1, thickness);
    check_solid(SOLID_HEX, 1, 1, 1, false);
    check_solid(SOLID_HEX, 1, 1, 1, true);
    check_solid(SOLID_INCOMPATIBLE, 1, 1, 1, false);
    check_solid(SOLID_INCOMPATIBLE, 1, 1, 1, true);
    check_deaths();
    return check_result();
}
