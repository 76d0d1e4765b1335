#include "mass_spring/spring_motion.h"

#include <math.h>
#include <string.h>

#include "models/mechanics/frames.h"
#include "models/vector.h"

/* Newton's tolerance, in rest lengths of the shortest spring. */
static const double DEFAULT_TOLERANCE = 1e-6;

/* Tolerances of conjugate gradients: for a change that others follow, and for one alone. */
static const double LINEAR_TOLERANCE = 1e-2, LAST_TOLERANCE = 1e-4;

/* The way that leaves a tangent as good as new, in lengths of a cell: two fifths fewer are
 * made, for 3 % more changes. */
static const double STILL = 1e-4;

static bool in_squares(const struct spring_motion *m)
{
    return m->integrator == INTEGRATOR_LEAPFROG || m->integrator == INTEGRATOR_MOMENTUM;
}

/* --- the march ------------------------------------------------------------------------ */

static void frames(const void *motion, double (*Q)[9])
{
    const struct spring_motion *m = motion;
    const int points[3] = {m->net.mesh.rows, m->net.mesh.points[1], 1};
    const int nodes = points[0] * points[1];

    for (int first = 0; first < m->net.mesh.nodes; first += nodes)
        frames_of_net(points, false, m->net.x + 3 * (size_t)first, Q + first);
}

static enum status follow(struct march *march)
{
    struct spring_motion *m = (struct spring_motion *)march;

    system_single(&march->system);
    return m->net.mesh.rows ? iterative_follow(march->system.iterative, frames, m, false)
                            : STATUS_OK;
}

static enum status make_march(struct spring_motion *m, struct message *why)
{
    enum status st;
    struct discretization d = *m->asked;
    const double cell = fmin(m->net.mesh.cell[0], m->net.mesh.cell[1]);
    const bool implicit = m->integrator == INTEGRATOR_IMPLICIT, grid = m->net.mesh.rows,
               squares = in_squares(m),
               swept = grid && m->integrator == INTEGRATOR_LEAPFROG &&
                       !spring_leapfrog_lacks(m->net.scene);

    if (!in_squares(m)) {
        d.newton = NEWTON_FULL; /* a tangent costs no more than two of its solutions */
        if (d.solver == SOLVER_AUTO)
            d.solver = SOLVER_CG; /* on an earlier factor */
    }
    TRY(!squares ? spring_lengths_init(&m->lengths, m->net.scene, &m->springs)
        : grid   ? spring_strips_init(&m->strips, &m->stencil)
                 : tri_shell_init(&m->shell, m->net.scene, &m->net.mesh, MEMBRANE_SPRINGS,
                                  BENDING_QUADRATIC, false));
    if (march_explicit(&d))
        mesh_weigh_edges(&m->net.mesh, m->net.scene->density * m->net.scene->thickness,
                         m->net.mass);
    m->swept = (struct spring_body){.net = &m->net, .stencil = &m->stencil};
    m->march = (struct march){
        .integrator = swept ? &spring_leapfrog_integrator : NULL,
        .moved = &m->swept,
        .body = !squares ? m->lengths.body
                : grid   ? m->strips.body
                         : m->shell.body,
        .graph = squares && !grid ? &m->shell.graph : &m->springs.graph,
        .drag = m->asked->parameters == PARAMETERS_PAPER ? m->net.drag : NULL,
        .follow = squares ? NULL : follow,
        .learns = implicit,
        .tolerance = (d.tolerance > 0 ? d.tolerance
                      : implicit      ? DEFAULT_TOLERANCE
                                      : 0) *
                     cell,
        .still = squares ? 0 : STILL * cell,
    };
    TRY(net_march(&m->net, &m->march, &d, why));
    if (!squares) {
        m->march.loose = d.iterations == 1 ? LAST_TOLERANCE : LINEAR_TOLERANCE;
        TRY(follow(&m->march));
    }
out:
    return st;
}

/* --- life ---------------------------------------------------------------------------- */

/* Makes leapfrog's and momentum's net. */
static enum status make_stencil(struct spring_motion *m, const struct discretization *d)
{
    enum status st;
    struct spring_forms forms = {0};

    TRY(spring_plate_make(m->net.scene, &m->net.mesh, d->parameters, &forms));
    TRY(spring_stencil_init(&m->stencil, m->net.scene, &m->net.mesh, &m->springs, &forms));
out:
    spring_forms_clear(&forms);
    return st;
}

