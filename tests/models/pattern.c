/* Sheets that are no rectangles: what is wrong with an outline, which places are on it, and
 * triangles that cover it once, whatever its shape.
 */
#include "models/pattern.h"

#include "models/pattern_mesh.h"
#include "tests/check.h"

/* Sums of some thousand rounded areas. */
static const double ROUNDING = 1e-12;

enum { MOST = 64 };

/* Lines of points, each ended by an INFINITY, the last by two. */
static const double square[] = {0, 0, 2, 0, 2, 1, 0, 1, INFINITY, INFINITY},
                    turned[] = {0, 1, 2, 1, 2, 0, 0, 0, INFINITY, INFINITY},
                    trapezoid[] = {1, 1, 1.6, 1, 1.45, 1.5, 1.1, 1.5, INFINITY, INFINITY},
                    ell[] = {0, 0, 3, 0, 3, 1, 1, 1, 1, 2, 0, 2, INFINITY, INFINITY},
                    star[] = {0,  3,    .5, 1,  2,   1,  1, -.2, 1.5, -2,       0,
                              -1, -1.5, -2, -1, -.2, -2, 1, -.5, 1,   INFINITY, INFINITY},
                    sieve[] = {0,   0,   3,   0,   3,   3,   0,        3,       INFINITY,
                               .5,  .5,  .5,  1,   1,   1,   1,        .5,      INFINITY,
                               2,   .5,  2.5, .5,  2.5, 1,   2,        1,       INFINITY,
                               .5,  2,   1,   2.2, 1,   2.5, .6,       2.5,     INFINITY,
                               1.4, 1.4, 1.6, 1.4, 1.6, 1.6, 1.4,      1.6,     INFINITY,
                               2,   2,   2.5, 2,   2.2, 2.8, INFINITY, INFINITY},
                    bow[] = {0, 0, 1, 1, 1, 0, 0, 1, INFINITY, INFINITY},
                    touching[] = {0, 0, 2, 0, 2, 2, 1, 0, 0, 2, INFINITY, INFINITY},
                    spike[] = {0, 0, 2, 0, 3, 0, 2, 0, 2, 1, INFINITY, INFINITY},
                    twice[] = {0, 0, 1, 0, 1, 0, 1, 1, INFINITY, INFINITY},
                    two[] = {0, 0, 1, 0, INFINITY, INFINITY},
                    out[] = {0, 0, 1, 0, 1, 1, 0,        1,       INFINITY,
                             2, 2, 3, 2, 3, 3, INFINITY, INFINITY},
                    nested[] = {0, 0, 9, 0, 9, 9, 0,        9,       INFINITY,
                                1, 1, 8, 1, 8, 8, 1,        8,       INFINITY,
                                2, 2, 3, 2, 3, 3, INFINITY, INFINITY};

static struct pattern *pattern_of(const double *number)
{
    struct pattern *p = pattern_make();

    REQUIRE(p);
    while (isfinite(*number)) {
        double at[MOST][2];
        int count = 0;
        for (; isfinite(*number); number += 2, count++)
            at[count][0] = number[0], at[count][1] = number[1];
        number++;
        REQUIRE(!pattern_add_line(p, count, (const double(*)[2])at));
    }
    return p;
}

static void test_faults(void)
{
    static const struct {
        const double *lines;
        enum pattern_fault fault;
        int line, point;
    } want[] = {{square, PATTERN_SOUND, 0, 0},   {sieve, PATTERN_SOUND, 0, 0},
                {bow, PATTERN_CROSSING, 0, 0},   {touching, PATTERN_CROSSING, 0, 0},
                {spike, PATTERN_CROSSING, 0, 0}, {twice, PATTERN_DOUBLE, 0, 1},
                {two, PATTERN_FEW, 0, 0},        {out, PATTERN_OUTSIDE, 1, 0},
                {nested, PATTERN_OUTSIDE, 2, 0}};

    for (size_t n = 0; n < sizeof want / sizeof *want; n++) {
        struct pattern *p = pattern_of(want[n].lines);
        struct pattern_blame blame = {0};
        double size[2];
        const enum status st = pattern_finish(p, size, &blame);
        if (!CHECK(st == (want[n].fault ? STATUS_INPUT : STATUS_OK) &&
                   blame.fault == want[n].fault) ||
            (want[n].fault &&
             !CHECK(blame.line == want[n].line && blame.point == want[n].point)))
            printf("%zu: fault %d of line %d, point %d\n", n, blame.fault, blame.line,
                   blame.point);
        pattern_free(p);
    }
}

static struct pattern *finish(const double *lines, double size[2])
{
    struct pattern *p = pattern_of(lines);
    struct pattern_blame blame;

