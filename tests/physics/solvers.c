/* Every model that solves linear systems, by every solver and preconditioner: the motion of
 * its direct solver, the same bits on any number of threads, work that is counted; what is
 * refused; an iteration that does not converge is a death. */
#include <float.h>
#include <omp.h>

#include "models/solid/solid_model.h"
#include "tests/contract.h"
#include "tests/opened_run.h"

/* Between solvers, of the length, after FRAMES frames: solutions are to 1e-6 in the energy
 * where frames are rebuilt, Newton's steps to 1e-7, those of springs, too (1e-6 of a spring
 * of a fifth), and what a frame leaves open is the next one's velocity: FRAMES^2 / 2 times.
 */
static const double SAME = 1e-5;

/* A factor may have more than 2^31 numbers. */
_Static_assert(sizeof *((struct system *)NULL)->slot == sizeof(ptrdiff_t),
               "places in a factor do not fit");

static const struct subject {
    const char *model;
    enum kinematics kinematics;
} subjects[] = {{"iga", KINEMATICS_PRINTED},          {"iga", KINEMATICS_INCREMENTAL},
                {"iga", KINEMATICS_LINEAR},           {"iga", KINEMATICS_NONLINEAR},
                {"hex", KINEMATICS_PRINTED},          {"hex", KINEMATICS_NONLINEAR},
                {"shell", KINEMATICS_LINEAR},         {"shell", KINEMATICS_NONLINEAR},
                {"mass_spring", KINEMATICS_NONLINEAR}};

static const struct way {
    enum solver solver;
    enum preconditioner preconditioner;
} ways[] = {{SOLVER_CG, PRECONDITIONER_FACTOR},    {SOLVER_CG, PRECONDITIONER_ICHOL},
            {SOLVER_CG, PRECONDITIONER_JACOBI},    {SOLVER_GMRES, PRECONDITIONER_FACTOR},
            {SOLVER_GMRES, PRECONDITIONER_ICHOL},  {SOLVER_GMRES, PRECONDITIONER_JACOBI},
            {SOLVER_BANDED, PRECONDITIONER_FACTOR}};

static struct discretization net_of(const struct subject *s)
{
    const struct contestant *c = NULL;
    REQUIRE(contestant_find(s->model, &c, NULL) == STATUS_OK);
    struct discretization d = small_net(c->model);

    d.kinematics = s->kinematics;
    return d;
}

static struct counters move(const struct subject *s, const struct scene *scene,
                            const struct discretization *d, double *xyz)
{
    const struct contestant *c = NULL;
    struct counters work = {0};
    struct message why = {""};
    struct model_size size;
    void *state = NULL;

    REQUIRE(contestant_find(s->model, &c, NULL) == STATUS_OK);
    CHECK_SAY(model_create(c->model, scene, d, &state, &why) == STATUS_OK, "%s: %s",
              s->model, why.text);
    REQUIRE(state);
    for (int n = 0; n < FRAMES; n++)
        CHECK(c->model->advance(state, &work) == STATUS_OK);
    model_sample(c->model, state, xyz);
    c->model->size(state, &size);
    CHECK(!solver_iterates(d->solver) || !strcmp(size.solver, option_solver[d->solver]));
    model_destroy(c->model, state);
    return work;
}

static void check_way(const struct subject *s, const struct scene *scene,
                      const struct way *way, const double *direct)
{
    static double xyz[3 * GRID_POINTS], again[3 * GRID_POINTS];
    struct discretization d = net_of(s);
    double off;

    d.solver = way->solver, d.preconditioner = way->preconditioner;
    omp_set_num_threads(1);
    const struct counters work = move(s, scene, &d, xyz);
    off = opened_apart(xyz, direct) / scene->length;
    CHECK_SAY(off < SAME, "%s %s, %s, %d: %g L", s->model, option_kinematics[s->kinematics],
              option_solver[way->solver], (int)way->preconditioner, off);
    CHECK(!solver_iterates(way->solver) || s->kinematics == KINEMATICS_LINEAR ||
          work.solves > work.steps);
    if (way->preconditioner == PRECONDITIONER_FACTOR && way->solver == SOLVER_CG &&
        kinematics_rebuilds(s->kinematics))
        CHECK(work.factorisations < work.steps && work.factorisations > 0); /* kept */
    omp_set_num_threads(4);
    move(s, scene, &d, again);
    CHECK(!memcmp(xyz, again, sizeof xyz));
}

