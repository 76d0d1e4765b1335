/* Feet of a sheet on itself: kept triangles against every pair, geometry against closed
 * forms, and steps that never let a sheet through itself. */
#include "models/contact/contact_search.h"

#include <omp.h>

#include "models/contact/contact_law.h"
#include "models/metric/intersection.h"
#include "models/vector.h"
#include "tests/check.h"
#include "tests/mesh_surface_fixture.h"
#include "tests/noise.h"

/* Sums of a few products of numbers near 1. */
static const double rounding = 1e-14;
/* The same, of differences of 1e-3 after moves of 5. */
static const double far_rounding = 1e-11;
static const double turn = 6.283185307179586;

enum { SIDE_MAX = 512, POINTS_MAX = 4096 };
static double place[POINTS_MAX][3], change[POINTS_MAX][3];

static double random_about_0(void)
{
    return 2 * noise_unit() - 1;
}

/* A test looks at this. */
static struct contact_surface surface;
static struct contact_search search;

/* The shapes of a unit square; contact starts at the distance `start`. */
static const double start = 0.02, radius = 0.05, inner = 0.1;

/* A surface on the unit square, in a search. */
static void open_smooth(const int points[2], contact_row *row, int width,
                        struct contact_surface *f, struct contact_search *s)
{
    double line[2][SIDE_MAX];
    struct scene scene;

    for (int d = 0; d < 2; d++)
        for (int i = 0; i < points[d]; i++)
            line[d][i] = i / (points[d] - 1.);
    REQUIRE(scene_init(&scene) == STATUS_OK);
    scene.length = scene.width = 1;
    REQUIRE(contact_surface_init(f, &scene, NULL, row, width, width,
                                 (const double *const[]){line[0], line[1]},
                                 points) == STATUS_OK);
    REQUIRE(contact_search_init(s, f, start) == STATUS_OK);
    scene_clear(&scene);
}

/* The next nets are meshes of the same points, in `mesh`. */
static bool meshed;
static struct mesh mesh;

/* A net of several sheets of so long sides, n[0] rows in all, in a search. */
static void open_sheets(int sheets, double side, const int n[2], struct contact_surface *f,
                        struct contact_search *s)
{
    struct scene scene;

    REQUIRE(scene_init(&scene) == STATUS_OK);
    scene.sheets = sheets;
    scene.length = scene.width = side;
    for (int k = 1; k < sheets; k++)
        scene.pose[k] = scene.pose[0];
    if (meshed)
        surface_of_grid(&scene, n, &mesh, f);
    else
        REQUIRE(contact_surface_init_net(f, &scene, n) == STATUS_OK);
    REQUIRE(contact_search_init(s, f, start) == STATUS_OK);
    scene_clear(&scene);
}

static void close_search(struct contact_surface *f, struct contact_search *s)
{
    contact_search_clear(s);
    contact_surface_clear(f);
    mesh_clear(&mesh);
}

static void flat(double u, double v, double x[3])
{
    x[0] = 0.6 * u - 0.48 * v, x[1] = 0.8 * u + 0.36 * v, x[2] = 0.8 * v;
}

/* A cylinder between two planes that are 0.8 start apart. */
static void folded(double u, double v, double x[3])
{
    const double r = 0.4 * start, arc = r * turn / 4, s = u - 0.5;
    const double angle = fmax(fmin(s / r, turn / 4), -turn / 4);

    x[0] = r * cos(angle) - fmax(fabs(s) - arc, 0);
    x[1] = v, x[2] = r * sin(angle) + 0.05 * v * x[0];
}

/* An involute of a circle: its turns are a circumference apart, here 0.7 start. */
static void rolled(double u, double v, double x[3])
{
    const double a = 0.7 * start / turn, angle = sqrt(2 * (u + inner) / a);

    x[0] = a * (cos(angle) + angle * sin(angle)), x[1] = v;
    x[2] = a * (sin(angle) - angle * cos(angle));
}

static void helicoid(double u, double v, double x[3])
{
    x[0] = (0.01 + v) * cos(10 * turn * u), x[1] = (0.01 + v) * sin(10 * turn * u);
    x[2] = 10 * 0.8 * start * u;
}

static void crumpled(double u, double v, double x[3])
{
    x[0] = u + radius * sin(turn * (4 * u + 3 * v) + 1) + 0.05 * random_about_0();
    x[1] = v + radius * sin(turn * (4 * v - 5 * u) + 2) + 0.05 * random_about_0();
    x[2] = radius * sin(turn * (5 * u + 2 * v)) + 0.02 * random_about_0();
}

static void doubled(double u, double v, double x[3])
{
    x[0] = u < 0.5 ? u : 1 - u, x[1] = v, x[2] = 0;
}

