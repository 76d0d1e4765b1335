/* explicit_sheet.h - a soft sheet as shell and solids, to be stepped explicitly, for tests.
 */
#ifndef EXPLICIT_SHEET_H
#define EXPLICIT_SHEET_H

#include "fem_ref/hex_model.h"
#include "iga/plate_model.h"
#include "models/reader/scene_file.h"
#include "shell_ref/shell_model.h"
#include "tests/check.h"

enum { MOST_SETTINGS = 16 };

/* A thick, soft sheet: it bends a lot, and a solid's steps are not many. */
static const char *const SOFT[] = {"sheet.thickness=0.05", "material.young=1000",
                                   "damping.kind=none", NULL};

static const struct kind {
    const char *name;
    const struct model *model;
    const char *settings[4];
} kinds[] = {
    {"shell, row sums, p = 2",
     &shell_model,
     {"discretization.points=[7,6]", "discretization.degree=[2,2]"}},
    {"shell, row sums, p = 3", &shell_model, {"discretization.points=[7,6]"}},
    {"iga, row sums, p = 3", &plate_model, {"discretization.points=[6,5,2]"}},
    {"hex, row sums", &hex_model, {"discretization.points=[7,4,2]"}},
};
enum { KINDS = sizeof kinds / sizeof *kinds };

struct run {
    const struct model *model;
    struct scene scene;
    struct discretization d;
    void *state;
    struct counters counters;
    struct message why;
};

static inline void add(const char **list, const char *const *more, int most)
{
    int n = 0;

    while (list[n])
        n++;
    for (int k = 0; k < most && more && more[k]; k++, n++) {
        REQUIRE(n < MOST_SETTINGS);
        list[n] = more[k];
    }
}

/* edge_drop as a soft sheet, with the kind's settings and more of them; leapfrog unless
 * those say otherwise. Not made yet. */
static inline void read_run(struct run *r, const struct kind *k, const char *const *more)
{
    const char *list[MOST_SETTINGS + 1] = {NULL};
    int count = 0;

    *r = (struct run){.model = k->model};
    model_defaults(k->model, &r->d);
    r->d.integrator = INTEGRATOR_LEAPFROG;
    add(list, SOFT, MOST_SETTINGS);
    add(list, k->settings, 4);
    add(list, more, MOST_SETTINGS);
    while (list[count])
        count++;
    if (!CHECK(scene_file_read(SOURCE_DIR "/models/scenes/edge_drop.yaml", count, list,
                               &r->scene, &r->d, &r->why) == STATUS_OK)) {
        printf("%s\n", r->why.text);
        exit(1);
    }
}

static inline void make_run(struct run *r)
{
    if (!CHECK(r->model->create(&r->scene, &r->d, &r->state, &r->why) == STATUS_OK)) {
        printf("%s\n", r->why.text);
        exit(1);
    }
}

static inline void open_run(struct run *r, const struct kind *k, const char *const *more)
{
    read_run(r, k, more);
    make_run(r);
}

#define WITH(...) ((const char *const[]){__VA_ARGS__, NULL})

static inline void close_run(struct run *r)
{
    if (r->state)
        r->model->destroy(r->state);
    scene_clear(&r->scene);
    discretization_clear(&r->d);
}

static inline enum status steps(struct run *r, int count)
{
    enum status st = STATUS_OK;

    for (int n = 0; n < count && st == STATUS_OK; n++)
        st = r->model->advance(r->state, &r->counters);
    return st;
}

static inline double total(const struct run *r)
{
    struct energy e;

    r->model->energy(r->state, &e);
    return e.kinetic + e.elastic + e.potential;
}

static inline void tip(const struct run *r, double at[3])
{
    r->model->probe(r->state, 1, (const double[]){1, 0.3, 0.5}, at);
}

static inline double distance(const double a[3], const double b[3])
{
    return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

#endif
