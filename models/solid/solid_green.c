#include "models/solid/solid_green.h"

#include <stdlib.h>
#include <string.h>

#include "models/room.h"
#include "models/solid/solid_green_layer.h"

static size_t row_of(const struct solid_space *space)
{
    return SOLID_PADDED((size_t)space->local);
}

static struct solid_green_rest rest_of(const struct solid_green *s, int element)
{
    const struct solid_space *space = s->assembly->space;
    size_t e = (size_t)element, gauss = (size_t)space->gauss, modes = (size_t)space->modes;

    if (space->layer) {
        size_t first = e * (size_t)solid_layer_points(space->layer_points);
        struct solid_green_rest rest = {
            .layer = {.q = s->g + first * SOLID_LAYER_VECTORS * row_of(space),
                      .t = s->n + first * SOLID_LAYER_VECTORS * 3,
                      .dV = s->dV + first}};
        memcpy(rest.layer.points, s->points + SOLID_KINDS * e, sizeof rest.layer.points);
        return rest;
    }
    return (struct solid_green_rest){
        .g = s->g + e * gauss * 3 * row_of(space),
        .dV = s->dV + e * gauss,
        .mode = modes ? s->mode + e * gauss * modes * 3 : NULL,
        .A = modes ? s->A + e * SOLID_GREEN_INTERNAL * SOLID_GREEN_INTERNAL : NULL,
    };
}

static void keep_layer(struct solid_green *s, const struct solid_layer *from, int element)
{
    size_t points = (size_t)solid_layer_points(from->points);

    memcpy(s->points + SOLID_KINDS * element, from->points, sizeof from->points);
    const struct solid_layer_rest rest = rest_of(s, element).layer;
    memcpy((double *)rest.q, from->q,
           points * SOLID_LAYER_VECTORS * (size_t)from->row * sizeof *rest.q);
    memcpy((double *)rest.t, from->t, points * SOLID_LAYER_VECTORS * 3 * sizeof *rest.t);
    memcpy((double *)rest.dV, from->dV, points * sizeof *rest.dV);
}

/* Copies what solid_element_compute found on the rest shape. */
static void keep_rest(struct solid_green *s, const struct solid_element *from, int element)
{
    const struct solid_green_rest rest = rest_of(s, element);
    const size_t gauss = (size_t)from->gauss;

    memcpy((double *)rest.g, from->g, gauss * 3 * (size_t)from->row * sizeof *from->g);
    memcpy((double *)rest.dV, from->dV, gauss * sizeof *from->dV);
    if (!from->modes)
        return;
    memcpy((double *)rest.mode, from->mode,
           gauss * (size_t)from->modes * 3 * sizeof *from->mode);
    memcpy((double *)rest.A, from->A,
           SOLID_GREEN_INTERNAL * SOLID_GREEN_INTERNAL * sizeof *from->A);
}

/* Allocates the rest shape's data. */
static enum status make_room(struct solid_green *s, const struct solid_space *space)
{
    size_t elements = (size_t)space->elements, modes = (size_t)space->modes;
    size_t points =
        elements *
        (size_t)(space->layer ? solid_layer_points(space->layer_points) : space->gauss);
    size_t rows = space->layer ? SOLID_LAYER_VECTORS : 3;
    size_t layers = space->layer ? 1 : 0;

    return room_cut(
        &s->room, ROOM(s->g, points * rows * row_of(space)), ROOM(s->dV, points),
        ROOM(s->points, layers * SOLID_KINDS * elements),
        ROOM(s->n, layers * points * SOLID_LAYER_VECTORS * 3),
        ROOM(s->mode, points * 3 * modes),
        ROOM(s->A, modes ? elements * SOLID_GREEN_INTERNAL * SOLID_GREEN_INTERNAL : 0));
}

static struct solid_green_element *room_of(const struct solid_green *s, int thread)
{
    return &s->assembly->work[thread].green;
}

static const int *nodes_of(const struct solid_space *space, int element)
{
    return space->ien + (size_t)element * (size_t)space->local;
}

/* Gathers x less `from` (NULL: nothing) at an element's nodes. */
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

static bool fill_strains(const struct solid_green *s, struct solid_green_element *e,
                         const struct solid_green_rest *rest, bool change)
{
    return e->layer ? solid_green_layer_strain(e, &rest->layer, change)
                    : solid_green_element_strain(e, &s->assembly->material, rest, change);
}

