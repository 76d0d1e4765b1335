/* Times the parts of a frame of projective dynamics, and what acceleration gains; if quick,
 * on the smaller nets. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/timing.h"
#include "bench/speed/bench.h"
#include "bench/speed/peers.h"
#include "models/reader/scene_file.h"
#include "projective_dynamics/pd_motion.h"

enum { ITERATIONS = 10 };

/* The nets, and the time a frame should reach [ms]. */
static const struct net {
    int points;
    double aim;
} nets[] = {{10, 0.03}, {32, 0.6}, {100, 7}};
enum { NETS = sizeof nets / sizeof *nets };

static enum status read_scene(struct scene *scene, struct message *why)
{
    enum status st;
    char *path = NULL;
    struct discretization d = {0};
    const char *const settings[] = {"damping={kind: none}"};

    TRY(scene_file_find("corners_drop", &path, why));
    TRY(scene_file_read(path, 1, settings, scene, &d, why));
out:
    discretization_clear(&d);
    free(path);
    return st;
}

static struct pd_options options_of(int points, enum constraint constraint, bool chebyshev)
{
    return (struct pd_options){.points = {points, points},
                               .constraint = constraint,
                               .substeps = 1,
                               .iterations = ITERATIONS,
                               .chebyshev = chebyshev};
}

/* --- a frame's parts ---------------------------------------------------------------------
 */

/* A net with one kind of constraint. */
struct made {
    char name[SAMPLES_NAME];
    struct pd_motion motion;
};

static enum status local_step(void *motion)
{
    struct pd_motion *m = motion;

    pd_local_step(&m->local, m->x, m->base, m->next);
    return STATUS_OK;
}

static enum status solve(void *motion)
{
    struct pd_motion *m = motion;

    return pd_system_solve(&m->system, m->before); /* zeros: the same work */
}

static enum status frame(void *motion)
{
    struct counters counters = {0};

    return pd_motion_frame(motion, &counters);
}

static const struct {
    const char *what;
    enum status (*call)(void *motion);
} phases[] = {{"local", local_step}, {"solve", solve}, {"frame", frame}};
enum { PHASES = sizeof phases / sizeof *phases, KINDS = 2 };

static void name_of(int net, enum constraint constraint, char name[SAMPLES_NAME])
{
    snprintf(name, SAMPLES_NAME, "%dx%d %s", nets[net].points, nets[net].points,
             pd_energy_constraints[constraint]);
}

static enum status sample_frames(struct bench *b, const struct scene *scene,
                                 struct message *why)
{
    struct made made[NETS * KINDS] = {{{0}}};
    struct samples_task tasks[NETS * KINDS * PHASES];
    enum status st = STATUS_OK;
    int count = 0;

    for (int n = 0; n < KINDS * (b->quick ? NETS - 1 : NETS); n++) {
        const enum constraint constraint = CONSTRAINT_TRIANGLES + n % KINDS;
        struct made *m = &made[n];
        struct pd_options o = options_of(nets[n / KINDS].points, constraint, false);
        struct model_size size;
        name_of(n / KINDS, constraint, m->name);
        TRY(pd_motion_init(&m->motion, scene, &o, why));
        pd_motion_size(&m->motion, &size);
        samples_add(&b->samples, m->name, "constraints", m->motion.energy.constraints);
        samples_add(&b->samples, m->name, "entries", (double)size.factor_entries);
        for (int p = 0; p < PHASES; p++)
            tasks[count++] = (struct samples_task){m->name, phases[p].what, phases[p].call,
                                                   NULL, &m->motion};
    }
    TRY(samples_time(&b->samples, b->quick, count, tasks));
out:
    for (int n = 0; n < NETS * KINDS; n++)
        pd_motion_clear(&made[n].motion);
    return st;
}

static void frame_row(struct table *t, const struct bench *b, int net,
                      enum constraint constraint)
{
    char name[SAMPLES_NAME];

    name_of(net, constraint, name);
    const struct clock_summary s = samples_of(&b->samples, name, "frame");
    if (!s.count)
        return;
    table_row(t);
    table_text(t, "%dx%d", nets[net].points, nets[net].points);
    table_text(t, "%s", pd_energy_constraints[constraint]);
    table_fixed(t, samples_number(&b->samples, name, "constraints"), 0);
    table_fixed(t, samples_number(&b->samples, name, "entries"), 0);
    table_number(t, 1e3 * samples_number(&b->samples, name, "local"), 3);
    table_number(t, 1e3 * samples_number(&b->samples, name, "solve"), 3);
    bench_part_times(t, &s);
    bench_part_aim(t, &s, nets[net].aim);
}

