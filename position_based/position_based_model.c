#include "position_based/position_based_model.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "models/damping.h"
#include "models/room.h"
#include "models/vector.h"

/* The softening that the choice of substeps tolerates, without and with contact, and a
 * bending mode's phase in the substeps from one bending to the next
 * (position_based_model.h). */
static const double SOFTENING = 10, SOFTENING_CONTACT = 0.4, BENDING = 0.4;

static const double MOST_SUBSTEPS = 1e6;

/* The iterations of a step at most, unless their number is given; then the frames from one
 * measurement of what they leave to the next. */
enum { MOST_ITERATIONS = 100, MEASURED = 10 };

static size_t count(const struct pb_motion *m)
{
    return 3 * (size_t)m->net.mesh.nodes;
}

/* --- what is built -----------------------------------------------------------------------
 */

/* Returns the strength dt^2 / alpha of a constraint of stiffness k for XPBD, or that which
 * takes PBD's share of the way; w: sum of inverse masses times squares of weights. */
static double strength_of(const struct pb_motion *m, double k, double w)
{
    double s = k * m->dt * m->dt;

    if (m->projection == PROJECTION_XPBD || w == 0)
        return s;
    double share = -expm1(-log1p(s * w) / m->arrival.most);
    return share / ((1 - share) * w);
}

static double inverse_mass(const struct pb_motion *m, int a)
{
    return 1 / (m->net.mass[a] + m->net.drag[a] * m->dt);
}

/* Returns the inverse mass where any component is free, else 0. */
static double free_inverse_mass(const struct pb_motion *m, int a)
{
    const int *place = m->net.supports.free_index + 3 * a;

    return place[0] >= 0 || place[1] >= 0 || place[2] >= 0 ? inverse_mass(m, a) : 0;
}

/* Puts what points have of their own. */
static void put_points(struct pb_motion *m)
{
    double *w = m->work, *kick = w + count(m), *keep = kick + count(m);

    for (int a = 0; a < m->net.mesh.nodes; a++) {
        double inverse = inverse_mass(m, a);
        keep[a] = m->net.mass[a] * inverse;
        if (m->net.contact)
            m->net.contact->compliance[a] = inverse * m->dt * m->dt;
        for (int c = 3 * a; c < 3 * a + 3; c++) {
            bool held = m->net.supports.free_index[c] < 0;
            w[c] = held ? 0 : inverse;
            kick[c] = w[c] * m->dt * m->dt * m->net.load[c];
            if (m->way[c % 3] != 0)
                kick[c] += (keep[a] - 1) * m->way[c % 3];
        }
    }
    pb_sweep_put(m->sweep, PB_W, 3, w);
    pb_sweep_put(m->sweep, PB_KICK, 3, kick);
    pb_sweep_put(m->sweep, PB_KEEP, 1, keep);
}

static enum pb_kind kind_of(const struct pb_motion *m, const struct spring *s)
{
    int rows = s->b / m->net.mesh.points[1] - s->a / m->net.mesh.points[1];
    int step = s->b % m->net.mesh.points[1] - s->a % m->net.mesh.points[1];

    return rows == 0 ? PB_V : step == 0 ? PB_U : step > 0 ? PB_DOWN : PB_UP;
}

static void put_springs(struct pb_motion *m)
{
    for (int n = 0; m->link && n < m->springs.spring_count; n++) {
        const struct spring *s = &m->springs.springs[n];
        const double w = free_inverse_mass(m, s->a) + free_inverse_mass(m, s->b);
        m->link[n] =
            (struct pb_link){{s->a, s->b}, s->length, strength_of(m, s->stiffness, w), 0};
    }
    for (int kind = 0; !m->link && kind < PB_SPRINGS; kind++) {
        memset(m->work, 0, count(m) * sizeof *m->work);
        for (const struct spring *s = m->springs.springs;
             s < m->springs.springs + m->springs.spring_count; s++) {
            double w = free_inverse_mass(m, s->a) + free_inverse_mass(m, s->b);
            if ((int)kind_of(m, s) == kind)
                m->work[s->a] = strength_of(m, s->stiffness, w);
        }
        pb_sweep_put(m->sweep, PB_STRENGTH + kind, 1, m->work);
    }
}

