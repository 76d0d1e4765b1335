#include "bench/score/score_contact.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "models/contact/contact_law.h"
#include "models/contact/contact_shape.h"
#include "models/vector.h"

/* A sheet keeps a margin if it rests farther off than this many times the distance at which
 * the scene's contact begins. */
static const double MARGIN = 1.1;

/* The cosine of the largest angle between the way to the other side and both normals, that
 * of the law of contact. */
static const double FACING = 0.7071067811865476;

enum status score_contact_begin(struct score_contact *c, const struct scene *scene,
                                const struct frames_net *frames,
                                const struct score_net *net)
{
    *c = (struct score_contact){.scene = scene, .net = net, .work.keep_pairs = true};
    const enum status st = score_net_triangles(net, frames, &c->triangles, &c->corner);
    c->work.most = (long)CROSSING_PAIRS_MOST * c->triangles;
    return st;
}

void score_contact_clear(struct score_contact *c)
{
    intersection_clear(&c->work);
    free(c->corner);
    *c = (struct score_contact){0};
}

/* Keeps the first event of a kind, and the one with the largest value of another. */
static void keep(struct score_contact *c, enum score_contact_kind first,
                 enum score_contact_kind most, const struct score_contact_event *event)
{
    if (!c->event[first].frame)
        c->event[first] = *event;
    if (event->value > c->event[most].value)
        c->event[most] = *event;
}

/* Returns the obstacle that is nearest to x at a time, and its distance; -1: there is none.
 */
static int nearest_body(const struct scene *scene, double t, const double x[3],
                        double *distance)
{
    int which = -1;

    *distance = INFINITY;
    for (int n = 0; n < scene->obstacle_count; n++) {
        struct contact_pose pose;
        contact_pose_at(&scene->obstacles[n], t, &pose);
        const double far = contact_shape_distance(&scene->obstacles[n], &pose, x, NULL);
        if (far < *distance) {
            *distance = far;
            which = n;
        }
    }
    return which;
}

static enum status take_itself(struct score_contact *c, struct score_contact_event event,
                               const double *xyz)
{
    long pairs;
    enum status st;

    TRY(intersection_count_mesh(&c->work, c->net->vertices, xyz, c->triangles, c->corner,
                                &pairs));
    if (!pairs)
        return STATUS_OK;
    TRY(crossing_measure(&c->work, CROSSING_TOLERANCE, &event.with));
    event.value = event.with.depth;
    if (event.with.pairs)
        keep(c, SCORE_CONTACT_ITSELF, SCORE_CONTACT_ITSELF_DEEPEST, &event);
    else
        keep(c, SCORE_CONTACT_TOUCHES, SCORE_CONTACT_TOUCHES, &event);
out:
    return st;
}

enum status score_contact_take(struct score_contact *c, double t, const double *xyz)
{
    struct score_contact_event event = {.frame = ++c->frames, .time = t}, body = event;
    const enum status st = take_itself(c, event, xyz);

    for (int n = 0; st == STATUS_OK && n < c->net->vertices; n++) {
        double distance;
        const int obstacle = nearest_body(c->scene, t, xyz + 3L * n, &distance);
        if (!(-distance > fmax(body.value, CROSSING_TOLERANCE)))
            continue;
        body.value = -distance;
        body.vertex = n;
        body.obstacle = obstacle;
    }
    if (body.value > 0)
        keep(c, SCORE_CONTACT_BODY, SCORE_CONTACT_BODY_DEEPEST, &body);
    return st;
}

/* --- At rest --- */

/* Tells whether a triangle, at its nearest point, and the vertex face each other. The
 * search's context is the normals of the vertices. */
static bool is_facing(const struct intersection *s,
                      const struct intersection_search *search, const int corner[3],
                      const double foot[3])
{
    const double *x = search->x, *normal = (const double *)search->context + (x - s->point);
    double way[3], a[3], b[3], other[3];

    for (int k = 0; k < 3; k++)
        if (x == s->point + 3L * corner[k])
            return false;
    vector_between(x, foot, way);
    vector_between(s->point + 3L * corner[0], s->point + 3L * corner[1], a);
    vector_between(s->point + 3L * corner[0], s->point + 3L * corner[2], b);
    vector_cross(a, b, other);
    const double least = FACING * vector_length(way);
    return fabs(vector_dot(way, normal)) >= least * vector_length(normal) &&
           fabs(vector_dot(way, other)) >= least * vector_length(other);
}

/* Sums the normals of the triangles at each vertex, by their areas. */
static double *make_normals(const struct score_contact *c, const double *xyz)
{
    double *normal = calloc(3 * (size_t)c->net->vertices, sizeof *normal);

    for (int n = 0; normal && n < c->triangles; n++) {
        const int *p = c->corner[n];
        double a[3], b[3], area[3];
        vector_between(xyz + 3L * p[0], xyz + 3L * p[1], a);
        vector_between(xyz + 3L * p[0], xyz + 3L * p[2], b);
        vector_cross(a, b, area);
        for (int k = 0; k < 9; k++)
            normal[3L * p[k / 3] + k % 3] += area[k % 3];
    }
    return normal;
}