    REQUIRE(!pattern_finish(p, size, &blame));
    return p;
}

/* The box begins at 0, areas are right, and grid points are on the sheet if they are on its
 * border. */
static void test_places(void)
{
    static const struct {
        const double *lines;
        double area, size[2];
    } want[] = {{square, 2, {2, 1}},
                {turned, 2, {2, 1}},
                {trapezoid, (0.6 + 0.35) / 2 * 0.5, {0.6, 0.5}},
                {ell, 4, {3, 2}}};
    double size[2];

    for (size_t n = 0; n < sizeof want / sizeof *want; n++) {
        struct pattern *p = finish(want[n].lines, size);
        CHECK_NEAR(p->area, want[n].area, ROUNDING);
        CHECK_NEAR(size[0], want[n].size[0], ROUNDING);
        CHECK_NEAR(size[1], want[n].size[1], ROUNDING);
        CHECK(p->on[0][0] && pattern_has(p, 0, 0));
        CHECK(!pattern_has(p, -1e-9, 0) && !pattern_has(p, 0, -1e-9));
        pattern_free(p);
    }
    struct pattern *p = finish(trapezoid, size);
    CHECK_NEAR(p->corner[0], 1, 0);
    CHECK_NEAR(p->corner[1], 1, 0);
    CHECK(p->on[0][99] && !p->on[1][99] && !p->on[1][0] && p->on[99][75] == false);
    CHECK(pattern_has(p, 0.05, 0.25) && !pattern_has(p, 0.0499, 0.25)); /* a slanted side */
    pattern_free(p);
    p = finish(sieve, size);
    CHECK(!pattern_has(p, .75, .75) && pattern_has(p, .75, .5) && pattern_has(p, 1.5, 1));
    CHECK(!p->on[25][25] && p->on[0][50] && p->on[99][99]);
    pattern_free(p);
}

/* Finds the smallest angle of the triangles [degrees]. */
static double sharpest(const struct mesh_flat *flat)
{
    double least = 180;

    for (int t = 0; t < flat->triangles; t++)
        for (int c = 0; c < 3; c++) {
            const int *v = flat->triangle[t];
            const double *a = flat->at[v[c]], *b = flat->at[v[(c + 1) % 3]],
                         *d = flat->at[v[(c + 2) % 3]];
            const double p[2] = {b[0] - a[0], b[1] - a[1]},
                         q[2] = {d[0] - a[0], d[1] - a[1]};
            const double angle =
                atan2(p[0] * q[1] - p[1] * q[0], p[0] * q[0] + p[1] * q[1]);
            least = fmin(least, angle * 45 / atan(1));
        }
    return least;
}

/* Triangles of any width and seed cover the sheet once, have its border, about as many as
 * there is room for, and no slivers. */
static void test_mesh(const double *lines, double width, int seed, double sharp)
{
    struct scene scene;
    struct mesh_flat flat = {0};
    struct mesh_edge *edge = NULL;
    int edges = 0, (*side)[3] = NULL, rim = 0;
    double size[2], area = 0, around = 0, border = 0;

    REQUIRE(!scene_init(&scene));
    scene.pattern = finish(lines, size);
    scene.length = size[0], scene.width = size[1];
    REQUIRE(!pattern_mesh(&scene, width, seed, &flat));
    if (!CHECK(!mesh_flat_edges(&flat, &edge, &edges, &side)))
        return;
    for (int t = 0; t < flat.triangles; t++)
        area += mesh_flat_area2(&flat, flat.triangle[t][0], flat.triangle[t][1],
                                flat.triangle[t][2]) /
                2;
    for (int e = 0; e < edges; e++) {
        const double *a = flat.at[edge[e].node[0]], *b = flat.at[edge[e].node[1]];
        const double l = hypot(b[0] - a[0], b[1] - a[1]);
        CHECK(l < 2.2 * width);
        if (edge[e].node[3] < 0)
            rim++, around += l;
    }
    for (int n = 0; n < scene.pattern->points; n++) {
        const double *a = scene.pattern->at[n],
                     *b = scene.pattern->at[scene.pattern->next[n]];
        border += hypot(b[0] - a[0], b[1] - a[1]);
    }
    const double most = scene.pattern->area / (sqrt(0.1875) * width * width);
    if (!CHECK(mesh_flat_good(&flat, 0) &&
               fabs(area / scene.pattern->area - 1) < ROUNDING &&
               fabs(around / border - 1) < ROUNDING && sharpest(&flat) > sharp &&
               flat.triangles < 1.3 * most + 2 * rim && flat.triangles > 0.6 * most) ||
        getenv("CHECK_TOL_SCALE"))
        printf("%d triangles for %g, %d on the rim, area %g of %g, border %g of %g, "
               "sharpest %.3g\n",
               flat.triangles, most, rim, area, scene.pattern->area, around, border,
               sharpest(&flat));
    /* a connected sheet with holes: nodes - edges + triangles = 2 - lines */
    CHECK(flat.nodes - edges + flat.triangles == 2 - scene.pattern->lines);
    free(edge);
    free(side);
    mesh_flat_clear(&flat);
    scene_clear(&scene);
}