static void needle(double u, double v, double x[3])
{
    x[0] = u + v, x[1] = x[2] = 0;
}

static void point(double u, double v, double x[3])
{
    x[0] = x[1] = x[2] = 0 * u * v;
}

static const struct shape {
    const char *name;
    void (*point)(double u, double v, double x[3]);
    int least, most; /* feet of 25 x 21 points                                        */
} shapes[] = {{"flat", flat, 0, 0},
              {"folded", folded, 504, 525},
              {"rolled", rolled, 650, 1050},
              {"helicoid", helicoid, 200, 1050},
              {"crumpled", crumpled, 200, 1050},
              {"doubled", doubled, 400, 600},
              {"needle", needle, 0, 1050},
              {"point", point, 0, 1050}};
enum { CRUMPLED = 4, SHAPES = sizeof shapes / sizeof *shapes };

static void shape_net(const struct shape *shape, const int n[2])
{
    for (int k = 0; k < n[0] * n[1]; k++)
        shape->point(k / n[1] / (n[0] - 1.), k % n[1] / (n[1] - 1.), place[k]);
}

/* Returns the share of `change` that may be gone. */
static double limit(struct contact_search *s, double x[3], double d[3], double wall)
{
    double share;

    REQUIRE(contact_search_limit(s, x, d, wall, 1, &share, NULL) == STATUS_OK);
    return share;
}

static void check_same(const struct contact_search *a, const struct contact_search *b)
{
    const size_t width = contact_foot_width(a->sheet.surface);
    int different = 0;

    if (!CHECK(a->count == b->count))
        return;
    for (int n = 0; n < a->count; n++) {
        struct contact_foot p = a->foot[n], q = b->foot[n];
        const int *i = a->node + p.first, *j = b->node + q.first;
        const double *v = a->weight + p.first, *w = b->weight + q.first;
        p.first = q.first = 0;
        different += memcmp(&p, &q, sizeof p) || memcmp(i, j, p.count * sizeof *i) ||
                     memcmp(v, w, p.count * sizeof *v) || (size_t)p.count > width;
    }
    CHECK(different == 0);
}

/* Finds feet by kept triangles and by every pair: they are the same. */
static void check_pairs(struct contact_search *kept, struct contact_search *all)
{
    REQUIRE(contact_search_find(kept, place[0]) == STATUS_OK);
    REQUIRE(contact_search_find_all(all, place[0]) == STATUS_OK);
    check_same(kept, all);
}

/* What a foot is: where its weights say, D along the normal from the sample, not beside
 * it along the sheet. */
static void check_feet(const struct contact_search *s, int sheets)
{
    const struct contact_surface *f = s->sheet.surface;
    int wrong = 0;

    for (int n = 0; n < s->count; n++) {
        const struct contact_foot *foot = &s->foot[n];
        double y[3], sum = 0;
        contact_surface_at(f, foot->sample, place[0], y);
        for (int k = 0; k < foot->count; k++) {
            sum += s->weight[foot->first + k];
            for (int i = 0; i < 3; i++)
                y[i] -= s->weight[foot->first + k] * place[s->node[foot->first + k]][i];
        }
        for (int i = 0; i < 3; i++)
            y[i] -= foot->distance * foot->normal[i];
        const bool grid = f->line[0];
        const double du = foot->u - (grid ? f->line[0][foot->sample / f->points[1]]
                                          : f->mesh.at[foot->sample][0]);
        const double dv = foot->v - (grid ? f->line[1][foot->sample % f->points[1]]
                                          : f->mesh.at[foot->sample][1]);
        wrong += !(fabs(sum - 1) < rounding) || !(vector_length(y) < rounding) ||
                 !(fabs(vector_length(foot->normal) - 1) < rounding) ||
                 (sheets == 1 && !(sqrt(du * du + dv * dv) > 0.25 * turn * start * 0.8)) ||
                 !(foot->distance >= 0 && foot->distance < start);
        if (n > 0 && foot->sample <= foot[-1].sample)
            wrong += foot->sample < foot[-1].sample ||
                     (n > 1 && foot->sample == foot[-2].sample);
    }
    CHECK(wrong == 0);
}

/* While sheets move bit by bit, what is found with kept triangles is what every pair says,
 * at any number of threads: each shape as one sheet, and the crumpled one as several, which
 * then lie through each other. */