/* Sets a form. Where components are held the others' weight is taken for all, so that one
 * factor suffices: that only takes more iterations. */
static void set_form(const struct pb_motion *m, int k, double *strength, double *recall)
{
    const struct spring_form *form = spring_form_of(&m->forms, k);
    double sum = 0;

    for (int n = 0; n < form->count; n++)
        sum += form->weight[n] * form->weight[n] *
               free_inverse_mass(m, m->forms.place[k].at + form->step[n]);
    pb_sweep_form(strength_of(m, m->bending_every * form->stiffness, sum),
                  1 + m->net.beta / m->dt, sum, strength, recall);
}

static void put_forms(struct pb_motion *m)
{
    static const int kind_of_form[] = {[SPRING_PLATE_U] = PB_LINE_U,
                                       [SPRING_PLATE_V] = PB_LINE_V,
                                       [SPRING_PLATE_TWIST] = PB_TWIST,
                                       [SPRING_PLATE_MEAN] = PB_MEAN};
    double *strength = m->work, *recall = m->work + m->net.mesh.nodes;

    for (int k = SPRING_PLATE_U; k <= SPRING_PLATE_MEAN; k++) {
        int kind = kind_of_form[k];
        memset(m->work, 0, count(m) * sizeof *m->work);
        for (int n = 0; n < m->forms.count; n++) {
            const int at = m->forms.place[n].at;
            if (spring_form_of(&m->forms, n)->kind == k)
                set_form(m, n, &strength[at], &recall[at]);
        }
        pb_sweep_put(m->sweep, PB_STRENGTH + kind, 1, strength);
        pb_sweep_put(m->sweep, PB_RECALL + kind - PB_SPRINGS, 1, recall);
    }
}

/* Lists the forms that lie anywhere, clamps and those of triangles. Returns how many. */
static int list_odd(struct pb_motion *m)
{
    int clamps = 0;

    for (int n = 0; n < m->forms.count; n++) {
        const struct spring_form *form = spring_form_of(&m->forms, n);
        struct pb_odd *odd = &m->odd[clamps];
        if (form->kind != SPRING_PLATE_CLAMP && form->kind != SPRING_PLATE_SLOPE)
            continue;
        set_form(m, n, &odd->strength, &odd->recall);
        odd->count = form->count;
        memcpy(odd->weight, form->weight, sizeof odd->weight);
        memcpy(odd->shift, form->shift, sizeof odd->shift);
        for (int k = 0; k < form->count; k++)
            odd->node[k] = m->forms.place[n].at + form->step[k];
        clamps++;
    }
    return clamps;
}

/* Lets the sweep's origin follow, and puts what depends on it; `new`: in any case. */
static void follow(struct pb_motion *m, bool new)
{
    if (!pb_sweep_follow(m->sweep, m->net.x, m->net.v, m->way) && !new)
        return;
    put_points(m);
    for (size_t n = 0; n < count(m); n++)
        m->work[n] = m->dt * m->net.v[n];
    pb_sweep_put(m->sweep, PB_X, 3, m->net.x);
    pb_sweep_put(m->sweep, PB_D, 3, m->work);
}

static enum status make_sweep(struct pb_motion *m, enum precision precision)
{
    enum status st;
    const double *cell = m->net.mesh.cell, diagonal = hypot(cell[0], cell[1]);
    struct pb_plan plan = {.n = m->net.mesh.points[0],
                           .m = m->net.mesh.points[1],
                           .sheet = m->net.mesh.rows ? m->net.mesh.rows : 1,
                           .precision = precision,
                           .rest = {cell[0], cell[1], diagonal, diagonal},
                           .gain = 1 + m->net.beta / m->dt,
                           .dt = m->dt,
                           .origin.length =
                               precision == PRECISION_SINGLE ? m->net.scene->length : 0,
                           .origin.carried = supports_most(&m->net.supports) == 0,
                           .odd = m->odd,
                           .odd_count = list_odd(m),
                           .link = m->link,
                           .link_count = m->link ? m->springs.spring_count : 0};

