#define _GNU_SOURCE /* sched_setaffinity */
#include "bench/harness/oldtiming.h"

#include <math.h>
#include <sched.h>
#include <stdlib.h>
#include <string.h>

#include "models/clock.h"

int oldtiming_pin(void)
{
    cpu_set_t set;
    int cpu = sched_getcpu();

    if (cpu < 0)
        return -1;
    CPU_ZERO(&set);
    CPU_SET(cpu, &set);
    return sched_setaffinity(0, sizeof set, &set) == 0 ? cpu : -1;
}

void oldtiming_clear(struct oldtiming_case *c)
{
    if (!c)
        return;
    free(c->create);
    free(c->advance);
    c->create = c->advance = NULL;
}

/* One repeat of one case. A death ends it: the seconds left are not a number. */
static enum status run_once(const struct oldtiming_plan *plan,
                            const struct oldtiming_case *c, int repeat, struct message *why)
{
    int frames = c->frames, warmup = frames == plan->frames && !c->rest ? plan->warmup : 0;
    void *state = NULL;
    struct counters counters = {0};
    double *advance = c->advance + (size_t)repeat * (size_t)frames;
    double start = clock_now();
    enum status st = c->model->create(c->scene, c->discretization, &state, why);

    c->create[repeat] = clock_now() - start;
    if (st != STATUS_OK)
        return st;
    for (int n = 0; n < frames; n++)
        advance[n] = NAN;
    for (int n = -warmup; n < frames && st == STATUS_OK; n++) {
        start = clock_now();
        st = c->rest ? c->model->equilibrium(state, &counters, why)
                     : c->model->advance(state, &counters);
        if (n >= 0 && st == STATUS_OK)
            advance[n] = clock_now() - start;
    }
    c->model->destroy(state);
    return status_is_death(st) ? STATUS_OK : st;
}

enum status oldtiming_run(const struct oldtiming_plan *plan, int count,
                          struct oldtiming_case *cases, struct message *why)
{
    enum status st = STATUS_OK;
    size_t repeats = (size_t)plan->repeats;

    for (int n = 0; n < count; n++) {
        if (cases[n].rest)
            cases[n].frames = 1;
        else if (!cases[n].frames)
            cases[n].frames = plan->frames;
        cases[n].create = malloc(repeats * sizeof(double));
        cases[n].advance = malloc(repeats * (size_t)cases[n].frames * sizeof(double));
        if (!cases[n].create || !cases[n].advance)
            st = STATUS_MEMORY;
    }
    for (int r = 0; r < plan->repeats; r++)
        for (int n = 0; n < count && st == STATUS_OK; n++) {
            st = run_once(plan, &cases[n], r, why);
            if (plan->progress)
                plan->progress(plan->context, r * count + n + 1, plan->repeats * count);
        }
    for (int n = 0; n < count && st != STATUS_OK; n++)
        oldtiming_clear(&cases[n]);
    return st;
}
