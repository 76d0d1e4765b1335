#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/deadline.h"
#include "bench/truth/truth_making.h"
#include "iga/support_knots.h"
#include "models/metric/metric.h"
#include "models/pattern.h"

/* --- Times, nets and steps --- */

static bool is_multiple(double t, double step)
{
    return fabs(t - round(t / step) * step) < 1e-9;
}

static int compare_times(const void *a, const void *b)
{
    const double *left = a, *right = b;

    return (*left > *right) - (*left < *right);
}

int truth_plan_times(double until, double longest, const struct scene *scene, double **time)
{
    const int frames = (int)fmin(floor(until / TRUTH_PLAN_FRAME + 1e-9), 1e6);
    int count = 0, kept = 0;
    double *t = malloc((size_t)(frames + scene->snapshot_count + 1) * sizeof *t);

    if (!t)
        return -1;
    for (int n = 1; n <= frames; n++)
        t[count++] = n / round(1 / TRUTH_PLAN_FRAME);
    for (int n = 0; n < scene->snapshot_count; n++)
        if (scene->snapshots[n] <= until && scene->snapshots[n] > 0)
            t[count++] = scene->snapshots[n];
    qsort(t, (size_t)count, sizeof *t, compare_times);
    for (int n = 0; n < count; n++)
        if (is_multiple(t[n], longest) && (!kept || t[n] > t[kept - 1] + 1e-9))
            t[kept++] = t[n];
    *time = t;
    return kept;
}

/* Tells whether a knot of so many spans lies at u (i = 0, along its sheet) or v. */
static bool has_knot(const struct scene *scene, int i, double at, int spans)
{
    if (i == 0)
        scene_sheet_at(scene, at, &at);
    return is_multiple(at, 1.0 / spans);
}

/* Returns whether so many spans a side have a knot at every edge of what is loaded; at
 * those of what is held splines have knots by themselves. */
static bool fits(const struct scene *scene, int spans)
{
    bool good = true;

    for (int n = 0; n < scene->support_count; n++)
        for (int i = 0; i < 2; i++)
            good &= scene->supports[n].lo[i] < scene->supports[n].hi[i] ||
                    has_knot(scene, i, scene->supports[n].lo[i], spans);
    for (int n = 0; n < scene->load_count; n++)
        for (int i = 0; i < 2; i++)
            good &= has_knot(scene, i, scene->loads[n].lo[i], spans) &&
                    has_knot(scene, i, scene->loads[n].hi[i], spans);
    return good;
}

enum truth_net truth_plan_net(const struct scene *scene)
{
    const struct pattern *p = scene->pattern;

    return !p ? TRUTH_SPLINES : p->mesh.nodes ? TRUTH_OWN_MESH : TRUTH_MESHES;
}

/* Gives the scene's own triangles, cut k times into four; the points of a net of a square
 * with as many triangles stand for how fine they are. */
static bool own_rung(const struct pattern *p, double frame, int k,
                     struct truth_level *level)
{
    enum { MOST = 400000 };
    const double triangles = ldexp(p->mesh.triangles, 2 * k);

    if (triangles > MOST)
        return false;
    *level = (struct truth_level){.degree = 1,
                                  .side = 1 + (int)lround(sqrt(triangles / 2)),
                                  .step = ldexp(frame, -1 - k),
                                  .net = TRUTH_OWN_MESH,
                                  .refine = k};
    return true;
}

/* Gives the k-th mesh and step: three triangles a side where splines have a span. */
static bool mesh_rung(double frame, const int *sizes, int count, int k,
                      struct truth_level *level)
{
    if (k + 1 >= count)
        return false;
    *level = (struct truth_level){.degree = 1,
                                  .side = 9 * sizes[k + 1] + 1,
                                  .step = frame / sizes[k + 1],
                                  .net = TRUTH_MESHES};
    return true;
}

