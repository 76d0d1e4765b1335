#include "models/solid/solid_assembly.h"

#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "models/room.h"

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

static void order_elements(struct solid_assembly *s)
{
    const struct solid_space *space = s->space;
    int slot = 0, n = 0;

    for (int phase = 0; phase < 2; phase++)
        for (int slab = phase; slab < space->slabs; slab += 2) {
            for (int e = space->slab[slab]; e < space->slab[slab + 1]; e++)
                s->element[n++] = e;
            s->begin[++slot] = n;
        }
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
                 ROOM(new.batch, omp_get_max_threads()), ROOM(new.element, space->elements),
                 ROOM(new.begin, space->slabs + 1)));
    order_elements(&new);
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

static void scatter(struct solid_assembly *s, const struct solid_element *e, int element)
{
    int local = e->local, run = s->run, runs = local / run;
    const int *node = s->space->ien + (size_t)element * (size_t)local;
    const int *place = s->place + (size_t)element * (size_t)(local * runs);

    for (int a = 0; a < local; a++) {
        const double *K = e->K + (size_t)a * (size_t)e->padded * 9;
        const double *M = e->M + (size_t)a * (size_t)e->row;
        for (int r = a / run; r < runs; r++) {
            int b = r * run > a ? r * run : a, count = (r + 1) * run - b;
            double *to = s->K[place[a * runs + r]], *to_M = s->M + place[a * runs + r];
            for (int t = 0; t < 9 * count; t++)
                to[t] += K[9 * b + t];
            for (int t = 0; t < count; t++)
                to_M[t] += M[b + t];
        }
        s->volume[node[a]] += e->volume[a];
    }
}

/* Adds the elements of the slabs first .. end - 1, as they are ordered. */
static enum status assemble(struct solid_assembly *s, int thread, int first, int end,
                            const double *x)
{
    const int *element = s->element + s->begin[first];
    const int count = s->begin[end] - s->begin[first];
    const struct solid_batch_sums to = {s->K, s->M, s->volume, s->place, s->run};

    if (s->batch[thread])
        return solid_batch_add(s->batch[thread], count, element, &s->material, x, &to);
    for (int n = 0; n < count; n++) {
        struct solid_element *work = &s->work[thread];
        enum status st = solid_element_compute(work, s->space, element[n], &s->material, x);
        if (st != STATUS_OK)
            return st;
        scatter(s, work, element[n]);
    }
    return STATUS_OK;
}

enum status solid_assembly_compute(struct solid_assembly *s, const double *x)
{
    size_t pairs = (size_t)s->graph.start[s->space->nodes];
    int slabs = s->space->slabs, inverted = 0, nan = 0;

    memset(s->K, 0, pairs * sizeof *s->K);
    memset(s->M, 0, pairs * sizeof *s->M);
    memset(s->volume, 0, (size_t)s->space->nodes * sizeof *s->volume);
    for (int phase = 0; phase < 2; phase++) {
        const int before = phase ? (slabs + 1) / 2 : 0;
        const int count = phase ? slabs / 2 : (slabs + 1) / 2;
#pragma omp parallel num_threads(s->threads) if (s->threads > 1 && slabs > 2)              \
    reduction(|                                                                            \
              : inverted, nan)
        {
            const int t = omp_get_thread_num(), threads = omp_get_num_threads();
            enum status st = assemble(s, t, before + count * t / threads,
                                      before + count * (t + 1) / threads, x);
            inverted |= st == STATUS_INVERTED;
            nan |= st == STATUS_NAN;
        }
    }
    return nan ? STATUS_NAN : inverted ? STATUS_INVERTED : STATUS_OK;
}
