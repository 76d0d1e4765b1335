#include "bench/truth/truth_sharp.h"

#include <math.h>

#include "bench/harness/deadline.h"
#include "bench/truth/truth_plan.h"
#include "models/metric/metric.h"

/* Steps, unknowns, bandwidth: between the assembly alone and the factors alone. Two runs
 * tell, within these. */
static const double DEARER_LEAST = 3, DEARER_MOST = 5;

/* Runs from the finest back to that which is pushed at the end. */
enum { PUSHED_BEHIND = 3 };

struct sharp {
    const struct truth_runs *runs;
    const struct scene *scene;
    double frame;
    const struct truth_wish *wish;
    struct truth_family family[TRUTH_MODELS];
    struct run_result pushed;
    struct truth_push push;
    int pushed_side; /* points along of the finest net that was pushed                  */
    FILE *say;
    double spent;
};

static double seconds_of(const struct run_result *r)
{
    return r->create_seconds + r->step_seconds;
}

static bool rung_of(const struct scene *scene, double frame, int model, int k,
                    struct truth_level *level)
{
    const bool there = k < TRUTH_FAMILY_MOST && truth_plan_rung(scene, frame, k, level);

    level->model = model == TRUTH_SOLID ? TRUTH_SELECTIVE : TRUTH_CURED;
    return there;
}

/* One run more of a model. */
static enum status add_run(struct sharp *s, int model, struct message *why)
{
    struct truth_family *f = &s->family[model];
    const int k = f->count;
    char text[TRUTH_BAR_LEVEL];
    enum status st;

    rung_of(s->scene, s->frame, model, k, &f->level[k]);
    truth_bar_level(&f->level[k], false, text);
    if (s->say && deadline_left() > 0)
        fprintf(s->say, "truth: %s\n", text);
    TRY(truth_level_find(s->runs, &f->level[k], false, &f->run[k], why));
    f->count++;
    s->spent += seconds_of(&f->run[k]);
out:
    return st;
}

/* Whether a model that came to this leaves the other one alone. */
static bool leaves_other(enum status st)
{
    return st == STATUS_UNSUPPORTED || st == STATUS_LATE || status_is_death(st);
}

/* Two runs of a model first show something (truth_bar_compare). */
enum { LEAST_RUNS = 2 };

/* `count` runs of each model that serves the scene, in turn; fewer where the budget ends,
 * and none of a model that did not come to two. */
static enum status begin(struct sharp *s, int count, struct message *why)
{
    struct message said[TRUTH_MODELS] = {{""}, {""}};
    enum status st[TRUTH_MODELS] = {STATUS_OK, STATUS_OK};
    int serve = 0;

    for (int n = 0; n < count; n++)
        for (int m = 0; m < TRUTH_MODELS; m++)
            if (st[m] == STATUS_OK)
                st[m] = add_run(s, m, &said[m]);
    for (int m = 0; m < TRUTH_MODELS; m++) {
        s->family[m].joint = true;
        if (st[m] == STATUS_LATE && s->family[m].count >= LEAST_RUNS)
            st[m] = STATUS_OK;
        if (st[m] != STATUS_OK && !(s->wish->alone && leaves_other(st[m])))
            return status_fail(why, st[m], "%s", said[m].text);
        if (st[m] != STATUS_OK)
            s->family[m].count = 0;
        serve += st[m] == STATUS_OK;
    }
    const int which = st[0] != STATUS_LATE && st[1] == STATUS_LATE;
    return serve ? STATUS_OK : status_fail(why, st[which], "%s", said[which].text);
}

static enum status push(struct sharp *s, const struct truth_family *f, int k,
                        struct message *why)
{
    enum status st;

    run_result_clear(&s->pushed);
    s->push = (struct truth_push){f->level[k], &f->run[k], &s->pushed};
    s->push.level.perturbed = true;
    st = truth_level_find(s->runs, &s->push.level, false, &s->pushed, why);
    if (st == STATUS_LATE) { /* nothing is known of the growth then */
        s->push.pushed = s->push.plain;
        s->pushed_side = f->level[k].side;
        return STATUS_OK;
    }
    TRY(st);
    s->spent += seconds_of(&s->pushed);
    if (f->level[k].side > s->pushed_side)
        s->pushed_side = f->level[k].side;
out:
    return st;
}

