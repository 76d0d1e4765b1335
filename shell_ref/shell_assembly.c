#include "shell_ref/shell_assembly.h"

#include <limits.h>
#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "shell_ref/shell_tangent.h"

static int runs_of(const struct shell_space *space)
{
    return space->direction[0].order;
}

static const int *nodes_of(const struct shell_space *space, int element)
{
    return space->ien + (size_t)element * (size_t)space->local;
}

static enum status find_places(struct shell_assembly *s)
{
    const struct shell_space *space = s->space;
    int local = space->local, runs = runs_of(space), run = local / runs;

    s->place = malloc((size_t)space->elements * (size_t)(local * runs) * sizeof *s->place);
    if (!s->place || s->graph.start[space->nodes] > INT_MAX / 9)
        return STATUS_MEMORY;
    for (int e = 0; e < space->elements; e++) {
        const int *node = nodes_of(space, e);
        int *place = s->place + (size_t)e * (size_t)(local * runs);
        for (int a = 0; a < local; a++)
            for (int r = a / run; r < runs; r++) {
                int first = r * run > a ? r * run : a;
                place[a * runs + r] = (int)blocks_find(&s->graph, node[a], node[first]);
            }
    }
    return STATUS_OK;
}

static void gather(const struct shell_space *space, int element, const double *x, double *X)
{
    const int *node = nodes_of(space, element);

    for (int a = 0; a < space->local; a++)
        for (int i = 0; i < 3; i++)
            X[3 * a + i] = x[3 * (size_t)node[a] + (size_t)i];
}

static double *rest_of(const struct shell_assembly *s, int element)
{
    return s->rest + (size_t)element * SHELL_REST_ROWS * (size_t)s->space->padded;
}

/* Rest data, mass and areas of one element. */
static enum status add_rest(struct shell_assembly *s, struct shell_element *e, int element)
{
    const struct shell_space *space = s->space;
    const int *node = nodes_of(space, element);
    double *rest = rest_of(s, element), sheet = s->material.density * s->material.thickness;
    int runs = runs_of(space), run = space->local / runs;
    const int *place = s->place + (size_t)element * (size_t)(space->local * runs);

    shell_element_load(e, space, element);
    gather(space, element, space->rest, e->X[0]);
    enum status st = shell_element_rest(
        e, &s->material, space->parametric + (size_t)element * (size_t)space->padded, rest);
    for (int a = 0; st == STATUS_OK && a < space->local; a++) {
        const double *Na = e->T + a * space->padded;
        for (int q = 0; q < space->gauss; q++)
            s->area[node[a]] += rest[q] * Na[q];
        for (int b = a; b < space->local; b++) {
            const double *Nb = e->T + b * space->padded;
            int r = b / run, first = r * run > a ? r * run : a;
            double sum = 0;
            for (int q = 0; q < space->gauss; q++)
                sum += rest[q] * Na[q] * Nb[q];
            s->M[place[a * runs + r] + b - first] += sheet * sum;
        }
    }
    return st;
}

enum status shell_assembly_init(struct shell_assembly *s, const struct shell_space *space,
                                const struct shell_material *material, struct message *why)
{
    enum status st;
    struct shell_assembly new = {.space = space, .material = *material};

    TRY(blocks_init(&new.graph, space->nodes, space->elements, space->local, space->ien));
    TRY(find_places(&new));
    new.M = calloc((size_t) new.graph.start[space->nodes], sizeof *new.M);
    new.area = calloc((size_t)space->nodes, sizeof *new.area);
    size_t rest = (size_t)space->elements * SHELL_REST_ROWS * (size_t)space->padded;
    new.rest = aligned_alloc(64, (rest + 7) / 8 * 8 * sizeof *new.rest);
    new.work = calloc((size_t)omp_get_max_threads(), sizeof *new.work);
    if (!new.M || !new.area || !new.rest || !new.work)
        TRY(STATUS_MEMORY);
    for (; new.threads < omp_get_max_threads(); new.threads++)
        TRY(shell_element_init(&new.work[new.threads], space));
    for (int e = 0; e < space->elements; e++)
        if ((st = add_rest(&new, &new.work[0], e)) != STATUS_OK) {
            status_fail(why, st, "the rest shape has no normal in element %d", e);
            goto out;
        }
    *s = new;
    memset(&new, 0, sizeof new);
out:
    shell_assembly_clear(&new);
    return st;
}

void shell_assembly_clear(struct shell_assembly *s)
{
    if (!s)
        return;
    for (int t = 0; t < s->threads; t++)
        shell_element_clear(&s->work[t]);
    blocks_clear(&s->graph);
    free(s->M);
    free(s->area);
    free(s->rest);
    free(s->place);
    free(s->work);
    memset(s, 0, sizeof *s);
}

size_t shell_assembly_strains(const struct shell_assembly *s)
{
    return (size_t)s->space->elements * SHELL_STRAINS * (size_t)s->space->padded;
}

/* What one pass over the elements is to do. */
struct task {
    const struct shell_assembly *s;
    const struct large_path *path;
    const double *x;
    struct large_foresight foresight;
    double *strain, *force; /* outputs; NULL: not wanted                               */
    double (*K)[9];
};