static void test_every_pair(void)
{
    enum { CALLS = 9, MOST = SHAPES + 3 };

    for (int k = 0; k < (meshed ? SHAPES : MOST); k++) {
        const struct shape *shape = &shapes[k < SHAPES ? k : CRUMPLED];
        const int sheets = k < SHAPES ? 1 : 2 + 3 * (k - SHAPES),
                  n[2] = {25 / sheets * sheets, 21};
        struct contact_search kept, all;
        open_sheets(sheets, 1, n, &surface, &kept);
        REQUIRE(contact_search_init(&all, &surface, start) == STATUS_OK);
        shape_net(shape, n);
        for (int call = 0; call < CALLS; call++) {
            omp_set_num_threads(1 + call % 4);
            check_pairs(&kept, &all);
            check_feet(&kept, sheets);
            if (call == 0 && sheets == 1)
                CHECK(kept.count >= shape->least && kept.count <= shape->most);
            CHECK(sheets == 1 || kept.count > n[0] * n[1] / 8);
            for (int p = 0; p < n[0] * n[1]; p++)
                for (int i = 0; i < 3; i++)
                    place[p][i] += 0.1 + (call < CALLS * 2 / 3 ? 0.02 : 0.2) * start *
                                             sin(3 * place[p][(i + 1) % 3] + 5 * i + call);
        }
        CHECK(kept.sought <= 16);
        contact_search_clear(&all);
        close_search(&surface, &kept);
    }
}

/* The involute by an interpolating polynomial in u, at Chebyshev's points, and lines along
 * v: a smooth surface. */
enum { ORDER = 64 };
static int smooth_row(const void *self, double u, double v, int *node, double *shape)
{
    double sum = 0;
    int exact = -1;

    (void)self;
    for (int k = 0; k < ORDER; k++) {
        const double way = u - (1 - cos(turn / 2 * k / (ORDER - 1))) / 2;
        const double weight = (k % 2 ? -1 : 1) * (k == 0 || k == ORDER - 1 ? 0.5 : 1);
        node[2 * k] = 2 * k, node[2 * k + 1] = 2 * k + 1;
        shape[2 * k] = weight / way;
        sum += weight / way;
        exact = way == 0 ? k : exact;
    }
    for (int k = 0; k < ORDER; k++) {
        const double share = exact < 0 ? shape[2 * k] / sum : k == exact;
        shape[2 * k] = (1 - v) * share, shape[2 * k + 1] = v * share;
    }
    return 2 * ORDER;
}

/* Compares feet with the closed form: the involute's turns have common normals. Returns the
 * largest errors of distance over start and of the normal, where there are turns on both
 * sides. */
static void compare_rolled(const struct contact_search *s, double *distance, double *normal)
{
    const double a = 0.7 * start / turn;
    int compared = 0;

    *distance = *normal = 0;
    for (int n = 0; n < s->count; n++) {
        const struct contact_foot *foot = &s->foot[n];
        const struct contact_surface *f = s->sheet.surface;
        const double u = f->line[0][foot->sample / f->points[1]];
        const double angle = sqrt(2 * (u + inner) / a);
        const double along = foot->normal[0] * cos(angle) + foot->normal[2] * sin(angle);
        if (foot->u < 0.02 || foot->u > 0.98)
            continue;
        *distance = fmax(*distance, fabs(foot->distance / start - 0.7));
        *normal = fmax(*normal, fabs(along));
        compared++;
    }
    CHECK(compared > s->sheet.surface->count);
}

/* A curve through itself and back, in loops as tight as contact is wide. */
static void place_looped(double phase)
{
    for (int k = 0; k < 2 * ORDER; k++) {
        const double u = (1 - cos(turn / 2 * (k / 2) / (ORDER - 1))) / 2;
        place[k][0] = 0.03 * sin(turn * 5 * u) + 0.01 * u, place[k][1] = k % 2;
        place[k][2] = 0.012 * sin(turn * 8.3 * u + phase);
    }
}

/* Errors of interpolation by polynomials of order 64 and of differences, seen
 * 3e-7. */
static const double smooth_error = 1e-6;

static void test_smooth(void)
{
    const int n[2] = {64, 3};
    double distance, normal;

    for (int k = 0; k < 2 * ORDER; k++)
        rolled((1 - cos(turn / 2 * (k / 2) / (ORDER - 1))) / 2, k % 2, place[k]);
    open_smooth(n, smooth_row, 2 * ORDER, &surface, &search);
    REQUIRE(contact_search_find(&search, place[0]) == STATUS_OK);
    check_feet(&search, 1);
    compare_rolled(&search, &distance, &normal);
    CHECK_NEAR(distance, 0, smooth_error);
    CHECK_NEAR(normal, 0, smooth_error);
    place_looped(1);
    for (int points = 14; points < 40; points++) {
        const int few[2] = {points, 3};
        close_search(&surface, &search);
        open_smooth(few, smooth_row, 2 * ORDER, &surface, &search);
        REQUIRE(contact_search_find(&search, place[0]) == STATUS_OK);
        check_feet(&search, 1);
        CHECK(search.count > 50);
    }
    close_search(&surface, &search);
}

