/* protocol_judge.c - verdicts on the frames of one simulator, as sentences with numbers. */
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "bench/score/protocol.h"
#include "bench/truth/truth_parts.h"

/* Fields closer to each other than this share of the length are the same: positions in
 * single precision are rounded by less. */
static const double SAME = 1e-6;

/* Nets that approach a limit more slowly than by this order do not show that they do, and
 * no simulator of cloth is expected to do it faster than PROMISED. */
static const double ORDER_LEAST = 0.5, PROMISED = 2;

/* A stiffness counts as the scene's within the method's own error. */
static const double STIFF_ERROR = 0.03;

/* It means something that a flaw was not found in a run if what was found leaves at most
 * this share of the difference. */
static const double CLEAR = 0.25;

struct judge {
    const struct protocol *p;
    void (*say)(void *context, const struct protocol_verdict *v);
    void *context;
};

const char *protocol_subject_name(enum protocol_subject subject)
{
    static const char *const name[] = {PROTOCOL_SUBJECT_LIST(LIST_WORD)};

    return name[subject];
}

static void __attribute__((format(printf, 5, 6)))
tell(const struct judge *j, enum protocol_subject subject, enum protocol_tone tone,
     const char *word, const char *format, ...)
{
    struct protocol_verdict v = {.subject = subject, .tone = tone};
    va_list args;

    snprintf(v.word, sizeof v.word, "%s", word);
    va_start(args, format);
    vsnprintf(v.text, sizeof v.text, format, args);
    va_end(args);
    j->say(j->context, &v);
}

static const struct score_finding *find(const struct protocol_run *run,
                                        enum score_kind kind)
{
    for (int n = 0; run && n < run->diagnosis.count; n++)
        if (run->diagnosis.finding[n].kind == kind)
            return &run->diagnosis.finding[n];
    return NULL;
}

/* Returns whether nothing is wrong with a run, or a fit explains its motion. */
static bool is_explained(const struct protocol_run *run)
{
    static const enum score_kind fitted[] = {
        SCORE_SOUND,   SCORE_FLOOR,   SCORE_FIRST_ORDER_STEP,
        SCORE_LAG,     SCORE_GRAVITY, SCORE_DAMPING,
        SCORE_BENDING, SCORE_HINGE,   SCORE_CLAMP};

    for (size_t n = 0; n < sizeof fitted / sizeof *fitted; n++)
        if (find(run, fitted[n]))
            return true;
    return false;
}

/* Returns the run on the finest net of a scene that is explained; NULL: there is none. */
static const struct protocol_run *explained(const struct judge *j, const char *name)
{
    const struct protocol_scene *scene = protocol_find(j->p, name);

    for (int n = scene ? scene->runs - 1 : -1; n >= 0; n--)
        if (protocol_is_first(scene, n) && is_explained(&scene->run[n]))
            return &scene->run[n];
    return NULL;
}

/* --- errors and flaws --- */

static void tell_error(const struct judge *j, const struct protocol_scene *scene)
{
    const struct protocol_run *run = protocol_finest(scene);
    const struct score_time *worst = protocol_worst(run);
    const bool sound = find(run, SCORE_SOUND) || find(run, SCORE_FLOOR);

    tell(j, PROTOCOL_ERROR, sound ? PROTOCOL_GOOD : PROTOCOL_NEUTRAL,
         sound ? "sound" : "off",
         "On %s its error is at most %.3g %% of the length (%dx%d points, at %.4g s; error "
         "bar of the truth %.3g %%, floor of the net %.3g %%).",
         scene->name, 100 * worst->error, run->net[0], run->net[1], worst->time,
         100 * worst->bar, 100 * worst->floor);
}

static void tell_missing(const struct judge *j)
{
    char names[160] = "";

    for (const char *const *name = protocol_first; *name; name++)
        if (!protocol_find(j->p, *name))
            TEXT_JOIN(names, ", ", "%s", *name);
    if (*names)
        tell(j, PROTOCOL_ERROR, PROTOCOL_UNKNOWN, "not run",
             "There are no frames of %s; clothbench export writes these scenes.", names);
}

