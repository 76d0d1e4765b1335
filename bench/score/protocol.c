#include "bench/score/protocol.h"

#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "bench/files/folder.h"
#include "bench/files/output.h"
#include "bench/files/provenance.h"
#include "bench/frames/frames.h"
#include "bench/truth/truth_making.h"
#include "bench/data/printer.h"
#include "models/reader/named_file.h"
#include "models/reader/schema.h"

SCOPE_OF(yaml_tree_free, struct yaml_tree)

/* Returns a scene by the name of its folder; NULL: it is not there. */
static const struct protocol_scene *protocol_find(const struct protocol *p,
                                                  const char *name)
{
    for (int k = 0; k < p->scenes; k++)
        if (!strcmp(p->scene[k].name, name))
            return &p->scene[k];
    return NULL;
}

/* Returns whether a run of a scene is the first of its name, no repeat of one. */
static bool protocol_is_first(const struct protocol_scene *scene, int run)
{
    const struct protocol_run *r = &scene->run[run];

    return !run || strcmp(r->label, r[-1].label) != 0;
}

/* Returns the first run on the finest net. */
static const struct protocol_run *protocol_finest(const struct protocol_scene *scene)
{
    int n = scene->runs - 1;

    while (!protocol_is_first(scene, n))
        n--;
    return &scene->run[n];
}

/* Returns the time of a run at which its error is largest. */
static const struct score_time *protocol_worst(const struct protocol_run *run)
{
    const struct score_time *worst = run->row;

    for (int n = 1; n < run->times; n++)
        worst = run->row[n].error > worst->error ? &run->row[n] : worst;
    return worst;
}

enum { PATH = 4096 };

/* The scenes to begin with, in their order; NULL ends them. */
static const char *const protocol_first[] = {"free_fall",  "hanging",   "rest_small",
                                             "rest_large", "edge_drop", NULL};

static const char *base_of(const char *path)
{
    return strrchr(path, '/') + 1;
}

/* --- engine.yaml --- */

static const struct schema_key keys[] = {
    {.key = "name", .type = SCHEMA_TEXT, .offset = offsetof(struct protocol, name)},
    {.key = "version", .type = SCHEMA_TEXT, .offset = offsetof(struct protocol, version)},
    {.key = "step",
     .type = SCHEMA_NUMBER,
     .open = true,
     .high = 1,
     .offset = offsetof(struct protocol, step)},
    {NULL}};

static enum status read_engine(struct protocol *p, struct message *why)
{
    static const struct named_file_kind kind = {.what = "engine", .ending = ".yaml"};
    struct yaml_tree *tree SCOPED(yaml_tree_free_scope) = NULL;
    char path[PATH];
    char *text SCOPED(scope_free) = NULL;
    size_t size;

    snprintf(path, sizeof path, "%s/engine.yaml", p->folder);
    if (access(path, F_OK))
        return STATUS_OK;
    CALL(named_file_read(&kind, path, &text, &size, why));
    CALL(yaml_tree_parse(path, false, text, size, &tree, why));
    return schema_read(keys, tree, "engine.yaml", p, why);
}

/* --- a run --- */

/* Keeps of a score what the protocol is made of. */
static void keep(struct arena *arena, const struct score *s, struct protocol_run *run)
{
    const size_t times = (size_t)s->times, numbers = 3 * (size_t)SCORE_POINTS;

    run->vertices = s->net.vertices;
    run->row = arena_take(arena, times, sizeof *run->row);
    double *got = arena_take(arena, times * numbers, sizeof *got);
    for (; run->times < s->times; run->times++, got += numbers) {
        struct score_time *row = &run->row[run->times];
        *row = s->row[run->times];
        for (size_t n = 0; n < numbers; n++) /* moved on to the same time as others' */
            got[n] = row->got[n] + (row->known[n] - row->truth[n]);
        row->known = row->truth = row->seen = NULL;
        row->got = got;
    }
    score_diagnosis_make(s, &run->diagnosis);
    score_print_say(s, &run->diagnosis, &run->said);
    if (score_diagnosis_has_place(&run->diagnosis))
        score_stiffness_make(s, &run->stiffness);
}

