/* Times the search for contact of a sheet with itself: with the triangles that were kept,
 * with all found again, in motion, and by every pair, beside an explicit step of the same
 * net. */
#include <math.h>
#include <stdlib.h>

#include "bench/harness/timing.h"
#include "bench/speed/bench.h"
#include "models/contact/contact_search.h"
#include "models/net/spring_sweep.h"

static const double half_pi = 1.5707963267948966;
/* A sheet of 1 m: where contact starts, and the gap of a fold [m]. */
static const double start = 0.002, gap = 0.0016;

/* A motion: parts move at SPEED against each other, and waves cross a cell in a step. */
enum { STEPS = 32 };
static const double speed = 1, waves = 100; /* [m/s] */

/* Turns about the edge u = 0. */
static void flat(double u, double v, double t, double x[3])
{
    const double angle = 0.927295218001612 + speed * t;

    x[0] = cos(angle) * u - 0.48 * v, x[1] = sin(angle) * u + 0.36 * v, x[2] = 0.8 * v;
}

/* Folds 0.3 of the sheet over, about a cylinder as thick as the gap, and ever more of it.
 */
static void folded(double u, double v, double t, double x[3])
{
    const double r = gap / 2, s = u - 0.7013 + speed * t / 2;
    const double angle = fmax(fmin(s / r, half_pi), -half_pi);

    x[0] = r * cos(angle) - fmax(fabs(s) - r * half_pi, 0);
    x[1] = v + 0.1 * fmax(s, 0), x[2] = r * sin(angle) + 0.05 * x[0] * v;
}

static const struct shape {
    const char *name;
    void (*point)(double u, double v, double t, double x[3]);
} shapes[] = {{"flat", flat}, {"folded", folded}};
static const int sides[] = {32, 64, 100, 256}, quick_sides[] = {12, 24};
enum { SHAPES = 2, SIDES = 4, QUICK_SIDES = 2, CASES = SHAPES * SIDES, TASKS = 4 };
enum { PAIRS_SIDE = 100 }; /* the largest that every pair is looked at of             */

struct net {
    char name[SAMPLES_NAME];
    int side;
    double *x, *line;
    struct contact_surface surface;
    struct contact_search search, plain; /* by the tree; of every pair                   */
    struct spring_sweep *sweep;
    int by_tree, by_pairs; /* feet                                                     */
};

static void place(struct net *net, const struct shape *shape, double t)
{
    const int side = net->side;

    for (int n = 0; n < side * side; n++)
        shape->point(net->line[n / side], net->line[n % side], t, net->x + 3 * (long)n);
}

static int row(const void *self, double u, double v, int *node, double *shape)
{
    const struct net *net = self;

    *shape = 1;
    *node = (int)lround(u * (net->side - 1)) * net->side + (int)lround(v * (net->side - 1));
    return 1;
}

static enum status step(void *net)
{
    spring_sweep_run(((struct net *)net)->sweep, 1e-5, 1);
    return STATUS_OK;
}

static enum status find(void *net)
{
    struct net *n = net;
    const enum status st = contact_search_find(&n->search, n->x);

    n->by_tree = n->search.count;
    return st;
}

static enum status find_again(void *net)
{
    contact_search_forget(&((struct net *)net)->search);
    return find(net);
}

static enum status find_all(void *net)
{
    struct net *n = net;
    const enum status st = contact_search_find_all(&n->plain, n->x);

    n->by_pairs = n->plain.count;
    return st;
}

/* Makes a net of springs at rest, whose step costs what that of any motion does. */
static enum status make_sweep(struct net *net)
{
    const int count = net->side * net->side;
    const struct spring_sweep_plan plan = {.n = net->side,
                                           .m = net->side,
                                           .sheet = net->side,
                                           .law = SWEEP_LENGTHS,
                                           .precision = PRECISION_DOUBLE};
    double(*c)[SWEEP_COUNT] = calloc((size_t)count, sizeof *c);
    enum status st = c ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    for (int n = 0; n < count; n++)
        c[n][SWEEP_KEEP] = c[n][SWEEP_FREE] = c[n][SWEEP_FREE + 1] = c[n][SWEEP_FREE + 2] =
            1;
    TRY(spring_sweep_make(&plan, &net->sweep));
    spring_sweep_set(net->sweep, (const double(*)[SWEEP_COUNT])c);
    spring_sweep_put(net->sweep, net->x, NULL);
out:
    free(c);
    return st;
}