/* Tells the flaws that have no subject of their own. */
static void tell_flaws(const struct judge *j, const struct protocol_scene *scene)
{
    const struct protocol_run *run = protocol_finest(scene);
    const struct score_diagnosis *d = &run->diagnosis;

    for (int n = 0; n < d->count; n++) {
        const enum score_kind kind = d->finding[n].kind;
        if (kind != SCORE_FIRST_ORDER_STEP && kind != SCORE_DAMPING &&
            kind != SCORE_BENDING && kind != SCORE_HINGE && kind != SCORE_CLAMP &&
            kind != SCORE_FLOOR && kind != SCORE_SOUND)
            tell(j, PROTOCOL_FLAW, PROTOCOL_BAD, score_diagnosis_name(kind), "%s: %s",
                 run->file, d->finding[n].text);
    }
    if (!d->count)
        tell(j, PROTOCOL_FLAW, PROTOCOL_NEUTRAL, "unexplained",
             "%s: No flaw that is known here explains the error.", run->file);
}

/* --- step, damping, clamp, stiffness --- */

/* A flaw of the motion, and the scenes on which it is looked for. */
struct motion_flaw {
    enum protocol_subject subject;
    const char *scene[2]; /* the second may be NULL                                      */
    struct {
        enum score_kind kind;
        const char *word;
    } found[2]; /* the second may have no word                                           */
    const char *without, *sentence; /* where it is not found                             */
};

static const struct motion_flaw motion_flaws[] = {
    {PROTOCOL_STEP,
     {"free_fall", "edge_drop"},
     {{SCORE_FIRST_ORDER_STEP, "first order"}},
     "second order",
     "Nothing of a first-order step is seen: the step is of second order at least"},
    {PROTOCOL_DAMPING,
     {"free_fall", "edge_drop"},
     {{SCORE_DAMPING, "damped"}},
     "none seen",
     "No damping is seen that the scene has not"},
    {PROTOCOL_CLAMP,
     {"edge_drop"},
     {{SCORE_HINGE, "a hinge"}, {SCORE_CLAMP, "gives way"}},
     "clamped",
     "The held edge is a clamp, and nothing of a hinge is seen"},
};

static void tell_motion_flaw(const struct judge *j, const struct motion_flaw *f)
{
    const struct protocol_run *clean = NULL;
    bool found = false;

    for (int k = 0; k < 2 && f->scene[k]; k++) {
        const struct protocol_run *run = explained(j, f->scene[k]);
        const struct score_finding *flaw = find(run, f->found[0].kind);
        const bool second = !flaw && f->found[1].word;
        flaw = second ? find(run, f->found[1].kind) : flaw;
        if (flaw)
            tell(j, f->subject, PROTOCOL_BAD,
                 flaw->kind == SCORE_DAMPING && flaw->value < 0 ? "gains energy"
                                                                : f->found[second].word,
                 "%s: %s", run->file, flaw->text);
        found = found || flaw;
        clean = !flaw && !clean && run && run->diagnosis.left <= CLEAR ? run : clean;
    }
    if (!found && clean)
        tell(j, f->subject, PROTOCOL_GOOD, f->without, "%s: %s.", clean->file, f->sentence);
    else if (!found)
        tell(j, f->subject, PROTOCOL_UNKNOWN, "not known",
             "It would be seen on %s%s, which %s no frames here, or flaws that hide it.",
             f->scene[0], f->scene[1] ? " or edge_drop" : "", f->scene[1] ? "have" : "has");
}