/* Reads a name up to the ending: NAME, NAME-REPEAT, NAME-dtSECONDS, NAME-dtSECONDS-REPEAT.
 */
static void parse_name(const char *name, struct protocol_run *run)
{
    const char *ending = frames_is_name(name) ? strrchr(name, '.') : name + strlen(name);
    char *last;

    run->repeat = 1;
    snprintf(run->label, sizeof run->label, "%.*s", (int)(ending - name), name);
    last = strrchr(run->label, '-');
    if (last && last > run->label && last[1] &&
        strspn(last + 1, "0123456789") == strlen(last + 1)) {
        run->repeat = (int)strtol(last + 1, NULL, 10);
        *last = '\0';
        last = strrchr(run->label, '-');
    }
    if (last && !strncmp(last, "-dt", 3))
        run->dt = strtod(last + 3, NULL);
}

/* Returns whether a path in a scene's folder may have frames. */
static bool may_be_run(const char *path)
{
    return frames_is_name(path) || folder_is(path);
}

static enum status read_run(struct arena *arena, const char *path,
                            const struct score_truth *truth, const struct score_look *look,
                            struct protocol_scene *to, struct message *why)
{
    struct protocol_run *run = &to->run[to->runs++];
    struct score s SCOPED(score_clear) = {.frames = 0};

    run->file = arena_print(arena, "%s/%s", to->name, base_of(path));
    parse_name(base_of(path), run);
    struct score_look own = *look;
    own.frames.dt = run->dt > 0 ? run->dt : look->frames.dt;
    CALL(score_read(truth, 1, &path, &own, &s, why));
    const int side = (int)lround(sqrt(s.net.vertices));
    run->net[0] = s.net.points[0] ? s.net.points[0] : s.net.columns ? s.net.columns : side;
    run->net[1] = s.net.points[1] ? s.net.points[1] : s.net.columns ? s.net.rows : side;
    keep(arena, &s, run);
    return STATUS_OK;
}

/* --- a scene --- */

static int compare_runs(const void *a, const void *b)
{
    const struct protocol_run *left = a, *right = b;
    const int points[2] = {left->net[0] * left->net[1], right->net[0] * right->net[1]},
              names = strcmp(left->label, right->label);

    if (points[0] != points[1])
        return points[0] < points[1] ? -1 : 1;
    if (left->dt != right->dt)
        return left->dt > right->dt ? -1 : 1;
    return names ? names : (left->repeat > right->repeat) - (left->repeat < right->repeat);
}

static enum status read_scene(struct arena *arena, const char *path,
                              const struct score_look *look, struct protocol_scene *to,
                              struct message *why)
{
    struct frames_folder folder SCOPED(frames_folder_clear) = {0};
    struct score_truth truth SCOPED(score_truth_clear) = {0};
    char own[PATH];

    to->name = arena_print(arena, "%s", base_of(path));
    snprintf(own, sizeof own, "%s/scene.yaml", path);
    CALL(frames_folder_read(path, &folder, why));
    frames_folder_keep(&folder, may_be_run);
    if (!folder.count)
        return status_fail(why, STATUS_INPUT,
                           "%s: has no frames in it; a file a net, %s/21x21.csv, would be "
                           "right",
                           path, to->name);
    CALL(score_truth_read(access(own, F_OK) ? to->name : own, &truth, why));
    if (truth.scene.pattern)
        return status_fail(why, STATUS_INPUT,
                           "%s: frames of a sheet with an outline have no page; score "
                           "SCENE FRAMES would be right",
                           path);
    to->length = truth.scene.length;
    to->run = arena_take(arena, (size_t)folder.count, sizeof *to->run);
    for (int n = 0; n < folder.count; n++)
        CALL(read_run(arena, folder.path[n], &truth, look, to, why));
    qsort(to->run, (size_t)to->runs, sizeof *to->run, compare_runs);
    for (int n = 1; n < to->runs; n++)
        if (!compare_runs(&to->run[n - 1], &to->run[n]))
            return status_fail(
                why, STATUS_INPUT,
                "%s: %s and %s are the same run; another number, NAME-2, for a "
                "repeat would be right",
                path, base_of(to->run[n - 1].file), base_of(to->run[n].file));
    return STATUS_OK;
}

