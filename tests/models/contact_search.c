/* Feet of a sheet on itself: kept triangles against every pair, geometry against closed
 * forms, and steps that never let a sheet through itself. */
#include "models/contact/contact_search.h"

#include <omp.h>
#include <stdint.h>

#include "models/metric/intersection.h"
#include "models/vector.h"
#include "tests/check.h"

/* Sums of a few products of numbers near 1. */
static const double rounding = 1e-14;
static const double turn = 6.283185307179586;

enum { SIDE_MAX = 64, POINTS_MAX = SIDE_MAX * SIDE_MAX };
static double place[POINTS_MAX][3], change[POINTS_MAX][3];
static uint64_t state = 20261127;

/* [-1, 1); xorshift64* */
static double random_about_0(void)
{
    state ^= state >> 12, state ^= state << 25, state ^= state >> 27;
    return (double)(state * 2685821657736338717u >> 11) * 0x1p-52 - 1;
}

/* A net of n[0] x n[1] points on a unit square. */
static int net_row(const void *self, double u, double v, int *node, double *shape)
{
    const int *n = self;

    node[0] = (int)lround(u * (n[0] - 1)) * n[1] + (int)lround(v * (n[1] - 1));
    shape[0] = 1;
    return 1;
}

static void make_surface(struct contact_surface *s, const int points[2], const void *self,
                         contact_row *row, int width, int nodes)
{
    double line[2][SIDE_MAX];
    struct scene scene;

    for (int d = 0; d < 2; d++)
        for (int i = 0; i < points[d]; i++)
            line[d][i] = i / (points[d] - 1.);
    REQUIRE(scene_init(&scene) == STATUS_OK);
    scene.length = scene.width = 1;
    REQUIRE(contact_surface_init(s, &scene, self, row, width, nodes,
                                 (const double *const[]){line[0], line[1]},
                                 points) == STATUS_OK);
    scene_clear(&scene);
}

/* The shapes of a unit square; contact starts at the distance `start`. */
static const double start = 0.02, radius = 0.05, inner = 0.1;

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
    int least, most; /* feet of 33 x 29 points                                        */
} shapes[] = {{"flat", flat, 0, 0},
              {"folded", folded, 900, 957},
              {"rolled", rolled, 1200, 1914},
              {"helicoid", helicoid, 957, 1914},
              {"crumpled", crumpled, 500, 1914},
              {"doubled", doubled, 900, 957},
              {"needle", needle, 0, 1914},
              {"point", point, 0, 1914}};
enum { SHAPES = sizeof shapes / sizeof *shapes };

static void shape_net(const struct shape *shape, const int n[2])
{
    for (int k = 0; k < n[0] * n[1]; k++)
        shape->point(k / n[1] / (n[0] - 1.), k % n[1] / (n[1] - 1.), place[k]);
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

/* What a foot is: where its weights say, D along the normal from the sample, not beside
 * it along the sheet. */
static void check_feet(const struct contact_search *s)
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
        const double du = foot->u - f->line[0][foot->sample / f->points[1]];
        const double dv = foot->v - f->line[1][foot->sample % f->points[1]];
        wrong += !(fabs(sum - 1) < rounding) || !(vector_length(y) < rounding) ||
                 !(fabs(vector_length(foot->normal) - 1) < rounding) ||
                 !(sqrt(du * du + dv * dv) > 0.25 * turn * start * 0.8) ||
                 !(foot->distance >= 0 && foot->distance < start);
        if (n > 0 && foot->sample <= foot[-1].sample)
            wrong += foot->sample < foot[-1].sample ||
                     (n > 1 && foot->sample == foot[-2].sample);
    }
    CHECK(wrong == 0);
}

/* While the sheet moves bit by bit, what is found with kept triangles is what every pair
 * says, at any number of threads. */
static void test_every_pair(void)
{
    enum { CALLS = 12 };
    const int n[2] = {33, 29};
    struct contact_surface surface;

    make_surface(&surface, n, n, net_row, 1, n[0] * n[1]);
    for (int k = 0; k < SHAPES; k++) {
        struct contact_search kept, all;
        int least = 1 << 30, most = 0;
        REQUIRE(contact_search_init(&kept, &surface, start) == STATUS_OK);
        REQUIRE(contact_search_init(&all, &surface, start) == STATUS_OK);
        shape_net(&shapes[k], n);
        for (int call = 0; call < CALLS; call++) {
            omp_set_num_threads(1 + call % 4);
            REQUIRE(contact_search_find(&kept, place[0]) == STATUS_OK);
            REQUIRE(contact_search_find_all(&all, place[0]) == STATUS_OK);
            check_same(&kept, &all);
            check_feet(&kept);
            if (call == 0)
                CHECK(kept.count >= shapes[k].least && kept.count <= shapes[k].most);
            least = least < kept.count ? least : kept.count;
            most = most > kept.count ? most : kept.count;
            for (int p = 0; p < n[0] * n[1]; p++)
                for (int i = 0; i < 3; i++)
                    place[p][i] += 0.1 + (call < CALLS * 2 / 3 ? 0.02 : 0.2) * start *
                                             sin(3 * place[p][(i + 1) % 3] + 5 * i + call);
        }
        if (0)
            printf("%s: %d to %d feet, sought %ld times\n", shapes[k].name, least, most,
                   kept.sought);
        CHECK(kept.sought <= 16);
        contact_search_clear(&kept);
        contact_search_clear(&all);
    }
    contact_surface_clear(&surface);
}

int main(void)
{
    test_every_pair();
    (void)change;
    return check_result();
}
