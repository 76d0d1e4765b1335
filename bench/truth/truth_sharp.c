#include "bench/truth/truth_sharp.h"

#include <math.h>

#include "bench/truth/truth_plan.h"

/* Steps, unknowns, bandwidth: between the assembly alone and the factors alone. Two runs
 * tell, within these. */
static const double DEARER_LEAST = 3, DEARER_MOST = 5;

struct sharp {
    const struct truth_runs *runs;
    const struct scene *scene;
    double frame;
    const struct truth_wish *wish;
    struct truth_family family[TRUTH_MODELS];
    struct run_result pushed;
    struct truth_push push;
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

    level->model = model == TRUTH_SOLID ? TRUTH_SOLID : TRUTH_CURED;
    return there;
}

/* One run more of a model. */
static enum status add_run(struct sharp *s, int model, struct message *why)
{
    struct truth_family *f = &s->family[model];
    const int k = f->count;
    enum status st;

    rung_of(s->scene, s->frame, model, k, &f->level[k]);
    TRY(truth_level_find(s->runs, &f->level[k], false, &f->run[k], why));
    f->count++;
    s->spent += seconds_of(&f->run[k]);
out:
    return st;
}

/* `count` runs of each model that serves the scene. */
static enum status begin(struct sharp *s, int count, struct message *why)
{
    struct message said[TRUTH_MODELS] = {{""}, {""}};
    enum status st = STATUS_OK;
    int serve = 0;

    for (int m = 0; m < TRUTH_MODELS; m++) {
        s->family[m].joint = true;
        st = STATUS_OK;
        for (int n = 0; n < count && st == STATUS_OK; n++)
            st = add_run(s, m, &said[m]);
        if (st != STATUS_OK && (st != STATUS_UNSUPPORTED || !s->wish->alone))
            return status_fail(why, st, "%s", said[m].text);
        if (st != STATUS_OK)
            s->family[m].count = 0;
        serve += st == STATUS_OK;
    }
    return serve ? STATUS_OK : status_fail(why, STATUS_UNSUPPORTED, "%s", said[0].text);
}

/* The finest of the first runs of the solid, or of the shell where that is alone. */
static enum status push(struct sharp *s, struct message *why)
{
    const struct truth_family *f =
        &s->family[s->family[TRUTH_SOLID].count ? TRUTH_SOLID : TRUTH_SHELL];
    const int k = f->count - 1;
    enum status st;

    s->push = (struct truth_push){f->level[k], &f->run[k], &s->pushed};
    s->push.level.perturbed = true;
    TRY(truth_level_find(s->runs, &s->push.level, false, &s->pushed, why));
    s->spent += seconds_of(&s->pushed);
out:
    return st;
}

/* The index of the order of a model among the columns, the bar two after it. */
static int columns_of(int model)
{
    return model == TRUTH_SOLID ? TRUTH_SOLID_SPACE : TRUTH_SHELL_SPACE;
}

static double spans_of(const struct truth_level *level)
{
    return level->side - level->degree;
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

struct truth_outlook truth_sharp_look(const struct truth_family family[TRUTH_MODELS],
                                      const struct scene *scene, double frame,
                                      const struct truth_made *made, double error)
{
    const double length = scene->length;
    struct truth_outlook o = {.lost = INFINITY};
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
        if (!isfinite(o.lost) && v[TRUTH_GROWTH] > TRUTH_MOST_GROWTH) {
            o.lost = made->time[n];
            o.growth = v[TRUTH_GROWTH];
        }
    }
    o.known = truth_wish_known(made, error * length);
    o.until = made->time[made->times - 1];
    return o;
}

static struct truth_verdict judge(struct sharp *s, struct truth_made *made,
                                  char text[TRUTH_WISH_TEXT])
{
    struct truth_verdict v;
    struct truth_outlook o;

    truth_bar_compare(s->family, &s->push, s->scene->length, made);
    truth_made_choose(made, s->scene->length);
    o = truth_sharp_look(s->family, s->scene, s->frame, made, s->wish->error);
    o.spent = s->spent;
    v = truth_wish_judge(s->wish, &o);
    truth_wish_tell(s->wish, &o, &v, text);
    return v;
}

enum status truth_sharp_make(const struct truth_runs *runs, const struct scene *scene,
                             const struct truth_sharp *how, const struct truth_wish *wish,
                             struct truth_made *made, struct truth_verdict *verdict,
                             char text[TRUTH_WISH_TEXT], struct message *why)
{
    struct sharp s = {.runs = runs, .scene = scene, .frame = how->frame, .wish = wish};
    enum status st;

    TRY(truth_made_init(made, runs->times, runs->times, runs->time));
    /* Nodes of a coarse net touch an obstacle one by one, in jumps that are the net's. */
    TRY(begin(&s, scene->obstacle_count ? 3 : 2, why));
    TRY(push(&s, why));
    for (;;) {
        *verdict = judge(&s, made, text);
        if (verdict->answer != TRUTH_GO)
            break;
        if (how->say)
            fprintf(how->say, "truth: %s\n", text);
        TRY(add_run(&s, verdict->next, why));
    }
    truth_bar_choose(s.family, scene->length, made);
    truth_bar_horizon(&s.push, made->times, made->time, scene->length, made->horizon);
out:
    for (int m = 0; m < TRUTH_MODELS; m++)
        truth_family_clear(&s.family[m]);
    run_result_clear(&s.pushed);
    if (st != STATUS_OK)
        truth_made_clear(made);
    return st;
}