/* Returns the place of a scene among those to begin with; behind them: their number. */
static int place_of(const char *name)
{
    int n = 0;

    while (protocol_first[n] && strcmp(protocol_first[n], name) != 0)
        n++;
    return n;
}

static int compare_scenes(const void *a, const void *b)
{
    const struct protocol_scene *left = a, *right = b;
    const int places = place_of(left->name) - place_of(right->name);

    return places ? places : strcmp(left->name, right->name);
}

/* --- verdicts on the frames of one simulator, as sentences with numbers --- */

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

const char *protocol_subject_name(enum protocol_subject subject)
{
    static const char *const name[] = {PROTOCOL_SUBJECT_LIST(LIST_WORD)};

    return name[subject];
}

static void __attribute__((format(printf, 5, 6)))
tell(struct protocol *p, enum protocol_subject subject, enum protocol_tone tone,
     const char *word, const char *format, ...)
{
    va_list args;

    p->verdict = arena_more(&p->arena, p->verdict, (size_t)p->verdicts, sizeof *p->verdict);
    struct protocol_verdict *v = &p->verdict[p->verdicts++];
    va_start(args, format);
    *v = (struct protocol_verdict){subject, tone, word,
                                   arena_vprint(&p->arena, format, args)};
    va_end(args);
}

static const struct score_finding *find(const struct protocol_run *run,
                                        enum score_kind kind)
{
    for (int n = 0; run && n < run->diagnosis.count; n++)
        if (run->diagnosis.finding[n].kind == kind)
            return &run->diagnosis.finding[n];
    return NULL;
}

/* Findings, as bits: those with a subject of their own, and of a motion that is sound or
 * that a fit explains. */
enum {
    HAS_SUBJECT = 1 << SCORE_FIRST_ORDER_STEP | 1 << SCORE_DAMPING | 1 << SCORE_BENDING |
                  1 << SCORE_HINGE | 1 << SCORE_CLAMP | 1 << SCORE_FLOOR | 1 << SCORE_SOUND,
    EXPLAINS = HAS_SUBJECT | 1 << SCORE_LAG | 1 << SCORE_GRAVITY
};

static bool is_explained(const struct protocol_run *run)
{
    for (int n = 0; n < run->diagnosis.count; n++)
        if (EXPLAINS >> run->diagnosis.finding[n].kind & 1)
            return true;
    return false;
}

/* Returns the run on the finest net of a scene that is explained; NULL: there is none. */
static const struct protocol_run *explained(struct protocol *p, const char *name)
{
    const struct protocol_scene *scene = protocol_find(p, name);

    for (int n = scene ? scene->runs - 1 : -1; n >= 0; n--)
        if (protocol_is_first(scene, n) && is_explained(&scene->run[n]))
            return &scene->run[n];
    return NULL;
}

/* --- errors and flaws --- */

static void tell_error(struct protocol *p, const struct protocol_scene *scene)
{
    const struct protocol_run *run = protocol_finest(scene);
    const struct score_time *worst = protocol_worst(run);
    const bool sound = find(run, SCORE_SOUND) || find(run, SCORE_FLOOR);

    tell(p, PROTOCOL_ERROR, sound ? PROTOCOL_GOOD : PROTOCOL_NEUTRAL,
         sound ? "sound" : "off",
         "On %s its error is at most %.3g %% of the length (%dx%d points, at %.4g s; error "
         "bar of the truth %.3g %%, floor of the net %.3g %%).",
         scene->name, 100 * worst->error, run->net[0], run->net[1], worst->time,
         100 * worst->bar, 100 * worst->floor);
}

