#include "models/model.h"

#include <stdlib.h>
#include <string.h>

#include "models/grid.h"
#include "models/support_lines.h"

void matrix_clear(struct matrix *m)
{
    free(m->row);
    free(m->column);
    free(m->value);
    *m = (struct matrix){0};
}

static enum status refuse(unsigned missing, const char *which, struct message *why)
{
    char text[SCENE_NEEDS_TEXT];

    if (!missing)
        return STATUS_OK;
    scene_needs_text(missing, text, sizeof text);
    return status_fail(why, STATUS_UNSUPPORTED, "unsupported: no %s%s", text, which);
}

enum status model_refuse(const struct scene *scene, unsigned serves, struct message *why)
{
    return refuse(scene_needs(scene) & ~serves, "", why);
}

/* Returns the whole row of an option: that of the models that share it, or its own. */
static const struct schema_key *whole(const struct schema_key *row)
{
    const struct schema_key *shared = option_find(option_shared, row->key);

    return shared ? shared : row;
}

static int value_of(const struct schema_key *option, const struct discretization *d)
{
    return *(const int *)(const void *)((const char *)d + option->offset);
}

/* Refuses as in "integrator=bdf2: shell has implicit, leapfrog". */
static enum status refuse_word(const struct schema_key *option, unsigned only,
                               const struct discretization *d, struct message *why)
{
    char known[256] = "";

    for (int n = 0; option->words[n]; n++)
        if (only & OPTION(n))
            TEXT_JOIN(known, ", ", "%s", option->words[n]);
    return status_fail(why, STATUS_UNSUPPORTED, "%s=%s: %s has %s", option->key,
                       option->words[value_of(option, d)], d->model->name, known);
}

/* Refuses as in "precision=single: with integrator=leapfrog only". */
static enum status refuse_alone(const struct schema_key *row,
                                const struct discretization *d, struct message *why)
{
    const struct schema_key *option = whole(row);
    const struct schema_key *needs = row->with ? row : option;
    char known[256] = "";

    if (!needs->with || !option_is_set(option, d))
        return STATUS_OK;
    const struct schema_key *other = whole(option_find(d->model->options, needs->with));
    if (needs->of & OPTION(value_of(other, d)))
        return STATUS_OK;
    for (int n = 0; other->words[n]; n++)
        if (needs->of & OPTION(n))
            TEXT_JOIN(known, " or ", "%s", other->words[n]);
    return status_fail(why, STATUS_UNSUPPORTED, "%s%s%s: with %s=%s only", option->key,
                       option->words ? "=" : "",
                       option->words ? option->words[value_of(option, d)] : "", other->key,
                       known);
}

enum status model_refuse_options(const struct discretization *d, struct message *why)
{
    enum status st = STATUS_OK;
    const struct schema_key *foreign = d->foreign;

    if (!d->model)
        return status_fail(why, STATUS_INPUT,
                           "the discretization is no model's: begin with model_defaults");
    for (const struct schema_key *s = option_shared; s->key; s++) {
        const struct schema_key *listed = option_find(d->model->options, s->key);

        if (!listed && option_is_set(s, d))
            foreign = s;
        if (listed && listed->only && !(listed->only & OPTION(value_of(s, d))))
            return refuse_word(s, listed->only, d, why);
    }
    if (foreign)
        return status_fail(why, STATUS_INPUT, "%s: %s has no use for it", foreign->key,
                           d->model->name);
    for (const struct schema_key *s = d->model->options; st == STATUS_OK && s->key; s++)
        st = refuse_alone(s, d, why);
    return st;
}

static enum status refuse_points(const struct discretization *d, struct message *why)
{
    for (int i = 0; i < 2; i++)
        if (d->points[i] < 2)
            return status_fail(why, STATUS_INPUT, "points: at least 2 along %c, not %d",
                               'u' + i, d->points[i]);
    if (d->points[2] != 1)
        return status_fail(why, STATUS_INPUT,
                           "points: %s has 1 point through the thickness, points=[n,m,1], "
                           "not %d",
                           d->model->name, d->points[2]);
    for (int i = 0; i < 3; i++)
        if (d->degree[i] != 1)
            return status_fail(why, STATUS_INPUT, "degree: %s has none", d->model->name);
    return STATUS_OK;
}