bool truth_plan_rung(const struct scene *scene, double frame, int k,
                     struct truth_level *level)
{
    /* Some 1.4 apart: near enough to stop in time, far enough to show an order. */
    static const int sizes[] = {1, 2, 3, 4, 6, 9, 13, 18, 26};
    enum { DEGREE = 3, LEAST = 6, SIZES = sizeof sizes / sizeof *sizes };
    int unit = 3, first = 0, repeats = 0;

    if (truth_plan_net(scene) == TRUTH_OWN_MESH)
        return own_rung(scene->pattern, frame, k, level);
    if (scene->pattern) /* triangles, of which a span needs three a side */
        return mesh_rung(frame, sizes, SIZES, k, level);
    for (int i = 0; i < 2; i++)
        repeats = (int)fmax(repeats,
                            support_knots_repeats(scene, i, DEGREE, SUPPORT_KNOTS_SOLID));
    while (unit < 20 && !fits(scene, unit))
        unit++;
    unit = fits(scene, unit) ? unit : 3;
    while (unit * sizes[first] < LEAST)
        first++;
    if (k + first >= SIZES)
        return false;
    *level = (struct truth_level){.degree = DEGREE,
                                  .side = unit * sizes[k + first] + DEGREE + repeats,
                                  .repeats = repeats};
    /* Three spans for a piece of the frame. */
    level->step = frame / (sizes[k + first] * fmax(1, round(unit / 3.0)));
    return true;
}

double truth_plan_frame(const struct scene *scene)
{
    return TRUTH_PLAN_FRAME / ceil(TRUTH_PLAN_FRAME / scene->step - 1e-9);
}

/* --- The maker --- */

/* The number of runs from the finest back to that which is pushed at the end. */
enum { PUSHED_BEHIND = 3 };

/* The number of runs that first show something (truth_bar_judge). */
enum { LEAST_RUNS = 2 };

struct maker {
    const struct truth_runs *runs;
    const struct scene *scene;
    const struct truth_wish *wish;
    struct truth_family family[TRUTH_MODELS];
    struct run_result pushed;
    struct truth_push push;
    int pushed_side; /* points along of the finest net that was pushed                  */
    double spent;
    struct truth before;    /* what all runs but the last one made                       */
    enum truth_answer bars; /* what its bars said: TRUTH_MET, TRUTH_APART, or TRUTH_GO */
};

static double seconds_of(const struct run_result *r)
{
    return r->create_seconds + r->step_seconds;
}

/* --- What runs show --- */

static const struct run_result *finest(const struct truth_family *f)
{
    return &f->run[f->count - 1];
}

/* Returns whether a run is, up to a time, as near to the truth as one that is claimed, so
 * that what it says of the growth of a change counts. */
static bool is_near(const struct truth_family *f, const struct run_result *run,
                    const struct truth *made, double until, double length)
{
    const struct run_result *fine = finest(f);

    for (int n = 0; n < made->times && made->time[n] <= until; n++)
        if (!(metric_rmse(run->xyz[n], fine->xyz[n]) + made->error[n] <=
              TRUTH_MOST_ERROR * length))
            return false;
    return true;
}

/* Finds when the change has grown too much, and whether the run that shows it may say so.
 */
static void see_push(const struct truth_family family[TRUTH_MODELS],
                     const struct truth_push *push, const struct truth *made, double length,
                     struct truth_outlook *o)
{
    int n = 0;

    o->lost = INFINITY;
    while (n < made->times && !(made->value[n][TRUTH_GROWTH] > TRUTH_MOST_GROWTH))
        n++;
    if (n == made->times)
        return;
    o->lost = made->time[n];
    o->growth = made->value[n][TRUTH_GROWTH];
    o->blunt = !is_near(&family[push->level.model], push->plain, made, o->lost, length);
}

