/* A free sheet falls and drifts without deforming, in every scheme of every model: its
 * motion is that of one point by the scheme's own law, with drag in wind, a dead load and
 * mass damping; and it flies as it was thrown. */
#include <float.h>

#include "tests/opened_run.h"

/* Positions of up to 4 m, a few eps a step. Solves for all of d are good to eps times the
 * condition of M + dt^2/4 K, 2e7; iterations stop at 1e-7 of the length, by what their last
 * steps let expect. In single precision positions below 2 m are rounded by 1.2e-7 m a step,
 * alike in many of the 4000 where the speed hardly changes; velocities that are differences
 * of them lead a sheet 1.3e-2 m astray. */
static const double SUMS = 2e-11, SOLVED = 4e-9, ITERATED = 1e-9, SINGLE = 2e-4;

enum scheme { EULER, AVERAGE, LEAPFROG, BDF2, INCREMENTAL, PRINTED };
enum { FRAMES = 40, EXTRA = 4 };

static const struct row {
    const char *name, *settings[EXTRA];
    enum scheme law;
    double tolerance; /* of the way                                                    */
} rows[] = {
    {"iga_linear", {0}, AVERAGE, SOLVED},
    {"hex_linear", {0}, AVERAGE, SOLVED},
    {"iga_incremental", {0}, INCREMENTAL, SUMS},
    {"hex_incremental", {0}, INCREMENTAL, SUMS},
    {"iga_paper", {0}, PRINTED, SUMS},
    {"hex_paper", {0}, PRINTED, SUMS},
    {"iga_nonlinear", {0}, AVERAGE, SOLVED},
    {"hex_nonlinear", {0}, AVERAGE, SOLVED},
    {"shell_linear", {0}, AVERAGE, SOLVED},
    {"shell_3", {0}, AVERAGE, ITERATED},
    {"iga_explicit_3", {0}, LEAPFROG, ITERATED},
    {"hex_explicit", {0}, LEAPFROG, ITERATED},
    {"shell_explicit_2", {0}, LEAPFROG, ITERATED},
    {"triangles", {0}, AVERAGE, ITERATED},
    {"triangles", {"discretization.integrator=leapfrog"}, LEAPFROG, ITERATED},
    {"triangles_baraff_witkin", {0}, EULER, ITERATED},
    {"mass_spring", {0}, EULER, ITERATED},
    {"mass_spring_explicit", {0}, LEAPFROG, ITERATED},
    {"mass_spring_leapfrog", {0}, LEAPFROG, ITERATED},
    {"mass_spring_momentum", {0}, AVERAGE, ITERATED},
    {"position_based", {"discretization.substeps=10"}, EULER, SUMS},
    {"position_based_pbd", {"discretization.substeps=10"}, EULER, SUMS},
    {"position_based_single", {"discretization.substeps=100"}, EULER, SINGLE},
    {"vbd", {"discretization.substeps=1", "discretization.iterations=300"}, EULER, SUMS},
    {"projective_dynamics", {0}, EULER, SUMS},
    {"projective_dynamics",
     {"discretization.substeps=2", "discretization.constraint=edges"},
     EULER,
     SUMS},
    {"projective_dynamics_bdf2", {"discretization.substeps=2"}, BDF2, SUMS},
};

/* One component of a point; d: what `printed` takes for its displacement. */
struct point {
    double x, v, a, d;
    bool moving;
};

/* Takes one step under f per mass, slowed by `rate` times the velocity; `printed` by mu,
 * too. */
static void step(enum scheme law, double dt, double f, double rate, double mu,
                 struct point *p)
{
    const double s = rate * dt / 2, v = p->v, quarter = dt * dt / 4;
    double next;

