#include "models/solid/solid_assembly.h"

#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "models/room.h"
#include "models/solid/solid_green_layer.h"

static bool runs_of(const struct solid_space *s, int run)
{
    for (long t = 0; t < (long)s->elements * s->local; t += run)
        for (int k = 1; k < run; k++)
            if (s->ien[t + k] != s->ien[t] + k)
                return false;
    return true;
}

static int longest_run(const struct solid_space *s)
{
    for (int run = s->local; run > 1; run--)
        if (s->local % run == 0 && runs_of(s, run))
            return run;
    return 1;
}

void solid_assembly_clear(struct solid_assembly *s)
{
    for (int t = 0; t < s->threads; t++) {
        solid_element_clear(&s->work[t]);
        solid_batch_destroy(s->batch[t]);
    }
    blocks_clear(&s->graph);
    free(s->place);
    free(s->room);
    memset(s, 0, sizeof *s);
}

enum status solid_assembly_init(struct solid_assembly *s, const struct solid_space *space,
                                const struct solid_material *material)
{
    enum status st;
    struct solid_assembly new = {.space = space, .material = *material};

    TRY(blocks_init(&new.graph, space->nodes, space->elements, space->local, space->ien));
    new.run = longest_run(space);
    TRY(blocks_places(&new.graph, space->elements, space->local, new.run, space->ien,
                      &new.place));
    size_t pairs = (size_t) new.graph.start[space->nodes];
    TRY(room_cut(&new.room, ROOM(new.K, pairs), ROOM(new.M, pairs),
                 ROOM(new.volume, space->nodes), ROOM(new.work, omp_get_max_threads()),
                 ROOM(new.batch, omp_get_max_threads())));
    for (int t = 0; t < omp_get_max_threads(); t++) {
        new.threads = t + 1;
        TRY(solid_element_init(&new.work[t], space));
        TRY(solid_batch_create(space, &new.batch[t]));
    }
    HAND_OVER(s, new);
out:
    solid_assembly_clear(&new);
    return st;
}

void solid_assembly_add(const struct solid_assembly *s, struct solid_green_element *e,
                        const struct solid_green_rest *rest, int element,
                        double stress_share, double geometry_share, double (*K)[9])
{
    const int local = e->local, run = s->run, runs = local / run;
    const int *place = s->place + (size_t)element * (size_t)(local * runs);

    if (e->layer)
        solid_green_layer_stiffness(e, &s->material, &rest->layer, geometry_share);
    else
        solid_green_element_stiffness(e, &s->material, rest, stress_share, geometry_share);
    for (int a = 0; a < local; a++)
        for (int r = a / run; r < runs; r++) {
            const int first = r * run > a ? r * run : a;
            double(*to)[9] = K + place[a * runs + r];
            if (e->layer)
                solid_green_layer_blocks(e, stress_share, a, first, (r + 1) * run, to);
            else
                solid_green_element_blocks(e, &s->material, stress_share, a, first,
                                           (r + 1) * run, to);
        }
}

/* Adds an element's mass and volumes. */
static void add_mass(struct solid_assembly *s, const struct solid_element *e, int element)
{
    const int local = e->local, run = s->run, runs = local / run;
    const int *node = s->space->ien + (size_t)element * (size_t)local;
    const int *place = s->place + (size_t)element * (size_t)(local * runs);

    for (int a = 0; a < local; a++) {
        const double *M = e->M + (size_t)a * (size_t)e->row;
        for (int r = a / run; r < runs; r++) {
            const int b = r * run > a ? r * run : a, count = (r + 1) * run - b;
            for (int t = 0; t < count; t++)
                s->M[place[a * runs + r] + t] += M[b + t];
        }
        s->volume[node[a]] += e->volume[a];
    }
}

/* Adds the elements of every second slab. */
static enum status assemble(struct solid_assembly *s, int thread, int slab, int end,
                            const double *x)
{
    struct solid_element *work = &s->work[thread];

    if (s->batch[thread])
        return solid_batch_add(s->batch[thread],
                               &(struct solid_batch_sums){s->K, s->M, s->volume, s->place,
                                                          s->run, s->material},
                               slab, end, x);
    for (; slab < end; slab += 2)
        for (int e = s->space->slab[slab]; e < s->space->slab[slab + 1]; e++) {
            enum status st = solid_element_compute(work, s->space, e, &s->material, x);
            if (st != STATUS_OK)
                return st;
            solid_assembly_add(s, &work->green, &work->rest, e, 1, 0, s->K);
            add_mass(s, work, e);
        }
    return STATUS_OK;
}

enum status solid_assembly_compute(struct solid_assembly *s, const double *x)
{
    size_t pairs = (size_t)s->graph.start[s->space->nodes];
    int slabs = s->space->slabs, inverted = 0, nan = 0;
    const int threads = slabs > 2 ? s->threads : 1;

    memset(s->K, 0, pairs * sizeof *s->K);
    memset(s->M, 0, pairs * sizeof *s->M);
    memset(s->volume, 0, (size_t)s->space->nodes * sizeof *s->volume);
    for (int phase = 0; phase < 2; phase++) {
        const int count = (slabs + 1 - phase) / 2;
#pragma omp parallel for num_threads(threads) if (threads > 1) reduction(| : inverted, nan)
        for (int t = 0; t < threads; t++) {
            enum status st = assemble(s, t, phase + 2 * (count * t / threads),
                                      phase + 2 * (count * (t + 1) / threads), x);
            inverted |= st == STATUS_INVERTED;
            nan |= st == STATUS_NAN;
        }
    }
    return nan ? STATUS_NAN : inverted ? STATUS_INVERTED : STATUS_OK;
}
