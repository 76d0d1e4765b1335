#include "models/contact/contact.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/contact/contact_limit.h"
#include "models/room.h"
#include "models/vector.h"

/* --- touches, and what each of them measures -----------------------------------------
 */

/* Makes room for one more touch of so many weights. */
static enum status make_room(struct contact *c, int weights)
{
    if (c->count == c->room) {
        const int room = 2 * c->room + 64;
        struct contact_touch *touch = realloc(c->touch, (size_t)room * sizeof *touch);
        if (!touch)
            return STATUS_MEMORY;
        c->touch = touch, c->room = room;
    }
    if (c->weights + weights > c->weight_room) {
        const int room = 2 * c->weight_room + weights + 64;
        int *node = realloc(c->node, (size_t)room * sizeof *node);
        c->node = node ? node : c->node;
        double *weight = realloc(c->weight, (size_t)room * sizeof *weight);
        c->weight = weight ? weight : c->weight;
        if (!node || !weight)
            return STATUS_MEMORY;
        c->weight_room = room;
    }
    return STATUS_OK;
}

/* Empties the totals. */
static void clear_totals(struct contact *c)
{
    c->energy = 0;
    c->least = INFINITY;
    for (int o = 0; o < c->scene->obstacle_count; o++)
        memset(c->landed[o], 0, sizeof *c->landed);
}

/* Appends the nodes and weights of a place, or of a foot, with the sign -1. */
static void append(struct contact *c, int count, const int *node, const double *weight,
                   double sign)
{
    for (int k = 0; k < count; k++, c->weights++) {
        c->node[c->weights] = node[k];
        c->weight[c->weights] = sign * weight[k];
    }
}

/* Appends a touch that is filled but for its nodes and their weights: those of its sample
 * less the foot's, or, without a sample (-1), those given. */
static enum status add(struct contact *c, struct contact_touch touch, int count,
                       const int *node, const double *weight)
{
    const struct contact_surface *s = &c->surface;
    const int own = touch.sample < 0 ? 0 : s->used[touch.sample];
    const size_t row = own ? (size_t)touch.sample * s->width : 0;

    touch.first = c->weights;
    touch.count = own + count;
    const enum status st = make_room(c, touch.count);
    if (st != STATUS_OK)
        return st;
    append(c, own, s->node + row, s->shape + row, 1);
    append(c, count, node, weight, own ? -1 : 1);
    c->touch[c->count++] = touch;
    return STATUS_OK;
}

/* Appends a touch of a sample with a body, at the distance D with the normal n.
 * STATUS_MEMORY. */
static enum status add_body(struct contact *c, int sample, int obstacle, double D,
                            const double n[3])
{
    const struct contact_touch touch = {.sample = sample,
                                        .obstacle = obstacle,
                                        .D = D,
                                        .normal = {n[0], n[1], n[2]},
                                        .area = c->surface.area[sample]};

    return add(c, touch, 0, NULL, NULL);
}

/* Appends a touch of a rim's point with another rim. */
static enum status add_rim(void *context, const struct contact_rim_foot *foot)
{
    const double *n = foot->normal;
    const struct contact_touch touch = {.sample = -1,
                                        .obstacle = -1,
                                        .D = foot->distance,
                                        .normal = {n[0], n[1], n[2]},
                                        .area = foot->area / 2};

    return add(context, touch, foot->of_point + foot->of_foot, foot->node, foot->weight);
}

/* Tells whether a sample presses between places of the sheet that are D apart about as much
 * as they would. */
static bool presses(const struct contact *c, const struct contact_meeting *m, double D)
{
    const double most = 2 * D - (c->self.start - c->self.range);

    for (int n = 0; !m->edges && n < c->count; n++)
        if (c->touch[n].obstacle < 0 && c->touch[n].sample == m->sample[0] &&
            c->touch[n].D < most)
            return true;
    return false;
}

/* Appends the places that cut a change short, from the first on, and forgets those that
 * have parted, or that a sample presses apart by now. */
static enum status add_meetings(struct contact *c, int first, const double *x)
{
    const struct contact_surface *s = &c->surface;
    int kept = first;

    for (int n = first; n < c->meetings; n++) {
        const struct contact_meeting *m = &c->meeting[n];
        struct contact_touch touch = {.sample = -1, .obstacle = -1, .first = c->weights};
        double weight[4];
        touch.D = contact_search_between(&c->search, x, m, weight, touch.normal);
        if (touch.D >= c->self.start || presses(c, m, touch.D))
            continue;
        touch.area = INFINITY;
        for (int k = 0; k < 4; k++) {
            touch.count += s->used[m->sample[k]];
            touch.area = fmin(touch.area, s->area[m->sample[k]]);
        }
        c->meeting[kept++] = *m;
        const enum status st = make_room(c, touch.count);
        if (st != STATUS_OK)
            return st;
        for (int k = 0; k < 4; k++) {
            const size_t row = (size_t)m->sample[k] * s->width;
            append(c, s->used[m->sample[k]], s->node + row, s->shape + row, weight[k]);
        }
        c->touch[c->count++] = touch;
    }
    c->meetings = kept;
    return STATUS_OK;
}

/* Returns the step up to x, among bodies at its end. */
static struct contact_thin_step step_to(const struct contact *c, const double *x)
{
    return (struct contact_thin_step){c->pose_old, c->pose, c->x_old, x};
}

/* Appends the touches of thin bodies' features at x; *passed: how many the step has carried
 * through the sheet. STATUS_MEMORY. */