    switch (law) {
    case EULER:
        p->v = (v + dt * f) / (1 + rate * dt);
        p->x += dt * p->v;
        break;
    case AVERAGE:
    case BDF2: /* the same where nothing slows it */
        p->v = ((1 - s) * v + dt * f) / (1 + s);
        p->x += dt * (v + p->v) / 2;
        break;
    case LEAPFROG: /* v is that of half a step ago */
        p->v = p->moving ? ((1 - s) * v + dt * f) / (1 + s) : (1 - s) * v + dt / 2 * f;
        p->x += dt * p->v;
        break;
    case INCREMENTAL: /* it starts without acceleration */
        next = (f - rate * (v + dt / 2 * p->a)) / (1 + s);
        p->x += dt * v + quarter * (p->a + next);
        p->v += dt / 2 * (p->a + next);
        p->a = next;
        break;
    case PRINTED: /* d / dt is the velocity that drag knows */
        p->d += dt * v + quarter * p->a;
        next = (f - rate / dt * p->d) / (1 + rate / dt * quarter);
        p->d += quarter * next;
        p->v = mu * (v + dt / 2 * (p->a + next));
        p->a = next;
        p->x += p->d;
    }
    p->moving = true;
}

static const struct air {
    /* `printed` has a damping of its own; constraints without stiffness know none of it */
    const char *drag, *damping, *without_beta, *motion;
    double alpha, push; /* the latter by a dead load [m/s^2], where loads are served    */
} airs[] = {
    {"drag.coefficient=0", "damping={kind: none}", "damping={kind: none}",
     "motion={velocity: [1,-2,3]}", 0, 0},
    {"drag={coefficient: 2.5, wind: [1.5,-0.7,0.4]}", "damping={kind: none}",
     "damping={kind: none}", NULL, 0, 2},
    {"drag={coefficient: 1, wind: [1.5,-0.7,0.4]}",
     "damping={kind: rayleigh, alpha: 3, beta: 1e-4}", "damping={kind: mass, value: 3}",
     "motion={velocity: [1,-2,3]}", 3, 0},
};
enum { AIRS = sizeof airs / sizeof *airs };

static void check_fall(const struct row *row, const struct air *air)
{
    const double mu = 0.5;
    const struct contestant *c = NULL;
    struct point p[3] = {{0}};
    struct run run;

    REQUIRE(contestant_find(row->name, &c, NULL) == STATUS_OK);
    const double push =
        c->model->serves & SCENE_NEED_LOADS ? air->push : 0; /* of 0.025 kg */
    OPENED_RUN(&run, "drag_fall", row->name, "gravity=[0.5,0,-9.81]",
               "sheet.thickness=0.05", "material.young=1000",
               c->layers ? "discretization.points=[6,5,2]" : "discretization.points=[6,5]",
               air->drag,
               row->law == PRINTED ? "damping={kind: velocity_scale, value: 0.5}"
               : strstr(row->name, "_pbd") || strstr(row->name, "projective") ||
                       strstr(row->name, "vbd")
                   ? air->without_beta
                   : air->damping,
               row->settings[0] ? row->settings[0] : air->drag,
               row->settings[1] ? row->settings[1] : air->drag,
               push > 0 ? "loads=[{at: {u: [0,1]}, force: [0,0,0.05]}]" : air->motion);
    const struct scene *s = &run.scene;
    const struct counters work = opened_steps(&run, FRAMES);
    const int steps = work.substeps > FRAMES ? (int)work.substeps : FRAMES;
    for (int i = 0; i < 3; i++) {
        p[i].v = row->law == PRINTED ? 0 : s->velocity[i];
        p[i].d = s->velocity[i] * s->step;
        for (int n = 0; n < steps; n++)
            step(row->law, FRAMES * s->step / steps,
                 s->gravity[i] + (i == 2 ? push : 0) + s->drag / s->density * s->wind[i],
                 s->drag / s->density + (row->law == PRINTED ? 0 : air->alpha), mu, &p[i]);
    }
    const double way[3] = {p[0].x, p[1].x, p[2].x};
    SAY_UNLESS(CHECK_NEAR(opened_off(&run, way) / fabs(way[2]), 0, row->tolerance),
               "%s, %s, %s: way %g m in %d steps", row->name,
               row->settings[0] ? row->settings[0] : "", air->drag, p[2].x, steps);
    run_close(&run);
}

int main(void)
{
    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++)
        for (int k = 0; k < AIRS; k++)
            if (rows[n].law != BDF2 || k == 0)
                check_fall(&rows[n], &airs[k]);
    return check_result();
}