static void scatter_force(const struct task *t, const struct shell_element *e, int element)
{
    const int *node = nodes_of(t->s->space, element);

    for (int a = 0; a < e->local; a++)
        for (int i = 0; i < 3; i++)
            t->force[3 * (size_t)node[a] + (size_t)i] += e->f[3 * a + i];
}

static void scatter_tangent(const struct task *t, const struct shell_element *e,
                            int element)
{
    int local = e->local, row = e->row, runs = runs_of(t->s->space), run = local / runs;
    const int *place = t->s->place + (size_t)element * (size_t)(local * runs);

    for (int a = 0; a < local; a++) {
        const double *K = e->K + (size_t)(a * 9 * row);
        for (int r = a / run; r < runs; r++) {
            int first = r * run > a ? r * run : a;
            double(*to)[9] = t->K + place[a * runs + r];
            for (int b = first; b < (r + 1) * run; b++, to++)
                for (int k = 0; k < 9; k++)
                    (*to)[k] += K[k * row + b];
        }
    }
}

/* e->strain and e->X[1] become the strain and the geometry of the path. */
static void follow_path(const struct task *t, struct shell_element *e, int element)
{
    const struct large_path *path = t->path;
    size_t strains = SHELL_STRAINS * (size_t)e->padded;
    double g1 = path->g1;

    memcpy(e->X[1], e->X[0], 3 * (size_t)e->local * sizeof(double));
    if (g1 != 1) {
        gather(t->s->space, element, path->x_old, e->X[1]);
        for (int n = 0; n < 3 * e->local; n++)
            e->X[1][n] = (1 - g1) * e->X[1][n] + g1 * e->X[0][n];
    }
    if (path->s0 == 0)
        return;
    const double *old = path->strain_old + (size_t)element * strains;
    double mu = path->lag;
    for (size_t n = 0; n < strains; n++) {
        double more = n < strains / 2 ? mu : 0;
        e->strain[n] = (path->s0 - more) * old[n] + (path->s1 + more) * e->strain[n];
    }
}

static bool do_element(const struct task *t, struct shell_element *e, int element)
{
    const struct shell_assembly *s = t->s;
    const double *rest = rest_of(s, element);
    size_t strains = SHELL_STRAINS * (size_t)e->padded;

    shell_element_load(e, s->space, element);
    gather(s->space, element, t->x, e->X[0]);
    if (!shell_element_strain(e, rest))
        return false;
    if (t->strain) {
        memcpy(t->strain + (size_t)element * strains, e->strain, strains * sizeof(double));
        return true;
    }
    if (t->foresight.change) {
        gather(s->space, element, t->foresight.change, e->X[2]);
        shell_element_foresee(e);
    }
    follow_path(t, e, element);
    if (t->foresight.strain)
        memcpy(e->strain, t->foresight.strain + (size_t)element * strains,
               strains * sizeof(double));
    if (t->foresight.none)
        memset(e->strain, 0, strains * sizeof(double));
    if (t->force) {
        shell_element_force(e, &s->material, rest);
        scatter_force(t, e, element);
    }
    if (t->K) {
        shell_tangent_compute(e, &s->material, rest, t->path);
        scatter_tangent(t, e, element);
    }
    return true;
}

static enum status do_all(const struct task *t)
{
    const struct shell_assembly *s = t->s;
    const int *slab = s->space->slab;
    int slabs = s->space->slabs, bad = 0;

    for (int phase = 0; phase < 2; phase++) {
#pragma omp parallel for schedule(static)                                                  \
    num_threads(s->threads) if (s->threads > 1 && slabs > 2) reduction(|                   \
                                                                       : bad)
        for (int n = phase; n < slabs; n += 2)
            for (int e = slab[n]; e < slab[n + 1]; e++)
                bad |= !do_element(t, &s->work[omp_get_thread_num()], e);
    }
    if (!bad)
        return STATUS_OK;
    for (int n = 0; n < 3 * s->space->nodes; n++)
        if (!isfinite(t->x[n]))
            return STATUS_NAN;
    return STATUS_INVERTED;
}

enum status shell_assembly_strain(const struct shell_assembly *s, const double *x,
                                  double *strain)
{
    return do_all(&(struct task){.s = s, .x = x, .strain = strain});
}

enum status shell_assembly_energy(const struct shell_assembly *s, const double *x,
                                  double *energy)
{
    struct shell_element *e = &s->work[0];

    *energy = 0;
    for (int n = 0; n < s->space->elements; n++) {
        shell_element_load(e, s->space, n);
        gather(s->space, n, x, e->X[0]);
        if (!shell_element_strain(e, rest_of(s, n)))
            return STATUS_NAN;
        *energy += shell_element_energy(e, &s->material, rest_of(s, n));
    }
    return STATUS_OK;
}

enum status shell_assembly_force(const struct shell_assembly *s,
                                 const struct large_path *path, const double *x,
                                 double *force)
{
    memset(force, 0, 3 * (size_t)s->space->nodes * sizeof *force);
    return do_all(&(struct task){.s = s, .path = path, .x = x, .force = force});
}

enum status shell_assembly_tangent(const struct shell_assembly *s,
                                   const struct large_path *path, const double *x,
                                   struct large_foresight foresight, double (*K)[9])
{
    memset(K, 0, (size_t)s->graph.start[s->space->nodes] * sizeof *K);
    return do_all(
        &(struct task){.s = s, .path = path, .x = x, .foresight = foresight, .K = K});
}