static enum status add_features(struct contact *c, const double *x, int *passed)
{
    const struct contact_thin_step step = step_to(c, x);
    struct contact_thin_foot f;
    enum status st;

    TRY(contact_thin_look(&c->thin, &step, passed));
    for (int n = 0; n < c->thin.pairs; n++) {
        if (!contact_thin_foot(&c->thin, n, &step, &f))
            continue;
        const struct contact_touch touch = {
            .sample = -1,
            .obstacle = f.obstacle,
            .D = f.distance,
            .D_old = f.before,
            .normal = {f.normal[0], f.normal[1], f.normal[2]},
            .area = f.area};
        TRY(add(c, touch, f.count, f.node, f.weight));
        c->least = fmin(c->least, f.distance - c->body.start);
    }
out:
    return st;
}

/* Appends the touches of the sheet with itself at x[nodes][3]. Each of the two sides has
 * half of the law at samples of its own. STATUS_NAN, STATUS_MEMORY. */
static enum status add_own(struct contact *c, const double *x)
{
    const struct contact_search *s = &c->search;
    enum status st = STATUS_OK;

    if (!c->scene->contact.self)
        return STATUS_OK;
    TRY(contact_search_find(&c->search, x));
    for (const struct contact_foot *f = s->foot; f < s->foot + s->count; f++) {
        const struct contact_touch touch = {
            .sample = f->sample,
            .obstacle = -1,
            .D = f->distance,
            .D_old = c->before[2 * f->sample + f->side],
            .normal = {f->normal[0], f->normal[1], f->normal[2]},
            .at = {f->u, f->v},
            .area = f->strength * c->surface.area[f->sample] / 2};
        TRY(add(c, touch, f->count, s->node + f->first, s->weight + f->first));
    }
    TRY(contact_rim_find(&c->rim, add_rim, c));
    TRY(add_meetings(c, 0, x));
out:
    return st;
}

/* Tells whether a body neither moves nor turns. */
static bool is_still(const struct scene_obstacle *o)
{
    return !SCENE_MOVES(o->motion);
}

/* Computes how far the body of a touch has moved there since the step began. */
static void body_way(const struct contact *c, const struct contact_touch *t,
                     const double *x, double way[3])
{
    double y[3] = {0}, before[3];

    way[0] = way[1] = way[2] = 0;
    if (t->obstacle < 0 || is_still(&c->scene->obstacles[t->obstacle]))
        return;
    for (int k = t->first; k < t->first + t->count; k++)
        for (int i = 0; i < 3; i++)
            y[i] += c->weight[k] * x[3 * (size_t)c->node[k] + i];
    body_shape_carry(&c->pose[t->obstacle], &c->pose_old[t->obstacle], y, before);
    vector_between(before, y, way);
}

double contact_body_work(const struct contact *c, const double *x)
{
    double work = 0, way[3];

    for (const struct contact_touch *t = c->touch; t < c->touch + c->count; t++) {
        body_way(c, t, x, way);
        work += t->push * vector_dot(t->normal, way) + vector_dot(t->rub, way);
    }
    return work;
}

/* Computes how far the touch's places have moved against each other since the step began.
 */
static void way_of(const struct contact *c, const struct contact_touch *t, const double *x,
                   double way[3])
{
    double of_body[3];

    way[0] = way[1] = way[2] = 0;
    for (int k = t->first; k < t->first + t->count; k++)
        for (int i = 0; i < 3; i++) {
            size_t u = 3 * (size_t)c->node[k] + i;
            way[i] += c->weight[k] * (x[u] - c->x_old[u]);
        }
    body_way(c, t, x, of_body);
    for (int i = 0; i < 3; i++)
        way[i] -= of_body[i];
}

static const struct contact_law *law_of(const struct contact *c,
                                        const struct contact_touch *t)
{
    return t->obstacle < 0 ? &c->self : &c->body;
}

static double friction_of(const struct contact *c, const struct contact_touch *t)
{
    return t->obstacle < 0 ? c->scene->contact.friction
                           : c->scene->obstacles[t->obstacle].friction;
}

/* Splits a way into its length along n, returned, and the part across, in `slip`. */
static double split(const double way[3], const double n[3], double slip[3])
{
    const double along = vector_dot(way, n);

    for (int i = 0; i < 3; i++)
        slip[i] = way[i] - along * n[i];
    return along;
}

/* Returns the distance of a touch when the step began. It is measured, of a body's with the
 * normal there (NULL: unwanted): the way along the normal would take what slides on a ball,
 * or on another layer of a bend, for what leaves it. */
static double distance_before(const struct contact *c, const struct contact_touch *t,
                              double along, double normal[3])
{
    double y[3];

    if (t->obstacle < 0)
        return t->D_old > 0 ? t->D_old : t->D - along;
    if (t->sample < 0) { /* of a feature, as it was found */
        if (normal)
            memcpy(normal, t->normal, sizeof t->normal);
        return t->D_old;
    }
    contact_surface_at(&c->surface, t->sample, c->x_old, y);
    return body_shape_distance(&c->scene->obstacles[t->obstacle], &c->pose_old[t->obstacle],
                               y, normal);
}

/* Replaces the normal of a touch with a body by the mean one of the part of the step in
 * which the law acted: between that at the step's start, or at the place on the way where
 * contact started, and that at its end. Opposite faces of a thin body have no mean. */
static void take_mean(const struct contact_law *law, double D_old, const double before[3],
                      struct contact_touch *t)
{
    const double acted = D_old > law->start ? (law->start - t->D) / (D_old - t->D) : 1;
    double mean[3];