static void tell_stiffness(const struct judge *j)
{
    static const char *const part[] = {"the membrane's along the warp",
                                       "the membrane's along the weft",
                                       "bending along the warp", "bending along the weft"};
    const struct protocol_run *drop = explained(j, "edge_drop");
    const struct score_finding *bends = find(drop, SCORE_BENDING);
    bool known[2][2] = {{false}};
    char missing[200] = "";

    for (int k = 0; k < j->p->scenes; k++) {
        const struct protocol_run *run = protocol_finest(&j->p->scene[k]);
        const struct score_stiffness *s = &run->stiffness;
        if (!s->applies || (!s->found && find(run, SCORE_SOUND)))
            continue;
        const double off = fabs(s->value / s->scene - 1);
        tell(j, PROTOCOL_STIFFNESS,
             !s->found           ? PROTOCOL_BAD
             : off < STIFF_ERROR ? PROTOCOL_GOOD
                                 : PROTOCOL_NEUTRAL,
             s->found ? s->part == LAW_MEMBRANE ? "membrane" : "bending" : "none fits",
             "%s: %s", run->file, s->text);
        known[s->part != LAW_MEMBRANE][strstr(s->along, "weft") != NULL] |=
            strcmp(s->along, "u") != 0;
    }
    if (bends)
        tell(j, PROTOCOL_STIFFNESS, PROTOCOL_NEUTRAL, "bending", "%s: %s", drop->file,
             bends->text);
    for (int n = 0; n < 4; n++)
        if (!known[n / 2][n % 2])
            TEXT_JOIN(missing, ", ", "%s", part[n]);
    if (*missing)
        tell(j, PROTOCOL_STIFFNESS, PROTOCOL_UNKNOWN, "not known",
             "These stiffnesses were not measured: %s. woven_hang and woven_level show "
             "them, exported with material.warp=90 for the weft.",
             missing);
}

/* --- several nets, several runs --- */

/* Fills the rms distance over the length of the fields of `count` runs from those of the
 * first one, over all times that all of them have; *worst is the largest of the last, and
 * *when its time. Returns the number of times. */
static int compare(const struct protocol_scene *scene, int count,
                   const struct protocol_run *const *run, double *distance, double *worst,
                   double *when)
{
    int times = 0;

    *worst = 0;
    memset(distance, 0, (size_t)count * sizeof *distance);
    for (int n = 0; n < run[0]->times; n++) {
        const struct score_time *row[3] = {&run[0]->row[n]};
        double far = 0;
        bool all = true;
        for (int k = 1; k < count; k++) {
            int m = 0;
            while (m < run[k]->times && run[k]->row[m].time != row[0]->time)
                m++;
            all = all && m < run[k]->times;
            row[k] = all ? &run[k]->row[m] : NULL;
        }
        for (int k = 1; k < count && all; k++) {
            far = score_rms(SCORE_POINTS, row[k]->got, row[k - 1]->got) / scene->length;
            distance[k] += far * far;
        }
        times += all;
        if (all && far > *worst)
            *worst = far, *when = row[0]->time;
    }
    for (int k = 1; k < count; k++)
        distance[k] = sqrt(distance[k] / times);
    return times;
}

/* Lists the first run of each of the last three nets, coarse to fine; returns how many. */
static int last_nets(const struct protocol_scene *scene, const struct protocol_run *net[3])
{
    int count = 0;

    for (int n = 0; n < scene->runs; n++) {
        if (!protocol_is_first(scene, n))
            continue;
        if (count == 3)
            net[0] = net[1], net[1] = net[2], count = 2;
        net[count++] = &scene->run[n];
    }
    return count;
}

/* Returns the rms over times of the error or of the truth's bar, over the length. */
static double rms_of(const struct protocol_run *run, bool bar)
{
    double sum = 0;

    for (int n = 0; n < run->times; n++)
        sum += pow(bar ? run->row[n].bar : run->row[n].error, 2);
    return sqrt(sum / run->times);
}

