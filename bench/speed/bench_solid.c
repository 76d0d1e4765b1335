#include "bench/speed/bench_solid.h"

#include <math.h>
#include <stdlib.h>

#include "bench/harness/registry.h"
#include "models/reader/scene_file.h"
#include "models/solid/solid_motion.h"

/* A case made: scene, discretization and state. */
struct made {
    const struct model *model;
    struct scene scene;
    struct discretization d;
    void *state;
};

static void unmake(struct made *m)
{
    if (m->model)
        m->model->destroy(m->state);
    scene_clear(&m->scene);
    discretization_clear(&m->d);
}

static enum status make(const char *model, const char *const *settings, struct made *m,
                        double *seconds, struct message *why)
{
    enum status st;
    char *path = NULL;
    int count = 0;

    *m = (struct made){0};
    while (settings[count])
        count++;
    TRY(registry_find(model, &m->model, why));
    m->model->defaults(&m->d);
    TRY(scene_file_find("edge_drop", &path, why));
    TRY(scene_file_read(path, count, settings, &m->scene, &m->d, why));
    double start = clock_now();
    TRY(m->model->create(&m->scene, &m->d, &m->state, why));
    *seconds = clock_now() - start;
out:
    free(path);
    return st;
}

static enum status run_phase(const struct model *model, void *state,
                             enum bench_solid_phase phase)
{
    struct solid_motion *motion = state; /* solid_model.h */
    const double(*K)[9] = (const double(*)[9])motion->assembly.K;
    struct counters counters = {0};

    switch (phase) {
    case BENCH_SOLID_ASSEMBLE:
        return solid_assembly_compute(&motion->assembly, motion->space->rest);
    case BENCH_SOLID_FACTOR:
        return system_factor(&motion->system, newmark_k(&motion->newmark), K,
                             newmark_m(&motion->newmark), motion->assembly.M);
    case BENCH_SOLID_SOLVE: /* of zeros: the same work, and no denormals */
        return system_solve(&motion->system, motion->newmark.work);
    default:
        return model->advance(state, &counters);
    }
}

/* Phases are short: one sample is as many calls as make up SAMPLE seconds. */
static const double SAMPLE = 1e-3;

enum status bench_solid_time(const struct model *model, void *state,
                             enum bench_solid_phase phase, int repeats, double *seconds)
{
    double start = clock_now();
    enum status st = run_phase(model, state, phase);
    int calls = (int)fmin(100, ceil(SAMPLE / fmax(clock_now() - start, 1e-7)));

    if (phase == BENCH_SOLID_FRAME)
        calls = 1; /* frames move the sheet: few of them */
    for (int r = 0; r < repeats && st == STATUS_OK; r++) {
        start = clock_now();
        for (int n = 0; n < calls && st == STATUS_OK; n++)
            st = run_phase(model, state, phase);
        seconds[r] = (clock_now() - start) / calls;
    }
    return st;
}

static enum status time_phase(struct made *m, enum bench_solid_phase phase, int repeats,
                              struct clock_summary *summary)
{
    double *seconds = malloc((size_t)repeats * sizeof *seconds);
    enum status st = seconds ? bench_solid_time(m->model, m->state, phase, repeats, seconds)
                             : STATUS_MEMORY;

    if (st == STATUS_OK)
        *summary = clock_summarise(seconds, repeats);
    free(seconds);
    return st;
}

enum status bench_solid_measure(const char *model, const char *const *settings, int repeats,
                                struct bench_solid *b, struct message *why)
{
    struct made m;
    enum status st;

    TRY(make(model, settings, &m, &b->create, why));
    m.model->size(m.state, &b->size);
    TRY(time_phase(&m, BENCH_SOLID_FRAME, repeats, &b->frame));
    TRY(time_phase(&m, BENCH_SOLID_ASSEMBLE, repeats, &b->assemble));
    TRY(time_phase(&m, BENCH_SOLID_FACTOR, repeats, &b->factor));
    TRY(time_phase(&m, BENCH_SOLID_SOLVE, repeats, &b->solve));
out:
    unmake(&m);
    return st;
}

enum status bench_solid_matrix(const char *model, const char *const *settings,
                               enum status (*use)(const struct bench_matrix *A,
                                                  void *context),
                               void *context, struct message *why)
{
    struct made m;
    double seconds, *value = NULL;
    long *start = NULL;
    int *row = NULL;
    enum status st;

    TRY(make(model, settings, &m, &seconds, why));
    struct solid_motion *motion = m.state;
    TRY(system_columns(&motion->assembly.graph, &motion->supports, NULL,
                       newmark_k(&motion->newmark), (const double(*)[9])motion->assembly.K,
                       newmark_m(&motion->newmark), motion->assembly.M, &start, &row,
                       &value));
    TRY(use(&(struct bench_matrix){motion->supports.free_count, start, row, value},
            context));
out:
    unmake(&m);
    free(start);
    free(row);
    free(value);
    return st;
}