    if (!(vector_dot(before, t->normal) > 0))
        return;
    t->mean = true;
    for (int i = 0; i < 3; i++)
        mean[i] = t->normal[i] + acted / 2 * (before[i] - t->normal[i]);
    const double size = vector_length(mean);
    for (int i = 0; i < 3; i++)
        t->normal[i] = mean[i] / size;
}

/* Adds a touch's pressure to the totals. */
static void add_total(struct contact *c, const struct contact_touch *t)
{
    const struct contact_law *law = law_of(c, t);

    c->least = fmin(c->least, t->D - law->start);
    c->energy += t->area * contact_law_potential(law, t->D);
}

/* Returns the distance of a sample that a step leads to y, D from a body, as seen from the
 * side from which they have met: a step may lead through a thin body, or so deep into it
 * that its nearest face is the far one. There the distance is that from the plane of the
 * face that it came through, and *normal this face's. The distance changes by the way at
 * most, so that most are done with at once. */
static double distance_met(const struct contact *c, int sample, int obstacle,
                           const double y[3], double D, double normal[3])
{
    enum { TRIES = 60 };
    const struct scene_obstacle *o = &c->scene->obstacles[obstacle];
    const struct scene_placement *pose = &c->pose[obstacle];
    const double reached = 1e-3 * c->body.range;
    double old[3], from[3], at[3], way[3], far[3], entry[3], passed = 0;

    if (!isfinite(c->dt))
        return D;
    contact_surface_at(&c->surface, sample, c->x_old, old);
    body_shape_carry(&c->pose_old[obstacle], pose, old, from);
    vector_between(from, y, way);
    const double length = vector_length(way);
    if (!(D <= length))
        return D;
    double left = body_shape_distance(o, pose, from, entry);
    if (!(left > 0) || left + body_shape_distance(o, pose, y, far) > length)
        return D;
    for (int n = 0; n < TRIES && left > reached && passed < length; n++) {
        passed += left;
        for (int i = 0; i < 3; i++)
            at[i] = from[i] + way[i] * passed / length;
        left = body_shape_distance(o, pose, at, entry);
    }
    if (passed <= 0 || passed > length || left > reached || vector_dot(entry, far) >= 0)
        return D;
    memcpy(normal, entry, sizeof entry);
    return fmin(0, (y[0] - at[0]) * entry[0] + (y[1] - at[1]) * entry[1] +
                       (y[2] - at[2]) * entry[2]);
}

/* --- life ----------------------------------------------------------------------------
 */

bool contact_wanted(const struct scene *scene)
{
    return scene->obstacle_count > 0 || scene->contact.self;
}

bool contact_rubs(const struct contact *c)
{
    bool any = c->scene->contact.friction > 0;

    for (int o = 0; o < c->scene->obstacle_count; o++)
        any |= c->scene->obstacles[o].friction > 0;
    return any;
}

void contact_clear(struct contact *c)
{
    contact_rim_clear(&c->rim);
    contact_search_clear(&c->search);
    contact_thin_clear(&c->thin);
    contact_surface_clear(&c->surface);
    free(c->arrays);
    free(c->touch);
    free(c->node);
    free(c->weight);
    memset(c, 0, sizeof *c);
}

enum status contact_init(struct contact *c, const struct scene *scene,
                         struct contact_surface *surface)
{
    enum status st;
    const struct contact_surface *s = &c->surface;
    const size_t bodies = (size_t)scene->obstacle_count, nodes = (size_t)surface->nodes;
    const size_t samples = (size_t)surface->count;

    *c = (struct contact){.scene = scene,
                          .surface = *surface,
                          .body = contact_law_body(scene),
                          .self = contact_law_self(scene)};
    *surface = (struct contact_surface){0};
    TRY(room_cut(&c->arrays, ROOM(c->pose, bodies), ROOM(c->pose_old, bodies),
                 ROOM(c->landed, bodies), ROOM(c->x_old, 3 * nodes), ROOM(c->area, nodes),
                 ROOM(c->spare, 4 * samples), ROOM(c->near, samples),
                 ROOM(c->pressed, nodes), ROOM(c->meeting, samples),
                 ROOM(c->foretold, 2 * samples), ROOM(c->before, 2 * samples)));
    for (int n = 0; n < s->count; n++)
        for (int k = n * s->width; k < n * s->width + s->used[n]; k++)
            c->area[s->node[k]] += s->shape[k] * s->area[n];
    TRY(contact_thin_init(&c->thin, scene, s, c->body.start));
    if (scene->contact.self) {
        TRY(contact_search_init(&c->search, &c->surface, c->self.start));
        TRY(contact_rim_init(&c->rim, &c->search));
    }
out:
    if (st != STATUS_OK)
        contact_clear(c);
    return st;
}

/* --- forces --------------------------------------------------------------------------
 */

/* Counts the last step if it has ended at x with a body through the sheet. */
static void count_crossing(struct contact *c, double t, const double *x)
{
    const struct contact_thin_step step = step_to(c, x);
    int passed;

    if (!c->thin.count)
        return;
    for (int o = 0; o < c->scene->obstacle_count; o++)
        scene_motion_at(&c->scene->obstacles[o].motion, t, &c->pose[o]);
    if (c->dt > 0 && isfinite(c->dt)) {
        c->failed = contact_thin_look(&c->thin, &step, &passed);
        c->crossed += c->failed == STATUS_OK && passed;
    }
    memset(c->thin.passed, 0, (size_t)c->thin.count * sizeof *c->thin.passed);
}

