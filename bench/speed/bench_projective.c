#include "bench/speed/bench_projective.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/clock.h"
#include "models/reader/scene_file.h"
#include "projective_dynamics/pd_motion.h"

enum { REPEATS = 15, ITERATIONS = 10 };

/* Aims [ms a frame], and what others took for the same number of constraints. */
static const struct net {
    int points;
    double aim;
    const char *elsewhere;
} nets[] = {
    {10, 0.03,
     "ShapeOp 0.10, Q-Minh 0.095, XPBD 0.065, CHOLMOD loop 0.039 ms (502 constraints)"},
    {32, 0.6,
     "ShapeOp 2.0, Q-Minh 1.6, XPBD 0.75, CHOLMOD loop 0.96 ms (5826 constraints)"},
    {100, 7, "ShapeOp 29, Q-Minh 49, XPBD 7.9, CHOLMOD loop 11.7 ms (59002 constraints)"},
};

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

enum phase { LOCAL, SOLVE, FRAME, PHASES };

static enum status run_phase(struct pd_motion *m, enum phase phase)
{
    struct counters counters = {0};

    if (phase == FRAME)
        return pd_motion_frame(m, &counters);
    if (phase == SOLVE)
        return pd_system_solve(&m->system, m->before); /* zeros: the same work */
    pd_local_step(&m->local, m->x, m->base, m->next);
    return STATUS_OK;
}

/* Repeats of as many calls as take a millisecond, the phases in turn. */
static enum status time_phases(struct pd_motion *m, struct clock_summary summary[PHASES])
{
    enum status st = STATUS_OK;
    double seconds[PHASES][REPEATS];

    for (int r = -1; r < REPEATS; r++) /* -1: warm-up */
        for (int phase = 0; phase < PHASES; phase++) {
            double start = clock_now();
            int calls = 0;
            do {
                TRY(run_phase(m, (enum phase)phase));
                calls++;
            } while (clock_now() - start < 1e-3);
            if (r >= 0)
                seconds[phase][r] = (clock_now() - start) / calls;
        }
    for (int phase = 0; phase < PHASES; phase++)
        summary[phase] = clock_summarise(seconds[phase], REPEATS);
out:
    return st;
}

static enum status frame_row(struct table *t, const struct scene *scene,
                             const struct net *net, enum constraint constraint,
                             struct message *why)
{
    enum status st;
    struct pd_motion m = {0};
    struct clock_summary s[PHASES];
    struct model_size size;
    struct pd_options o = options_of(net->points, constraint, false);

    TRY(pd_motion_init(&m, scene, &o, why));
    TRY(time_phases(&m, s));
    pd_motion_size(&m, &size);
    table_row(t);
    table_text(t, "%dx%d", net->points, net->points);
    table_text(t, "%s", constraint_name(constraint));
    table_integer(t, m.energy.constraints);
    table_integer(t, size.factor_entries);
    table_number(t, 1e3 * s[LOCAL].median, 3);
    table_number(t, 1e3 * s[SOLVE].median, 3);
    table_number(t, 1e3 * s[FRAME].median, 3);
    table_text(t, "%.3g-%.3g", 1e3 * s[FRAME].lower, 1e3 * s[FRAME].upper);
    table_number(t, net->aim, 3);
    table_text(t, "%s", 1e3 * s[FRAME].median <= net->aim ? "yes" : "no");
out:
    pd_motion_clear(&m);
    return st;
}

static enum status print_frames(enum table_format format, const struct scene *scene,
                                struct message *why)
{
    static const struct table_column columns[] = {
        {"net", NULL, TABLE_LEFT}, {"stretch by", NULL, TABLE_LEFT},
        {"constraints", NULL, 0},  {"numbers in L", NULL, 0},
        {"local", "ms", 0},        {"solve", "ms", 0},
        {"frame", "ms", 0},        {"quartiles", "ms", 0},
        {"aim", "ms", 0},          {"reached", NULL, TABLE_LEFT}};
    struct table *t = table_create(
        10, columns, "Projective dynamics, frames of 10 iterations, one thread");
    enum status st = STATUS_OK;

