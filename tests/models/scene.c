/* Scenes and discretizations made in memory: needs, paths, copies, sheets, ripples. */
#include "models/discretization.h"
#include "models/grid.h"
#include "models/scene.h"
#include "tests/check.h"

/* A handful of operations on numbers of order one. */
#define TOL_ROUND (8 * 2.220446049250313e-16)

static void check_numbers(void)
{
    struct scene s;

    REQUIRE(scene_init(&s) == STATUS_OK);
    s.young = 1e5, s.poisson = 0.3, s.density = 0.5, s.thickness = 0.001;
    s.gravity[2] = -9.81;
    CHECK_RELATIVE(scene_bending_stiffness(&s), 1e5 * 1e-9 / 10.92, TOL_ROUND);
    /* 12 (1 - nu^2) rho g L^3 / (E h^2) */
    CHECK_RELATIVE(scene_gamma(&s), 10.92 * 0.5 * 9.81 / 0.1, TOL_ROUND);
    s.length = 2;
    CHECK_RELATIVE(scene_gamma(&s), 8 * 10.92 * 0.5 * 9.81 / 0.1, TOL_ROUND);
    scene_clear(&s);
}

static void check_needs(void)
{
    const struct scene_support edge = {.lo = {0, 0, 0}, .hi = {0, 1, 1}, .fix = FIX_XYZ};
    struct scene_support other = {.lo = {0, 0, 0}, .hi = {0.1, 1, 0.5}, .fix = FIX_Z};
    struct scene s;
    char text[256];

    REQUIRE(scene_init(&s) == STATUS_OK);
    CHECK(scene_needs(&s) == 0);
    REQUIRE(scene_add_support(&s, &edge) == STATUS_OK);
    CHECK(scene_needs(&s) == 0);
    REQUIRE(scene_add_support(&s, &other) == STATUS_OK);
    CHECK(scene_needs(&s) == (SCENE_NEED_PATCH_SUPPORTS | SCENE_NEED_COMPONENT_SUPPORTS |
                              SCENE_NEED_THICKNESS_SUPPORTS));
    s.drag = 1;
    REQUIRE(scene_add_obstacle(&s, &(struct scene_obstacle){.radius = 1}) == STATUS_OK);
    CHECK(scene_needs(&s) & SCENE_NEED_DRAG);
    CHECK(scene_needs(&s) & SCENE_NEED_CONTACT);

    scene_needs_text(0, text, sizeof text);
    CHECK(!strcmp(text, ""));
    scene_needs_text(SCENE_NEED_DRAG | SCENE_NEED_CONTACT, text, sizeof text);
    CHECK(!strcmp(text, "contact with obstacles, body drag"));
    scene_needs_text(~0u, text, 10);
    CHECK(strlen(text) == 9);
    scene_clear(&s);
    scene_clear(&s);
}

/* A scene's obstacle is a copy, that of a mesh excepted. */
static void check_bodies(void)
{
    double path[2][4] = {{0, 0, 0, 0}, {1, 0, 0, 2}}, turn[1][2] = {{3, 45}};
    char file[] = "a.obj";
    struct scene_obstacle o = {
        .kind = OBSTACLE_MESH,
        .motion = {.path_count = 2, .path = path, .turn_count = 1, .turn = turn},
        .file = file};
    struct scene s;

    REQUIRE(scene_init(&s) == STATUS_OK);
    REQUIRE(scene_add_obstacle(&s, &o) == STATUS_OK);
    path[1][3] = turn[0][1] = 0, file[0] = 'b';
    CHECK(s.obstacles[0].motion.path[1][3] == 2 && s.obstacles[0].motion.turn[0][1] == 45);
    CHECK(!strcmp(s.obstacles[0].file, "a.obj") && !s.obstacles[0].mesh);
    CHECK(scene_needs(&s) == (SCENE_NEED_CONTACT | SCENE_NEED_MOVING_OBSTACLES));
    s.contact.self = true;
    CHECK(scene_needs(&s) & SCENE_NEED_SELF_CONTACT);
    scene_clear(&s);
}