void contact_begin(struct contact *c, double t, double dt, const double *x_old)
{
    const double end = isfinite(dt) ? t + dt : t;

    count_crossing(c, t, x_old);
    c->dt = dt, c->rests = c->held = c->released = c->middle = false;
    c->bounds = 0, c->measured = c->fresh = c->cycles = false;
    memset(c->before, 0, 2 * (size_t)c->surface.count * sizeof *c->before);
    c->least_change = c->anew = INFINITY, c->waited = 0;
    c->count = c->weights = 0;
    memset(c->foretold, 0, 2 * (size_t)c->surface.count * sizeof *c->foretold);
    memcpy(c->x_old, x_old, 3 * (size_t)c->surface.nodes * sizeof *c->x_old);
    for (int o = 0; o < c->scene->obstacle_count; o++) {
        scene_motion_at(&c->scene->obstacles[o].motion, t, &c->pose_old[o]);
        scene_motion_at(&c->scene->obstacles[o].motion, end, &c->pose[o]);
    }
}

void contact_begin_rest(struct contact *c, double t, double dt, const double *x_old)
{
    contact_begin(c, t, dt, x_old);
    c->rests = true;
}

/* Computes the forces of a touch at x. */
static void press(struct contact *c, struct contact_touch *t, const double *x)
{
    const struct contact_law *law = law_of(c, t);
    const double mu = friction_of(c, t);
    double way[3], slip[3], before[3];

    way_of(c, t, x, way);
    t->D_flat = t->D - vector_dot(way, t->normal);
    if (!isfinite(c->dt)) {
        t->push = t->area * contact_law_pressure(law, t->D, &t->stiffness);
        t->stiffness *= t->area;
        return;
    }
    const double D_old = distance_before(c, t, vector_dot(way, t->normal), before);
    if (c->middle && t->obstacle >= 0 && !t->mean)
        take_mean(law, D_old, before, t);
    t->D_old = D_old, t->D_flat = t->D - split(way, t->normal, slip);
    t->push = t->area * contact_law_push(law, t->D, D_old, c->rests ? INFINITY : c->dt,
                                         &t->stiffness);
    t->stiffness *= t->area;
    if (!c->held || t->bound == 0)
        t->bound = t->push;
    if (mu == 0)
        return;
    const double size = vector_length(slip);
    t->share = contact_law_friction(law, size, c->dt);
    const double stick = 2 * mu * t->bound / (law->creep * c->dt);
    t->drag = size > 0 ? mu * t->bound * t->share / size : stick;
    t->grip = stick * fmax(0, 1 - size / (law->creep * c->dt));
    for (int i = 0; i < 3; i++)
        t->rub[i] = -t->drag * slip[i];
    if (!c->held && t->sample >= 0)
        split(c->foretold[2 * t->sample + (t->obstacle < 0)], t->normal, t->foretold);
}

/* Returns the distance of y from a body: exact where contact has started, or where it is
 * less than the least so far, else some number from there up to it. */
static double body_distance(const struct contact *c, int obstacle, const double y[3],
                            double normal[3])
{
    return body_shape_near(&c->scene->obstacles[obstacle], &c->pose[obstacle], y,
                           c->body.start + fmax(c->least, 0), normal);
}

/* Returns a touch's distance at x, along the normal that it had where it was found. */
static double distance_now(const struct contact *c, const struct contact_touch *t,
                           const double *x)
{
    double way[3];

    way_of(c, t, x, way);
    return t->D_flat + vector_dot(way, t->normal);
}

/* Tells whether a held touch is that of a sample with a body; *at: a body's touch before or
 * at it, of touches that are ascending up to listed[0]. */
static bool is_held(const struct contact *c, int sample, int obstacle, int *at)
{
    const struct contact_touch *t = c->touch;

    while (*at < c->listed[0] && t[*at].obstacle >= 0 && t[*at].sample < sample)
        ++*at;
    for (int n = *at; n < c->listed[0] && t[n].obstacle >= 0 && t[n].sample == sample; n++)
        if (t[n].obstacle == obstacle)
            return true;
    for (int n = c->listed[0]; n < c->count; n++)
        if (t[n].sample == sample && t[n].obstacle == obstacle)
            return true;
    return false;
}

/* Lists the touches at x; adds those that are new to held ones. */
static enum status list_touches(struct contact *c, const double *x)
{
    enum status st = STATUS_OK;
    int at = 0, passed;

    if (!c->held)
        c->count = c->weights = 0;
    for (int n = 0; n < c->surface.count; n++) {
        double y[3], normal[3];
        contact_surface_at(&c->surface, n, x, y);
        for (int o = 0; o < c->scene->obstacle_count; o++) {
            double D = body_distance(c, o, y, normal);
            if (isnan(D))
                return STATUS_NAN;
            if (!is_still(&c->scene->obstacles[o])) /* changes stop before still ones */
                D = distance_met(c, n, o, y, D, normal);
            if (D - c->body.start < c->least)
                c->least = D - c->body.start;
            if (D < c->body.start && !(c->held && is_held(c, n, o, &at)))
                TRY(add_body(c, n, o, D, normal));
        }
    }
    if (!c->held) {
        TRY(add_features(c, x, &passed));
        return add_own(c, x);
    }
    TRY(add_meetings(c, c->listed[1], x));
    c->listed[1] = c->meetings;
out:
    return st;
}

/* Measures how far samples are from other places of the sheet where the step begins. */
static enum status measure_before(struct contact *c)
{
    const struct contact_search *s = &c->search;
    enum status st = contact_search_find(&c->search, c->x_old);

