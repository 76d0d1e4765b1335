#define _GNU_SOURCE /* sched_setaffinity */
#include "bench/harness/timing.h"

#include <math.h>
#include <omp.h>
#include <sched.h>
#include <string.h>

#include "bench/harness/motion.h"
#include "models/clock.h"

/* The processors that this program may use, before it was pinned to one of them. */
static cpu_set_t everywhere;
static bool everywhere_known;

void timing_alone(void)
{
    const int cpu = sched_getcpu();
    cpu_set_t here;

    omp_set_num_threads(1);
    if (!everywhere_known)
        everywhere_known = sched_getaffinity(0, sizeof everywhere, &everywhere) == 0;
    if (cpu < 0)
        return;
    CPU_ZERO(&here);
    CPU_SET(cpu, &here);
    sched_setaffinity(0, sizeof here, &here);
}

void timing_apart(void)
{
    if (everywhere_known)
        sched_setaffinity(0, sizeof everywhere, &everywhere);
}

int timing_processors(void)
{
    return everywhere_known ? CPU_COUNT(&everywhere) : omp_get_num_procs();
}

void timing_clear(struct timing_case *c)
{
    arena_clear(&c->arena);
    c->create = c->advance = NULL;
}

static enum status step(const struct timing_case *c, struct run *fresh, double *seconds,
                        struct message *why)
{
    struct motion m SCOPED(motion_clear) = {0};

    motion_init(&m, fresh->model, &fresh->scene, fresh->state);
    m.judged = true;
    m.until = c->until;
    m.clock = clock_processor;
    m.frame_count =
        c->warmup + c->frames < m.frame_count ? c->warmup + c->frames : m.frame_count;
    CALL(motion_run(&m, NULL, NULL, true, why));
    for (int n = c->warmup; n < m.frames; n++)
        seconds[n - c->warmup] = m.seconds[n];
    return STATUS_OK;
}

static enum status settle(struct run *fresh, double *seconds, struct message *why)
{
    struct counters work = {0};
    const double start = clock_processor();
    const enum status st = run_settle(fresh, &work, why);

    if (st == STATUS_OK)
        *seconds = clock_processor() - start;
    return status_is_death(st) ? STATUS_OK : st;
}

/* Times one repeat of one case; only the state is new. */
static enum status run_once(struct timing_case *c, int repeat, struct message *why)
{
    struct run fresh = *c->run;
    const double before = clock_allocated();
    double *advance = c->advance + (size_t)repeat * (size_t)c->frames;
    enum status st;

    fresh.state = NULL;
    for (int n = 0; n < c->frames; n++)
        advance[n] = NAN;
    TRY(run_build(&fresh, why));
    c->create[repeat] = fresh.create_seconds;
    st = c->rest ? settle(&fresh, advance, why) : step(c, &fresh, advance, why);
    if (repeat == 0) /* later the libraries keep memory */
        c->bytes = clock_allocated() - before;
out:
    model_destroy(fresh.model, fresh.state);
    return st;
}

static void make_room(struct timing_case *c)
{
    const size_t repeats = c->repeats ? (size_t)c->repeats : TIMING_REPEATS;

    if (c->rest)
        c->frames = 1, c->warmup = 0;
    c->create = arena_take(&c->arena, repeats, sizeof(double));
    c->advance = arena_take(&c->arena, repeats * (size_t)c->frames, sizeof(double));
}

int timing_repeats(double seconds, bool quick)
{
    return quick                     ? TIMING_REPEATS_QUICK
           : seconds <= TIMING_SHORT ? TIMING_REPEATS
                                     : TIMING_REPEATS_LONG;
}

/* Times the r-th repeat of all cases that have one. */
static enum status run_round(const struct timing_plan *plan, int r, int count,
                             struct timing_case *cases, struct message *why)
{
    enum status st = STATUS_OK;

    for (int n = 0; n < count && st == STATUS_OK; n++) {
        struct timing_case *c = &cases[n];
        const double start = clock_now();
        if (r > 0 && r >= c->repeats)
            continue;
        st = run_once(c, r, why);
        if (!c->repeats) /* the first has shown how long it takes */
            c->repeats = timing_repeats(clock_now() - start, plan->quick);
        if (plan->progress)
            plan->progress(plan->context, r * count + n + 1, TIMING_REPEATS * count);
    }
    return st;
}

enum status timing_run(const struct timing_plan *plan, int count, struct timing_case *cases,
                       struct message *why)
{
    enum status st = STATUS_OK;
    int most = 1;

    for (int n = 0; n < count; n++)
        make_room(&cases[n]);
    for (int r = 0; r < most && st == STATUS_OK; r++) {
        st = run_round(plan, r, count, cases, why);
        for (int n = 0; n < count; n++)
            most = cases[n].repeats > most ? cases[n].repeats : most;
    }
    if (plan->progress && count && st == STATUS_OK)
        plan->progress(plan->context, TIMING_REPEATS * count, TIMING_REPEATS * count);
    for (int n = 0; n < count && st != STATUS_OK; n++)
        timing_clear(&cases[n]);
    return st;
}
