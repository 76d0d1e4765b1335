#include "bench/score/score_contact.h"

#include <math.h>
#include <stdio.h>

#include "models/contact/contact_law.h"
#include "models/bodies/body_shape.h"
#include "models/pattern.h"
#include "models/vector.h"

/* A sheet keeps a margin if it rests farther off than this many times the distance at which
 * the scene's contact begins. */
static const double MARGIN = 1.1;

void score_contact_begin(struct arena *arena, struct score_contact *c,
                         const struct scene *scene, const struct frames_net *frames,
                         const struct score_net *net)
{
    *c = (struct score_contact){.scene = scene,
                                .net = net,
                                .beside = frames->beside,
                                .unsewn = frames->beside &&
                                          pattern_starts_in_space(scene->pattern),
                                .work = {.keep_pairs = true, .shake = CROSSING_SHAKE}};
    c->corner = score_net_triangles(arena, net, frames, scene, &c->triangles);
    c->work.most = (long)CROSSING_PAIRS_MOST * c->triangles;
}

void score_contact_clear(struct score_contact *c)
{
    intersection_clear(&c->work);
    *c = (struct score_contact){0};
}

/* Returns the obstacle that is nearest to x at a time, and its distance; -1: there is none.
 */
static int nearest_body(const struct scene *scene, double t, const double x[3],
                        double *distance)
{
    int which = -1;

    *distance = INFINITY;
    for (int n = 0; n < scene->obstacle_count; n++) {
        struct scene_placement pose;
        scene_motion_at(&scene->obstacles[n].motion, t, &pose);
        const double far = body_shape_distance(&scene->obstacles[n], &pose, x, NULL);
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

    if (c->unsewn)
        return STATUS_OK;
    CALL(intersection_count_mesh(&c->work, c->net->vertices, xyz, c->triangles, c->corner,
                                 &pairs));
    if (pairs <= c->event[SCORE_CONTACT_ITSELF_WORST].with.pairs)
        return STATUS_OK;
    CALL(crossing_measure(&c->work, CROSSING_TOLERANCE, &event.with));
    event.value = event.with.depth;
    if (event.with.pairs && !c->event[SCORE_CONTACT_ITSELF].frame)
        c->event[SCORE_CONTACT_ITSELF] = event;
    if (event.with.pairs)
        c->event[SCORE_CONTACT_ITSELF_WORST] = event;
    return STATUS_OK;
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
    if (body.value > 0 && !c->event[SCORE_CONTACT_BODY].frame)
        c->event[SCORE_CONTACT_BODY] = body;
    if (body.value > c->event[SCORE_CONTACT_BODY_DEEPEST].value)
        c->event[SCORE_CONTACT_BODY_DEEPEST] = body;
    return st;
}

/* --- At rest --- */

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

void score_contact_end(struct score_contact *c, double time, double seconds,
                       const double *before, const double *xyz)
{
    const struct intersection *s = &c->work;
    const double length = c->scene->length;
    double distance;

    for (int n = 0; n < c->net->vertices; n++) {
        if (c->beside && c->beside[n])
            continue;
        if (!(vector_distance(before + 3L * n, xyz + 3L * n) <=
              SCORE_CONTACT_STILL * length * seconds))
            continue;
        const int obstacle = nearest_body(c->scene, time, xyz + 3L * n, &distance);
        keep_least(c, SCORE_CONTACT_REST_BODY, time, distance, n, obstacle);
        struct intersection_search search = {.x = s->point + 3L * n,
                                             .counts = crossing_faces,
                                             .least =
                                                 SCORE_CONTACT_REACH * length / s->scale};
        if (!c->unsewn && intersection_nearest(s, &search))
            keep_least(c, SCORE_CONTACT_REST_ITSELF, time, search.least * s->scale, n, -1);
    }
}

/* --- Words --- */

const char *score_contact_name(enum score_contact_kind kind)
{
    static const char *const name[] = {SCORE_CONTACT_KIND_LIST(LIST_WORD)};

    return name[kind];
}

bool score_contact_tells(const struct score_contact *c, enum score_contact_kind kind)
{
    const struct score_contact_event *e = c->event;

    if (kind == SCORE_CONTACT_ITSELF_WORST || kind == SCORE_CONTACT_BODY_DEEPEST)
        return e[kind].frame != e[kind - 1].frame;
    return e[kind].frame;
}

/* Writes how far off the sheet is at rest, and where the scene's contact begins. */
static void rest_text(const struct score_contact_event *e, const char *what, double start,
                      const char *share, char text[SCORE_CONTACT_TEXT])
{
    const bool margin = e->value > MARGIN * start;
    char off[48] = "touches";

    if (e->value > CROSSING_TOLERANCE)
        snprintf(off, sizeof off, "is at least %.3g mm off", 1e3 * e->value);
    snprintf(text, SCORE_CONTACT_TEXT,
             "%s: at the end, %.4g s, what rests %s %s; the scene's contact begins at %.3g "
             "mm, %s the contact thickness.",
             margin ? "Rests on a margin" : "Rests without a margin", e->time, off, what,
             1e3 * start, share);
}

void score_contact_text(const struct score_contact *c, enum score_contact_kind kind,
                        char text[SCORE_CONTACT_TEXT])
{
    const struct score_contact_event *e = &c->event[kind];
    const double *uv = c->net->uv + 2L * e->vertex;
    const char *itself = scene_sheet_other(c->scene);
    char at[64], body[32], through[80], other[80];

    snprintf(at, sizeof at, "frame %d (%.4g s)", e->frame, e->time);
    snprintf(body, sizeof body, "obstacle %d", e->obstacle);
    snprintf(through, sizeof through, "Passes through %s, first in", itself);
    snprintf(other, sizeof other, "other parts of %s", itself);
    if (kind == SCORE_CONTACT_ITSELF || kind == SCORE_CONTACT_ITSELF_WORST)
        snprintf(text, SCORE_CONTACT_TEXT,
                 "%s %s: %d triangles cross in %ld pairs, %.3g mm deep.",
                 kind == SCORE_CONTACT_ITSELF ? through : "It is worst in", at,
                 e->with.triangles, e->with.pairs, 1e3 * e->value);
    else if (kind == SCORE_CONTACT_BODY || kind == SCORE_CONTACT_BODY_DEEPEST)
        snprintf(text, SCORE_CONTACT_TEXT, "%s %s in %s: %.3g mm at u = %.3g, v = %.3g.",
                 kind == SCORE_CONTACT_BODY ? "Passes through" : "It is deepest in", body,
                 at, 1e3 * e->value, uv[0], uv[1]);
    else if (kind == SCORE_CONTACT_REST_BODY)
        rest_text(e, body, contact_law_body(c->scene).start, "half", text);
    else
        rest_text(e, other, contact_law_self(c->scene).start, "which is", text);
}
