#include "projective_dynamics/pd_contact.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/room.h"
#include "models/vector.h"

/* Most changes in a global step, and products in a change. */
enum { MOST_CHANGES = 10, MOST_PRODUCTS = 200 };

/* Conjugate gradients end at this share of the first residual, if errors of moves are also
 * less than this share of the distance to the wall. */
static const double LEFT = 0.01, CLOSE = 0.1;

void pd_contact_clear(struct pd_contact *c)
{
    if (!c->system)
        return;
    contact_clear(&c->law);
    pd_net_free_fields(c->system->net, c->field);
    free(c->room);
    free(c->row_room);
    memset(c, 0, sizeof *c);
}

enum status pd_contact_init(struct pd_contact *c, const struct scene *scene,
                            struct pd_system *system, const struct mesh *mesh,
                            const int *free_index)
{
    enum status st;
    const struct pd_net *net = system->net;
    const size_t nodes = (size_t)net->nodes;
    struct contact_surface surface;

    *c = (struct pd_contact){.system = system, .free_index = free_index};
    if (!(c->field = pd_net_fields(net, 3)))
        TRY(STATUS_MEMORY);
    TRY(room_cut(&c->room, ROOM(c->at, 3 * nodes), ROOM(c->change, 3 * nodes),
                 ROOM(c->pushed, 3 * nodes), ROOM(c->goal, 3 * nodes),
                 ROOM(c->force, 3 * nodes), ROOM(c->alone, 3 * nodes),
                 ROOM(c->compliance, nodes)));
    TRY(mesh_contact(mesh, scene, &surface));
    TRY(contact_init(&c->law, scene, &surface));
    c->features = c->law.thin.count;
    c->law.thin.count = 0;
    return STATUS_OK;
out:
    pd_contact_clear(c);
    return st;
}

/* Computes at[nodes][3] = x, three fields. */
static void interleave(const struct pd_net *net, const double *x, double *at)
{
    const ptrdiff_t stride = pd_net_stride(net);

    for (int i = 0; i < 3; i++)
        for (int k = 0; k < net->nodes; k++)
            at[3 * k + i] = x[i * stride + k];
}

/* Computes x, three fields, = at[nodes][3]. */
static void separate(const struct pd_net *net, const double *at, double *x)
{
    const ptrdiff_t stride = pd_net_stride(net);

    for (int i = 0; i < 3; i++)
        for (int k = 0; k < net->nodes; k++)
            x[i * stride + k] = at[3 * k + i];
}

enum status pd_contact_find(struct pd_contact *c, const double *x)
{
    interleave(c->system->net, x, c->at);
    return contact_find(&c->law, c->at);
}

void pd_contact_begin(struct pd_contact *c, double t, double dt, const double *start)
{
    c->begun = false;
    interleave(c->system->net, start, c->at);
    c->law.thin.count = c->features; /* that have come through the sheet are counted */
    contact_begin(&c->law, t, dt, c->at);
    c->law.thin.count = 0;
}

enum status pd_contact_end(struct pd_contact *c, double factor, double *x, double share,
                           double (*body)[6])
{
    enum status st;
    const double areal = c->law.scene->density * c->law.scene->thickness;

    interleave(c->system->net, x, c->at);
    for (int k = 0; k < c->law.surface.nodes; k++)
        c->compliance[k] = factor / (areal * c->law.area[k]);
    c->law.thin.count = c->features;
    TRY(contact_project_features(&c->law, c->compliance, c->free_index, c->at));
    contact_force_bodies(&c->law, c->at, share, body);
    separate(c->system->net, c->at, x);
out:
    c->law.thin.count = 0;
    return st;
}

/* --- rows --------------------------------------------------------------------------------
 */

/* Adds C^T v, v[touches][3], to out[nodes][3], where nodes are free; of touches with bodies
 * only if that is asked for. */
static void scatter(const struct pd_contact *c, const double *v, bool bodies, double *out)
{
    const struct contact *law = &c->law;

    for (const struct contact_touch *t = law->touch; t < law->touch + law->count;
         t++, v += 3)
        for (int k = t->first; k < t->first + t->count && (t->obstacle >= 0 || !bodies);
             k++)
            for (int i = 0; i < 3; i++)
                if (c->free_index[3 * law->node[k] + i] >= 0)
                    out[3 * law->node[k] + i] += law->weight[k] * v[i];
}

/* Computes v[touches][3] = C x, x[nodes][3]. */
static void gather(const struct pd_contact *c, const double *x, double *v)
{
    const struct contact *law = &c->law;

    memset(v, 0, 3 * (size_t)law->count * sizeof *v);
    for (const struct contact_touch *t = law->touch; t < law->touch + law->count;
         t++, v += 3)
        for (int k = t->first; k < t->first + t->count; k++)
            for (int i = 0; i < 3; i++)
                v[i] += law->weight[k] * x[3 * law->node[k] + i];
}

