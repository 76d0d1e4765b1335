#include "shell_ref/shell_assembly.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "models/room.h"
#include "shell_ref/shell_tangent.h"

static int runs_of(const struct shell_space *space)
{
    return space->direction[0].order;
}

static const int *nodes_of(const struct shell_space *space, int element)
{
    return space->ien + (size_t)element * (size_t)space->local;
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

static double *strain_of(const void *self, int thread, int element, const double *x,
                         const double *change)
{
    const struct shell_assembly *s = self;
    struct shell_element *e = &s->work[thread];

    shell_element_load(e, s->space, element);
    gather(s->space, element, x, e->X[0]);
    if (!shell_element_strain(e, rest_of(s, element)))
        return NULL;
    if (change) {
        gather(s->space, element, change, e->X[2]);
        shell_element_foresee(e);
    }
    return e->strain;
}

static void set_geometry(const void *self, int thread, int element, const double *x_old,
                         double share)
{
    const struct shell_assembly *s = self;
    struct shell_element *e = &s->work[thread];

    memcpy(e->X[1], e->X[0], 3 * (size_t)e->local * sizeof(double));
    if (share == 1)
        return;
    gather(s->space, element, x_old, e->X[1]);
    for (int n = 0; n < 3 * e->local; n++)
        e->X[1][n] = (1 - share) * e->X[1][n] + share * e->X[0][n];
}

static void add_force(const void *self, int thread, int element, double *force)
{
    const struct shell_assembly *s = self;
    struct shell_element *e = &s->work[thread];
    const int *node = nodes_of(s->space, element);

    shell_element_force(e, &s->material, rest_of(s, element));
    for (int a = 0; a < e->local; a++)
        for (int i = 0; i < 3; i++)
            force[3 * (size_t)node[a] + (size_t)i] += e->f[3 * a + i];
}

static void add_tangent(const void *self, int thread, int element,
                        const struct large_path *path, double (*K)[9])
{
    const struct shell_assembly *s = self;
    struct shell_element *e = &s->work[thread];
    int local = e->local, row = e->row, runs = runs_of(s->space), run = local / runs;
    const int *place = s->place + (size_t)element * (size_t)(local * runs);

    shell_tangent_compute(e, &s->material, rest_of(s, element), path);
    for (int a = 0; a < local; a++) {
        const double *from = e->K + (size_t)(a * 9 * row);
        for (int r = a / run; r < runs; r++) {
            int first = r * run > a ? r * run : a;
            double(*to)[9] = K + place[a * runs + r];
            for (int b = first; b < (r + 1) * run; b++, to++)
                for (int k = 0; k < 9; k++)
                    (*to)[k] += from[k * row + b];
        }
    }
}

static struct large_body body_of(const struct shell_assembly *s)
{
    size_t strains = SHELL_STRAINS * (size_t)s->space->padded;

    return (struct large_body){.self = s,
                               .nodes = s->space->nodes,
                               .slabs = s->space->slabs,
                               .threads = s->threads,
                               .slab = s->space->slab,
                               .pairs = s->graph.start[s->space->nodes],
                               .strains = strains,
                               .lagged = strains / 2,
                               .strain = strain_of,
                               .geometry = set_geometry,
                               .force = add_force,
                               .tangent = add_tangent};
}

void shell_assembly_clear(struct shell_assembly *s)
{
    for (int t = 0; t < s->threads; t++)
        shell_element_clear(&s->work[t]);
    blocks_clear(&s->graph);
    free(s->place);
    free(s->room);
    memset(s, 0, sizeof *s);
}

enum status shell_assembly_init(struct shell_assembly *s, const struct shell_space *space,
                                const struct shell_material *material, struct message *why)
{
    enum status st;
    struct shell_assembly new = {.space = space, .material = *material};

    TRY(blocks_init(&new.graph, space->nodes, space->elements, space->local, space->ien));
    TRY(blocks_places(&new.graph, space->elements, space->local,
                      space->local / runs_of(space), space->ien, &new.place));
    TRY(room_cut(
        &new.room, ROOM(new.M, new.graph.start[space->nodes]), ROOM(new.area, space->nodes),
        ROOM(new.rest, (size_t)space->elements * SHELL_REST_ROWS * (size_t)space->padded),
        ROOM(new.work, omp_get_max_threads())));
    for (; new.threads < omp_get_max_threads(); new.threads++)
        TRY(shell_element_init(&new.work[new.threads], space));
    for (int e = 0; e < space->elements; e++)
        if ((st = add_rest(&new, &new.work[0], e)) != STATUS_OK) {
            status_fail(why, st, "the rest shape has no normal in element %d", e);
            goto out;
        }
    *s = new;
    s->body = body_of(s);
    memset(&new, 0, sizeof new);
out:
    shell_assembly_clear(&new);
    return st;
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
