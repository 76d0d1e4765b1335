/* Refinement must not be seen: the same point at the same parameters, for every operation,
 * direction, degree and kind of patch; and the spaces it makes are the ones asked for. */
#include "iga/refine.h"
#include "tests/check.h"
#include "tests/spline_fixture.h"

#include <float.h>

/* A new control point is a convex combination of old ones through up to 5 levels of 3
 * roundings, averaged over 10 choices, of coordinates about 1: 8 eps; evaluating at both
 * patches adds 40 eps at the very worst, 8 as a rule (tests/iga/patch.c). Repeated
 * refinements add their 8 eps each. */
#define TOL_SHAPE 1e-14
#define TOL_KNOT  DBL_EPSILON

enum { SAMPLES = 30, CASES = 60 };

static double distance(const struct patch *a, const struct patch *b, const double uvw[3])
{
    double x[3], y[3];

    patch_point(a, uvw, x, NULL);
    patch_point(b, uvw, y, NULL);
    return hypot(hypot(x[0] - y[0], x[1] - y[1]), x[2] - y[2]);
}

static void check_same_shape(const struct patch *before, const struct patch *after,
                             uint64_t *state)
{
    CHECK(!before->weight == !after->weight);
    for (int s = 0; s < SAMPLES; s++) {
        double uvw[3];
        for (int d = 0; d < 3; d++)
            uvw[d] = s < 8 ? s >> d & 1 : random_unit(state);
        CHECK_NEAR(distance(before, after, uvw), 0.0, TOL_SHAPE);
    }
    for (int a = 0; after->weight && a < patch_nodes(after); a++)
        CHECK(after->weight[a] > 0.0);
}

/* Counts how often u occurs among the knots. */
static int multiplicity(const struct bspline *b, double u)
{
    int count = 0;

    for (int i = 0; i < b->n + b->p + 1; i++)
        count += b->U[i] == u;
    return count;
}

static void check_others_unchanged(const struct patch *before, const struct patch *after,
                                   int direction)
{
    for (int d = 0; d < 3; d++) {
        const struct bspline *a = &before->basis[d], *b = &after->basis[d];
        if (d == direction)
            continue;
        CHECK(a->p == b->p && a->n == b->n);
        CHECK(!memcmp(a->U, b->U, (size_t)(a->n + a->p + 1) * sizeof *a->U));
    }
}

/* New knots where there were none, and one more on an inner knot where it is allowed. */
static int pick_knots(const struct bspline *b, uint64_t *state, double *u)
{
    int count = 0, most = random_int(state, 1, b->p);

    for (int i = b->p + 1; i < b->n && !count; i++)
        if (multiplicity(b, b->U[i]) < b->p)
            u[count++] = b->U[i];
    for (double at = count ? u[0] + 0.01 : 0.3; most > 0; most--)
        u[count++] = at;
    u[count++] = 0.995;
    return count;
}

static void check_insert(const struct patch *before, int d, uint64_t *state)
{
    struct patch after = {0};
    double u[BSPLINE_MAX_DEGREE + 2];
    int count = pick_knots(&before->basis[d], state, u);

    REQUIRE(patch_copy(before, &after) == STATUS_OK);
    REQUIRE(refine_insert(&after, d, count, u, NULL) == STATUS_OK);
    CHECK(after.basis[d].n == before->basis[d].n + count);
    CHECK(after.basis[d].p == before->basis[d].p);
    check_others_unchanged(before, &after, d);
    check_same_shape(before, &after, state);
    patch_clear(&after);
}

static void check_elevate(const struct patch *before, int d, uint64_t *state)
{
    const struct bspline *old = &before->basis[d];

    for (int by = 0; by <= BSPLINE_MAX_DEGREE - old->p; by++) {
        struct patch after = {0};
        const struct bspline *new = &after.basis[d];
        REQUIRE(patch_copy(before, &after) == STATUS_OK);
        REQUIRE(refine_elevate(&after, d, by, NULL) == STATUS_OK);
        CHECK(new->p == old->p + by);
        for (int i = 0; i < old->n + old->p + 1; i++)
            CHECK(multiplicity(new, old->U[i]) == multiplicity(old, old->U[i]) + by);
        check_others_unchanged(before, &after, d);
        check_same_shape(before, &after, state);
        patch_clear(&after);
    }
}

