/* pd_fixture.h - sheets for the tests of projective dynamics. */
#ifndef TESTS_PD_FIXTURE_H
#define TESTS_PD_FIXTURE_H

#include "projective_dynamics/pd_motion.h"
#include "tests/check.h"

/* A free sheet without loads. */
static inline void pd_fixture_scene(struct scene *scene, double poisson)
{
    REQUIRE(scene_init(scene) == STATUS_OK);
    scene->thickness = 0.01;
    scene->young = 1e4;
    scene->poisson = poisson;
    scene->density = 20;
}

static inline void pd_fixture_hold(struct scene *scene, double u0, double u1, double v0,
                                   double v1, unsigned fix)
{
    struct scene_support s = {.lo = {u0, v0, 0}, .hi = {u1, v1, 1}, .fix = fix};
    REQUIRE(scene_add_support(scene, &s) == STATUS_OK);
}

static inline struct pd_options pd_fixture_options(int n, int m, enum constraint constraint)
{
    return (struct pd_options){
        .points = {n, m}, .constraint = constraint, .substeps = 1, .iterations = 10};
}

static inline void pd_fixture_motion(struct pd_motion *m, const struct scene *scene,
                                     const struct pd_options *options)
{
    struct message why = {{0}};
    CHECK_SAY(pd_motion_init(m, scene, options, &why) == STATUS_OK, "%s", why.text);
    REQUIRE(m->x);
}

static inline void pd_fixture_frames(struct pd_motion *m, int frames)
{
    struct counters counters = {0};
    for (int n = 0; n < frames; n++)
        CHECK(pd_motion_frame(m, &counters) == STATUS_OK);
}

static inline void pd_fixture_close(struct pd_motion *m, struct scene *scene)
{
    pd_motion_clear(m);
    scene_clear(scene);
}

/* Repeatable numbers in [-1,1]. */
static inline double pd_fixture_random(unsigned *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (double)(*seed >> 8) / (1 << 23) - 1;
}

/* Moves every node of three fields by up to `size`. */
static inline void pd_fixture_shake(const struct pd_net *net, double *x, double size,
                                    unsigned seed)
{
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < net->nodes; k++)
            x[c * pd_net_stride(net) + k] += size * pd_fixture_random(&seed);
}

/* Returns the largest length of an edge over its rest length. */
static inline double pd_fixture_longest(const struct pd_motion *m)
{
    const struct pd_net *net = &m->energy.net;
    double most = 0;

    for (int kind = 0; kind < PD_EDGES; kind++)
        for (int k = 0; k < net->nodes; k++) {
            int to[2];
            double sum = 0;
            if (!pd_net_has(net, (enum pd_edge)kind, k))
                continue;
            pd_net_ends(net, (enum pd_edge)kind, to);
            for (int c = 0; c < 3; c++) {
                const double *x = m->x + c * pd_net_stride(net) + k;
                sum += (x[to[1]] - x[to[0]]) * (x[to[1]] - x[to[0]]);
            }
            most = fmax(most, sqrt(sum) / pd_net_length(net, (enum pd_edge)kind));
        }
    return most;
}

static inline double pd_fixture_distance(const struct pd_net *net, const double *x,
                                         const double *y)
{
    double most = 0;
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < net->nodes; k++)
            most = fmax(
                most, fabs(x[c * pd_net_stride(net) + k] - y[c * pd_net_stride(net) + k]));
    return most;
}

#endif