/* Multiplies a vector at a touch by `along` in the direction of its normal, by `across` in
 * others. */
static void stretch(const double n[3], double along, double across, const double v[3],
                    double out[3])
{
    const double length = vector_dot(n, v);

    for (int i = 0; i < 3; i++)
        out[i] = across * v[i] + (along - across) * length * n[i];
}

/* Multiplies v[touches][3] by R. */
static void weigh(const struct pd_contact *c, double *v)
{
    for (const struct contact_touch *t = c->law.touch; t < c->law.touch + c->law.count;
         t++, v += 3)
        stretch(t->normal, sqrt(c->factor * t->stiffness), sqrt(c->factor * t->drag), v, v);
}

/* Computes c->pushed = A^-1 C^T v. */
static enum status push(struct pd_contact *c, const double *v)
{
    enum status st;
    const struct pd_net *net = c->system->net;

    memset(c->pushed, 0, 3 * (size_t)net->nodes * sizeof *c->pushed);
    scatter(c, v, false, c->pushed);
    separate(net, c->pushed, c->field);
    TRY(pd_system_solve(c->system, c->field));
    c->solves++;
    interleave(net, c->field, c->pushed);
out:
    return st;
}

static void add(int count, double factor, const double *b, double *a)
{
    for (int n = 0; n < count; n++)
        a[n] += factor * b[n];
}

static double dot(int count, const double *a, const double *b)
{
    double sum = 0;

    for (int n = 0; n < count; n++)
        sum += a[n] * b[n];
    return sum;
}

/* --- a change ----------------------------------------------------------------------------
 */

/* Divides c->residual by about the diagonal of 1 + R S R, for c->scaled. Returns the
 * largest error of a touch's move that the residual means, as a share of the distance to
 * the wall. */
static double divide(struct pd_contact *c)
{
    const struct contact *law = &c->law;
    double most = 0;

    for (int n = 0; n < law->count; n++) {
        const struct contact_touch *t = &law->touch[n];
        const struct contact_law *l = t->obstacle < 0 ? &law->self : &law->body;
        const double room = fmax(t->D - l->start + l->range, CONTACT_LAW_FLOOR * l->range);
        double soft = 0, off[3], *scaled = c->scaled + 3 * n;
        for (int k = t->first; k < t->first + t->count; k++)
            soft += law->weight[k] * law->weight[k] * c->compliance[law->node[k]];
        stretch(t->normal, 1 / (1 + soft * t->stiffness), 1 / (1 + soft * t->drag),
                c->residual + 3 * n, scaled);
        stretch(t->normal, soft * sqrt(t->stiffness / c->factor),
                soft * sqrt(t->drag / c->factor), scaled, off);
        most = fmax(most, vector_length(off) / room);
    }
    return most;
}

/* Takes the stiffness of the touches into c->change, that by the forces as they are. */
static enum status stiffen(struct pd_contact *c)
{
    enum status st = STATUS_OK;
    const int count = 3 * c->law.count;
    double before = 0, enough = 0;

    gather(c, c->change, c->residual);
    weigh(c, c->residual);
    for (int n = 0; n < MOST_PRODUCTS; n++) {
        const double off = divide(c), size = dot(count, c->residual, c->scaled);
        enough = n ? enough : LEFT * LEFT * size;
        if (size == 0 || (size <= enough && off <= CLOSE))
            break;
        for (int i = 0; i < count; i++)
            c->product[i] = c->direction[i] =
                c->scaled[i] + (n ? size / before * c->direction[i] : 0);
        before = size;
        weigh(c, c->product);
        TRY(push(c, c->product));
        gather(c, c->pushed, c->product);
        weigh(c, c->product);
        add(count, 1, c->direction, c->product);
        const double far = size / dot(count, c->direction, c->product);
        add(count, -far, c->product, c->residual);
        add(3 * c->system->net->nodes, -far, c->pushed, c->change);
    }
out:
    return st;
}

static enum status make_room(struct pd_contact *c)
{
    const size_t rows = 6 * (size_t)c->law.count;

    if (3 * c->law.count <= c->rows)
        return STATUS_OK;
    free(c->row_room);
    enum status st =
        room_cut(&c->row_room, ROOM(c->residual, rows), ROOM(c->scaled, rows),
                 ROOM(c->direction, rows), ROOM(c->product, rows), ROOM(c->start, rows));
    c->rows = st == STATUS_OK ? (int)rows : 0;
    return st;
}