/* A support is a copy. By its path it goes up, then along x; its turn about a line
 * through (1,0,0) along z begins at time 1. */
static void check_motion(void)
{
    static const struct {
        double time, at[3]; /* where (2,0,0) is                                        */
    } rows[] = {{-1, {2, 0, 0}}, {.5, {2, 0, 1}}, {1, {2, 0, 2}},
                {2, {3, 1, 2}},  {3, {4, 0, 2}},  {99, {4, 0, 2}}};
    double path[3][4] = {{0, 0, 0, 0}, {1, 0, 0, 2}, {3, 4, 0, 2}};
    double turn[2][2] = {{1, 0}, {3, 180}};
    const struct scene_support moved = {.hi = {0, 1, 1},
                                        .fix = FIX_XYZ,
                                        .motion = {.path_count = 3,
                                                   .path = path,
                                                   .turn_count = 2,
                                                   .turn = turn,
                                                   .axis = {0, 0, 1},
                                                   .about = {1, 0, 0}}};
    struct scene_placement place;
    struct scene s;
    double x[3], back[3];

    REQUIRE(scene_init(&s) == STATUS_OK);
    REQUIRE(scene_add_support(&s, &moved) == STATUS_OK);
    path[2][1] = turn[1][1] = -1;
    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++) {
        scene_motion_at(&s.supports[0].motion, rows[n].time, &place);
        scene_placement_point(&place, (const double[3]){2, 0, 0}, x);
        scene_placement_back(&place, x, back);
        for (int i = 0; i < 3; i++) {
            CHECK_NEAR(x[i], rows[n].at[i], 1e-15);
            CHECK_NEAR(back[i], i ? 0 : 2, 1e-15);
        }
    }
    scene_motion_at(&(const struct scene_motion){0}, 1, &place);
    CHECK(place.shift[0] == 0 && place.turn[0][0] == 1 && place.turn[1][0] == 0);
    CHECK(scene_needs(&s) == (SCENE_NEED_MOVING_SUPPORTS | SCENE_NEED_TURNING_CLAMPS));
    s.supports[0].lo[2] = s.supports[0].hi[2] = 0.5; /* a hinge */
    CHECK(scene_needs(&s) == (SCENE_NEED_MOVING_SUPPORTS | SCENE_NEED_THICKNESS_SUPPORTS));
    scene_clear(&s);
}

static void check_discretization(void)
{
    double knots[] = {0, 0, 1, 1}, weights[] = {1, 2, 3, 4};
    struct discretization from = {.points = {2, 2, 1}, .degree = {1, 1, 0}}, to;

    from.knots[1] = knots, from.knot_count[1] = 4;
    from.weights = weights, from.weight_count = 4;
    REQUIRE(discretization_copy(&from, &to) == STATUS_OK);
    CHECK(to.knots[1] != knots && !memcmp(to.knots[1], knots, sizeof knots));
    CHECK(to.weights != weights && !memcmp(to.weights, weights, sizeof weights));
    CHECK(!to.knots[0] && !to.knots[2] && to.points[0] == 2);
    discretization_clear(&to);
    CHECK(!to.weights && !to.knots[1] && !to.points[0]);
    discretization_clear(&to);
}

