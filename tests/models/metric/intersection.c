/* Self-intersections of grids: pairs against exact linear programming, the tree against
 * every pair. Counts: no tolerances. */
#include "models/metric/intersection.h"

#include <omp.h>

#include "models/grid.h"
#include "models/metric/metric.h"
#include "models/metric/triangle.h"
#include "tests/check.h"
#include "tests/noise.h"
#include "tests/triangle_reference.h"

enum { POINTS_MAX = 64 * 64 };
static double xyz[POINTS_MAX][3];
static struct intersection work;

static long count(int n_u, int n_v)
{
    long pairs;
    CHECK(intersection_count(&work, n_u, n_v, xyz[0], &pairs) == STATUS_OK);
    return pairs;
}

/* Tells whether two triangles of the last count of `s` meet where they should not. */
static bool meet(const struct intersection *s, int first, int second)
{
    int a[3], b[3], shared = 0;
    const double *p[3], *q[3];

    REQUIRE(intersection_triangle(s, first, a) && intersection_triangle(s, second, b));
    for (int i = 0; i < 3; i++)
        for (int j = shared; j < 3; j++)
            if (a[i] == b[j]) { /* shared corners come first, in the same order */
                const int same = a[i];
                a[i] = a[shared], a[shared] = same;
                b[j] = b[shared], b[shared++] = same;
                break;
            }
    for (int i = 0; i < 3; i++)
        p[i] = s->point + 3L * a[i], q[i] = s->point + 3L * b[i];
    return shared == 2   ? triangle_meets_beyond_edge(p, q)
           : shared == 1 ? triangle_meets_beyond_vertex(p, q)
                         : triangle_meets(p, q);
}

/* Counts by testing every pair. */
static long count_all(int n_u, int n_v)
{
    struct intersection own = {0};
    long ignored, pairs = 0;

    CHECK(intersection_count(&own, n_u, n_v, xyz[0], &ignored) == STATUS_OK);
    for (int p = 0; p < own.triangles; p++)
        for (int q = p + 1; q < own.triangles; q++)
            pairs += meet(&own, p, q);
    intersection_clear(&own);
    return pairs;
}

static void test_flat(void)
{
    int corner[3];

    intersection_corners(50, 1, corner); /* beyond the diagonal of the first cell */
    CHECK(corner[0] == 0 && corner[1] == 51 && corner[2] == 50);
    for (int j = 0; j < 40; j++)
        for (int i = 0; i < 50; i++) {
            double *x = xyz[j * 50 + i];
            x[0] = 0.3 * i - 0.7 * j, x[1] = 0.1 * i + 0.2 * j, x[2] = 0.5 * i + 0.9 * j;
        }
    CHECK(count(50, 40) == 0);
    CHECK(work.tests < 50 * 40 * 60); /* the tree leaves little more than neighbours */
    for (int n = 0; n < 2000; n++)
        xyz[n][2] = 0;
    CHECK(count(50, 40) == 0);
    /* the sheet drawn out to a needle, still flat and of one side */
    for (int n = 0; n < 2000; n++)
        xyz[n][1] = ldexp(xyz[n][1], -60);
    CHECK(count(50, 40) == 0);
}

/* Are two triangles a pair by linear programming? Corners that both have come first. */
static bool reference_pair(int n_u, const int (*x)[3], int first, int second)
{
    int a[3], b[3], p[3][3], q[3][3], shared = 0;

    intersection_corners(n_u, first, a), intersection_corners(n_u, second, b);
    for (int k = 0; k < 9; k++)
        if (k / 3 >= shared && k % 3 >= shared && a[k / 3] == b[k % 3]) {
            const int common = a[k / 3];
            a[k / 3] = a[shared], b[k % 3] = b[shared];
            a[shared] = b[shared] = common;
            shared++;
        }
    for (int i = 0; i < 3; i++) {
        memcpy(p[i], x[a[i]], sizeof p[i]);
        memcpy(q[i], x[b[i]], sizeof q[i]);
    }
    return reference_meets(p, q, shared);
}

/* Small integers: much touches, lies in one plane or has no area. The same pairs at heights
 * of 2^-240 of the widths; of 2^-300, which nothing is told from 0, those of the flat
 * sheet. */
static void test_reference(void)
{
    enum { N = 5, M = 4, TRIANGLES = 2 * (N - 1) * (M - 1) };
    int x[N * M][3];

    work.keep_pairs = true;
    for (int n = 0; n < 60; n++) {
        const int size = 1 + n % 4, spread = n % 3, height = n / 20;
        long next = 0;
        for (int p = 0; p < N * M; p++)
            for (int c = 0; c < 3; c++) {
                x[p][c] = (int)(noise_unit() * (2 * size + 1)) - size;
                if (spread && c < 2)
                    x[p][c] += spread * (c ? p / 5 : p % 5) * size;
                if (n % 5 == 4 && c == 2)
                    x[p][c] = 0;
                xyz[p][c] = c < 2 || !height ? x[p][c] : ldexp(x[p][c], -180 - 60 * height);
                if (height == 2 && c == 2)
                    x[p][c] = 0;
            }
        const long pairs = count(N, M);
        for (int t = 0; t < TRIANGLES * TRIANGLES; t++) {
            const int first = t / TRIANGLES, second = t % TRIANGLES;
            if (first >= second || !reference_pair(N, (const int(*)[3])x, first, second))
                continue;
            CHECK(next < pairs && work.pairs[next].first == first &&
                  work.pairs[next].second == second);
            next++;
        }
        CHECK(next == pairs && work.pair_count == pairs);
    }
    work.keep_pairs = false;
    count(N, M);
    CHECK(work.pair_count == 0);
}

