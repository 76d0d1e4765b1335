#include "bench/verify/checks/stress.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/folder.h"
#include "bench/harness/child.h"
#include "bench/harness/derived_key.h"
#include "bench/truth/truth.h"
#include "bench/data/printer.h"
#include "bench/verify/verify.h"
#include "fem_ref/elastica.h"
#include "fem_ref/kirchhoff.h"
#include "models/clock.h"
#include "models/contact/contact_law.h"
#include "models/bodies/body_mesh.h"
#include "models/contact/contact_rest.h"
#include "models/bodies/body_shape.h"
#include "models/grid.h"
#include "models/metric/crossing.h"
#include "models/metric/metric.h"
#include "models/reader/scene_file.h"

const char *const stress_scene = "cantilever";

static const struct stress_case *case_of(const struct verify_sheet *sheet)
{
    return (const struct stress_case *)sheet->check;
}

/* The worst of what a run has touched. */
struct touched {
    double gap, gap_time; /* least distance of the middle from a body [m], [s]   */
    double through_time;  /* when it first passes through itself; NaN: never [s] */
    struct crossing with; /* itself, where that is deepest                       */
    double deepest_time;  /* of that                                         [s] */
};

/* A run of a hard case, on its way to an error. */
struct judged {
    const struct stress_case *c;          /*                                   borrowed */
    const struct verify_subject *subject; /*                                  borrowed */
    struct verify_row *row;               /* to be filled                      borrowed */
    struct run run;
    double time; /* of the frame that was reached [s]                                  */
    int frames;  /* up to it                                                           */
    struct message *why;      /* for the sentence of a failure            borrowed */
    double *xyz, *first;      /* fields (grid.h), room for judges                  */
    struct kirchhoff *plate;  /* of the judges that need it                  owned */
    double load;              /* on that plate [N/m^2]                             */
    struct energy *energies;  /* [frames of the scene + 1]                         */
    struct truth *truth;      /* the finer shell's                           owned */
    FILE *mesh;               /* the case's own, NULL: none                    owned */
    struct touched touched;   /* of the judges of contact                          */
    struct intersection work; /* of the same                                 owned */
};

/* The judge of a truth: it measures the error at rest, at the end of the motion, or at all
 * frames, of which the largest counts. NULL: nothing to do. */
struct stress_truth {
    enum { AT_REST, AT_END, AT_FRAMES } when;
    enum status (*begin)(struct judged *r);
    double (*error)(struct judged *r);
    enum status (*end)(struct judged *r);
};

/* --- runs -------------------------------------------------------------------------------
 */

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
    CALL(body_mesh_make(round + 3, (const double(*)[3])vertex, 2 * round + (count < 0),
                        (const int(*)[3])triangle, &body.mesh, why));
    CALL(scene_add_obstacle(s, &body));
    return contact_rest_refuse(
        s, &(struct discretization){.kinematics = KINEMATICS_NONLINEAR}, why);
}

/* Gives a mesh whose triangles all meet in the middle of the sheet, as a file. */
static enum status give_fan(struct judged *r)
{
    static const int corner[][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
    const int count = r->c->valence;
    char path[32];

    if (!(r->mesh = tmpfile()))
        return status_fail(r->why, STATUS_FILE, "no temporary file can be made");
    fprintf(r->mesh, "v 0.5 0.5 0\n");
    for (int n = 0; n < count; n++) {
        const int *a = corner[4 * n / count], *b = a + 2;
        const double part = (double)(4 * n % count) / count;
        fprintf(r->mesh, "v %.17g %.17g 0\n", a[0] + part * (b[0] - a[0]),
                a[1] + part * (b[1] - a[1]));
    }
    for (int n = 0; n < count; n++)
        fprintf(r->mesh, "f 1 %d %d\n", n + 2, (n + 1) % count + 2);
    fflush(r->mesh);
    snprintf(path, sizeof path, "/dev/fd/%d", fileno(r->mesh));
    free(r->run.discretization.mesh);
    r->run.discretization.mesh = strdup(path);
    return r->run.discretization.mesh ? STATUS_OK : STATUS_MEMORY;
}

/* Reads the case's scene and the contestant's numerics, E from Gamma; errors as run_read.
 */
static enum status read_run(const struct judged *r, struct run *run, struct message *why)
{
    const struct stress_case *c = r->c;
    const struct verify_subject *s = r->subject;
    struct settings settings SCOPED(settings_clear) = {0};
    enum status st = STATUS_OK;

