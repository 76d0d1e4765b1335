/* Truths that are closed forms, held against what they solve: falls by steps of Runge and
 * Kutta, the hanging sheet's balance of forces, the elastica's table and the shell; whom
 * they are refused; that files, times and frames of them are as of other truths. */
#include "bench/truth/truth_making.h"

#include "bench/harness/motion.h"
#include "bench/truth/truth.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "tests/opened_run.h"
#include "tests/said.h"
#include "tests/scratch.h"
#include "tests/text.h"
#include "tests/truth_fixture.h"

static const double TOL_STEPS = 1e-11;  /* of 1000 steps of fourth order              */
static const double TOL_EXACT = 1e-14;  /* of a product, near 1                       */
static const double TOL_TABLE = 1e-10;  /* of the elastica's table                    */
static const double TOL_LENGTH = 1e-4;  /* of 99 chords of an arc                     */
static const double TOL_BALANCE = 1e-6; /* of differences over 1/99 of a smooth curve */

enum { FIELD = 3 * GRID_POINTS };

/* A scene as its truth moves, with settings until NULL. */
static void read_scene(const char *name, const char *const *set, struct scene *s)
{
    struct settings settings = {0};
    struct message why = {""};
    char *path = NULL;

    settings_list(&settings, set ? 8 : 0, set);
    REQUIRE(scene_file_find(name, &path, NULL) == STATUS_OK);
    CHECK_SAY(truth_plan_scene(path, &settings, s, &why) == STATUS_OK, "%s: %s", name,
              why.text);
    settings_clear(&settings);
    free(path);
}

/* Returns its field at t, freed by the caller. */
static double *field_at(const struct scene *s, double t, double *error)
{
    double *xyz = malloc(FIELD * sizeof *xyz);
    struct truth truth = {1, &t, &xyz, error};

    REQUIRE(xyz);
    REQUIRE(truth_closed_fields(s, &truth) == STATUS_OK);
    return xyz;
}

/* --- falls -------------------------------------------------------------------------------
 */

/* Computes how far it falls along each axis, by classical Runge-Kutta steps. */
static void step_fall(const struct scene *s, double alpha, double end, double x[3])
{
    const double k = s->drag / s->density + alpha;
    const int steps = 1000;

    for (int c = 0; c < 3; c++) {
        const double a = s->gravity[c] + s->drag / s->density * s->wind[c];
        double v = s->velocity[c], h = end / steps;
        x[c] = 0;
        for (int n = 0; n < steps; n++) {
            const double a1 = a - k * v, a2 = a - k * (v + h / 2 * a1);
            const double a3 = a - k * (v + h / 2 * a2), a4 = a - k * (v + h * a3);
            x[c] += h * v + h * h / 6 * (a1 + a2 + a3);
            v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
        }
    }
}

static void falls(void)
{
    static const struct {
        const char *scene, *set[4];
        double alpha;
    } cases[] = {
        {"free_fall", {NULL}, 0},
        {"free_fall",
         {"gravity=[1, -2, 3]", "motion={velocity: [4, 5, 6], spin: [0, 0, 0]}"},
         0},
        {"drag_fall", {NULL}, 0},
        {"drag_fall", {"drag.wind=[3, 0, 1]", "damping={kind: mass, value: 2}"}, 2},
        {"drag_fall", {"drag.coefficient=1.0e-9", "damping={kind: none}"}, 0},
        {"free_fall", {"damping={kind: mass, value: 50}"}, 50},
        {"free_fall", {"damping={kind: velocity_scale, value: 0.5}"}, 0}, /* undamped */
    };

    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++)
        for (double t = 0.05; t < 1; t *= 3) {
            struct scene s;
            double error, x[3], uvw[3], rest[3];
            read_scene(cases[n].scene, cases[n].set, &s);
            double *xyz = field_at(&s, t, &error);
            step_fall(&s, cases[n].alpha, t, x);
            for (int p = 0; p < GRID_POINTS; p += 1777)
                for (int c = 0; c < 3; c++) {
                    grid_point(p, uvw);
                    scene_rest_point(&s, uvw, rest);
                    CHECK_NEAR(xyz[3 * p + c], rest[c] + x[c], TOL_STEPS);
                }
            CHECK(error > 0 && error < 1e-13);
            free(xyz);
            scene_clear(&s);
        }
}

