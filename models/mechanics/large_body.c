#include "models/mechanics/large_body.h"

#include <math.h>
#include <omp.h>
#include <string.h>

const struct large_path large_path_statics = {.s1 = 1, .g1 = 1};

/* The task of one pass over the elements. */
struct task {
    const struct large_body *body;
    const struct large_path *path;
    const double *x;
    struct large_foresight foresight;
    double *strain, *force; /* outputs; NULL: not wanted                               */
    double (*K)[9];
};

size_t large_body_strains(const struct large_body *b)
{
    return (size_t)b->slab[b->slabs] * b->strains;
}

/* Combines the strains of the path from those at x. */
static void follow_path(const struct task *t, int element, double *strain)
{
    const struct large_path *path = t->path;
    const struct large_body *b = t->body;

    if (path->s0 == 0)
        return;
    const double *old = path->strain_old + (size_t)element * b->strains;
    for (size_t n = 0; n < b->strains; n++) {
        double lag = n < b->lagged ? path->lag : 0;
        strain[n] = (path->s0 - lag) * old[n] + (path->s1 + lag) * strain[n];
        if (path->gain && n < b->lagged)
            strain[n] -= path->back * path->gain[(size_t)element * b->strains + n];
    }
}

static bool do_element(const struct task *t, int thread, int element)
{
    const struct large_body *b = t->body;
    size_t at = (size_t)element * b->strains, bytes = b->strains * sizeof(double);

    if (b->plain && t->K) {
        b->geometry(b->self, thread, element, t->x, 1);
        b->tangent(b->self, thread, element, t->path, t->K);
        return true;
    }
    double *strain = b->strain(b->self, thread, element, t->x,
                               t->foresight.change ? &t->foresight : NULL);

    if (!strain)
        return false;
    if (t->strain) {
        memcpy(t->strain + at, strain, bytes);
        return true;
    }
    b->geometry(b->self, thread, element, t->path->x_old, t->path->g1);
    follow_path(t, element, strain);
    if (t->foresight.strain)
        memcpy(strain, t->foresight.strain + at, bytes);
    if (t->foresight.none)
        memset(strain, 0, bytes);
    if (t->force)
        b->force(b->self, thread, element, t->force);
    if (t->K)
        b->tangent(b->self, thread, element, t->path, t->K);
    return true;
}

/* Returns whether an element of slab n fails. */
static bool do_slab(const struct task *t, int thread, int n)
{
    bool bad = false;

    for (int e = t->body->slab[n]; e < t->body->slab[n + 1]; e++)
        bad |= !do_element(t, thread, e);
    return bad;
}

static enum status do_all(const struct task *t)
{
    const struct large_body *b = t->body;
    const bool alone = b->threads == 1 || b->slabs <= 2; /* opening a region costs more than
                                                            a small net's elements        */
    int slabs = b->slabs, bad = 0;

    for (int phase = 0; phase < 2; phase++) {
        for (int n = phase; alone && n < slabs; n += 2)
            bad |= do_slab(t, 0, n);
        if (alone)
            continue;
#pragma omp parallel for schedule(static) num_threads(b->threads) reduction(| : bad)
        for (int n = phase; n < slabs; n += 2)
            bad |= do_slab(t, omp_get_thread_num(), n);
    }
    if (!bad)
        return STATUS_OK;
    for (int n = 0; n < 3 * b->nodes; n++)
        if (!isfinite(t->x[n]))
            return STATUS_NAN;
    return STATUS_INVERTED;
}

enum status large_body_strain(const struct large_body *b, const double *x, double *strain)
{
    return do_all(&(struct task){.body = b, .x = x, .strain = strain});
}

enum status large_body_force(const struct large_body *b, const struct large_path *path,
                             const double *x, double *force)
{
    memset(force, 0, 3 * (size_t)b->nodes * sizeof *force);
    return do_all(&(struct task){.body = b, .path = path, .x = x, .force = force});
}

enum status large_body_tangent(const struct large_body *b, const struct large_path *path,
                               const double *x, struct large_foresight foresight,
                               double (*K)[9])
{
    if (!b->plain)
        memset(K, 0, (size_t)b->pairs * sizeof *K);
    return do_all(
        &(struct task){.body = b, .path = path, .x = x, .foresight = foresight, .K = K});
}