/* Feet that come and go while loops change their shape do so by their share in the law,
 * inside a bend about the sample, too. (At the phase 2.42 a sample has the same foot on
 * both sides, one of which leaps to another layer.) */
static void test_loops(void)
{
    enum { STEPS = 70, POINTS = 40 };
    static double share[2][2 * 3 * POINTS];
    const double step = 1e-5;
    double most = 0;

    open_smooth((const int[]){POINTS, 3}, smooth_row, 2 * ORDER, &surface, &search);
    for (int n = 0; n < STEPS; n++) {
        for (int side = 0; side < 2; side++) {
            memset(share[side], 0, sizeof share[side]);
            place_looped(1 + 0.02 * n + side * step);
            REQUIRE(contact_search_find(&search, place[0]) == STATUS_OK);
            for (int k = 0; k < search.count; k++)
                share[side][2 * search.foot[k].sample + search.foot[k].side] =
                    search.foot[k].strength * (1 - search.foot[k].distance / start);
        }
        for (int k = 0; k < 2 * 3 * POINTS; k++)
            most = fmax(most, fabs(share[1][k] - share[0][k]));
    }
    CHECK(most < 0.05);
    close_search(&surface, &search);
}

/* Two sheets: an arc about y = place[3], whose axes are place[0..2], and a patch about
 * place[4]. They begin and end at u = arc_end and patch_begin. */
static double arc_end, patch_begin;
static int bend_row(const void *self, double u, double v, int *node, double *shape)
{
    const bool patch = u > arc_end;
    const double angle = 2.8 * (u / arc_end - 0.5);
    const double arc[] = {cos(angle), sin(angle), v, 1};
    const double flat[] = {1, (u - patch_begin) / (1 - patch_begin) - 0.5, v - 0.5};

    (void)self;
    for (int k = 0; k < 4 - patch; k++)
        node[k] = 4 * patch + k, shape[k] = patch ? flat[k] : arc[k];
    return 4 - patch;
}

/* Computes the force by the law on a sample at (r, angle) inside that arc of a radius;
 * *slope is the law's, if it is not NULL. */
static void press_inside(struct contact_search *s, int sample, double bend, double r,
                         double angle, double force[3], double *slope)
{
    const struct contact_law law = {.start = start, .range = start / 2, .stiffness = 1};

    place[0][0] = place[1][2] = bend;
    place[4][0] = r * cos(angle), place[4][2] = r * sin(angle);
    REQUIRE(contact_search_find(s, place[0]) == STATUS_OK);
    memset(force, 0, 3 * sizeof *force);
    for (const struct contact_foot *f = s->foot; f < s->foot + s->count; f++)
        for (int i = 0; i < 3 && f->sample == sample; i++)
            force[i] += f->strength * f->normal[i] *
                        contact_law_pressure(&law, f->distance, i ? NULL : slope);
}

/* A sample moves inside a bend about it, where the foot turns the faster the nearer it is
 * to the middle: by that the force changes no faster than twice the law along, and than the
 * law across. */
static void test_bend(void)
{
    enum { ROWS = 16, SAMPLE = (ROWS + ROWS / 2) * 3 + 1 };
    const int n[2] = {2 * ROWS, 3};
    const double nearer = 1e-5 * start;
    double along = 0, across = 0, least = INFINITY, most = 0;
    struct scene scene;

    REQUIRE(scene_init(&scene) == STATUS_OK);
    scene.sheets = 2, scene.length = scene.width = 1, scene.pose[1] = scene.pose[0];
    arc_end = scene_sheet_u(&scene, 0, 1), patch_begin = scene_sheet_u(&scene, 1, 0);
    REQUIRE(contact_surface_init_even(&surface, &scene, NULL, bend_row, 4, 7, n) ==
            STATUS_OK);
    REQUIRE(contact_search_init(&search, &surface, start) == STATUS_OK);
    memset(place, 0, 7 * sizeof *place);
    place[2][1] = 1, place[3][1] = -0.5;
    place[5][2] = place[6][1] = 1e-3 * start;
    for (int k = 0; k < 400; k++) {
        const double bend = (0.6 + 0.1 * (k % 5)) * start, angle = 0.16 * (k / 80) - 0.32;
        const double r = bend * (0.01 + 0.02 * (k / 5 % 16));
        double force[3], other[3], slope = INFINITY;
        if (bend - r < 0.52 * start)
            continue; /* the law's wall */
        press_inside(&search, SAMPLE, bend, r + nearer, angle, other, NULL);
        press_inside(&search, SAMPLE, bend, r, angle, force, &slope);
        least = fmin(least, vector_length(force)), most = fmax(most, vector_length(force));
        vector_between(force, other, other);
        along = fmax(along, vector_length(other) / (nearer * slope));
        press_inside(&search, SAMPLE, bend, r, angle + nearer / r, other, NULL);
        vector_between(force, other, other);
        across = fmax(across, vector_length(other) / (nearer * slope));
    }
    printf("inside a bend: %.2f of the law's slope along, %.2f across\n", along, across);
    CHECK(along < 2 && across < 1 && along > 1 && least == 0 && most > 1);
    close_search(&surface, &search);
    scene_clear(&scene);
}