static enum status print_frames(const struct bench *b, struct message *why)
{
    static const struct table_column columns[] = {
        {"net", NULL, TABLE_LEFT}, {"stretch by", NULL, TABLE_LEFT},
        {"constraints"},           {"numbers in L"},
        {"local", "ms"},           {"solve", "ms"},
        BENCH_PART_TIMES,          BENCH_PART_AIM};
    struct table *t =
        table_create(sizeof columns / sizeof *columns, columns,
                     "Projective dynamics, frames of 10 iterations, one thread");
    char name[SAMPLES_NAME];
    enum status st;

    for (int n = 0; n < NETS; n++) {
        for (enum constraint c = CONSTRAINT_TRIANGLES; c <= CONSTRAINT_EDGES; c++)
            frame_row(t, b, n, c);
        snprintf(name, sizeof name, "projective %dx%d edges", nets[n].points,
                 nets[n].points);
        TRY(peers_note(t, name, why));
    }
    table_note(t, "Constraints are edges or triangles, and rows of bending; bending about "
                  "a flat rest shape lies in the constant matrix and has no local step.");
    return table_finish(t, b->format, b->file);
out:
    table_destroy(t);
    return st;
}

/* --- acceleration ------------------------------------------------------------------------
 */

enum { LENGTHS = 5, START_FRAME = 40, MOST = 400000, SIDES = 2 };
static const int lengths[LENGTHS] = {10, 30, 100, 300, 1000}, sides[SIDES] = {10, 20};

static void copy(const struct pd_net *net, const double *from, double *to)
{
    memcpy(to - net->pad, from - net->pad, (size_t)(3 * pd_net_stride(net)) * sizeof *to);
}

static double farthest(const struct pd_net *net, const double *a, const double *b)
{
    double most = 0;

    for (int c = 0; c < 3; c++)
        for (int k = 0; k < net->nodes; k++) {
            ptrdiff_t at = c * pd_net_stride(net) + k;
            most = fmax(most, fabs(a[at] - b[at]));
        }
    return most;
}

/* Iterates from `start`; fills the distance to `end` after each of lengths[], and the
 * seconds an iteration. */
static enum status approach(struct pd_motion *m, bool chebyshev, const double *start,
                            const double *end, double distance[LENGTHS], double *seconds)
{
    enum status st = STATUS_OK;
    const struct pd_net *net = &m->energy.net;
    int done = 0;

    m->options.chebyshev = chebyshev;
    copy(net, start, m->x);
    *seconds = 0;
    for (int n = 0; n < LENGTHS; n++) {
        double begin = clock_now();
        for (; done < lengths[n]; done++)
            TRY(pd_motion_iterate(m, done, NULL));
        *seconds += clock_now() - begin;
        distance[n] = farthest(net, m->x, end);
    }
    *seconds /= lengths[LENGTHS - 1];
out:
    return st;
}

/* Finds, for one step of a falling sheet, where its iterations start and end. */
static enum status find_ends(struct pd_motion *m, double *start, double *end, int *needed)
{
    enum status st;
    struct counters counters = {0};
    double moved = INFINITY;

    m->options.chebyshev = false;
    for (int n = 0; n < START_FRAME; n++)
        TRY(pd_motion_frame(m, &counters));
    pd_motion_begin(m);
    copy(&m->energy.net, m->x, start);
    for (*needed = 0; *needed < MOST && moved > 1e-14; ++*needed)
        TRY(pd_motion_iterate(m, *needed, &moved));
    copy(&m->energy.net, m->x, end);
out:
    return st;
}

static void name_approach(int points, bool chebyshev, char name[SAMPLES_NAME])
{
    snprintf(name, SAMPLES_NAME, "%dx%d %s", points, points,
             chebyshev ? "Chebyshev" : "plain");
}

/* Stores the distances, which are the same every time, and the seconds of each repeat. */
static enum status sample_approach(struct bench *b, struct pd_motion *m, bool chebyshev,
                                   const double *start, const double *end)
{
    double distance[LENGTHS], seconds;
    char name[SAMPLES_NAME], what[SAMPLES_NAME];
    enum status st = STATUS_OK;

    name_approach(m->energy.net.n, chebyshev, name);
    for (int r = 0; r < timing_repeats(0, b->quick); r++) {
        TRY(approach(m, chebyshev, start, end, distance, &seconds));
        samples_add(&b->samples, name, "iteration", seconds);
    }
    for (int n = 0; n < LENGTHS; n++) {
        snprintf(what, sizeof what, "after %d", lengths[n]);
        samples_add(&b->samples, name, what, distance[n] / m->scene->length);
    }
out:
    return st;
}