enum status model_refuse_net(const struct scene *scene, const struct discretization *d,
                             struct message *why)
{
    const unsigned thickness = SCENE_NEED_THICKNESS_SUPPORTS;
    unsigned missing = scene_needs(scene) & ~d->model->serves & ~thickness;
    enum status st;

    for (int n = 0; n < scene->support_count; n++)
        if (scene->supports[n].lo[2] > 0.5 || scene->supports[n].hi[2] < 0.5)
            missing |= thickness;
    TRY(refuse(missing, missing & thickness ? " that leave out the mid-surface" : "", why));
    TRY(refuse_points(d, why));
    TRY(model_refuse_options(d, why));
out:
    return st;
}

void model_defaults(const struct model *model, struct discretization *d)
{
    *d = model->defaults;
    d->model = model;
}

void model_open(const struct model *model, struct discretization *d)
{
    model_defaults(model, d);
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

    if (points)
        TEXT_ADD(text, "points=[%d,%d,%d], ", d->points[0], d->points[1], d->points[2]);
    if (degree)
        TEXT_ADD(text, "degree=[%d,%d,%d], ", d->degree[0], d->degree[1], d->degree[2]);
    if (remedy)
        TEXT_ADD(text, "remedy=%s, ", option_remedy[d->remedy]);
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

/* Returns whether lines of points are where a grid's are. */
static bool has_lines(const struct scene *scene, const struct discretization *d)
{
    if (scene->pattern)
        return false;
    return !d->mesh || !strcmp(d->mesh, "grid") || !strcmp(d->mesh, "diagonal");
}

/* Adds the points that the scene needs to the default ones of directions left open: lines
 * where supports end and loads lie, where twice the spans have them, and knots that repeat.
 */
static bool add_points(const struct model *model, const struct scene *scene,
                       const bool open[3], struct discretization *d)
{
    bool added = false;

    for (int i = 0; i < 2; i++) {
        const int points = d->points[i];
        if (!open[i] || d->knot_count[i] || !has_lines(scene, d) || points <= d->degree[i])
            continue;
        d->points[i] += model->extra_points ? model->extra_points(scene, d, i) : 0;
        const int fit = support_lines_points(scene, i, d->points[i], d->degree[i]);
        d->points[i] = fit ? fit : d->points[i];
        added |= d->points[i] > points;
    }
    return added;
}

void model_complete(const struct model *model, const struct scene *scene,
                    struct discretization *d, struct message *told)
{
    const bool open[3] = {!d->points[0], !d->points[1], !d->points[2]};
    const struct discretization *usual = &model->defaults;
    struct discretization all = *d;

    fill(usual, &all);
    for (int i = 0; i < 3; i++)
        if (!d->points[i])
            d->points[i] = at_least(usual->points[i], d->degree[i]);
    status_fail(told, STATUS_OK, "more does not fit the points or knots");
    if (model->adapt)
        model->adapt(scene, d, told);
    if (memcmp(d->points, all.points, sizeof d->points))
        status_fail(told, STATUS_OK, "the degree needs as many");
    fill(usual, d);
    if (add_points(model, scene, open, d) && d->remedy == all.remedy)
        status_fail(told, STATUS_OK,
                    "lines of the net lie where supports end and loads are");
    tell(&all, d, told);
}

enum status model_create(const struct model *model, const struct scene *scene,
                         const struct discretization *d, void **state, struct message *why)
{
    const size_t bytes = (model->bytes + 63) / 64 * 64;
    void *made = aligned_alloc(64, bytes);

    if (!made)
        return STATUS_MEMORY;
    const enum status st = model->init(memset(made, 0, bytes), scene, d, why);
    if (st == STATUS_OK)
        *state = made;
    else
        model_destroy(model, made);
    return st;
}

void model_destroy(const struct model *model, void *state)
{
    if (state && model->clear)
        model->clear(state);
    free(state);
}

void model_sample(const struct model *model, const void *state, double *xyz)
{
    if (model->sample)
        model->sample(state, xyz);
    else
        grid_sample(model->probe, state, xyz);
}