/* A sheet shaken by `noise` cells. */
static void crumple(int n_u, int n_v, double noise)
{
    for (int j = 0; j < n_v; j++)
        for (int i = 0; i < n_u; i++) {
            double *x = xyz[j * n_u + i];
            x[0] = i + noise * (noise_unit() - 0.5);
            x[1] = j + noise * (noise_unit() - 0.5);
            x[2] = 4 * sin(0.5 * i) + noise * (noise_unit() - 0.5);
        }
}

static void transpose(int n_u, int n_v)
{
    static double old[POINTS_MAX][3];

    memcpy(old, xyz, sizeof old);
    for (int j = 0; j < n_v; j++)
        for (int i = 0; i < n_u; i++)
            memcpy(xyz[i * n_v + j], old[j * n_u + i], sizeof *xyz);
}

static void test_crumpled(void)
{
    static const int size[][2] = {{2, 30}, {17, 13}, {33, 9}, {28, 28}};
    long most = 0;

    for (int n = 0; n < 24; n++) {
        int n_u = size[n % 4][0], n_v = size[n % 4][1];
        crumple(n_u, n_v, 1.5 * (1 + n / 4));
        long pairs = count(n_u, n_v);
        CHECK(pairs == count_all(n_u, n_v));
        most = pairs > most ? pairs : most;
        transpose(n_u, n_v);
        CHECK(count(n_v, n_u) == pairs);
        for (int p = 0; p < n_u * n_v; p++) { /* another axis up, other units */
            double *x = xyz[p], z = x[2];
            x[2] = ldexp(x[1], 900), x[1] = ldexp(x[0], 900), x[0] = ldexp(z, 900);
        }
        CHECK(count(n_v, n_u) == pairs);
    }
    CHECK(most > 1000);
}

/* More candidates than are tested at a time; one to four threads; pairs in order. */
static void test_threads(void)
{
    struct intersection other = {.keep_pairs = true};
    long pairs, again;

    crumple(48, 48, 40);
    work.keep_pairs = true;
    omp_set_num_threads(1);
    pairs = count(48, 48);
    CHECK(work.tests > 1000000 && pairs == work.pair_count && pairs == count_all(48, 48));
    for (long n = 1; n < pairs; n++) {
        struct intersection_pair p = work.pairs[n - 1], q = work.pairs[n];
        if (!CHECK(p.first < q.first || (p.first == q.first && p.second < q.second)))
            break;
    }
    for (int threads = 2; threads <= 4; threads++) {
        omp_set_num_threads(threads);
        REQUIRE(intersection_count(&other, 48, 48, xyz[0], &again) == STATUS_OK);
        CHECK(again == pairs && other.tests == work.tests);
        CHECK(!memcmp(other.pairs, work.pairs, pairs * sizeof *work.pairs));
    }
    intersection_clear(&other);
    work.keep_pairs = false;
}

/* Points that are no numbers, and work that is used again for another grid. */
static void test_reuse(void)
{
    static const double bad[] = {NAN, INFINITY, -INFINITY};
    static const struct intersection zero;
    struct intersection s = {0};
    long pairs;

    crumple(6, 6, 0.1);
    for (int n = 0; n < 3; n++) {
        const double kept = xyz[35 - n][n];
        xyz[35 - n][n] = bad[n];
        CHECK(intersection_count(&work, 6, 6, xyz[0], &pairs) == STATUS_NAN && pairs == -1);
        xyz[35 - n][n] = kept;
    }
    CHECK(count(6, 6) == 0);
    crumple(40, 40, 3);
    CHECK(intersection_count(&s, 40, 40, xyz[0], &pairs) == STATUS_OK);
    const double *point = s.point;
    const long small = count_all(11, 31);
    CHECK(intersection_count(&s, 11, 31, xyz[0], &pairs) == STATUS_OK);
    CHECK(pairs == small && s.point == point);
    intersection_clear(&s);
    CHECK(!memcmp(&s, &zero, sizeof s));
}

/* A sheet wound up in itself: every point of its mid-surface, and every third, by hand. */
static void test_every(int step)
{
    static double field[3 * GRID_POINTS], surface[GRID_POINTS][3];
    const int side = (GRID_U - 1) / step + 1;
    const struct scene scene = {.sheets = 1};
    long count = 0;

    for (int n = 0; n < GRID_POINTS; n++) {
        double u = n % GRID_U / 99.0, v = n / GRID_U % GRID_V / 99.0;
        field[3 * n] = sin(7 * u + 2 * v), field[3 * n + 1] = sin(5 * v - u);
        field[3 * n + 2] = u * v + 0.01 * (n / (GRID_U * GRID_V));
    }
    for (int n = 0; n < 3 * side * side; n++) {
        int m = step * (n / 3 / side * GRID_U + n / 3 % side) * 3 + n % 3;
        surface[n / 3][n % 3] = 0.5 * (field[m] + field[m + 3 * GRID_POINTS / 2]);
    }
    CHECK(intersection_count(&work, side, side, surface[0], &count) == STATUS_OK);
    CHECK(count > 10);
    CHECK(metric_intersections_every(&scene, field, step) == (double)count);
    CHECK(step > 1 || metric_intersections(&scene, field) == (double)count);
    field[3 * GRID_POINTS - 1] = NAN;
    CHECK(isnan(metric_intersections_every(&scene, field, step)));
}

int main(void)
{
    test_flat();
    test_reference();
    test_crumpled();
    test_threads();
    test_reuse();
    test_every(1);
    test_every(3);
    intersection_clear(&work);
    return check_result();
}
