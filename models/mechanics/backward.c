#include "models/mechanics/backward.h"

#include <stdlib.h>
#include <string.h>

#include "models/room.h"

enum status backward_init(struct backward *b, size_t count)
{
    b->count = count;
    return room_cut(&b->room, ROOM(b->x, count), ROOM(b->v, count), ROOM(b->origin, count),
                    ROOM(b->speed, count));
}

void backward_clear(struct backward *b)
{
    free(b->room);
    memset(b, 0, sizeof *b);
}

void backward_start(struct backward *b, double dt, const double *x, const double *v,
                    const double *a)
{
    for (size_t n = 0; n < b->count; n++) {
        const double gain = a ? dt * a[n] : 0;
        b->v[n] = v[n] - gain;
        b->x[n] = x[n] - dt * (v[n] - gain / 2);
    }
}

void backward_begin(struct backward *b, const double *x, const double *v)
{
    for (size_t n = 0; n < b->count; n++) {
        b->origin[n] = x[n] + (x[n] - b->x[n]) / 3;
        b->speed[n] = v[n] + (v[n] - b->v[n]) / 3;
        b->x[n] = x[n];
        b->v[n] = v[n];
    }
}

void backward_scale(struct backward *b, double dt, double factor, const double *v)
{
    for (size_t n = 0; n < b->count; n++) {
        const double blow = (factor - 1) * v[n];
        b->v[n] += blow;
        b->x[n] -= dt * blow;
    }
}

double backward_span(double dt)
{
    return 2 * dt / 3;
}