/* --- at rest -----------------------------------------------------------------------------
 */

/* Checks, by differences of the field, that each row carries what hangs below it. */
static void hanging(void)
{
    struct scene s;
    double error, *xyz;

    read_scene("hanging", NULL, &s);
    xyz = field_at(&s, s.end, &error);
    const double weight = s.density * 9.81 * s.length / s.young;
    for (int i = 1; i < GRID_U - 1; i++) {
        const double l = (xyz[3 * (i - 1) + 2] - xyz[3 * (i + 1) + 2]) * (GRID_U - 1) / 2;
        CHECK_NEAR(l * (l * l - 1) / 2, weight * (1 - i / (GRID_U - 1.0)), TOL_BALANCE);
        CHECK(xyz[3 * i + 1] == 0 && fabs(fabs(xyz[3 * i]) - s.thickness / 2) < TOL_EXACT);
    }
    CHECK(xyz[2] == 0);
    /* Hooke's law on lengths: half of the strain at the top. The bar has the difference. */
    const double tip = xyz[3 * (GRID_U - 1) + 2], apart = fabs(tip + 1 + weight / 2);
    CHECK(apart > 0 && apart < weight * weight && error > apart / 4 && error < apart);
    free(xyz);
    scene_clear(&s);
}

/* The tip of tests/reference/heavy_elastica.csv; lengths, thickness and direction. */
static void bent(const char *name, double gamma, double drop, double reach, double turn)
{
    static const char *const upward[] = {"gravity=[0, 0, 9.81]", NULL};
    struct scene s, up;
    double error, *xyz, *other, length = 0;

    read_scene(name, NULL, &s);
    read_scene(name, upward, &up);
    CHECK_RELATIVE(scene_gamma(&s), gamma, TOL_EXACT);
    xyz = field_at(&s, s.end, &error);
    other = field_at(&up, s.end, &error);
    const double *low = xyz + 3 * (GRID_U - 1), *high = low + 3 * GRID_U * GRID_V;
    CHECK_NEAR((low[2] + high[2]) / 2, -drop, TOL_TABLE);
    CHECK_NEAR((low[0] + high[0]) / 2, reach, TOL_TABLE);
    CHECK_NEAR(atan2(high[0] - low[0], high[2] - low[2]), turn, TOL_TABLE);
    for (int i = 0; i < GRID_U; i++) {
        const double *a = xyz + 3 * i, *b = a + 3 * GRID_U * GRID_V;
        CHECK_NEAR(hypot(b[0] - a[0], b[2] - a[2]), s.thickness, TOL_EXACT);
        if (i)
            length += hypot(a[0] + b[0] - a[-3] - b[-3], a[2] + b[2] - a[-1] - b[-1]) / 2;
        /* gravity upwards: the mirror image, whose lower face was the upper one */
        const double *m = other + 3 * i + 3 * GRID_U * GRID_V;
        CHECK_NEAR(m[0], a[0], TOL_EXACT);
        CHECK_NEAR(m[2], -a[2], TOL_EXACT);
    }
    CHECK_NEAR(length, 1, TOL_LENGTH);
    free(xyz);
    free(other);
    scene_clear(&s);
    scene_clear(&up);
}

/* The shell, which shares nothing with them, within their bars; and a sheet that falls into
 * place under the scene's damping is at rest by the end. */