    for (size_t n = 0; n < sizeof nets / sizeof *nets; n++) {
        for (enum constraint c = CONSTRAINT_TRIANGLES; c <= CONSTRAINT_EDGES; c++)
            TRY(frame_row(t, scene, &nets[n], c, why));
        table_note(t, "%d points a side elsewhere, on another machine: %s.", nets[n].points,
                   nets[n].elsewhere);
    }
    table_note(t,
               "Constraints are edges or triangles, and rows of bending; bending about a "
               "flat rest shape lies in the constant matrix and has no local step.");
    TRY(table_print(t, format, stdout));
out:
    table_destroy(t);
    return st;
}

/* --- acceleration ------------------------------------------------------------------------
 */

enum { LENGTHS = 5, START_FRAME = 40, MOST = 400000 };
static const int lengths[LENGTHS] = {10, 30, 100, 300, 1000};

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

/* From `start`: the distance to `end` after each of lengths[], and seconds an iteration. */
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

/* One step of a falling sheet: where it starts, and where its iterations end. */
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

static void approach_row(struct table *t, const struct pd_motion *m, const char *what,
                         const double *distance, double seconds)
{
    table_row(t);
    table_text(t, "%dx%d", m->energy.net.n, m->energy.net.m);
    table_text(t, "%s", what);
    for (int n = 0; n < LENGTHS; n++)
        table_number(t, distance[n] / m->scene->length, 2);
    table_number(t, 1e6 * seconds, 3);
}

static enum status approach_rows(struct table *t, const struct scene *scene, int points,
                                 struct message *why)
{
    enum status st;
    struct pd_motion m = {0};
    struct pd_options o = options_of(points, CONSTRAINT_TRIANGLES, true);
    double *start = NULL, *end = NULL, distance[LENGTHS], seconds;
    int needed;

    TRY(pd_motion_init(&m, scene, &o, why));
    start = pd_net_fields(&m.energy.net, 3);
    end = pd_net_fields(&m.energy.net, 3);
    if (!start || !end)
        TRY(STATUS_MEMORY);
    TRY(find_ends(&m, start, end, &needed));
    TRY(approach(&m, false, start, end, distance, &seconds));
    approach_row(t, &m, "plain", distance, seconds);
    TRY(approach(&m, true, start, end, distance, &seconds));
    approach_row(t, &m, "Chebyshev", distance, seconds);
    table_note(t,
               "%d points a side: radius %.6f; the end itself took %d plain iterations%s.",
               points, m.radius, needed, needed == MOST ? ", and is not quite it" : "");
out:
    pd_net_free_fields(&m.energy.net, start);
    pd_net_free_fields(&m.energy.net, end);
    pd_motion_clear(&m);
    return st;
}

static enum status print_acceleration(enum table_format format, const struct scene *scene,
                                      struct message *why)
{
    static const struct table_column columns[] = {{"net", NULL, TABLE_LEFT},
                                                  {"iteration", NULL, TABLE_LEFT},
                                                  {"10", "L", 0},
                                                  {"30", "L", 0},
                                                  {"100", "L", 0},
                                                  {"300", "L", 0},
                                                  {"1000", "L", 0},
                                                  {"each", "us", 0}};
    struct table *t = table_create(
        8, columns, "How far one step at 0.2 s is from its end after so many iterations");
    enum status st = STATUS_OK;

    TRY(approach_rows(t, scene, 10, why));
    TRY(approach_rows(t, scene, 20, why));
    table_note(t,
               "corners_drop undamped, matched triangles, dt = %g ms; largest distance of "
               "a node over the length.",
               1e3 * scene->step);
    TRY(table_print(t, format, stdout));
out:
    table_destroy(t);
    return st;
}

enum status bench_projective_print(enum table_format format, struct message *why)
{
    enum status st;
    struct scene scene = {0};

    TRY(read_scene(&scene, why));
    TRY(print_frames(format, &scene, why));
    printf("\n");
    TRY(print_acceleration(format, &scene, why));
out:
    scene_clear(&scene);
    return st;
}
