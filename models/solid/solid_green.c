#include "models/solid/solid_green.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "models/solid/solid_green_stiffness.h"

static size_t row_of(const struct solid_space *space)
{
    return SOLID_PADDED((size_t)space->local);
}

static size_t layer_points(const struct solid_space *space)
{
    return (size_t)(space->layer_points[0] + space->layer_points[1]);
}

static struct solid_green_rest rest_of(const struct solid_green *s, int element)
{
    const struct solid_space *space = s->assembly->space;
    size_t e = (size_t)element, gauss = (size_t)space->gauss, modes = (size_t)space->modes;

    if (space->layer) {
        size_t first = e * layer_points(space);
        return (struct solid_green_rest){
            .layer = {.points = {s->points[2 * e], s->points[2 * e + 1]},
                      .q = s->g + first * SOLID_LAYER_VECTORS * row_of(space),
                      .t = s->n + first * SOLID_LAYER_VECTORS * 3,
                      .dV = s->dV + first}};
    }
    return (struct solid_green_rest){
        .points = s->points[2 * e],
        .plane_stress = space->plane_stress,
        .n = space->plane_stress ? s->n + e * gauss * 3 : NULL,
        .g = s->g + e * gauss * 3 * row_of(space),
        .dV = s->dV + e * gauss,
        .mode = modes ? s->mode + e * gauss * modes * 3 : NULL,
        .A = modes ? s->A + e * SOLID_GREEN_INTERNAL * SOLID_GREEN_INTERNAL : NULL,
    };
}

static void keep_layer(struct solid_green *s, const struct solid_layer *from, int element)
{
    size_t points = (size_t)(from->points[0] + from->points[1]);

    memcpy(s->points + 2 * element, from->points, sizeof from->points);
    const struct solid_layer_rest rest = rest_of(s, element).layer;
    memcpy((double *)rest.q, from->q,
           points * SOLID_LAYER_VECTORS * (size_t)from->row * sizeof *rest.q);
    memcpy((double *)rest.t, from->t, points * SOLID_LAYER_VECTORS * 3 * sizeof *rest.t);
    memcpy((double *)rest.dV, from->dV, points * sizeof *rest.dV);
}

/* Copies what solid_element_compute found on the rest shape. */
static void keep_rest(struct solid_green *s, const struct solid_element *from, int element)
{
    s->points[2 * element] = from->points;
    struct solid_green_rest rest = rest_of(s, element);
    double *g = (double *)rest.g, *dV = (double *)rest.dV, *mode = (double *)rest.mode;
    int local = from->local, modes = from->modes;

    if (rest.plane_stress)
        memcpy((double *)rest.n, from->n, 3 * (size_t)from->points * sizeof *from->n);
    for (int q = 0; q < from->points; q++) {
        dV[q] = from->dV[q];
        for (int i = 0; i < 3; i++) {
            const double *row = from->g + (q * 3 + i) * from->padded;
            memcpy(g + (q * 3 + i) * from->row, row, (size_t)local * sizeof *g);
            for (int m = 0; m < modes; m++)
                mode[(q * modes + m) * 3 + i] = row[local + m];
        }
    }
    if (modes)
        solid_green_element_modes(&s->work[0], &s->assembly->material, &rest,
                                  (double *)rest.A);
}

static double *numbers(size_t count)
{
    double *room = aligned_alloc(64, (count + 7) / 8 * 8 * sizeof *room);

    if (room)
        memset(room, 0, (count + 7) / 8 * 8 * sizeof *room);
    return room;
}

/* Room for what the rest shape gives. */
static enum status make_room(struct solid_green *s, const struct solid_space *space)
{
    size_t elements = (size_t)space->elements, modes = (size_t)space->modes;
    size_t points = elements * (space->layer ? layer_points(space) : (size_t)space->gauss);
    size_t rows = space->layer ? SOLID_LAYER_VECTORS : 3;
    size_t axes = space->layer ? SOLID_LAYER_VECTORS * 3 : space->plane_stress ? 3 : 0;