void spring_motion_clear(void *motion)
{
    struct spring_motion *m = motion;

    march_clear(&m->march);
    spring_strips_clear(&m->strips);
    spring_lengths_clear(&m->lengths);
    tri_shell_clear(&m->shell);
    spring_stencil_clear(&m->stencil);
    spring_net_clear(&m->springs);
    net_clear(&m->net);
    memset(m, 0, sizeof *m);
}

enum status spring_motion_init(struct spring_motion *m, const struct scene *scene,
                               const struct discretization *d, struct message *why)
{
    enum status st;

    *m = (struct spring_motion){.asked = d,
                                .integrator = d->integrator,
                                .degree = (int[]){0, 2, 3}[OWN(spring_own, d)->surface],
                                .strain_limit = OWN(spring_own, d)->strain_limit};
    TRY(net_init(&m->net, scene, d, why));
    TRY(spring_net_init(&m->springs, scene, &m->net.mesh, d->parameters, in_squares(m)));
    if (in_squares(m) && m->net.mesh.rows)
        TRY(make_stencil(m, d));
    TRY(make_march(m, why));
out:
    return st;
}

/* --- Provot's inverse procedure (Provot 1995, section 4.2) -------------------------------
 *
 * After a step, the ends of every spring that has become longer than (1 + limit) times its
 * rest length are moved together along it, each half way, or one alone if the other is
 * held.
 *
 * Provot sweeps once and does not say what becomes of the velocities. Here sweeps go on, in
 * the order of the springs and back, until all springs keep the limit to a part in 1000 of
 * it, 1000 sweeps at most; the velocity is that of the corrected points, so that a net at
 * its limit does not gather speed.
 */

enum { MOST_SWEEPS = 1000 };

/* A spring is still too long if it exceeds the limit by more than this share of it. */
static const double SLACK = 1e-3;

/* Shortens a spring; returns whether it was too long and could be moved. */
static bool shorten(const struct spring *s, const struct supports *supports, double limit,
                    double *x)
{
    double e[3];
    const int *place = supports->free_index;
    bool moved = false;

    vector_between(x + 3 * (size_t)s->a, x + 3 * (size_t)s->b, e);
    double length = vector_length(e), excess = length - (1 + limit) * s->length;
    if (!(excess > SLACK * limit * s->length))
        return false;
    for (int i = 0; i < 3; i++) {
        size_t a = 3 * (size_t)s->a + (size_t)i, b = 3 * (size_t)s->b + (size_t)i;
        double by = excess / length * e[i];
        bool a_free = place[a] >= 0, b_free = place[b] >= 0;
        if (a_free)
            x[a] += b_free ? by / 2 : by;
        if (b_free)
            x[b] -= a_free ? by / 2 : by;
        moved |= a_free || b_free;
    }
    return moved;
}

void spring_motion_limit(const struct spring_net *net, const struct supports *supports,
                         double limit, double *x)
{
    bool moved = true;

    for (int sweep = 0; moved && sweep < MOST_SWEEPS; sweep++) {
        moved = false;
        for (int n = 0; n < net->spring_count; n++) {
            int at = sweep % 2 ? net->spring_count - 1 - n : n;
            moved |= shorten(&net->springs[at], supports, limit, x);
        }
    }
}

/* --- steps ---------------------------------------------------------------------------
 */

/* Limits strains at the end of a frame, whose velocity is that of the corrected
 * points. */
static void limit_frame(struct spring_motion *m, double *before)
{
    const size_t count = 3 * (size_t)m->net.mesh.nodes;

    memcpy(before, m->net.x, count * sizeof *before);
    spring_motion_limit(&m->springs, &m->net.supports, m->strain_limit, m->net.x);
    for (size_t n = 0; n < count; n++)
        m->march.v[n] += (m->net.x[n] - before[n]) / m->march.dt;
    m->march.started = false;
}

enum status spring_motion_step(void *motion, struct counters *counters)
{
    enum status st;
    struct spring_motion *m = motion;

    TRY(march_step(motion, counters));
    if (m->strain_limit > 0)
        limit_frame(m, m->march.work);
out:
    return st;
}

void spring_motion_energy(const void *motion, struct energy *energy)
{
    const struct spring_motion *m = motion;

    net_march_energy(&m->net, &m->march, energy);
}
