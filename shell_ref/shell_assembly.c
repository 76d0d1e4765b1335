#include "shell_ref/shell_assembly.h"

#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "models/room.h"

/* Returns how many runs of consecutive numbers an element's nodes are: one for each of its
 * rows along v, where no row ends at the beginning again. */
static int runs_of(const struct shell_space *space)
{
    return space->basis[1].wrap ? space->local : space->direction[0].order;
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

static size_t rest_size(const struct shell_space *space, int rule)
{
    return SHELL_REST_ROWS * (size_t)space->rule[rule].padded;
}

static const struct shell_material *material_of(const struct shell_assembly *s, int element)
{
    return &s->material[element / (s->space->elements / s->sheets)];
}

/* The places where an element's rest data begins, by parts. */
struct rest {
    const double *part[SHELL_PARTS];
};

static struct rest rest_of(const struct shell_assembly *s, int element)
{
    struct rest r;

    for (int part = 0; part < SHELL_PARTS; part++)
        r.part[part] = s->rest[part] + (size_t)element * rest_size(s->space, part);
    return r;
}

/* Adds mass and areas of one element from the areas of its points. */
static void add_mass(struct shell_assembly *s, const struct shell_element *e, int element,
                     const double *area)
{
    const struct shell_points *p = &e->at[SHELL_MASS];
    const int *node = nodes_of(s->space, element);
    const struct shell_material *material = material_of(s, element);
    double sheet = material->density * material->law.thickness;
    int local = e->local, runs = runs_of(s->space), run = local / runs;
    const int *place = s->place + (size_t)element * (size_t)(local * runs);

    for (int a = 0; a < local; a++) {
        const double *Na = p->T + a * p->padded;
        for (int q = 0; q < p->count; q++)
            s->area[node[a]] += area[q] * Na[q];
        for (int b = a; b < local; b++) {
            const double *Nb = p->T + b * p->padded;
            int r = b / run, first = r * run > a ? r * run : a;
            double sum = 0;
            for (int q = 0; q < p->count; q++)
                sum += area[q] * Na[q] * Nb[q];
            s->M[place[a * runs + r] + b - first] += sheet * sum;
        }
    }
}

/* Adds rest data, mass and areas of one element. */
static enum status add_rest(struct shell_assembly *s, struct shell_element *e, int element)
{
    struct shell_place place[SHELL_MAX_POINTS];
    double mass[SHELL_REST_ROWS * SHELL_MAX_POINTS];

    shell_element_load(e, s->space, element, SHELL_RULES);
    gather(s->space, element, s->space->rest, e->X[0]);
    for (int r = 0; r < SHELL_RULES; r++) {
        double *rest =
            r == SHELL_MASS ? mass : s->rest[r] + (size_t)element * rest_size(s->space, r);
        shell_space_places(s->space, r, element, place);
        enum status st = shell_element_rest(e, r, material_of(s, element), place, rest);
        if (st != STATUS_OK)
            return st;
    }
    add_mass(s, e, element, mass + REST_AREA * e->at[SHELL_MASS].padded);
    return STATUS_OK;
}

static double *strain_of(const void *self, int thread, int element, const double *x,
                         const struct large_foresight *foresight)
{
    const struct shell_assembly *s = self;
    struct shell_element *e = &s->work[thread];

    shell_element_load(e, s->space, element, SHELL_PARTS);
    gather(s->space, element, x, e->X[0]);
    if (foresight) {
        gather(s->space, element, foresight->change, e->X[2]);
        gather(s->space, element, foresight->beside, e->X[1]); /* no geometry is set yet */
    }
    return shell_element_strain(e, rest_of(s, element).part, foresight) ? e->strain : NULL;
}

static void set_geometry(const void *self, int thread, int element, const double *x_old,
                         double share)
{
    const struct shell_assembly *s = self;
    struct shell_element *e = &s->work[thread];

    memcpy(e->X[1], e->X[0], 3 * (size_t)e->local * sizeof(double));
    e->same = share == 1;
    if (e->same)
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

    shell_element_force(e, material_of(s, element), rest_of(s, element).part);
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

    shell_element_tangent(e, material_of(s, element), rest_of(s, element).part, path);
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

static enum status energy_of(const void *self, const double *x, double *energy)
{
    const struct shell_assembly *s = self;
    struct shell_element *e = &s->work[0];

    *energy = 0;
    for (int n = 0; n < s->space->elements; n++) {
        shell_element_load(e, s->space, n, SHELL_PARTS);
        gather(s->space, n, x, e->X[0]);
        if (!shell_element_strain(e, rest_of(s, n).part, false))
            return STATUS_NAN;
        *energy += shell_element_energy(e, material_of(s, n), rest_of(s, n).part);
    }
    return STATUS_OK;
}

static struct large_body body_of(const struct shell_assembly *s)
{
    return (struct large_body){.self = s,
                               .nodes = s->space->nodes,
                               .slabs = s->space->slabs,
                               .threads = s->threads,
                               .slab = s->space->slab,
                               .pairs = s->graph.start[s->space->nodes],
                               .strains = shell_room_strains(s->space, SHELL_PARTS),
                               .lagged = shell_room_strains(s->space, SHELL_MEMBRANE),
                               .strain = strain_of,
                               .geometry = set_geometry,
                               .force = add_force,
                               .tangent = add_tangent,
                               .energy = energy_of};
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
                                int sheets, const struct shell_material *material,
                                struct message *why)
{
    enum status st;
    struct shell_assembly new = {.space = space, .sheets = sheets};

    memcpy(new.material, material, (size_t)sheets * sizeof *material);
    TRY(blocks_init(&new.graph, space->nodes, space->elements, space->local, space->ien));
    TRY(blocks_places(&new.graph, space->elements, space->local,
                      space->local / runs_of(space), space->ien, &new.place));
    TRY(room_cut(&new.room, ROOM(new.M, new.graph.start[space->nodes]),
                 ROOM(new.area, space->nodes),
                 ROOM(new.rest[0], (size_t)space->elements * rest_size(space, 0)),
                 ROOM(new.rest[1], (size_t)space->elements * rest_size(space, 1)),
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