    spring_plate_mean(m->net.scene, cell, plan.mean);
    TRY(pb_sweep_make(&plan, &m->sweep));
    put_springs(m);
    put_forms(m);
    follow(m, true);
out:
    return st;
}

/* Returns the greatest 2 k / m of a spring: the softening of a step of one second. */
static double stiffest(const struct pb_motion *m)
{
    double most = 0;

    for (const struct spring *s = m->springs.springs;
         s < m->springs.springs + m->springs.spring_count; s++)
        most = fmax(most, s->stiffness * (1 / m->net.mass[s->a] + 1 / m->net.mass[s->b]));
    return most;
}

/* Returns an upper bound of the bending's frequencies (Gershgorin) [rad/s]. */
static double bending_frequency(const struct pb_motion *m)
{
    double most = 0;

    memset(m->work, 0, count(m) * sizeof *m->work);
    for (int n = 0; n < m->forms.count; n++) {
        const struct spring_form *form = spring_form_of(&m->forms, n);
        double sum = 0;
        for (int k = 0; k < form->count; k++)
            sum += fabs(form->weight[k]);
        for (int k = 0; k < form->count; k++)
            m->work[m->forms.place[n].at + form->step[k]] +=
                form->stiffness * fabs(form->weight[k]) * sum;
    }
    for (int a = 0; a < m->net.mesh.nodes; a++)
        most = fmax(most, m->work[a] * free_inverse_mass(m, a));
    return sqrt(most);
}

static enum status set_steps(struct pb_motion *m, const struct discretization *d,
                             struct message *why)
{
    double step = m->net.scene->step, most = stiffest(m);
    double bending = bending_frequency(m);
    double borne = contact_wanted(m->net.scene) ? SOFTENING_CONTACT : SOFTENING;
    double least = fmax(sqrt(most / borne), bending / BENDING);
    double n = d->substeps ? d->substeps : fmax(1, ceil(step * least));

    if (!(n <= MOST_SUBSTEPS))
        return status_fail(why, STATUS_INPUT,
                           "steps this small are %g to a frame; set substeps", n);
    m->substeps = (int)n;
    m->dt = step / n;
    m->softening = most * m->dt * m->dt;
    m->bending_every = (int)fmin(n, fmax(1, BENDING / (m->dt * bending)));
    return STATUS_OK;
}

static double elastic(const struct pb_motion *m)
{
    double sum = spring_net_energy(&m->springs, m->net.x), value[3];

    for (int n = 0; n < m->forms.count; n++) {
        spring_form_value(&m->forms, n, m->net.x, value);
        for (int c = 0; c < 3; c++)
            sum += spring_form_of(&m->forms, n)->stiffness * value[c] * value[c] / 2;
    }
    return sum;
}

static enum status allocate(struct pb_motion *m)
{
    size_t nodes = (size_t)m->net.mesh.nodes;

    return room_cut(&m->room, ROOM(m->before, 3 * nodes), ROOM(m->work, 9 * nodes),
                    ROOM(m->odd, m->forms.count),
                    ROOM(m->link, m->net.mesh.rows ? 0 : m->springs.spring_count));
}

void pb_motion_clear(void *motion)
{
    struct pb_motion *m = motion;

    pb_sweep_free(m->sweep);
    spring_net_clear(&m->springs);
    net_clear(&m->net);
    spring_forms_clear(&m->forms);
    free(m->room);
    memset(m, 0, sizeof *m);
}

static enum status make_contact(struct pb_motion *m)
{
    enum status st = net_meet(&m->net);

    if (m->net.contact)
        m->net.contact->steps = m->substeps, m->net.contact->dt = m->dt;
    return st;
}