static void shell_agrees(const char *name, double net)
{
    static const char *const fine[] = {"discretization.points=[40,5]"};
    static const char *const coarse[] = {"discretization.points=[12,4]"};
    struct run run;
    struct counters work = {0};
    double error, *found = malloc(2 * FIELD * sizeof *found), *moved = found + FIELD;

    REQUIRE(found);
    opened_run(&run, name, "shell_selective_3", 1, fine);
    REQUIRE(run_settle(&run, &work, NULL) == STATUS_OK);
    model_sample(run.model, run.state, found);
    double *xyz = field_at(&run.scene, run.scene.end, &error);
    CHECK_SAY(metric_rmse(found, xyz) <= error + net, "%s: %g m apart, bar %g m", name,
              metric_rmse(found, xyz), error);
    run_close(&run);
    opened_run(&run, name, "shell_selective_3", 1, coarse);
    for (double t = 0; t < run.scene.end - run.scene.step / 2; t += run.scene.step)
        REQUIRE(run.model->advance(run.state, &work) == STATUS_OK);
    model_sample(run.model, run.state, moved);
    REQUIRE(run_settle(&run, &work, NULL) == STATUS_OK);
    model_sample(run.model, run.state, found);
    CHECK_SAY(metric_rmse(found, moved) <= error / 2, "%s: %g m from rest, bar %g m", name,
              metric_rmse(found, moved), error);
    run_close(&run);
    free(found);
    free(xyz);
}

static void refused(void)
{
    static const struct {
        const char *scene, *set[3];
    } cases[] = {
        /* clang-format off */
        {"edge_drop", {NULL}}, {"hinge", {NULL}}, {"sphere", {NULL}}, {"cloak", {NULL}},
        {"free_fall", {"motion={velocity: [0, 0, 0], spin: [0, 0, 1]}"}},
        {"free_fall", {"loads=[{at: {u: 0}, force: [1, 0, 0]}]"}},
        {"free_fall", {"damping={kind: velocity_rate, value: 1}"}},
        {"free_fall", {"obstacles=[{sphere: {center: [0, 0, -9], radius: 1}}]"}},
        {"hanging", {"material.poisson=0.1"}}, {"hanging", {"gravity=[0, 0, 9.81]"}},
        {"hanging", {"gravity=[0, 1, -9.81]"}}, {"hanging", {"gravity=[0, 0, 0]"}},
        {"hanging", {"damping={kind: none}"}}, {"hanging", {"damping.value=0.1"}},
        /* not at rest by the end */
        {"hanging", {"drag={coefficient: 1}"}},
        {"hanging", {"air={density: 1, drag: [1, 0]}"}},
        {"drag_fall", {"air={density: 1, drag: [1, 0]}"}},
        {"hanging", {"supports=[{at: {u: 0}, fix: xz}]"}},
        {"hanging", {"supports=[{at: {u: 0}, fix: xyz}, {at: {u: 1}, fix: xyz}]"}},
        {"rest_small", {"material.poisson=0.3"}}, {"rest_small", {"damping.value=1"}},
        {"rest_small", {"damping.value=2000"}}, /* creeps */
        {"rest_small", {"gravity=[0, 0, -0.0001]"}}, /* no elastica so stiff is known */
        {"rest_small", {"sheet.thickness=1", "material.young=1.0e3"}}, /* no strip */
        {"rest_large", {"loads=[{at: {u: 1}, force: [0, 0, 1]}]"}},
        {"rest_large", {"time.end=1"}},
        /* clang-format on */
    };

    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        struct truth made;
        struct scene s;
        read_scene(cases[n].scene, cases[n].set, &s);
        CHECK_SAY(truth_closed_make(&s, &made) == STATUS_UNSUPPORTED && !made.xyz, "%s, %s",
                  cases[n].scene, cases[n].set[0] ? cases[n].set[0] : "");
        scene_clear(&s);
    }
}

/* --- as other truths ---------------------------------------------------------------------
 */