/* Computes c->change from c->at by the free result x and the touches; c->force[nodes][3],
 * minus the forces of which it is made; and c->alone[nodes][3], where it would take each
 * node without the forces of bodies on itself. */
static enum status find_change(struct pd_contact *c, const double *x)
{
    enum status st = STATUS_OK;
    const int count = 3 * c->system->net->nodes, rows = 3 * c->law.count;

    interleave(c->system->net, x, c->change);
    add(count, -1, c->at, c->change);
    memset(c->force, 0, (size_t)count * sizeof *c->force);
    memset(c->alone, 0, (size_t)count * sizeof *c->alone);
    if (rows) {
        TRY(make_room(c));
        for (int n = 0; n < rows; n++) {
            const struct contact_touch *t = &c->law.touch[n / 3];
            c->product[n] = c->factor * (t->push * t->normal[n % 3] + t->rub[n % 3]);
            c->start[n] = c->product[n];
        }
        TRY(push(c, c->product));
        add(count, 1, c->pushed, c->change);
        TRY(stiffen(c));
        gather(c, c->change, c->product);
        weigh(c, c->product);
        add(rows, -1, c->residual, c->product);
        weigh(c, c->product);
        for (int n = 0; n < rows; n++)
            c->product[n] = (c->product[n] - c->start[n]) / c->factor;
        scatter(c, c->product, false, c->force);
        scatter(c, c->product, true, c->alone);
    }
    for (int k = 0; k < count; k++) {
        c->goal[k] = c->at[k] + c->change[k];
        c->alone[k] = c->goal[k] + c->compliance[k / 3] * c->alone[k];
    }
out:
    return st;
}

/* --- the global step ---------------------------------------------------------------------
 */

/* Finds the touches at c->goal, where the change ends. Their forces are *alike those of
 * which it was made if what differs moves no node farther, by itself, than the law reaches.
 */
static enum status compare(struct pd_contact *c, bool *alike)
{
    enum status st;
    const int count = 3 * c->system->net->nodes, touches = c->law.count;
    double most = 0;

    TRY(contact_find(&c->law, c->goal));
    *alike = !touches && !c->law.count;
    if (*alike)
        return STATUS_OK;
    memcpy(c->pushed, c->force, (size_t)count * sizeof *c->pushed);
    contact_force(&c->law, c->pushed);
    for (int k = 0; k < count; k++)
        if (c->free_index[k] >= 0)
            most = fmax(most, c->compliance[k / 3] * fabs(c->pushed[k]));
    *alike = most <= c->law.body.range;
out:
    return st;
}

/* Moves c->at to where each touch with a body has the force of the law by itself, and
 * others those of the change, as far as nothing is in the way. */
static enum status settle(struct pd_contact *c)
{
    enum status st;
    const int count = 3 * c->system->net->nodes;

    TRY(contact_project_bodies(&c->law, c->compliance, c->free_index, c->alone));
    for (int k = 0; k < count; k++)
        c->change[k] = c->alone[k] - c->at[k];
    contact_shorten(&c->law, c->at, c->change);
    add(count, 1, c->change, c->at);
    TRY(contact_find(&c->law, c->at));
out:
    return st;
}

/* Finds the touches where the step's first change begins: where it starts, with held nodes
 * where they are taken; if a body has moved over the sheet, in front of that. */
static enum status begin(struct pd_contact *c, const double *x)
{
    enum status st;
    const struct pd_net *net = c->system->net;

    interleave(net, x, c->change);
    for (int k = 0; k < 3 * net->nodes; k++)
        if (c->free_index[k] < 0)
            c->at[k] = c->change[k];
    c->begun = true;
    TRY(contact_find(&c->law, c->at));
    if (c->law.least < -c->law.body.range) {
        memcpy(c->alone, c->at, 3 * (size_t)net->nodes * sizeof *c->alone);
        TRY(settle(c));
    }
out:
    return st;
}

enum status pd_contact_apply(struct pd_contact *c, double factor, double *x)
{
    enum status st = STATUS_OK;
    const struct pd_net *net = c->system->net;
    bool alike = false;

    c->factor = factor;
    for (int k = 0; k < net->nodes; k++)
        c->compliance[k] = factor / pd_system_diagonal(c->system, k);
    if (!c->begun)
        TRY(begin(c, x));
    for (int n = 0; n < MOST_CHANGES && !alike; n++) {
        TRY(find_change(c, x));
        if (!contact_shorten(&c->law, c->at, c->change))
            TRY(compare(c, &alike));
        if (alike)
            memcpy(c->at, c->goal, 3 * (size_t)net->nodes * sizeof *c->at);
        else
            TRY(settle(c));
    }
    separate(net, c->at, x);
out:
    return st;
}
