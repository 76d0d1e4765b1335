/* Times the count of self-intersections with its tree of boxes, by every pair of triangles,
 * and as score does it for a mesh, with depths; on surfaces from flat to crumpled. */
#include <math.h>
#include <stdlib.h>

#include "bench/speed/bench.h"
#include "models/metric/crossing.h"

static const double turn = 6.283185307179586;

/* Tilts a flat sheet, so that no coordinate is constant. */
static void flat(double u, double v, double x[3])
{
    x[0] = 0.6 * u - 0.48 * v, x[1] = 0.8 * u + 0.36 * v, x[2] = 0.8 * v;
}

/* Rolls a sheet up two and a half times, with 3 mm between turns. */
static void rolled(double u, double v, double x[3])
{
    const double radius = 0.06 + 0.003 * 2.5 * u;

    x[0] = radius * cos(2.5 * turn * u), x[1] = v, x[2] = radius * sin(2.5 * turn * u);
}

/* Folds a sheet through itself by waves of 2 cm in three directions. */
static void folded(double u, double v, double x[3])
{
    x[0] = u + 0.02 * sin(turn * (9 * u + 7 * v) + 1) + 0.02 * sin(turn * (11 * v - 3 * u));
    x[1] = v + 0.02 * sin(turn * (8 * v - 9 * u) + 2) + 0.02 * sin(turn * 12 * u);
    x[2] = 0.02 * sin(turn * (10 * u + 2 * v)) + 0.02 * sin(turn * (9 * v - 5 * u) + 3);
}

/* Folds a sheet in half, the halves exactly on each other. */
static void doubled(double u, double v, double x[3])
{
    x[0] = u < 0.5 ? u : 1 - u, x[1] = v, x[2] = 0;
}

static const struct shape {
    const char *name;
    void (*point)(double u, double v, double x[3]);
} shapes[] = {
    {"flat", flat}, {"rolled up", rolled}, {"folded", folded}, {"doubled", doubled}};
enum { SHAPES = sizeof shapes / sizeof *shapes, SIDE = 100, QUICK_SIDE = 30 };

/* A surface of side x side points, and what the last counts found. */
struct surface {
    struct intersection work, mesh;
    int side;
    double *xyz;
    int (*corner)[3]; /* [triangles] of a mesh                                          */
    struct crossing crossing;
    long by_tree, by_pairs; /* intersecting pairs of triangles                          */
};

static enum status count(void *surface)
{
    struct surface *s = surface;

    return intersection_count(&s->work, s->side, s->side, s->xyz, &s->by_tree);
}

static enum status count_all(void *surface)
{
    struct surface *s = surface;

    return intersection_count_all(&s->work, s->side, s->side, s->xyz, &s->by_pairs);
}

static enum status count_mesh(void *surface)
{
    struct surface *s = surface;
    const int points = s->side * s->side, triangles = 2 * (s->side - 1) * (s->side - 1);
    long pairs;

    s->mesh.keep_pairs = true;
    s->mesh.shake = CROSSING_SHAKE;
    return intersection_count_mesh(&s->mesh, points, s->xyz, triangles, s->corner, &pairs);
}

/* Measures what count_mesh found last. */
static enum status measure(void *surface)
{
    struct surface *s = surface;

    return crossing_measure(&s->mesh, CROSSING_TOLERANCE, &s->crossing);
}

static enum status make(const struct shape *shape, int side, struct surface *s)
{
    s->side = side;
    const int triangles = 2 * (side - 1) * (side - 1);
    s->xyz = malloc((size_t)(side * side) * 3 * sizeof *s->xyz);
    s->corner = malloc((size_t)triangles * sizeof *s->corner);
    if (!s->xyz || !s->corner)
        return STATUS_MEMORY;
    for (int n = 0; n < triangles; n++)
        intersection_corners(side, n, s->corner[n]);
    for (int n = 0; n < side * side; n++)
        shape->point(n % side / (side - 1.), n / side / (side - 1.), s->xyz + 3 * n);
    return STATUS_OK;
}

static enum status sample(struct bench *b, struct message *why)
{
    struct surface all[SHAPES] = {{{0}}};
    struct samples_task tasks[4 * SHAPES];
    enum status st = STATUS_OK;

    for (int n = 0; n < SHAPES; n++) {
        TRY(make(&shapes[n], b->quick ? QUICK_SIDE : SIDE, &all[n]));
        const char *name = shapes[n].name;
        tasks[4 * n] = (struct samples_task){name, "tree", count, NULL, &all[n]};
        tasks[4 * n + 1] =
            (struct samples_task){name, "every pair", count_all, NULL, &all[n]};
        tasks[4 * n + 2] = (struct samples_task){name, "mesh", count_mesh, NULL, &all[n]};
        tasks[4 * n + 3] = (struct samples_task){name, "depth", measure, NULL, &all[n]};
    }
    TRY(samples_time(&b->samples, b->quick, 4 * SHAPES, tasks));
    for (int n = 0; n < SHAPES; n++) {
        if (all[n].by_tree != all[n].by_pairs)
            TRY(status_fail(why, STATUS_LIBRARY, "%s: the tree finds %ld pairs of %ld",
                            shapes[n].name, all[n].by_tree, all[n].by_pairs));
        samples_add(&b->samples, shapes[n].name, "pairs", (double)all[n].by_tree);
        samples_add(&b->samples, shapes[n].name, "side", all[n].side);
    }
out:
    for (int n = 0; n < SHAPES; n++) {
        intersection_clear(&all[n].work);
        intersection_clear(&all[n].mesh);
        free(all[n].xyz);
        free(all[n].corner);
    }
    return st;
}

static enum status print(const struct bench *b, struct message *why)
{
    static const struct table_column columns[] = {
        {"surface", NULL, TABLE_LEFT},
        {"pairs"},
        {"tree", "ms"},
        {"every pair", "ms"},
        {"gain"},
        {"repeats"},
        {"mesh of 10,000", "ms", .key = "mesh_of_10000"},
        {"its depth", "ms", .key = "depth_of_10000"}};
    const double side = samples_number(&b->samples, shapes[0].name, "side"),
                 triangles = 2 * (side - 1) * (side - 1);
    struct table *t = TABLE_OF(columns, "Counting a sheet's self-intersections");

    (void)why;
    for (int n = 0; n < SHAPES; n++) {
        const char *name = shapes[n].name;
        const struct clock_summary tree = samples_of(&b->samples, name, "tree");
        const double all = samples_number(&b->samples, name, "every pair");
        table_line(t, "%s|%.0f|%.3g|%.3g|%.3g|%d|%.3g|%.3g", name,
                   samples_number(&b->samples, name, "pairs"), 1e3 * tree.median, 1e3 * all,
                   all / tree.median, tree.count,
                   1e7 / triangles * samples_number(&b->samples, name, "mesh"),
                   1e7 / triangles * samples_number(&b->samples, name, "depth"));
    }
    table_note(t,
               "The surfaces are made up and have %.0f x %.0f points. The column `every "
               "pair` tests all pairs of triangles, boxes first, and finds the same. The "
               "last two columns have what `score` does for each 10,000 triangles of a "
               "frame: it searches them as a list, and measures the depth if more pairs "
               "meet than in any frame before.",
               side, side);
    return table_finish(t, b->format, b->file);
}

const struct bench_part bench_part_intersection = {
    .item = {"intersection", "counting a sheet's self-intersections, flat to folded"},
    .sample = sample,
    .print = print};