/* Tells of three nets that approach a limit, by their order and the bar that it leaves. */
static void tell_limit(const struct judge *j, const struct protocol_scene *scene,
                       const struct protocol_run *const net[3],
                       const struct truth_order *order)
{
    const double error = rms_of(net[2], false), bar = order->bar + rms_of(net[2], true);
    char nets[96], limit[200];

    snprintf(nets, sizeof nets, "%dx%d, %dx%d, %dx%d", net[0]->net[0], net[0]->net[1],
             net[1]->net[0], net[1]->net[1], net[2]->net[0], net[2]->net[1]);
    if (error <= bar)
        snprintf(limit, sizeof limit,
                 "The truth is %.3g %% from the finest, so that it may be the limit.",
                 100 * error);
    else
        snprintf(limit, sizeof limit,
                 "The truth is %.3g %% from the finest: the limit is another motion, at "
                 "least %.3g %% from the truth and its bar.",
                 100 * error, 100 * (error - bar));
    tell(j, PROTOCOL_NETS, error <= bar ? PROTOCOL_GOOD : PROTOCOL_BAD,
         error <= bar ? "converges" : "to another limit",
         "On %s it converges with order %.2g in the width of the cells (%s); the finest "
         "net is up to %.3g %% of the length from the limit. %s",
         scene->name, order->order, nets, 100 * order->bar, limit);
}

/* Tells of two nets or more. */
static void tell_refined(const struct judge *j, const struct protocol_scene *scene,
                         int count, const struct protocol_run *const net[3])
{
    double apart[3], h[3], worst, when;

    const int times = compare(scene, count, net, apart, &worst, &when);
    if (times && apart[1] < SAME && (count == 2 || apart[2] < SAME)) {
        tell(j, PROTOCOL_NETS, PROTOCOL_NEUTRAL, "the same on each",
             "On %s its motion does not depend on the net.", scene->name);
        return;
    }
    if (count == 2 || !times) {
        tell(j, PROTOCOL_NETS, PROTOCOL_UNKNOWN, "not known",
             times ? "On %s there are two nets, %.3g %% of the length apart: three would "
                     "show whether it converges."
                   : "On %s the nets have no time of the truth in common.",
             scene->name, 100 * apart[1]);
        return;
    }
    for (int k = 0; k < 3; k++)
        h[k] = 1 / sqrt((net[k]->net[0] - 1.) * (net[k]->net[1] - 1.));
    const struct truth_order order = truth_order(h, apart[1], apart[2], PROMISED);
    if (order.order >= ORDER_LEAST)
        tell_limit(j, scene, net, &order);
    else
        tell(j, PROTOCOL_NETS, PROTOCOL_BAD, "does not converge",
             "On %s it does not converge: from %dx%d to %dx%d points it changes by %.3g %% "
             "of the length, from there to %dx%d by %.3g %%.",
             scene->name, net[0]->net[0], net[0]->net[1], net[1]->net[0], net[1]->net[1],
             100 * apart[1], net[2]->net[0], net[2]->net[1], 100 * apart[2]);
}

static void tell_nets(const struct judge *j)
{
    const struct protocol_run *net[3];
    char single[200] = "";

    for (int k = 0; k < j->p->scenes; k++) {
        const struct protocol_scene *scene = &j->p->scene[k];
        const int count = last_nets(scene, net);
        if (count > 1)
            tell_refined(j, scene, count, net);
        else
            TEXT_JOIN(single, ", ", "%s", scene->name);
    }
    if (*single)
        tell(j, PROTOCOL_NETS, PROTOCOL_UNKNOWN, "not known",
             "There is one net only on %s: whether it converges there is not known.",
             single);
}

/* Tells whether a repeat agrees with the run before it. */
static void tell_repeat(const struct judge *j, const struct protocol_scene *scene,
                        const struct protocol_run *const pair[2])
{
    double apart[2], worst, when = 0;
    const int times = compare(scene, 2, pair, apart, &worst, &when);

    if (!times)
        tell(j, PROTOCOL_REPEATS, PROTOCOL_UNKNOWN, "not known",
             "%s and %s have no time of the truth in common.", pair[0]->file,
             pair[1]->file);
    else if (worst <= SAME)
        tell(j, PROTOCOL_REPEATS, PROTOCOL_GOOD, "agree", "%s and %s agree%s.",
             pair[0]->file, pair[1]->file,
             worst > 0 ? " to single precision" : " to the last digit");
    else
        tell(j, PROTOCOL_REPEATS, PROTOCOL_BAD, "do not agree",
             "%s and %s do not agree: they are %.3g %% of the length apart at %.4g s, "
             "where the truth is %.3g %% from the first.",
             pair[0]->file, pair[1]->file, 100 * worst, when,
             100 * protocol_worst(pair[0])->error);
}

