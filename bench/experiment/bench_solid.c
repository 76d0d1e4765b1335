#include "bench/experiment/bench_solid.h"

#include <math.h>

#include "models/clock.h"
#include "models/mechanics/integrator_newmark.h"
#include "models/solid/solid_model.h"

/* Runs one phase on a solid's state. Assembly comes first; the matrices are afterwards
 * those of the rest shape. */
static enum status run_phase(void *state, enum bench_solid_phase phase)
{
    struct solid_sheet *s = state; /* solid_model.h */
    struct march *m = &s->march;
    const double(*K)[9] = (const double(*)[9])s->assembly.K;

    if (phase == BENCH_SOLID_ASSEMBLE)
        return solid_assembly_compute(&s->assembly, s->space.rest);
    if (phase == BENCH_SOLID_FACTOR)
        return system_factor(&m->system, integrator_newmark_k(m), K,
                             integrator_newmark_m(m), m->M);
    return system_solve(&m->system, m->work); /* of zeros: the same work, no denormals */
}

/* Phases are short: one sample is as many calls as make up SAMPLE seconds. */
static const double SAMPLE = 1e-3;

enum status bench_solid_time(void *state, enum bench_solid_phase phase, int repeats,
                             double *seconds)
{
    double start = clock_processor();
    enum status st = run_phase(state, phase);
    int calls = (int)fmin(100, ceil(SAMPLE / fmax(clock_processor() - start, 1e-7)));

    for (int r = 0; r < repeats && st == STATUS_OK; r++) {
        start = clock_processor();
        for (int n = 0; n < calls && st == STATUS_OK; n++)
            st = run_phase(state, phase);
        seconds[r] = (clock_processor() - start) / calls;
    }
    return st;
}