/* Elevation and split at once: old knots keep their continuity, new ones have p - 1. */
static void check_k(const struct patch *before, int d, uint64_t *state)
{
    const struct bspline *old = &before->basis[d];
    int by = random_int(state, 0, BSPLINE_MAX_DEGREE - old->p),
        parts = random_int(state, 1, 4);
    int spans, old_spans, span[64];
    struct patch after = {0}, split = {0};
    const struct bspline *new = &after.basis[d];

    REQUIRE(patch_copy(before, &after) == STATUS_OK);
    REQUIRE(patch_copy(before, &split) == STATUS_OK);
    REQUIRE(refine_k(&after, d, by, parts, NULL) == STATUS_OK);
    REQUIRE(refine_split(&split, d, parts, NULL) == STATUS_OK);
    old_spans = bspline_spans(old, span);
    spans = bspline_spans(new, span);
    CHECK(new->p == old->p + by &&spans == old_spans *parts);
    CHECK(bspline_spans(&split.basis[d], span) == spans);
    CHECK(split.basis[d].n == old->n + old_spans * (parts - 1));
    for (int s = 1; s < spans; s++) {
        double u = split.basis[d].U[span[s]];
        int was = multiplicity(old, u);
        CHECK(multiplicity(new, u) == (was ? was + by : 1));
        CHECK(multiplicity(&split.basis[d], u) == (was ? was : 1));
    }
    check_same_shape(before, &after, state);
    check_same_shape(before, &split, state);
    patch_clear(&after);
    patch_clear(&split);
}

/* By hand: u^2 on two spans with knot 1/4. Coefficients are the blossom s t at the inner
 * knot pairs; a knot at 1/2 makes it {0, 0, 1/8, 1/2, 1}, elevation the means of pairs. */
static void check_by_hand(void)
{
    static const double U[] = {0, 0, 0, 0.25, 1, 1, 1}, old[] = {0, 0, 0.25, 1};
    static const double inserted[] = {0, 0, 0.125, 0.5, 1};
    static const double elevated[] = {0, 0, 1.0 / 48, 3.0 / 16, 0.5, 1};
    struct bspline basis[3];
    struct patch one = {0}, two = {0};
    double half = 0.5;

    REQUIRE(bspline_init(&basis[0], 2, 7, U, NULL) == STATUS_OK);
    REQUIRE(bspline_init_uniform(&basis[1], 1, 2, NULL) == STATUS_OK);
    REQUIRE(bspline_init_uniform(&basis[2], 1, 2, NULL) == STATUS_OK);
    REQUIRE(patch_init(&one, basis) == STATUS_OK);
    for (int a = 0; a < 16; a++)
        one.point[3 * a] = old[a / 4];
    REQUIRE(patch_copy(&one, &two) == STATUS_OK);
    REQUIRE(refine_insert(&one, 0, 1, &half, NULL) == STATUS_OK);
    REQUIRE(refine_elevate(&two, 0, 1, NULL) == STATUS_OK);
    REQUIRE(one.basis[0].n == 5 && two.basis[0].n == 6);
    for (int a = 0; a < 20; a++)
        CHECK_NEAR(one.point[3 * a], inserted[a / 4], TOL_KNOT);
    for (int a = 0; a < 24; a++)
        CHECK_NEAR(two.point[3 * a], elevated[a / 4], TOL_KNOT);
    for (int d = 0; d < 3; d++)
        bspline_clear(&basis[d]);
    patch_clear(&one);
    patch_clear(&two);
}