static enum status sample_net(struct bench *b, const struct scene *scene, int points,
                              struct message *why)
{
    enum status st;
    struct pd_motion m = {0};
    struct pd_options o = options_of(points, CONSTRAINT_TRIANGLES, true);
    double *start = NULL, *end = NULL;
    char name[SAMPLES_NAME];
    int needed;

    TRY(pd_motion_init(&m, scene, &o, why));
    start = pd_net_fields(&m.energy.net, 3);
    end = pd_net_fields(&m.energy.net, 3);
    if (!start || !end)
        TRY(STATUS_MEMORY);
    TRY(find_ends(&m, start, end, &needed));
    name_approach(points, true, name);
    samples_add(&b->samples, name, "needed", needed);
    samples_add(&b->samples, name, "radius", m.radius);
    samples_add(&b->samples, "scene", "time", m.time);
    TRY(sample_approach(b, &m, false, start, end));
    TRY(sample_approach(b, &m, true, start, end));
out:
    pd_net_free_fields(&m.energy.net, start);
    pd_net_free_fields(&m.energy.net, end);
    pd_motion_clear(&m);
    return st;
}

static void approach_row(struct table *t, const struct bench *b, int points, bool chebyshev)
{
    char name[SAMPLES_NAME], what[SAMPLES_NAME];

    name_approach(points, chebyshev, name);
    const struct clock_summary each = samples_of(&b->samples, name, "iteration");
    if (!each.count)
        return;
    table_row(t);
    table_text(t, "%dx%d", points, points);
    table_text(t, "%s", chebyshev ? "Chebyshev" : "plain");
    for (int n = 0; n < LENGTHS; n++) {
        snprintf(what, sizeof what, "after %d", lengths[n]);
        table_number(t, samples_number(&b->samples, name, what), 2);
    }
    table_number(t, 1e6 * each.median, 3);
    table_integer(t, each.count);
    if (!chebyshev)
        return;
    const double needed = samples_number(&b->samples, name, "needed");
    table_note(
        t, "%d points a side: radius %.6f; the end itself took %.0f plain iterations%s.",
        points, samples_number(&b->samples, name, "radius"), needed,
        needed >= MOST ? ", and is not quite it" : "");
}

static enum status print_acceleration(const struct bench *b)
{
    static const struct table_column columns[] = {{"net", NULL, TABLE_LEFT},
                                                  {"iteration", NULL, TABLE_LEFT},
                                                  {"10", "L"},
                                                  {"30", "L"},
                                                  {"100", "L"},
                                                  {"300", "L"},
                                                  {"1000", "L"},
                                                  {"each", "us"},
                                                  {"repeats"}};
    char caption[96];

    snprintf(caption, sizeof caption,
             "How far one step at %g s is from its end after so many iterations",
             samples_number(&b->samples, "scene", "time"));
    struct table *t = table_create(sizeof columns / sizeof *columns, columns, caption);
    for (int n = 0; n < SIDES; n++)
        for (int c = 0; c < 2; c++)
            approach_row(t, b, sides[n], c);
    table_note(t,
               "corners_drop undamped, matched triangles, dt = %g ms; largest distance of "
               "a node over the length.",
               1e3 * samples_number(&b->samples, "scene", "step"));
    return table_finish(t, b->format, b->file);
}

static enum status sample(struct bench *b, struct message *why)
{
    enum status st;
    struct scene scene = {0};

    TRY(read_scene(&scene, why));
    samples_add(&b->samples, "scene", "step", scene.step);
    TRY(sample_frames(b, &scene, why));
    for (int n = 0; n < (b->quick ? 1 : SIDES); n++)
        TRY(sample_net(b, &scene, sides[n], why));
out:
    scene_clear(&scene);
    return st;
}

static enum status print(const struct bench *b, struct message *why)
{
    const enum status st = print_frames(b, why);

    return st == STATUS_OK ? print_acceleration(b) : st;
}

const struct bench_part bench_part_projective = {
    .item = {"projective",
             "projective dynamics: local step, solve, frame; what acceleration pays"},
    .sample = sample,
    .print = print};