    s->g = numbers(points * rows * row_of(space));
    s->dV = numbers(points);
    s->points = calloc(2 * elements, sizeof *s->points);
    s->n = axes ? numbers(points * axes) : NULL;
    s->mode = modes ? numbers(points * 3 * modes) : NULL;
    s->A = modes ? numbers(elements * SOLID_GREEN_INTERNAL * SOLID_GREEN_INTERNAL) : NULL;
    return s->g && s->dV && s->points && (s->n || !axes) && (!modes || (s->mode && s->A))
               ? STATUS_OK
               : STATUS_MEMORY;
}

enum status solid_green_init(struct solid_green *s, const struct solid_assembly *assembly)
{
    enum status st;
    const struct solid_space *space = assembly->space;
    struct solid_green new = {.assembly = assembly};

    TRY(make_room(&new, space));
    new.work = calloc((size_t)omp_get_max_threads(), sizeof *new.work);
    if (!new.work)
        TRY(STATUS_MEMORY);
    for (; new.threads < omp_get_max_threads(); new.threads++)
        TRY(solid_green_element_init(&new.work[new.threads], space));
    for (int e = 0; e < space->elements; e++) {
        TRY(solid_element_compute(&assembly->work[0], space, e, &assembly->material,
                                  space->rest));
        if (space->layer)
            keep_layer(&new, assembly->work[0].layer, e);
        else
            keep_rest(&new, &assembly->work[0], e);
    }
    *s = new;
    memset(&new, 0, sizeof new);
out:
    solid_green_clear(&new);
    return st;
}

void solid_green_clear(struct solid_green *s)
{
    if (!s)
        return;
    for (int t = 0; t < s->threads; t++)
        solid_green_element_clear(&s->work[t]);
    free(s->work);
    free(s->g);
    free(s->dV);
    free(s->points);
    free(s->n);
    free(s->mode);
    free(s->A);
    memset(s, 0, sizeof *s);
}

static size_t strains_of(const struct solid_space *space)
{
    return space->layer ? (size_t)solid_layer_strains(space->layer_points)
                        : SOLID_GREEN_STRAINS * (size_t)space->gauss;
}

size_t solid_green_strains(const struct solid_green *s)
{
    return (size_t)s->assembly->space->elements * strains_of(s->assembly->space);
}

static const int *nodes_of(const struct solid_space *space, int element)
{
    return space->ien + (size_t)element * (size_t)space->local;
}

/* x less `from` (NULL: nothing) of an element's nodes. */
static void gather(const struct solid_space *space, int element, const double *x,
                   const double *from, double *U)
{
    const int *node = nodes_of(space, element);

    for (int a = 0; a < space->local; a++)
        for (int i = 0; i < 3; i++) {
            size_t n = 3 * (size_t)node[a] + (size_t)i;
            U[SOLID_LANES * a + i] = from ? x[n] - from[n] : x[n];
        }
}

/* What one pass over the elements is to do. */
struct task {
    const struct solid_green *s;
    const struct large_path *path;
    const double *x;
    struct large_foresight foresight;
    double *strain, *force; /* outputs; NULL: not wanted                               */
    double (*K)[9];
};

static void scatter_force(const struct task *t, const struct solid_green_element *e,
                          int element)
{
    const int *node = nodes_of(t->s->assembly->space, element);

    for (int a = 0; a < e->local; a++)
        for (int i = 0; i < 3; i++)
            t->force[3 * (size_t)node[a] + (size_t)i] += e->f[SOLID_LANES * a + i];
}

static void scatter_tangent(const struct task *t, const struct solid_green_element *e,
                            int element)
{
    const struct solid_assembly *s = t->s->assembly;
    int local = e->local, run = s->run, runs = local / run;
    const int *place = s->place + (size_t)element * (size_t)(local * runs);

    for (int a = 0; a < local; a++)
        for (int r = a / run; r < runs; r++) {
            int first = r * run > a ? r * run : a;
            solid_green_stiffness_blocks(e, &s->material, t->path->s1 + t->path->lag, a,
                                         first, (r + 1) * run, t->K + place[a * runs + r]);
        }
}

