/* Measures the errors of hard cases. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/child.h"
#include "bench/harness/derived_key.h"
#include "bench/harness/motion.h"
#include "bench/harness/run.h"
#include "bench/stress/stress.h"
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
struct judge {
    enum { AT_REST, AT_END, AT_FRAMES } when;
    enum status (*begin)(struct judged *r);
    double (*error)(struct judged *r);
    enum status (*end)(struct judged *r);
};
static const struct judge judges[STRESS_TRUTHS];

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
 * axis; `needles` as in struct stress_case. STATUS_INPUT with a sentence: no such mesh. */
static enum status give_needles(struct scene *s, int needles, struct message *why)
{
    enum { ROUND_MOST = 100 };
    const double radius = 0.4, height = 0.025, below = 0.011, turn = 8 * atan(1);
    const int round = needles < 0 ? -needles / 2 : needles / 2;
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
    TRY(contact_mesh_make(round + 3, (const double(*)[3])vertex, 2 * round + (needles < 0),
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
    TRY(run_read(run, &(struct run_plan){job->path, job->contestant, .settings = &settings},
                 why));
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
    const struct judge *judge = &judges[r->job->c->truth];

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

static enum status begin_shell(struct judged *r)
{
    const struct message *lost = r->job->no_truth;
    struct message missing = {""};

    if (stress_find_truth(r->job, false, &r->truth, &missing) != STATUS_OK)
        return status_fail(r->why, STATUS_UNSUPPORTED,
                           "no truth to hold it against: %.900s",
                           lost && *lost->text ? lost->text : missing.text);
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

static const struct judge judges[STRESS_TRUTHS] = {
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
    const struct judge *j = &judges[r->job->c->truth];
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