enum status pb_motion_init(struct pb_motion *m, const struct scene *scene,
                           const struct discretization *d, struct message *why)
{
    enum status st;

    *m = (struct pb_motion){.projection = OWN(pb_own, d)->projection};
    /* PBD's stiffness depends on the number of iterations: nothing to arrive at. */
    const bool one = m->projection == PROJECTION_PBD && !d->iterations;
    TRY(net_init(&m->net, scene, d, why));
    mesh_weigh_edges(&m->net.mesh, scene->density * scene->thickness, m->net.mass);
    TRY(spring_net_init(&m->springs, scene, &m->net.mesh, d->parameters, false));
    TRY(spring_plate_make(scene, &m->net.mesh, d->parameters, &m->forms));
    TRY(allocate(m));
    m->rest_energy = m->net.mesh.flat.start ? 0 : elastic(m);
    TRY(set_steps(m, d, why));
    net_arrive(&m->net, one ? 1 : d->iterations, MOST_ITERATIONS, m->dt, &m->arrival);
    TRY(make_contact(m));
    TRY(net_make_air(&m->net));
    TRY(make_sweep(m, d->precision));
out:
    return st;
}

/* --- steps -------------------------------------------------------------------------------
 */

static void hold(struct pb_motion *m, double t)
{
    const struct supports *s = &m->net.supports;

    supports_shift(s, m->net.scene, t, m->net.shift);
    for (int h = 0; h < s->held_count; h++)
        pb_sweep_hold(m->sweep, s->held[h] / 3, s->held[h] % 3,
                      m->net.mesh.rest[s->held[h]] + m->net.shift[h]);
}

/* Adds to force[nodes][3] what the springs pull at start + d: their elastic force and the
 * resistance to its change. */
static void add_springs(const struct pb_motion *m, const double *start, const double *d,
                        double *force)
{
    const double gamma = m->net.beta / m->dt;

    for (const struct spring *s = m->springs.springs;
         s < m->springs.springs + m->springs.spring_count; s++) {
        double e[3], step[3];
        vector_between(d + 3 * s->a, d + 3 * s->b, step);
        vector_between(start + 3 * s->a, start + 3 * s->b, e);
        for (int i = 0; i < 3; i++)
            e[i] += step[i];
        const double l = vector_length(e),
                     pull =
                         s->stiffness * (l - s->length + gamma * vector_dot(e, step) / l);
        for (int i = 0; i < 3; i++) {
            force[3 * s->a + i] -= pull * e[i] / l;
            force[3 * s->b + i] += pull * e[i] / l;
        }
    }
}

/* Returns whether the step that ends at t does so after `done` iterations: computes the
 * forces that they leave (position_based_model.h). */
static bool ends(struct pb_motion *m, int done, bool bends, double t)
{
    double *start = m->work, *d = start + count(m), *force = d + count(m), value[3];
    const int *place = m->net.supports.free_index;
    const double square = m->dt * m->dt, gain = 1 + m->net.beta / m->dt;

    pb_sweep_get(m->sweep, PB_X, 3, start);
    pb_sweep_get(m->sweep, PB_D, 3, d);
    for (size_t n = 0; n < count(m); n++)
        force[n] = d[n] / (inverse_mass(m, (int)n / 3) * square) - m->net.load[n] -
                   m->net.mass[n / 3] * m->before[n] / square;
    add_springs(m, start, d, force);
    for (size_t n = 0; n < count(m); n++) {
        start[n] += gain * d[n];
        d[n] = (d[n] - m->before[n]) / square;
    }
    for (int k = 0; bends && k < m->forms.count; k++) {
        spring_form_value(&m->forms, k, start, value);
        spring_form_pull(&m->forms, k,
                         m->bending_every * spring_form_of(&m->forms, k)->stiffness, value,
                         force);
    }
    const struct arrival_forces f = {
        arrival_sum(m->net.mesh.nodes, place, true, NULL, force),
        arrival_sum(m->net.mesh.nodes, place, false, NULL, force),
        arrival_sum(m->net.mesh.nodes, place, true, m->net.mass, d)};
    return arrival_ends(&m->arrival, done, &f, t);
}