static double *strain_of(const void *self, int thread, int element, const double *x,
                         const struct large_foresight *foresight)
{
    const struct solid_green *s = self;
    const struct solid_space *space = s->assembly->space;
    struct solid_green_element *e = room_of(s, thread);
    const struct solid_green_rest rest = rest_of(s, element);

    gather(space, element, x, space->rest, e->U[0]);
    if (foresight) {
        gather(space, element, foresight->beside, NULL, e->U[1]); /* no geometry yet */
        gather(space, element, foresight->change, NULL, e->U[2]);
    }
    return fill_strains(s, e, &rest, foresight) ? e->strain : NULL;
}

static void set_geometry(const void *self, int thread, int element, const double *x_old,
                         double share)
{
    const struct solid_green *s = self;
    const struct solid_space *space = s->assembly->space;
    struct solid_green_element *e = room_of(s, thread);

    memcpy(e->U[1], e->U[0], SOLID_LANES * (size_t)e->local * sizeof(double));
    if (share == 1)
        return;
    gather(space, element, x_old, space->rest, e->U[1]);
    for (int n = 0; n < SOLID_LANES * e->local; n++)
        e->U[1][n] = (1 - share) * e->U[1][n] + share * e->U[0][n];
}

static void add_force(const void *self, int thread, int element, double *force)
{
    const struct solid_green *s = self;
    struct solid_green_element *e = room_of(s, thread);
    const int *node = nodes_of(s->assembly->space, element);
    const struct solid_green_rest rest = rest_of(s, element);

    if (e->layer)
        solid_green_layer_force(e, &s->assembly->material, &rest.layer);
    else
        solid_green_element_force(e, &s->assembly->material, &rest);
    for (int a = 0; a < e->local; a++)
        for (int i = 0; i < 3; i++)
            force[3 * (size_t)node[a] + (size_t)i] += e->f[SOLID_LANES * a + i];
}

static void add_tangent(const void *self, int thread, int element,
                        const struct large_path *path, double (*K)[9])
{
    const struct solid_green *s = self;
    const struct solid_green_rest rest = rest_of(s, element);

    solid_assembly_add(s->assembly, room_of(s, thread), &rest, element,
                       path->s1 + path->lag, path->g1, K);
}

enum status solid_green_energy(const void *self, const double *x, double *energy)
{
    const struct solid_green *s = self;
    const struct solid_assembly *a = s->assembly;
    struct solid_green_element *e = room_of(s, 0);

    *energy = 0;
    for (int n = 0; n < a->space->elements; n++) {
        const struct solid_green_rest rest = rest_of(s, n);
        gather(a->space, n, x, a->space->rest, e->U[0]);
        if (!fill_strains(s, e, &rest, false))
            return STATUS_INVERTED;
        *energy += e->layer ? solid_green_layer_energy(e, &a->material, &rest.layer)
                            : solid_green_element_energy(e, &a->material, &rest);
    }
    return STATUS_OK;
}

static struct large_body body_of(const struct solid_green *s)
{
    const struct solid_space *space = s->assembly->space;
    const struct blocks *graph = &s->assembly->graph;
    size_t strains = space->layer ? (size_t)solid_layer_strains(space->layer_points)
                                  : SOLID_GREEN_STRAINS * (size_t)space->gauss;

    return (struct large_body){.self = s,
                               .nodes = space->nodes,
                               .slabs = space->slabs,
                               .threads = s->assembly->threads,
                               .slab = space->slab,
                               .pairs = graph->start[graph->nodes],
                               .strains = strains,
                               .lagged = strains,
                               .strain = strain_of,
                               .geometry = set_geometry,
                               .force = add_force,
                               .tangent = add_tangent,
                               .energy = solid_green_energy};
}

void solid_green_clear(struct solid_green *s)
{
    free(s->room);
    memset(s, 0, sizeof *s);
}

enum status solid_green_init(struct solid_green *s, const struct solid_assembly *assembly)
{
    enum status st;
    const struct solid_space *space = assembly->space;
    struct solid_green new = {.assembly = assembly};

    TRY(make_room(&new, space));
    for (int e = 0; e < space->elements; e++) {
        TRY(solid_element_compute(&assembly->work[0], space, e, &assembly->material,
                                  space->rest));
        if (space->layer)
            keep_layer(&new, assembly->work[0].green.layer, e);
        else
            keep_rest(&new, &assembly->work[0], e);
    }
    *s = new;
    s->body = body_of(s);
    memset(&new, 0, sizeof new);
out:
    solid_green_clear(&new);
    return st;
}
