/* Times the count of self-intersections with and without its tree: surfaces of 100 x 100
 * points from flat to crumpled; if quick, of fewer. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "bench/speed/bench.h"
#include "models/clock.h"
#include "models/metric/intersection.h"

static const double turn = 6.283185307179586;

/* A flat sheet, tilted, so that no coordinate is constant. */
static void flat(double u, double v, double x[3])
{
    x[0] = 0.6 * u - 0.48 * v, x[1] = 0.8 * u + 0.36 * v, x[2] = 0.8 * v;
}

/* A sheet that hangs from a middle disc of radius 0.3 in eight folds. */
static void draped(double u, double v, double x[3])
{
    double a = u - 0.5, b = v - 0.5, radius = hypot(a, b), angle = atan2(b, a);
    double below = fmax(radius - 0.3, 0);
    double out = fmin(radius, 0.3) + below * (0.3 + 0.25 * cos(8 * angle));

    x[0] = out * cos(angle), x[1] = out * sin(angle);
    x[2] = -sqrt(0.9) * below;
}

/* A sheet that is rolled up two and a half times, with 3 mm between turns. */
static void rolled(double u, double v, double x[3])
{
    double radius = 0.06 + 0.003 * 2.5 * u;
    x[0] = radius * cos(2.5 * turn * u), x[1] = v, x[2] = radius * sin(2.5 * turn * u);
}

/* Waves in three directions that fold the sheet through itself, with amplitudes of 0.02 and
 * wave lengths of 0.08. */
static void folded(double u, double v, double x[3])
{
    x[0] = u + 0.02 * sin(turn * (9 * u + 7 * v) + 1) + 0.02 * sin(turn * (11 * v - 3 * u));
    x[1] = v + 0.02 * sin(turn * (8 * v - 9 * u) + 2) + 0.02 * sin(turn * 12 * u);
    x[2] = 0.02 * sin(turn * (10 * u + 2 * v)) + 0.02 * sin(turn * (9 * v - 5 * u) + 3);
}

/* Noise of three grid steps: every triangle is close to others. */
static void crumpled(double u, double v, double x[3])
{
    uint64_t state = 1 + lround(u * 99) + 100 * lround(v * 99);

    x[0] = u, x[1] = v, x[2] = 0;
    for (int c = 0; c < 3; c++) {
        /* The hash is splitmix64. */
        uint64_t z = state * 3 + c + 1;
        z *= 0x9e3779b97f4a7c15u;
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
        z = (z ^ z >> 27) * 0x94d049bb133111ebu;
        x[c] += 0.03 * ((double)((z ^ z >> 31) >> 11) * 0x1p-53 - 0.5);
    }
}

/* A sheet folded in half along v, the halves exactly on each other. */
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
enum { SHAPES = sizeof shapes / sizeof *shapes, SIDE = 100, QUICK_SIDE = 30 };

enum way { TREE, EVERY_PAIR, WAYS };
static const char *const way_name[WAYS] = {"tree", "every pair"};

/* A shape on the grid, and the result of its last count. */
struct sheet {
    struct intersection work;
    int side; /* points                                                                */
    double *xyz;
    long pairs[WAYS]; /* that intersect                                                */
    long tests[WAYS]; /* of pairs of triangles                                         */
};

static enum status count(void *sheet)
{
    struct sheet *s = sheet;
    enum status st =
        intersection_count(&s->work, s->side, s->side, s->xyz, &s->pairs[TREE]);

    s->tests[TREE] = s->work.tests;
    return st;
}

static enum status count_all(void *sheet)
{
    struct sheet *s = sheet;
    enum status st =
        intersection_count_all(&s->work, s->side, s->side, s->xyz, &s->pairs[EVERY_PAIR]);

    s->tests[EVERY_PAIR] = s->work.tests;
    return st;
}

static enum status make(const struct shape *shape, int side, struct sheet *s)
{
    s->side = side;
    s->xyz = malloc((size_t)(side * side) * 3 * sizeof *s->xyz);
    if (!s->xyz)
        return STATUS_MEMORY;
    for (int n = 0; n < side * side; n++)
        shape->point(n % side / (side - 1.), n / side / (side - 1.), s->xyz + 3 * n);
    return STATUS_OK;
}

/* Stores the counts, after checking that the tree finds what testing every pair finds. */
static enum status keep(struct bench *b, const char *name, const struct sheet *s,
                        struct message *why)
{
    if (s->pairs[TREE] != s->pairs[EVERY_PAIR])
        return status_fail(why, STATUS_LIBRARY, "%s: the tree finds %ld pairs of %ld", name,
                           s->pairs[TREE], s->pairs[EVERY_PAIR]);
    samples_add(&b->samples, name, "pairs", (double)s->pairs[TREE]);
    samples_add(&b->samples, name, "tests", (double)s->tests[TREE]);
    samples_add(&b->samples, name, "all tests", (double)s->tests[EVERY_PAIR]);
    return STATUS_OK;
}

static enum status sample(struct bench *b, struct message *why)
{
    struct sheet sheets[SHAPES] = {{{0}}};
    struct samples_task tasks[WAYS * SHAPES];
    const int side = b->quick ? QUICK_SIDE : SIDE;
    enum status st = STATUS_OK;

    samples_add(&b->samples, "sheet", "side", side);
    for (int n = 0; n < SHAPES; n++) {
        TRY(make(&shapes[n], side, &sheets[n]));
        for (int w = 0; w < WAYS; w++)
            tasks[WAYS * n + w] =
                (struct samples_task){shapes[n].name, way_name[w],
                                      w == TREE ? count : count_all, NULL, &sheets[n]};
    }
    TRY(samples_time(&b->samples, b->quick, WAYS * SHAPES, tasks));
    for (int n = 0; n < SHAPES; n++)
        TRY(keep(b, shapes[n].name, &sheets[n], why));
out:
    for (int n = 0; n < SHAPES; n++) {
        intersection_clear(&sheets[n].work);
        free(sheets[n].xyz);
    }
    return st;
}

static enum status print(const struct bench *b, struct message *why)
{
    (void)why;
    static const struct table_column columns[] = {
        {"surface", NULL, TABLE_LEFT}, {"pairs"}, {"tests"}, BENCH_PART_TIMES,
        {"every pair", "ms"},          {"gain"}};
    const double side = samples_number(&b->samples, "sheet", "side");
    char caption[64];

    snprintf(caption, sizeof caption, "Self-intersections of %.0f x %.0f points", side,
             side);
    struct table *t = table_create(sizeof columns / sizeof *columns, columns, caption);
    for (int n = 0; n < SHAPES; n++) {
        const char *name = shapes[n].name;
        const struct clock_summary tree = samples_of(&b->samples, name, way_name[TREE]);
        const double all = samples_number(&b->samples, name, way_name[EVERY_PAIR]);
        table_row(t);
        table_text(t, "%s", name);
        table_fixed(t, samples_number(&b->samples, name, "pairs"), 0);
        table_fixed(t, samples_number(&b->samples, name, "tests"), 0);
        bench_part_times(t, &tree);
        table_number(t, 1e3 * all, 3);
        table_number(t, all / tree.median, 3);
    }
    table_note(
        t,
        "Made surfaces. Every pair: %.0f tests, boxes of triangles first; the same counts.",
        samples_number(&b->samples, shapes[SHAPES - 1].name, "all tests"));
    return table_finish(t, b->format, b->file);
}

const struct bench_part bench_part_intersection = {
    .item = {"intersection", "counting a sheet's self-intersections, flat to crumpled"},
    .sample = sample,
    .print = print};