/* Newton's method with every tangent new ends where it ends with those kept. */
static void check_full(const struct subject *s, const struct scene *scene,
                       const double *direct)
{
    static double xyz[3 * GRID_POINTS];
    struct discretization d = net_of(s);

    d.newton = NEWTON_FULL;
    const struct counters full = move(s, scene, &d, xyz);
    CHECK(opened_apart(xyz, direct) / scene->length < SAME);
    d.newton = NEWTON_CHORD;
    const struct counters chord = move(s, scene, &d, xyz);
    CHECK(full.factorisations == full.assemblies && full.solves == full.iterations);
    CHECK(chord.factorisations < full.factorisations && chord.solves > chord.assemblies);
}

static void check_subject(const struct subject *s, bool obstacle)
{
    static double direct[3 * GRID_POINTS];
    const struct discretization d = net_of(s);
    struct scene scene;

    fill_scene(&scene);
    if (obstacle)
        REQUIRE(scene_add_obstacle(&scene, &(struct scene_obstacle){.kind = OBSTACLE_PLANE,
                                                                    .point = {0, 0, -0.01},
                                                                    .normal = {0, 0, 1}}) ==
                STATUS_OK);
    move(s, &scene, &d, direct);
    for (size_t w = 0; w < (obstacle ? 1 : sizeof ways / sizeof *ways); w++)
        check_way(s, &scene, &ways[w], direct);
    if (s->kinematics == KINEMATICS_NONLINEAR && strcmp(s->model, "mass_spring") &&
        !obstacle)
        check_full(s, &scene, direct);
    scene_clear(&scene);
}

/* Checks that a solid that is rebuilt keeps factors on large nets alone. */
static void check_auto(int side, bool keeps)
{
    static double direct[3 * GRID_POINTS], xyz[3 * GRID_POINTS];
    const struct subject *s = &subjects[0];
    struct discretization d = net_of(s);
    struct scene scene;

    fill_scene(&scene);
    REQUIRE(s->kinematics == KINEMATICS_PRINTED);
    d.points[0] = d.points[1] = side;
    const struct counters kept = move(s, &scene, &d, xyz);
    d.solver = SOLVER_DIRECT;
    const struct counters full = move(s, &scene, &d, direct);
    CHECK(full.factorisations == full.steps);
    CHECK(keeps ? kept.factorisations < kept.steps : kept.factorisations == kept.steps);
    CHECK(opened_apart(xyz, direct) / scene.length < (keeps ? SAME : DBL_MIN));
    scene_clear(&scene);
}

/* More than double precision has to give: it ends, as a death with words. */
static void check_death(enum solver solver, enum preconditioner preconditioner)
{
    const struct contestant *c = NULL;
    struct discretization d = net_of(&subjects[0]);
    struct counters work = {0};
    struct scene scene;
    void *state = NULL;

    fill_scene(&scene);
    d.solver = solver, d.preconditioner = preconditioner;
    REQUIRE(contestant_find("iga", &c, NULL) == STATUS_OK);
    REQUIRE(model_create(c->model, &scene, &d, &state, NULL) == STATUS_OK);
    struct march *m = state; /* march.h: a state begins with it */
    iterative_tolerate(m->system.iterative, 1e-30, 0);
    CHECK(c->model->advance(state, &work) == STATUS_UNSOLVED);
    CHECK(status_is_death(STATUS_UNSOLVED) && work.solves > 1);
    model_destroy(c->model, state);
    scene_clear(&scene);
}

int main(void)
{
    for (size_t n = 0; n < sizeof subjects / sizeof *subjects; n++)
        check_subject(&subjects[n], false);
    for (size_t n = 0; n < sizeof subjects / sizeof *subjects; n++)
        if (subjects[n].kinematics != KINEMATICS_LINEAR) /* which has no contact */
            check_subject(&subjects[n], true);
    check_auto(10, false);
    check_auto(14, true);
    check_death(SOLVER_GMRES, PRECONDITIONER_FACTOR);
    check_death(SOLVER_GMRES, PRECONDITIONER_JACOBI);
    return check_result();
}