/* Points lie where supports end. */
static void test_supports(void)
{
    const struct scene_support s = {.lo = {0, 0.21, 0}, .hi = {0, 0.77, 1}, .fix = FIX_XYZ};
    struct scene scene;
    struct mesh_flat flat = {0};
    double size[2];
    int found[2] = {0};

    REQUIRE(!scene_init(&scene));
    scene.pattern = finish(square, size);
    scene.length = size[0], scene.width = size[1];
    REQUIRE(!scene_add_support(&scene, &s));
    REQUIRE(!pattern_mesh(&scene, 0.13, 0, &flat));
    for (int a = 0; a < flat.nodes; a++)
        for (int k = 0; k < 2; k++)
            found[k] +=
                flat.at[a][0] == 0 && fabs(flat.at[a][1] - (k ? 0.77 : 0.21)) < ROUNDING;
    CHECK(found[0] == 1 && found[1] == 1);
    mesh_flat_clear(&flat);
    scene_clear(&scene);
}

/* The outline of triangles is that from which they were made; pieces that meet in a point
 * are told. */
static void test_around(void)
{
    struct scene scene;
    struct mesh_flat flat = {0}, bow_tie;
    struct pattern *p = pattern_make();
    struct pattern_blame blame;
    double size[2];
    int triangle = 0;

    REQUIRE(!scene_init(&scene) && p);
    scene.pattern = finish(sieve, size);
    scene.length = size[0], scene.width = size[1];
    REQUIRE(!pattern_mesh(&scene, 0.2, 0, &flat));
    const int nodes = flat.nodes;
    CHECK(!pattern_add_mesh(p, &flat, &triangle) && !flat.nodes);
    CHECK(!pattern_finish(p, size, &blame));
    CHECK(p->mesh.nodes == nodes && p->lines == 6);
    CHECK_NEAR(p->area / scene.pattern->area, 1, ROUNDING);
    CHECK(!memcmp(p->on, scene.pattern->on, sizeof p->on));
    pattern_free(p);

    p = pattern_make();
    REQUIRE(p && !mesh_flat_make(&bow_tie, 5, 2));
    memcpy(bow_tie.at, (double[5][2]){{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}},
           5 * sizeof *bow_tie.at);
    memcpy(bow_tie.triangle, (int[2][3]){{0, 1, 2}, {2, 3, 4}},
           2 * sizeof *bow_tie.triangle);
    bow_tie.nodes = 5, bow_tie.triangles = 2;
    CHECK(pattern_add_mesh(p, &bow_tie, &triangle) == STATUS_INPUT && triangle == 1);
    mesh_flat_clear(&bow_tie);
    pattern_free(p);
    scene_clear(&scene);
}

/* Stars with random rays, whose corners may be as sharp as they like. */
static void test_random(void)
{
    enum { RAYS = 13, STARS = 40 };
    const double PI = 4 * atan(1);
    uint64_t state = 7;

    for (int n = 0; n < STARS; n++) {
        double lines[2 * RAYS + 2];
        for (int k = 0; k < RAYS; k++) {
            const double angle = 2 * PI * (k + 0.3 * mesh_flat_random(&state)) / RAYS;
            const double radius = 0.6 + 0.35 * mesh_flat_random(&state);
            lines[2 * k] = radius * cos(angle), lines[2 * k + 1] = radius * sin(angle);
        }
        lines[2 * RAYS] = lines[2 * RAYS + 1] = INFINITY;
        test_mesh(lines, n % 2 ? 0.2 : 0.05, n % 3, 0);
    }
}

int main(void)
{
    const double SHARP = 15; /* degrees; corners of the outlines are 30 at least */
    static const double *const shapes[] = {square, turned, trapezoid, ell, star, sieve};

    test_faults();
    test_places();
    for (size_t n = 0; n < sizeof shapes / sizeof *shapes; n++)
        for (int seed = 0; seed < 3; seed++) {
            test_mesh(shapes[n], n == 2 ? 0.05 : 0.2, seed, SHARP);
            test_mesh(shapes[n], n == 2 ? 0.011 : 0.037, seed, SHARP);
        }
    test_random();
    test_supports();
    test_around();
    return check_result();
}