static void tell_missing(struct protocol *p)
{
    char names[160] = "";

    for (const char *const *name = protocol_first; *name; name++)
        if (!protocol_find(p, *name))
            TEXT_JOIN(names, ", ", "%s", *name);
    if (*names)
        tell(p, PROTOCOL_ERROR, PROTOCOL_UNKNOWN, "not run",
             "There are no frames of %s; clothbench export writes these scenes.", names);
}

/* Tells the flaws that have no subject of their own. */
static void tell_flaws(struct protocol *p, const struct protocol_scene *scene)
{
    const struct protocol_run *run = protocol_finest(scene);
    const struct score_diagnosis *d = &run->diagnosis;

    for (int n = 0; n < d->count; n++) {
        const enum score_kind kind = d->finding[n].kind;
        if (!(HAS_SUBJECT >> kind & 1))
            tell(p, PROTOCOL_FLAW, PROTOCOL_BAD, score_diagnosis_name(kind), "%s: %s",
                 run->file, d->finding[n].text);
    }
    if (!d->count)
        tell(p, PROTOCOL_FLAW, PROTOCOL_NEUTRAL, "unexplained",
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

/* Tells of each scene why a flaw of the motion is not known from it. */
static void tell_hidden(struct protocol *p, const struct motion_flaw *f)
{
    char why[200] = "";

    for (int k = 0; k < 2 && f->scene[k]; k++)
        TEXT_JOIN(
            why, "; ", "%s %s", f->scene[k],
            protocol_find(p, f->scene[k])
                ? "has frames whose error is not explained, or other flaws that hide it"
                : "has no frames here");
    tell(p, f->subject, PROTOCOL_UNKNOWN, "not known", "It would be seen on %s%s: %s.",
         f->scene[0], f->scene[1] ? " or edge_drop" : "", why);
}

static void tell_motion_flaw(struct protocol *p, const struct motion_flaw *f)
{
    const struct protocol_run *clean = NULL;
    bool found = false;

    for (int k = 0; k < 2 && f->scene[k]; k++) {
        const struct protocol_run *run = explained(p, f->scene[k]);
        const struct score_finding *flaw = find(run, f->found[0].kind);
        const bool second = !flaw && f->found[1].word;
        flaw = second ? find(run, f->found[1].kind) : flaw;
        if (flaw)
            tell(p, f->subject, PROTOCOL_BAD,
                 flaw->kind == SCORE_DAMPING && flaw->value < 0 ? "gains energy"
                                                                : f->found[second].word,
                 "%s: %s", run->file, flaw->text);
        found = found || flaw;
        clean = !flaw && !clean && run && run->diagnosis.left <= CLEAR ? run : clean;
    }
    if (!found && clean)
        tell(p, f->subject, PROTOCOL_GOOD, f->without, "%s: %s.", clean->file, f->sentence);
    else if (!found)
        tell_hidden(p, f);
}

static void tell_stiffness(struct protocol *p)
{
    static const char *const part[] = {"the membrane's along the warp",
                                       "the membrane's along the weft",
                                       "bending along the warp", "bending along the weft"};
    const struct protocol_run *drop = explained(p, "edge_drop");
    const struct score_finding *bends = find(drop, SCORE_BENDING);
    bool known[2][2] = {{false}};
    char missing[200] = "";

    for (int k = 0; k < p->scenes; k++) {
        const struct protocol_run *run = protocol_finest(&p->scene[k]);
        const struct score_stiffness *s = &run->stiffness;
        if (!s->applies || (!s->found && find(run, SCORE_SOUND)))
            continue;
        const double off = fabs(s->value / s->scene - 1);
        char text[SCORE_STIFFNESS_TEXT];
        score_stiffness_text(s, text);
        tell(p, PROTOCOL_STIFFNESS,
             !s->found           ? PROTOCOL_BAD
             : off < STIFF_ERROR ? PROTOCOL_GOOD
                                 : PROTOCOL_NEUTRAL,
             s->found ? s->part == LAW_MEMBRANE ? "membrane" : "bending" : "none fits",
             "%s: %s", run->file, text);
        for (int weft = 0; weft < 2 && s->found; weft++) /* along u: the same along both */
            known[s->part != LAW_MEMBRANE][weft] |=
                s->along == SCORE_ALONG_U || weft == (s->along == SCORE_ALONG_WEFT);
    }
    if (bends) {
        tell(p, PROTOCOL_STIFFNESS, PROTOCOL_NEUTRAL, "bending", "%s: %s", drop->file,
             bends->text);
        known[1][0] = known[1][1] = true;
    }
    for (int n = 0; n < 4; n++)
        if (!known[n / 2][n % 2])
            TEXT_JOIN(missing, ", ", "%s", part[n]);
    if (*missing)
        tell(p, PROTOCOL_STIFFNESS, PROTOCOL_UNKNOWN, "not known",
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
        if (!protocol_is_first(scene, n) || /* another step on the same net */
            (count && !memcmp(net[count - 1]->net, scene->run[n].net, sizeof net[0]->net)))
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
static void tell_limit(struct protocol *p, const struct protocol_scene *scene,
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
    tell(p, PROTOCOL_NETS, error <= bar ? PROTOCOL_GOOD : PROTOCOL_BAD,
         error <= bar ? "converges" : "to another limit",
         "On %s it converges with order %.2g in the width of the cells (%s); the finest "
         "net is up to %.3g %% of the length from the limit. %s",
         scene->name, order->order, nets, 100 * order->bar, limit);
}

/* Tells of two nets or more. */
static void tell_refined(struct protocol *p, const struct protocol_scene *scene, int count,
                         const struct protocol_run *const net[3])
{
    double apart[3], h[3], worst, when;

    const int times = compare(scene, count, net, apart, &worst, &when);
    if (times && apart[1] < SAME && (count == 2 || apart[2] < SAME)) {
        tell(p, PROTOCOL_NETS, PROTOCOL_NEUTRAL, "the same on each",
             "On %s its motion does not depend on the net.", scene->name);
        return;
    }
    if (count == 2 || !times) {
        tell(p, PROTOCOL_NETS, PROTOCOL_UNKNOWN, "not known",
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
        tell_limit(p, scene, net, &order);
    else
        tell(p, PROTOCOL_NETS, PROTOCOL_BAD, "does not converge",
             "On %s it does not converge: from %dx%d to %dx%d points it changes by %.3g %% "
             "of the length, from there to %dx%d by %.3g %%.",
             scene->name, net[0]->net[0], net[0]->net[1], net[1]->net[0], net[1]->net[1],
             100 * apart[1], net[2]->net[0], net[2]->net[1], 100 * apart[2]);
}

static void tell_nets(struct protocol *p)
{
    const struct protocol_run *net[3];
    char single[200] = "";

    for (int k = 0; k < p->scenes; k++) {
        const struct protocol_scene *scene = &p->scene[k];
        const int count = last_nets(scene, net);
        if (count > 1)
            tell_refined(p, scene, count, net);
        else
            TEXT_JOIN(single, ", ", "%s", scene->name);
    }
    if (*single)
        tell(p, PROTOCOL_NETS, PROTOCOL_UNKNOWN, "not known",
             "There is one net only on %s: whether it converges there is not known.",
             single);
}

/* Tells whether a repeat agrees with the run before it. */
static void tell_repeat(struct protocol *p, const struct protocol_scene *scene,
                        const struct protocol_run *const pair[2])
{
    double apart[2], worst, when = 0;
    const int times = compare(scene, 2, pair, apart, &worst, &when);

    if (!times)
        tell(p, PROTOCOL_REPEATS, PROTOCOL_UNKNOWN, "not known",
             "%s and %s have no time of the truth in common.", pair[0]->file,
             pair[1]->file);
    else if (worst <= SAME)
        tell(p, PROTOCOL_REPEATS, PROTOCOL_GOOD, "agree", "%s and %s agree%s.",
             pair[0]->file, pair[1]->file,
             worst > 0 ? " to single precision" : " to the last digit");
    else
        tell(p, PROTOCOL_REPEATS, PROTOCOL_BAD, "do not agree",
             "%s and %s do not agree: they are %.3g %% of the length apart at %.4g s, "
             "where the truth is %.3g %% from the first.",
             pair[0]->file, pair[1]->file, 100 * worst, when,
             100 * protocol_worst(pair[0])->error);
}

static void tell_repeats(struct protocol *p)
{
    bool any = false;

    for (int k = 0; k < p->scenes; k++) {
        const struct protocol_scene *scene = &p->scene[k];
        for (int n = 1; n < scene->runs; n++) {
            const struct protocol_run *const pair[2] = {&scene->run[n - 1], &scene->run[n]};
            if (protocol_is_first(scene, n))
                continue;
            tell_repeat(p, scene, pair);
            any = true;
        }
    }
    if (!any)
        tell(p, PROTOCOL_REPEATS, PROTOCOL_UNKNOWN, "not known",
             "No run was repeated: whether two runs agree is not known.");
}

/* --- contact --- */

static void tell_contact(struct protocol *p)
{
    int files = 0;
    bool through = false;

    for (int k = 0; k < p->scenes; k++)
        for (int n = 0; n < p->scene[k].runs; n++) {
            const struct protocol_run *run = &p->scene[k].run[n];
            files += score_diagnosis_has_place(&run->diagnosis);
            for (int m = 0; m < run->said.count; m++) {
                const struct score_print_saying *w = &run->said.saying[m];
                if (!strcmp(w->kind, score_contact_name(SCORE_CONTACT_ITSELF)) ||
                    !strcmp(w->kind, score_contact_name(SCORE_CONTACT_BODY))) {
                    tell(p, PROTOCOL_CONTACT, PROTOCOL_BAD, "passes through", "%s: %s",
                         run->file, w->text);
                    through = true;
                }
            }
        }
    if (!files)
        tell(p, PROTOCOL_CONTACT, PROTOCOL_UNKNOWN, "not known",
             "In no file do axes, units and order of the vertices allow a judgement.");
    else if (!through)
        tell(p, PROTOCOL_CONTACT, PROTOCOL_GOOD, "does not pass",
             "In none of %d files does the sheet pass through itself or a body.", files);
}

static void judge(struct protocol *p)
{
    for (int k = 0; k < p->scenes; k++)
        tell_error(p, &p->scene[k]);
    tell_missing(p);
    for (int k = 0; k < p->scenes; k++)
        tell_flaws(p, &p->scene[k]);
    for (size_t n = 0; n < sizeof motion_flaws / sizeof *motion_flaws; n++)
        tell_motion_flaw(p, &motion_flaws[n]);
    tell_stiffness(p);
    tell_nets(p);
    tell_repeats(p);
    tell_contact(p);
}

enum status protocol_read(const char *path, const struct score_look *look,
                          struct protocol *p, struct message *why)
{
    struct frames_folder folder SCOPED(frames_folder_clear) = {0};

    *p = (struct protocol){.folder = path};
    const enum status st = frames_folder_read(path, &folder, why);
    CALL(st == STATUS_FILE ? STATUS_INPUT : st);
    frames_folder_keep(&folder, folder_is);
    if (!folder.count)
        return status_fail(why, STATUS_INPUT,
                           "%s: has no folders named like scenes; edge_drop/21x21.csv in "
                           "it would be right",
                           path);
    CALL(read_engine(p, why));
    p->scene = arena_take(&p->arena, (size_t)folder.count, sizeof *p->scene);
    for (int n = 0; n < folder.count; n++)
        CALL(read_scene(&p->arena, folder.path[n], look, &p->scene[p->scenes++], why));
    qsort(p->scene, (size_t)p->scenes, sizeof *p->scene, compare_scenes);
    judge(p);
    return STATUS_OK;
}

void protocol_clear(struct protocol *p)
{
    arena_clear(&p->arena);
    free(p->name);
    free(p->version);
    *p = (struct protocol){0};
}

/* --- the tables of the page ----------------------------------------------------------- */

static struct dataset *verdicts_of(const struct protocol *p)
{
    static const struct dataset_column columns[] = {
        {"subject"}, {"verdict"}, {"tone"}, {"sentence"}};
    static const char *const tone[] = {"good", "bad", "", ""};
    char title[512];
    int files = 0;

    for (int k = 0; k < p->scenes; k++)
        files += p->scene[k].runs;
    snprintf(title, sizeof title, "%s%s%s: its cloth beside known motions",
             p->name ? p->name : p->folder, p->version ? " " : "",
             p->version ? p->version : "");
    struct dataset *t = DATASET_OF(columns, title);
    if (p->step > 0)
        dataset_note(t, "Its step is said to be %.3g ms.", 1e3 * p->step);
    dataset_note(t,
                 "%d file%s of frames on %d scene%s were compared with motions that are "
                 "known, with error bars. Errors are rms distances over the sheet, in per "
                 "cent of its length.",
                 files, files == 1 ? "" : "s", p->scenes, p->scenes == 1 ? "" : "s");
    for (const struct protocol_verdict *v = p->verdict; v < p->verdict + p->verdicts; v++)
        dataset_line(t, "%s|%s|%s|%s", protocol_subject_name(v->subject), v->word,
                     tone[v->tone], v->text);
    return t;
}

static struct dataset *errors_of(const struct protocol *p)
{
    static const struct dataset_column columns[] = {{"file"},  {"vertices"}, {"time", "s"},
                                                    {"error"}, {"bar"},      {"floor"}};
    struct dataset *t =
        DATASET_OF(columns, "Errors, error bars of the truth, floors of the nets, over the "
                            "length");

    for (int k = 0; k < p->scenes; k++)
        for (int m = 0; m < p->scene[k].runs; m++)
            for (int n = 0; n < p->scene[k].run[m].times; n++) {
                const struct protocol_run *run = &p->scene[k].run[m];
                const struct score_time *row = &run->row[n];
                dataset_line(t, "%s|%d|%.3g|%.2g|%.2g|%.2g", run->file, run->vertices,
                             row->time, row->error, row->bar, row->floor);
            }
    return t;
}

static struct dataset *said_of(const struct protocol *p)
{
    static const struct dataset_column columns[] = {{"file"}, {"sentence"}};
    struct dataset *t = DATASET_OF(columns, "What score says of each file");

    for (int k = 0; k < p->scenes; k++)
        for (int m = 0; m < p->scene[k].runs; m++) {
            const struct protocol_run *run = &p->scene[k].run[m];
            for (int n = 0; n < run->said.count; n++)
                dataset_line(t, "%s|%s", run->file, run->said.saying[n].text);
        }
    return t;
}

enum status protocol_tables_write(const char *path, const struct protocol *p,
                                  struct message *why)
{
    static struct provenance made;
    static struct dataset *(*const table[])(const struct protocol *p) = {
        verdicts_of, errors_of, said_of};
    struct output *out SCOPED(output_discard_scope) = NULL;

    provenance_collect(&made);
    CALL(output_create_in(NULL, path, &out, why));
    FILE *file = output_stream(out);
    fprintf(file, "# clothbench score --protocol | commit %s | %s\n",
            provenance_value(&made, "commit"), provenance_value(&made, "date"));
    struct printer printer = {TABLE_CSV, file};
    for (size_t n = 0; n < sizeof table / sizeof *table; n++)
        CALL(printer_table(&printer, table[n](p), NULL, why));
    return output_close(&out, why);
}
