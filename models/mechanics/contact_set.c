#include "models/mechanics/contact_set.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/contact/contact_shape.h"
#include "models/room.h"

static const double ROUNDING = 1e-13;

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double scene_size(const struct scene *scene)
{
    double size = sqrt(dot(scene->origin, scene->origin)) + scene->length + scene->width;

    for (int o = 0; o < scene->obstacle_count; o++) {
        const struct scene_obstacle *s = &scene->obstacles[o];
        double radius = s->kind == OBSTACLE_SPHERE ? s->radius : 0;
        size = fmax(size, sqrt(dot(s->point, s->point)) + radius);
    }
    return size;
}

void contact_set_clear(struct contact_set *c)
{
    free(c->room);
    memset(c, 0, sizeof *c);
}

enum status contact_set_init(struct contact_set *c, const struct scene *scene,
                             const struct supports *held, double offset)
{
    enum status st;
    size_t nodes = (size_t)held->nodes;
    struct contact_set new = {.scene = scene,
                              .held = held,
                              .nodes = held->nodes,
                              .obstacles = scene->obstacle_count,
                              .offset = offset,
                              .rounding = ROUNDING * scene_size(scene)};

    if (!new.obstacles) {
        *c = new;
        return STATUS_OK;
    }
    TRY(room_cut(&new.room, ROOM(new.pair, nodes * (size_t) new.obstacles),
                 ROOM(new.node, nodes), ROOM(new.projector, nodes), ROOM(new.drag, nodes),
                 ROOM(new.factored, nodes), ROOM(new.touched, nodes),
                 ROOM(new.work, 15 * nodes)));
    HAND_OVER(c, new);
out:
    contact_set_clear(&new);
    return st;
}

bool contact_set_used(const struct contact_set *c)
{
    return c->obstacles > 0;
}

void contact_set_forget(struct contact_set *c)
{
    c->is_factored = false;
}

void contact_set_detect(struct contact_set *c, const double *x)
{
    for (int a = 0; a < c->nodes; a++) {
        struct contact_pair *pair = c->pair + (size_t)a * (size_t)c->obstacles;
        c->node[a].trend = 0;
        for (int o = 0; o < c->obstacles; o++)
            pair[o].gap = contact_shape_distance(&c->scene->obstacles[o], NULL,
                                                 x + 3 * (size_t)a, pair[o].normal) -
                          c->offset;
    }
}

/* Adds the normal, as far as it is free, to the node's base, if it is independent of those
 * there; low[] are its components. */
static bool extend_base(const struct contact_set *c, int a, const double normal[3],
                        double low[3])
{
    struct contact_node *node = &c->node[a];
    double q[3], size;

    for (int i = 0; i < 3; i++)
        q[i] = c->held->free_index[3 * a + i] < 0 ? 0 : normal[i];
    for (int j = 0; j < node->touches; j++) {
        low[j] = dot(q, node->base[j]);
        for (int i = 0; i < 3; i++)
            q[i] -= low[j] * node->base[j][i];
    }
    size = sqrt(dot(q, q));
    if (size < CONTACT_SET_INDEPENDENT)
        return false;
    low[node->touches] = size;
    for (int i = 0; i < 3; i++)
        node->base[node->touches][i] = q[i] / size;
    return true;
}

/* Computes dual = low^-T base, where the normals are low base. */
static void make_dual(struct contact_node *node, double low[3][3])
{
    for (int j = node->touches - 1; j >= 0; j--)
        for (int i = 0; i < 3; i++) {
            double s = node->base[j][i];
            for (int t = j + 1; t < node->touches; t++)
                s -= low[t][j] * node->dual[t][i];
            node->dual[j][i] = s / low[j][j];
        }
}

static void make_projector(const struct contact_set *c, int a)
{
    const struct contact_node *node = &c->node[a];
    double *P = c->projector[a];

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            P[3 * i + j] = i == j;
            for (int t = 0; t < node->touches; t++)
                P[3 * i + j] -= node->base[t][i] * node->base[t][j];
        }
}

bool contact_set_project(struct contact_set *c)
{
    bool same = c->is_factored;

    for (int a = 0; a < c->nodes; a++) {
        struct contact_node *node = &c->node[a];
        struct contact_pair *pair = c->pair + (size_t)a * (size_t)c->obstacles;
        double low[3][3] = {{0}};
        node->touches = 0;
        for (int o = 0; o < c->obstacles; o++)
            if (pair[o].active && node->touches < 3 &&
                extend_base(c, a, pair[o].normal, low[node->touches]))
                node->obstacle[node->touches++] = o;
        make_dual(node, low);
        make_projector(c, a);
        c->touched[a] = node->touches > 0;
        same = same && !memcmp(c->projector[a], c->factored[a], sizeof c->projector[a]) &&
               !memcmp(c->drag[a], c->factored[a] + 9, sizeof c->drag[a]);
    }
    return !same;
}

void contact_set_remember(struct contact_set *c)
{
    for (int a = 0; a < c->nodes; a++) {
        memcpy(c->factored[a], c->projector[a], sizeof c->projector[a]);
        memcpy(c->factored[a] + 9, c->drag[a], sizeof c->drag[a]);
    }
    c->is_factored = true;
}

bool contact_set_any(const struct contact_set *c)
{
    for (int a = 0; a < c->nodes; a++)
        if (c->touched[a])
            return true;
    return false;
}