    for (const struct contact_foot *f = s->foot; st == STATUS_OK && f < s->foot + s->count;
         f++)
        c->before[2 * f->sample + f->side] = f->distance;
    c->measured = true;
    return st;
}

enum status contact_find(struct contact *c, const double *x)
{
    enum status st = c->failed;

    c->failed = STATUS_OK;
    clear_totals(c);
    TRY(st);
    if (c->scene->contact.self && isfinite(c->dt) && !c->measured)
        TRY(measure_before(c));
    for (int n = 0; c->held && n < c->count; n++)
        c->touch[n].D = distance_now(c, &c->touch[n], x);
    TRY(list_touches(c, x));
    for (int n = 0; n < c->count; n++) {
        press(c, &c->touch[n], x);
        add_total(c, &c->touch[n]);
    }
out:
    return st;
}

void contact_grip(const struct contact_touch *t, double K[9])
{
    const double *n = t->normal, *f = t->foretold, *s = t->rub;
    const double sizes = vector_length(s) * fmax(t->share, vector_length(f));
    const double less = sizes > 0 ? (t->drag - t->grip) / (2 * sizes) : 0;

    for (int i = 0; i < 9; i++) /* rub is against the slip */
        K[i] = t->drag * ((i % 4 == 0) - n[i / 3] * n[i % 3]) +
               less * (f[i / 3] * s[i % 3] + s[i / 3] * f[i % 3]);
}

void contact_force(const struct contact *c, double *force)
{
    for (const struct contact_touch *t = c->touch; t < c->touch + c->count; t++)
        for (int k = t->first; k < t->first + t->count; k++)
            for (int i = 0; i < 3; i++)
                force[3 * (size_t)c->node[k] + i] +=
                    c->weight[k] * (t->push * t->normal[i] + t->rub[i]);
}

void contact_force_at(const double at[3], const double force[3], double share,
                      double sum[6])
{
    double moment[3];

    vector_cross(at, force, moment);
    for (int i = 0; i < 3; i++) {
        sum[i] += share * force[i];
        sum[3 + i] += share * moment[i];
    }
}

void contact_force_bodies(const struct contact *c, const double *x, double share,
                          double (*body)[6])
{
    for (int o = 0; o < c->scene->obstacle_count; o++)
        for (int i = 0; i < 6; i++)
            body[o][i] += share * c->landed[o][i];
    for (const struct contact_touch *t = c->touch; t < c->touch + c->count; t++) {
        double at[3] = {0}, force[3];
        if (t->obstacle < 0)
            continue;
        for (int k = t->first; k < t->first + t->count; k++)
            for (int i = 0; i < 3; i++) {
                const size_t u = 3 * (size_t)c->node[k] + i;
                at[i] += c->weight[k] * (c->middle ? (c->x_old[u] + x[u]) / 2 : x[u]);
            }
        for (int i = 0; i < 3; i++)
            force[i] = t->push * t->normal[i] + t->rub[i];
        contact_force_at(at, force, share, body[t->obstacle]);
    }
}

void contact_force_sum(const struct contact *c, const double (*body)[6], double force[3])
{
    memset(force, 0, 3 * sizeof *force);
    for (int o = 0; o < c->scene->obstacle_count; o++)
        for (int i = 0; i < 3; i++)
            force[i] += body[o][i];
}

/* Returns the share of the step's bounce that the velocity of a touch loses, by the
 * stiffness [N/m] of its force and the area whose mass it moves (contact.h). */
static double bounced(const struct contact *c, double stiffness, double area)
{
    const double mass = c->scene->density * c->scene->thickness * area;
    const double a = stiffness * c->dt * c->dt / (2 * mass);

    return 1 - 1 / (1 + a * a);
}

/* Computes by how much the velocity of a touch is to change towards the mean one: along the
 * normal, if it opens faster, and across, if it sticks. */
static void land(const struct contact *c, const struct contact_touch *t, double area,
                 const double *x, const double *v, double by[3])
{
    double more[3] = {0}, across[3];

    for (int k = t->first; k < t->first + t->count; k++)
        for (int i = 0; i < 3; i++) {
            size_t u = 3 * (size_t)c->node[k] + i;
            more[i] += c->weight[k] * ((x[u] - c->x_old[u]) / c->dt - v[u]);
        }
    const double along = fmin(0, split(more, t->normal, across));
    const double opens = bounced(c, t->stiffness, area), slips = bounced(c, t->grip, area);
    for (int i = 0; i < 3; i++)
        by[i] = opens * along * t->normal[i] + slips * across[i];
}

void contact_landing(const struct contact *c, int obstacle, const double *x,
                     const double *v, double *change)
{
    memset(change, 0, 3 * (size_t)c->surface.nodes * sizeof *change);
    for (const struct contact_touch *t = c->touch; t < c->touch + c->count; t++) {
        const double area = t->obstacle < 0 ? t->area / 2 : t->area; /* both sides move */
        double by[3];
        if (!(t->push > 0) || (obstacle != CONTACT_ANY && t->obstacle != obstacle))
            continue;
        land(c, t, area, x, v, by);
        for (int k = t->first; k < t->first + t->count; k++)
            for (int i = 0; i < 3; i++)
                change[3 * (size_t)c->node[k] + i] +=
                    c->weight[k] * area / c->area[c->node[k]] * by[i];
    }
}

void contact_report(const struct contact *c, struct model_contact *report)
{
    *report = (struct model_contact){
        .least_gap = c->least, .energy = c->energy, .crossed = c->crossed};
    for (int n = 0; n < c->count; n++)
        report->nodes += c->touch[n].push > 0;
}

/* --- steps that stay outside ---------------------------------------------------------
 */