static enum status make(const struct scene *scene, const struct shape *shape, int side,
                        struct net *net)
{
    enum status st = STATUS_OK;

    net->side = side;
    snprintf(net->name, sizeof net->name, "%s %dx%d", shape->name, side, side);
    net->line = malloc(side * sizeof *net->line);
    net->x = malloc((size_t)(side * side) * 3 * sizeof *net->x);
    if (!net->line || !net->x)
        return STATUS_MEMORY;
    for (int n = 0; n < side; n++)
        net->line[n] = n / (side - 1.);
    place(net, shape, 0);
    TRY(contact_surface_init(&net->surface, scene, net, row, 1, side * side,
                             (const double *const[]){net->line, net->line},
                             (const int[]){side, side}));
    TRY(contact_search_init(&net->search, &net->surface, start));
    TRY(contact_search_init(&net->plain, &net->surface, start));
    TRY(make_sweep(net));
out:
    return st;
}

static void clear(struct net *net)
{
    contact_search_clear(&net->search);
    contact_search_clear(&net->plain);
    contact_surface_clear(&net->surface);
    spring_sweep_free(net->sweep);
    free(net->x);
    free(net->line);
}

/* Times the search in steps of a motion, between them those of the springs. */
static enum status time_motion(struct bench *b, const struct shape *shape, struct net *n)
{
    const double dt = 1 / waves / (n->side - 1);
    enum status st = STATUS_OK;
    int count = 1;

    for (int r = 0; r < count; r++) {
        double seconds = 0;
        place(n, shape, 0);
        TRY(find_again(n));
        const long sought = n->search.sought;
        for (int k = 1; k <= STEPS; k++) {
            place(n, shape, k * dt);
            TRY(step(n));
            const double begin = clock_now();
            TRY(find(n));
            seconds += clock_now() - begin;
        }
        samples_add(&b->samples, n->name, "moving", seconds / STEPS);
        samples_add(&b->samples, n->name, "steps kept",
                    (double)STEPS / fmax(1, n->search.sought - sought));
        count = timing_repeats(seconds, b->quick);
    }
out:
    return st;
}

static enum status sample(struct bench *b, struct message *why)
{
    const int count = b->quick ? QUICK_SIDES : SIDES;
    struct net all[CASES] = {{{0}}};
    struct samples_task tasks[TASKS * CASES];
    struct scene scene = {0};
    enum status st = STATUS_OK;
    int used = 0;

    TRY(scene_init(&scene));
    scene.length = scene.width = 1;
    for (int k = 0; k < SHAPES * count; k++) {
        struct net *n = &all[k];
        TRY(make(&scene, &shapes[k / count], (b->quick ? quick_sides : sides)[k % count],
                 n));
        tasks[used++] = (struct samples_task){n->name, "step", step, NULL, n};
        tasks[used++] = (struct samples_task){n->name, "kept", find, NULL, n};
        tasks[used++] = (struct samples_task){n->name, "again", find_again, NULL, n};
        if (n->side <= PAIRS_SIDE)
            tasks[used++] = (struct samples_task){n->name, "every pair", find_all, NULL, n};
    }
    TRY(samples_time(&b->samples, b->quick, used, tasks));
    for (int k = 0; k < SHAPES * count; k++) {
        struct net *n = &all[k];
        if (n->side <= PAIRS_SIDE && n->by_tree != n->by_pairs)
            TRY(status_fail(why, STATUS_LIBRARY, "%s: the tree finds %d feet of %d",
                            n->name, n->by_tree, n->by_pairs));
        samples_add(&b->samples, n->name, "feet", n->by_tree);
        TRY(time_motion(b, &shapes[k / count], n));
    }
out:
    for (int k = 0; k < CASES; k++)
        clear(&all[k]);
    scene_clear(&scene);
    return st;
}