    settings_list(&settings, STRESS_SETTINGS, c->physics);
    contestant_points(s->contestant, s->along[0], s->across[0], &settings);
    settings_list(&settings, STRESS_SETTINGS, c->numerics);
    CALL(run_read(run, &(struct case_plan){stress_scene, s->contestant, settings}, why));
    if (c->gamma > 0)
        run->scene.young = derived_key_young("gamma", c->gamma, &run->scene);
    if (c->weight_ratio > 0)
        CALL(give_weights(&run->discretization, c->weight_ratio));
    if (c->needles)
        st = give_needles(&run->scene, c->needles, why);
    return st;
}

/* Takes the error at a frame: the largest is the run's, and its time is that of the first
 * beyond the bound. */
static void note(struct judged *r, double time, double error)
{
    const double bound = r->row->tolerance;

    if (!(error <= bound) && !(r->row->error > bound))
        r->row->until = time;
    if (!(error <= r->row->error))
        r->row->error = error;
}

static enum status watch(void *context, const struct motion *m, struct message *why)
{
    struct judged *r = context;
    const struct stress_truth *judge = r->c->truth;

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
    struct motion m SCOPED(motion_clear) = {0};

    motion_init(&m, run->model, &run->scene, run->state);
    CALL(motion_run(&m, watch, r, true, r->why));
    if (!m.death)
        return STATUS_OK;
    r->row->until = m.death_time;
    return status_fail(r->why, m.death, "%s", status_text(m.death));
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
        r->row->until = 0;
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
    const struct stress_case *c = r->c;
    struct judged other = *r;
    enum status st;

    other.run = (struct run){0};
    model_sample(r->run.model, r->run.state, r->xyz);
    TRY(read_run(r, &other.run, r->why));
    change_units(&other.run.scene, c->length, c->mass, c->time);
    TRY(run_build(&other.run, r->why));
    TRY(move(&other));
    model_sample(other.run.model, other.run.state, r->first);
    for (size_t n = 0; n < 3 * GRID_POINTS; n++)
        r->first[n] *= c->length;
    r->row->error = metric_rmse(r->xyz, r->first) / r->run.scene.length;
out:
    r->row->until *= c->time;
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
    r->energies = arena_take(&r->subject->sheet->arena, (size_t)(s->end / s->step) + 2,
                             sizeof *r->energies);
    return STATUS_OK;
}

/* Takes the energy; the drift is a share of the largest, which is known at the end. */
static double take_energy(struct judged *r)
{
    r->run.model->energy(r->run.state, &r->energies[r->frames]);
    return 0;
}

static enum status end_energy(struct judged *r)
{
    double *drift =
               arena_take(&r->subject->sheet->arena, (size_t)r->frames + 1, sizeof *drift),
           most = 0, least = 0;

    metric_energy_drift(r->frames + 1, r->energies, drift);
    for (int n = 0; n <= r->frames; n++) {
        note(r, n * r->run.scene.step, fabs(drift[n]));
        most = fmax(most, drift[n]), least = fmin(least, drift[n]);
    }
    verify_row_note(r->row,
                    "%d steps: %.2g won at most, %.2g lost at most, of the energy in play",
                    r->frames, most, fabs(least));
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

/* Finds the truth of a finer shell at some times, which it makes if it is not in the
 * folder yet and `made`. Errors as truth_find. */
static enum status find_truth(const struct verify_sheet *sheet, bool made,
                              struct truth **truth, struct message *why)
{
    /* The sheet hangs from points, which hold nothing of a solid. */
    static const struct truth_wish wish = {.error = 0.005, .seconds = 30, .shell = true};
    static const double time[] = {0.1, 0.2, 0.3};
    const int times = sizeof time / sizeof *time;
    char folder[4096];
    char *path SCOPED(scope_free) = NULL;
    struct settings physics SCOPED(settings_clear) = {0};