/* Two concentric arcs of a net, one turned by an angle and moved along the axis. */
static void place_arcs(int half, int m, double cell, double angle, double shift)
{
    for (int k = 0; k < 2 * half * m; k++) {
        const int i = k / m, in = i >= half;
        const double r = in ? 0.2 - 0.6 * start : 0.2;
        const double at = cell * (in ? 2 * half - 1 - i : i) + (in ? angle : 0);
        place[k][0] = r * cos(at), place[k][2] = r * sin(at);
        place[k][1] = cell * 0.2 * (k % m) + (in ? shift : 0);
    }
}

/* While one layer slides along another, hollow side and outer side, feet and normals move
 * as smoothly as it does. */
static void test_sliding(void)
{
    enum { HALF = 12, M = 6, STEPS = 600 };
    const int n[2] = {2 * HALF, M};
    const double cell = 0.1, step = 2 * cell / STEPS;
    static double normal[2 * HALF * M][3], at[2 * HALF * M][2];
    double turned = 0, moved = 0;
    long compared = 0;

    open_sheets(1, 1, n, &surface, &search);
    memset(at, 0, sizeof at);
    for (int k = 0; k <= STEPS; k++) {
        bool seen[2 * HALF * M] = {false};
        place_arcs(HALF, M, cell, k * step + 0.01, 0.2 * (k * step * 0.7 + 0.003));
        REQUIRE(contact_search_find(&search, place[0]) == STATUS_OK);
        for (int f = 0; f < search.count; f++) {
            const struct contact_foot *foot = &search.foot[f];
            const double u = foot->u * (2 * HALF - 1), v = foot->v * (M - 1);
            const int i = foot->sample / M, on = i < HALF ? i : 2 * HALF - 1 - i;
            double way[3];
            vector_between(normal[foot->sample], foot->normal, way);
            if (at[foot->sample][0] > 0 && on > 3 && on < HALF - 3) {
                turned = fmax(turned, vector_length(way));
                moved =
                    fmax(moved, hypot(u - at[foot->sample][0], v - at[foot->sample][1]));
                compared++;
            }
            memcpy(normal[foot->sample], foot->normal, sizeof way);
            at[foot->sample][0] = u, at[foot->sample][1] = v;
            seen[foot->sample] = true;
        }
        for (int p = 0; p < 2 * HALF * M; p++)
            at[p][0] = seen[p] ? at[p][0] : 0;
    }
    CHECK(compared > STEPS * HALF * M / 2);
    CHECK(turned < 20 * step); /* about the border; a face's edge would be 300 */
    CHECK(moved < 2 * step / cell);
    close_search(&surface, &search);
}

/* A card moves off the border of another, above it, until no place of that is near: what
 * presses on its samples changes evenly, by no more than at last, where the border is as
 * far as contact starts and comes nearer by the slope of the way to it. */
static void test_leaving(void)
{
    enum { ROWS = 5, M = 5, STEPS = 400 };
    const int n[2] = {2 * ROWS, M};
    const double side = 0.2, gap = 0.9 * start;
    const double most = sqrt(start * start - gap * gap) / (start - gap) / STEPS;
    double before = ROWS * M;

    open_sheets(2, side, n, &surface, &search);
    for (int k = 0; k <= STEPS; k++) {
        double all = 0;
        for (int p = 0; p < 2 * ROWS * M; p++) {
            place[p][0] = side * (p % (ROWS * M) / M) / (ROWS - 1.);
            place[p][1] =
                side * (p % M) / (M - 1.) + (p < ROWS * M ? 0 : k * start / STEPS);
            place[p][2] = p < ROWS * M ? 0 : gap;
        }
        REQUIRE(contact_search_find(&search, place[0]) == STATUS_OK);
        for (const struct contact_foot *f = search.foot; f < search.foot + search.count;
             f++)
            all += f->sample < ROWS * M ? 0 : f->strength;
        CHECK(all <= before + rounding && all >= before - ROWS * most);
        before = all;
    }
    CHECK(before == ROWS * (M - 1));
    close_search(&surface, &search);
}

