/* opened_run.h - runs that must open, for tests that look into them. */
#ifndef TESTS_OPENED_RUN_H
#define TESTS_OPENED_RUN_H

#include "bench/harness/run.h"
#include "models/grid.h"
#include "tests/check.h"

/* A model, or contestant, by its name on a scene with settings; ends the test if it cannot.
 */
static inline void opened_run(struct run *run, const char *scene, const char *name,
                              int count, const char *const *text)
{
    struct settings settings = {0};
    struct run_plan plan = {.path = scene, .settings = &settings};
    struct message why = {""};

    REQUIRE(contestant_find(name, &plan.contestant, NULL) == STATUS_OK);
    settings_list(&settings, count, text);
    if (!CHECK(run_open(run, &plan, &why) == STATUS_OK)) {
        printf("%s: %s\n", name, why.text);
        exit(1);
    }
    settings_clear(&settings);
}

/* Settings are a list that a NULL may end early. */
#define OPENED_RUN(run, scene, name, ...)                                                  \
    opened_run(run, scene, name,                                                           \
               (int)(sizeof((const char *const[]){__VA_ARGS__}) / sizeof(const char *)),   \
               (const char *const[]){__VA_ARGS__})

/* So many frames on. */
static inline struct counters opened_steps(struct run *run, int frames)
{
    struct counters work = {0};

    for (int n = 0; n < frames; n++)
        if (!CHECK(run->model->advance(run->state, &work) == STATUS_OK)) {
            printf("%s dies in frame %d\n", run->contestant->name, n);
            exit(1);
        }
    return work;
}

static inline void opened_settle(struct run *run)
{
    struct counters work = {0};
    struct message why = {""};

    if (!CHECK(run_settle(run, &work, &why) == STATUS_OK))
        printf("%s: %s\n", run->contestant->name, why.text);
}

/* Returns the farthest that any of the grid's points is from rest + shift, by component. */
static inline double opened_deviation(const struct run *run, const double shift[3])
{
    static double xyz[3 * GRID_POINTS];
    double worst = 0;

    run->model->sample(run->state, xyz);
    for (int n = 0; n < GRID_POINTS; n++) {
        double uvw[3], rest[3];
        grid_point(n, uvw);
        scene_rest_point(&run->scene, uvw, rest);
        for (int i = 0; i < 3; i++)
            worst = fmax(worst, fabs(xyz[3 * n + i] - rest[i] - shift[i]));
    }
    return worst;
}

static inline double opened_total(const struct run *run)
{
    struct energy e;

    run->model->energy(run->state, &e);
    return e.kinetic + e.elastic + e.potential;
}

#endif
