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
enum { SHAPES = 2, SIDES = 4, QUICK_SIDES = 2, CASES = SHAPES * SIDES };
enum { PAIRS_SIDE = 100 }; /* the largest that every pair is looked at of             */

/* What is timed of a net, each repeat: calls of the first four, and a search in motion. */
enum what { STEP, KEPT, AGAIN, EVERY_PAIR, MOVING, WHATS };

struct net {
    const struct shape *shape;
    int side;
    double *x, *line; /* in the arena                                                   */
    struct arena *arena;
    struct contact_surface surface;
    struct contact_search search, plain; /* by the tree; of every pair                   */
    struct spring_sweep *sweep;
    int by_tree, by_pairs, feet; /* that a search found last; of the net at rest         */
    double seconds[WHATS][TIMING_REPEATS], steps_kept;
    int repeats[WHATS];
};

static void place(struct net *net, double t)
{
    const int side = net->side;

    for (int n = 0; n < side * side; n++)
        net->shape->point(net->line[n / side], net->line[n % side], t,
                          net->x + 3 * (long)n);
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
    const struct spring_sweep_plan plan = {
        .n = net->side, .m = net->side, .sheet = net->side, .precision = PRECISION_DOUBLE};
    double(*c)[SWEEP_COUNT] = arena_take(net->arena, (size_t)count, sizeof *c);

    for (int n = 0; n < count; n++)
        c[n][SWEEP_KEEP] = c[n][SWEEP_FREE] = c[n][SWEEP_FREE + 1] = c[n][SWEEP_FREE + 2] =
            1;
    CALL(spring_sweep_make(&plan, &net->sweep));
    spring_sweep_set(net->sweep, (const double(*)[SWEEP_COUNT])c);
    spring_sweep_put(net->sweep, net->x, NULL);
    return STATUS_OK;
}

static enum status make(const struct scene *scene, const struct shape *shape, int side,
                        struct net *net)
{
    net->shape = shape;
    net->side = side;
    net->line = arena_take(net->arena, (size_t)side, sizeof *net->line);
    net->x = arena_take(net->arena, (size_t)(side * side) * 3, sizeof *net->x);
    for (int n = 0; n < side; n++)
        net->line[n] = n / (side - 1.);
    place(net, 0);
    CALL(contact_surface_init(&net->surface, scene, net, row, 1, side * side,
                              (const double *const[]){net->line, net->line},
                              (const int[]){side, side}));
    CALL(contact_search_init(&net->search, &net->surface, start));
    CALL(contact_search_init(&net->plain, &net->surface, start));
    return make_sweep(net);
}

static void clear(struct net *net)
{
    contact_search_clear(&net->search);
    contact_search_clear(&net->plain);
    contact_surface_clear(&net->surface);
    spring_sweep_free(net->sweep);
}

static enum status (*const call[MOVING])(void *net) = {step, find, find_again, find_all};

static void add(struct net *net, enum what what, double seconds)
{
    net->seconds[what][net->repeats[what]++] = seconds;
}

/* Returns the median; NaN: it was not timed. */
static double median(const struct net *net, enum what what)
{
    return net->repeats[what]
               ? clock_summarise(net->seconds[what], net->repeats[what]).median
               : NAN;
}

static const double SAMPLE = 1e-3; /* [s] a sample lasts at least */

/* Times as many calls as make up a sample by their mean. The first fetches again what
 * other nets have driven out of the caches: it isn't counted if there is time for more. */
static enum status time_calls(struct net *net, enum what what, double *seconds)
{
    const double begin = clock_now();
    double sum = 0;
    enum status st = STATUS_OK;

    for (int calls = 0; st == STATUS_OK && (!calls || clock_now() - begin < SAMPLE);
         calls++) {
        const double before = clock_now();
        st = call[what](net);
        sum = (calls > 1 ? sum : 0) + clock_now() - before;
        *seconds = sum / (calls > 1 ? calls : 1);
    }
    return st;
}

/* Times everything at rest in turn, short calls after an untimed round, repeated as
 * timing.h says. */
static enum status time_nets(int count, struct net *nets, bool quick)
{
    for (int n = -count * MOVING; n < TIMING_REPEATS * count * MOVING; n++) {
        const int at = (n + count * MOVING) % (count * MOVING);
        struct net *net = &nets[at / MOVING];
        const enum what what = at % MOVING;
        double seconds;
        if ((what == EVERY_PAIR && net->side > PAIRS_SIDE) ||
            (net->repeats[what] &&
             net->repeats[what] >= timing_repeats(net->seconds[what][0], quick)))
            continue;
        CALL(time_calls(net, what, &seconds));
        if (n >= 0 || seconds > TIMING_SHORT)
            add(net, what, seconds);
    }
    return STATUS_OK;
}