/* Positions that are no numbers are said, and forgotten. */
static void test_not_a_number(void)
{
    const int n[2] = {20, 20};
    double share;

    open_sheets(1, 1, n, &surface, &search);
    shape_net(&shapes[1], n);
    REQUIRE(contact_search_find(&search, place[0]) == STATUS_OK);
    const int count = search.count;
    const double old = place[99][1];
    place[99][1] = NAN;
    CHECK(contact_search_find(&search, place[0]) == STATUS_NAN && search.count == 0);
    CHECK(contact_search_find_all(&search, place[0]) == STATUS_NAN);
    CHECK(contact_search_limit(&search, place[0], place[0], 0, 1, &share, NULL) ==
          STATUS_NAN);
    place[99][1] = old;
    REQUIRE(contact_search_find(&search, place[0]) == STATUS_OK);
    CHECK(count > 300 && search.count == count);
    close_search(&surface, &search);
}

/* Two layers with a wide loop between them. */
static void place_layers(const int n[2], double gap)
{
    for (int p = 0; p < n[0] * n[1]; p++) {
        const int i = p / n[1], up = i >= n[0] / 2, on = up ? n[0] - 1 - i : i;
        const bool loop = on == n[0] / 2 - 1;
        place[p][0] = 0.03 * on + (loop ? 0.1 : 0), place[p][1] = 0.05 * (p % n[1]);
        place[p][2] = (up - 0.5) * (loop ? 3 * start : gap);
    }
}

/* Layers come from afar, through each other, and leave again: feet are found from the start
 * of contact on, on either side, though triangles are seldom found again. */
static void test_approach(void)
{
    enum { STEPS = 80 };
    const int n[2] = {40, 20};
    const double step = 0.031 * start;

    open_sheets(1, 1, n, &surface, &search);
    for (int k = 0; k < 2 * STEPS; k++) {
        const double gap = 2.01 * start - (k < STEPS ? k : 2 * STEPS - k) * step;
        place_layers(n, gap);
        REQUIRE(contact_search_find(&search, place[0]) == STATUS_OK);
        CHECK(search.count == (gap < start ? n[1] * (n[0] - 2) : 0));
        CHECK_NEAR(search.count ? search.foot[99].distance : gap, fabs(gap), rounding);
    }
    CHECK(search.sought < STEPS);
    close_search(&surface, &search);
}

/* Two layers that come nearer: half of the gap over the wall is used up, to a
 * hundredth; a motion that both have is free. */
static void test_limit_of_layers(void)
{
    const int n[2] = {40, 20};
    const double wall = start / 2, gap = 0.8 * start - wall;

    open_sheets(1, 1, n, &surface, &search);
    place_layers(n, 0.8 * start);
    for (int k = 0; k < 5; k++) {
        const double closing = k * 0.4 * gap, want = fmin(1, 0.5 * gap / closing);
        for (int p = 0; p < n[0] * n[1]; p++) {
            const int up = p / n[1] >= n[0] / 2;
            change[p][0] = 5, change[p][1] = k, change[p][2] = 3 - up * closing;
        }
        const double share = limit(&search, place[0], change[0], wall);
        CHECK(share <= want + far_rounding && share >= 0.97 * want);
    }
    close_search(&surface, &search);
}

/* Changes at random, long and short, cut to their limits, one after the other: nothing ever
 * crosses, and nothing stops. */
static void test_limit(void)
{
    enum { ROUNDS = 60 };
    const int n[2] = {24, 20};
    const double near = 0.01; /* pairs that count are then all that share no corner */
    struct intersection work = {0};

    for (int k = 0; k < 4; k++) {
        double done = 0;
        long crossings = 0, cuts = 0;
        open_sheets(1, 1, n, &surface, &search);
        contact_search_clear(&search);
        REQUIRE(contact_search_init(&search, &surface, near) == STATUS_OK);
        shape_net(&shapes[k], n);
        for (int round = 0; round < ROUNDS; round++) {
            const double size = pow(10, -1 - round % 3), noise = k < 2 ? 0.3 : 0.05;
            for (int p = 0; p < n[0] * n[1]; p++)
                for (int i = 0; i < 3; i++)
                    change[p][i] = size * (sin(5 * place[p][(i + 1) % 3] + i + 7 * round) +
                                           noise * random_about_0());
            const double share = limit(&search, place[0], change[0], 0);
            for (int p = 0; p < n[0] * n[1]; p++)
                for (int i = 0; i < 3; i++)
                    place[p][i] += share * change[p][i];
            REQUIRE(intersection_count(&work, n[1], n[0], place[0], &crossings) ==
                    STATUS_OK);
            CHECK(crossings == 0);
            CHECK(share > 0);
            done += share * size, cuts += share < 1;
        }
        CHECK(cuts > ROUNDS / 4 && done > 0.01);
        close_search(&surface, &search);
    }
    intersection_clear(&work);
}