/* Many refinements one after another: the circle stays one. */
static void check_circle(void)
{
    struct patch circle = {0}, patch = {0};
    uint64_t state = 7;

    quarter_annulus(0.5, 1.0, 0.5, &circle);
    REQUIRE(patch_copy(&circle, &patch) == STATUS_OK);
    for (int round = 0; round < 2; round++)
        for (int d = 0; d < 3; d++) {
            REQUIRE(refine_elevate(&patch, d, 1, NULL) == STATUS_OK);
            REQUIRE(refine_split(&patch, d, 2, NULL) == STATUS_OK);
        }
    check_same_shape(&circle, &patch, &state);
    for (int s = 0; s < SAMPLES; s++) {
        double uvw[3] = {random_unit(&state), 1.0, random_unit(&state)}, x[3];
        patch_point(&patch, uvw, x, NULL);
        CHECK_NEAR(hypot(x[0], x[1]), 1.0, TOL_SHAPE);
    }
    patch_clear(&circle);
    patch_clear(&patch);
}

struct refusal {
    enum { INSERT, ELEVATE, SPLIT, K } what;
    int number[2];
    double u[3];
    const char *sentence;
};

static enum status attempt(const struct refusal *r, struct patch *patch,
                           struct message *why)
{
    switch (r->what) {
    case INSERT:
        return refine_insert(patch, 0, r->number[0], r->u, why);
    case ELEVATE:
        return refine_elevate(patch, 0, r->number[0], why);
    case SPLIT:
        return refine_split(patch, 0, r->number[0], why);
    default:
        return refine_k(patch, 0, r->number[0], r->number[1], why);
    }
}

static void check_refusals(void)
{
    static const struct refusal refusals[] = {
        {INSERT, {1}, {0.0}, "new knot 0 is not strictly between 0 and 1"},
        {INSERT, {1}, {1.0}, "new knot 1 is not strictly between 0 and 1"},
        {INSERT, {1}, {NAN}, "new knot nan is not strictly between 0 and 1"},
        {INSERT, {2}, {0.5, 0.4}, "new knots must not decrease: 0.4 after 0.5"},
        {INSERT, {3}, {0.3, 0.3, 0.3}, "inner knot 0.3 is repeated more than 2 times"},
        {INSERT, {-1}, {0}, "-1 knots cannot be inserted"},
        {ELEVATE, {4}, {0}, "degree 2 elevated by 4 is above 5"},
        {ELEVATE, {-1}, {0}, "a degree cannot be elevated by -1"},
        {SPLIT, {0}, {0}, "a span cannot be split into 0 parts"},
        {SPLIT, {1000000000}, {0}, "a span cannot be split into 1000000000 parts"},
        {K, {1, 0}, {0}, "a span cannot be split into 0 parts"},
        {K, {4, 2}, {0}, "degree 2 elevated by 4 is above 5"},
    };
    struct patch patch = {0}, copy = {0};

    quarter_annulus(1, 2, 1, &patch);
    REQUIRE(patch_copy(&patch, &copy) == STATUS_OK);
    for (size_t i = 0; i < sizeof refusals / sizeof *refusals; i++) {
        struct message why = {""};
        struct patch was = patch;
        CHECK(attempt(&refusals[i], &patch, &why) == STATUS_INPUT);
        CHECK(attempt(&refusals[i], &patch, NULL) == STATUS_INPUT);
        if (!CHECK(!strcmp(why.text, refusals[i].sentence)))
            printf("    case %zu said: %s\n", i, why.text);
        CHECK(!memcmp(&was, &patch, sizeof patch));
        CHECK(!memcmp(copy.point, patch.point, 36 * sizeof(double)));
        CHECK(!memcmp(copy.weight, patch.weight, 12 * sizeof(double)));
    }
    CHECK(refine_insert(&patch, 0, 0, NULL, NULL) == STATUS_OK); /* nothing to do is fine */
    patch_clear(&patch);
    patch_clear(&copy);
}

int main(void)
{
    uint64_t state = 1;

    for (int i = 0; i < CASES; i++) {
        int degree[3];
        struct patch patch = {0};
        for (int d = 0; d < 3; d++)
            degree[d] = 1 + (i + d * (1 + i / 5)) % BSPLINE_MAX_DEGREE;
        random_patch(&state, degree, 0.5, i % 2, &patch);
        for (int d = 0; d < 3; d++) {
            check_insert(&patch, d, &state);
            check_elevate(&patch, d, &state);
            check_k(&patch, d, &state);
        }
        patch_clear(&patch);
    }
    check_by_hand();
    check_circle();
    check_refusals();
    return check_result();
}