/* Times the search in steps of a motion, between them those of the springs. */
static enum status time_motion(struct net *n, bool quick)
{
    const double dt = 1 / waves / (n->side - 1);
    int count = 1;

    for (int r = 0; r < count; r++) {
        double seconds = 0;
        place(n, 0);
        CALL(find_again(n));
        const long sought = n->search.sought;
        for (int k = 1; k <= STEPS; k++) {
            place(n, k * dt);
            CALL(step(n));
            const double begin = clock_now();
            CALL(find(n));
            seconds += clock_now() - begin;
        }
        add(n, MOVING, seconds / STEPS);
        n->steps_kept = (double)STEPS / fmax(1, n->search.sought - sought);
        count = timing_repeats(seconds, quick);
    }
    return STATUS_OK;
}

/* Returns the exponent by which a time grows with the number of points, from the fewest to
 * the most of `count` nets of a shape. */
static double growth(const struct net *nets, int count, enum what what)
{
    const struct net *first = &nets[0], *last = &nets[count - 1];

    return log(median(last, what) / median(first, what)) /
           log((double)last->side / first->side) / 2;
}

static enum status print(const struct bench *b, int count, const struct net *nets,
                         struct message *why)
{
    static const struct dataset_column columns[] = {{"net"},
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
    struct dataset *t = DATASET_OF(columns, "Searching a sheet for contact with itself");

    for (const struct net *n = nets; n < nets + SHAPES * count; n++)
        dataset_line(t, "%s %dx%d|%d|%.3g|%.3g|%.3g|%.3g|%.3g|%.3g|%.3g|%.3g|%.3g|%d",
                     n->shape->name, n->side, n->side, n->feet, 1e6 * median(n, STEP),
                     1e6 * median(n, KEPT), median(n, KEPT) / median(n, STEP),
                     1e6 * median(n, AGAIN), n->steps_kept, 1e6 * median(n, MOVING),
                     median(n, MOVING) / median(n, STEP), 1e6 * median(n, EVERY_PAIR),
                     median(n, EVERY_PAIR) / median(n, AGAIN), n->repeats[KEPT]);
    dataset_note(
        t, "A sheet of 1 m, contact from 2 mm on. The column `step` is an explicit step of "
           "the net's springs, `kept` a search whose near triangles still hold, `again` "
           "one that finds them again (after samples have moved by the margin against "
           "each other), `every pair` one that looks at all samples and cells, boxes "
           "first, and finds the same.");
    dataset_note(
        t,
        "In `moving` the sheet turns about an edge or is folded ever more, its parts "
        "at %g m/s against each other, in steps of a cell over %g m/s; its search is "
        "the mean of %d steps, and near triangles hold for so many as `steps kept` "
        "tells (a motion of %d at most).",
        speed, waves, STEPS, STEPS);
    dataset_note(
        t,
        "With the number of points the time grows by the power %.2f (flat) and %.2f "
        "(folded) where triangles are kept, %.2f and %.2f where they are found again.",
        growth(nets, count, KEPT), growth(nets + count, count, KEPT),
        growth(nets, count, AGAIN), growth(nets + count, count, AGAIN));
    return printer_table(b->printer, t, "contact", why);
}

static enum status measure(struct bench *b, struct message *why)
{
    const int count = b->quick ? QUICK_SIDES : SIDES;
    struct arena arena = {0};
    struct net *nets = arena_take(&arena, CASES, sizeof *nets);
    struct scene scene = {0};
    enum status st;

    TRY(scene_init(&scene));
    scene.length = scene.width = 1;
    for (int k = 0; k < CASES; k++)
        nets[k].arena = &arena;
    for (int k = 0; k < SHAPES * count; k++)
        TRY(make(&scene, &shapes[k / count], (b->quick ? quick_sides : sides)[k % count],
                 &nets[k]));
    TRY(time_nets(SHAPES * count, nets, b->quick));
    for (struct net *n = nets; n < nets + SHAPES * count; n++) {
        if (n->side <= PAIRS_SIDE && n->by_tree != n->by_pairs)
            TRY(status_fail(why, STATUS_LIBRARY, "%s %dx%d: the tree finds %d feet of %d",
                            n->shape->name, n->side, n->side, n->by_tree, n->by_pairs));
        n->feet = n->by_tree;
        TRY(time_motion(n, b->quick));
    }
    st = print(b, count, nets, why);
out:
    for (int k = 0; k < CASES; k++)
        clear(&nets[k]);
    arena_clear(&arena);
    scene_clear(&scene);
    return st;
}

const struct bench_part bench_part_contact = {
    .item = {"contact", "searching a sheet for contact with itself, flat and folded"},
    .measure = measure};
