#include "bench/speed/bench_intersection.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "models/clock.h"
#include "models/grid.h"
#include "models/metric/intersection.h"

enum { REPEATS = 15 };

static const double turn = 6.283185307179586;

/* Tilted, so that no coordinate is constant. */
static void flat(double u, double v, double x[3])
{
    x[0] = 0.6 * u - 0.48 * v, x[1] = 0.8 * u + 0.36 * v, x[2] = 0.8 * v;
}

/* Hangs from a middle disc of radius 0.3 in eight folds. */
static void draped(double u, double v, double x[3])
{
    double a = u - 0.5, b = v - 0.5, radius = hypot(a, b), angle = atan2(b, a);
    double below = fmax(radius - 0.3, 0);
    double out = fmin(radius, 0.3) + below * (0.3 + 0.25 * cos(8 * angle));

    x[0] = out * cos(angle), x[1] = out * sin(angle);
    x[2] = -sqrt(0.9) * below;
}

/* Rolled up two and a half times, 3 mm between turns. */
static void rolled(double u, double v, double x[3])
{
    double radius = 0.06 + 0.003 * 2.5 * u;
    x[0] = radius * cos(2.5 * turn * u), x[1] = v, x[2] = radius * sin(2.5 * turn * u);
}

/* Waves in three directions that fold the sheet through itself; amplitudes of 0.02 against
 * wave lengths of 0.08. */
static void folded(double u, double v, double x[3])
{
    x[0] = u + 0.02 * sin(turn * (9 * u + 7 * v) + 1) + 0.02 * sin(turn * (11 * v - 3 * u));
    x[1] = v + 0.02 * sin(turn * (8 * v - 9 * u) + 2) + 0.02 * sin(turn * 12 * u);
    x[2] = 0.02 * sin(turn * (10 * u + 2 * v)) + 0.02 * sin(turn * (9 * v - 5 * u) + 3);
}

/* Noise of three grid steps: no triangle is clear of its surroundings. */
static void crumpled(double u, double v, double x[3])
{
    uint64_t state = 1 + lround(u * 99) + 100 * lround(v * 99);

    x[0] = u, x[1] = v, x[2] = 0;
    for (int c = 0; c < 3; c++) {
        /* splitmix64 */
        uint64_t z = state * 3 + c + 1;
        z *= 0x9e3779b97f4a7c15u;
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
        z = (z ^ z >> 27) * 0x94d049bb133111ebu;
        x[c] += 0.03 * ((double)((z ^ z >> 31) >> 11) * 0x1p-53 - 0.5);
    }
}

/* In half along v, the halves exactly on each other. */
static void doubled(double u, double v, double x[3])
{
    x[0] = u < 0.5 ? u : 1 - u, x[1] = v, x[2] = 0;
}

static const struct shape {
    const char *name;
    void (*point)(double u, double v, double x[3]);
} shapes[] = {
    {"flat", flat},     {"draped", draped},     {"rolled up", rolled},
    {"folded", folded}, {"crumpled", crumpled}, {"doubled", doubled},
};

struct cost {
    long pairs;                /* that intersect                                       */
    long tests, all_tests;     /* of pairs of triangles: with the tree, without        */
    struct clock_summary tree; /* [s]                                                  */
    double all;                /* every pair, once [s]                                 */
};

static enum status measure(const struct shape *shape, struct cost *cost,
                           struct message *why)
{
    struct intersection work = {0};
    double seconds[REPEATS], *xyz = malloc(GRID_U * GRID_V * 3 * sizeof *xyz);
    enum status st = xyz ? STATUS_OK : STATUS_MEMORY;
    long all;

    TRY(st);
    for (int n = 0; n < GRID_U * GRID_V; n++) {
        double uvw[3];
        grid_point(n, uvw);
        shape->point(uvw[0], uvw[1], xyz + 3 * n);
    }
    for (int n = -1; n < REPEATS; n++) { /* the first is a warm-up */
        double begin = clock_now();
        TRY(intersection_count(&work, GRID_U, GRID_V, xyz, &cost->pairs));
        if (n >= 0)
            seconds[n] = clock_now() - begin;
    }
    cost->tree = clock_summarise(seconds, REPEATS);
    cost->tests = work.tests;
    double begin = clock_now();
    TRY(intersection_count_all(&work, GRID_U, GRID_V, xyz, &all));
    cost->all = clock_now() - begin;
    cost->all_tests = work.tests;
    if (all != cost->pairs)
        st = status_fail(why, STATUS_LIBRARY, "%s: the tree finds %ld pairs of %ld",
                         shape->name, cost->pairs, all);
out:
    intersection_clear(&work);
    free(xyz);
    return st;
}

enum status bench_intersection_print(enum table_format format, struct message *why)
{
    static const struct table_column columns[] = {{"surface", NULL, TABLE_LEFT},
                                                  {"pairs", NULL, 0},
                                                  {"tests", NULL, 0},
                                                  {"median", "ms", 0},
                                                  {"quartiles", "ms", 0},
                                                  {"every pair", "ms", 0},
                                                  {"gain", NULL, 0}};
    struct table *t = table_create(7, columns, "Self-intersections of 100 x 100 points");
    enum status st = STATUS_OK;
    struct cost cost = {0};

    for (size_t n = 0; n < sizeof shapes / sizeof *shapes; n++) {
        TRY(measure(&shapes[n], &cost, why));
        table_row(t);
        table_text(t, "%s", shapes[n].name);
        table_integer(t, cost.pairs);
        table_integer(t, cost.tests);
        table_number(t, 1e3 * cost.tree.median, 3);
        table_text(t, "%.3g-%.3g", 1e3 * cost.tree.lower, 1e3 * cost.tree.upper);
        table_number(t, 1e3 * cost.all, 3);
        table_number(t, cost.all / cost.tree.median, 3);
    }
    table_note(t,
               "Made surfaces. Every pair: %ld tests, boxes of triangles first, once; the "
               "same counts.",
               cost.all_tests);
    TRY(table_print(t, format, stdout));
out:
    table_destroy(t);
    return st;
}
