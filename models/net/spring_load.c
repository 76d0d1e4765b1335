#include "models/net/spring_load.h"

#include <stdlib.h>
#include <string.h>

#include "models/damping.h"
#include "models/mechanics/dead_load.h"
#include "models/room.h"

static void set_points(struct spring_load *l, double alpha)
{
    const struct scene *s = l->scene;

    for (int a = 0; a < l->net->nodes; a++) {
        const struct scene_own *own = &s->own[scene_sheet_of(s, a, l->net->nodes)];
        double volume = l->net->area[a] * s->thickness;
        l->mass[a] = own->density > 0 ? own->density * volume
                                      : l->net->law.area_mass * l->net->area[a];
        l->drag[a] = alpha * l->mass[a] + l->net->law.drag + s->drag * volume;
        for (int i = 0; i < 3; i++)
            l->load[3 * a + i] = l->mass[a] * s->gravity[i] + s->drag * volume * s->wind[i];
    }
}

void spring_load_clear(struct spring_load *l)
{
    free(l->room);
    free(l->dead);
    memset(l, 0, sizeof *l);
}

enum status spring_load_init(struct spring_load *l, const struct scene *scene,
                             const struct spring_net *net, enum parameters parameters)
{
    enum status st;
    const bool scenes = parameters != PARAMETERS_PAPER;
    size_t nodes = (size_t)net->nodes;
    /* The nodes' hat functions distribute the loads, as the solids' functions do. */
    const struct dead_load_line line[3] = {
        {.n = net->rows, .degree = 1}, {.n = net->points[1], .degree = 1}, {.n = 1}};

    *l = (struct spring_load){.scene = scene,
                              .net = net,
                              .beta = scenes ? damping_stiffness(scene) : 0,
                              .keep = scenes ? damping_velocity(scene) : 1};
    TRY(room_cut(&l->room, ROOM(l->mass, nodes), ROOM(l->drag, nodes),
                 ROOM(l->load, 3 * nodes)));
    set_points(l, scenes ? damping_mass(scene) : 0);
    TRY(dead_load_make(scene, line, &l->dead, l->load));
out:
    if (st != STATUS_OK)
        spring_load_clear(l);
    return st;
}

void spring_load_energy(const struct spring_load *l, const double *x, const double *v,
                        struct energy *energy)
{
    double kinetic = 0, potential = 0;

    for (size_t n = 0; n < 3 * (size_t)l->net->nodes; n++) {
        double mass = l->mass[n / 3];
        kinetic += mass * v[n] * v[n] / 2;
        double weight = mass * l->scene->gravity[n % 3] + (l->dead ? l->dead[n] : 0);
        potential -= weight * (x[n] - l->net->rest[n]);
    }
    energy->kinetic = kinetic;
    energy->potential = potential;
}