struct truth_outlook truth_make_look(const struct truth_family family[TRUTH_MODELS],
                                     const struct truth_push *push,
                                     const struct scene *scene, double frame,
                                     const struct truth *made, double error)
{
    static const int bar[TRUTH_MODELS] = {TRUTH_SOLID_BAR, TRUTH_SHELL_BAR};
    const double length = scene->length;
    struct truth_outlook o = {.net = truth_plan_net(scene)};
    struct truth_level next;
    bool met = true;

    for (int n = 0; n < made->times; n++) {
        const double *v = made->value[n];
        met =
            met && made->error[n] <= error * length && v[TRUTH_GROWTH] <= TRUTH_MOST_GROWTH;
        if (met)
            o.known = made->time[n];
        o.error = fmax(o.error, made->error[n] / length);
        o.difference = fmax(o.difference, v[TRUTH_DIFFERENCE] / length);
        for (int m = 0; m < TRUTH_MODELS; m++)
            if (family[m].count)
                o.model[m].bar = fmax(o.model[m].bar, v[bar[m]] / length);
    }
    for (int m = 0; m < TRUTH_MODELS; m++) {
        const struct truth_family *f = &family[m];
        o.model[m].runs = f->count;
        o.model[m].finest = f->count == TRUTH_FAMILY_MOST ||
                            !truth_plan_rung(scene, frame, f->begun + f->count, &next);
        if (f->count)
            o.model[m].seconds = seconds_of(finest(f));
    }
    see_push(family, push, made, length, &o);
    return o;
}

/* Returns what the bars say by themselves: that they are met, that they leave no room for
 * the difference of the models, or TRUTH_GO. */
static enum truth_answer read_bars(const struct truth_wish *wish,
                                   const struct truth_outlook *o)
{
    const struct truth_seen *m = o->model;

    if (o->error <= wish->error && !isfinite(o->lost))
        return TRUTH_MET;
    return m[0].runs && m[1].runs && o->difference > wish->error &&
                   m[0].bar + m[1].bar <= wish->error
               ? TRUTH_APART
               : TRUTH_GO;
}

/* Returns the model of the next run: where both bars are too large, or have to outlive it,
 * the one whose finest run took less time; else the one with the larger bar. */
static enum truth_model choose(const struct truth_wish *wish, const struct truth_outlook *o)
{
    const struct truth_seen *solid = &o->model[TRUTH_SOLID],
                            *shell = &o->model[TRUTH_SHELL];
    const bool tried = read_bars(wish, o) != TRUTH_GO;

    if (!solid->runs || !shell->runs)
        return solid->runs ? TRUTH_SOLID : TRUTH_SHELL;
    if (tried && solid->finest != shell->finest)
        return solid->finest ? TRUTH_SHELL : TRUTH_SOLID;
    if (tried || (!solid->finest && !shell->finest && solid->bar > wish->error &&
                  shell->bar > wish->error))
        return solid->seconds < shell->seconds ? TRUTH_SOLID : TRUTH_SHELL;
    return solid->bar > shell->bar ? TRUTH_SOLID : TRUTH_SHELL;
}

/* Returns what comes next, with TRUTH_GO a run of that model. Bars of coarse nets may be
 * too small, as both models have the same spans there: what they say has to outlive a run.
 */
static enum truth_answer decide(const struct truth_wish *wish,
                                const struct truth_outlook *o, enum truth_model next)
{
    if (isfinite(o->lost) && (!o->blunt || o->model[next].finest))
        return TRUTH_LOST;
    if (o->outlived)
        return read_bars(wish, o);
    if (o->model[next].finest)
        return TRUTH_FINEST;
    return o->spent + o->model[next].seconds > wish->seconds ? TRUTH_DEAR : TRUTH_GO;
}

static void tell(const struct truth_wish *wish, const struct truth_outlook *o,
                 enum truth_answer answer, enum truth_model next, char text[TRUTH_END_TEXT])
{
    const double wanted = 100 * wish->error, found = 100 * o->error;
    const bool met = read_bars(wish, o) == TRUTH_MET && !o->outlived;
    char known[128];

