/* shell_sheet.h - flat sheets as shells through the common contract, for tests: a scene
 * with edges held, a discretization, the state and what it did. */
#ifndef SHELL_SHEET_H
#define SHELL_SHEET_H

#include "shell_ref/shell_model.h"
#include "shell_ref/shell_motion.h"
#include "tests/check.h"

struct sheet {
    struct scene scene;
    struct discretization d;
    void *state; /* begins with a struct shell_motion                                  */
    struct counters counters;
};

/* 1 m x 1 m, no load, no supports, the full rule: that of the truths; change scene and d
 * before sheet_start. */
static inline void sheet_init(struct sheet *s, int p, int spans_u, int spans_v)
{
    memset(s, 0, sizeof *s);
    REQUIRE(scene_init(&s->scene) == STATUS_OK);
    model_defaults(&shell_model, &s->d);
    s->d.remedy = REMEDY_NONE;
    s->d.degree[0] = s->d.degree[1] = p;
    s->d.points[0] = p + spans_u;
    s->d.points[1] = p + spans_v;
}

/* Holds `fix` on the edge where parameter d (0: u, 1: v) is `at`; clamped: through the
 * thickness, else on w = 1/2. */
static inline void sheet_hold(struct sheet *s, int d, double at, unsigned fix, bool clamped)
{
    struct scene_support edge = {.hi = {1, 1, 1}, .fix = fix};

    edge.lo[d] = edge.hi[d] = at;
    if (!clamped)
        edge.lo[2] = edge.hi[2] = 0.5;
    REQUIRE(scene_add_support(&s->scene, &edge) == STATUS_OK);
}

static inline struct shell_motion *sheet_start(struct sheet *s)
{
    struct message why = {{0}};

    if (!CHECK(shell_model.create(&s->scene, &s->d, &s->state, &why) == STATUS_OK)) {
        printf("%s\n", why.text);
        exit(1);
    }
    return s->state;
}

static inline bool sheet_settle(struct sheet *s)
{
    struct message why = {{0}};

    if (CHECK(shell_model.equilibrium(s->state, &s->counters, &why) == STATUS_OK))
        return true;
    printf("%s\n", why.text);
    return false;
}

/* Displacement of the mid-surface point (u,v). */
static inline void sheet_moved(const struct sheet *s, double u, double v, double by[3])
{
    const double uvw[3] = {u, v, 0.5};
    double rest[3];

    scene_rest_point(&s->scene, uvw, rest);
    shell_model.probe(s->state, 1, uvw, by);
    for (int i = 0; i < 3; i++)
        by[i] -= rest[i];
}

static inline void sheet_clear(struct sheet *s)
{
    shell_model.destroy(s->state);
    discretization_clear(&s->d);
    scene_clear(&s->scene);
}

#endif
