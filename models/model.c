#include "models/model.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "models/contact.h"

void matrix_clear(struct matrix *m)
{
    free(m->row);
    free(m->column);
    free(m->value);
    *m = (struct matrix){0};
}

static enum status refuse(unsigned missing, const char *which, struct message *why)
{
    char text[256];

    if (!missing)
        return STATUS_OK;
    scene_needs_text(missing, text, sizeof text);
    return status_fail(why, STATUS_UNSUPPORTED, "unsupported: no %s%s", text, which);
}

/* Refuses a sheet that begins in an obstacle, whatever the model and net. */
static enum status refuse_depth(const struct scene *scene, struct message *why)
{
    for (int o = 0; o < scene->obstacle_count; o++) {
        const double depth = contact_rest_depth(scene, &scene->obstacles[o]);
        if (depth > 0)
            return status_fail(why, STATUS_INPUT, CONTACT_REST_DEPTH, depth, o);
    }
    return STATUS_OK;
}

enum status model_refuse(const struct scene *scene, unsigned serves, struct message *why)
{
    const enum status st = refuse(scene_needs(scene) & ~serves, "", why);

    return st == STATUS_OK ? refuse_depth(scene, why) : st;
}

enum status model_refuse_net(const struct scene *scene, unsigned serves,
                             struct message *why)
{
    const unsigned thickness = SCENE_NEED_THICKNESS_SUPPORTS;
    unsigned missing = scene_needs(scene) & ~serves & ~thickness;

    for (int n = 0; n < scene->support_count; n++)
        if (scene->supports[n].lo[2] > 0.5 || scene->supports[n].hi[2] < 0.5)
            missing |= thickness;
    const enum status st =
        refuse(missing, missing & thickness ? " that leave out the mid-surface" : "", why);
    return st == STATUS_OK ? refuse_depth(scene, why) : st;
}

void model_open(const struct model *model, struct discretization *d)
{
    model->defaults(d);
    memset(d->points, 0, sizeof d->points);
    memset(d->degree, 0, sizeof d->degree);
    d->remedy = REMEDY_AUTO;
}

static void fill(const struct discretization *usual, struct discretization *d)
{
    for (int i = 0; i < 3; i++) {
        d->points[i] = d->points[i] ? d->points[i] : usual->points[i];
        d->degree[i] = d->degree[i] ? d->degree[i] : usual->degree[i];
    }
    if (d->remedy == REMEDY_AUTO)
        d->remedy = usual->remedy;
}

/* Says which settings are not the usual ones, and why; *why has the model's reason. */
static void tell(const struct discretization *usual, const struct discretization *d,
                 struct message *why)
{
    const bool points = memcmp(d->points, usual->points, sizeof d->points),
               degree = memcmp(d->degree, usual->degree, sizeof d->degree),
               remedy = d->remedy != usual->remedy;
    const struct message reason = *why;
    char text[128] = "";
    size_t used = 0;

    if (points)
        used = (size_t)snprintf(text, sizeof text, "points=[%d,%d,%d], ", d->points[0],
                                d->points[1], d->points[2]);
    if (degree)
        used += (size_t)snprintf(text + used, sizeof text - used, "degree=[%d,%d,%d], ",
                                 d->degree[0], d->degree[1], d->degree[2]);
    if (remedy)
        snprintf(text + used, sizeof text - used, "remedy=%s, ", remedy_name(d->remedy));
    if (points || degree || remedy)
        status_fail(why, STATUS_OK, "%snot the defaults: %s", text, reason.text);
    else
        why->text[0] = '\0';
}

/* Returns a direction's points, raised to suit a given degree (0: any); 0 and 1 stay. */
static int at_least(int points, int degree)
{
    return points > 1 && points <= degree ? degree + 1 : points;
}

/* Adds the points that the scene needs to the default ones of directions left open. */
static bool add_points(const struct model *model, const struct scene *scene,
                       const bool open[3], struct discretization *d)
{
    bool added = false;

    for (int i = 0; model->extra_points && i < 3; i++) {
        const int more =
            open[i] && !d->knot_count[i] ? model->extra_points(scene, d, i) : 0;
        d->points[i] += more;
        added |= more > 0;
    }
    return added;
}

void model_complete(const struct model *model, const struct scene *scene,
                    struct discretization *d, struct message *told)
{
    const bool open[3] = {!d->points[0], !d->points[1], !d->points[2]};
    struct discretization usual, all = *d;

    model->defaults(&usual);
    fill(&usual, &all);
    for (int i = 0; i < 3; i++)
        if (!d->points[i])
            d->points[i] = at_least(usual.points[i], d->degree[i]);
    status_fail(told, STATUS_OK, "more does not fit the points or knots");
    if (model->adapt)
        model->adapt(scene, d, told);
    if (memcmp(d->points, all.points, sizeof d->points))
        status_fail(told, STATUS_OK, "the degree needs as many");
    fill(&usual, d);
    if (add_points(model, scene, open, d) && d->remedy == all.remedy)
        status_fail(told, STATUS_OK, "knots repeat at the ends of supports");
    tell(&all, d, told);
}