    if (o->known > 0)
        snprintf(known, sizeof known, "%sknown to %.3g %% up to %.3g s",
                 met ? "if a finer run leaves it so, which none has shown, " : "", wanted,
                 o->known);
    else
        snprintf(known, sizeof known, "known to %.3g %% at none of its times", wanted);
    switch (answer) {
    case TRUTH_MET:
        snprintf(text, TRUTH_END_TEXT, "%s: the error bar is %.2g %% at most", known,
                 found);
        break;
    case TRUTH_GO:
        snprintf(
            text, TRUTH_END_TEXT,
            "after %.3g s the bar is %.2g %%, and %.3g %% was requested; next%s: the %s",
            o->spent, found, wanted, met ? ", to see whether it stays so" : "",
            truth_level_word(next, o->net, TRUTH_FORM_WORD));
        break;
    case TRUTH_LOST:
        snprintf(text, TRUTH_END_TEXT,
                 "no: a change of gravity by %g has grown %.2g-fold at %.3g s, from where "
                 "on nothing can be claimed; %s (--until asks for an earlier end)",
                 TRUTH_PERTURBATION, o->growth, o->lost, known);
        break;
    case TRUTH_APART:
        snprintf(text, TRUTH_END_TEXT,
                 "no: %s and %s differ by %.2g %%, and their own bars, %.2g %% and "
                 "%.2g %%, do not explain it%s; %s",
                 truth_level_word(TRUTH_SOLID, o->net, TRUTH_FORM_WORD),
                 truth_level_word(TRUTH_SHELL, o->net, TRUTH_FORM_WORD),
                 100 * o->difference, 100 * o->model[TRUTH_SOLID].bar,
                 100 * o->model[TRUTH_SHELL].bar,
                 o->net ? "" : ": this thickness makes them two sheets", known);
        break;
    case TRUTH_DEAR:
        snprintf(text, TRUTH_END_TEXT,
                 "no: the bar is %.2g %%, its runs took %.3g s, and the budget of %.3g s "
                 "has no time for a finer one; %s (a larger --budget goes on from here)",
                 found, o->spent, wish->seconds, known);
        break;
    case TRUTH_FINEST:
        snprintf(text, TRUTH_END_TEXT, "no: the finest nets leave %.2g %%; %s", found,
                 known);
        break;
    }
}

enum truth_answer truth_make_judge(const struct truth_wish *wish,
                                   const struct truth_outlook *o, enum truth_model *next,
                                   char text[TRUTH_END_TEXT])
{
    *next = choose(wish, o);
    const enum truth_answer a = decide(wish, o, *next);
    tell(wish, o, a, *next, text);
    return a;
}

/* --- Runs --- */

/* Makes one more run of a model. */
static enum status add_run(struct maker *k, enum truth_model model, struct message *why)
{
    struct truth_family *f = &k->family[model];
    struct truth_level *level = &f->level[f->count];
    char text[TRUTH_BAR_LEVEL];

    truth_plan_rung(k->scene, k->runs->frame, f->begun + f->count, level);
    level->model = model;
    truth_bar_level(level, false, text);
    if (k->runs->say && deadline_left(k->runs->until) > 0)
        fprintf(k->runs->say, "truth: %s\n", text);
    CALL(truth_level_find(k->runs, level, &f->run[f->count], why));
    k->spent += seconds_of(&f->run[f->count++]);
    return STATUS_OK;
}

/* The last rung that may be too coarse to live: 21 points a side of most scenes. */
enum { COARSE = 3 };

/* Makes one of the first runs of a model. A net that is so coarse that it dies says nothing
 * of finer ones, and those before it no more: the model begins behind it. */
static enum status begin_run(struct maker *k, enum truth_model model, struct message *why)
{
    struct truth_family *f = &k->family[model];
    const enum status st = add_run(k, model, why);
    const int died = f->begun + f->count;

    if (!status_is_death(st) || died > COARSE)
        return st;
    if (k->runs->say)
        fprintf(k->runs->say, "truth: %s; it begins with a finer net\n", why->text);
    truth_family_clear(f);
    f->count = 0, f->begun = died + 1;
    return STATUS_OK;
}

