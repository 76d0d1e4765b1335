/* A sheet that nothing holds flies as far as it was thrown, in every model, and is not
 * taken for one that flies apart; nor is one that its support carries away. */
#include <math.h>

#include "bench/harness/motion.h"
#include "bench/harness/run.h"
#include "tests/run_fixture.h"

/* Round-off of positions of some hundred metres, and of iterations that stop at 1e-6 L. */
static const double TOL_FLIGHT = 1e-5;
static const double g = 9.81;

/* How far backward Euler falls too far: dt / t of the way. */
static double lag(const struct run *run)
{
    return strcmp(run->model->name, "mass_spring") &&
                   strcmp(run->model->name, "projective_dynamics")
               ? 0
               : run->scene.step;
}

static void fly(const struct model *model, const char *const *text, struct run *run)
{
    struct settings set =
        LIST("gravity=[0,0,-9.81]", "damping={kind: none}", "snapshots=[]", "supports=[]",
             "time={step: 0.01, end: 0.5}");
    struct run_plan plan = {DROP, named(model->name), &set, 0};
    struct message why = {""};
    struct motion m;

    contestant_points(plan.contestant, 5, 4, &set);
    settings_list(&set, 9, text);
    REQUIRE(run_open(run, &plan, &why) == STATUS_OK);
    REQUIRE(motion_init(&m, run->model, &run->scene, run->state) == STATUS_OK);
    REQUIRE(motion_run(&m, NULL, NULL, true, &why) == STATUS_OK);
    if (!CHECK(!m.death && m.frames == m.frame_count))
        printf("%s, %s: dies at %g s\n", model->name, text[0], m.death_time);
    motion_clear(&m);
    settings_clear(&set);
}

/* Thrown, without and with a spin, which leaves the middle where it would be. */
static void check_thrown(const struct model *model)
{
    static const double middle[3] = {0.5, 0.5, 0.5};
    static const char *const motion[][2] = {
        {"motion={velocity: [30, 0, 5]}", NULL},
        {"motion={velocity: [300, 0, 5]}", NULL},
        {"motion={velocity: [30, 0, 5], spin: [0, 0, 3]}", NULL}};

    for (int n = 0; n < LENGTH(motion); n++) {
        double start[3], v[3], x[3];
        struct run run;
        fly(model, motion[n], &run);
        const double t = run.scene.end;
        scene_rest_point(&run.scene, middle, start);
        scene_initial_velocity(&run.scene, start, v);
        run.model->probe(run.state, 1, middle, x);
        bool good = CHECK_NEAR(x[0], start[0] + v[0] * t, TOL_FLIGHT);
        good &= CHECK_NEAR(x[1], start[1] + v[1] * t, TOL_FLIGHT);
        good &=
            CHECK_NEAR(x[2], start[2] + v[2] * t - g / 2 * t * (t + lag(&run)), TOL_FLIGHT);
        if (!good)
            printf("%s, %s\n", model->name, motion[n][0]);
        run_close(&run);
    }
}

/* Free along x alone, which it does not fall; and carried by its edge. */
static void check_partly_held(const struct model *model)
{
    static const char *const held[][3] = {
        {"motion={velocity: [60, 0, 0]}", "supports=[{at: {u: 0}, fix: yz}]", NULL},
        {"motion={velocity: [0, 30, 0]}",
         "supports=[{at: {u: 0}, fix: xyz, path: [[0, 0, 0, 0], [0.5, 0, 15, 0]]}]", NULL}};
    static const double edge[3] = {0, 0.5, 0.5}, want[][2] = {{30, 0}, {0, 15}};

    for (int n = 0; n < LENGTH(held); n++) {
        double start[3], x[3];
        struct run run;
        fly(model, held[n], &run);
        scene_rest_point(&run.scene, edge, start);
        run.model->probe(run.state, 1, edge, x);
        CHECK_NEAR(x[0] - start[0], want[n][0], run.scene.length);
        CHECK_NEAR(x[1] - start[1], want[n][1], TOL_FLIGHT);
        run_close(&run);
    }
}

int main(void)
{
    for (int n = 0; contestant_model(n); n++) {
        check_thrown(contestant_model(n));
        check_partly_held(contestant_model(n));
    }
    return check_result();
}
