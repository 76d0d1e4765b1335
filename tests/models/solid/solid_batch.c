/* Elements side by side in the lanes of vectors (solid_batch.h) against the same elements
 * one by one: stiffness, mass and volumes, on boxes and on geometries without a right
 * angle, with as many elements as fill the lanes and with some left over; and what is
 * folded. */
#include "tests/solid_fixture.h"

/* Sums of some hundred products, in the same order but for where they are fused. */
static const double ROUND_OFF = 1e-12;

static double apart(size_t count, const double *a, const double *b)
{
    double most = 0, size = 0;

    for (size_t t = 0; t < count; t++)
        most = fmax(most, fabs(a[t] - b[t])), size = fmax(size, fabs(a[t]));
    return most / size;
}

/* Assembles element by element from here on. */
static void part(struct solid_assembly *s)
{
    for (int t = 0; t < s->threads; t++) {
        solid_batch_destroy(s->batch[t]);
        s->batch[t] = NULL;
    }
}

static void check_case(const struct solid_case *c, bool skewed)
{
    const struct solid_material material = {.lambda = 3, .mu = 2, .density = 1.5};
    struct solid s[2];

    for (int k = 0; k < 2; k++) {
        struct patch patch;
        uint64_t state = 5;
        solid_box(c, &patch);
        if (skewed)
            solid_skew(&patch), solid_shake(&patch, c->size, 0.2, &state);
        solid_make(&s[k], SOLID_IGA, &patch, (const int[]){0, 0, 0}, false, &material);
        REQUIRE(s[k].assembly.batch[0]);
        if (k)
            part(&s[k].assembly);
        CHECK(solid_assembly_compute(&s[k].assembly, s[k].space.rest) == STATUS_OK);
    }
    const struct solid_assembly *a = &s[0].assembly, *b = &s[1].assembly;
    const size_t pairs = (size_t)a->graph.start[a->graph.nodes];
    CHECK_NEAR(apart(9 * pairs, a->K[0], b->K[0]), 0, ROUND_OFF);
    CHECK_NEAR(apart(pairs, a->M, b->M), 0, ROUND_OFF);
    CHECK_NEAR(apart((size_t)a->graph.nodes, a->volume, b->volume), 0, ROUND_OFF);
    for (int k = 0; k < 2; k++) { /* turned inside out; not a number */
        double *x = s[k].space.rest;
        for (int n = 0; n < s[k].space.nodes; n++)
            x[3 * n] = -x[3 * n];
        CHECK(solid_assembly_compute(&s[k].assembly, x) == STATUS_INVERTED);
        for (int n = 0; n < s[k].space.nodes; n++)
            x[3 * n] = NAN;
        CHECK(solid_assembly_compute(&s[k].assembly, x) == STATUS_NAN);
        solid_clear(&s[k]);
    }
}

int main(void)
{
    static const struct solid_case cases[] = {
        {SOLID_IGA, {2, 2, 1}, {6, 5, 2}, {1, 0.8, 0.1}},
        {SOLID_IGA, {3, 2, 2}, {5, 4, 3}, {1, 0.8, 0.3}},
        {SOLID_IGA, {1, 1, 1}, {2, 2, 2}, {1, 1, 1}},
        {SOLID_IGA, {2, 1, 1}, {11, 2, 2}, {1, 0.2, 0.1}}};

    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++)
        for (int skewed = 0; skewed < 2; skewed++)
            check_case(&cases[n], skewed);
    return check_result();
}