    CALL(scene_file_find(stress_scene, &path, why));
    settings_list(&physics, STRESS_SETTINGS, case_of(sheet)->physics);
    snprintf(folder, sizeof folder, "%s/%s.truth", sheet->folder, sheet->check->item.name);
    if (made)
        CALL(folder_make(folder, why));
    return made ? truth_find_or_make(path, &physics, times, time, folder, &wish, truth, why)
                : truth_find(path, &physics, times, time, folder, truth, why);
}

/* Makes the truth of a case before its runs, which without one say that there is none. */
static void make_truth(struct verify_sheet *sheet)
{
    struct truth *truth SCOPED(truth_destroy_scope) = NULL;
    struct message said = {""};
    const enum status st = find_truth(sheet, true, &truth, &said);

    if (st != STATUS_OK)
        fprintf(stderr, "stress %s: no truth: %s\n", sheet->check->item.name, said.text);
}

static enum status begin_shell(struct judged *r)
{
    struct message missing = {""};

    if (find_truth(r->subject->sheet, false, &r->truth, &missing) != STATUS_OK)
        return status_fail(r->why, STATUS_UNSUPPORTED,
                           "no truth to hold it against: %.900s", missing.text);
    verify_row_note(r->row, "the truth's error bar is %.2g",
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
        const double now =
            body_shape_least_gap(s, r->time - (1 - share) * s->step, (long)U * V, between);
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
    struct message told = {""};

    tell_contact(r, told.text, sizeof told.text);
    verify_row_note(r->row, "%s", told.text);
    return STATUS_OK;
}

const struct stress_truth
    stress_plate = {AT_REST, make_plate, measure_plate, NULL},
    stress_elastica = {AT_REST, NULL, measure_elastica, NULL},
    stress_vibration = {AT_FRAMES, make_plate, measure_vibration, NULL},
    stress_similar = {AT_END, NULL, NULL, end_similar},
    stress_energy = {AT_FRAMES, begin_energy, take_energy, end_energy},
    stress_buckled = {AT_END, NULL, measure_buckled, NULL},
    stress_still = {AT_FRAMES, NULL, measure_still, NULL},
    stress_still_rest = {AT_FRAMES, begin_still_rest, measure_still, NULL},
    stress_shifted = {AT_END, NULL, measure_shifted, NULL},
    stress_shell = {AT_FRAMES, begin_shell, measure_shell, NULL},
    stress_contact = {AT_FRAMES, begin_contact, measure_contact, end_contact},
    stress_slide = {AT_FRAMES, begin_contact, measure_slide, end_contact};

/* --- one row --- */

static enum status judge(struct judged *r)
{
    const struct stress_truth *truth = r->c->truth;
    enum status st;

