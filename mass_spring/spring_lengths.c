#include "mass_spring/spring_lengths.h"

#include <stdlib.h>
#include <string.h>

#include "models/room.h"

/* The net is one element: its forces are vectors over all springs (spring_force.c). */

static double *strain_of(const void *self, int thread, int element, const double *x,
                         const struct large_foresight *foresight)
{
    struct spring_lengths *s = (struct spring_lengths *)self;
    const size_t count = 3 * (size_t)s->net->mesh->nodes;

    (void)thread, (void)element, (void)foresight;
    memset(s->strain, 0, count * sizeof *s->strain);
    spring_force_add(s->net, x, s->strain);
    for (size_t t = 0; t < count; t++)
        s->strain[t] = -s->strain[t];
    for (int k = 0; k < s->forms.count; k++) {
        double value[3];
        spring_form_value(&s->forms, k, x, value);
        spring_form_pull(&s->forms, k, spring_form_of(&s->forms, k)->stiffness, value,
                         s->strain);
    }
    return s->strain;
}

static void set_geometry(const void *self, int thread, int element, const double *x_old,
                         double share)
{
    struct spring_lengths *s = (struct spring_lengths *)self;

    (void)thread, (void)element, (void)share;
    s->x = x_old;
}

static void add_force(const void *self, int thread, int element, double *force)
{
    const struct spring_lengths *s = self;

    (void)thread, (void)element;
    for (size_t t = 0; t < 3 * (size_t)s->net->mesh->nodes; t++)
        force[t] += s->strain[t];
}

static void add_tangent(const void *self, int thread, int element,
                        const struct large_path *path, double (*K)[9])
{
    const struct spring_lengths *s = self;

    (void)thread, (void)element;
    if (path->x_old)
        spring_force_clamped(s->net, s->x, s->hinges, K);
    else
        spring_force_jacobian(s->net, s->x, K);
    for (long n = 0; s->forms.count && n < s->body.pairs; n++)
        for (int i = 0; i < 3; i++)
            K[n][4 * i] += s->plate[n];
}

static enum status energy_of(const void *self, const double *x, double *energy)
{
    const struct spring_lengths *s = self;

    *energy = spring_forms_energy(&s->forms, x, spring_force_energy(s->net, x));
    return STATUS_OK;
}

void spring_lengths_clear(struct spring_lengths *s)
{
    spring_forms_clear(&s->forms);
    free(s->room);
    memset(s, 0, sizeof *s);
}

enum status spring_lengths_init(struct spring_lengths *s, const struct scene *scene,
                                const struct spring_net *net)
{
    const size_t pairs = (size_t)net->graph.start[net->mesh->nodes];
    enum status st;

    *s = (struct spring_lengths){.net = net, .slab = {0, 1}};
    TRY(room_cut(&s->room, ROOM(s->hinges, pairs), ROOM(s->plate, pairs),
                 ROOM(s->strain, 3 * (size_t)net->mesh->nodes)));
    spring_force_hinges(net, s->hinges);
    if (!net->mesh->rows) {
        TRY(spring_plate_make(scene, net->mesh, PARAMETERS_MATCHED, &s->forms));
        spring_forms_matrix(&s->forms, &net->graph, s->plate);
    }
    s->body = (struct large_body){.self = s,
                                  .nodes = net->mesh->nodes,
                                  .slabs = 1,
                                  .threads = 1,
                                  .slab = s->slab,
                                  .pairs = (long)pairs,
                                  .strains = 3 * (size_t)net->mesh->nodes,
                                  .plain = true,
                                  .strain = strain_of,
                                  .geometry = set_geometry,
                                  .force = add_force,
                                  .tangent = add_tangent,
                                  .energy = energy_of};
out:
    return st;
}