/* A sample at y that a change moves by d, and a body. */
struct approach {
    const struct contact *c;
    int sample, obstacle;
    const double *y, *d;
};

static double distance_over(void *self, double share, double *slope)
{
    const struct approach *a = self;
    const struct scene_obstacle *o = &a->c->scene->obstacles[a->obstacle];
    double end[3], normal[3];

    for (int i = 0; i < 3; i++)
        end[i] = a->y[i] + share * a->d[i];
    double D = body_shape_distance(o, &a->c->pose[a->obstacle], end, normal);
    if (share == 0 && !is_still(o)) /* what a body came over may come back */
        D = distance_met(a->c, a->sample, a->obstacle, end, D, normal);
    *slope = vector_dot(normal, a->d);
    return D - (a->c->body.start - a->c->body.range);
}

/* Returns the share of the change d of a sample at y that leaves enough before a body. The
 * distance is no more than the way shorter, so that most are done with at once. */
static double limit_sample(const struct contact *c, int sample, int obstacle,
                           const double y[3], const double d[3], double share)
{
    struct approach a = {c, sample, obstacle, y, d};
    const double enough = c->body.start + share * vector_length(d);
    double normal[3];

    if (body_shape_near(&c->scene->obstacles[obstacle], &c->pose[obstacle], y, enough,
                        normal) >= enough)
        return share;
    return contact_limit_share(&a, distance_over, c->body.range, share);
}

/* Returns the share of a change d of x that leaves enough to a sample before all bodies. */
static double limit_bodies(const struct contact *c, int sample, const double *x,
                           const double *d, double share)
{
    double y[3], way[3];

    contact_surface_at(&c->surface, sample, x, y);
    contact_surface_at(&c->surface, sample, d, way);
    for (int o = 0; o < c->scene->obstacle_count; o++)
        share = limit_sample(c, sample, o, y, way, share);
    return share;
}

/* Notes the friction that the tangent foretells a change d for (contact_grip). */
static void foretell(struct contact *c, struct contact_touch *t, const double *d)
{
    double way[3] = {0}, slip[3], K[9], square = 0;
    const double most = friction_of(c, t) * t->bound;

    if (!(most > 0))
        return;
    for (int k = t->first; k < t->first + t->count; k++)
        for (int i = 0; i < 3; i++)
            way[i] += c->weight[k] * d[3 * (size_t)c->node[k] + i];
    split(way, t->normal, slip);
    contact_grip(t, K);
    for (int i = 0; i < 3; i++) {
        t->foretold[i] = (vector_dot(K + 3 * (size_t)i, slip) - t->rub[i]) / most;
        square += t->foretold[i] * t->foretold[i];
    }
    for (int i = 0; i < 3; i++)
        t->foretold[i] /= fmax(1, sqrt(square));
    if (t->sample >= 0)
        memcpy(c->foretold[2 * t->sample + (t->obstacle < 0)], t->foretold,
               sizeof t->foretold);
}

/* Notes places that cut a change short, unless a sample presses there about as much. */
static void note(struct contact *c, const double *x, const struct contact_meeting *met)
{
    double weight[4], normal[3];

    if (met->sample[0] < 0 || c->meetings == c->surface.count ||
        presses(c, met, contact_search_between(&c->search, x, met, weight, normal)))
        return;
    for (int n = 0; n < c->meetings; n++)
        if (!memcmp(c->meeting[n].sample, met->sample, sizeof met->sample) &&
            c->meeting[n].edges == met->edges)
            return;
    c->meeting[c->meetings++] = *met;
}

/* Lists the features that a change d of x brings near triangles; returns how many pairs
 * there are, 0 with c->failed. */
static int list_features(struct contact *c, const double *x, const double *d)
{
    c->failed = contact_thin_near(&c->thin, c->pose, x, d);
    return c->failed == STATUS_OK ? c->thin.pairs : 0;
}

/* Returns the share of a change that leaves enough before the n-th of these pairs. */
static double limit_feature(struct contact *c, int n, const double *x, const double *d,
                            double share, int samples[3])
{
    return contact_thin_limit(&c->thin, n, x, d, c->body.start - c->body.range,
                              c->body.range, share, samples);
}

/* Returns the share of a change that keeps the sheet from coming through itself; 0 with
 * c->failed. */
static double limit_own(struct contact *c, const double *x, const double *d,
                        struct contact_meeting *met)
{
    double share = 1;

    if (c->scene->contact.self && c->failed == STATUS_OK)
        c->failed = contact_search_limit(&c->search, x, d, c->self.start - c->self.range,
                                         c->self.range, &share, met);
    return c->failed == STATUS_OK ? share : 0;
}

double contact_limit(struct contact *c, const double *x, double *d)
{
    const int count = 3 * c->surface.nodes;
    double share = 1;
    int samples[3];

    for (int n = 0; n < c->surface.count; n++)
        share = limit_bodies(c, n, x, d, share);
    for (int n = list_features(c, x, d) - 1; n >= 0; n--)
        share = limit_feature(c, n, x, d, share, samples);
    for (int n = 0; n < c->count; n++)
        foretell(c, &c->touch[n], d);
    struct contact_meeting met = {.sample = {-1}};
    share = fmin(share, limit_own(c, x, d, &met));
    note(c, x, &met);
    for (int k = 0; share < 1 && k < count; k++)
        d[k] *= share;
    return share;
}

void contact_lead(struct contact *c, double *x)
{
    const int count = 3 * c->surface.nodes;

    for (int k = 0; k < count; k++)
        x[k] -= c->x_old[k];
    contact_limit(c, c->x_old, x);
    for (int k = 0; k < count; k++)
        x[k] += c->x_old[k];
}