/* Sheets far from each other have the feet and limits that each has alone, to the bit. */
static void test_sheets_alone(void)
{
    enum { ROWS = 25, M = 21, COUNT = ROWS * M, SHEETS = 3 };
    static double at[COUNT][3];
    const int n[2] = {SHEETS * ROWS, M}, one[2] = {ROWS, M};
    struct contact_surface lone;
    struct contact_search all, alone;
    double least = 1;
    int first = 0;

    open_sheets(SHEETS, 1, n, &surface, &all);
    open_sheets(1, 1, one, &lone, &alone);
    for (int k = 0; k < SHEETS; k++)
        for (int p = 0; p < COUNT; p++) {
            double *x = place[k * COUNT + p];
            shapes[2 + k].point(p / M / (ROWS - 1.), p % M / (M - 1.), x);
            for (int i = 0; i < 3; i++)
                x[i] += 32 * k, change[k * COUNT + p][i] = 0.05 * random_about_0();
        }
    REQUIRE(contact_search_find(&all, place[0]) == STATUS_OK);
    for (int k = 0; k < SHEETS; k++) {
        memcpy(at, place + k * COUNT, sizeof at);
        REQUIRE(contact_search_find(&alone, at[0]) == STATUS_OK);
        for (int f = 0; f < alone.count && first + f < all.count; f++) {
            const struct contact_foot *a = &all.foot[first + f], *b = &alone.foot[f];
            CHECK(a->sample == b->sample + k * COUNT && a->distance == b->distance);
            CHECK(!memcmp(a->normal, b->normal, sizeof a->normal) && a->v == b->v);
            CHECK_NEAR(a->strength, b->strength, far_rounding);
        }
        first += alone.count;
        least = fmin(least, limit(&alone, at[0], change[k * COUNT], 0));
    }
    CHECK(first == all.count && least < 1);
    CHECK(limit(&all, place[0], change[0], 0) == least);
    close_search(&surface, &all);
    close_search(&lone, &alone);
}

/* As one mesh, two sheets are joined by triangles that are far from all. A sheet comes to
 * the other side of a sample within the margin: through it, where cells are so wide that
 * nothing turns, or because the sample's neighbours turn its normal, where they are so near
 * that little turns it far. What is known of sides keeps neither out. */
static void test_sides(void)
{
    enum { ROWS = 12, M = 9, I = 5, J = 4 };
    static const struct {
        double cell, at[3], row[3], column[3]; /* of the lower sheet; the upper one [m] */
        double through, turn; /* way of each sheet, of the sample's neighbours [m]      */
    } cases[] = {{0.2, {-0.011, -0.008, 0.004}, {0.002, 0, 0}, {0, 0.002, 0}, 0.0026, 0},
                 {5e-4, {0.01, -0.004, 0.002}, {0, 0, 0.001}, {0, 0.001, 0}, 0, 9e-4}};
    const int n[2] = {2 * ROWS, M};

    for (int k = 0; k < 2; k++) {
        struct contact_search kept, all;
        open_sheets(meshed ? 1 : 2, start / 4, n, &surface, &kept);
        contact_search_clear(&kept);
        for (int p = ROWS * M; meshed && p < 2 * ROWS * M; p++)
            mesh.flat.at[p][0] += 1;
        REQUIRE(contact_search_init(&kept, &surface, start) == STATUS_OK);
        REQUIRE(contact_search_init(&all, &surface, start) == STATUS_OK);
        for (int p = 0; p < 2 * ROWS * M; p++) {
            const int i = p / M % ROWS, j = p % M;
            const double lower[] = {(i - I) * cases[k].cell, (j - J) * cases[k].cell, 0};
            for (int x = 0; x < 3; x++)
                place[p][x] = p < ROWS * M ? lower[x]
                                           : cases[k].at[x] + i * cases[k].row[x] +
                                                 j * cases[k].column[x];
            if (meshed && (p / M == ROWS - 1 || p / M == ROWS)) /* joined, far away */
                place[p][0] = 1000, place[p][2] = p / M == ROWS ? 100 : -100;
        }
        for (int side = 0; side < 2; side++) {
            int f = 0;
            check_pairs(&kept, &all);
            while (f < all.count && all.foot[f].sample != I * M + J)
                f++;
            CHECK(f < all.count && all.foot[f].side == side);
            for (int p = 0; p < 2 * ROWS * M; p++)
                place[p][2] += (p < ROWS * M ? 1 : -1) * cases[k].through;
            for (int j = 0; j < M; j++)
                place[(I - 1) * M + j][2] -= cases[k].turn,
                    place[(I + 1) * M + j][2] += cases[k].turn;
        }
        CHECK(kept.sought == 1);
        contact_search_clear(&all);
        close_search(&surface, &kept);
    }
}