/* Whose runs are pushed: the solid's, or the shell's where that is alone. */
static const struct truth_family *pushed_family(const struct sharp *s)
{
    return &s->family[s->family[TRUTH_SOLID].count ? TRUTH_SOLID : TRUTH_SHELL];
}

static enum status push_first(struct sharp *s, struct message *why)
{
    const struct truth_family *f = pushed_family(s);

    return push(s, f, f->count - 1, why);
}

/* A coarse net may not show how fast a change grows, and the finest is dear: the third of
 * the finest. False: one as fine was pushed, or there is no budget. */
static bool find_finer(const struct sharp *s, int *run)
{
    const struct truth_family *f = pushed_family(s);

    *run = f->count - PUSHED_BEHIND;
    return *run >= 0 && s->pushed_side < f->level[*run].side &&
           s->spent + seconds_of(&f->run[*run]) <= s->wish->seconds;
}

/* The index of the order of a model among the columns, the bar two after it. */
static int columns_of(int model)
{
    return model == TRUTH_SOLID ? TRUTH_SOLID_SPACE : TRUTH_SHELL_SPACE;
}

static double spans_of(const struct truth_level *level)
{
    return level->side - level->degree - level->repeats;
}

/* The largest bar of a model, and the order seen there. */
static void see_bar(const struct truth_made *made, int model, double length,
                    struct truth_seen *seen)
{
    const int order = columns_of(model), bar = order + 2;

    for (int n = 0; n < made->times; n++)
        if (n == 0 || made->value[n][bar] > seen->bar * length) {
            seen->bar = made->value[n][bar] / length;
            seen->order = made->value[n][order];
        }
}

/* What its last two runs took. */
static void see_cost(const struct truth_family *f, struct truth_seen *seen)
{
    const int last = f->count - 1;
    const double finer = spans_of(&f->level[last]) / spans_of(&f->level[last - 1]);

    seen->seconds = seconds_of(&f->run[last]);
    seen->dearer = log(seen->seconds / seconds_of(&f->run[last - 1])) / log(finer);
    seen->dearer = fmin(DEARER_MOST, fmax(DEARER_LEAST, seen->dearer));
}

/* Up to a time a run is as near to the truth as one that is claimed: what it says of the
 * growth of a change is heard. */
static bool is_near(const struct truth_family *f, const struct run_result *run,
                    const struct truth_made *made, double until, double length)
{
    const struct run_result *fine = truth_bar_finest(f);

    for (int n = 0; n < made->times && made->time[n] <= until; n++)
        if (!(metric_rmse(run->xyz[n], fine->xyz[n]) + made->value[n][TRUTH_ERROR] <=
              TRUTH_MOST_ERROR * length))
            return false;
    return true;
}

/* From when on the change has grown beyond, and whether the run it was seen in may say so.
 */
static void see_push(const struct truth_family family[TRUTH_MODELS],
                     const struct truth_push *push, const struct truth_made *made,
                     double length, struct truth_outlook *o)
{
    int n = 0;

    o->lost = INFINITY;
    while (n < made->times && !(made->value[n][TRUTH_GROWTH] > TRUTH_MOST_GROWTH))
        n++;
    if (n == made->times)
        return;
    o->lost = made->time[n];
    o->growth = made->value[n][TRUTH_GROWTH];
    o->blunt = !is_near(&family[truth_level_kind(push->level.model)], push->plain, made,
                        o->lost, length);
}

struct truth_outlook truth_sharp_look(const struct truth_family family[TRUTH_MODELS],
                                      const struct truth_push *push,
                                      const struct scene *scene, double frame,
                                      const struct truth_made *made, double error)
{
    const double length = scene->length;
    struct truth_outlook o = {0};
    struct truth_level next;

    for (int m = 0; m < TRUTH_MODELS; m++) {
        const struct truth_family *f = &family[m];
        o.model[m].runs = f->count;
        if (!f->count)
            continue;
        see_bar(made, m, length, &o.model[m]);
        see_cost(f, &o.model[m]);
        if (rung_of(scene, frame, m, f->count, &next))
            o.model[m].next = spans_of(&f->level[f->count - 1]) / spans_of(&next);
    }
    for (int n = 0; n < made->times; n++) {
        const double *v = made->value[n];
        o.error = fmax(o.error, v[TRUTH_ERROR] / length);
        o.difference = fmax(o.difference, v[TRUTH_DIFFERENCE] / length);
    }
    see_push(family, push, made, length, &o);
    o.known = truth_wish_known(made, error * length);
    o.until = made->time[made->times - 1];
    return o;
}

