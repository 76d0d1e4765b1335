/* mass_spring.h - the net that its tests share. */
#ifndef TESTS_MASS_SPRING_H
#define TESTS_MASS_SPRING_H

#include <omp.h>

#include "bench/harness/contestant.h"
#include "mass_spring/spring_motion.h"
#include "models/vector.h"
#include "tests/check.h"
#include "tests/noise.h"

/* A sheet in SI numbers of cloth, held along u = 0 unless `free`. */
static inline void fill_scene(struct scene *scene, bool held)
{
    struct scene_support edge = {.lo = {0, 0, 0}, .hi = {0, 1, 1}, .fix = FIX_XYZ};

    REQUIRE(scene_init(scene) == STATUS_OK);
    scene->length = 0.6;
    scene->width = 0.5;
    scene->thickness = 0.01;
    scene->young = 1e5;
    scene->poisson = 0.3;
    scene->density = 0.5;
    scene->gravity[0] = 1.5;
    scene->gravity[2] = -9.81;
    if (held)
        REQUIRE(scene_add_support(scene, &edge) == STATUS_OK);
}

static inline struct discretization net_of(int n, int m)
{
    struct discretization d;
    const struct contestant *c = NULL;

    REQUIRE(contestant_find("mass_spring", &c, NULL) == STATUS_OK);
    model_defaults(c->model, &d);
    d.points[0] = n, d.points[1] = m;
    return d;
}

/* A net that moves. */
struct springs {
    struct scene scene;
    struct discretization d;
    struct spring_motion m;
    struct counters counters;
};

/* Change scene and d before springs_start. */
static inline void springs_init(struct springs *s, int n, int m, bool held)
{
    *s = (struct springs){.d = net_of(n, m)};
    fill_scene(&s->scene, held);
}

static inline void springs_start(struct springs *s)
{
    struct message why = {{0}};

    CHECK_SAY(spring_motion_init(&s->m, &s->scene, &s->d, &why) == STATUS_OK, "%s",
              why.text);
    REQUIRE(s->m.net.x);
}

static inline void springs_steps(struct springs *s, int count)
{
    for (int n = 0; n < count; n++)
        CHECK(spring_motion_step(&s->m, &s->counters) == STATUS_OK);
}

static inline double springs_energy(struct springs *s)
{
    struct energy e;

    spring_motion_energy(&s->m, &e);
    return e.kinetic + e.elastic + e.potential;
}

static inline void springs_clear(struct springs *s)
{
    spring_motion_clear(&s->m);
    scene_clear(&s->scene);
}

/* Returns the largest elongation of any spring, (l - r) / r. */
static inline double springs_strain(const struct springs *s)
{
    double most = -1, e[3];

    for (int n = 0; n < s->m.springs.spring_count; n++) {
        const struct spring *one = &s->m.springs.springs[n];
        vector_between(s->m.net.x + 3 * one->a, s->m.net.x + 3 * one->b, e);
        most = fmax(most, vector_length(e) / one->length - 1);
    }
    return most;
}

#endif
