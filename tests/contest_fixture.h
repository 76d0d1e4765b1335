/* contest_fixture.h - contests whose runs are made up: what each took, and how far off it
 * was.
 */
#ifndef CONTEST_FIXTURE_H
#define CONTEST_FIXTURE_H

#include "bench/compare/contest.h"
#include "models/grid.h"
#include "tests/run_fixture.h"

enum { TIMES = 2 };

static struct {
    struct scene scene;
    struct truth truth;
    double time[TIMES], error[TIMES];
    double *xyz[TIMES];
} world;

/* A sheet of 2 m that the truth leaves at the origin; frames of 4 ms, seen for 0.2 s; error
 * bars of 1 and 2 % of L. */
static inline struct contest make(void)
{
    REQUIRE(scene_init(&world.scene) == STATUS_OK);
    free(world.scene.name);
    world.scene.name = strdup("made_up");
    world.scene.length = world.scene.width = 2, world.scene.step = 4e-3;
    for (int t = 0; t < TIMES; t++) {
        world.time[t] = 0.1 * (t + 1), world.error[t] = 0.02 * (t + 1);
        world.xyz[t] = calloc(3 * GRID_POINTS, sizeof **world.xyz);
        REQUIRE(world.xyz[t]);
    }
    world.truth = (struct truth){TIMES, world.time, world.xyz, world.error, "made up"};
    return (struct contest){
        .scene = &world.scene, .truth = &world.truth, .physics = "as told"};
}

static inline void unmake(struct contest *c)
{
    contest_clear(c);
    for (int t = 0; t < TIMES; t++)
        free(world.xyz[t]);
    scene_clear(&world.scene);
}

enum { PROBE = 1, EARLY = 2, DIES = 4, REFUSES = 8, LATE = 16 };

/* A run: how refined, seconds, error at its worst time (the later one, unless EARLY). */
struct run_of {
    int side, divisor, iterations;
    double seconds, worst;
    unsigned how;
    int across; /* 0: cells about square */
};

static inline void add(struct contest *c, const char *who, const struct run_of *run)
{
    const int across = run->across ? run->across : contest_across(c, named(who), run->side);
    const int early = !!(run->how & EARLY);
    struct contest_row *row =
        contest_add(c, &(struct contest_at){
                           named(who), {run->side, across, run->divisor, run->iterations}});

    row->probe = run->how & PROBE;
    row->seconds = row->probe ? NAN : run->seconds;
    row->error[early] = run->worst / 2, row->error[!early] = row->worst = run->worst;
    if (run->how & DIES)
        row->error[0] = 0.3;
    row->absent = run->how & LATE;
    if (run->how & (REFUSES | LATE))
        row->error[0] = NAN;
    if (run->how & (DIES | REFUSES | LATE))
        row->error[1] = row->worst = NAN;
    row->result.outcome = run->how & REFUSES ? STATUS_INPUT
                          : run->how & DIES  ? STATUS_ESCAPED
                                             : STATUS_OK;
    row->result.death_time = 0.15;
    row->result.unknowns = 100 * run->side;
    row->result.steps = 50;
    row->result.create = (struct clock_summary){.median = run->seconds / 5, .count = 7};
    row->result.bytes = 1e6 * run->seconds;
    row->result.step =
        (struct clock_summary){.median = run->seconds * 0.8 / 50, .count = 9};
    run_result_tell(&row->result, "would not");
}

#endif