/* e->strain and e->U[1] become the strain and the geometry of the path. */
static void follow_path(const struct task *t, struct solid_green_element *e, int element)
{
    const struct large_path *path = t->path;
    size_t strains = strains_of(t->s->assembly->space);
    double g1 = path->g1;

    memcpy(e->U[1], e->U[0], SOLID_LANES * (size_t)e->local * sizeof(double));
    if (g1 != 1) {
        gather(t->s->assembly->space, element, path->x_old, t->s->assembly->space->rest,
               e->U[1]);
        for (int n = 0; n < SOLID_LANES * e->local; n++)
            e->U[1][n] = (1 - g1) * e->U[1][n] + g1 * e->U[0][n];
    }
    if (path->s0 == 0)
        return;
    const double *old = path->strain_old + (size_t)element * strains;
    for (size_t n = 0; n < strains; n++)
        e->strain[n] =
            (path->s0 - path->lag) * old[n] + (path->s1 + path->lag) * e->strain[n];
}

static bool do_element(const struct task *t, struct solid_green_element *e, int element)
{
    const struct solid_green *s = t->s;
    const struct solid_space *space = s->assembly->space;
    const struct solid_material *material = &s->assembly->material;
    const struct solid_green_rest rest = rest_of(s, element);
    size_t bytes = strains_of(space) * sizeof(double);

    gather(space, element, t->x, space->rest, e->U[0]);
    if (t->foresight.change)
        gather(space, element, t->foresight.change, NULL, e->U[2]);
    if (!solid_green_element_strain(e, material, &rest, t->foresight.change))
        return false;
    if (t->strain) {
        memcpy(t->strain + (size_t)element * strains_of(space), e->strain, bytes);
        return true;
    }
    follow_path(t, e, element);
    if (t->foresight.strain)
        memcpy(e->strain, t->foresight.strain + (size_t)element * strains_of(space), bytes);
    if (t->foresight.none)
        memset(e->strain, 0, bytes);
    if (t->force) {
        solid_green_element_force(e, material, &rest);
        scatter_force(t, e, element);
    }
    if (t->K) {
        solid_green_stiffness_compute(e, material, &rest, t->path->s1 + t->path->lag,
                                      t->path->g1);
        scatter_tangent(t, e, element);
    }
    return true;
}

static enum status do_all(const struct task *t)
{
    const struct solid_green *s = t->s;
    const struct solid_space *space = s->assembly->space;
    const int *slab = space->slab;
    int slabs = space->slabs, bad = 0;

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
    for (int n = 0; n < 3 * space->nodes; n++)
        if (!isfinite(t->x[n]))
            return STATUS_NAN;
    return STATUS_INVERTED;
}

enum status solid_green_strain(const struct solid_green *s, const double *x, double *strain)
{
    return do_all(&(struct task){.s = s, .x = x, .strain = strain});
}

enum status solid_green_energy(const struct solid_green *s, const double *x, double *energy)
{
    const struct solid_assembly *a = s->assembly;
    struct solid_green_element *e = &s->work[0];

    *energy = 0;
    for (int n = 0; n < a->space->elements; n++) {
        const struct solid_green_rest rest = rest_of(s, n);
        gather(a->space, n, x, a->space->rest, e->U[0]);
        if (!solid_green_element_strain(e, &a->material, &rest, false))
            return STATUS_INVERTED;
        *energy += solid_green_element_energy(e, &a->material, &rest);
    }
    return STATUS_OK;
}

enum status solid_green_force(const struct solid_green *s, const struct large_path *path,
                              const double *x, double *force)
{
    memset(force, 0, 3 * (size_t)s->assembly->space->nodes * sizeof *force);
    return do_all(&(struct task){.s = s, .path = path, .x = x, .force = force});
}

enum status solid_green_tangent(const struct solid_green *s, const struct large_path *path,
                                const double *x, struct large_foresight foresight,
                                double (*K)[9])
{
    const struct solid_assembly *a = s->assembly;

    memset(K, 0, (size_t)a->graph.start[a->graph.nodes] * sizeof *K);
    return do_all(
        &(struct task){.s = s, .path = path, .x = x, .foresight = foresight, .K = K});
}