bool contact_shorten(struct contact *c, const double *x, double *d)
{
    const struct contact_surface *s = &c->surface;
    bool any = false;

    for (int n = 0; n < s->count; n++) {
        const double share = limit_bodies(c, n, x, d, 1);
        any |= share < 1;
        for (int k = 0; share < 1 && k < s->used[n]; k++)
            for (int i = 0; i < 3; i++)
                d[3 * (size_t)s->node[(size_t)n * s->width + k] + i] *= share;
    }
    for (int n = list_features(c, x, d) - 1; n >= 0; n--) {
        int samples[3];
        const double share = limit_feature(c, n, x, d, 1, samples);
        any |= share < 1;
        for (int k = 0; share < 1 && k < 9; k++)
            d[3 * (size_t)s->node[samples[k / 3]] + k % 3] *= share;
    }
    const double own = limit_own(c, x, d, NULL);
    for (int k = 0; own < 1 && k < 3 * s->nodes; k++)
        d[k] *= own;
    return any || own < 1;
}

/* --- the end of a step ---------------------------------------------------------------
 */

/* Notes where a touch that was found at x was when the step began. */
static void look_back(const struct contact *c, struct contact_touch *t, const double *x)
{
    double way[3];

    way_of(c, t, x, way);
    const double along = vector_dot(way, t->normal);
    t->D_old = distance_before(c, t, along, NULL);
    t->D_flat = t->D - along;
}

/* Returns how far the touch opens along n by a unit of force along n [m/N], by itself or if
 * those around it have the same pressure. */
static double opening(const struct contact *c, const struct contact_touch *t,
                      const double n[3], const double *compliance, const int *held,
                      bool together)
{
    double sum = 0;

    for (int k = t->first; k < t->first + t->count; k++) {
        const int a = c->node[k];
        const double share = together ? c->pressed[a] / t->area : c->weight[k];
        for (int i = 0; i < 3; i++)
            if (held[3 * (size_t)a + i] >= 0)
                sum += n[i] * n[i] * c->weight[k] * share * compliance[a];
    }
    return sum;
}

/* Finds a touch's force by the law, from its way up to x: normal force first, then
 * friction. */
static void press_by(const struct contact *c, struct contact_touch *t,
                     const double *compliance, const int *held, bool together,
                     const double *x)
{
    const struct contact_law *law = law_of(c, t);
    const double mu = friction_of(c, t);
    const double open = opening(c, t, t->normal, compliance, held, together);
    double way[3], slip[3], across[3];

    way_of(c, t, x, way);
    const double along = split(way, t->normal, slip), size = vector_length(slip);
    t->push = contact_law_solve(law, t->D_flat + along, t->D_old, c->dt, t->area, open);
    memset(t->rub, 0, sizeof t->rub);
    if (mu == 0 || size == 0)
        return;
    for (int i = 0; i < 3; i++)
        across[i] = slip[i] / size;
    const double most = mu * t->push * opening(c, t, across, compliance, held, together);
    const double share = contact_law_hold(law, size, c->dt, most);
    for (int i = 0; i < 3; i++)
        t->rub[i] = -mu * t->push * share * across[i];
}

/* Moves the nodes of a touch by `times` its force, in so far as they are free. */
static void yield_to(const struct contact *c, const struct contact_touch *t, double times,
                     const double *compliance, const int *held, double *x)
{
    for (int k = t->first; k < t->first + t->count; k++)
        for (int i = 0; i < 3; i++) {
            size_t u = 3 * (size_t)c->node[k] + i;
            if (held[u] >= 0)
                x[u] += times * c->weight[k] * compliance[c->node[k]] *
                        (t->push * t->normal[i] + t->rub[i]);
        }
}

/* A push that is less than the law's by this share is enough: the distance that has it is
 * p / p' = x (1 - x) r / 2 of it greater, at most 1.3e-5 of the range. */
static const double ENOUGH = 1e-4;

/* Tells whether a touch's push is less than the law has at x. */
static bool lacks(const struct contact *c, const struct contact_touch *t, const double *x)
{
    const double D = distance_now(c, t, x);
    const double p = contact_law_push(law_of(c, t), D, t->D_old, c->dt, NULL);

    return t->area * p > (1 + ENOUGH) * t->push;
}

/* Gives each touch from `first` on that lacks force what it lacks, one after the other as
 * the others now press; returns whether any did. */
static bool relieve(const struct contact *c, int first, const double *compliance,
                    const int *held, double *x)
{
    bool any = false;

    for (struct contact_touch *t = c->touch + first; t < c->touch + c->count; t++) {
        const struct contact_touch before = *t;
        if (!lacks(c, t, x))
            continue;
        any = true;
        yield_to(c, t, -1, compliance, held, x);
        press_by(c, t, compliance, held, false, x);
        if (t->push < before.push) /* others that rely on it would sink */
            *t = before;
        yield_to(c, t, 1, compliance, held, x);
    }
    return any;
}

/* Takes the touches from `first` on as they are at x. */
static void take(struct contact *c, int first, const double *x)
{
    for (struct contact_touch *t = c->touch + first; t < c->touch + c->count; t++) {
        t->D = distance_now(c, t, x);
        add_total(c, t);
    }
}

/* Ends the step of touches with a body, or of the sheet's own: with a body of all as if
 * they had the same pressure, which leaves flat what lands flat; then of one after the
 * other as the others now press. */