static struct truth_outlook look(struct sharp *s, struct truth_made *made)
{
    struct truth_outlook o;

    truth_bar_compare(s->family, &s->push, s->scene->length, made);
    truth_made_bar(made, s->scene->length);
    o = truth_sharp_look(s->family, &s->push, s->scene, s->frame, made, s->wish->error);
    o.spent = s->spent;
    return o;
}

/* The cheapest run that may say what becomes of a change up to a time; false: none may. */
static bool find_near(const struct sharp *s, const struct truth_made *made, double until,
                      const struct truth_family **family, int *run)
{
    double least = INFINITY;

    for (int m = 0; m < TRUTH_MODELS; m++)
        for (int k = 0; k < s->family[m].count; k++) {
            const struct truth_family *f = &s->family[m];
            const double seconds = seconds_of(&f->run[k]);
            if (seconds >= least || !is_near(f, &f->run[k], made, until, s->scene->length))
                continue;
            least = seconds;
            *family = f;
            *run = k;
        }
    return isfinite(least);
}

/* A net too coarse to know the motion does not say that it is lost: the push is made again
 * on one that does, as soon as there is one and the budget has its time. */
static enum status look_again(struct sharp *s, const struct truth_sharp *how,
                              struct truth_made *made, struct truth_outlook *o,
                              struct message *why)
{
    const struct truth_family *f = NULL;
    char text[TRUTH_BAR_LEVEL];
    enum status st = STATUS_OK;
    int k = 0;

    *o = look(s, made);
    while (o->blunt && find_near(s, made, o->lost, &f, &k) &&
           s->spent + seconds_of(&f->run[k]) <= s->wish->seconds) {
        truth_bar_level(&f->level[k], false, text);
        if (how->say)
            fprintf(how->say,
                    "truth: a change has grown %.2g-fold at %.3g s on a net too coarse to "
                    "tell; once more on the %s, %.2g s\n",
                    o->growth, o->lost, text, seconds_of(&f->run[k]));
        TRY(push(s, f, k, why));
        *o = look(s, made);
    }
out:
    return st;
}

enum status truth_sharp_make(const struct truth_runs *runs, const struct scene *scene,
                             const struct truth_sharp *how, const struct truth_wish *wish,
                             struct truth_made *made, struct truth_verdict *verdict,
                             char text[TRUTH_WISH_TEXT], struct message *why)
{
    struct sharp s = {
        .runs = runs, .scene = scene, .frame = how->frame, .wish = wish, .say = how->say};
    struct truth_outlook o;
    enum status st;
    int finer;

    TRY(truth_made_init(made, runs->times, runs->times, runs->time));
    /* Nodes of a coarse net touch an obstacle one by one, in jumps that are the net's. */
    TRY(begin(&s, scene->obstacle_count ? 3 : 2, why));
    TRY(push_first(&s, why));
    for (;;) {
        TRY(look_again(&s, how, made, &o, why));
        *verdict = truth_wish_judge(wish, &o);
        truth_wish_tell(wish, &o, verdict, text);
        if (verdict->answer == TRUTH_GO) {
            if (how->say)
                fprintf(how->say, "truth: %s\n", text);
            st = add_run(&s, verdict->next, why);
            if (st == STATUS_LATE) {
                verdict->answer = TRUTH_DEAR;
                truth_wish_tell(wish, &o, verdict, text);
                break;
            }
            TRY(st);
        } else if (verdict->answer != TRUTH_LOST && find_finer(&s, &finer)) {
            TRY(push(&s, pushed_family(&s), finer, why));
        } else {
            break;
        }
    }
    truth_bar_choose(s.family, scene->length, made);
    st = STATUS_OK;
    truth_bar_horizon(&s.push, o.blunt, made->times, made->time, scene->length,
                      made->horizon);
out:
    for (int m = 0; m < TRUTH_MODELS; m++)
        truth_family_clear(&s.family[m]);
    run_result_clear(&s.pushed);
    if (st != STATUS_OK)
        truth_made_clear(made);
    return st;
}