/* Returns whether a model that came to this leaves the other one alone. */
static bool leaves_other(enum status st)
{
    return st == STATUS_UNSUPPORTED || st == STATUS_LATE || status_is_death(st);
}

/* Makes `count` runs of each model that doesn't refuse the scene, in turn; fewer where the
 * budget ends, and none of a model that did not come to two. */
static enum status begin(struct maker *k, int count, struct message *why)
{
    const enum truth_model first = k->wish->shell ? TRUTH_SHELL : TRUTH_SOLID;
    struct message said[TRUTH_MODELS] = {{""}, {""}};
    enum status st[TRUTH_MODELS] = {STATUS_OK, STATUS_OK};
    int serve = 0;

    for (int n = 0; n < count; n++)
        for (enum truth_model m = first; m < TRUTH_MODELS; m++)
            while (st[m] == STATUS_OK && k->family[m].count <= n)
                st[m] = begin_run(k, m, &said[m]);
    for (enum truth_model m = first; m < TRUTH_MODELS; m++) {
        if (st[m] == STATUS_LATE && k->family[m].count >= LEAST_RUNS)
            st[m] = STATUS_OK;
        if (st[m] != STATUS_OK && !(k->wish->alone && leaves_other(st[m])))
            return status_fail(why, st[m], "%s", said[m].text);
        if (st[m] != STATUS_OK)
            k->family[m].count = 0;
        serve += st[m] == STATUS_OK;
    }
    const int which = st[first] != STATUS_LATE && st[TRUTH_SHELL] == STATUS_LATE
                          ? TRUTH_SHELL
                          : (int)first;
    return serve ? STATUS_OK : status_fail(why, st[which], "%s", said[which].text);
}

static enum status push(struct maker *k, const struct truth_family *f, int run,
                        struct message *why)
{
    enum status st;

    run_result_clear(&k->pushed);
    k->push = (struct truth_push){f->level[run], &f->run[run], &k->pushed};
    k->push.level.perturbed = true;
    st = truth_level_find(k->runs, &k->push.level, &k->pushed, why);
    if (st == STATUS_LATE) /* nothing is known of the growth then */
        k->push.pushed = k->push.plain;
    else if (st != STATUS_OK)
        return st;
    else
        k->spent += seconds_of(&k->pushed);
    k->pushed_side = (int)fmax(k->pushed_side, f->level[run].side);
    return STATUS_OK;
}

/* Returns the family whose runs are pushed: the solid's, or the shell's where that is
 * alone. */
static const struct truth_family *pushed_family(const struct maker *k)
{
    return &k->family[k->family[TRUTH_SOLID].count ? TRUTH_SOLID : TRUTH_SHELL];
}

/* Finds the third of the finest runs, to be pushed: a coarse net may not show how fast a
 * change grows, and the finest is expensive. False: one as fine was pushed, or there is no
 * budget. */
static bool find_finer(const struct maker *k, int *run)
{
    const struct truth_family *f = pushed_family(k);

    *run = f->count - PUSHED_BEHIND;
    return *run >= 0 && k->pushed_side < f->level[*run].side &&
           k->spent + seconds_of(&f->run[*run]) <= k->wish->seconds;
}

/* Returns whether the last run moved the truth by no more than the bar that it had. */
static bool is_within(const struct truth *before, const struct truth *made)
{
    double moved = 0, bar = 0;

    for (int n = 0; n < made->times; n++) {
        moved = fmax(moved, metric_rmse(before->xyz[n], made->xyz[n]));
        bar = fmax(bar, before->error[n]);
    }
    return moved <= bar;
}

static struct truth_outlook look(struct maker *k, struct truth *made)
{
    struct truth_outlook o;