static void tell_repeats(const struct judge *j)
{
    bool any = false;

    for (int k = 0; k < j->p->scenes; k++) {
        const struct protocol_scene *scene = &j->p->scene[k];
        for (int n = 1; n < scene->runs; n++) {
            const struct protocol_run *const pair[2] = {&scene->run[n - 1], &scene->run[n]};
            if (protocol_is_first(scene, n))
                continue;
            tell_repeat(j, scene, pair);
            any = true;
        }
    }
    if (!any)
        tell(j, PROTOCOL_REPEATS, PROTOCOL_UNKNOWN, "not known",
             "No run was repeated: whether two runs agree is not known.");
}

/* --- contact and place --- */

static void tell_contact(const struct judge *j)
{
    int files = 0;
    bool through = false;

    for (int k = 0; k < j->p->scenes; k++)
        for (int n = 0; n < j->p->scene[k].runs; n++) {
            const struct protocol_run *run = &j->p->scene[k].run[n];
            files += score_diagnosis_has_place(&run->diagnosis);
            for (int m = 0; m < run->said.count; m++)
                if (!strncmp(run->said.text[m], "Passes through", 14)) {
                    tell(j, PROTOCOL_CONTACT, PROTOCOL_BAD, "passes through", "%s: %s",
                         run->file, run->said.text[m]);
                    through = true;
                }
        }
    if (!files)
        tell(j, PROTOCOL_CONTACT, PROTOCOL_UNKNOWN, "not known",
             "In no file do axes, units and order of the vertices allow a judgement.");
    else if (!through)
        tell(j, PROTOCOL_CONTACT, PROTOCOL_GOOD, "does not pass",
             "In none of %d files does the sheet pass through itself or a body.", files);
}

static enum status tell_place(const struct judge *j, const struct protocol_scene *scene,
                              bool *any)
{
    struct protocol_rival *rival;
    int count, before = 0;
    char word[40], best[160] = "";
    const enum status st = protocol_place(j->p, scene, &count, &rival);

    while (before < count && !rival[before].own)
        before++;
    if (before)
        snprintf(best, sizeof best, " The best of them is %s with %.3g %%.", rival->title,
                 100 * rival->error);
    snprintf(word, sizeof word, "place %d of %d", before + 1, count);
    if (count > 1)
        tell(j, PROTOCOL_PLACE, PROTOCOL_NEUTRAL, word,
             "On %s %d of %d contestants come nearer to the truth with as many points or "
             "fewer; its own error is %.3g %% at the same times.%s",
             scene->name, before, count - 1, 100 * rival[before].error, best);
    *any = *any || count > 1;
    free(rival);
    return st;
}

enum status protocol_judge(const struct protocol *p,
                           void (*say)(void *context, const struct protocol_verdict *v),
                           void *context)
{
    const struct judge j = {p, say, context};
    bool placed = false;
    enum status st = STATUS_OK;

    for (int k = 0; k < p->scenes; k++)
        tell_error(&j, &p->scene[k]);
    tell_missing(&j);
    for (int k = 0; k < p->scenes; k++)
        tell_flaws(&j, &p->scene[k]);
    for (size_t n = 0; n < sizeof motion_flaws / sizeof *motion_flaws; n++)
        tell_motion_flaw(&j, &motion_flaws[n]);
    tell_stiffness(&j);
    tell_nets(&j);
    tell_repeats(&j);
    tell_contact(&j);
    for (int k = 0; k < p->scenes; k++)
        TRY(tell_place(&j, &p->scene[k], &placed));
    if (!placed)
        tell(&j, PROTOCOL_PLACE, PROTOCOL_UNKNOWN, "not known",
             "Its place among the contestants is not known: the scenes to begin with show "
             "it, on a net that one of them has, too.");
out:
    return st;
}