/* Lets grippers take hold and let go at time t: constraints know what is held. */
static void change_hands(struct pb_motion *m, double t)
{
    struct supports *s = &m->net.supports;

    if (!s->whose)
        return;
    pb_sweep_get(m->sweep, PB_X, 3, m->before);
    if (!supports_change(s, m->net.scene, t, m->before))
        return;
    put_points(m);
    put_springs(m);
    put_forms(m);
    list_odd(m);
}

/* Puts the air's force in a step from time t. */
static void meet_air(struct pb_motion *m, double t)
{
    double *x = m->work, *v = x + count(m);

    pb_sweep_get(m->sweep, PB_X, 3, x);
    pb_sweep_get(m->sweep, PB_D, 3, v);
    for (size_t n = 0; n < count(m); n++)
        v[n] /= m->dt;
    net_blow(&m->net, t, m->dt, x, v);
    put_points(m);
}

/* Ends a step by the law of contact. */
static enum status meet_bodies(struct pb_motion *m, double t)
{
    enum status st;
    double *start = m->work, *x = start + count(m);

    pb_sweep_get(m->sweep, PB_X, 3, start);
    pb_sweep_get(m->sweep, PB_D, 3, x);
    for (size_t n = 0; n < count(m); n++)
        x[n] += start[n];
    TRY(net_contact_project(m->net.contact, t, start, x));
    if (m->net.contact->law.count == 0)
        return STATUS_OK;
    for (size_t n = 0; n < count(m); n++)
        x[n] -= start[n];
    pb_sweep_put(m->sweep, PB_D, 3, x);
out:
    return st;
}

/* Takes a substep; asked: measures what a fixed number of iterations leaves. */
static enum status substep(struct pb_motion *m, bool asked, struct counters *counters)
{
    const bool xpbd = m->projection == PROJECTION_XPBD, looks = xpbd && asked,
               recalls = xpbd && (m->arrival.most > 1 || asked),
               bends = ++m->substep % m->bending_every == 0;
    const double t = (double)m->substep / m->substeps * m->net.scene->step;
    enum status st = STATUS_OK;
    int done = 0;

    change_hands(m, t - m->dt);
    if (m->net.calm)
        meet_air(m, t - m->dt);
    if (looks)
        pb_sweep_get(m->sweep, PB_D, 3, m->before);
    pb_sweep_predict(m->sweep, recalls);
    if (m->net.supports.moving)
        hold(m, t);
    do {
        const int until = arrival_next(&m->arrival, done);
        pb_sweep_project(m->sweep, until - done, bends, recalls);
        done = until;
    } while (looks && !ends(m, done, bends, t));
    counters->iterations += done;
    if (m->net.contact)
        TRY(meet_bodies(m, t));
    pb_sweep_finish(m->sweep);
out:
    return st;
}

enum status pb_motion_frame(void *motion, struct counters *counters)
{
    struct pb_motion *m = motion;
    enum status st = STATUS_OK;

    net_contact_frame(m->net.contact);
    for (int n = 1; n <= m->substeps; n++)
        TRY(substep(m, !m->arrival.fixed || (n == m->substeps && m->frame % MEASURED == 0),
                    counters));
    m->frame++;
    counters->steps++;
    counters->substeps += m->substeps;
    arrival_count(&m->arrival, counters);
    pb_sweep_get(m->sweep, PB_X, 3, m->net.x);
    pb_sweep_get(m->sweep, PB_D, 3, m->work);
    supports_damp(&m->net.supports, m->net.keep, m->work);
    for (size_t n = 0; n < count(m); n++) {
        m->net.v[n] = m->work[n] / m->dt;
        if (!isfinite(m->net.x[n]) || !isfinite(m->net.v[n]))
            return STATUS_NAN;
    }
    if (m->net.keep != 1)
        pb_sweep_put(m->sweep, PB_D, 3, m->work);
    follow(m, false);
out:
    return st;
}

/* --- what came of it ---------------------------------------------------------------------
 */

void pb_motion_energy(const void *motion, struct energy *energy)
{
    const struct pb_motion *m = motion;

    net_energy(&m->net, m->net.v, energy);
    energy->elastic = fmax(elastic(m) - m->rest_energy, 0);
}

