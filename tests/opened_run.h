/* opened_run.h - runs that must open, for tests that look into them. */
#ifndef TESTS_OPENED_RUN_H
#define TESTS_OPENED_RUN_H

#include "bench/harness/run.h"
#include "models/grid.h"
#include "tests/check.h"

/* Reads a model, or contestant, by its name on a scene with settings, and builds it, so
 * that a test may change things between; end the test if they cannot. */
static inline void opened_read(struct run *run, const char *scene, const char *name,
                               int count, const char *const *text)
{
    struct case_plan plan = {.path = scene};
    struct message why = {""};

    REQUIRE(contestant_find(name, &plan.contestant, NULL) == STATUS_OK);
    settings_list(&plan.settings, count, text);
    REQUIRE_SAY(run_read(run, &plan, &why) == STATUS_OK, "%s: %s", name, why.text);
    settings_clear(&plan.settings);
}

static inline void opened_build(struct run *run)
{
    struct message why = {""};

    REQUIRE_SAY(run_build(run, &why) == STATUS_OK, "%s: %s", run->contestant->name,
                why.text);
}

static inline void opened_run(struct run *run, const char *scene, const char *name,
                              int count, const char *const *text)
{
    opened_read(run, scene, name, count, text);
    opened_build(run);
}

/* Settings are a list that a NULL may end early. */
#define OPENED_LIST(...)                                                                   \
    (int)(sizeof((const char *const[]){__VA_ARGS__}) / sizeof(const char *)),              \
        (const char *const[])                                                              \
    {                                                                                      \
        __VA_ARGS__                                                                        \
    }
#define OPENED_RUN(run, scene, name, ...)                                                  \
    opened_run(run, scene, name, OPENED_LIST(__VA_ARGS__))

/* Advances so many frames. */
static inline struct counters opened_steps(struct run *run, int frames)
{
    struct counters work = {0};

    for (int n = 0; n < frames; n++)
        REQUIRE_SAY(run->model->advance(run->state, &work) == STATUS_OK,
                    "%s dies in frame %d", run->contestant->name, n);
    return work;
}

static inline void opened_settle(struct run *run)
{
    struct counters work = {0};
    struct message why = {""};

    CHECK_SAY(run_settle(run, &work, &why) == STATUS_OK, "%s: %s", run->contestant->name,
              why.text);
}

/* Returns all energy of the sheet and its contact [J]. */
static inline double opened_total(const struct run *run)
{
    struct model_contact c = {0};
    struct energy e;

    run->model->energy(run->state, &e);
    if (run->model->contact && run->scene.obstacle_count)
        run->model->contact(run->state, &c);
    return e.kinetic + e.elastic + e.potential + c.energy;
}

/* Returns the largest |a - b| of two fields' coordinates [m]; NaN if one is. */
static inline double opened_apart(const double *a, const double *b)
{
    double most = 0;

    for (int t = 0; t < 3 * GRID_POINTS; t++)
        if (!(fabs(a[t] - b[t]) <= most))
            most = fabs(a[t] - b[t]);
    return most;
}

/* Returns how far the present field is from the one at rest, shifted by `by` (NULL: 0). */
static inline double opened_off(const struct run *run, const double *by)
{
    static double xyz[3 * GRID_POINTS], want[3 * GRID_POINTS];

    model_sample(run->model, run->state, xyz);
    for (int n = 0; n < GRID_POINTS; n++) {
        double uvw[3];
        grid_point(n, uvw);
        scene_rest_point(&run->scene, uvw, want + 3 * n);
        for (int i = 0; by && i < 3; i++)
            want[3 * n + i] += by[i];
    }
    return opened_apart(xyz, want);
}

#endif
