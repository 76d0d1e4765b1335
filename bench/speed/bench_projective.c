/* Times the parts of a frame of projective dynamics; if quick, on the smaller nets. */
#include <stdlib.h>

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

static enum status sample(struct bench *b, struct message *why)
{
    struct scene scene = {0};
    struct made made[NETS * KINDS] = {{{0}}};
    struct samples_task tasks[NETS * KINDS * PHASES];
    int count = 0;
    enum status st;

    TRY(read_scene(&scene, why));
    for (int n = 0; n < KINDS * (b->quick ? NETS - 1 : NETS); n++) {
        const enum constraint constraint = CONSTRAINT_TRIANGLES + n % KINDS;
        struct made *m = &made[n];
        const int points = nets[n / KINDS].points;
        const struct pd_options o = {.points = {points, points},
                                     .constraint = constraint,
                                     .substeps = 1,
                                     .iterations = ITERATIONS};
        struct model_size size;
        name_of(n / KINDS, constraint, m->name);
        TRY(pd_motion_init(&m->motion, &scene, &o, why));
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
    scene_clear(&scene);
    return st;
}

static void add_row(struct table *t, const struct bench *b, int net,
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

static enum status print(const struct bench *b, struct message *why)
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
            add_row(t, b, n, c);
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

const struct bench_part bench_part_projective = {
    .item = {"projective", "projective dynamics: local step, solve, frame"},
    .sample = sample,
    .print = print};