    truth_bar_judge(k->family, &k->push, k->scene->length, made);
    o = truth_make_look(k->family, &k->push, k->scene, k->runs->frame, made,
                        k->wish->error);
    o.spent = k->spent;
    o.outlived = k->bars != TRUTH_GO && k->bars == read_bars(k->wish, &o) &&
                 is_within(&k->before, made);
    return o;
}

/* Finds the cheapest run that may say what becomes of a change up to a time; false: none
 * may. */
static bool find_near(const struct maker *k, const struct truth *made, double until,
                      const struct truth_family **family, int *run)
{
    double least = INFINITY;

    for (int m = 0; m < TRUTH_MODELS; m++)
        for (int n = 0; n < k->family[m].count; n++) {
            const struct truth_family *f = &k->family[m];
            const double seconds = seconds_of(&f->run[n]);
            if (seconds >= least || !is_near(f, &f->run[n], made, until, k->scene->length))
                continue;
            least = seconds;
            *family = f;
            *run = n;
        }
    return isfinite(least);
}

/* Looks at the runs. A net too coarse to know the motion does not say that it is lost: the
 * push is made again on one that does, as soon as there is one and the budget has its time.
 */
static enum status look_again(struct maker *k, struct truth *made, struct truth_outlook *o,
                              struct message *why)
{
    const struct truth_family *f = NULL;
    int run = 0;

    *o = look(k, made);
    while (o->blunt && find_near(k, made, o->lost, &f, &run) &&
           k->spent + seconds_of(&f->run[run]) <= k->wish->seconds) {
        CALL(push(k, f, run, why));
        *o = look(k, made);
    }
    return STATUS_OK;
}

/* Makes runs until there is an answer. */
static enum status work(struct maker *k, struct truth *made, struct truth_outlook *o,
                        struct truth_end *end, struct message *why)
{
    enum truth_model next;
    enum status st = STATUS_OK;
    int finer;

    for (;;) {
        CALL(look_again(k, made, o, why));
        end->answer = truth_make_judge(k->wish, o, &next, end->text);
        if (end->answer == TRUTH_GO) {
            if (k->runs->say)
                fprintf(k->runs->say, "truth: %s\n", end->text);
            st = add_run(k, next, why);
            if (st == STATUS_LATE) {
                end->answer = TRUTH_DEAR;
                tell(k->wish, o, end->answer, next, end->text);
                return STATUS_OK;
            }
            CALL(st);
            const struct truth older = k->before;
            k->before = *made;
            *made = older;
            k->bars = read_bars(k->wish, o);
        } else if (end->answer != TRUTH_LOST && find_finer(k, &finer)) {
            CALL(push(k, pushed_family(k), finer, why));
        } else {
            return STATUS_OK;
        }
    }
    return STATUS_OK;
}

enum status truth_make(const struct truth_runs *runs, const struct scene *scene,
                       const struct truth_wish *wish, struct truth *made,
                       struct truth_end *end, struct message *why)
{
    struct maker k = {.runs = runs, .scene = scene, .wish = wish, .bars = TRUTH_GO};
    struct truth_outlook o;
    enum status st;

    truth_init(made, runs->times, runs->times, runs->time);
    truth_init(&k.before, runs->times, runs->times, runs->time);
    /* Nodes of a coarse net touch an obstacle one by one, in jumps that are the net's. */
    TRY(begin(&k, scene->obstacle_count ? LEAST_RUNS + 1 : LEAST_RUNS, why));
    const struct truth_family *f = pushed_family(&k);
    TRY(push(&k, f, f->count - 1, why));
    TRY(work(&k, made, &o, end, why));
    end->known = o.known;
    made->outlined = scene->pattern;
    truth_bar_horizon(&k.push, o.blunt, made->times, made->time, scene->length,
                      made->horizon);
out:
    for (int m = 0; m < TRUTH_MODELS; m++)
        truth_family_clear(&k.family[m]);
    run_result_clear(&k.pushed);
    truth_clear(&k.before);
    if (st != STATUS_OK)
        truth_clear(made);
    return st;
}