static void found_by_those_who_ask(void)
{
    static const double early[] = {0.1}, any[] = {0.123, 0.2};
    struct settings none = {0};
    struct truth *t = NULL;
    struct message why = {""};
    double time[8];
    char *path = NULL;
    int count;

    REQUIRE(scene_file_find("free_fall", &path, NULL) == STATUS_OK);
    CHECK(truth_stored_times(path, &none, 0.45, 3, time, &count, &why) == STATUS_OK);
    CHECK(count == 3 && time[0] == 0.2 && time[2] == 0.4);
    REQUIRE(truth_find(path, &none, 2, any, NULL, &t, &why) == STATUS_OK);
    CHECK_NEAR(t->xyz[0][2] + 0.001177 / 2, -9.81 * 0.123 * 0.123 / 2, TOL_EXACT);
    CHECK(t->error[0] < 1e-13 && *t->source);
    truth_destroy(t), t = NULL;
    free(path);
    REQUIRE(scene_file_find("rest_small", &path, NULL) == STATUS_OK);
    CHECK(truth_stored_times(path, &none, 10, 8, time, &count, &why) == STATUS_OK);
    CHECK(count == 1 && time[0] == 1.5);
    REQUIRE(truth_find(path, &none, 1, time, NULL, &t, &why) == STATUS_OK);
    truth_destroy(t), t = NULL;
    /* not so early: then by runs, of which there are none */
    CHECK(truth_find(path, &none, 1, early, NULL, &t, &why) == STATUS_FILE);
    free(path);
}

/* 100 x 100 are the grid; others lie on it; each has its time and bar. */
static void printed_frames(void)
{
    static const int grid[] = {GRID_U, GRID_V}, three[] = {3, 2};
    struct truth made;
    struct scene s;
    struct said said;
    double worst = 0;
    int lines = 0;

    read_scene("rest_large", NULL, &s);
    REQUIRE(truth_closed_make(&s, &made) == STATUS_OK);
    said_open(&said);
    CHECK(truth_print_frames(&made, &s, grid, said.file) == STATUS_OK);
    said_close(&said, true);
    CHECK(text_count(said.text, "# bar: 5,") == 1);
    const char *at = strstr(said.text, "t,u,v,x,y,z\n");
    REQUIRE(at);
    for (double v[6];
         (at = strchr(at, '\n')) &&
         sscanf(++at, "%lf,%lf,%lf,%lf,%lf,%lf", v, v + 1, v + 2, v + 3, v + 4, v + 5) == 6;
         lines++) {
        const double *low = made.xyz[0] + 3 * lines, *high = low + 3 * GRID_U * GRID_V;
        for (int c = 0; c < 3; c++)
            worst = fmax(worst, fabs(v[3 + c] - (low[c] + high[c]) / 2));
        worst =
            fmax(worst, fabs(v[1] - lines % 100 / 99.0) + fabs(v[2] - lines / 100 / 99.0));
    }
    CHECK(lines == GRID_U * GRID_V);
    CHECK_NEAR(worst, 0.0, TOL_EXACT);
    said_clear(&said);
    said_open(&said);
    CHECK(truth_print_frames(&made, &s, three, said.file) == STATUS_OK);
    said_close(&said, true);
    CHECK(text_count(said.text, "\n5,0.5,") == 2 && text_count(said.text, "\n5,") == 6);
    said_clear(&said);
    truth_clear(&made);
    scene_clear(&s);
}

int main(void)
{
    const double of_the_net = 1e-5; /* [m] of 40 points                                */

    scratch_open();
    falls();
    hanging();
    bent("rest_small", 1, 0.123471401983, 0.991246395347, 0.165115560502);
    bent("rest_large", 100, 0.937523935396, 0.159223382628, 1.56410732058);
    shell_agrees("hanging", of_the_net);
    shell_agrees("rest_small", of_the_net);
    shell_agrees("rest_large", of_the_net);
    refused();
    found_by_those_who_ask();
    printed_frames();
    return check_result();
}