static void settle(struct contact *c, int first, const double *compliance, const int *held,
                   double *x)
{
    struct contact_touch *from = c->touch + first, *end = c->touch + c->count;

    memset(c->pressed, 0, (size_t)c->surface.nodes * sizeof *c->pressed);
    for (const struct contact_touch *t = from; t < end; t++)
        for (int k = t->first; k < t->first + t->count; k++)
            c->pressed[c->node[k]] += fabs(c->weight[k]) * t->area;
    for (struct contact_touch *t = from; t < end && t->obstacle >= 0; t++)
        press_by(c, t, compliance, held, true, x);
    for (struct contact_touch *t = from; t < end; t++)
        yield_to(c, t, 1, compliance, held, x);
    relieve(c, first, compliance, held, x);
}

/* Tells whether a sample at y has come less far from where it was looked at than the bodies
 * were from it: most of a sheet need not be looked at in each of an explicit method's
 * steps.
 */
static bool keeps_off(struct contact *c, const double *spare, const double y[3])
{
    double way[3];

    vector_between(spare, y, way);
    const double square = vector_dot(way, way);
    if (!(square < spare[3] * spare[3]))
        return false;
    if (spare[3] < c->least)
        c->least = fmin(c->least, spare[3] - sqrt(square));
    return true;
}

/* Lists the samples that must be looked at, with their places. */
static int list_near(struct contact *c, const double *x)
{
    int count = 0;

    for (int n = 0; n < c->surface.count; n++) {
        double *spare = c->spare + 4 * (size_t)n, y[3];
        contact_surface_at(&c->surface, n, x, y);
        if (keeps_off(c, spare, y))
            continue;
        memcpy(spare, y, sizeof y);
        spare[3] = INFINITY;
        c->near[count++] = n;
    }
    return count;
}

/* Ends the step of samples by the law of a body, together: a sheet that lands flat stays
 * flat. Their spare is how far they are from it, 0 if it may come nearer by itself. */
static enum status meet_body(struct contact *c, int obstacle, int count,
                             const double *compliance, const int *held, double *x)
{
    enum status st = STATUS_OK;
    const struct scene_obstacle *body = &c->scene->obstacles[obstacle];
    const bool still = is_still(body);
    const int first = c->count;

    for (int n = 0; n < count; n++) {
        double y[3], normal[3], *spare = &c->spare[4 * (size_t)c->near[n] + 3];
        contact_surface_at(&c->surface, c->near[n], x, y);
        double D = body_shape_distance(body, &c->pose[obstacle], y, normal);
        if (isnan(D))
            return STATUS_NAN;
        D = distance_met(c, c->near[n], obstacle, y, D, normal);
        const double off = D - c->body.start;
        *spare = fmin(*spare, still ? fmax(off, 0) : 0);
        if (off >= 0) {
            c->least = fmin(c->least, off);
            continue;
        }
        TRY(add_body(c, c->near[n], obstacle, D, normal));
        look_back(c, &c->touch[c->count - 1], x);
    }
    settle(c, first, compliance, held, x);
out:
    return st;
}

/* Ends the step of the places that meet features. Where some have come through, normals
 * hold on a part of the way only: they are found *again. */
static enum status meet_features(struct contact *c, const double *compliance,
                                 const int *held, double *x, bool *again)
{
    enum { TIMES = 4 };
    enum status st = STATUS_OK;
    int passed = 1;

    for (int n = 0; n < TIMES && passed > 0; n++) {
        *again = n > 0;
        const int first = c->count;
        TRY(add_features(c, x, &passed));
        for (int k = first; k < c->count; k++)
            look_back(c, &c->touch[k], x);
        settle(c, first, compliance, held, x);
    }
out:
    return st;
}

/* The rounds in which bodies that close from two sides find how each presses against the
 * other, and layers on a body how it bears them; their forces rise to those of the law,
 * from below. */
enum { ROUNDS = 32 };

/* Adds the touches of `near` listed samples with bodies, and of features, and ends all. */
static enum status project_bodies(struct contact *c, int near, const double *compliance,
                                  const int *held, double *x)
{
    enum status st = STATUS_OK;
    const int own = c->count;

    for (int o = 0; o < c->scene->obstacle_count; o++)
        TRY(meet_body(c, o, near, compliance, held, x));
    const int thin = c->count;
    bool again;
    TRY(meet_features(c, compliance, held, x, &again));
    const bool several = c->scene->obstacle_count > 1 || c->count > thin;
    int rounds = !again && (several || (own && c->count > own)) ? ROUNDS : 0;
    while (rounds-- > 0 && relieve(c, 0, compliance, held, x))
        ;
    take(c, 0, x);
out:
    return st;
}

enum status contact_project_bodies(struct contact *c, const double *compliance,
                                   const int *held, double *x)
{
    clear_totals(c);
    c->count = c->weights = 0;
    return project_bodies(c, list_near(c, x), compliance, held, x);
}

enum status contact_project_features(struct contact *c, const double *compliance,
                                     const int *held, double *x)
{
    clear_totals(c);
    c->count = c->weights = 0;
    return project_bodies(c, 0, compliance, held, x);
}

enum status contact_project(struct contact *c, const double *compliance, const int *held,
                            double *x)
{
    enum status st = STATUS_OK;

    clear_totals(c);
    c->count = c->weights = 0;
    TRY(add_own(c, x));
    for (int n = 0; n < c->count; n++)
        look_back(c, &c->touch[n], x);
    settle(c, 0, compliance, held, x);
    TRY(project_bodies(c, list_near(c, x), compliance, held, x));
out:
    return st;
}
