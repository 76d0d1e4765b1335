/* The same bits for 1, 2 and 4 threads: assembled matrices, and frames of motion that
 * rebuild them, on nets of a few slabs and of many.
 *
 *   threads iga|hex
 */
#include <omp.h>

#include "models/solid/solid_model.h"
#include "tests/plate_fixture.h"

#ifdef __SANITIZE_ADDRESS__
enum { FRAMES = 4 }; /* several times dearer, and the same code every frame */
#else
enum { FRAMES = 20 };
#endif

/* What one run leaves: K, M and volume at rest, then positions of frames, then K, M and
 * volume of the last one. */
struct trace {
    size_t count;
    double *value;
};

static void append(struct trace *t, size_t count, const double *value)
{
    t->value = realloc(t->value, (t->count + count) * sizeof *value);
    REQUIRE(t->value);
    memcpy(t->value + t->count, value, count * sizeof *value);
    t->count += count;
}

static void append_matrices(struct trace *t, const struct solid_motion *m)
{
    const struct solid_assembly *s = &m->assembly;
    size_t pairs = (size_t)s->graph.start[s->graph.nodes];

    append(t, 9 * pairs, s->K[0]);
    append(t, pairs, s->M);
    append(t, (size_t)s->graph.nodes, s->volume);
}

static struct trace run(const struct model *model, const struct discretization *d,
                        int threads)
{
    struct counters counters = {0};
    struct message why = {""};
    struct trace trace = {0};
    struct scene scene;
    void *state = NULL;

    omp_set_num_threads(threads);
    plate_scene(&scene, 1e-3, 0.3);
    plate_hold(&scene, 0, 0, FIX_XYZ);
    scene.density = 0.5;
    scene.gravity[2] = -9.81;
    scene.damping = (struct scene_damping){.kind = DAMPING_VELOCITY_SCALE, .value = 0.5};
    REQUIRE(model->create(&scene, d, &state, &why) == STATUS_OK);
    const struct solid_motion *m = state; /* solid_model.h: a state begins with it */
    CHECK(m->assembly.threads == threads);
    append_matrices(&trace, m);
    for (int n = 0; n < FRAMES; n++) {
        CHECK(model->advance(state, &counters) == STATUS_OK);
        append(&trace, 3 * (size_t)m->space->nodes, m->x);
    }
    append_matrices(&trace, m);
    CHECK(m->x[3 * m->space->nodes - 4] <
          0); /* it fell: frames had something to differ in */
    model->destroy(state);
    scene_clear(&scene);
    return trace;
}

static void check_threads(const struct model *model, const struct discretization *d)
{
    struct trace one = run(model, d, 1);

    for (int threads = 2; threads <= 4; threads += 2) {
        struct trace many = run(model, d, threads);
        CHECK(many.count == one.count);
        if (!CHECK(!memcmp(many.value, one.value, one.count * sizeof *one.value)))
            printf("  %s, %d x %d x %d points, %d threads\n", model->name, d->points[0],
                   d->points[1], d->points[2], threads);
        free(many.value);
    }
    free(one.value);
}

int main(int argc, char **argv)
{
    struct discretization d;

    REQUIRE(argc == 2);
    if (!strcmp(argv[1], "iga")) {
        static const int nets[][2][3] = {
            {{2, 2, 1}, {10, 10, 2}}, {{2, 2, 1}, {26, 20, 2}}, {{3, 2, 2}, {12, 9, 4}}};
        for (size_t n = 0; n < sizeof nets / sizeof *nets; n++) {
            const int *p = nets[n][0], *points = nets[n][1];
            d = plate_degrees(p[0], p[1], p[2], points[0], points[1], points[2]);
            d.kinematics = KINEMATICS_PRINTED;
            check_threads(&plate_model, &d);
        }
        return check_result();
    }
    for (int n = 16; n <= 32; n += 16) {
        d = plate_degrees(1, 1, 1, n, n, 2);
        d.kinematics = KINEMATICS_PRINTED;
        check_threads(&hex_model, &d);
        d.remedy = REMEDY_INCOMPATIBLE;
        check_threads(&hex_model, &d);
    }
    return check_result();
}