void contact_set_apply(const struct contact_set *c, const double (*P)[9], double *v)
{
    for (int a = 0; a < c->nodes; a++) {
        double *va = v + 3 * (size_t)a, w[3];
        if (!c->touched[a])
            continue;
        for (int i = 0; i < 3; i++)
            w[i] = dot(P[a] + 3 * i, va);
        memcpy(va, w, sizeof w);
    }
}

void contact_set_along(const struct contact_set *c, int a, double v[3])
{
    const struct contact_node *node = &c->node[a];

    for (int i = 0; i < 3; i++)
        if (c->held->free_index[3 * a + i] < 0)
            v[i] = 0;
    for (int t = 0; t < node->touches; t++) {
        double s = dot(v, node->base[t]);
        for (int i = 0; i < 3; i++)
            v[i] -= s * node->base[t][i];
    }
}

double contact_set_arrest(const struct contact_set *c, const double *v, double *change,
                          double (*P)[9])
{
    double largest = 0;

    memset(change, 0, 3 * (size_t)c->nodes * sizeof *change);
    for (int a = 0; a < c->nodes; a++) {
        const struct contact_node *node = &c->node[a];
        const struct contact_pair *pair = c->pair + (size_t)a * (size_t)c->obstacles;
        const double *va = v + 3 * (size_t)a;
        const int *place = c->held->free_index + 3 * (size_t)a;
        double *to = change + 3 * (size_t)a, along[3] = {va[0], va[1], va[2]};
        contact_set_along(c, a, along);
        for (int t = 0; t < 9; t++)
            P[a][t] = node->sticks && place[t / 3] >= 0 && place[t % 3] >= 0
                          ? 0
                          : c->projector[a][t];
        for (int i = 0; node->sticks && i < 3; i++)
            to[i] = -along[i];
        for (int t = 0; t < node->touches; t++)
            for (int i = 0; i < 3; i++)
                to[i] -= dot(pair[node->obstacle[t]].normal, va) * node->dual[t][i];
        for (int i = 0; i < 3; i++)
            largest = fmax(largest, fabs(to[i]));
    }
    return largest;
}

/* Applies friction of node a against f[3], which becomes zero if the node sticks. */
static void rub(struct contact_set *c, int a, const struct contact_pair *pair, double f[3])
{
    struct contact_node *node = &c->node[a];
    double along[3] = {f[0], f[1], f[2]}, limit = 0;

    contact_set_along(c, a, along);
    double length = sqrt(dot(along, along));
    for (int t = 0; t < node->touches; t++)
        limit += c->scene->obstacles[node->obstacle[t]].friction *
                 pair[node->obstacle[t]].lambda;
    node->sticks = limit > 0 && length < limit;
    double share = node->sticks ? 1 : length > 0 ? limit / length : 0;
    for (int i = 0; i < 3; i++) {
        node->friction[i] = -share * along[i];
        node->force[i] += node->friction[i];
        f[i] += node->friction[i];
    }
}

void contact_set_balance(struct contact_set *c, const double *x, double touching, double *F)
{
    contact_set_detect(c, x);
    for (size_t n = 0; n < (size_t)c->nodes * (size_t)c->obstacles; n++)
        c->pair[n].active &= c->pair[n].gap <= touching;
    contact_set_project(c);
    for (int a = 0; a < c->nodes; a++) {
        struct contact_node *node = &c->node[a];
        struct contact_pair *pair = c->pair + (size_t)a * (size_t)c->obstacles;
        double *f = F + 3 * (size_t)a, before[3] = {f[0], f[1], f[2]};
        memset(node->force, 0, sizeof node->force);
        for (int o = 0; o < c->obstacles; o++)
            pair[o].lambda = 0;
        for (int t = 0; t < node->touches; t++) {
            struct contact_pair *p = &pair[node->obstacle[t]];
            p->lambda = fmax(0, -dot(node->dual[t], before));
            for (int i = 0; i < 3; i++) {
                double push =
                    c->held->free_index[3 * a + i] < 0 ? 0 : p->lambda * p->normal[i];
                node->force[i] += push;
                f[i] += push;
            }
        }
        rub(c, a, pair, f);
    }
}

void contact_set_stiffen(const struct contact_set *c, const struct blocks *graph,
                         double stiffness, double (*K)[9])
{
    for (int a = 0; a < c->nodes; a++) {
        const struct contact_node *node = &c->node[a];
        const struct contact_pair *pair = c->pair + (size_t)a * (size_t)c->obstacles;
        double *block = K[graph->start[a]];
        for (int t = 0; t < 9; t++)
            block[t] +=
                stiffness * ((t % 4 == 0) - (node->sticks ? 0 : c->projector[a][t]));
        for (int t = 0; t < node->touches; t++) {
            const struct contact_pair *p = &pair[node->obstacle[t]];
            const struct scene_obstacle *o = &c->scene->obstacles[node->obstacle[t]];
            double pull =
                o->kind == OBSTACLE_SPHERE ? p->lambda / (o->radius + c->offset) : 0;
            for (int i = 0; i < 9; i++)
                block[i] -= pull * ((i % 4 == 0) - p->normal[i / 3] * p->normal[i % 3]);
        }
    }
}

void contact_set_report(const struct contact_set *c, const double *x, double unit,
                        struct model_contact *report)
{
    *report = (struct model_contact){
        .least_gap = contact_shape_least_gap(c->scene, 0, c->nodes, x) - c->offset};
    for (int a = 0; contact_set_used(c) && a < c->nodes; a++) {
        report->nodes += c->touched[a];
        for (int i = 0; i < 3; i++)
            report->force[i] += unit * c->node[a].force[i];
    }
}