/* Which edges a support clamps: u = 0, u = 1, v = 0, v = 1. */
static void check_clamped(void)
{
    static const struct {
        struct scene_support support;
        const char *edges;
    } cases[] = {{{{0, 0, 0}, {0, 1, 1}, FIX_XYZ}, "yes no no no"},
                 {{{1, 0, 0}, {1, 1, 1}, FIX_XYZ}, "no yes no no"},
                 {{{0, 0, 0}, {1, 0.1, 1}, FIX_XYZ}, "no no yes no"},
                 {{{0, 1, 0}, {1, 1, 1}, FIX_XYZ}, "no no no yes"},
                 {{{0, 0, 0}, {1, 1, 1}, FIX_XYZ}, "yes yes yes yes"},
                 {{{0, 0, 0}, {0, 1, 1}, FIX_X | FIX_Z}, "no no no no"},
                 {{{0, 0, 0.5}, {0, 1, 0.5}, FIX_XYZ}, "no no no no"},
                 {{{0, 0, 0}, {0, 0.9, 1}, FIX_XYZ}, "no no no no"},
                 {{{0.1, 0, 0}, {0.1, 1, 1}, FIX_XYZ}, "no no no no"}};

    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        struct scene s;
        char edges[32] = "";
        REQUIRE(scene_init(&s) == STATUS_OK);
        REQUIRE(scene_add_support(&s, &(struct scene_support){.fix = FIX_XYZ}) ==
                STATUS_OK);
        REQUIRE(scene_add_support(&s, &cases[n].support) == STATUS_OK);
        for (int edge = 0; edge < 4; edge++) {
            strcat(edges, edge ? " " : "");
            strcat(edges, scene_edge_clamped(&s, 0, edge / 2, edge % 2) ? "yes" : "no");
        }
        CHECK_SAY(!strcmp(edges, cases[n].edges), "support %zu: %s", n, edges);
        scene_clear(&s);
    }
}

/* The grid's columns and u of sheets: ends are exact, a void belongs to the nearest. */
static void check_sheets(void)
{
    struct scene s;
    double at;

    REQUIRE(scene_init(&s) == STATUS_OK);
    CHECK(scene_sheet_at(&s, 0.1, &at) == 0 && at == 0.1);
    CHECK(scene_sheet_u(&s, 0, 0.1) == 0.1 && !grid_cut(1, 49));
    for (s.sheets = 2; s.sheets <= SCENE_MAX_SHEETS; s.sheets++) {
        int column[2], cuts = 0;
        for (int i = 0; i < GRID_U; i++) {
            const int k = scene_sheet_at(&s, i / (GRID_U - 1.0), &at);
            grid_columns(s.sheets, k, column);
            CHECK(column[0] <= i && i <= column[1] && grid_sheet(s.sheets, i) == k);
            CHECK((at == 0) == (i == column[0]) && (at == 1) == (i == column[1]));
            CHECK_NEAR(scene_sheet_u(&s, k, at), i / (GRID_U - 1.0), TOL_ROUND);
            if (grid_cut(s.sheets, i)) {
                CHECK(i == column[1] && ++cuts == k + 1);
                CHECK(scene_sheet_at(&s, (i + 0.4) / (GRID_U - 1), &at) == k && at == 1);
                CHECK(scene_sheet_at(&s, (i + 0.6) / (GRID_U - 1), &at) == k + 1);
                CHECK(at == 0);
            }
        }
        CHECK(cuts == s.sheets - 1 && column[1] == GRID_U - 1);
    }
    scene_clear(&s);
}

/* A ripple is one of many: the same for a seed, with the mean square 1 over seeds. */
static void check_ripple(void)
{
    enum { SEEDS = 2000 };
    const double tol = 5 * sqrt(2. / SEEDS); /* five standard errors */
    const double at[3] = {0.3, -0.2, 0.7};
    struct scene s;
    double squares = 0, v[3];

    REQUIRE(scene_init(&s) == STATUS_OK);
    s.wave = 0.1, s.ripple[2] = 2;
    CHECK(scene_ripples(&s) && scene_needs(&s) == SCENE_NEED_INITIAL_MOTION);
    for (s.seed = 0; s.seed < SEEDS; s.seed++) {
        scene_initial_velocity(&s, at, v);
        CHECK(v[0] == 0 && v[2] == 2 * scene_ripple(&s, at));
        squares += v[2] * v[2] / 4 / SEEDS;
    }
    CHECK_NEAR(squares, 1, tol);
    scene_clear(&s);
}

int main(void)
{
    check_sheets();
    check_ripple();
    check_numbers();
    check_needs();
    check_motion();
    check_bodies();
    check_discretization();
    check_clamped();
    return check_result();
}