/* Keeps the least distance of a kind. */
static void keep_least(struct score_contact *c, enum score_contact_kind kind, double time,
                       double distance, int vertex, int obstacle)
{
    struct score_contact_event *e = &c->event[kind];

    if (distance < SCORE_CONTACT_REACH * c->scene->length &&
        (!e->frame || distance < e->value))
        *e = (struct score_contact_event){.frame = c->frames,
                                          .time = time,
                                          .value = distance,
                                          .vertex = vertex,
                                          .obstacle = obstacle};
}

enum status score_contact_end(struct score_contact *c, double time, double seconds,
                              const double *before, const double *xyz)
{
    const struct intersection *s = &c->work;
    const double length = c->scene->length;
    double *normal = make_normals(c, xyz), way[3], distance;

    if (!normal)
        return STATUS_MEMORY;
    for (int n = 0; n < c->net->vertices; n++) {
        vector_between(before + 3L * n, xyz + 3L * n, way);
        if (!(vector_length(way) <= SCORE_CONTACT_STILL * length * seconds))
            continue;
        const int obstacle = nearest_body(c->scene, time, xyz + 3L * n, &distance);
        keep_least(c, SCORE_CONTACT_REST_BODY, time, distance, n, obstacle);
        struct intersection_search search = {s->point + 3L * n, normal, is_facing, 0,
                                             SCORE_CONTACT_REACH * length / s->scale};
        intersection_nearest(s, &search);
        keep_least(c, SCORE_CONTACT_REST_ITSELF, time, search.least * s->scale, n, -1);
    }
    free(normal);
    return STATUS_OK;
}

/* --- Words --- */

const char *score_contact_name(enum score_contact_kind kind)
{
    static const char *const name[] = {
#define SCORE_CONTACT_NAME(code, text) text,
        SCORE_CONTACT_KIND_LIST(SCORE_CONTACT_NAME)
#undef SCORE_CONTACT_NAME
    };

    return name[kind];
}

bool score_contact_tells(const struct score_contact *c, enum score_contact_kind kind)
{
    const struct score_contact_event *e = c->event;

    if (kind == SCORE_CONTACT_TOUCHES && e[SCORE_CONTACT_ITSELF].frame)
        return false;
    if (kind == SCORE_CONTACT_ITSELF_DEEPEST || kind == SCORE_CONTACT_BODY_DEEPEST)
        return e[kind].frame != e[kind - 1].frame;
    return e[kind].frame;
}

/* Writes how far off the sheet is at rest, and where the scene's contact begins. */
static void rest_text(const struct score_contact_event *e, const char *what, double start,
                      const char *share, char text[SCORE_CONTACT_TEXT])
{
    const bool margin = e->value > MARGIN * start;

    snprintf(text, SCORE_CONTACT_TEXT,
             "%s: at the end, %.4g s, what rests is at least %.3g mm off %s; the scene's "
             "contact begins at %.3g mm, %s the contact thickness.",
             margin ? "Rests on a margin" : "Rests without a margin", e->time,
             1e3 * e->value, what, 1e3 * start, share);
}

void score_contact_text(const struct score_contact *c, enum score_contact_kind kind,
                        char text[SCORE_CONTACT_TEXT])
{
    const struct score_contact_event *e = &c->event[kind];
    const double *uv = c->net->uv + 2L * e->vertex;
    char at[64], body[32];

    snprintf(at, sizeof at, "frame %d (%.4g s)", e->frame, e->time);
    snprintf(body, sizeof body, "obstacle %d", e->obstacle);
    if (kind == SCORE_CONTACT_ITSELF || kind == SCORE_CONTACT_ITSELF_DEEPEST)
        snprintf(text, SCORE_CONTACT_TEXT,
                 "%s %s: %d triangles cross in %ld pairs, %.3g mm deep.",
                 kind == SCORE_CONTACT_ITSELF ? "Passes through itself, first in"
                                              : "It is deepest in itself in",
                 at, e->with.triangles, e->with.pairs, 1e3 * e->value);
    else if (kind == SCORE_CONTACT_TOUCHES)
        snprintf(text, SCORE_CONTACT_TEXT, "Touches itself without a gap, first in %s.",
                 at);
    else if (kind == SCORE_CONTACT_BODY || kind == SCORE_CONTACT_BODY_DEEPEST)
        snprintf(text, SCORE_CONTACT_TEXT, "%s %s in %s: %.3g mm at u = %.3g, v = %.3g.",
                 kind == SCORE_CONTACT_BODY ? "Passes through" : "It is deepest in", body,
                 at, 1e3 * e->value, uv[0], uv[1]);
    else if (kind == SCORE_CONTACT_REST_BODY)
        rest_text(e, body, contact_law_body(c->scene).start, "half", text);
    else
        rest_text(e, "other parts of itself", contact_law_self(c->scene).start, "which is",
                  text);
}
