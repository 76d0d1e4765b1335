#include "models/solid/solid_hinge.h"

#include <stdlib.h>
#include <string.h>

#include "models/supports.h"
#include "models/room.h"

/* Returns m of a column of nodes. */
static double mean(const struct solid_hinge *h, const double *x)
{
    double m = 0;

    for (int k = 0; k < h->layers; k++)
        m += h->middle[k] * x[3 * k];
    return m;
}

static enum status find_columns(struct solid_hinge *h, const struct solid_space *space,
                                const struct scene *scene, bool *any, struct message *why)
{
    enum status st = STATUS_OK;

    for (int a = 0; a < space->nodes && st == STATUS_OK; a += h->layers) {
        bool hinged;
        st = supports_hinge(scene, h->layers, (const double(*)[3])space->uvw + a, h->at,
                            &hinged, why);
        h->column[a / h->layers] = hinged;
        *any |= hinged;
    }
    return st;
}

enum status solid_hinge_init(struct solid_space *space, const struct scene *scene,
                             int layers, const double *middle, struct message *why)
{
    enum status st;
    struct solid_hinge new = {.layers = layers};
    bool any = false;

    if (supports_columns(scene) == SUPPORTS_WHOLE)
        return STATUS_OK;
    TRY(room_cut(&new.room, ROOM(new.column, space->nodes / layers),
                 ROOM(new.middle, layers)));
    memcpy(new.middle, middle, (size_t)layers * sizeof *middle);
    for (int k = 0; k < layers; k++)
        if (middle[k] >= middle[new.at])
            new.at = k;
    TRY(find_columns(&new, space, scene, &any, why));
    for (int a = 0; a < space->nodes; a += layers) {
        double *x = space->rest + 3 * (size_t)a;
        if (!new.column[a / layers])
            continue;
        for (int i = 0; i < 3; i++)
            x[3 * new.at + i] = mean(&new, x + i);
        space->uvw[a + new.at][2] = 0.5;
    }
    if (any) {
        space->hinge = new;
        memset(&new, 0, sizeof new);
    }
out:
    free(new.room);
    return st;
}

/* Turns a column's functions, or forces, `stride` apart. */
static void turn(const struct solid_hinge *h, size_t stride, double *f)
{
    double *at = f + (size_t)h->at * stride, share = *at / h->middle[h->at];

    for (int k = 0; k < h->layers; k++)
        f[(size_t)k * stride] -= h->middle[k] * share;
    *at = share;
}

void solid_hinge_functions(const struct solid_space *space, int element, int rows, int row,
                           double *f)
{
    const struct solid_hinge *h = &space->hinge;
    const int *node = space->ien + (size_t)element * (size_t)space->local;

    for (int a = 0; h->column && a < space->local; a += h->layers)
        for (int r = 0; h->column[node[a] / h->layers] && r < rows; r++)
            turn(h, 1, f + (size_t)r * (size_t)row + a);
}

int solid_hinge_row(const struct solid_space *space, int used, int *node, double *shape)
{
    const struct solid_hinge *h = &space->hinge;
    int left = 0;

    for (int a = 0; h->column && a < used; a += h->layers)
        if (h->column[node[a] / h->layers])
            turn(h, 1, shape + a);
    for (int a = 0; a < used; a++)
        if (shape[a] != 0)
            node[left] = node[a], shape[left++] = shape[a];
    return left;
}

void solid_hinge_forces(const struct solid_space *space, double *f)
{
    const struct solid_hinge *h = &space->hinge;

    for (int a = 0; h->column && a < space->nodes; a += h->layers)
        for (int i = 0; h->column[a / h->layers] && i < 3; i++)
            turn(h, 3, f + 3 * (size_t)a + i);
}

double solid_hinge_point(const struct solid_space *space, const double *x, int node, int i)
{
    const struct solid_hinge *h = &space->hinge;
    const size_t at = 3 * (size_t)node + (size_t)i;

    if (!h->column || !h->column[node / h->layers] || node % h->layers != h->at)
        return x[at];
    return (x[at] * (1 + h->middle[h->at]) - mean(h, x + at - 3 * (size_t)h->at)) /
           h->middle[h->at];
}