/* A pattern's points where a function has them, and nothing of it elsewhere. */
static void shape_mesh(void (*shape)(double u, double v, double x[3]))
{
    REQUIRE(mesh.vertices < POINTS_MAX);
    for (int a = 0; a < mesh.vertices; a++)
        shape(mesh.flat.at[a][0], mesh.flat.at[a][1], place[a]);
}

/* Two flat prongs that lie on each other, where the pattern has nothing between them. */
static void forked(double u, double v, double x[3])
{
    const double t = fmin(fmax((u - 0.45) / 0.1, 0), 1);

    x[0] = u - 0.2 * t, x[1] = v, x[2] = 0.8 * start * t;
}

/* The tree without what leaves flat parts out. */
static void open_all(struct contact_search *s)
{
    for (int n = 0; n < s->tree.patches.start[s->tree.levels - 1] + 1; n++)
        s->tree.patches.convex[n] = false;
}

static enum status count_pair(struct contact_tree_search *s, int cell, int other)
{
    (void)cell, (void)other;
    ++*(long *)s->context;
    return STATUS_OK;
}

/* Outlines, with what of them lies flat and far from corners to the inside left out. */
static const struct {
    double line[64];
    bool convex;
} patterns[] = {
    {{0, 0, 1, 0, 1, 1, 0, 1, INFINITY, INFINITY}, true},
    {{1, .5, .85, .85, .5, 1, .15, .85, 0, .5, .15, .15, .5, 0, .85, .15, INFINITY,
      INFINITY},
     true},
    {{0,  0,  1,        0,  .8, 1,  .3, 1,  INFINITY, .3, .2, .5,       .3,
      .3, .5, INFINITY, .6, .5, .7, .5, .7, .9,       .6, .9, INFINITY, INFINITY},
     false},
    {{0, 0, 1, 0, 1, 1, .55, 1, .55, .3, .45, .3, .45, 1, 0, 1, INFINITY, INFINITY},
     false}};

/* Feet and limits on meshes of all kinds of outlines, bent to all shapes, are those that
 * every pair says, and those without what leaves flat parts out, which does so, though. */
static void test_patterns(void)
{
    void (*const shape[])(double, double, double *) = {flat, folded, crumpled, forked};

    for (int k = 0; k < 16; k++) {
        struct contact_search kept, all;
        struct scene scene;
        long pairs = 0;
        struct contact_tree_search visit = {1.3 * start, 0, &pairs, count_pair};
        REQUIRE(scene_init(&scene) == STATUS_OK);
        surface_of_lines(&scene, patterns[k / 4].line, (int[]){31, 31}, k + 1, &mesh,
                         &surface);
        REQUIRE(contact_search_init(&kept, &surface, start) == STATUS_OK);
        REQUIRE(contact_search_init(&all, &surface, start) == STATUS_OK);
        open_all(&all);
        shape_mesh(shape[k % 4]);
        for (int p = 0; p < 3 * mesh.vertices; p++)
            change[p / 3][p % 3] = 0.02 * random_about_0();
        for (int call = 0; call < 3; call++) {
            omp_set_num_threads(1 + call);
            check_pairs(&kept, &all);
            check_feet(&kept, 1);
            for (int p = 0; p < 3 * mesh.vertices; p++)
                place[p / 3][p % 3] += 0.1 * start * sin(7. * p + call);
        }
        CHECK(k % 4 ? kept.count > 50 : kept.count == 0);
        const double share = limit(&kept, place[0], change[0], 0);
        CHECK(share == limit(&all, place[0], change[0], 0));
        CHECK(share > 0 && (share < 1 || k % 4 == 0));
        shape_mesh(flat);
        contact_tree_fit(&kept.tree, place[0], NULL);
        REQUIRE(contact_tree_visit(&kept.tree, &visit) == STATUS_OK);
        CHECK(patterns[k / 4].convex ? pairs == 0 : pairs < 4L * mesh.flat.triangles);
        contact_search_clear(&all);
        close_search(&surface, &kept);
        scene_clear(&scene);
    }
}

int main(void)
{
    test_patterns();
    meshed = true;
    test_sides();
    test_every_pair();
    test_sliding();
    test_approach();
    test_limit_of_layers();
    test_limit();
    meshed = false;
    test_sides();
    test_sheets_alone();
    test_every_pair();
    test_smooth();
    test_loops();
    test_bend();
    test_sliding();
    test_leaving();
    test_not_a_number();
    test_approach();
    test_limit_of_layers();
    test_limit();
    return check_result();
}