/* Tells whether the samples are of a quick run. */
static bool is_quick(const struct bench *b)
{
    return samples_of(&b->samples, "flat 12x12", "step").count > 0;
}

/* Returns the exponent by which a time grows with the number of points, from the fewest to
 * the most. */
static double growth(const struct bench *b, const struct shape *shape, const char *what)
{
    const int *side = is_quick(b) ? quick_sides : sides;
    const int last = (is_quick(b) ? QUICK_SIDES : SIDES) - 1;
    double seconds[2];

    for (int k = 0; k < 2; k++) {
        char name[SAMPLES_NAME];
        const int n = side[k * last];
        snprintf(name, sizeof name, "%s %dx%d", shape->name, n, n);
        seconds[k] = samples_number(&b->samples, name, what);
    }
    return log(seconds[1] / seconds[0]) / log((double)side[last] / side[0]) / 2;
}

static enum status print(const struct bench *b, struct message *why)
{
    static const struct table_column columns[] = {{"net", NULL, TABLE_LEFT},
                                                  {"feet"},
                                                  {"step", "us"},
                                                  {"kept", "us"},
                                                  {"over step"},
                                                  {"again", "us"},
                                                  {"steps kept"},
                                                  {"moving", "us"},
                                                  {"moving over step"},
                                                  {"every pair", "us"},
                                                  {"gain"},
                                                  {"repeats"}};
    struct table *t = TABLE_OF(columns, "Searching a sheet for contact with itself");
    const int count = is_quick(b) ? QUICK_SIDES : SIDES;

    (void)why;
    for (int k = 0; k < SHAPES * count; k++) {
        char name[SAMPLES_NAME];
        const int side = (is_quick(b) ? quick_sides : sides)[k % count];
        snprintf(name, sizeof name, "%s %dx%d", shapes[k / count].name, side, side);
        const double seconds = samples_number(&b->samples, name, "step");
        const struct clock_summary kept = samples_of(&b->samples, name, "kept");
        const double again = samples_number(&b->samples, name, "again");
        const double moving = samples_number(&b->samples, name, "moving");
        const double all = samples_number(&b->samples, name, "every pair");
        table_line(t, "%s|%.0f|%.3g|%.3g|%.3g|%.3g|%.3g|%.3g|%.3g|%.3g|%.3g|%d", name,
                   samples_number(&b->samples, name, "feet"), 1e6 * seconds,
                   1e6 * kept.median, kept.median / seconds, 1e6 * again,
                   samples_number(&b->samples, name, "steps kept"), 1e6 * moving,
                   moving / seconds, 1e6 * all, all / again, kept.count);
    }
    table_note(
        t, "A sheet of 1 m, contact from 2 mm on. The column `step` is an explicit step of "
           "the net's springs, `kept` a search whose near triangles still hold, `again` "
           "one that finds them again (after samples have moved by the margin against "
           "each other), `every pair` one that looks at all samples and cells, boxes "
           "first, and finds the same.");
    table_note(
        t,
        "In `moving` the sheet turns about an edge or is folded ever more, its parts "
        "at %g m/s against each other, in steps of a cell over %g m/s; its search is "
        "the mean of %d steps, and near triangles hold for so many as `steps kept` "
        "tells (a motion of %d at most).",
        speed, waves, STEPS, STEPS);
    table_note(
        t,
        "With the number of points the time grows by the power %.2f (flat) and %.2f "
        "(folded) where triangles are kept, %.2f and %.2f where they are found again.",
        growth(b, &shapes[0], "kept"), growth(b, &shapes[1], "kept"),
        growth(b, &shapes[0], "again"), growth(b, &shapes[1], "again"));
    return table_finish(t, b->format, b->file);
}

const struct bench_part bench_part_contact = {
    .item = {"contact", "searching a sheet for contact with itself, flat and folded"},
    .sample = sample,
    .print = print};