    TRY(truth->begin ? truth->begin(r) : STATUS_OK);
    TRY(truth->when == AT_REST ? settle(r) : move(r));
    if (truth->when != AT_FRAMES && truth->error)
        r->row->error = truth->error(r);
    st = truth->end ? truth->end(r) : STATUS_OK;
out:
    if (status_is_death(st) && truth->end == end_contact) { /* even then it is told */
        const struct message said = *r->why;
        struct message told = {""};
        tell_contact(r, told.text, sizeof told.text);
        if (*told.text)
            status_fail(r->why, st, "%.500s; before: %.400s",
                        *said.text ? said.text : status_text(st), told.text);
    }
    return st;
}

/* Ends a row: a model's refusal or death, and an error that is no number, are verdicts; a
 * file that cannot be written is none. */
static void end_row(struct judged *r, enum status st)
{
    const char *text = *r->why->text ? r->why->text : status_text(st);
    struct verify_sheet *sheet = r->subject->sheet;

    if (st == STATUS_FILE)
        verify_sheet_holds(sheet, status_fail(&sheet->why, st, "%s", text));
    if (st == STATUS_OK) {
        verify_row_judge_error(r->row, r->row->error, 0);
        r->row->bar = NAN;
        if (!isfinite(r->row->error))
            r->row->error = NAN, r->row->verdict = VERDICT_DIED;
        return;
    }
    *r->row->note = '\0';
    r->row->error = NAN;
    verify_row_end(r->row,
                   st == STATUS_UNSUPPORTED || st == STATUS_INPUT ? VERDICT_NOT_APPLICABLE
                                                                  : VERDICT_DIED,
                   "%s", text);
}

void stress_add_row(struct verify_subject *s)
{
    const struct stress_case *c = case_of(s->sheet);
    struct message said = {""};
    struct judged r = {.c = c,
                       .subject = s,
                       .row = verify_sheet_add(s, "%s", c->check.item.text),
                       .why = &said};
    const double start = clock_processor();
    enum status st;

    r.xyz = arena_take(&s->sheet->arena, (size_t)2 * 3 * GRID_POINTS, sizeof *r.xyz);
    r.first = r.xyz + 3 * GRID_POINTS;
    TRY(read_run(&r, &r.run, &said));
    if (c->valence)
        TRY(give_fan(&r));
    TRY(run_build(&r.run, &said));
    st = judge(&r);
out:
    r.row->seconds = clock_processor() - start;
    kirchhoff_destroy(r.plate);
    truth_destroy(r.truth);
    run_close(&r.run);
    if (r.mesh)
        fclose(r.mesh);
    intersection_clear(&r.work);
    end_row(&r, st);
}

/* --- cases, as data --- */

/* A case is made of its name, what is hard, and a truth with its source and bound. --quick
 * has those of QUICK; ON says the net. */
#define ON(name, text, slow, side, ...) HARD(name, text, slow, side, __VA_ARGS__)
#define HARD(name, what, is_slow, side, judge, from, bound, ...)                           \
    static const struct stress_case name = {                                               \
        .check = {.item = {#name, what},                                                   \
                  .source = from,                                                          \
                  .slow = is_slow,                                                         \
                  .parts = {{&name.field, stress_add_row, 1}}},                            \
        .field = {NULL, CONTESTANT_STRESS, NULL, {side}, {side}, bound},                   \
        .truth = &judge,                                                                   \
        __VA_ARGS__}
#define CASE(name, text, ...)  ON(name, text, true, 10, __VA_ARGS__)
#define QUICK(name, text, ...) ON(name, text, false, 10, __VA_ARGS__)

/* Truths, and the reasons for their bounds. */
#define REST                                                                               \
    stress_plate,                                                                          \
        "tip at rest against the Kirchhoff plate (Ritz), relative; bound: asked of "       \
        "cures for locking",                                                               \
        0.02
#define HEAVY                                                                              \
    stress_elastica,                                                                       \
        "tip at rest against the heavy elastica, over L; bound: what the nonlinear solid " \
        "is asked for",                                                                    \
        0.01
#define VIBRATION                                                                          \
    stress_vibration,                                                                      \
        "tip in time against the Kirchhoff plate's modal solution, over its greatest "     \
        "deflection; bound: a fiftieth of the swing cannot be seen",                       \
        0.02
#define ENERGY                                                                             \
    stress_energy,                                                                         \
        "drift of the sum of energies, over the energy in play; bound: a hundredth of a "  \
        "swing cannot be seen",                                                            \
        0.01
#define SIMILAR                                                                            \
    stress_similar,                                                                        \
        "against the model's own motion in metres, kilograms and seconds, RMSE over L; "   \
        "bound: round-off, carried through 60 frames",                                     \
        1e-8
#define BUCKLED                                                                            \
    stress_buckled,                                                                        \
        "middle against Euler's elastica, over L; bound: what the nonlinear solid is "     \
        "asked for",                                                                       \
        0.01
#define STILL                                                                              \
    stress_still,                                                                          \
        "motion where there should be none, RMSE over L; bound: what iterations take for " \
        "nothing (models/mechanics/arrival.h)",                                            \
        1e-10
#define STILL_REST                                                                         \
    stress_still_rest,                                                                     \
        "motion away from the model's own equilibrium, RMSE over L; bound: a hundred "     \
        "times what the search for equilibrium leaves",                                    \
        1e-5
#define SHIFTED                                                                            \
    stress_shifted,                                                                        \
        "where it comes to rest, RMSE over L; bound: of its throw, 6e-6 is left by then",  \
        1e-3
#define SHELL                                                                              \
    stress_shell,                                                                          \
        "against a finer nonlinear shell, RMSE over L; bound: a fiftieth of the length",   \
        0.02

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
QUICK(thin_5, "h/L = 1e-5", REST, THICK("1e-5"));

#define POISSON(nu)                                                                        \
    .gamma = LIGHT / 10,                                                                   \
    .physics = {"sheet.thickness=1e-2", "material.poisson=" nu, SETTLING}
CASE(poisson_0, "nu = 0", REST, POISSON("0"));
CASE(poisson_049, "nu = 0.49", REST, POISSON("0.49"));
CASE(poisson_04999, "nu = 0.4999", REST, POISSON("0.4999"));

QUICK(narrow, "length 1000 widths", REST, .gamma = LIGHT,
      .physics = {"sheet.width=1e-3", "sheet.thickness=1e-4", "material.poisson=0",
                  SETTLING});
CASE(wide, "width 1000 lengths", REST, .gamma = LIGHT,
     .physics = {"sheet.width=1e3", "sheet.thickness=1e-2", "material.poisson=0",
                 SETTLING});

/* Nets. nu = 0: the truth is a cubic beam, nothing depends on v. */
#define KNOTS(list) .numerics = {"discretization.knots_u=" list}
ON(one_element, "one element", false, 1, REST, THICK("1e-2"));
CASE(graded_knots, "knots from 1e-6 to 0.5", REST, THICK("1e-2"),
     KNOTS("[0,0,0,1e-6,1e-5,1e-4,1e-3,0.01,0.1,0.5,1,1,1]"));
CASE(repeated_knots, "repeated knots", REST, THICK("1e-2"),
     KNOTS("[0,0,0,0.2,0.2,0.4,0.4,0.6,0.8,0.8,1,1,1]"));
CASE(torn_knots, "a knot p + 1 times", REST, THICK("1e-2"),
     KNOTS("[0,0,0,0.2,0.2,0.2,0.4,0.6,0.8,0.8,1,1,1]"));
QUICK(folded_knots, "knots that fold back", REST, THICK("1e-2"),
      KNOTS("[0,0,0,0.2,0.1,0.4,0.3,0.6,0.8,0.8,1,1,1]"));
CASE(skewed_weights, "weights 1 and 10", REST, THICK("1e-2"), .weight_ratio = 10);

/* Meshes, for nets that know them. */
#define MESHED(mesh, points)                                                               \
    .numerics = {"discretization.mesh=" mesh, "discretization.points=" points}
CASE(slivers, "a mesh of triangles 100 times as long as wide", REST, THICK("1e-2"),
     MESHED("diagonal", "[201,3]"));
CASE(two_triangles, "a mesh of two triangles", REST, THICK("1e-2"),
     MESHED("diagonal", "[2,2]"));
CASE(valence_20, "a mesh of triangles of which 20 meet at a point", REST, THICK("1e-2"),
     .numerics = {"discretization.mesh=diagonal", "discretization.refine=3"},
     .valence = 20);
CASE(slit, "a slit of a tenth of a millimetre, along the sheet", REST, .gamma = LIGHT,
     .physics = {"sheet={outline: [[0,0],[1,0],[1,1],[0,1]], thickness: 1e-2, "
                 "holes: [[[0.2,0.5],[0.8,0.5],[0.8,0.5001],[0.2,0.5001]]]}",
                 "material.poisson=0", SETTLING});
CASE(many_triangles, "an irregular mesh of 200,000 triangles", STILL,
     MESHED("irregular", "[318,318]"),
     .physics = {"gravity=[0,0,0]", "time={step: 0.005, end: 0.01}"});

/* Weight against bending, from a card to fabrics of 1 m. */
#define SLOW                                                                               \
    .physics = {"sheet.thickness=1e-3", "material.poisson=0",                              \
                "damping={kind: mass, value: 10}", "time={step: 0.01, end: 6}"}
CASE(gamma_8, "Gamma = 8", HEAVY, .gamma = 8, SLOW);
QUICK(gamma_1000, "Gamma = 1000", HEAVY, .gamma = 1000, SLOW);
CASE(gamma_100000, "Gamma = 100000", HEAVY, .gamma = 1e5, SLOW);

/* The same vibration, period 0.13 s and 1.3 s. */
CASE(step_small, "steps of 0.1 ms, 1/1300 period", VIBRATION, .gamma = LIGHT,
     .physics = {"sheet.thickness=1e-2", "material.poisson=0",
                 "time={step: 1e-4, end: 0.1}"});
QUICK(step_large, "steps of 0.1 s, 1/13 period", VIBRATION, .gamma = LIGHT,
      .physics = {"sheet.thickness=1e-2", "material.poisson=0", "gravity=[0,0,-0.0981]",
                  "time={step: 0.1, end: 1}"});

/* The same motion at the same Gamma. Pulled sideways and along, too, so that nothing
 * vanishes by symmetry. */
#define PULLED                                                                             \
    .gamma = 3,                                                                            \
    .physics = {"gravity=[1,2,-9.81]", "sheet.thickness=0.01",                             \
                "damping={kind: mass, value: 0.5}", "time={step: 0.0025, end: 0.15}"}
QUICK(millimetres, "mm, kg, s", SIMILAR, PULLED, .length = 1e-3, .mass = 1, .time = 1);
CASE(inches, "inch, slinch, s", SIMILAR, PULLED, .length = 0.0254, .mass = 175.126836,
     .time = 1);
CASE(soft, "E/rho a 1000th, Gamma the same", SIMILAR, PULLED, .length = 1, .mass = 1,
     .time = 0.0316227766016838);
CASE(stiff, "E/rho 1000 times, Gamma the same", SIMILAR, PULLED, .length = 1, .mass = 1,
     .time = 31.6227766016838);

/* The sheet of the pendulum table C0, 50 s. */
ON(swing_10000, "10,000 steps of undamped swing", true, 6, ENERGY,
   .physics = {"sheet.thickness=5e-3", "material={young: 1e5, poisson: 0, density: 0.3}",
               "time={step: 0.005, end: 50}"});
CASE(violent_drop, "dropped at 1000 g", ENERGY, .gamma = 1e5,
     .physics = {"sheet.thickness=5e-3", "gravity=[0,0,-9810]",
                 "time={step: 1e-3, end: 0.1}"});

/* Kuhl and Crisfield (1999) spin a stiff bar, on which average acceleration gains energy
 * without end: 100 rad in steps of 0.1 rad. */
QUICK(spinning_bar, "stiff bar, 16 turns in the air", ENERGY,
      .physics = {"sheet={length: 1, width: 0.1, thickness: 0.01}",
                  "pose.origin=[-0.5,-0.05,0]",
                  "material={young: 1e9, poisson: 0, density: 1000}", "gravity=[0,0,0]",
                  "supports=[]", "motion={spin: [0,10,0]}", "time={step: 0.01, end: 10}"});

CASE(buckling, "ends 10 % nearer", BUCKLED, .gamma = 0.2,
     .physics = {"sheet.thickness=5e-3", "material.poisson=0",
                 "supports=[{at: {u: 0}, fix: xyz}, {at: {u: 1}, fix: xyz, "
                 "path: [[0,0,0,0],[1,-0.1,0,0]]}]",
                 "damping={kind: mass, value: 20}", "time={step: 0.005, end: 2}"});

QUICK(still, "nothing acts", STILL,
      .physics = {"gravity=[0,0,0]", "time={step: 0.005, end: 0.5}"});
CASE(rest_start, "starts in equilibrium", STILL_REST, .gamma = 30,
     .physics = {"sheet.thickness=0.01", "time={step: 0.005, end: 0.5}"});
QUICK(thrown, "edge jerked by L/2 in one step", SHIFTED,
      .physics = {"gravity=[0,0,0]", "sheet.thickness=0.02",
                  "material={young: 1e7, poisson: 0.3, density: 100}",
                  "supports=[{at: {u: 0}, fix: xyz, path: [[0,0,0,0],[0.005,0,0,0.5]]}]",
                  "damping={kind: mass, value: 8}", "time={step: 0.005, end: 3}"});

CASE(two_corners, "hung from two corners", SHELL, /* Gamma = 50 */
     .check.run = make_truth,
     .physics = {"sheet.thickness=5e-3", "material.young=4285",
                 "supports=[{at: {u: 0, v: 0}, fix: xyz}, {at: {u: 0, v: 1}, fix: xyz}]",
                 "time={step: 0.005, end: 0.3}"});

/* Contact. The law is that of the sheet's thickness: it starts at half of it before a body,
 * and its wall is at a quarter, which is an error of 0.25. */
#define TOUCH                                                                              \
    stress_contact,                                                                        \
        "way into the distance at which contact with a body starts, over twice that; "     \
        "more than half: through it or itself; bound: the middle surface is where a body " \
        "begins",                                                                          \
        0.5
#define SLIDE                                                                              \
    stress_slide,                                                                          \
        "mean way along the plane against the rigid block's, over L; and as of contact; "  \
        "bound: a hundredth of the length",                                                \
        0.01
#define UNDAMPED       "sheet.thickness=0.02", "material={young: 2e6, poisson: 0.3, density: 150}"
#define FELT           UNDAMPED, "damping={kind: mass, value: 2}"
#define FREE           FELT, "supports=[]"
#define FLOOR(z, more) "{plane: {point: [0,0," z "], normal: [0,0,1]" more
#define LID(z, more)   "{plane: {point: [0,0," z "], normal: [0,0,-1]" more
#define SHORT          "time={step: 0.005, end: 0.1}"

QUICK(touching, "begins where contact starts", TOUCH,
      .physics = {FREE, "obstacles=[" FLOOR("-0.01", "}}]"), SHORT});
QUICK(overlapping, "begins a quarter of h in a plane", TOUCH,
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
QUICK(stopping, "lifted at 5 m/s by a plane that stops at once", TOUCH,
      .physics = {FREE,
                  "obstacles=[" FLOOR("-0.01", "}, path: [[0,0,0,0],[0.1,0,0,0.5]]}]"),
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

#define CASES(X)                                                                           \
    X(thin_2), X(thin_3), X(thin_4), X(thin_5), X(poisson_0), X(poisson_049),              \
        X(poisson_04999), X(narrow), X(wide), X(one_element), X(graded_knots),             \
        X(repeated_knots), X(torn_knots), X(folded_knots), X(skewed_weights), X(slivers),  \
        X(two_triangles), X(valence_20), X(slit), X(many_triangles), X(gamma_8),           \
        X(gamma_1000), X(gamma_100000), X(step_small), X(step_large), X(millimetres),      \
        X(inches), X(soft), X(stiff), X(swing_10000), X(violent_drop), X(spinning_bar),    \
        X(buckling), X(still), X(rest_start), X(thrown), X(two_corners), X(touching),      \
        X(overlapping), X(coplanar), X(closing), X(crushed), X(stopping), X(struck),       \
        X(thrown_at_ball), X(pressed_fold), X(thick_contact), X(friction_0),               \
        X(friction_5), X(needles), X(flat_triangle)

#define CHECK_OF(name) &name.check
const struct verify_check *const stress_checks[] = {CASES(CHECK_OF), NULL};

#define ITEM_OF(name) &name.check.item
const struct command_item *const stress_items[] = {CASES(ITEM_OF), NULL};

/* --- the command --- */

static const struct verify_set set = {
    .command = "stress",
    .item = "case",
    .checks = stress_checks,
    .folder = "results/stress",
    .apart = true,
    .note = "met: the error is within the tolerance, which is one number a case, the same "
            "for all; MISSED: it is beyond; not applicable: the model refused. Nobody "
            "promised it, and the command does not fail. until: the time in the scene at "
            "which the run died, or at which its error was first beyond.",
};

static enum status run(struct command_line *line, struct message *why)
{
    return verify_run(&set, line, why);
}

const struct command stress_command = {
    .name = "stress",
    .summary =
        "run hard cases: thin, stiff, incompressible, long steps, odd nets, units, contact",
    .arguments = "[CASE]... [OPTION]...",
    .text =
        "Runs every contestant on hard cases, each in a process of its own with a time\n"
        "limit, and prints them as `verify` does. A run has met or MISSED the case's\n"
        "tolerance, which is the same for all, by its error against the truth that the\n"
        "case names; it is not applicable where the model refuses, with its sentence; or\n"
        "it died, with time and cause. Cases of contact also tell how near the middle of\n"
        "the sheet came to a body, and when and how deep it passed through one or\n"
        "through itself.\n",
    .examples = "stress\nstress --quick\nstress thin_5 buckling --models iga,shell\n",
    .most = 64,
    .options = verify_options,
    .section = "cases",
    .items = stress_items,
    .run = run,
};
