#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */
#include "bench/stress/stress.h"

#include <math.h>
#include <omp.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

#include "bench/files/csv.h"
#include "bench/files/folder.h"
#include "bench/harness/child.h"
#include "bench/harness/derived_key.h"
#include "bench/harness/motion.h"
#include "bench/harness/pool.h"
#include "bench/harness/run.h"
#include "bench/ui/show.h"
#include "fem_ref/elastica.h"
#include "fem_ref/kirchhoff.h"
#include "models/clock.h"
#include "models/contact/contact_law.h"
#include "models/contact/contact_mesh.h"
#include "models/contact/contact_rest.h"
#include "models/contact/contact_shape.h"
#include "models/grid.h"
#include "models/metric/crossing.h"
#include "models/metric/metric.h"
#include "models/reader/scene_file.h"

/* --- cases, as data --- */

const char *const stress_case_scene = "cantilever";

#define CASE(name, text, ...)                                                              \
    static const struct stress_case name = {.item = {#name, text}, __VA_ARGS__}

/* Truths with their bounds, and the reasons for these. */
#define REST .truth = STRESS_PLATE, .bound = 0.02, .why = "asked of cures for locking"
#define HEAVY                                                                              \
    .truth = STRESS_ELASTICA, .bound = 0.01, .why = "what the nonlinear solid is asked for"
#define VIBRATION                                                                          \
    .truth = STRESS_VIBRATION, .bound = 0.02,                                              \
    .why = "a fiftieth of the swing cannot be seen"
#define ENERGY                                                                             \
    .truth = STRESS_ENERGY, .bound = 0.01, .why = "a hundredth of a swing cannot be seen"
#define SIMILAR                                                                            \
    .truth = STRESS_SIMILAR, .bound = 1e-8, .why = "round-off, carried through 60 frames"

/* A light plate: linear theory is right to 0.0125 Gamma^2 = 3e-5 where nu = 0. With another
 * nu a plate that bends by more than its thickness no longer bends across as well (its
 * middle surface would stretch), and the tip is 3 % less: those cases are lighter still.
 * Models without static equilibrium come to rest by the damping, twice the lowest
 * frequency, in 0.5 s. */
#define LIGHT    0.05
#define SETTLING "damping={kind: mass, value: 100}", "time={step: 0.005, end: 0.5}"

#define THICK(h)                                                                           \
    .gamma = LIGHT, .physics = {"sheet.thickness=" h, "material.poisson=0", SETTLING}
CASE(thin_2, "h/L = 1e-2", REST, THICK("1e-2"));
CASE(thin_3, "h/L = 1e-3", REST, THICK("1e-3"));
CASE(thin_4, "h/L = 1e-4", REST, THICK("1e-4"));
CASE(thin_5, "h/L = 1e-5", REST, THICK("1e-5"), .quick = true);

#define POISSON(nu)                                                                        \
    .gamma = LIGHT / 10,                                                                   \
    .physics = {"sheet.thickness=1e-2", "material.poisson=" nu, SETTLING}
CASE(poisson_0, "nu = 0", REST, POISSON("0"));
CASE(poisson_049, "nu = 0.49", REST, POISSON("0.49"));
CASE(poisson_04999, "nu = 0.4999", REST, POISSON("0.4999"));

CASE(narrow, "length 1000 widths", REST, .gamma = LIGHT, .quick = true,
     .physics = {"sheet.width=1e-3", "sheet.thickness=1e-4", "material.poisson=0",
                 SETTLING});
CASE(wide, "width 1000 lengths", REST, .gamma = LIGHT,
     .physics = {"sheet.width=1e3", "sheet.thickness=1e-2", "material.poisson=0",
                 SETTLING});

/* Nets. nu = 0: the truth is a cubic beam, nothing depends on v. */
#define KNOTS(list) .numerics = {"discretization.knots_u=" list}
CASE(one_element, "one element", REST, THICK("1e-2"), .side = 1, .quick = true);
CASE(graded_knots, "knots from 1e-6 to 0.5", REST, THICK("1e-2"),
     KNOTS("[0,0,0,1e-6,1e-5,1e-4,1e-3,0.01,0.1,0.5,1,1,1]"));
CASE(repeated_knots, "repeated knots", REST, THICK("1e-2"),
     KNOTS("[0,0,0,0.2,0.2,0.4,0.4,0.6,0.8,0.8,1,1,1]"));
CASE(torn_knots, "a knot p + 1 times", REST, THICK("1e-2"),
     KNOTS("[0,0,0,0.2,0.2,0.2,0.4,0.6,0.8,0.8,1,1,1]"));
CASE(folded_knots, "knots that fold back", REST, THICK("1e-2"), .quick = true,
     KNOTS("[0,0,0,0.2,0.1,0.4,0.3,0.6,0.8,0.8,1,1,1]"));
CASE(skewed_weights, "weights 1 and 10", REST, THICK("1e-2"), .weight_ratio = 10);

/* Weight against bending, from a card to fabrics of 1 m. */
#define SLOW                                                                               \
    .physics = {"sheet.thickness=1e-3", "material.poisson=0",                              \
                "damping={kind: mass, value: 10}", "time={step: 0.01, end: 6}"}
CASE(gamma_8, "Gamma = 8", HEAVY, .gamma = 8, SLOW);
CASE(gamma_1000, "Gamma = 1000", HEAVY, .gamma = 1000, SLOW, .quick = true);
CASE(gamma_100000, "Gamma = 100000", HEAVY, .gamma = 1e5, SLOW);

/* The same vibration, period 0.13 s and 1.3 s. */
CASE(step_small, "steps of 0.1 ms, 1/1300 period", VIBRATION, .gamma = LIGHT,
     .physics = {"sheet.thickness=1e-2", "material.poisson=0",
                 "time={step: 1e-4, end: 0.1}"});
CASE(step_large, "steps of 0.1 s, 1/13 period", VIBRATION, .gamma = LIGHT, .quick = true,
     .physics = {"sheet.thickness=1e-2", "material.poisson=0", "gravity=[0,0,-0.0981]",
                 "time={step: 0.1, end: 1}"});

/* The same motion at the same Gamma. Pulled sideways and along, too, so that nothing
 * vanishes by symmetry. */
#define PULLED                                                                             \
    .gamma = 3,                                                                            \
    .physics = {"gravity=[1,2,-9.81]", "sheet.thickness=0.01",                             \
                "damping={kind: mass, value: 0.5}", "time={step: 0.0025, end: 0.15}"}
CASE(millimetres, "mm, kg, s", SIMILAR, PULLED, .length = 1e-3, .mass = 1, .time = 1,
     .quick = true);
CASE(inches, "inch, slinch, s", SIMILAR, PULLED, .length = 0.0254, .mass = 175.126836,
     .time = 1);
CASE(soft, "E/rho a 1000th, Gamma the same", SIMILAR, PULLED, .length = 1, .mass = 1,
     .time = 0.0316227766016838);
CASE(stiff, "E/rho 1000 times, Gamma the same", SIMILAR, PULLED, .length = 1, .mass = 1,
     .time = 31.6227766016838);

/* The sheet of the pendulum table C0, 50 s. */
CASE(swing_10000, "10,000 steps of undamped swing", ENERGY, .side = 6,
     .physics = {"sheet.thickness=5e-3", "material={young: 1e5, poisson: 0, density: 0.3}",
                 "time={step: 0.005, end: 50}"});
CASE(violent_drop, "dropped at 1000 g", ENERGY, .gamma = 1e5,
     .physics = {"sheet.thickness=5e-3", "gravity=[0,0,-9810]",
                 "time={step: 1e-3, end: 0.1}"});

/* Kuhl and Crisfield (1999) spin a stiff bar, on which average acceleration gains energy
 * without end: 100 rad in steps of 0.1 rad. */
CASE(spinning_bar, "stiff bar, 16 turns in the air", ENERGY, .quick = true,
     .physics = {"sheet={length: 1, width: 0.1, thickness: 0.01}",
                 "pose.origin=[-0.5,-0.05,0]",
                 "material={young: 1e9, poisson: 0, density: 1000}", "gravity=[0,0,0]",
                 "supports=[]", "motion={spin: [0,10,0]}", "time={step: 0.01, end: 10}"});

CASE(buckling, "ends 10 % nearer", .truth = STRESS_BUCKLED, .gamma = 0.2,
     .physics = {"sheet.thickness=5e-3", "material.poisson=0",
                 "supports=[{at: {u: 0}, fix: xyz}, {at: {u: 1}, fix: xyz, "
                 "path: [[0,0,0,0],[1,-0.1,0,0]]}]",
                 "damping={kind: mass, value: 20}", "time={step: 0.005, end: 2}"},
     .bound = 0.01, .why = "what the nonlinear solid is asked for");

CASE(still, "nothing acts", .truth = STRESS_STILL, .quick = true,
     .physics = {"gravity=[0,0,0]", "time={step: 0.005, end: 0.5}"}, .bound = 1e-10,
     .why = "what iterations take for nothing (models/mechanics/arrival.h)");
CASE(rest_start, "starts in equilibrium", .truth = STRESS_STILL_REST, .gamma = 30,
     .physics = {"sheet.thickness=0.01", "time={step: 0.005, end: 0.5}"}, .bound = 1e-5,
     .why = "a hundred times what the search for equilibrium leaves");
CASE(thrown, "edge jerked by L/2 in one step", .truth = STRESS_SHIFTED, .quick = true,
     .physics = {"gravity=[0,0,0]", "sheet.thickness=0.02",
                 "material={young: 1e7, poisson: 0.3, density: 100}",
                 "supports=[{at: {u: 0}, fix: xyz, path: [[0,0,0,0],[0.005,0,0,0.5]]}]",
                 "damping={kind: mass, value: 8}", "time={step: 0.005, end: 3}"},
     .bound = 1e-3, .why = "of its throw, 6e-6 is left by then");

CASE(two_corners, "hung from two corners", .truth = STRESS_SHELL, /* Gamma = 50 */
     .physics = {"sheet.thickness=5e-3", "material.young=4285",
                 "supports=[{at: {u: 0, v: 0}, fix: xyz}, {at: {u: 0, v: 1}, fix: xyz}]",
                 "time={step: 0.005, end: 0.3}"},
     .bound = 0.02, .why = "a fiftieth of the length");

/* Contact. The law is that of the sheet's thickness: it starts at half of it before a body,
 * and its wall is at a quarter, which is an error of 0.25. */
#define TOUCH                                                                              \
    .truth = STRESS_CONTACT, .bound = 0.5,                                                 \
    .why = "the middle surface is where a body begins"
#define SLIDE          .truth = STRESS_SLIDE, .bound = 0.01, .why = "a hundredth of the length"
#define UNDAMPED       "sheet.thickness=0.02", "material={young: 2e6, poisson: 0.3, density: 150}"
#define FELT           UNDAMPED, "damping={kind: mass, value: 2}"
#define FREE           FELT, "supports=[]"
#define FLOOR(z, more) "{plane: {point: [0,0," z "], normal: [0,0,1]" more
#define LID(z, more)   "{plane: {point: [0,0," z "], normal: [0,0,-1]" more
#define SHORT          "time={step: 0.005, end: 0.1}"

CASE(touching, "begins where contact starts", TOUCH, .quick = true,
     .physics = {FREE, "obstacles=[" FLOOR("-0.01", "}}]"), SHORT});
CASE(overlapping, "begins a quarter of h in a plane", TOUCH, .quick = true,
     .physics = {FREE, "obstacles=[" FLOOR("-0.005", "}}]"), SHORT});
CASE(coplanar, "begins on a plane and a box with its edges", TOUCH,
     .physics = {
         FREE,
         "obstacles=[" FLOOR("-0.01",
                             "}}, ") "{box: {center: [0.5,0.5,-0.11], size: [1,1,0.2]}}]",
         SHORT});

/* Two planes that come together at 0.5 m/s, by `way` each. */
#define CLOSED(way)                                                                        \
    .physics = {FREE,                                                                      \
                "obstacles=[" FLOOR("-0.05", "}, path: [[0,0,0,0],[0.1,0,0," way "]]}, ")  \
                    LID("0.05", "}, path: [[0,0,0,0],[0.1,0,0,-" way "]]}]"),              \
                "time={step: 0.005, end: 0.12}"}
CASE(closing, "two planes leave 0.6 h", TOUCH, CLOSED("0.044"));
CASE(crushed, "two planes leave 0.4 h, less than the law has room for", TOUCH,
     CLOSED("0.046"));
CASE(stopping, "lifted at 5 m/s by a plane that stops at once", TOUCH, .quick = true,
     .physics = {FREE, "obstacles=[" FLOOR("-0.01", "}, path: [[0,0,0,0],[0.1,0,0,0.5]]}]"),
                 "time={step: 0.005, end: 0.2}"});
CASE(struck, "struck by a plate of h that moves by 5 h a step", TOUCH,
     .physics = {FREE,
                 "obstacles=[{box: {center: [0.5,0.5,-0.021], size: [1.4,1.4,0.02]}, "
                 "path: [[0,0,0,0],[0.1,0,0,2]]}]",
                 SHORT});
CASE(thrown_at_ball, "thrown at a ball at 20 m/s", TOUCH,
     .physics = {"sheet.thickness=0.03",
                 "material={young: 1e7, poisson: 0.3, density: 150}", "supports=[]",
                 "obstacles=[{sphere: {center: [0.5,0.5,-0.35], radius: 0.3}}]",
                 "motion={velocity: [0,0,-20]}", "time={step: 0.001, end: 0.05}"});

#define EDGE(u, path) "{at: {u: " u ", w: 0.5}, fix: xyz, path: [" path "]}"
CASE(pressed_fold, "folded by an edge, then pressed to 1.9 h in 0.2 s", TOUCH,
     .physics = {
         FELT, "pose.origin=[0,0,0.01]", "contact={}",
         "supports=[" EDGE("0", "[0,0,0,0],[0.075,0.0304,0,0.148],[0.15,0.1172,0,0.2739],"
                                "[0.225,0.2469,0,0.3589],[0.3,0.4,0,0.3905],"
                                "[0.375,0.5531,0,0.3642],[0.45,0.6828,0,0.2844],"
                                "[0.525,0.7696,0,0.1638],[0.6,0.8,0,0.021]") "]",
         "obstacles=[" FLOOR("0", "}}, ")
             LID("0.5", "}, path: [[0.6,0,0,0],[0.8,0,0,-0.462]]}]"),
         "time={step: 0.005, end: 0.9}"});
CASE(thick_contact, "contact three spacings thick, ends brought to less", TOUCH,
     .physics = {
         FELT, "contact={thickness: 0.333}",
         "supports=[" EDGE("0", "[0,0,0,0]") ", " EDGE("1",
                                                       "[0,0,0,0],[0.4,-0.75,0,0]") "]",
         "time={step: 0.005, end: 0.5}"});

#define INCLINE(mu)                                                                        \
    .physics = {UNDAMPED, "supports=[]", "gravity=[2,0,-9.6]",                             \
                "obstacles=[" FLOOR("-0.01", ", friction: " mu "}}]"),                     \
                "time={step: 0.005, end: 0.4}"}
CASE(friction_0, "incline of 12 degrees, friction 0", SLIDE, INCLINE("0"));
CASE(friction_5, "incline of 12 degrees, friction 5", SLIDE, INCLINE("5"));

#define ONTO_NEEDLES .physics = {FREE, "time={step: 0.005, end: 0.2}"}
CASE(needles, "a body of triangles up to 160,000 times as long as wide", TOUCH,
     ONTO_NEEDLES, .needles = 200);
CASE(flat_triangle, "one of them with its corners on a line", TOUCH, ONTO_NEEDLES,
     .needles = -200);

const struct command_item *const stress_case_items[] = {
    /* clang-format off */
    &thin_2.item, &thin_3.item, &thin_4.item, &thin_5.item, &poisson_0.item,
    &poisson_049.item, &poisson_04999.item, &narrow.item, &wide.item, &one_element.item,
    &graded_knots.item, &repeated_knots.item, &torn_knots.item, &folded_knots.item,
    &skewed_weights.item, &gamma_8.item, &gamma_1000.item, &gamma_100000.item,
    &step_small.item, &step_large.item, &millimetres.item, &inches.item, &soft.item,
    &stiff.item, &swing_10000.item, &violent_drop.item, &spinning_bar.item,
    &buckling.item, &still.item, &rest_start.item, &thrown.item, &two_corners.item,
    &touching.item, &overlapping.item, &coplanar.item, &closing.item, &crushed.item,
    &stopping.item, &struck.item, &thrown_at_ball.item, &pressed_fold.item, &thick_contact.item,
    &friction_0.item, &friction_5.item, &needles.item, &flat_triangle.item,
    NULL,
    /* clang-format on */
};

const struct stress_case *stress_case_at(int n)
{
    return (const struct stress_case *)stress_case_items[n];
}

const char *const stress_truth_text[STRESS_TRUTHS] = {STRESS_TRUTH_LIST(LIST_WORD)};

/* --- results --- */

enum { PATH = 4096 };

const char *const stress_end_name[STRESS_ENDS] = {"accurate", "degraded", "refused",
                                                  "died"};

enum stress_end stress_result_end(double error, double bound)
{
    return !isfinite(error) ? STRESS_DIED
           : error <= bound ? STRESS_ACCURATE
                            : STRESS_DEGRADED;
}

/* Measures the errors of hard cases. */

/* The worst of what a run has touched. */
struct touched {
    double gap, gap_time; /* least distance of the middle from a body [m], [s]   */
    double through_time;  /* when it first passes through itself; NaN: never [s] */
    struct crossing with; /* itself, where that is deepest                       */
    double deepest_time;  /* of that                                         [s] */
};

/* A run of a hard case, on its way to an error. */
struct judged {
    const struct stress_job *job; /*                                          borrowed */
    struct run run;
    double time; /* of the frame that was reached [s]                                  */
    int frames;  /* up to it                                                           */
    struct stress_result *result; /* to be filled                             borrowed */
    struct message *why;          /* for the sentence of a failure            borrowed */
    double *xyz, *first;          /* fields (grid.h), room for judges        xyz owned */
    struct kirchhoff *plate;      /* of the judges that need it                  owned */
    double load;                  /* on that plate [N/m^2]                             */
    struct energy *energies;      /* [frames of the scene + 1]                   owned */
    struct truth *truth;          /* of STRESS_SHELL                             owned */
    struct touched touched;       /* of the judges of contact                          */
    struct intersection work;     /* of the same                                 owned */
};

/* The judge of a truth: it measures the error at rest, at the end of the motion, or at all
 * frames, of which the largest counts. NULL: nothing to do. */
struct truth_judge {
    enum { AT_REST, AT_END, AT_FRAMES } when;
    enum status (*begin)(struct judged *r);
    double (*error)(struct judged *r);
    enum status (*end)(struct judged *r);
};
static const struct truth_judge judges[STRESS_TRUTHS];

/* --- runs -------------------------------------------------------------------------------
 */

/* Adds the settings of the case, on top of the contestant's. */
static void add_settings(const struct stress_job *job, struct settings *s)
{
    const struct stress_case *c = job->c;
    const int least = contestant_least(job->contestant);
    const int side = c->side == 0 ? 10 : c->side == 1 ? least : c->side;

    settings_list(s, STRESS_SETTINGS, c->physics);
    contestant_points(job->contestant, side, side, s);
    settings_list(s, STRESS_SETTINGS, c->numerics);
}

/* Gives every other row of control points the weight `ratio`. */
static enum status give_weights(struct discretization *d, double ratio)
{
    const int row = d->points[1] * (d->points[2] > 0 ? d->points[2] : 1);
    const int count = d->points[0] * row;

    d->weights = malloc((size_t)count * sizeof *d->weights);
    if (!d->weights)
        return STATUS_MEMORY;
    for (int n = 0; n < count; n++)
        d->weights[n] = n / row % 2 ? ratio : 1;
    d->weight_count = count;
    return STATUS_OK;
}

/* Puts a flat double cone under the sheet, whose triangles get ever narrower round its
 * axis; `count` as `needles` of struct stress_case. STATUS_INPUT with a sentence: no such
 * mesh. */
static enum status give_needles(struct scene *s, int count, struct message *why)
{
    enum { ROUND_MOST = 100 };
    const double radius = 0.4, height = 0.025, below = 0.011, turn = 8 * atan(1);
    const int round = count < 0 ? -count / 2 : count / 2;
    double vertex[ROUND_MOST + 3][3];
    int triangle[2 * ROUND_MOST + 1][3];
    struct scene_obstacle body = {.kind = OBSTACLE_MESH, .scale = 1};
    enum status st;

    for (int n = 0; n < round; n++) {
        const double angle = turn * pow((double)n / round, 3);
        const int next = (n + 1) % round;
        vertex[n][0] = 0.5 + radius * cos(angle), vertex[n][1] = 0.5 + radius * sin(angle);
        vertex[n][2] = -below - height;
        memcpy(triangle[2 * n], (int[]){n, next, round}, sizeof *triangle);
        memcpy(triangle[2 * n + 1], (int[]){next, n, round + 1}, sizeof *triangle);
    }
    for (int n = 0; n < 3; n++) { /* the two tips, and the middle of its axis */
        vertex[round + n][0] = vertex[round + n][1] = 0.5;
        vertex[round + n][2] = -below - height * (n == 1 ? 2 : n / 2);
    }
    memcpy(triangle[2 * round], (int[]){round, round + 1, round + 2}, sizeof *triangle);
    TRY(contact_mesh_make(round + 3, (const double(*)[3])vertex, 2 * round + (count < 0),
                          (const int(*)[3])triangle, &body.mesh, why));
    TRY(scene_add_obstacle(s, &body));
    st = contact_rest_refuse(s, why);
out:
    return st;
}

/* Reads the case's scene and the contestant's numerics, E from Gamma; errors as run_read.
 */
static enum status read_run(const struct stress_job *job, struct run *run,
                            struct message *why)
{
    const struct stress_case *c = job->c;
    struct settings settings = {0};
    enum status st;

    add_settings(job, &settings);
    TRY(run_read(run, &(struct case_plan){job->path, job->contestant, settings}, why));
    if (c->gamma > 0)
        run->scene.young =
            derived_key_solve("gamma", "material.young", c->gamma, &run->scene);
    if (c->weight_ratio > 0)
        TRY(give_weights(&run->discretization, c->weight_ratio));
    if (c->needles)
        st = give_needles(&run->scene, c->needles, why);
out:
    settings_clear(&settings);
    return st;
}

/* Takes the error at a frame: the largest is the run's, and its time is that of the first
 * beyond the bound. */
static void note(struct judged *r, double time, double error)
{
    struct stress_result *result = r->result;
    const double bound = r->job->c->bound;

    if (!(error <= bound) && !(result->error > bound))
        result->time = time;
    if (!(error <= result->error))
        result->error = error;
}

static enum status watch(void *context, const struct motion *m, struct message *why)
{
    struct judged *r = context;
    const struct truth_judge *judge = &judges[r->job->c->truth];

    (void)why;
    child_reached(m->time); /* in case that it was the last */
    r->time = m->time, r->frames = m->frames;
    if (judge->when == AT_FRAMES)
        note(r, m->time, judge->error(r));
    return STATUS_OK;
}

/* Goes through the scene's motion; a death leaves its time and sentence. */
static enum status move(struct judged *r)
{
    const struct run *run = &r->run;
    struct motion m = {0};
    enum status st;

    TRY(motion_init(&m, run->model, &run->scene, run->state));
    TRY(motion_run(&m, watch, r, true, r->why));
    if (!m.death)
        goto out;
    r->result->time = m.death_time;
    st = status_fail(r->why, m.death, "%s", status_text(m.death));
out:
    motion_clear(&m);
    return st;
}

/* Goes to static equilibrium; by damped motion where the model has no other way. */
static enum status settle(struct judged *r)
{
    struct counters counters = {0};
    enum status st;

    if (!r->run.model->equilibrium)
        return move(r);
    st = run_settle(&r->run, &counters, r->why);
    if (status_is_death(st))
        r->result->time = 0;
    return st;
}

/* Measures how far a material point has come from rest [m]. */
static void displacement(const struct judged *r, const double uvw[3], double d[3])
{
    const struct run *run = &r->run;
    double rest[3];

    run->model->probe(run->state, 1, uvw, d);
    scene_rest_point(&run->scene, uvw, rest);
    for (int i = 0; i < 3; i++)
        d[i] -= rest[i];
}

/* --- judges -----------------------------------------------------------------------------
 */

static const double tip[3] = {1, 0.5, 0.5}, middle[3] = {0.5, 0.5, 0.5};

/* Functions a direction: 24 give statics to 1e-6. */
enum { TERMS = 24 };

static enum status make_plate(struct judged *r)
{
    const struct scene *s = &r->run.scene;
    const struct kirchhoff_plate plate = {s->length, s->width,   s->thickness,
                                          s->young,  s->poisson, s->density};
    enum status st = kirchhoff_create(&plate, TERMS, &r->plate);

    r->load = s->density * s->thickness * -s->gravity[2];
    return st == STATUS_OK ? st : status_fail(r->why, st, "%s", status_text(st));
}

/* Returns the plate's deflection at the tip at rest [m]. */
static double plate_tip(const struct judged *r)
{
    const struct scene *s = &r->run.scene;

    return kirchhoff_static(r->plate, r->load, s->length, s->width / 2);
}

static double measure_plate(struct judged *r)
{
    double d[3];

    displacement(r, tip, d);
    return fabs(-d[2] / plate_tip(r) - 1);
}

static double measure_vibration(struct judged *r)
{
    const struct scene *s = &r->run.scene;
    double d[3];

    displacement(r, tip, d);
    const double true_tip =
        kirchhoff_transient(r->plate, r->load, 0, r->time, s->length, s->width / 2);
    return fabs(-d[2] - true_tip) / (2 * plate_tip(r));
}

static double measure_elastica(struct judged *r)
{
    const struct scene *s = &r->run.scene;
    struct elastica_point e;
    double d[3];

    displacement(r, tip, d);
    return elastica_solve(scene_gamma(s), &e) == STATUS_OK
               ? hypot(d[0] / s->length + 1 - e.reach, d[2] / s->length + e.drop)
               : NAN;
}

/* Expresses the scene in units of `length` metres, `mass` kilograms and `time` seconds. */
static void change_units(struct scene *s, double length, double mass, double time)
{
    s->length /= length, s->width /= length, s->thickness /= length;
    s->young *= length * time * time / mass;
    s->density *= length * length * length / mass;
    for (int i = 0; i < 3; i++)
        s->gravity[i] *= time * time / length, s->origin[i] /= length;
    s->damping.value *= time;
    s->step /= time, s->end /= time;
}

/* Runs the same once more in other units, in which it may die, too. */
static enum status end_similar(struct judged *r)
{
    const struct stress_case *c = r->job->c;
    struct judged other = *r;
    enum status st;

    other.run = (struct run){0};
    model_sample(r->run.model, r->run.state, r->xyz);
    TRY(read_run(r->job, &other.run, r->why));
    change_units(&other.run.scene, c->length, c->mass, c->time);
    TRY(run_build(&other.run, r->why));
    TRY(move(&other));
    model_sample(other.run.model, other.run.state, r->first);
    for (size_t n = 0; n < 3 * GRID_POINTS; n++)
        r->first[n] *= c->length;
    r->result->error = metric_rmse(r->xyz, r->first) / r->run.scene.length;
out:
    r->result->time *= c->time;
    run_close(&other.run);
    return st;
}

static enum status begin_energy(struct judged *r)
{
    const struct scene *s = &r->run.scene;
    struct energy rest = {NAN, NAN, NAN};

    if (r->run.model->energy)
        r->run.model->energy(r->run.state, &rest);
    if (!isfinite(rest.elastic))
        return status_fail(r->why, STATUS_UNSUPPORTED,
                           "unsupported: no elastic energy that could be kept");
    r->energies = calloc((size_t)(s->end / s->step) + 2, sizeof *r->energies);
    return r->energies ? STATUS_OK : STATUS_MEMORY;
}

/* Takes the energy; the drift is a share of the largest, which is known at the end. */
static double take_energy(struct judged *r)
{
    r->run.model->energy(r->run.state, &r->energies[r->frames]);
    return 0;
}

static enum status end_energy(struct judged *r)
{
    double *drift = malloc((size_t)(r->frames + 1) * sizeof *drift), most = 0, least = 0;

    if (!drift)
        return STATUS_MEMORY;
    metric_energy_drift(r->frames + 1, r->energies, drift);
    for (int n = 0; n <= r->frames; n++) {
        note(r, n * r->run.scene.step, fabs(drift[n]));
        most = fmax(most, drift[n]), least = fmin(least, drift[n]);
    }
    snprintf(r->result->sentence.text, sizeof r->result->sentence.text,
             "%d steps: %.2g won at most, %.2g lost at most, of the energy in play",
             r->frames, most, fabs(least));
    free(drift);
    return STATUS_OK;
}

static double measure_buckled(struct judged *r)
{
    const struct scene *s = &r->run.scene;
    struct scene_placement end;
    double d[3];

    scene_motion_at(&s->supports[s->support_count - 1].motion, s->end, &end);
    displacement(r, middle, d);
    return fabs(fabs(d[2]) / s->length - elastica_buckled(-end.shift[0] / s->length));
}

static double measure_still(struct judged *r)
{
    model_sample(r->run.model, r->run.state, r->frames ? r->xyz : r->first);
    return r->frames ? metric_rmse(r->xyz, r->first) / r->run.scene.length : 0;
}

static enum status begin_still_rest(struct judged *r)
{
    return r->run.model->equilibrium
               ? settle(r)
               : status_fail(r->why, STATUS_UNSUPPORTED,
                             "unsupported: no static equilibrium to start from");
}

static double measure_shifted(struct judged *r)
{
    const struct scene *s = &r->run.scene;
    struct scene_placement end;
    double uvw[3], *rest = r->first;

    scene_motion_at(&s->supports[0].motion, s->end, &end);
    for (int n = 0; n < GRID_POINTS; n++) {
        grid_point(n, uvw);
        scene_rest_point(s, uvw, rest + 3 * n);
        for (int i = 0; i < 3; i++)
            rest[3 * n + i] += end.shift[i];
    }
    model_sample(r->run.model, r->run.state, r->xyz);
    return metric_rmse(r->xyz, rest) / s->length;
}

/* Finds the truth of a case of STRESS_SHELL at some times, which the shell makes if it is
 * not in the folder yet and `made`. Errors as truth_find. */
static enum status find_truth(const struct stress_job *job, bool made, struct truth **truth,
                              struct message *why)
{
    /* The sheet hangs from points, which hold nothing of a solid. */
    static const struct truth_wish wish = {.error = 0.005, .seconds = 30, .shell = true};
    static const double time[] = {0.1, 0.2, 0.3};
    const int times = sizeof time / sizeof *time;
    char folder[4096];
    struct settings physics = {0};
    enum status st = STATUS_OK;

    settings_list(&physics, STRESS_SETTINGS, job->c->physics);
    snprintf(folder, sizeof folder, "%s/%s.truth", job->folder, job->c->item.name);
    if (made)
        TRY(folder_make(folder, why));
    st = made ? truth_find_or_make(job->path, &physics, times, time, folder, &wish, truth,
                                   why)
              : truth_find(job->path, &physics, times, time, folder, truth, why);
out:
    settings_clear(&physics);
    return st;
}

static enum status begin_shell(struct judged *r)
{
    struct message missing = {""};

    if (find_truth(r->job, false, &r->truth, &missing) != STATUS_OK)
        return status_fail(r->why, STATUS_UNSUPPORTED,
                           "no truth to hold it against: %.900s", missing.text);
    snprintf(r->result->sentence.text, sizeof r->result->sentence.text,
             "the truth's error bar is %.2g",
             r->truth->error[r->truth->times - 1] / r->run.scene.length);
    return STATUS_OK;
}

static double measure_shell(struct judged *r)
{
    const struct scene *s = &r->run.scene;
    const int n = truth_index(r->truth, r->truth->times, r->time);

    if (n < 0)
        return 0; /* between the times of the truth */
    model_sample(r->run.model, r->run.state, r->xyz);
    return metric_rmse(r->xyz, r->truth->xyz[n]) / s->length;
}

static enum status begin_contact(struct judged *r)
{
    r->touched = (struct touched){.gap = INFINITY, .through_time = NAN};
    return STATUS_OK;
}

/* The points of the middle of the sheet that judges of contact look at: every third of the
 * grid. */
enum { STEP = 3, U = (GRID_U - 1) / STEP + 1, V = (GRID_V - 1) / STEP + 1 };

/* Returns the least distance of the middle x[V U][3] from a body since the frame before, as
 * if sheet and bodies had moved evenly: what lies on the other side now has passed through.
 * Keeps x for the next frame. */
static double least_gap(const struct judged *r, const double *x)
{
    enum { TIMES = 8 };
    const struct scene *s = &r->run.scene;
    double *before = r->first + GRID_POINTS, *between = before + GRID_POINTS,
           gap = INFINITY;

    for (int k = r->frames ? 1 : TIMES; k <= TIMES; k++) {
        const double share = (double)k / TIMES;
        for (int n = 0; n < 3 * U * V; n++)
            between[n] = share < 1 ? before[n] + share * (x[n] - before[n]) : x[n];
        const double now = contact_shape_least_gap(s, r->time - (1 - share) * s->step,
                                                   (long)U * V, between);
        if (!(now >= gap))
            gap = now;
    }
    memcpy(before, x, 3 * U * V * sizeof *x);
    return gap;
}

static double measure_contact(struct judged *r)
{
    const struct scene *s = &r->run.scene;
    const double start = contact_law_body(s).start;
    struct touched *t = &r->touched;
    struct crossing with = {0};

    model_sample(r->run.model, r->run.state, r->xyz);
    grid_middle(r->xyz, STEP, r->first);
    const double gap = least_gap(r, r->first);
    if (!(gap >= t->gap))
        t->gap = gap, t->gap_time = r->time;
    if (s->contact.self && crossing_of_field(&r->work, s->sheets, STEP, r->xyz,
                                             CROSSING_TOLERANCE, &with) != STATUS_OK)
        return NAN;
    if (with.pairs && isnan(t->through_time))
        t->through_time = r->time;
    if (with.depth > t->with.depth)
        t->with = with, t->deepest_time = r->time;
    return isnan(gap) ? NAN
                      : fmax(fmax(0, 1 - gap / start) / 2,
                             with.pairs ? 0.5 + with.depth / (2 * start) : 0);
}

/* Takes the way of the middle of all points along the first obstacle, a plane under the
 * sheet that gravity crosses. */
static double measure_slide(struct judged *r)
{
    const struct scene *s = &r->run.scene;
    const double touched = measure_contact(r), bound = 0.5;
    const double fall = s->gravity[0] + s->obstacles[0].friction * s->gravity[2];
    double way = 0;

    for (int n = 0; n < GRID_POINTS; n++)
        way += r->xyz[3 * n] / GRID_POINTS;
    way -= s->origin[0] + s->length / 2;
    way = fabs(way - fmax(0, fall) * r->time * r->time / 2) / s->length;
    return touched <= bound ? way : touched;
}

/* Tells what the run has touched up to now. */
static void tell_contact(const struct judged *r, char *text, size_t size)
{
    const struct touched *t = &r->touched;
    const struct scene *s = &r->run.scene;
    const double start = contact_law_body(s).start;
    int used = 0;

    if (s->obstacle_count)
        used = snprintf(
            text, size,
            t->gap > 0 ? "nearest to a body: %.3g mm at %.3g s, of %.3g mm where "
                         "contact starts"
                       : "through a body: %.3g mm deep at %.3g s, %.3g mm off is where "
                         "contact starts",
            fabs(t->gap) * 1e3, t->gap_time, start * 1e3);
    if (s->contact.self && isnan(t->through_time))
        snprintf(text + used, size - (size_t)used, "%snot through %s", used ? "; " : "",
                 scene_sheet_other(s));
    else if (s->contact.self)
        snprintf(text + used, size - (size_t)used,
                 "%sthrough %s from %.3g s, deepest by %.3g mm on %d triangles at %.3g s",
                 used ? "; " : "", scene_sheet_other(s), t->through_time,
                 t->with.depth * 1e3, t->with.triangles, t->deepest_time);
}

static enum status end_contact(struct judged *r)
{
    tell_contact(r, r->result->sentence.text, sizeof r->result->sentence.text);
    return STATUS_OK;
}

static const struct truth_judge judges[STRESS_TRUTHS] = {
    [STRESS_PLATE] = {AT_REST, make_plate, measure_plate, NULL},
    [STRESS_ELASTICA] = {AT_REST, NULL, measure_elastica, NULL},
    [STRESS_VIBRATION] = {AT_FRAMES, make_plate, measure_vibration, NULL},
    [STRESS_SIMILAR] = {AT_END, NULL, NULL, end_similar},
    [STRESS_ENERGY] = {AT_FRAMES, begin_energy, take_energy, end_energy},
    [STRESS_BUCKLED] = {AT_END, NULL, measure_buckled, NULL},
    [STRESS_STILL] = {AT_FRAMES, NULL, measure_still, NULL},
    [STRESS_STILL_REST] = {AT_FRAMES, begin_still_rest, measure_still, NULL},
    [STRESS_SHIFTED] = {AT_END, NULL, measure_shifted, NULL},
    [STRESS_SHELL] = {AT_FRAMES, begin_shell, measure_shell, NULL},
    [STRESS_CONTACT] = {AT_FRAMES, begin_contact, measure_contact, end_contact},
    [STRESS_SLIDE] = {AT_FRAMES, begin_contact, measure_slide, end_contact},
};

/* --- one job ----------------------------------------------------------------------------
 */

static enum status judge(struct judged *r)
{
    const struct truth_judge *j = &judges[r->job->c->truth];
    struct stress_result *result = r->result;
    enum status st;

    TRY(j->begin ? j->begin(r) : STATUS_OK);
    TRY(j->when == AT_REST ? settle(r) : move(r));
    if (j->when != AT_FRAMES && j->error)
        result->error = j->error(r);
    TRY(j->end ? j->end(r) : STATUS_OK);
    result->end = stress_result_end(result->error, r->job->c->bound);
out:
    if (status_is_death(st) && j->end == end_contact) { /* even then it is told */
        const struct message said = *r->why;
        struct message told = {""};
        tell_contact(r, told.text, sizeof told.text);
        if (*told.text)
            status_fail(r->why, st, "%.500s; before: %.400s",
                        *said.text ? said.text : status_text(st), told.text);
    }
    return st;
}

/* Makes a model's refusal or death the result; a file that cannot be written is none. */
static enum status settle_result(enum status st, const struct message *said,
                                 struct stress_result *result, struct message *why)
{
    const char *text = *said->text ? said->text : status_text(st);

    if (st == STATUS_OK)
        return st;
    if (st == STATUS_FILE)
        return status_fail(why, st, "%s", text);
    result->end =
        st == STATUS_UNSUPPORTED || st == STATUS_INPUT ? STRESS_REFUSED : STRESS_DIED;
    result->error = NAN;
    snprintf(result->sentence.text, sizeof result->sentence.text, "%s", text);
    return STATUS_OK;
}

enum status stress_judge(const struct stress_job *job, struct stress_result *result,
                         struct message *why)
{
    struct message said = {""};
    struct judged r = {.job = job, .result = result, .why = &said};
    const double start = clock_processor();
    enum status st;

    *result = (struct stress_result){.error = NAN, .time = NAN};
    r.xyz = malloc(2 * 3 * GRID_POINTS * sizeof *r.xyz);
    TRY(r.xyz ? STATUS_OK : STATUS_MEMORY);
    r.first = r.xyz + 3 * GRID_POINTS;
    TRY(read_run(job, &r.run, &said));
    TRY(run_build(&r.run, &said));
    st = judge(&r);
out:
    result->seconds = clock_processor() - start;
    kirchhoff_destroy(r.plate);
    truth_destroy(r.truth);
    run_close(&r.run);
    intersection_clear(&r.work);
    free(r.energies);
    free(r.xyz);
    return settle_result(st, &said, result, why);
}

/* --- what is printed --- */

/* A contestant's result of a case, as the file has it. */
struct row {
    const struct contestant *contestant;
    bool there;
    struct stress_result r;
};

/* The tables: how all ended, a row a case; what each case is held against; everything, a
 * row a run. */
enum { OVERVIEW, TRUTHS, DETAILS, TABLES };
struct tables {
    struct table *table[TABLES];
    int count[STRESS_ENDS]; /* runs by their end                                       */
};

static struct table *create_details(void)
{
    static const struct table_column details[] = {
        {"case", NULL, TABLE_LEFT},
        {"model", NULL, TABLE_LEFT},
        {"bound", "1", TABLE_RIGHT, .readers = TABLE_MACHINES},
        {"end", NULL, TABLE_LEFT},
        {"error", "1", TABLE_RIGHT},
        {"until", "s", TABLE_RIGHT},
        {"took", "s", TABLE_RIGHT},
        {"in words", NULL, TABLE_LEFT},
    };

    return TABLE_OF(details, "How each run ended");
}

/* Makes the tables; those for which there is no memory are NULL, as table_finish expects.
 */
static struct tables create_tables(int contestants, const struct row *rows)
{
    static const struct table_column truths[] = {
        {"case", NULL, TABLE_LEFT},   {"what is hard", NULL, TABLE_LEFT},
        {"bound", NULL, TABLE_RIGHT}, {"its reason", NULL, TABLE_LEFT},
        {"error", NULL, TABLE_LEFT},
    };
    struct table_column *columns = calloc((size_t)contestants + 1, sizeof *columns);
    struct table *overview = NULL;

    if (columns) {
        columns[0] = (struct table_column){"case", NULL, TABLE_LEFT};
        for (int n = 0; n < contestants; n++)
            columns[n + 1] =
                (struct table_column){rows[n].contestant->column, NULL, TABLE_LEFT};
        overview = table_create(contestants + 1, columns, "Hard cases");
    }
    free(columns);
    return (struct tables){.table = {overview,
                                     TABLE_OF(truths, "What each case is held against"),
                                     create_details()}};
}

/* Fills the next cell of the overview. */
static void add_word(struct table *t, const struct row *row)
{
    const struct stress_result *r = &row->r;

    if (!row->there)
        table_add(t, "-");
    else if (r->end == STRESS_ACCURATE || r->end == STRESS_DEGRADED)
        table_add(t, "%s %.0e", r->end == STRESS_ACCURATE ? "ok" : "off", r->error);
    else if (r->end == STRESS_DIED && isfinite(r->time))
        table_add(t, "died %.2g s", r->time);
    else
        table_add(t, "%s", stress_end_name[r->end]);
}

static void add_details(struct table *t, const struct stress_case *c,
                        const struct contestant *contestant, const struct stress_result *r)
{
    table_line(t, "%s|%s|%.1g|%s|%.3g|%.3g|%.2f|%s", c->item.name, contestant->name,
               c->bound, stress_end_name[r->end], isfinite(r->error) ? r->error : NAN,
               r->time, r->seconds, r->sentence.text);
}

enum status stress_save(const char *folder, long count, const struct stress_job *jobs,
                        struct message *why)
{
    struct table *t = create_details();

    for (const struct stress_job *j = jobs; j < jobs + count; j++)
        add_details(t, j->c, j->contestant, j->result);
    const enum status st = table_save(t, folder, "stress", why);
    table_destroy(t);
    return st;
}

static void add_truth(struct table *t, const struct stress_case *c)
{
    table_line(t, "%s|%s|%.1g|%s|%s", c->item.name, c->item.text, c->bound, c->why,
               stress_truth_text[c->truth]);
}

/* Reads the row of a case and a contestant, if there is one. */
static void read_row(const struct csv_table *t, const struct stress_case *c,
                     struct row *row)
{
    row->there = false;
    for (int n = 0; n < t->rows && !row->there; n++) {
        int end = 0;
        if (strcmp(csv_words_of(t, n, "case"), c->item.name) ||
            strcmp(csv_words_of(t, n, "model"), row->contestant->name))
            continue;
        while (end < STRESS_ENDS && strcmp(csv_words_of(t, n, "end"), stress_end_name[end]))
            end++;
        row->there = end < STRESS_ENDS;
        row->r = (struct stress_result){.end = (enum stress_end)end,
                                        .error = csv_number_of(t, n, "error"),
                                        .time = csv_number_of(t, n, "until_s"),
                                        .seconds = csv_number_of(t, n, "took_s")};
        snprintf(row->r.sentence.text, sizeof row->r.sentence.text, "%s",
                 csv_words_of(t, n, "in_words"));
    }
}

/* Reads the rows of a case; returns how many there are. */
static int read_case(const struct csv_table *t, const struct stress_case *c,
                     int contestants, struct row *rows)
{
    int count = 0;

    for (struct row *row = rows; row < rows + contestants; row++) {
        read_row(t, c, row);
        count += row->there;
    }
    return count;
}

static void add_case(struct tables *t, const struct stress_case *c, int contestants,
                     const struct row *rows)
{
    table_line(t->table[OVERVIEW], "%s", c->item.name);
    for (const struct row *row = rows; row < rows + contestants; row++) {
        add_word(t->table[OVERVIEW], row);
        if (!row->there)
            continue;
        add_details(t->table[DETAILS], c, row->contestant, &row->r);
        t->count[row->r.end]++;
    }
    add_truth(t->table[TRUTHS], c);
    table_rule(t->table[DETAILS]);
}

/* Adds the notes; returns the number of runs. */
static int add_notes(const struct tables *t)
{
    struct table *overview = t->table[OVERVIEW];
    const int *count = t->count;
    int runs = 0;

    for (int n = 0; n < STRESS_ENDS; n++)
        runs += count[n];
    table_note(overview,
               "`ok` means accurate: the error is within the case's bound. `off` means "
               "degraded: the error is beyond it. %d runs: %d accurate, %d degraded, %d "
               "refused, %d died.",
               runs, count[0], count[1], count[2], count[3]);
    table_note(t->table[DETAILS],
               "The column `until` is the time in the scene at which the run died, or "
               "at which its error first exceeded the bound.");
    return runs;
}

enum status stress_print(const char *folder, const struct stress_choice *choice,
                         const struct printer *p, struct message *why)
{
    const bool data = table_format_is_data(p->format);
    const struct contestant *at = NULL;
    struct csv csv = {0};
    char path[PATH];
    int contestants = 0;
    enum status st;

    snprintf(path, PATH, "%s/stress.csv", folder);
    TRY(csv_read(path, &csv, why));
    while ((at = stress_choice_next(choice, at)))
        contestants++;
    struct row *rows = calloc((size_t)contestants + 1, sizeof *rows);
    TRY(rows ? STATUS_OK : STATUS_MEMORY);
    for (int n = 0; (at = stress_choice_next(choice, at)); n++)
        rows[n].contestant = at;
    struct tables t = create_tables(contestants, rows);
    for (int n = 0; stress_case_at(n); n++)
        if (stress_choice_case(choice, stress_case_at(n)) &&
            read_case(csv.table, stress_case_at(n), contestants, rows))
            add_case(&t, stress_case_at(n), contestants, rows);
    const int runs = add_notes(&t);
    for (int n = 0; n < TABLES; n++) /* a machine gets one: that with everything */
        if (st == STATUS_OK && runs && (!data || n == DETAILS))
            st = kept_table(p, t.table[n]);
        else
            table_destroy(t.table[n]);
    free(rows);
    if (st == STATUS_OK && !runs)
        st = status_fail(why, STATUS_INPUT, "%s holds no such results of `stress`", path);
out:
    csv_clear(&csv);
    return st;
}

/* The limit of a job's processor time [s]; that of the clock is ten times as long, for a
 * job that sleeps. */
enum { TIME_LIMIT = 120 };

struct options {
    const char *folder;
    struct stress_choice choice;
    int jobs;
};

/* --- the choice -------------------------------------------------------------------------
 */

bool stress_choice_case(const struct stress_choice *choice, const struct stress_case *c)
{
    for (int n = 0; n < choice->word_count; n++)
        if (!strcmp(choice->words[n], c->item.name))
            return true;
    return !choice->word_count && (c->quick || !choice->quick);
}

const struct contestant *stress_choice_next(const struct stress_choice *choice,
                                            const struct contestant *last)
{
    const struct contestant *c = last ? last + 1 : contestant_table;

    while (c->name && !contestant_chosen(c, choice->models, CONTESTANT_STRESS))
        c++;
    return c->name ? c : NULL;
}

enum status stress_choice_check(const struct stress_choice *choice, struct message *why)
{
    for (int w = 0; w < choice->word_count; w++) {
        int n = 0;
        while (stress_case_items[n] && strcmp(stress_case_items[n]->name, choice->words[w]))
            n++;
        if (!stress_case_items[n])
            return status_fail(why, STATUS_INPUT,
                               "stress: there is no case '%s'; clothbench list cases has "
                               "them",
                               choice->words[w]);
    }
    return contestant_check(choice->models, why);
}

/* --- jobs -------------------------------------------------------------------------------
 */

/* Does a job in a process of its own. */
static enum status work(void *context, long number, struct message *why)
{
    const struct stress_job *job = (const struct stress_job *)context + number;

    return stress_judge(job, job->result, why);
}

/* Ends a job: a run that came to no result of its own has died. */
static enum status end_job(void *context, long number, const struct child_end *end,
                           struct message *why)
{
    const struct stress_job *job = (const struct stress_job *)context + number;
    const struct stress_result dead = {.end = STRESS_DIED,
                                       .error = NAN,
                                       .time = end->reached,
                                       .seconds = end->seconds,
                                       .sentence = end->why};

    (void)why;
    if (end->outcome != CHILD_DONE)
        *job->result = dead;
    return STATUS_OK;
}

/* Lists the jobs of the chosen cases. Returns their number; list NULL: the number alone.
 * result[]: room for as many. */
static long list_jobs(const struct options *o, const char *path,
                      struct stress_result *result, struct stress_job *list)
{
    struct stress_job job = {.path = path, .folder = o->folder};
    long count = 0;

    for (int n = 0; (job.c = stress_case_at(n)); n++)
        while (stress_choice_case(&o->choice, job.c) &&
               (job.contestant = stress_choice_next(&o->choice, job.contestant))) {
            if (list) {
                list[count] = job;
                list[count].result = &result[count];
            }
            count++;
        }
    return count;
}

/* Makes the truths of the cases that need one; runs without one say that there is none. */
static enum status make_truths(long count, const struct stress_job *list)
{
    enum status st = STATUS_OK;

    for (long n = 0; n < count && st != STATUS_MEMORY; n++) {
        struct truth *truth = NULL;
        struct message said = {""};
        if (list[n].c->truth != STRESS_SHELL || (n && list[n].c == list[n - 1].c))
            continue;
        st = find_truth(&list[n], true, &truth, &said);
        if (st != STATUS_OK)
            fprintf(stderr, "stress %s: no truth: %s\n", list[n].c->item.name, said.text);
        truth_destroy(truth);
    }
    return st == STATUS_MEMORY ? st : STATUS_OK;
}

static enum status measure(const struct options *o, struct message *why)
{
    struct pool pool = {.count = list_jobs(o, NULL, NULL, NULL),
                        .slots = o->jobs,
                        .time_limit = TIME_LIMIT,
                        .work = work,
                        .settle = end_job};
    const size_t size = ((size_t)pool.count + 1) * sizeof(struct stress_result);
    struct stress_result *result =
        mmap(NULL, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    struct stress_job *list = calloc((size_t)pool.count + 1, sizeof *list);
    char *path = NULL;
    enum status st;

    TRY(list && result != MAP_FAILED ? STATUS_OK : STATUS_MEMORY);
    TRY(folder_make(o->folder, why));
    TRY(scene_file_find(stress_case_scene, &path, why));
    pool.context = list;
    list_jobs(o, path, result, list);
    omp_set_num_threads(1);
    TRY(make_truths(pool.count, list));
    TRY(pool_run(&pool, why));
    if (pool.stopped_by)
        pool_raise(&pool);
    st = stress_save(o->folder, pool.count, list, why);
out:
    if (result != MAP_FAILED)
        munmap(result, size);
    free(list);
    free(path);
    return st;
}

static enum status run(const struct command_line *line, struct message *why)
{
    const char *from;
    struct options o = {.folder = "results/stress",
                        .choice = {.word_count = line->word_count,
                                   .words = line->words,
                                   .models = command_value(line, "--models"),
                                   .quick = command_given(line, "--quick")}};
    struct printer p = {TABLE_TEXT, stdout, NULL};
    long jobs = omp_get_num_procs();
    enum status st = STATUS_OK;

    TRY(command_folder(line, &o.folder, &from, why));
    TRY(command_format(line, &p.format, why));
    TRY(command_integer(line, "--jobs", 1, 1024, &jobs, why));
    TRY(stress_choice_check(&o.choice, why));
    o.jobs = (int)jobs;
    if (!from)
        TRY(measure(&o, why));
    if (!o.choice.word_count)
        kept_open(o.folder, "stress", "", &p.kept);
    TRY(stress_print(o.folder, &o.choice, &p, why));
    TRY(kept_close(&p.kept, why));
    show_tell(o.folder);
out:
    kept_discard(&p.kept);
    return st;
}

static const struct command_option options[] = {
    {"--models", "A,B,...", false, "models or contestants (those that take part here)"},
    {"--quick", NULL, false, "some of the cases, in less than a minute"},
    {"--jobs", "N", false, "runs at a time (the number of processors)"},
    {"--format", TABLE_FORMATS, false, "output format (text)"},
    {"--out", "DIR", false, "folder of stress.csv (results/stress)"},
    {"--from", "DIR", false, "print again from stress.csv of an earlier run"},
    {NULL, NULL, false, NULL},
};

const struct command stress_command = {
    .name = "stress",
    .summary =
        "run hard cases: thin, stiff, incompressible, long steps, odd nets, units, contact",
    .arguments = "[CASE]... [OPTION]...",
    .text =
        "Runs every contestant on hard cases, each in a process of its own with a time\n"
        "limit. A run ends as accurate or degraded, by its error against the truth that\n"
        "the case names; as refused, with the model's sentence; or as died, with time\n"
        "and cause. The bound on the error is the same for all and is printed with its\n"
        "reason. Cases of contact also tell how near the middle of the sheet came to a\n"
        "body, and when and how deep it passed through one or through itself.\n",
    .examples = "stress\nstress --quick\nstress thin_5 buckling --models iga,shell\n",
    .most = 64,
    .options = options,
    .section = "cases",
    .items = stress_case_items,
    .run = run,
};
