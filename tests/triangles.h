/* triangles.h - sheets of triangles for their tests. */
#ifndef TESTS_TRIANGLES_H
#define TESTS_TRIANGLES_H

#include "tests/check.h"
#include "triangles/tri_model.h"
#include "triangles/tri_motion.h"

struct sheet {
    struct scene scene;
    struct discretization d;
    struct tri_motion *m;
    struct counters counters;
};

/* No load, no supports; change scene and d before sheet_start. */
static inline void sheet_init(struct sheet *s, int n, int m)
{
    memset(s, 0, sizeof *s);
    REQUIRE(scene_init(&s->scene) == STATUS_OK);
    model_defaults(&tri_model, &s->d);
    s->d.points[0] = n, s->d.points[1] = m;
}

static inline void sheet_clamp(struct sheet *s)
{
    const struct scene_support edge = {.hi = {0, 1, 1}, .fix = FIX_XYZ};

    REQUIRE(scene_add_support(&s->scene, &edge) == STATUS_OK);
}

static inline void sheet_start(struct sheet *s)
{
    struct message why = {{0}};
    void *state = NULL;

    if (!CHECK(tri_model.create(&s->scene, &s->d, &state, &why) == STATUS_OK)) {
        printf("%s\n", why.text);
        exit(1);
    }
    s->m = state;
}

static inline void sheet_frames(struct sheet *s, int frames)
{
    for (int n = 0; n < frames; n++)
        REQUIRE(tri_model.advance(s->m, &s->counters) == STATUS_OK);
}

/* The mid-surface point (u, v). */
static inline void sheet_point(const struct sheet *s, double u, double v, double xyz[3])
{
    tri_model.probe(s->m, 1, (const double[3]){u, v, 0.5}, xyz);
}

static inline void sheet_clear(struct sheet *s)
{
    tri_model.destroy(s->m);
    scene_clear(&s->scene);
}

#endif