/* PBD's stiffness is that of its iterations: it has no forces. */
static enum status pb_motion_forces(void *motion, double (*support)[6], double (*body)[6])
{
    struct pb_motion *m = motion;
    double *start = m->work, *d = start + count(m), *slope = d + count(m), value[3];
    const double t = (double)m->substep / m->substeps * m->net.scene->step;

    if (!support || !body)
        return STATUS_OK;
    memset(slope, 0, count(m) * sizeof *slope);
    for (size_t n = 0; n < count(m); n++) {
        d[n] = m->dt * m->net.v[n];
        start[n] = m->net.x[n] - d[n];
    }
    add_springs(m, start, d, slope);
    for (size_t n = 0; n < count(m); n++)
        start[n] = m->net.x[n] + m->net.beta * m->net.v[n];
    for (int k = 0; k < m->forms.count; k++) {
        spring_form_value(&m->forms, k, start, value);
        spring_form_pull(&m->forms, k, spring_form_of(&m->forms, k)->stiffness, value,
                         slope);
    }
    net_forces(&m->net, t, m->dt, slope, support, body);
    for (int n = 0; n < 6 * m->net.scene->support_count; n++)
        if (m->projection == PROJECTION_PBD)
            support[n / 6][n % 6] = NAN;
    return STATUS_OK;
}

/* clang-format off */
static const struct schema_key options[] = {
    OPTIONS_NET, {"iterations"}, {"parameters"}, {"precision"}, {"mesh"}, {"seed"}, {"refine"},
    {"projection", "projection of constraints on positions",
     OPTION_WORDS([PROJECTION_XPBD] = "xpbd", [PROJECTION_PBD] = "pbd"),
     OPTION_OWN(pb_own, projection)},
    {NULL}};
/* clang-format on */

static enum status init(void *state, const struct scene *scene,
                        const struct discretization *d, struct message *why)
{
    enum status st;
    const char *lacks = net_mesh_lacks(scene, d, true);
    const struct net_refusal rows[] = {
        {*lacks, lacks},
        {OWN(pb_own, d)->projection == PROJECTION_PBD && damping_stiffness(scene) > 0 &&
             d->parameters == PARAMETERS_MATCHED,
         "unsupported: no damping by stiffness (rayleigh beta) with projection=pbd, which "
         "knows no stiffness"},
        {0}};

    TRY(net_refuse(scene, d, rows, why));
    TRY(pb_motion_init(state, scene, d, why));
out:
    return st;
}

/* Describes the misfit of springs to plane stress, and what one iteration leaves. */
static void describe(const void *state, struct message *line)
{
    const struct pb_motion *m = state;

    spring_net_tell(&m->springs, m->net.scene, line);
    size_t end = strlen(line->text);
    snprintf(line->text + end, sizeof line->text - end,
             "; steps of %.3g s, one iteration adds up to %.3g of their compliance to "
             "springs%s",
             m->dt, m->softening,
             m->projection == PROJECTION_PBD ? "; PBD's stiffness depends on both" : "");
    message_add(line, "; ");
    arrival_describe(&m->arrival, "iterations", line);
}

static void doubt(const void *state, struct message *line)
{
    const struct pb_motion *m = state;

    arrival_doubt(&m->arrival, line);
}

const struct model position_based_model = {
    .name = "position_based",
    .title = "position-based constraints",
    .source = "Macklin, Mueller, Chentanez 2016 (XPBD), small steps: Macklin et al. 2019; "
              "Mueller et al. 2007 (PBD)",
    .serves = NET_SERVES,
    .options = options,
    .defaults = {.points = {10, 10, 1},
                 .degree = {1, 1, 1},
                 .kinematics = KINEMATICS_NONLINEAR},
    .bytes = sizeof(struct pb_motion),
    .init = init,
    .advance = pb_motion_frame,
    .probe = net_probe,
    .size = net_size,
    .describe = describe,
    .doubt = doubt,
    .energy = pb_motion_energy,
    .contact = net_touches,
    .forces = pb_motion_forces,
    .clear = pb_motion_clear,
};
